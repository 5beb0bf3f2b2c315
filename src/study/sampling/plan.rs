//! What is asked of an ensemble.

/// Standard error of the force, over its mean, at which no more runs are made.
pub(crate) const TARGET: f64 = 0.01;
/// Runs made at least, where the caller does not say how many and no patterns of caught nodes do.
pub(crate) const LEAST: usize = 8;
/// Runs made at most, where the caller does not say how many.
pub(crate) const MOST: usize = 64;

/// How an ensemble is made.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    /// Number of runs; nothing means as many as are needed for a standard error of the force of
    /// [`TARGET`], and [`MOST`] at most.
    pub(crate) runs: Option<usize>,
    /// Seed of the ensemble.
    pub(crate) seed: u64,
    /// The same alignment for every run; nothing means one of its own for each.
    pub(crate) phase: Option<[f64; 2]>,
    /// Whether members may be quick runs whose bias is taken out, see [`crate::study::paired`].
    pub(crate) auto: bool,
    /// Threads, at least 1.
    pub(crate) threads: usize,
}

impl Default for Plan {
    fn default() -> Self {
        Plan { runs: None, seed: 0, phase: None, auto: false, threads: 1 }
    }
}
