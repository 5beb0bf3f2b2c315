//! Where first breaks are, in words.

use super::CheckResult;
use crate::layout::Layout;

/// Distance from a plate's edge within which a break counts as one at the plate, m: two openings of the
/// reference mesh, since a wire that starts at the plate ends one or two openings away.
pub(crate) const AT_PLATE: f64 = 0.16;
/// Distance from the punch's axis within which a break counts as one at the punch, in its diameters: the
/// rim is at 0.5.
pub(crate) const AT_PUNCH: f64 = 0.6;

/// How many runs broke first where.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Places {
    /// At an anchor plate.
    pub(crate) plate: usize,
    /// Under the punch or at its rim.
    pub(crate) punch: usize,
    /// Between them.
    pub(crate) between: usize,
    /// How many of all are double twists.
    pub(crate) twists: usize,
}

impl Places {
    /// Of a result on this layout.
    pub(crate) fn from_result(result: &CheckResult, layout: &Layout) -> Places {
        let mut places = Places::default();
        for b in &result.breaks {
            let from_plate = layout.apart_from_plate(b.place);
            let from_punch = layout.apart_from_block(b.place);
            if from_plate <= AT_PLATE {
                places.plate += 1;
            } else if from_punch <= AT_PUNCH * layout.punch {
                places.punch += 1;
            } else {
                places.between += 1;
            }
            places.twists += usize::from(b.twist);
        }
        places
    }

    /// In words: `plate 7, punch 1`.
    pub(crate) fn text(&self) -> String {
        let parts = [("plate", self.plate), ("punch", self.punch), ("between", self.between)];
        let named = parts.iter().filter(|p| p.1 > 0).map(|(word, n)| format!("{word} {n}"));
        named.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Curve, Point};
    use crate::dem::outcome::Quality;
    use crate::fingerprint::Fingerprint;
    use crate::layout::REFERENCE;
    use crate::study::ensemble::Spread;
    use crate::study::result::{FieldFigures, FirstBreak, Revisions, Sampled, Wanted};

    #[test]
    fn places_are_told_apart_across_the_edge_too() {
        let at =
            |x: f64, y: f64| FirstBreak { at: Point::default(), place: [x, y], twist: x > 0.0 };
        let result = CheckResult {
            wanted: Wanted::default(),
            inputs: Fingerprint(0),
            by: Revisions::CURRENT,
            runs: 4,
            slipped: 0,
            force: Spread::default(),
            deflection: Spread::default(),
            peak: Point::default(),
            k75: 0.0,
            energy: 0.0,
            curve: Curve::default(),
            band: [Vec::new(), Vec::new()],
            // Reference: L 3, D 1, d 0.32. Plate edges at 1.34, the punch's rim at 0.5 from its axis.
            breaks: vec![at(-1.25, 1.3), at(0.4, 0.3), at(0.0, 1.2), at(1.45, 0.1)],
            quality: Quality::default(),
            flags: Vec::new(),
            field: FieldFigures::default(),
            sampled: Sampled::default(),
        };
        let p = Places::from_result(&result, &REFERENCE);
        assert_eq!((p.plate, p.punch, p.between, p.twists), (1, 1, 2, 2));
        assert_eq!(p.text(), "plate 1, punch 1, between 2");
        // A punch at the cell's right edge reaches into the next cell, from the left edge in.
        let edge = Layout { ex: 1.4, ..REFERENCE };
        let p = Places::from_result(&result, &edge);
        assert_eq!((p.plate, p.punch, p.between), (1, 1, 2));
    }
}
