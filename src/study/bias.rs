//! What is taken out of quick members of an ensemble.

/// What standard runs gave over quick ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bias {
    /// How many pairs.
    pub(crate) pairs: usize,
    /// Factors on force and deflection.
    pub(crate) factors: [f64; 2],
    /// Standard errors of the means that come from them, as parts.
    pub(crate) errors: [f64; 2],
}
