//! A check as JSON: the field names of the command `check`.

use super::ensemble::{Ensemble, Run, Spread};
use crate::curve::Point;
use crate::dem::lattice::Role;
use crate::dem::outcome::{Break, Stop};
use crate::dem::{Fidelity, Test};
use serde::Serialize;
use serde_json::Value;

/// Force and deflection in the units of JSON.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PointRecord {
    /// kN.
    #[serde(rename = "F_kN")]
    pub force: f64,
    /// m.
    #[serde(rename = "delta_m")]
    pub deflection: f64,
}

impl From<Point> for PointRecord {
    fn from(p: Point) -> Self {
        PointRecord { force: p.force * 1.0e-3, deflection: p.deflection }
    }
}

/// A bond and its place from the panel's centre.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BondRecord {
    /// `single` or `double_twist`.
    pub kind: &'static str,
    /// m, across the twists.
    pub x_m: f64,
    /// m, along them.
    pub y_m: f64,
}

impl From<&Break> for BondRecord {
    fn from(b: &Break) -> Self {
        let kind = if b.role == Role::Twist { "double_twist" } else { "single" };
        BondRecord { kind, x_m: b.place[0], y_m: b.place[1] }
    }
}

/// The first break.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FirstBreakRecord {
    /// Force and deflection.
    #[serde(flatten)]
    pub point: PointRecord,
    /// The bond that broke.
    pub bond: BondRecord,
}

/// A later break.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BreakRecord {
    /// Punch displacement, m.
    pub delta_m: f64,
    /// The bond that broke.
    pub bond: BondRecord,
}

/// A curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveRecord {
    /// m.
    pub delta_m: Vec<f64>,
    /// kN.
    #[serde(rename = "F_kN")]
    pub force: Vec<f64>,
}

/// Quality figures.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct QualityRecord {
    /// See [`crate::dem::outcome::Quality`].
    pub kinetic_over_internal: f64,
    /// Likewise.
    pub energy_balance: f64,
    /// Likewise.
    pub support_over_punch: f64,
    /// Likewise.
    pub error_estimate: f64,
}

/// Cost.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CostRecord {
    /// Time on the wall, set-up included, to the first break, ms.
    pub wall_ms: f64,
    /// Processor time in the same span, ms.
    pub processor_ms: f64,
    /// Steps in all.
    pub steps: usize,
    /// Nodes.
    pub nodes: usize,
    /// Bonds.
    pub bonds: usize,
}

/// One run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunRecord {
    /// Its seed, as text where it does not fit a number of JSON exactly.
    pub seed: u64,
    /// Its alignment.
    pub phase: [f64; 2],
    /// Why it ended.
    pub stop: Stop,
    /// The first break, or nothing.
    pub first_break: Option<FirstBreakRecord>,
    /// All breaks in order.
    pub breaks: Vec<BreakRecord>,
    /// The peak.
    pub peak: PointRecord,
    /// Work of the punch up to the first break, J.
    #[serde(rename = "energy_J")]
    pub energy: f64,
    /// kN/m.
    #[serde(rename = "k75_kN_per_m")]
    pub k75: f64,
    /// The curve.
    pub curve: CurveRecord,
    /// Quality figures.
    pub quality: QualityRecord,
    /// Cost.
    pub cost: CostRecord,
    /// What was skipped.
    pub skipped: Vec<String>,
    /// Stretch of the net in x and y.
    pub stretch: [f64; 2],
}

impl From<&Run> for RunRecord {
    fn from(run: &Run) -> Self {
        let o = &run.outcome;
        RunRecord {
            seed: run.seed,
            phase: run.phase,
            stop: o.stop,
            first_break: o
                .first_break
                .zip(o.breaks.first())
                .map(|(p, b)| FirstBreakRecord { point: p.into(), bond: b.into() }),
            breaks: o
                .breaks
                .iter()
                .map(|b| BreakRecord { delta_m: b.deflection, bond: b.into() })
                .collect(),
            peak: o.peak.into(),
            energy: o.energy,
            k75: o.k75 * 1.0e-3,
            curve: CurveRecord {
                delta_m: o.curve.deflection.clone(),
                force: o.curve.force.iter().map(|f| f * 1.0e-3).collect(),
            },
            quality: QualityRecord {
                kinetic_over_internal: o.quality.kinetic_over_internal,
                energy_balance: o.quality.energy_balance,
                support_over_punch: o.quality.support_over_punch,
                error_estimate: o.quality.error_estimate,
            },
            cost: CostRecord {
                wall_ms: 1.0e3 * run.wall,
                processor_ms: 1.0e3 * run.processor,
                steps: o.cost.steps,
                nodes: o.cost.nodes,
                bonds: o.cost.bonds,
            },
            skipped: o.skipped.clone(),
            stretch: o.stretch,
        }
    }
}

/// 5 and 95 % points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BandRecord {
    /// kN.
    #[serde(rename = "F_kN")]
    pub force: [f64; 2],
    /// m.
    #[serde(rename = "delta_m")]
    pub deflection: [f64; 2],
}

/// The whole check. `inputs` and `forecast` are the caller's.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckRecord {
    /// Version of the program.
    pub version: &'static str,
    /// The inputs, as the command `forecast` writes them.
    pub inputs: Value,
    /// Which test.
    pub test: Test,
    /// Fidelity.
    pub fidelity: Fidelity,
    /// Which force is reported.
    pub force: &'static str,
    /// The runs.
    pub runs: Vec<RunRecord>,
    /// Mean of the first breaks, or nothing where none broke.
    pub mean: Option<PointRecord>,
    /// Mean of the peaks.
    pub mean_peak: PointRecord,
    /// Standard error of the mean.
    pub standard_error: PointRecord,
    /// Standard deviation of a run.
    pub standard_deviation: PointRecord,
    /// Runs that slipped.
    pub slipped: usize,
    /// Band.
    pub band: BandRecord,
    /// The closed-form forecast.
    pub forecast: Value,
    /// Warnings by name.
    pub warnings: Vec<String>,
}

impl CheckRecord {
    /// The record of an ensemble.
    pub fn new(
        ensemble: &Ensemble,
        test: Test,
        fidelity: Fidelity,
        inputs: Value,
        forecast: Value,
    ) -> CheckRecord {
        let (f, d) = (&ensemble.force, &ensemble.deflection);
        let point = |pick: &dyn Fn(&Spread) -> f64| PointRecord {
            force: pick(f) * 1.0e-3,
            deflection: pick(d),
        };
        let broke = ensemble.runs.iter().any(|run| run.outcome.first_break.is_some());
        CheckRecord {
            version: env!("CARGO_PKG_VERSION"),
            inputs,
            test,
            fidelity,
            force: "weighted mean of punch (0.25) and support (0.75)",
            runs: ensemble.runs.iter().map(RunRecord::from).collect(),
            mean: broke.then(|| point(&|s| s.mean)),
            mean_peak: PointRecord {
                force: ensemble.peak[0] * 1.0e-3,
                deflection: ensemble.peak[1],
            },
            standard_error: point(&|s| s.error),
            standard_deviation: point(&|s| s.deviation),
            slipped: ensemble.slipped,
            band: BandRecord { force: f.band.map(|x| x * 1.0e-3), deflection: d.band },
            forecast,
            warnings: ensemble.warnings.clone(),
        }
    }
}
