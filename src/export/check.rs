//! A discrete element check as charts and reports show it.

use crate::curve::{Curve, Point};

/// Force between two limits over deflection; the three lists have the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Band {
    /// Deflections, m, rising.
    pub deflection: Vec<f64>,
    /// Lower limit, N.
    pub low: Vec<f64>,
    /// Upper limit, N.
    pub high: Vec<f64>,
}

/// A check of one layout: one run, or the mean of an ensemble with its band.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Check {
    /// What it is, in a few words: `check, 16 runs`.
    pub label: String,
    /// The curve, or the mean of the curves; its failure point is the (mean) first break.
    pub mean: Curve,
    /// The band of an ensemble.
    pub band: Option<Band>,
    /// First breaks of the runs.
    pub breaks: Vec<Point>,
    /// Quality figures, what was skipped, why it ended: one sentence each, for the report.
    pub notes: Vec<String>,
    /// Whether the inputs have changed since it was made.
    pub stale: bool,
}

impl Check {
    /// The label, with a mark where the inputs have changed since.
    pub fn title(&self) -> String {
        if self.stale {
            format!("{} (stale: inputs have changed since)", self.label)
        } else {
            self.label.clone()
        }
    }
}
