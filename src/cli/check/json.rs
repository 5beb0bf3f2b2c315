//! A check as JSON: SI with kN, one object a layout.

use super::Checked;
use crate::cli::output::{Fault, json_list, number, optional};
use crate::cli::shapes::{CurveJson, Head, InputsJson, Pair, WarningJson};
use crate::dem::lattice::Role;
use crate::dem::outcome::Break;
use crate::dem::{Fidelity, Stop, Test};
use crate::study::ensemble::{Run, Spread};
use crate::units::{to_kn, without_noise};
use serde::Serialize;

/// One object, or a list of them with one line each.
pub(crate) fn report(checked: &[Checked], several: bool) -> Result<String, Fault> {
    json_list(checked.iter().map(Report::of), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    test: Test,
    fidelity: Fidelity,
    law: &'a str,
    stretch: [f64; 2],
    runs: Vec<RunJson<'a>>,
    mean: Maybe,
    mean_peak: Maybe,
    standard_error: Maybe,
    standard_deviation: Maybe,
    slipped: usize,
    band: Band,
    forecast: Maybe,
    warnings: &'a [WarningJson],
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Band {
    F_kN: [Option<f64>; 2],
    delta_m: [Option<f64>; 2],
}

/// A force with its deflection; nothing in both where there is none.
#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Maybe {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
}

impl Maybe {
    /// A force (N) and a deflection, if `there`.
    fn of(there: bool, force: f64, deflection: f64) -> Maybe {
        Maybe { F_kN: there.then(|| to_kn(force)), delta_m: there.then_some(deflection) }
    }
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct RunJson<'a> {
    seed: u64,
    phase: [f64; 2],
    stop: Stop,
    first_break: Option<FirstBreak>,
    breaks: Vec<BreakJson>,
    peak: Pair,
    #[serde(serialize_with = "number")]
    energy_J: f64,
    #[serde(serialize_with = "optional")]
    k75_kN_per_m: Option<f64>,
    curve: CurveJson,
    quality: QualityJson,
    cost: CostJson,
    /// Whether it was repeated with a shorter step.
    repeated: bool,
    skipped: &'a [String],
}

#[derive(Serialize)]
struct FirstBreak {
    #[serde(flatten)]
    at: Pair,
    bond: Option<BondJson>,
}

#[derive(Serialize)]
struct BondJson {
    kind: &'static str,
    #[serde(serialize_with = "number")]
    x_m: f64,
    #[serde(serialize_with = "number")]
    y_m: f64,
}

#[derive(Serialize)]
struct BreakJson {
    #[serde(flatten)]
    bond: BondJson,
    #[serde(serialize_with = "number")]
    delta_m: f64,
}

#[derive(Serialize)]
struct QualityJson {
    #[serde(serialize_with = "number")]
    kinetic_over_internal: f64,
    #[serde(serialize_with = "number")]
    energy_balance: f64,
    #[serde(serialize_with = "number")]
    support_over_punch: f64,
    #[serde(serialize_with = "number")]
    error_estimate: f64,
}

#[derive(Serialize)]
struct CostJson {
    #[serde(serialize_with = "number")]
    wall_ms: f64,
    steps: usize,
    steps_to_first_break: usize,
    nodes: usize,
    bonds: usize,
}

/// The word for a bond.
pub(super) fn kind(role: Role) -> &'static str {
    match role {
        Role::Twist => "double_twist",
        Role::Left | Role::Right => "single_wire",
    }
}

impl BondJson {
    fn of(b: &Break) -> BondJson {
        BondJson { kind: kind(b.role), x_m: b.place[0], y_m: b.place[1] }
    }
}

impl<'a> RunJson<'a> {
    fn of(run: &'a Run) -> RunJson<'a> {
        let o = &run.outcome;
        // A number that is not finite cannot stand in JSON; it is one only of a diverged run.
        let finite = |v: f64| if v.is_finite() { v } else { 0.0 };
        RunJson {
            seed: run.seed,
            phase: run.phase,
            stop: o.stop,
            first_break: o.first_break.map(|p| FirstBreak {
                at: Pair::from(p),
                bond: o.breaks.first().map(BondJson::of),
            }),
            breaks: o
                .breaks
                .iter()
                .map(|b| BreakJson { bond: BondJson::of(b), delta_m: b.deflection })
                .collect(),
            peak: Pair::from(o.peak),
            energy_J: finite(o.energy),
            k75_kN_per_m: (o.k75 > 0.0).then(|| to_kn(o.k75)),
            curve: CurveJson::from(&o.curve),
            quality: QualityJson {
                kinetic_over_internal: finite(o.quality.kinetic_over_internal),
                energy_balance: finite(o.quality.energy_balance),
                support_over_punch: finite(o.quality.support_over_punch),
                error_estimate: finite(o.quality.error_estimate),
            },
            cost: CostJson {
                wall_ms: 1000.0 * run.wall,
                steps: o.cost.steps,
                steps_to_first_break: o.cost.steps_to_break,
                nodes: o.cost.nodes,
                bonds: o.cost.bonds,
            },
            repeated: o.repeated,
            skipped: &o.skipped,
        }
    }
}

impl<'a> Report<'a> {
    fn of(c: &'a Checked) -> Report<'a> {
        let e = &c.ensemble;
        let (broken, counted) = (c.broken(), c.counted() > 0);
        let both = |there: bool, part: fn(&Spread) -> f64| {
            Maybe::of(there, part(&e.force), part(&e.deflection))
        };
        let shown = |v: f64| counted.then(|| without_noise(v));
        let forecast = c.forecast.values;
        Report {
            head: Head::of(
                c.name.as_deref(),
                c.fingerprint,
                InputsJson::of(&c.case.layout, &c.case.mesh, c.case.rule),
            ),
            test: c.spec.test,
            fidelity: c.fidelity,
            law: &c.spec.wire.source,
            stretch: c.stretch,
            runs: e.runs.iter().map(RunJson::of).collect(),
            mean: both(broken > 0, |s| s.mean),
            mean_peak: Maybe::of(counted, e.peak[0], e.peak[1]),
            // Of a single run nothing is known of the scatter.
            standard_error: both(broken > 1, |s| s.error),
            standard_deviation: both(broken > 1, |s| s.deviation),
            slipped: e.slipped,
            band: Band {
                F_kN: e.force.band.map(|v| shown(to_kn(v))),
                delta_m: e.deflection.band.map(shown),
            },
            forecast: forecast
                .map_or(Maybe::of(false, 0.0, 0.0), |v| Maybe::of(true, v.force, v.deflection)),
            warnings: &c.warnings,
        }
    }
}
