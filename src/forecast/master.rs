//! Step 3 of the method: the master curve, Eq. 3 of Pol & Gabrieli (2021), its exact inverse, slope
//! and area. Normalised: deflection over delta_a, force over F_a, from 0 to 1.

/// Coefficients of Eq. 3: a x^3 + b x^2 + c x.
const A: f64 = 1.312;
const B: f64 = -0.385;
const C: f64 = 0.073;

/// Eq. 3: normalised force at a normalised deflection `x` (0 at first touch, 1 at failure).
pub fn force(x: f64) -> f64 {
    x * (C + x * (B + x * A))
}

/// Slope of Eq. 3, dF/dx; at least 0.035 everywhere, so the curve rises and has an inverse.
pub fn slope(x: f64) -> f64 {
    C + x * (2.0 * B + x * 3.0 * A)
}

/// Area under Eq. 3 from 0 to `x`: normalised absorbed energy.
pub fn area(x: f64) -> f64 {
    x * x * (C / 2.0 + x * (B / 3.0 + x * A / 4.0))
}

/// Exact inverse of Eq. 3: the normalised deflection at a normalised force `y`.
///
/// The cubic has one real root because its slope has none; Cardano's formula gives it, and two steps
/// of Newton's method remove the rounding.
pub fn deflection(y: f64) -> f64 {
    if y == 0.0 {
        return 0.0;
    }
    // x = t - B/(3A) turns A x^3 + B x^2 + C x - y into A (t^3 + p t + q).
    let shift = B / (3.0 * A);
    let p = C / A - 3.0 * shift * shift;
    let q = 2.0 * shift * shift * shift - shift * C / A - y / A;
    // p > 0, so the root is real without cases.
    let root = libm::sqrt(q * q / 4.0 + p * p * p / 27.0);
    // The larger of the two cube roots, and the smaller from their product -p/3: no cancellation.
    let large = libm::cbrt(if q > 0.0 { -q / 2.0 - root } else { -q / 2.0 + root });
    let mut x = large - p / (3.0 * large) - shift;
    for _ in 0..2 {
        x -= (force(x) - y) / slope(x);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn worked_by_hand() {
        assert!((force(1.0) - 1.0).abs() < 1e-15);
        // 1.312/8 - 0.385/4 + 0.073/2 = 0.164 - 0.09625 + 0.0365 = 0.10425
        assert!((force(0.5) - 0.10425).abs() < 1e-15);
        // 1.312/4 - 0.385/3 + 0.073/2 = 0.328 - 0.128333... + 0.0365
        assert!((area(1.0) - 0.236_166_666_666_666_7).abs() < 1e-15);
        // 3.936 - 0.77 + 0.073
        assert!((slope(1.0) - 3.239).abs() < 1e-14);
    }

    #[test]
    fn the_curve_rises_everywhere() {
        let least = (0..=1000).map(|i| slope(f64::from(i) / 1000.0)).fold(f64::MAX, f64::min);
        // Minimum at x = 0.385/3.936: 0.073 - 0.385^2/3.936 = 0.0353
        assert!((least - 0.0353).abs() < 1e-4);
    }

    #[test]
    fn the_inverse_is_exact() {
        for i in 0..=2000 {
            let x = f64::from(i) / 1000.0;
            // Rounding only: the slope is at least 0.035, so 1e-16 in y is 3e-15 in x.
            assert!((deflection(force(x)) - x).abs() < 1e-14, "{x}");
        }
    }
}
