//! What is kept of a run of a campaign: one line of its file.

use super::Sample;
use crate::curve::Curve;
use crate::dem::lattice::Role;
use crate::dem::{RunOutcome, Stop};
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::problem::{Problem, summary};
use crate::study::result::rounded;
use crate::units::{from_kn, to_kn};
use serde::{Deserialize, Serialize};

/// Points of a normalised curve, from 0 to the first break, both ends included.
pub(crate) const POINTS: usize = 21;

/// What a run is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Kind {
    /// The standard laboratory test.
    Laboratory,
    /// The anchored reference panel.
    Reference,
    /// A random layout, centred.
    Centred,
    /// A random layout with an offset.
    Eccentric,
}

/// How a run ended, or why there is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum RowEnd {
    /// A wire broke: the row has a force.
    Broke,
    /// The block slipped through without a break.
    Slipped,
    /// The largest travel came before a break.
    NoBreak,
    /// The numbers mean nothing.
    Diverged,
    /// The block stands on a plate.
    PunchOnPlate,
    /// Mirrored blocks would overlap.
    BlocksOverlap,
    /// The sizes drawn make no layout, as a block larger than the spacing.
    NoLayout,
    /// The scene cannot be built.
    NoScene,
}

impl RowEnd {
    pub(crate) fn words(self) -> &'static str {
        match self {
            RowEnd::Broke => "broke",
            RowEnd::Slipped => "slipped",
            RowEnd::NoBreak => "no break before the largest travel",
            RowEnd::Diverged => "diverged",
            RowEnd::PunchOnPlate => "block on a plate",
            RowEnd::BlocksOverlap => "mirrored blocks overlap",
            RowEnd::NoLayout => "block larger than the spacing",
            RowEnd::NoScene => "no scene",
        }
    }
}

/// The first bond that broke.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct FirstBond {
    /// `wire` or `twist`.
    pub(crate) bond: String,
    /// Its place from its cell's centre, m.
    pub(crate) x_m: f64,
    /// Likewise.
    pub(crate) y_m: f64,
}

/// A run. Forces kN, lengths m, five digits: it is a line of a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    /// Its number.
    pub(crate) run: usize,
    /// What it is of.
    pub(crate) kind: Kind,
    /// Plate side.
    pub(crate) d_m: f64,
    /// Spacing.
    #[serde(rename = "L_m")]
    pub(crate) l_m: f64,
    /// Block diameter.
    #[serde(rename = "D_m")]
    pub(crate) punch_m: f64,
    /// Offset across the twists.
    pub(crate) ex_m: f64,
    /// Offset along them.
    pub(crate) ey_m: f64,
    /// Seed of its slack.
    pub(crate) seed: u64,
    /// Its alignment.
    pub(crate) phase: [f64; 2],
    /// How it ended.
    pub(crate) end: RowEnd,
    /// Why there is no scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) why: Option<String>,
    /// Force at the first break.
    #[serde(rename = "F_kN")]
    pub(crate) force_kn: Option<f64>,
    /// Deflection there.
    pub(crate) delta_m: Option<f64>,
    /// Tangent stiffness at 75 % of the force, kN/m.
    #[serde(rename = "k75_kN_m")]
    pub(crate) k75_kn_m: Option<f64>,
    /// Force over that at the break, at equal steps of the deflection over that at the break.
    pub(crate) curve: Vec<f64>,
    /// The first bond that broke.
    pub(crate) first: Option<FirstBond>,
}

impl Row {
    /// A row without a run.
    pub(in crate::lab) fn without(
        run: usize,
        sample: &Sample,
        end: RowEnd,
        why: Option<String>,
    ) -> Row {
        let l = &sample.layout;
        Row {
            run,
            kind: sample.kind,
            // To the last bit: whoever reads the file can make the run again.
            d_m: l.plate,
            l_m: l.spacing,
            punch_m: l.punch,
            ex_m: l.ex,
            ey_m: l.ey,
            seed: sample.seed,
            phase: sample.phase,
            end,
            why,
            force_kn: None,
            delta_m: None,
            k75_kn_m: None,
            curve: Vec::new(),
            first: None,
        }
    }

    /// What is wrong with a layout before anything is run.
    pub(super) fn refused(run: usize, sample: &Sample) -> Option<Row> {
        let l = &sample.layout;
        if sample.kind == Kind::Laboratory {
            return None;
        }
        let end = if l.check().is_err() {
            RowEnd::NoLayout
        } else if l.punch_on_plate() {
            RowEnd::PunchOnPlate
        } else if l.blocks == Blocks::Mirrored && l.blocks_overlap().is_some() {
            RowEnd::BlocksOverlap
        } else {
            return None;
        };
        Some(Row::without(run, sample, end, None))
    }

    /// A scene that could not be built.
    pub(super) fn impossible(run: usize, sample: &Sample, found: &[Problem]) -> Row {
        Row::without(run, sample, RowEnd::NoScene, Some(summary(found)))
    }

    /// A run that came to its end.
    pub(super) fn of(run: usize, sample: &Sample, outcome: &RunOutcome) -> Row {
        let end = match (outcome.stop, outcome.first_break) {
            (Stop::Diverged, _) => RowEnd::Diverged,
            (_, Some(_)) => RowEnd::Broke,
            (Stop::Slipped, None) => RowEnd::Slipped,
            (_, None) => RowEnd::NoBreak,
        };
        let mut row = Row::without(run, sample, end, None);
        let Some(at) = outcome.first_break.filter(|_| end == RowEnd::Broke) else { return row };
        row.force_kn = Some(rounded(to_kn(at.force)));
        row.delta_m = Some(rounded(at.deflection));
        row.k75_kn_m = (outcome.k75 > 0.0).then(|| rounded(to_kn(outcome.k75)));
        row.curve = normalised(&outcome.curve, at.deflection, at.force);
        row.first = outcome.breaks.first().map(|b| FirstBond {
            bond: if b.role == Role::Twist { "twist" } else { "wire" }.into(),
            x_m: rounded(b.place[0]),
            y_m: rounded(b.place[1]),
        });
        row
    }
}

impl Row {
    /// Its layout, with the blocks of its campaign.
    pub(crate) fn layout(&self, blocks: Blocks) -> Layout {
        Layout {
            plate: self.d_m,
            spacing: self.l_m,
            punch: self.punch_m,
            ex: self.ex_m,
            ey: self.ey_m,
            blocks,
            ..REFERENCE
        }
    }

    /// Force, N, and deflection, m, at the first break.
    pub(crate) fn values(&self) -> Option<[f64; 2]> {
        Some([from_kn(self.force_kn?), self.delta_m?])
    }
}

/// A curve over its first break at [`POINTS`] equal steps; 0 at the start and 1 at the end by definition.
fn normalised(curve: &Curve, deflection: f64, force: f64) -> Vec<f64> {
    let last = POINTS - 1;
    (0..=last)
        .map(|i| match i {
            0 => 0.0,
            i if i == last => 1.0,
            // The first window's mean stands behind the first touch: before it the line to it counts.
            i => {
                let at = deflection * i as f64 / last as f64;
                let first = curve.points().next().unwrap_or_default();
                let read = if at < first.deflection {
                    first.force * at / first.deflection
                } else {
                    curve.force_at(at)
                };
                rounded(read / force)
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_read_at_equal_steps_and_ends_at_the_break() {
        let curve =
            Curve { deflection: vec![0.2, 0.4, 0.8], force: vec![10.0, 20.0, 80.0], failure: None };
        let points = normalised(&curve, 0.8, 80.0);
        assert_eq!(points.len(), POINTS);
        // By hand: 0.04 m is on the way to the first point, 0.6 m half way between the last two.
        assert_eq!((points[0], points[1], points[15], points[20]), (0.0, 0.025, 0.625, 1.0));
    }
}
