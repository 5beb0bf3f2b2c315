//! Forces of bonds and of the dome, for every width of vector.

#![expect(
    clippy::inline_always,
    reason = "what uses an instruction set has to be compiled where that is enabled"
)]

use super::lanes::{Lanes, Real};
use super::state::{BondKind, DomeValues, NetShape};

/// Vectors of a kind's constants.
#[derive(Clone, Copy)]
pub(super) struct KindLanes<'a, L: Lanes> {
    kind: &'a BondKind<L::Real>,
    knee: L,
    knee_force: L,
    unloading: L,
    rupture: L,
    per_length: L,
    ramp: L,
}

impl<'a, L: Lanes> KindLanes<'a, L> {
    #[inline(always)]
    pub(super) unsafe fn new(kind: &'a BondKind<L::Real>) -> Self {
        // SAFETY: the caller promises the instruction set; registers alone are touched.
        unsafe {
            KindLanes {
                kind,
                knee: L::splat(kind.knee.0),
                knee_force: L::splat(kind.knee.1),
                unloading: L::splat(kind.unloading),
                rupture: L::splat(kind.rupture),
                per_length: L::splat(kind.per_length),
                ramp: L::splat(kind.ramp),
            }
        }
    }

    /// Loading curve behind the ramp at strain `e`.
    #[inline(always)]
    unsafe fn curve(&self, e: L) -> L {
        // SAFETY: the caller promises the instruction set; registers alone are touched.
        unsafe {
            match &self.kind.shape {
                NetShape::Lines(lines) => {
                    let mut f = e.mul(L::splat(lines[0].0)).add(L::splat(lines[0].1));
                    for line in &lines[1..] {
                        f = f.min(e.mul(L::splat(line.0)).add(L::splat(line.1)));
                    }
                    f
                }
                NetShape::Hinges(first, hinges) => {
                    let zero = L::splat(L::Real::default());
                    let mut f = L::splat(*first);
                    for hinge in hinges {
                        let beyond = e.sub(L::splat(hinge.0)).max(zero);
                        f = f.add(beyond.mul(L::splat(hinge.1)));
                    }
                    f
                }
            }
        }
    }
}

/// Forces over lengths, N/m, of three bonds whose ends are `d` apart; updates their largest strains
/// at `top`. `own` has 1/l1 and the ramp's slope of each where they differ from bond to bond.
///
/// Three bonds are dealt with together, step by step, because each step waits for the one before it
/// and the other bonds fill the wait.
#[inline(always)]
pub(super) unsafe fn pulls<L: Lanes>(
    kinds: [&KindLanes<'_, L>; 3],
    d: [[L; 3]; 3],
    top: [*mut L::Real; 3],
    own: Option<[[*const L::Real; 2]; 3]>,
) -> [L; 3] {
    // SAFETY: the caller promises the instruction set, and a vector within a plane at each address.
    unsafe {
        let zero = L::splat(L::Real::default());
        let one = L::splat(L::Real::new(1.0));
        let mut square = [zero; 3];
        let mut inverse = [zero; 3];
        for b in 0..3 {
            let [x, y, z] = d[b];
            square[b] = x.mul(x).add(y.mul(y)).add(z.mul(z));
        }
        for b in 0..3 {
            inverse[b] = square[b].rsqrt();
        }
        let mut e = [zero; 3];
        let mut most = [zero; 3];
        let mut f = [zero; 3];
        let mut slope = [zero; 3];
        for b in 0..3 {
            let (per_length, ramp, unloading) = match own {
                None => (kinds[b].per_length, kinds[b].ramp, kinds[b].unloading.max(kinds[b].ramp)),
                Some(own) => {
                    let ramp = L::load(own[b][1]);
                    (L::load(own[b][0]), ramp, kinds[b].unloading.max(ramp))
                }
            };
            e[b] = square[b].mul(inverse[b]).mul(per_length).sub(one);
            // What is missing has no number here, and keeps none: of two that cannot be compared the second counts.
            most[b] = e[b].max(L::load(top[b]));
            most[b].store(top[b]);
            slope[b] = unloading;
            f[b] = most[b].sub(kinds[b].knee).mul(ramp).add(kinds[b].knee_force);
        }
        let beyond = most[0].any_gt(kinds[0].knee)
            | most[1].any_gt(kinds[1].knee)
            | most[2].any_gt(kinds[2].knee);
        if beyond {
            for b in 0..3 {
                f[b] = most[b].select_gt(kinds[b].knee, kinds[b].curve(most[b]), f[b]);
            }
        }
        for b in 0..3 {
            f[b] = f[b].sub(slope[b].mul(most[b].sub(e[b]))).max(zero);
            f[b] = most[b].select_gt(kinds[b].rupture, zero, f[b]).mul(inverse[b]);
        }
        f
    }
}

/// Vectors of the dome's constants at an instant.
#[derive(Clone, Copy)]
pub(super) struct DomeLanes<L> {
    cap_reach: L,
    rim_reach: L,
    ring: L,
    seam: L,
    stiffness: L,
    cap_height: L,
    ring_height: L,
}

impl<L: Lanes> DomeLanes<L> {
    /// Those of a dome whose centres of cap and rim are at these heights, m.
    #[inline(always)]
    pub(super) unsafe fn new(values: &DomeValues<L::Real>, heights: [L::Real; 2]) -> Self {
        // SAFETY: the caller promises the instruction set; registers alone are touched.
        unsafe {
            DomeLanes {
                cap_reach: L::splat(values.cap_reach),
                rim_reach: L::splat(values.rim_reach),
                ring: L::splat(values.ring),
                seam: L::splat(values.seam),
                stiffness: L::splat(values.stiffness),
                cap_height: L::splat(heights[0]),
                ring_height: L::splat(heights[1]),
            }
        }
    }

    /// Contact force on nodes at `p` (from the axis, and from the flat net), N.
    #[inline(always)]
    pub(super) unsafe fn push(&self, p: [L; 3]) -> [L; 3] {
        // SAFETY: the caller promises the instruction set; registers alone are touched.
        unsafe {
            let zero = L::splat(L::Real::default());
            let square = p[0].mul(p[0]).add(p[1].mul(p[1]));
            let r_inverse = square.rsqrt();
            let r = square.mul(r_inverse);
            let over = p[2].sub(self.cap_height);
            let seam = self.seam.mul(over);
            let out = r.sub(seam.select_gt(r, zero, self.ring));
            let height = seam.select_gt(r, self.cap_height, self.ring_height);
            let reach = seam.select_gt(r, self.cap_reach, self.rim_reach);
            let up = p[2].sub(height).max(zero);
            let square = out.mul(out).add(up.mul(up));
            let inverse = square.rsqrt();
            let depth = reach.sub(square.mul(inverse)).max(zero);
            let force = self.stiffness.mul(depth).mul(inverse);
            let flat = force.mul(out).mul(r_inverse);
            [flat.mul(p[0]), flat.mul(p[1]), force.mul(up)]
        }
    }
}
