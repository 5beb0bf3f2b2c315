//! Force and deflection at failure of a centred block over those of the reference panel.
//!
//! Two ways of failing compete. A small block goes through the mesh: the force depends on the block, and hardly
//! on plates and spacing. A large one tears the mesh at the anchors: the force depends on the plate, and hardly
//! on the block. The force is the lower of the two, rounded off where they meet, because alignment and slack
//! decide there: F = (S^-n + P^-n)^(-1/n). The part of S in that sum says how much of either way there is,
//! and the deflection is made of two surfaces by it. So there is no jump at D = d.

use crate::layout::Layout;
use serde::{Deserialize, Serialize};

/// d*, L*, D*, m: where all variables are 1.
pub(crate) const REFERENCE_SIZES: [f64; 3] = [0.32, 3.0, 1.0];

/// ln(d/d*), ln(L/L*), ln(D/D*).
pub(crate) fn logarithms(layout: &Layout) -> [f64; 3] {
    let sizes = [layout.plate, layout.spacing, layout.punch];
    [0, 1, 2].map(|k| libm::log(sizes[k] / REFERENCE_SIZES[k]))
}

/// A term: powers of ln(d/d*), ln(L/L*), ln(D/D*), and its coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Term(pub(crate) [u8; 3], pub(crate) f64);

/// The exponential of a sum of terms; with first powers alone a product of powers of the sizes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Surface(pub(crate) Vec<Term>);

impl Surface {
    /// Its logarithm at some logarithms of sizes.
    pub(crate) fn logarithm(&self, at: [f64; 3]) -> f64 {
        self.0.iter().map(|term| term.1 * power(term.0, at)).sum()
    }
}

/// A product of powers.
pub(crate) fn power(powers: [u8; 3], at: [f64; 3]) -> f64 {
    (0..3).map(|k| (0..powers[k]).map(|_| at[k]).product::<f64>()).product()
}

/// The relations of a centred block.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sizes {
    /// The form in words.
    pub(crate) form: String,
    /// n: how sharply the two ways meet.
    pub(crate) sharpness: f64,
    /// S over F_a*: the block goes through the mesh.
    pub(crate) through: Surface,
    /// P over F_a*: the mesh tears at the anchors.
    pub(crate) anchors: Surface,
    /// Deflection over delta_a* of the first way.
    pub(crate) deflection_through: Surface,
    /// Deflection of the second.
    pub(crate) deflection_anchors: Surface,
    /// D at which the two ways meet at the reference spacing, for d = 0.16, 0.32 and 0.48 m.
    pub(crate) threshold: [f64; 3],
}

/// What the relations give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Centred {
    /// Force over F_a*.
    pub(crate) force: f64,
    /// Deflection over delta_a*.
    pub(crate) deflection: f64,
    /// Part of the block's way of failing, 0 to 1.
    pub(crate) through: f64,
}

impl Sizes {
    /// Of a layout, as if its block were centred.
    pub(crate) fn at(&self, layout: &Layout) -> Centred {
        let at = logarithms(layout);
        let (force, through) =
            meet(self.through.logarithm(at), self.anchors.logarithm(at), self.sharpness);
        let deflection = through * self.deflection_through.logarithm(at)
            + (1.0 - through) * self.deflection_anchors.logarithm(at);
        Centred { force, deflection: libm::exp(deflection), through }
    }

    /// D at which the two ways meet, m; between 0.05 and 2.5 m.
    pub(crate) fn meeting(&self, plate: f64) -> f64 {
        let gap = |punch: f64| {
            let at = [libm::log(plate / REFERENCE_SIZES[0]), 0.0, libm::log(punch)];
            self.through.logarithm(at) - self.anchors.logarithm(at)
        };
        let (mut low, mut high) = (0.05, 2.5);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if gap(middle) < 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

/// The lower of two values, rounded off, and the part of the first in it, from their logarithms.
pub(crate) fn meet(first: f64, second: f64, n: f64) -> (f64, f64) {
    // From the lower one, so that nothing overflows.
    let lowest = first.min(second);
    let [a, b] = [first, second].map(|v| libm::exp(-n * (v - lowest)));
    (libm::exp(lowest - libm::log(a + b) / n), a / (a + b))
}

/// Eqs. A.1-A.2 with other coefficients; the published ones are [`PUBLISHED`]. Sizes over d*, L*, D*.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Product {
    /// Force, D <= d: factor of D (published 2.47).
    pub(crate) force_small: f64,
    /// Force, D > d: slope over D, of 1 at D* (0.06; then 0.94).
    pub(crate) force_large: f64,
    /// Force: slope and constant over d (0.48, 0.45).
    pub(crate) force_plate: [f64; 2],
    /// Force: slope over L, of 1 at L* (0.16; then 0.84).
    pub(crate) force_spacing: f64,
    /// Deflection, D <= d: slope and constant over D (0.98 x 0.72, 0.98 x 0.78).
    pub(crate) deflection_small: [f64; 2],
    /// Deflection, D > d: of D^2, D and constant (0.98 x 0.03, -0.16, 1.13).
    pub(crate) deflection_large: [f64; 3],
    /// Deflection: slope over d, of 1 at d* (0.02; then 0.98).
    pub(crate) deflection_plate: f64,
}

pub(crate) const PUBLISHED: Product = Product {
    force_small: 2.47,
    force_large: 0.06,
    force_plate: [0.48, 0.45],
    force_spacing: 0.16,
    deflection_small: [0.98 * 0.72, 0.98 * 0.78],
    deflection_large: [0.98 * 0.03, 0.98 * -0.16, 0.98 * 1.13],
    deflection_plate: 0.02,
};

impl Product {
    /// Force over F_a* and deflection over delta_a* of a layout, as if its block were centred.
    pub(crate) fn at(&self, layout: &Layout) -> [f64; 2] {
        let sizes = [layout.plate, layout.spacing, layout.punch];
        let [d, l, punch] = [0, 1, 2].map(|k| sizes[k] / REFERENCE_SIZES[k]);
        let small = layout.punch <= layout.plate;
        let by_block = if small {
            self.force_small * punch
        } else {
            self.force_large * punch + 1.0 - self.force_large
        };
        let force = by_block
            * (self.force_plate[0] * d + self.force_plate[1])
            * (self.force_spacing * l + 1.0 - self.force_spacing);
        let by_block = if small {
            self.deflection_small[0] * punch + self.deflection_small[1]
        } else {
            let [square, slope, constant] = self.deflection_large;
            (square * punch + slope) * punch + constant
        };
        let plate = self.deflection_plate * d + 1.0 - self.deflection_plate;
        [force, l * by_block * plate]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    #[test]
    fn the_lower_of_two_is_rounded_off_where_they_meet() {
        // Far apart the lower one; equal ones at 2^(-1/n) of them, half and half.
        let (value, part) = meet(libm::log(2.0), libm::log(20.0), 8.0);
        assert!((value - 2.0).abs() < 1e-8 && (part - 1.0).abs() < 1e-7);
        let (value, part) = meet(0.0, 0.0, 4.0);
        assert!((value - 0.5_f64.powf(0.25)).abs() < 1e-15 && part == 0.5);
        assert!(meet(-900.0, 900.0, 8.0).0.is_finite());
    }

    #[test]
    fn the_published_product_is_that_of_the_paper() {
        // Table 1, tests 1 and 2: 22.8 kN at 0.55 m and 13.0 kN at 0.49 m.
        for (plate, punch, force, deflection) in
            [(0.25, 0.6, "22.8", "0.55"), (0.32, 0.2, "13.0", "0.49")]
        {
            let layout = Layout { plate, spacing: 2.5, punch, ..REFERENCE };
            let [f, d] = PUBLISHED.at(&layout);
            assert_eq!(
                (format!("{:.1}", 29.1 * f), format!("{:.2}", 0.648 * d)),
                (force.into(), deflection.into())
            );
        }
    }

    #[test]
    fn a_surface_of_first_powers_is_a_product_of_powers() {
        let surface = Surface(vec![
            Term([0, 0, 0], libm::log(2.0)),
            Term([1, 0, 0], 0.5),
            Term([0, 1, 1], 1.0),
        ]);
        let at = [libm::log(4.0), 3.0, 2.0];
        // 2 x 4^0.5 x e^6.
        assert!((surface.logarithm(at) - (libm::log(4.0) + 6.0)).abs() < 1e-12);
    }
}
