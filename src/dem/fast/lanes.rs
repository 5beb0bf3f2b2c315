//! Vectors of numbers for the kernel: one trait, one type for each instruction set.
//!
//! Every operation rounds like the scalar one of IEEE 754 and there is no fused multiply-add, so a
//! kernel written with them gives the same bits whichever type it runs on. `max` and `select_gt`
//! are defined by a comparison, so that even a NaN goes the same way everywhere.

/// The number inside: `f32` for speed, `f64` for reference runs.
pub trait Real:
    Copy
    + PartialOrd
    + Default
    + Send
    + Sync
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Div<Output = Self>
    + 'static
{
    /// Rounded from double precision.
    fn new(x: f64) -> Self;
    /// In double precision.
    fn wide(self) -> f64;
    /// Adding and subtracting this rounds velocities to multiples of a tiny number, which keeps
    /// them and everything made from them clear of denormal numbers, m per step.
    const GRAIN: f64;
}

impl Real for f32 {
    fn new(x: f64) -> f32 {
        x as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    // 2^-36: velocities are multiples of 2^-59 m, squares of displacements at least 3e-36 or 0.
    const GRAIN: f64 = 1.0 / 68_719_476_736.0;
}

impl Real for f64 {
    fn new(x: f64) -> f64 {
        x
    }
    fn wide(self) -> f64 {
        self
    }
    // About 2^-299: velocities are multiples of 2^-351 m, squares of displacements at least 2^-702 or 0.
    const GRAIN: f64 = 1.0e-90;
}

/// A vector of `N` numbers.
///
/// # Safety
/// All methods need the instruction set of the type, and `load` and `store` need `N` numbers at the
/// address.
#[allow(clippy::missing_safety_doc)] // Said once, above.
pub(crate) trait Lanes: Copy {
    /// The number inside.
    type Real: Real;
    /// A vector of the same instruction set for what is left at the end of a row: 8 lanes or fewer.
    type Tail: Lanes<Real = Self::Real>;
    /// Lanes.
    const N: usize;
    unsafe fn load(from: *const Self::Real) -> Self;
    unsafe fn store(self, to: *mut Self::Real);
    unsafe fn splat(x: Self::Real) -> Self;
    unsafe fn add(self, b: Self) -> Self;
    unsafe fn sub(self, b: Self) -> Self;
    unsafe fn mul(self, b: Self) -> Self;
    /// The larger; the second where they cannot be compared.
    unsafe fn max(self, b: Self) -> Self;
    /// The smaller; the second where they cannot be compared.
    unsafe fn min(self, b: Self) -> Self;
    /// `yes` where `self > b`, else `no`.
    unsafe fn select_gt(self, b: Self, yes: Self, no: Self) -> Self;
    /// Whether any lane of `self` is above that of `b`.
    unsafe fn any_gt(self, b: Self) -> bool;
    /// 1/sqrt, for positive normal numbers; finite for 0. To about 1e-6 in single precision (see
    /// [`FIRST`]), to rounding in double.
    unsafe fn rsqrt(self) -> Self;
}

// The inverse square root in single precision: a first guess from the bits (halved and negated
// exponent; max error 3.5 %), then two Newton steps y (a - x/2 y y). A Newton step errs to one side,
// so its constant is a little above 3/2, which centres the error: 9e-4 after the first step, 7e-7
// after the second. Only shifts, subtractions and multiplications: the same bits everywhere, and a
// third of the time of a square root and a division. A test holds the error.

/// Bits from which half of the number's bits are taken.
pub(crate) const GUESS: i32 = 0x5f37_5a86;
/// Constant of the first Newton step.
pub(crate) const FIRST: f32 = 1.500_876;
/// Constant of the second Newton step.
pub(crate) const SECOND: f32 = 1.500_000_6;

/// Portable vectors, as arrays: any processor.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Portable<R, const N: usize>([R; N]);

macro_rules! portable {
    ($real:ty, $n:literal, |$x:ident| $rsqrt:expr) => {
        impl Lanes for Portable<$real, $n> {
            type Real = $real;
            type Tail = Self;
            const N: usize = $n;
            #[inline(always)]
            unsafe fn load(from: *const $real) -> Self {
                // SAFETY: the caller's promise of N numbers; no alignment asked.
                Portable(unsafe { from.cast::<[$real; $n]>().read_unaligned() })
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $real) {
                // SAFETY: as above.
                unsafe { to.cast::<[$real; $n]>().write_unaligned(self.0) }
            }
            #[inline(always)]
            unsafe fn splat(x: $real) -> Self {
                Portable([x; $n])
            }
            #[inline(always)]
            unsafe fn add(self, b: Self) -> Self {
                Portable(std::array::from_fn(|k| self.0[k] + b.0[k]))
            }
            #[inline(always)]
            unsafe fn sub(self, b: Self) -> Self {
                Portable(std::array::from_fn(|k| self.0[k] - b.0[k]))
            }
            #[inline(always)]
            unsafe fn mul(self, b: Self) -> Self {
                Portable(std::array::from_fn(|k| self.0[k] * b.0[k]))
            }
            #[inline(always)]
            unsafe fn max(self, b: Self) -> Self {
                Portable(std::array::from_fn(
                    |k| if self.0[k] > b.0[k] { self.0[k] } else { b.0[k] },
                ))
            }
            #[inline(always)]
            unsafe fn min(self, b: Self) -> Self {
                Portable(std::array::from_fn(
                    |k| if self.0[k] < b.0[k] { self.0[k] } else { b.0[k] },
                ))
            }
            #[inline(always)]
            unsafe fn select_gt(self, b: Self, yes: Self, no: Self) -> Self {
                Portable(std::array::from_fn(
                    |k| if self.0[k] > b.0[k] { yes.0[k] } else { no.0[k] },
                ))
            }
            #[inline(always)]
            unsafe fn any_gt(self, b: Self) -> bool {
                self.0.iter().zip(&b.0).fold(false, |any, (a, b)| any | (a > b))
            }
            #[inline(always)]
            unsafe fn rsqrt(self) -> Self {
                Portable(self.0.map(|$x| $rsqrt))
            }
        }
    };
}

portable!(f32, 8, |x| {
    let half = 0.5 * x;
    let y = f32::from_bits((GUESS - ((x.to_bits() as i32) >> 1)) as u32);
    let y = y * (FIRST - (half * y) * y);
    y * (SECOND - (half * y) * y)
});
portable!(f64, 4, |x| 1.0 / x.sqrt());

#[cfg(target_arch = "x86_64")]
pub(crate) use x86::*;

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{FIRST, GUESS, Lanes, SECOND};
    use std::arch::x86_64::*;

    macro_rules! vector {
        ($(#[$doc:meta])* $name:ident($inner:ty), $real:ty, $n:literal, tail $tail:ty,
         $load:ident, $store:ident, $splat:ident, $add:ident, $sub:ident, $mul:ident, $max:ident,
         $min:ident, |$a:ident, $b:ident, $yes:ident, $no:ident| $select:expr, any $any:expr,
         rsqrt |$x:ident| $rsqrt:expr) => {
            $(#[$doc])*
            #[derive(Debug, Clone, Copy)]
            pub(crate) struct $name($inner);

            // `max(a, b)` of these instructions is `a > b ? a : b`, `min(a, b)` is `a < b ? a : b`.
            impl Lanes for $name {
                type Real = $real;
                type Tail = $tail;
                const N: usize = $n;
                #[inline(always)]
                unsafe fn load(from: *const $real) -> Self {
                    // SAFETY: the caller promises this instruction set, and N numbers at the address; the
                    // instruction asks for no alignment.
                    $name(unsafe { $load(from) })
                }
                #[inline(always)]
                unsafe fn store(self, to: *mut $real) {
                    // SAFETY: the caller promises this instruction set, and N numbers at the address; the
                    // instruction asks for no alignment.
                    unsafe { $store(to, self.0) }
                }
                #[inline(always)]
                unsafe fn splat(x: $real) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $splat(x) })
                }
                #[inline(always)]
                unsafe fn add(self, b: Self) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $add(self.0, b.0) })
                }
                #[inline(always)]
                unsafe fn sub(self, b: Self) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $sub(self.0, b.0) })
                }
                #[inline(always)]
                unsafe fn mul(self, b: Self) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $mul(self.0, b.0) })
                }
                #[inline(always)]
                unsafe fn max(self, b: Self) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $max(self.0, b.0) })
                }
                #[inline(always)]
                unsafe fn min(self, b: Self) -> Self {
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $min(self.0, b.0) })
                }
                #[inline(always)]
                unsafe fn select_gt(self, b: Self, yes: Self, no: Self) -> Self {
                    let ($a, $b, $yes, $no) = (self.0, b.0, yes.0, no.0);
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $select })
                }
                #[inline(always)]
                unsafe fn any_gt(self, b: Self) -> bool {
                    let ($a, $b) = (self.0, b.0);
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    unsafe { $any }
                }
                #[inline(always)]
                unsafe fn rsqrt(self) -> Self {
                    let $x = self.0;
                    // SAFETY: the caller promises this instruction set; registers alone are touched.
                    $name(unsafe { $rsqrt })
                }
            }
        };
    }

    vector!(
        /// 16 single-precision lanes (AVX-512F).
        F32x16(__m512), f32, 16, tail F32x8, _mm512_loadu_ps, _mm512_storeu_ps, _mm512_set1_ps,
        _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_max_ps, _mm512_min_ps,
        |a, b, yes, no| _mm512_mask_blend_ps(_mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b), no, yes),
        any _mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b) != 0,
        rsqrt |x| {
            let half = _mm512_mul_ps(_mm512_set1_ps(0.5), x);
            let bits = _mm512_srai_epi32::<1>(_mm512_castps_si512(x));
            let y = _mm512_castsi512_ps(_mm512_sub_epi32(_mm512_set1_epi32(GUESS), bits));
            let s = _mm512_mul_ps(_mm512_mul_ps(half, y), y);
            let y = _mm512_mul_ps(y, _mm512_sub_ps(_mm512_set1_ps(FIRST), s));
            let s = _mm512_mul_ps(_mm512_mul_ps(half, y), y);
            _mm512_mul_ps(y, _mm512_sub_ps(_mm512_set1_ps(SECOND), s))
        }
    );
    vector!(
        /// 8 single-precision lanes (AVX2).
        F32x8(__m256), f32, 8, tail F32x8, _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps,
        _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_max_ps, _mm256_min_ps,
        |a, b, yes, no| _mm256_blendv_ps(no, yes, _mm256_cmp_ps::<_CMP_GT_OQ>(a, b)),
        any _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(a, b)) != 0,
        rsqrt |x| {
            let half = _mm256_mul_ps(_mm256_set1_ps(0.5), x);
            let bits = _mm256_srai_epi32::<1>(_mm256_castps_si256(x));
            let y = _mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(GUESS), bits));
            let s = _mm256_mul_ps(_mm256_mul_ps(half, y), y);
            let y = _mm256_mul_ps(y, _mm256_sub_ps(_mm256_set1_ps(FIRST), s));
            let s = _mm256_mul_ps(_mm256_mul_ps(half, y), y);
            _mm256_mul_ps(y, _mm256_sub_ps(_mm256_set1_ps(SECOND), s))
        }
    );
    vector!(
        /// 4 single-precision lanes (SSE2, every x86-64).
        F32x4(__m128), f32, 4, tail F32x4, _mm_loadu_ps, _mm_storeu_ps, _mm_set1_ps,
        _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_max_ps, _mm_min_ps,
        |a, b, yes, no| {
            let mask = _mm_cmpgt_ps(a, b);
            _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no))
        },
        any _mm_movemask_ps(_mm_cmpgt_ps(a, b)) != 0,
        rsqrt |x| {
            let half = _mm_mul_ps(_mm_set1_ps(0.5), x);
            let bits = _mm_srai_epi32::<1>(_mm_castps_si128(x));
            let y = _mm_castsi128_ps(_mm_sub_epi32(_mm_set1_epi32(GUESS), bits));
            let s = _mm_mul_ps(_mm_mul_ps(half, y), y);
            let y = _mm_mul_ps(y, _mm_sub_ps(_mm_set1_ps(FIRST), s));
            let s = _mm_mul_ps(_mm_mul_ps(half, y), y);
            _mm_mul_ps(y, _mm_sub_ps(_mm_set1_ps(SECOND), s))
        }
    );
    vector!(
        /// 8 double-precision lanes (AVX-512F).
        F64x8(__m512d), f64, 8, tail F64x8, _mm512_loadu_pd, _mm512_storeu_pd, _mm512_set1_pd,
        _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_max_pd, _mm512_min_pd,
        |a, b, yes, no| _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b), no, yes),
        any _mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b) != 0,
        rsqrt |x| _mm512_div_pd(_mm512_set1_pd(1.0), _mm512_sqrt_pd(x))
    );
    vector!(
        /// 4 double-precision lanes (AVX2).
        F64x4(__m256d), f64, 4, tail F64x4, _mm256_loadu_pd, _mm256_storeu_pd, _mm256_set1_pd,
        _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_max_pd, _mm256_min_pd,
        |a, b, yes, no| _mm256_blendv_pd(no, yes, _mm256_cmp_pd::<_CMP_GT_OQ>(a, b)),
        any _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(a, b)) != 0,
        rsqrt |x| _mm256_div_pd(_mm256_set1_pd(1.0), _mm256_sqrt_pd(x))
    );
    vector!(
        /// 2 double-precision lanes (SSE2, every x86-64).
        F64x2(__m128d), f64, 2, tail F64x2, _mm_loadu_pd, _mm_storeu_pd, _mm_set1_pd,
        _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_max_pd, _mm_min_pd,
        |a, b, yes, no| {
            let mask = _mm_cmpgt_pd(a, b);
            _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no))
        },
        any _mm_movemask_pd(_mm_cmpgt_pd(a, b)) != 0,
        rsqrt |x| _mm_div_pd(_mm_set1_pd(1.0), _mm_sqrt_pd(x))
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_square_root_errs_by_less_than_a_millionth() {
        // Two octaves of the exponent in steps of a few thousand units in the last place hold every
        // case there is (the guess repeats every two octaves). Bound: 7e-7 by design, 1e-6 with rounding.
        let mut worst = 0.0_f64;
        let mut bits = 1.0_f32.to_bits();
        while bits < 4.0_f32.to_bits() {
            let x = f32::from_bits(bits);
            let mut out = [0.0_f32; 8];
            // SAFETY: portable lanes need no instruction set; the array holds 8 numbers.
            unsafe { Portable::<f32, 8>::splat(x).rsqrt().store(out.as_mut_ptr()) };
            worst = worst.max((f64::from(out[0]) * f64::from(x).sqrt() - 1.0).abs());
            bits += 977;
        }
        assert!(worst < 1.0e-6, "{worst:e}");
        assert!(worst > 1.0e-7, "{worst:e}");
    }
}
