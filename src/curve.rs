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

    /// Force at a deflection (m), N: linear between the points, and on along the first or last pair
    /// beyond them; 0 without a point.
    pub fn force_at(&self, deflection: f64) -> f64 {
        let (xs, ys) = (&self.deflection, &self.force);
        if xs.len() < 2 {
            return ys.first().copied().unwrap_or(0.0);
        }
        let k = xs.partition_point(|&x| x < deflection).clamp(1, xs.len() - 1);
        ys[k - 1] + (ys[k] - ys[k - 1]) * (deflection - xs[k - 1]) / (xs[k] - xs[k - 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_is_read_between_the_points_and_beyond_them() {
        let curve =
            Curve { deflection: vec![0.1, 0.2, 0.4], force: vec![10.0, 30.0, 40.0], failure: None };
        let read = [0.0, 0.1, 0.15, 0.2, 0.3, 0.5].map(|at| curve.force_at(at));
        for (read, by_hand) in read.iter().zip([-10.0, 10.0, 20.0, 30.0, 35.0, 45.0]) {
            assert!((read - by_hand).abs() < 1e-12, "{read} {by_hand}");
        }
        assert_eq!(Curve::default().force_at(0.1), 0.0);
    }
}
