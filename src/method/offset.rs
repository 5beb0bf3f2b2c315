//! What an offset of the block does to force and deflection: factors over the centred block.
//!
//! The logarithm of a factor is a sum of cosines of ex/L and ey/L, hence even, periodic and smooth, each less
//! its value at the centre; with coefficients that go with D/L where the anchors decide; and of exponentials of
//! the gap between the block's edge and the nearest plate, which falls steeply for every size of block. Blocks
//! that go through the mesh (see [`super::sizes`]) have a sum of their own.

use super::sizes::Centred;
use crate::layout::Layout;
use serde::{Deserialize, Serialize};
use std::f64::consts::{SQRT_2, TAU};

/// Lengths over L in which the gap's exponentials fall.
const REACHES: [f64; 3] = [0.05, 0.1, 0.2];
/// Those that blocks which go through the mesh have.
const REACHES_THROUGH: [f64; 2] = [0.1, 0.2];
/// Harmonics of the same, their sum at most.
const HARMONICS_THROUGH: usize = 2;
/// Least and largest logarithm of a factor: beyond them nothing was seen.
const LIMITS: (f64, f64) = (-1.6, 0.3);

/// The two factors' sums.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Offsets {
    /// Harmonics of the cosines, i + j at most.
    pub(crate) harmonics: usize,
    /// Weight of smallness of the coefficients in the fit.
    pub(crate) ridge: f64,
    /// Coefficients of the force's sum in the order of [`variables`].
    pub(crate) force: Vec<f64>,
    /// Of the deflection's.
    pub(crate) deflection: Vec<f64>,
    /// Standard deviation of the factors where the anchors decide: what runs with an offset scatter more than
    /// centred ones, of force and deflection.
    pub(crate) deviation: [f64; 2],
    /// Runs with an offset that they rest on.
    pub(crate) runs: usize,
}

/// Factors of an offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Factors {
    pub(crate) force: f64,
    pub(crate) deflection: f64,
}

impl Offsets {
    /// Of a layout; exactly 1 at the centre.
    pub(crate) fn at(&self, layout: &Layout, centred: &Centred) -> Factors {
        let variables = variables(layout, centred.through, self.harmonics);
        let factor = |coefficients: &[f64]| {
            let sum: f64 = variables.iter().zip(coefficients).map(|(v, c)| v * c).sum();
            libm::exp(limited(sum))
        };
        Factors { force: factor(&self.force), deflection: factor(&self.deflection) }
    }
}

/// A logarithm within what was seen.
pub(crate) fn limited(logarithm: f64) -> f64 {
    logarithm.clamp(LIMITS.0, LIMITS.1)
}

/// The variables of the sums: cosines, cosines times D/L and exponentials of the gap, each times the part
/// of the anchors' way of failing; then cosines and exponentials times that of the block's. All vanish at the
/// centre.
pub(crate) fn variables(layout: &Layout, through: f64, harmonics: usize) -> Vec<f64> {
    let side = layout.spacing;
    // As the net has it: x across the twists.
    let [ex, ey] = layout.turned(layout.folded().into());
    let (x, y) = (ex.abs() / side, ey.abs() / side);
    if x == 0.0 && y == 0.0 {
        return vec![0.0; count(harmonics)];
    }
    let anchors = 1.0 - through;
    let (punch, gaps) = (layout.punch / side, gaps(layout));
    let cosines = cosines(x, y, harmonics);
    let mut all = Vec::with_capacity(count(harmonics));
    for c in &cosines {
        all.push(anchors * c);
        all.push(anchors * c * punch);
    }
    all.extend(REACHES.iter().map(|reach| anchors * nearness(gaps, *reach)));
    all.extend(self::cosines(x, y, HARMONICS_THROUGH).iter().map(|c| through * c));
    all.extend(REACHES_THROUGH.iter().map(|reach| through * nearness(gaps, *reach)));
    all
}

/// How many variables there are.
pub(crate) fn count(harmonics: usize) -> usize {
    2 * pairs(harmonics) + REACHES.len() + pairs(HARMONICS_THROUGH) + REACHES_THROUGH.len()
}

/// Pairs of harmonics with a sum from 1 to `most`.
fn pairs(most: usize) -> usize {
    (most + 1) * (most + 2) / 2 - 1
}

/// cos(2 pi i x) cos(2 pi j y) - 1 for i + j from 1 to `most`.
fn cosines(x: f64, y: f64, most: usize) -> Vec<f64> {
    let wave = |k: usize, at: f64| libm::cos(TAU * k as f64 * at);
    let mut all = Vec::with_capacity(pairs(most));
    for i in 0..=most {
        for j in 0..=most - i {
            if i + j > 0 {
                all.push(wave(i, x) * wave(j, y) - 1.0);
            }
        }
    }
    all
}

/// Gap between the block's edge and the nearest plate over L: where it stands, and centred.
fn gaps(layout: &Layout) -> [f64; 2] {
    let side = layout.spacing;
    let centred = SQRT_2 * (side - layout.plate) / 2.0;
    [layout.distance_to_plate(), centred].map(|distance| (distance - layout.punch / 2.0) / side)
}

/// Exponential of the gap, less that at the centre. A block on a plate has the gap 0.
fn nearness(gaps: [f64; 2], reach: f64) -> f64 {
    let [here, centred] = gaps.map(|gap| libm::exp(-gap.max(0.0) / reach));
    here - centred
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    fn some() -> Offsets {
        let n = count(3);
        let force = (0..n).map(|k| 0.02 * (k as f64 + 1.0) / n as f64).collect();
        Offsets {
            harmonics: 3,
            ridge: 0.0,
            force,
            deflection: vec![0.01; n],
            deviation: [0.0; 2],
            runs: 0,
        }
    }

    #[test]
    fn one_at_the_centre_even_and_periodic() {
        let offsets = some();
        let centred = Centred { force: 1.0, deflection: 1.0, through: 0.3 };
        let at = |ex: f64, ey: f64| offsets.at(&Layout { ex, ey, ..REFERENCE }, &centred);
        assert_eq!(at(0.0, 0.0), Factors { force: 1.0, deflection: 1.0 });
        let here = at(0.4, 0.7);
        assert_ne!(here.force, 1.0);
        for (ex, ey) in [(-0.4, 0.7), (0.4, -0.7), (3.4, 0.7), (0.4, 6.7)] {
            assert!((at(ex, ey).force - here.force).abs() < 1e-12, "{ex} {ey}");
        }
        // Continuous into the centre.
        assert!((at(1e-9, 0.0).force - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_variables_are_as_many_as_are_counted() {
        // By hand: 9 pairs with a sum of 1 to 3, 5 of 1 to 2.
        assert_eq!((pairs(3), pairs(2)), (9, 5));
        let layout = Layout { ex: 0.3, ey: 0.2, ..REFERENCE };
        for harmonics in [2, 3] {
            assert_eq!(variables(&layout, 0.2, harmonics).len(), count(harmonics));
        }
    }
}
