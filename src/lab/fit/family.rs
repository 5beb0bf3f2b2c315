//! The laws that a fit chooses from: the published curve of a wire under factors of its own for single
//! wire and double twist, a strain at which the wire breaks, and the slack.

use crate::mesh::laws::{SINGLE_WIRE, scaled};
use crate::mesh::wire::{CurvePoint, Distortion, NetGeometry, Slack, WireData};
use serde::{Deserialize, Serialize};

/// How many parameters a law has.
pub(crate) const COUNT: usize = 6;
/// Their words, in order.
pub(crate) const WORDS: [&str; COUNT] = [
    "wire stress factor",
    "wire strain factor",
    "wire rupture strain",
    "twist stress factor",
    "twist strain factor",
    "lambda_u",
];

/// A law of the family. Stress and strain factors are those of [`crate::mesh::laws::scaled`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawParameters {
    /// Stress factor of the single wire.
    pub wire_stress: f64,
    /// Strain factor of the single wire.
    pub wire_strain: f64,
    /// Strain at which the single wire breaks: its curve is cut there, or goes on level to there.
    pub rupture: f64,
    /// Stress factor of the double twist, on twice the wire's area.
    pub twist_stress: f64,
    /// Strain factor of the double twist.
    pub twist_strain: f64,
    /// Largest slack over a bond's length; drawn triangular.
    pub lambda_u: f64,
}

impl LawParameters {
    /// The parameters in order.
    pub(crate) fn values(&self) -> [f64; COUNT] {
        [
            self.wire_stress,
            self.wire_strain,
            self.rupture,
            self.twist_stress,
            self.twist_strain,
            self.lambda_u,
        ]
    }

    /// The law of parameters in order.
    pub(crate) fn of(values: [f64; COUNT]) -> LawParameters {
        let [wire_stress, wire_strain, rupture, twist_stress, twist_strain, lambda_u] = values;
        LawParameters { wire_stress, wire_strain, rupture, twist_stress, twist_strain, lambda_u }
    }

    /// The logarithms, in which a fit moves: all parameters stay above 0, and a step is a part.
    pub(crate) fn logarithms(&self) -> Vec<f64> {
        self.values().map(f64::ln).to_vec()
    }

    /// The law of logarithms; what is missing is 1.
    pub(crate) fn of_logarithms(at: &[f64]) -> LawParameters {
        let mut values = [1.0; COUNT];
        values.iter_mut().zip(at).for_each(|(value, at)| *value = at.exp());
        LawParameters::of(values)
    }

    /// Strength of the single wire, MPa on its nominal area.
    pub(crate) fn wire_strength(&self) -> f64 {
        let single = scaled(&SINGLE_WIRE, self.wire_strain, self.wire_stress);
        cut(&single, self.rupture).last().map_or(0.0, |p| p.1)
    }

    /// At six significant digits, which is far more than is known of them.
    pub(crate) fn rounded(&self) -> LawParameters {
        LawParameters::of(self.values().map(|v| format!("{v:.5e}").parse().unwrap_or(v)))
    }

    /// Net and wires of this law.
    pub fn wire(&self, net: NetGeometry, source: String) -> WireData {
        let seven = |v: f64| format!("{v:.6e}").parse().unwrap_or(v);
        let tidy = |points: Vec<CurvePoint>| {
            points.into_iter().map(|p| CurvePoint(seven(p.0), seven(p.1))).collect()
        };
        let single = scaled(&SINGLE_WIRE, self.wire_strain, self.wire_stress);
        WireData {
            net,
            single: tidy(cut(&single, self.rupture)),
            double_twist: tidy(scaled(&SINGLE_WIRE, self.twist_strain, self.twist_stress)),
            distortion: Distortion {
                lambda_u: seven(self.lambda_u),
                lambda_f: 1.0,
                slack: Slack::Triangular,
            },
            source,
        }
    }
}

/// A curve that ends at strain `end`: cut there, or level from its last point on.
fn cut(points: &[CurvePoint], end: f64) -> Vec<CurvePoint> {
    // A point that is the end but for rounding is the end.
    let before = end * (1.0 - 1.0e-5);
    let mut kept: Vec<CurvePoint> = points.iter().copied().filter(|p| p.0 < before).collect();
    let stress = match (kept.last(), points.get(kept.len())) {
        (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (end - a.0) / (b.0 - a.0),
        (Some(a), None) => a.1,
        (None, _) => points.first().map_or(0.0, |b| b.1 * end / b.0),
    };
    kept.push(CurvePoint(end, stress));
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{catalogue, laws};

    #[test]
    fn the_bench_curves_are_a_member_and_logarithms_lead_back() {
        let end = 0.001_923_1 + 0.4 * (0.35 - 0.001_923_1);
        let law = LawParameters::of([1.0, 0.4, end, 1.0, 0.16, 0.03]);
        let net = catalogue::reference().wire.as_ref().unwrap().net;
        let (made, bench) = (law.wire(net, "test".into()), laws::bench());
        assert_eq!(made.check(), Ok(()));
        for (ours, named) in
            [(&made.single, &bench.single), (&made.double_twist, &bench.double_twist)]
        {
            assert_eq!(ours.len(), named.len());
            for (a, b) in ours.iter().zip(named) {
                assert!((a.0 / b.0 - 1.0).abs() < 1e-6 && (a.1 / b.1 - 1.0).abs() < 1e-6);
            }
        }
        let back = LawParameters::of_logarithms(&law.logarithms());
        assert!(back.values().iter().zip(law.values()).all(|(a, b)| (a / b - 1.0).abs() < 1e-14));
    }

    #[test]
    fn a_curve_is_cut_between_its_points_and_goes_on_level_beyond_them() {
        let points = [CurvePoint(0.01, 100.0), CurvePoint(0.05, 200.0)];
        assert_eq!(cut(&points, 0.03), [CurvePoint(0.01, 100.0), CurvePoint(0.03, 150.0)]);
        assert_eq!(cut(&points, 0.08)[2], CurvePoint(0.08, 200.0));
        assert_eq!(cut(&points, 0.005), [CurvePoint(0.005, 50.0)]);
    }
}
