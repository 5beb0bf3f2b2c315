//! How a verdict is made: each check by each panel that there is, and the worst of them.

use super::super::remark::CheckFlag;
use super::super::result::CheckResult;
use super::{Aspect, Basis, Checked, Judge, Simulated, State, Verdict, VerdictRemark};
use crate::case::{Case, CasePoint, CaseValue, Derived, NoValue};
use crate::forecast::warning::{Warning, extrapolated};
use crate::forecast::{Field, Forecast, NoField};
use crate::mesh::adopted::Adopted;
use crate::problem::Problem;

/// Standard deviations from the mean to the 5 % point of a normal distribution.
const FIVE_PER_CENT: f64 = 1.645;
/// A forecast's characteristic F_a as a part of its mean, by its coefficient of variation.
pub(crate) fn characteristic_part(variation: f64) -> f64 {
    (1.0 - FIVE_PER_CENT * variation).max(0.0)
}

/// What a verdict takes from a forecast.
#[derive(Debug, Clone, Copy)]
pub struct Forecasted {
    /// The panel, or why there is none.
    field: Result<Field, &'static str>,
    /// Whether its numbers are extrapolated.
    extrapolated: bool,
    /// Whether it is of one block alone by relations of a block in every cell.
    of_many: bool,
}

/// Why there is no panel to judge by.
const SENSELESS: &str = "the sizes make no sense";

impl Forecasted {
    /// No forecast, and why.
    pub(crate) fn none(why: &'static str) -> Forecasted {
        Forecasted::new(Err(why), &[])
    }

    fn new(field: Result<Field, &'static str>, warnings: &[Warning]) -> Forecasted {
        let of_many = warnings.contains(&Warning::OneBlock);
        Forecasted { field, extrapolated: extrapolated(warnings), of_many }
    }
}

impl From<&Forecast> for Forecasted {
    fn from(forecast: &Forecast) -> Forecasted {
        Forecasted::new(forecast.field.map_err(NoField::reason), &forecast.warnings)
    }
}

impl From<&Result<Derived, Vec<Problem>>> for Forecasted {
    fn from(derived: &Result<Derived, Vec<Problem>>) -> Forecasted {
        match derived {
            Ok(derived) => Forecasted::from(&derived.forecast),
            Err(_) => Forecasted::none(SENSELESS),
        }
    }
}

impl From<&CasePoint> for Forecasted {
    fn from(point: &CasePoint) -> Forecasted {
        Forecasted::new(Ok(point.field), &point.warnings)
    }
}

impl From<&CaseValue> for Forecasted {
    fn from(outcome: &CaseValue) -> Forecasted {
        match outcome {
            Ok(point) => Forecasted::from(point),
            Err(NoValue::Outside(why)) => Forecasted::none(why.reason()),
            Err(NoValue::Senseless(_)) => Forecasted::none(SENSELESS),
        }
    }
}

/// The verdict on a case, from its forecast and the check that there is.
pub fn verdict(
    case: &Case,
    forecast: impl Into<Forecasted>,
    simulated: Simulated,
    basis: Basis,
) -> Verdict {
    let forecast = forecast.into();
    let field = forecast.field.ok();
    let check = match simulated {
        Simulated::Current(result) if result.runs > 0 => Some(result),
        _ => None,
    };
    let panels: Vec<Panel> =
        field.map(Panel::Forecast).into_iter().chain(check.map(Panel::Check)).collect();
    let why = forecast.field.err().unwrap_or(SENSELESS);
    let strength = worst(basis, why, panels.iter().map(|p| strength(case, p, basis)));
    let deflection = worst(basis, why, panels.iter().map(|p| deflection(case, p)));
    let checks = [
        strength.unwrap_or_else(|state| open(Aspect::Strength, case, state)),
        deflection.unwrap_or_else(|state| open(Aspect::Deflection, case, state)),
        anchor(case, check),
    ];
    Verdict { basis, checks, remarks: remarks(case, &forecast, simulated) }
}

/// Of one check by several panels the worst; nothing asked or nothing judged as the state it leaves.
fn worst(
    basis: Basis,
    why: &'static str,
    all: impl Iterator<Item = Checked>,
) -> Result<Checked, State> {
    let weight = |c: &Checked| match c.state {
        State::PassesThrough => f64::INFINITY,
        _ => c.usage[basis as usize].unwrap_or(f64::NEG_INFINITY),
    };
    let found = all.max_by(|a, b| weight(a).total_cmp(&weight(b)));
    found.ok_or(State::NotJudged(why))
}

/// A check without a panel to judge it by.
fn open(aspect: Aspect, case: &Case, state: State) -> Checked {
    let asked = case.asked();
    let (demand, lacking) = match aspect {
        Aspect::Deflection => (None, lacking(&[(asked.force, LOAD), (asked.deflection, ALLOWED)])),
        _ => (asked.force.map(|f| asked.gamma_load * f), lacking(&[(asked.force, LOAD)])),
    };
    Checked {
        aspect,
        demand,
        capacity: [None; 2],
        usage: [None; 2],
        state: lacking.map_or(state, State::NotAsked),
        judge: None,
    }
}

/// Why a check without a break gives no capacity.
const NO_BREAK: &str = "no run of the check broke the mesh";

/// Why a forecast from a record of the force alone gives no deflection.
const STRENGTH_ONLY: &str = "the laboratory record has no deflection";

/// Names of what may be missing.
const LOAD: &str = "design_force or pressure";
const ALLOWED: &str = "allowable_deflection";
pub(super) const ANCHOR: &str = "anchor_resistance";

/// The first of what is needed that is missing.
fn lacking(needed: &[(Option<f64>, &'static str)]) -> Option<&'static str> {
    needed.iter().find(|(value, _)| value.is_none()).map(|(_, name)| *name)
}

/// Force at failure, mean and characteristic, N. A check knows one law; with a mesh that was adopted the range
/// of the laws that fit lowers its characteristic value. A forecast's has that already.
pub(super) fn with_laws(case: &Case, panel: &Panel) -> [Option<f64>; 2] {
    let force = panel.force();
    let (Panel::Check(_), Some(adopted)) = (panel, &case.mesh.adopted) else { return force };
    let [Some(mean), Some(low)] = force else { return force };
    let scatter = (1.0 - low / mean) / FIVE_PER_CENT;
    [Some(mean), Some(mean * characteristic_part(scatter.hypot(adopted.variation())))]
}

fn strength(case: &Case, panel: &Panel, basis: Basis) -> Checked {
    let asked = case.asked();
    let resistance = with_laws(case, panel).map(|f| Some(f? / asked.gamma_resistance));
    let Some(force) = asked.force else {
        let none = open(Aspect::Strength, case, State::NotAsked(LOAD));
        return Checked { capacity: resistance, ..none };
    };
    let demand = asked.gamma_load * force;
    let usage = resistance.map(|r| Some(demand / r?));
    let state = match usage[basis as usize] {
        _ if panel.passes_through() => State::PassesThrough,
        Some(usage) => passes(usage <= 1.0),
        None if !panel.breaks() => State::NotJudged(NO_BREAK),
        None => State::NotJudged("a single run has no characteristic value"),
    };
    Checked {
        aspect: Aspect::Strength,
        demand: Some(demand),
        capacity: resistance,
        usage,
        state,
        judge: Some(panel.judge()),
    }
}

pub(super) fn deflection(case: &Case, panel: &Panel) -> Checked {
    let asked = case.asked();
    let open = open(Aspect::Deflection, case, State::NotJudged(NO_BREAK));
    let open = Checked { capacity: [asked.deflection; 2], ..open };
    let (Some(force), Some(allowed)) = (asked.force, asked.deflection) else { return open };
    if let Panel::Forecast(field) = panel
        && field.end().is_none()
    {
        return Checked { state: State::NotJudged(STRENGTH_ONLY), ..open };
    }
    if !panel.breaks() {
        return open;
    }
    let reached = panel.deflection_at(force);
    let usage = match reached {
        Some(reached) => reached / allowed,
        None => force / panel.force_at(allowed),
    };
    Checked {
        demand: reached,
        usage: [Some(usage); 2],
        state: passes(reached.is_some() && usage <= 1.0),
        judge: Some(panel.judge()),
        ..open
    }
}

/// What the worst anchor carries of the force on a block, and by what that is known.
fn anchor_share(case: &Case, check: Option<&CheckResult>) -> (f64, Judge) {
    let check = check.filter(|c| c.broke());
    match (check.and_then(CheckResult::anchor_share), case.layout.facing_bound()) {
        (Some(share), _) => (share, Judge::Check),
        (None, Some(bound)) => (bound, Judge::Estimate),
        (None, None) if case.layout.shares_unknown() => (1.0, Judge::Estimate),
        (None, None) => (1.0, Judge::Statics),
    }
}

fn anchor(case: &Case, check: Option<&CheckResult>) -> Checked {
    let asked = case.asked();
    let (share, judge) = anchor_share(case, check);
    let demand = asked.force.map(|f| share * asked.gamma_load * f);
    let capacity = asked.anchor_resistance;
    let usage = demand.zip(capacity).map(|(demand, takes)| demand / takes);
    let state = match (usage, lacking(&[(demand, LOAD), (capacity, ANCHOR)])) {
        (Some(usage), _) => passes(usage <= 1.0),
        (None, lacking) => State::NotAsked(lacking.unwrap_or(ANCHOR)),
    };
    Checked {
        aspect: Aspect::Anchor,
        demand,
        capacity: [capacity; 2],
        usage: [usage; 2],
        state,
        judge: usage.map(|_| judge),
    }
}

fn passes(passes: bool) -> State {
    if passes { State::Pass } else { State::Fail }
}

fn remarks(case: &Case, forecast: &Forecasted, simulated: Simulated) -> Vec<VerdictRemark> {
    let mut remarks = Vec::new();
    if case.mesh.adopted.as_ref().is_some_and(Adopted::wide) {
        remarks.push(VerdictRemark::WideLaws);
    }
    if forecast.extrapolated {
        remarks.push(VerdictRemark::Extrapolated);
    }
    if forecast.of_many && !matches!(simulated, Simulated::Current(_)) {
        remarks.push(VerdictRemark::OneBlock);
    }
    match simulated {
        Simulated::Missing => {}
        Simulated::Stale => remarks.push(VerdictRemark::Stale),
        Simulated::Current(result) => {
            if result.runs == 1 {
                remarks.push(VerdictRemark::OneRun);
            }
            if result.flags.contains(&CheckFlag::Unsettled) {
                remarks.push(VerdictRemark::Unsettled);
            }
            if forecast.field.is_ok_and(|f| apart(&f, result)) {
                remarks.push(VerdictRemark::Apart);
            }
        }
    }
    remarks
}

/// Whether forecast and check lie outside of each other's band of 5 to 95 %. One run has no band: its
/// force stands for both ends.
fn apart(field: &Field, result: &CheckResult) -> bool {
    if !result.broke() {
        return false;
    }
    let forecast = field.values.force;
    let half = FIVE_PER_CENT * field.variation * forecast;
    let [low, high] = if result.runs > 1 { result.force.band } else { [result.force.mean; 2] };
    let outside = forecast < low || forecast > high;
    outside && (result.force.mean - forecast).abs() > half
}

/// What a capacity is read from.
pub(super) enum Panel<'a> {
    Forecast(Field),
    Check(&'a CheckResult),
}

impl Panel<'_> {
    fn judge(&self) -> Judge {
        match self {
            Panel::Forecast(_) => Judge::Forecast,
            Panel::Check(_) => Judge::Check,
        }
    }

    /// Force at failure, mean and characteristic, N.
    fn force(&self) -> [Option<f64>; 2] {
        match self {
            Panel::Forecast(field) => {
                let mean = field.values.force;
                [Some(mean), Some(mean * characteristic_part(field.variation))]
            }
            Panel::Check(result) if !result.broke() => [None; 2],
            Panel::Check(result) => [Some(result.force.mean), result.characteristic()],
        }
    }

    /// Whether it tells where the panel fails: a check without a break does not.
    fn breaks(&self) -> bool {
        match self {
            Panel::Forecast(_) => true,
            Panel::Check(result) => result.broke(),
        }
    }

    /// Whether no run broke the mesh: the block slipped through in all of them.
    fn passes_through(&self) -> bool {
        matches!(self, Panel::Check(result) if result.slipped >= result.runs)
    }

    /// Deflection (m) at a force (N) on the mean curve; missing from failure on.
    fn deflection_at(&self, force: f64) -> Option<f64> {
        match self {
            Panel::Forecast(field) if force >= field.values.force => None,
            Panel::Forecast(field) => field.end()?.deflection_at(force),
            Panel::Check(result) => {
                let failure = result.curve.failure.filter(|end| force < end.force)?;
                let (mut x, mut y) = (0.0, 0.0);
                for point in result.curve.points().chain([failure]) {
                    if point.force >= force {
                        return Some(x + (point.deflection - x) * (force - y) / (point.force - y));
                    }
                    (x, y) = (point.deflection, point.force);
                }
                None
            }
        }
    }

    /// Force (N) at a deflection (m) on the mean curve, the force at failure beyond it.
    fn force_at(&self, deflection: f64) -> f64 {
        match self {
            Panel::Forecast(field) => {
                field.end().map_or(0.0, |end| end.force_at(deflection.min(end.deflection)))
            }
            Panel::Check(result) => match result.curve.failure {
                Some(end) if deflection >= end.deflection => end.force,
                _ => result.curve.force_at(deflection).max(0.0),
            },
        }
    }
}
