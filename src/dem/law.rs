//! The law of a bond, after Thoeni et al. (2013): tension only, piecewise linear loading, elastic
//! unloading, rupture for good, and a random slack.
//!
//! A bond of unloaded length l0 and slack delta_l carries nothing lasting below its *taut length*
//! l1 = l0 + delta_l. With the strain e = length/l1 - 1 every bond of a kind follows the same curve
//! (strain, force) whatever its length and slack, except for the first straight part, the *ramp*:
//! it starts at the unloaded length, where e = -delta_l/l1, and ends at the curve's first point.
//!
//! ```text
//!  force                 ____ rupture at the last point
//!     |            __----
//!     |        _--/   / unloading, slope k0
//!     |   __--/      /
//!     |__/ ramp     /
//!   --+----+-------+------ strain
//!  -delta_l/l1     permanent
//! ```
//!
//! The only memory of a bond is the largest strain it has had, `top`; it is broken when `top` is
//! beyond the last point. Then force = max(0, envelope(top) - k (top - e)).

use crate::mesh::wire::{CurvePoint, Distortion, WireData};

/// Pascals in a megapascal.
const PA_PER_MPA: f64 = 1.0e6;

/// Loading curve of one kind of bond (single wire or double twist).
#[derive(Debug, Clone, PartialEq)]
pub struct BondCurve {
    /// Strains at the corners, rising; the first one ends the ramp.
    pub strain: Vec<f64>,
    /// Forces at the corners, N, not falling.
    pub force: Vec<f64>,
    /// Slope from each corner to the next, N per unit of strain; 0 behind the last one.
    pub slope: Vec<f64>,
    /// Slope of unloading and reloading k0, N per unit of strain.
    pub unloading: f64,
}

impl BondCurve {
    /// The curve of a wire of this stress-strain curve on `area` (m^2).
    ///
    /// With lambda_F below 1 the ramp ends at lambda_F times the first point, and the curve goes on
    /// from there along the elastic line.
    pub fn new(points: &[CurvePoint], area: f64, lambda_f: f64) -> BondCurve {
        let newton = |stress: f64| stress * PA_PER_MPA * area;
        let first = points.first().copied().unwrap_or(CurvePoint(1.0, 0.0));
        let (mut strain, mut force) = (Vec::new(), Vec::new());
        if lambda_f < 1.0 {
            strain.push(lambda_f * first.0);
            force.push(lambda_f * newton(first.1));
        }
        strain.extend(points.iter().map(|p| p.0));
        force.extend(points.iter().map(|p| newton(p.1)));
        let mut slope: Vec<f64> = (1..strain.len())
            .map(|k| (force[k] - force[k - 1]) / (strain[k] - strain[k - 1]))
            .collect();
        slope.push(0.0);
        BondCurve { strain, force, slope, unloading: newton(first.1) / first.0 }
    }

    /// Strain at rupture.
    pub fn rupture(&self) -> f64 {
        // A curve has at least one point: `WireData::check`, and `new` pushes what it is given.
        self.strain.last().copied().unwrap_or(0.0)
    }

    /// Largest slope of the curve after its ramp, N per unit of strain; 0 for a curve of one point.
    pub fn steepest(&self) -> f64 {
        self.slope.iter().copied().fold(0.0, f64::max)
    }

    /// Slope of the ramp of a bond whose ramp starts at strain `start`, N per unit of strain.
    pub(crate) fn ramp(&self, start: f64) -> f64 {
        self.force[0] / (self.strain[0] - start)
    }

    /// Slope of unloading of such a bond, N per unit of strain: the elastic one, or the ramp's where
    /// that is steeper (a first point put in above the elastic line).
    pub(crate) fn unloading(&self, start: f64) -> f64 {
        self.unloading.max(self.ramp(start))
    }

    /// The values of a bond whose ramp starts at strain `start` and unloads with the full slope.
    pub fn full(&self, start: f64) -> Ramp {
        Ramp { start, slope: self.ramp(start), unloading: self.unloading(start) }
    }

    /// Force on first loading at strain `e`, N, of a bond with this ramp.
    ///
    /// Nothing below the ramp's start; the last force beyond the last point.
    pub fn envelope(&self, ramp: &Ramp, e: f64) -> f64 {
        if e <= self.strain[0] {
            return (ramp.slope * (e - ramp.start)).max(0.0);
        }
        let corners = self.strain.iter().zip(&self.force).zip(&self.slope);
        let mut force = self.force[0];
        for ((strain, at), slope) in corners {
            if e <= *strain {
                break;
            }
            force = at + slope * (e - strain);
        }
        force
    }

    /// Force at strain `e`, N, of a bond whose largest strain so far is `top` (at least `e`).
    pub fn force(&self, ramp: &Ramp, top: f64, e: f64) -> f64 {
        if top > self.rupture() {
            return 0.0;
        }
        (self.envelope(ramp, top) - ramp.unloading * (top - e)).max(0.0)
    }

    /// Work taken up so far per length l1, N: what the bond has absorbed on its way to (`top`, `e`),
    /// whatever the way was, because unloading and reloading give back what they take.
    pub(crate) fn work(&self, ramp: &Ramp, top: f64, e: f64) -> f64 {
        let end = top.min(self.rupture());
        let mut work = 0.0;
        let (mut e0, mut f0) = (ramp.start, 0.0);
        for (strain, force) in self.strain.iter().zip(&self.force) {
            if end <= e0 {
                break;
            }
            let e1 = end.min(*strain);
            let f1 = if e1 < *strain { self.envelope(ramp, e1) } else { *force };
            work += 0.5 * (f0 + f1) * (e1 - e0);
            (e0, f0) = (e1, f1);
        }
        if top > self.rupture() {
            return work;
        }
        let (high, low) = (self.envelope(ramp, top), self.force(ramp, top, e));
        work - (high * high - low * low) / (2.0 * ramp.unloading)
    }
}

/// What a bond has of its own: its ramp and the slope of its unloading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Strain at which the ramp starts, -delta_l/l1.
    pub start: f64,
    /// Slope of the ramp, N per unit of strain.
    pub slope: f64,
    /// Slope of unloading and reloading, N per unit of strain; at least the ramp's.
    pub unloading: f64,
}

/// The two curves of a mesh, and its slack.
#[derive(Debug, Clone, PartialEq)]
pub struct Law {
    /// Single wire, on its own area.
    pub single: BondCurve,
    /// Double twist, on twice that area.
    pub twist: BondCurve,
    /// How slack is drawn.
    pub distortion: Distortion,
}

impl Law {
    /// The law of a mesh type's wires.
    pub fn new(wire: &WireData) -> Law {
        let area = std::f64::consts::PI * wire.net.diameter * wire.net.diameter / 4.0;
        let lambda_f = wire.distortion.lambda_f;
        Law {
            single: BondCurve::new(&wire.single, area, lambda_f),
            twist: BondCurve::new(&wire.double_twist, 2.0 * area, lambda_f),
            distortion: wire.distortion,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve() -> BondCurve {
        BondCurve::new(&[CurvePoint(0.01, 100.0), CurvePoint(0.05, 200.0)], 1.0e-6, 1.0)
    }

    #[test]
    fn loading_unloading_and_rupture_follow_the_corners_worked_by_hand() {
        let c = curve();
        // 100 MPa on 1 mm^2 is 100 N at 1 %; half way to (5 %, 200 N) is (3 %, 150 N).
        assert!((c.envelope(&c.full(0.0), 0.005) - 50.0).abs() < 1e-12);
        assert!((c.envelope(&c.full(0.0), 0.03) - 150.0).abs() < 1e-12);
        // k0 = 100 N / 0.01; 0.5 % back from there is 50 N less.
        assert!((c.force(&c.full(0.0), 0.03, 0.025) - 100.0).abs() < 1e-9);
        assert_eq!(c.force(&c.full(0.0), 0.03, 0.0), 0.0);
        assert_eq!(c.force(&c.full(0.0), 0.0501, 0.0501), 0.0);
        // Slack of a tenth: the ramp starts at -0.1/1.1 and meets the same first point.
        let start = -0.1 / 1.1;
        assert!((c.envelope(&c.full(start), 0.01) - 100.0).abs() < 1e-12);
        assert!((c.envelope(&c.full(start), (start + 0.01) / 2.0) - 50.0).abs() < 1e-12);
    }

    #[test]
    fn a_lambda_f_below_one_inserts_a_point_on_the_elastic_line() {
        let c = BondCurve::new(&[CurvePoint(0.01, 100.0)], 1.0e-6, 0.6);
        assert!((c.strain[0] - 0.006).abs() < 1e-15 && (c.force[0] - 60.0).abs() < 1e-12);
        assert!((c.steepest() - c.unloading).abs() < 1e-6);
    }

    #[test]
    fn absorbed_work_is_the_integral_of_the_force_along_any_path() {
        let c = curve();
        let start = -0.02;
        // Up to 4 %, down to 1 %, up again to 4.5 %, by the trapezium rule in steps of 1e-6, whose
        // error at the corners is below 1e-5 of the work.
        let (mut e, mut top, mut work, mut last): (f64, f64, f64, f64) = (start, start, 0.0, 0.0);
        for (to, sign) in [(0.04, 1.0), (0.01, -1.0), (0.045, 1.0)] {
            while (to - e) * sign > 0.0 {
                e += sign * 1.0e-6;
                top = top.max(e);
                let f = c.force(&c.full(start), top, e);
                work += 0.5 * (f + last) * sign * 1.0e-6;
                last = f;
            }
        }
        let state = c.work(&c.full(start), top, e);
        assert!((work / state - 1.0).abs() < 1e-4, "{work} {state}");
    }
}
