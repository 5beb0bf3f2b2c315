//! The one output that forecast and check share: force over deflection, with its failure point.

/// A force at a deflection.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// Out-of-plane deflection of the punch, m, positive into the mesh, 0 at first touch.
    pub deflection: f64,
    /// Punching force, N, positive against the punch.
    pub force: f64,
}

/// A force-deflection curve; `deflection` and `force` have the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Deflections, m, rising.
    pub deflection: Vec<f64>,
    /// Forces, N, one for each deflection.
    pub force: Vec<f64>,
    /// The failure point: (delta_a, F_a) of a forecast, the first break of a check, if there is one.
    pub failure: Option<Point>,
}

impl Curve {
    /// The points in order.
    pub(crate) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        self.deflection
            .iter()
            .zip(&self.force)
            .map(|(&deflection, &force)| Point { deflection, force })
    }
}
