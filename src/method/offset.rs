//! What an offset of the block does to force and deflection: factors over the centred block.
//!
//! The logarithm of a factor is a sum of cosines of ex/L and ey/L, hence even, periodic and smooth, each less
//! its value at the centre; with coefficients that go with D/L where the anchors decide; and of exponentials of
//! the gap between the block's edge and the nearest plate, which falls steeply for every size of block. Blocks
//! that go through the mesh (see [`super::sizes`]) have a sum of their own, in one of two forms.

use super::sizes::{Centred, logarithms};
use crate::layout::Layout;
use serde::{Deserialize, Serialize};
use std::f64::consts::{SQRT_2, TAU};

/// Lengths over L in which the gap's exponentials fall.
const REACHES: [f64; 3] = [0.05, 0.1, 0.2];
/// Those that blocks which go through the mesh have.
const REACHES_THROUGH: [f64; 2] = [0.1, 0.2];
/// Harmonics of the same, their sum at most.
const HARMONICS_THROUGH: usize = 2;
/// Those that go with the size of the block.
const HARMONICS_BY_SIZE: usize = 1;
/// Part of the spacing within which what an offset does besides its place comes about.
const RAMP: f64 = 0.1;
/// D that logarithms of a small block are over, m.
const SMALL: f64 = 0.25;
/// Least and largest logarithm of a factor: beyond them nothing was seen.
const LIMITS: (f64, f64) = (-1.6, 0.3);

/// Form of the sum of blocks that go through the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub(crate) enum ThroughForm {
    /// Cosines and exponentials of the gap: as if an offset did the same to every such block. Files that say
    /// nothing have it.
    #[default]
    Cosines,
    /// The same and what goes with the sizes: what is lost as soon as there is an offset (of mirrored blocks
    /// two or four differ then, and the weakest breaks first), by d, L and D; and the first cosines and the
    /// wider exponential of the gap, by D.
    BySize,
}

/// The two factors' sums.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Offsets {
    /// Harmonics of the cosines, i + j at most.
    pub(crate) harmonics: usize,
    /// Form of the sum of blocks that go through the mesh, of force and deflection.
    #[serde(default)]
    pub(crate) through: [ThroughForm; 2],
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
        let factor = |form: ThroughForm, coefficients: &[f64]| {
            let variables = variables(layout, centred.through, self.harmonics, form);
            let sum: f64 = variables.iter().zip(coefficients).map(|(v, c)| v * c).sum();
            libm::exp(limited(sum))
        };
        Factors {
            force: factor(self.through[0], &self.force),
            deflection: factor(self.through[1], &self.deflection),
        }
    }
}

/// A logarithm within what was seen.
pub(crate) fn limited(logarithm: f64) -> f64 {
    logarithm.clamp(LIMITS.0, LIMITS.1)
}

/// The variables of the sums: cosines, cosines times D/L and exponentials of the gap, each times the part
/// of the anchors' way of failing; then those of the block's times its part. All vanish at the centre.
pub(crate) fn variables(
    layout: &Layout,
    through: f64,
    harmonics: usize,
    form: ThroughForm,
) -> Vec<f64> {
    let side = layout.spacing;
    // As the net has it: x across the twists.
    let [ex, ey] = layout.turned(layout.folded().into());
    let (x, y) = (ex.abs() / side, ey.abs() / side);
    if x == 0.0 && y == 0.0 {
        return vec![0.0; count(harmonics, form)];
    }
    let anchors = 1.0 - through;
    let (punch, gaps) = (layout.punch / side, gaps(layout));
    let cosines = cosines(x, y, harmonics);
    let mut all = Vec::with_capacity(count(harmonics, form));
    for c in &cosines {
        all.push(anchors * c);
        all.push(anchors * c * punch);
    }
    all.extend(REACHES.iter().map(|reach| anchors * nearness(gaps, *reach)));
    let near = REACHES_THROUGH.map(|reach| nearness(gaps, reach));
    let mut of_block: Vec<f64> =
        self::cosines(x, y, HARMONICS_THROUGH).into_iter().chain(near).collect();
    if form == ThroughForm::BySize {
        let [d, l, _] = logarithms(layout);
        let punch = libm::log(layout.punch / SMALL);
        // Each direction for itself: without an offset in one, blocks are alike in it.
        let offset = 1.0 - 0.5 * [x, y].map(|e| libm::exp(-e / RAMP)).iter().sum::<f64>();
        of_block.extend([1.0, punch, l, d].map(|v| v * offset));
        let place = self::cosines(x, y, HARMONICS_BY_SIZE).into_iter().chain(near.last().copied());
        of_block.extend(place.map(|v| v * punch));
    }
    all.extend(of_block.into_iter().map(|v| through * v));
    all
}

/// How many variables there are.
pub(crate) fn count(harmonics: usize, form: ThroughForm) -> usize {
    let (cosines, near) = (pairs(harmonics), REACHES_THROUGH.len());
    let by_size = match form {
        ThroughForm::Cosines => 0,
        ThroughForm::BySize => 4 + pairs(HARMONICS_BY_SIZE) + 1,
    };
    let of_block = pairs(HARMONICS_THROUGH) + near + by_size;
    2 * cosines + REACHES.len() + of_block
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

    fn some(through: ThroughForm) -> Offsets {
        let n = count(3, through);
        let force = (0..n).map(|k| 0.02 * (k as f64 + 1.0) / n as f64).collect();
        Offsets {
            harmonics: 3,
            through: [through; 2],
            ridge: 0.0,
            force,
            deflection: vec![0.01; n],
            deviation: [0.0; 2],
            runs: 0,
        }
    }

    #[test]
    fn one_at_the_centre_even_and_periodic() {
        for form in [ThroughForm::Cosines, ThroughForm::BySize] {
            one_at_the_centre(&some(form));
        }
    }

    fn one_at_the_centre(offsets: &Offsets) {
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
        // By hand: 9 pairs with a sum of 1 to 3, 5 of 1 to 2, 2 of 1.
        assert_eq!((pairs(3), pairs(2), pairs(1)), (9, 5, 2));
        // 2 x 9 + 3 and 5 + 2, and 4 + 2 + 1 more.
        assert_eq!(count(3, ThroughForm::Cosines), 28);
        assert_eq!(count(3, ThroughForm::BySize), 35);
        let layout = Layout { ex: 0.3, ey: 0.2, ..REFERENCE };
        for form in [ThroughForm::Cosines, ThroughForm::BySize] {
            for harmonics in [2, 3] {
                let made = variables(&layout, 0.2, harmonics, form);
                assert_eq!(made.len(), count(harmonics, form));
            }
        }
    }

    /// A file of before has no word for the form, and its numbers mean what they meant.
    #[test]
    fn a_file_without_the_form_has_the_cosines() {
        let offsets = some(ThroughForm::Cosines);
        let text = ron::ser::to_string(&offsets).unwrap();
        let without = text.replace("through:(Cosines,Cosines),", "");
        assert_ne!(text, without);
        assert_eq!(ron::from_str::<Offsets>(&without).unwrap(), offsets);
    }

    /// Worked by hand: a block of 0.25 m goes through the mesh as a whole, with both offsets at 0.1 L.
    #[test]
    fn what_an_offset_does_by_size_is_worked_by_hand() {
        let layout = Layout { punch: 0.25, ex: 0.3, ey: 0.3, ..REFERENCE };
        let made = variables(&layout, 1.0, 2, ThroughForm::BySize);
        let own = &made[made.len() - 14..];
        // cos 36 degrees - 1 for the first of y and of x.
        assert!((own[0] + 0.190_983).abs() < 1e-6 && own[2] == own[0], "{own:?}");
        assert!(own[5] > 0.0 && own[6] > own[5], "{own:?}");
        // 1 - 1/e of what is lost, and nothing more of it by D, L or d, which are those that it is over.
        assert!((own[7] - 0.632_121).abs() < 1e-6 && own[8..] == [0.0; 6], "{own:?}");
        // Of the anchors' way there is nothing.
        assert!(made[..made.len() - 14].iter().all(|v| *v == 0.0));
    }
}
