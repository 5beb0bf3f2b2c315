//! The verdict on a layout: is it enough, by strength, by deflection and for the anchors.
//!
//! Service load F_k: the design force, or the pressure on the cell's area. Ultimate load
//! F_d = gamma_load F_k. Three checks:
//!
//! - strength: F_d gamma_resistance / capacity, at most 1;
//! - deflection: delta(F_k) over the allowed one on the mean curve; where the panel does not carry F_k,
//!   F_k over the force at the allowed deflection, and it fails;
//! - anchor: F_d over what an anchor takes. In a field with a block in every cell an anchor carries the
//!   whole force of its cell, by statics.
//!
//! The capacity is the mean, or the characteristic value: of the forecast F_a (1 - 1.645 V), of a check
//! the lower end of its band. Both are given; the basis says which one decides. Where a check by
//! simulation stands for the inputs as they are, it is judged beside the forecast and the larger use
//! counts. What is left out by all this (the scatter of a mesh's production, sliding of the block, the
//! puncture at a plate) is why no word here is "safe".

use super::result::CheckResult;
use crate::case::Case;
use crate::forecast::{Field, Forecast, NoField};
use crate::remark::Weight;
use crate::words::Choice;

/// Standard deviations from the mean to the 5 % point of a normal distribution.
const FIVE_PER_CENT: f64 = 1.645;
/// Punch diameter from which on the forecast scatters less, m.
const LARGE_PUNCH: f64 = 0.4;
/// Use above which a caution makes a verdict doubtful.
const NEAR_LIMIT: f64 = 0.8;

/// Coefficient of variation of F_a about the forecast for a punch diameter (m): alignment and slack,
/// assumed until a campaign of checks gives it.
pub(crate) fn variation(punch: f64) -> f64 {
    if punch >= LARGE_PUNCH { 0.07 } else { 0.085 }
}

/// The forecast's characteristic F_a as a part of its mean.
pub(crate) fn characteristic_part(punch: f64) -> f64 {
    1.0 - FIVE_PER_CENT * variation(punch)
}

/// Which value of a capacity decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    /// The mean.
    #[default]
    Mean,
    /// The characteristic value, which 5 % fall below.
    Characteristic,
}

impl Basis {
    /// The other one.
    pub(crate) fn other(self) -> Basis {
        match self {
            Basis::Mean => Basis::Characteristic,
            Basis::Characteristic => Basis::Mean,
        }
    }
}

impl Choice for Basis {
    const ALL: &'static [Basis] = &[Basis::Mean, Basis::Characteristic];

    fn word(self) -> &'static str {
        match self {
            Basis::Mean => "mean",
            Basis::Characteristic => "characteristic",
        }
    }
}

/// What is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aspect {
    /// Force at failure.
    Strength,
    /// Deflection under the service load.
    Deflection,
    /// Force on an anchor.
    Anchor,
}

impl Aspect {
    /// The word in output.
    pub fn word(self) -> &'static str {
        match self {
            Aspect::Strength => "strength",
            Aspect::Deflection => "deflection",
            Aspect::Anchor => "anchor",
        }
    }
}

/// What a capacity was taken from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Judge {
    /// The closed form.
    Forecast,
    /// The simulation.
    Check,
    /// Statics alone.
    Statics,
}

impl Judge {
    /// The word in output.
    pub fn word(self) -> &'static str {
        match self {
            Judge::Forecast => "forecast",
            Judge::Check => "check",
            Judge::Statics => "statics",
        }
    }
}

/// How a check stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// The use is at most 1.
    Pass,
    /// The use is above 1, or the panel does not carry the load.
    Fail,
    /// In all runs of the check the block slipped through the mesh without a break: it fails.
    PassesThrough,
    /// Asked, but there is no capacity: why.
    NotJudged(&'static str),
    /// Not asked: what is missing, by its name in a file.
    NotAsked(&'static str),
}

impl State {
    /// Whether it fails.
    pub fn fails(self) -> bool {
        matches!(self, State::Fail | State::PassesThrough)
    }

    /// One sign, as [`Finding::mark`] has it.
    pub(crate) fn mark(self) -> char {
        match self {
            State::Pass => '+',
            State::Fail | State::PassesThrough => 'x',
            State::NotJudged(_) => '?',
            State::NotAsked(_) => ' ',
        }
    }

    /// The word in output.
    pub fn word(self) -> &'static str {
        match self {
            State::Pass => "pass",
            State::Fail | State::PassesThrough => "fail",
            State::NotJudged(_) => "not judged",
            State::NotAsked(_) => "not asked",
        }
    }

    /// Why, where there is more to say than the word.
    pub fn why(self) -> Option<String> {
        match self {
            State::Pass | State::Fail => None,
            State::PassesThrough => Some("passes through".into()),
            State::NotJudged(why) => Some(why.into()),
            State::NotAsked(lacking) => Some(format!("{lacking} is missing")),
        }
    }
}

/// One check. Demand and capacity are N, of the deflection m; pairs are mean and characteristic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Checked {
    /// What is checked.
    pub aspect: Aspect,
    /// What is asked for; missing where nothing is, and for a deflection beyond failure.
    pub demand: Option<f64>,
    /// What there is: resistance with its factor, the allowed deflection, what an anchor takes.
    pub capacity: [Option<f64>; 2],
    /// Demand over capacity.
    pub usage: [Option<f64>; 2],
    /// How it stands on the basis that decides.
    pub state: State,
    /// What it was taken from; missing where nothing was judged.
    pub judge: Option<Judge>,
}

/// The check by simulation that there is for a layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Simulated<'a> {
    /// None.
    Missing,
    /// One of other inputs or of another program: it does not count.
    Stale,
    /// One of the inputs as they are.
    Current(&'a CheckResult),
}

/// Something to know beside a verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VerdictRemark {
    /// A stale check did not count.
    Stale,
    /// Forecast and check lie beyond each other's bands; the larger use counts.
    Apart,
    /// A check of one run has no characteristic value.
    OneRun,
    /// The forecast is extrapolated.
    Extrapolated,
}

impl VerdictRemark {
    /// Stable identifier for programs.
    pub(crate) fn code(self) -> &'static str {
        match self {
            VerdictRemark::Stale => "stale_check",
            VerdictRemark::Apart => "forecast_and_check_apart",
            VerdictRemark::OneRun => "one_run",
            VerdictRemark::Extrapolated => "extrapolated",
        }
    }

    /// How much it weighs: near the limit a caution makes the verdict doubtful.
    pub(crate) fn weight(self) -> Weight {
        match self {
            VerdictRemark::OneRun => Weight::Note,
            _ => Weight::Caution,
        }
    }

    /// A sentence without a final stop.
    pub(crate) fn sentence(self) -> &'static str {
        match self {
            VerdictRemark::Stale => "the check is stale and does not count",
            VerdictRemark::Apart => {
                "forecast and check differ beyond both bands; the larger use counts"
            }
            VerdictRemark::OneRun => "a check of one run has no characteristic value",
            VerdictRemark::Extrapolated => "the forecast is extrapolated",
        }
    }
}

/// The verdict in a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finding {
    /// A check fails.
    Fails,
    /// None fails, but one that is asked could not be judged.
    NotJudged,
    /// All pass, with a caution near the limit.
    Doubtful,
    /// All that is asked passes.
    Passes,
    /// Nothing is asked.
    NotAsked,
}

impl Finding {
    /// One sign, readable without colour.
    pub fn mark(self) -> char {
        match self {
            Finding::Fails => 'x',
            Finding::NotJudged | Finding::Doubtful => '?',
            Finding::Passes => '+',
            Finding::NotAsked => ' ',
        }
    }

    /// The word; never "safe".
    pub fn word(self) -> &'static str {
        match self {
            Finding::Fails => "FAILS",
            Finding::NotJudged => "NOT JUDGED",
            Finding::Doubtful => "DOUBTFUL",
            Finding::Passes => "PASSES",
            Finding::NotAsked => "NOT ASKED",
        }
    }
}

/// The verdict on a layout.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Which value of the capacities decides.
    pub basis: Basis,
    /// Strength, deflection, anchor.
    pub checks: [Checked; 3],
    /// What to know beside it.
    pub remarks: Vec<VerdictRemark>,
}

impl Verdict {
    /// The check that governs: one that passes through, else that of the largest use.
    pub fn governing(&self) -> Option<&Checked> {
        let through = |c: &&Checked| c.state == State::PassesThrough;
        let judged = self.checks.iter().filter(|c| self.usage(c).is_some());
        self.checks.iter().find(through).or_else(|| {
            judged.max_by(|a, b| {
                let usage = |c| self.usage(c).unwrap_or(0.0);
                usage(a).total_cmp(&usage(b))
            })
        })
    }

    /// The use of a check on the basis that decides.
    pub fn usage(&self, check: &Checked) -> Option<f64> {
        check.usage[self.basis as usize]
    }

    /// The largest use.
    pub fn largest_use(&self) -> Option<f64> {
        self.usage(self.governing()?)
    }

    /// The verdict in a word.
    pub fn finding(&self) -> Finding {
        let any = |of: fn(State) -> bool| self.checks.iter().any(|c| of(c.state));
        let caution = self.remarks.iter().any(|r| r.weight() >= Weight::Caution);
        if any(State::fails) {
            Finding::Fails
        } else if any(|s| matches!(s, State::NotJudged(_))) {
            Finding::NotJudged
        } else if !any(|s| s == State::Pass) {
            Finding::NotAsked
        } else if caution && self.largest_use() > Some(NEAR_LIMIT) {
            Finding::Doubtful
        } else {
            Finding::Passes
        }
    }
}

/// The verdict on a case, from its forecast (missing where its sizes make no sense) and the check that
/// there is.
pub fn verdict(
    case: &Case,
    forecast: Option<&Forecast>,
    simulated: Simulated,
    basis: Basis,
) -> Verdict {
    let field = forecast.and_then(|f| f.field.ok());
    let check = match simulated {
        Simulated::Current(result) if result.runs > 0 => Some(result),
        _ => None,
    };
    let panels: Vec<Panel> =
        field.map(Panel::Forecast).into_iter().chain(check.map(Panel::Check)).collect();
    let why = match forecast.map(|f| f.field) {
        None => "the sizes make no sense",
        Some(Err(NoField::PassesThrough)) => "the block is smaller than the mesh opening",
        Some(_) => "the block is on a plate",
    };
    let strength = worst(basis, why, panels.iter().map(|p| strength(case, p, basis)));
    let deflection = worst(basis, why, panels.iter().map(|p| deflection(case, p)));
    let checks = [
        strength.unwrap_or_else(|state| open(Aspect::Strength, case, state)),
        deflection.unwrap_or_else(|state| open(Aspect::Deflection, case, state)),
        anchor(case),
    ];
    Verdict { basis, checks, remarks: remarks(case, forecast, simulated) }
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

/// Names of what may be missing.
const LOAD: &str = "design_force or pressure";
const ALLOWED: &str = "allowable_deflection";
const ANCHOR: &str = "anchor_resistance";

/// The first of what is needed that is missing.
fn lacking(needed: &[(Option<f64>, &'static str)]) -> Option<&'static str> {
    needed.iter().find(|(value, _)| value.is_none()).map(|(_, name)| *name)
}

fn strength(case: &Case, panel: &Panel, basis: Basis) -> Checked {
    let asked = case.asked();
    let resistance = panel.force(case.layout.punch).map(|f| Some(f? / asked.gamma_resistance));
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

fn deflection(case: &Case, panel: &Panel) -> Checked {
    let asked = case.asked();
    let open = open(Aspect::Deflection, case, State::NotJudged(NO_BREAK));
    let open = Checked { capacity: [asked.deflection; 2], ..open };
    let (Some(force), Some(allowed)) = (asked.force, asked.deflection) else { return open };
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

fn anchor(case: &Case) -> Checked {
    let asked = case.asked();
    let demand = asked.force.map(|f| asked.gamma_load * f);
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
        judge: usage.map(|_| Judge::Statics),
    }
}

fn passes(passes: bool) -> State {
    if passes { State::Pass } else { State::Fail }
}

fn remarks(case: &Case, forecast: Option<&Forecast>, simulated: Simulated) -> Vec<VerdictRemark> {
    let mut remarks = Vec::new();
    if forecast.is_some_and(Forecast::extrapolated) {
        remarks.push(VerdictRemark::Extrapolated);
    }
    match simulated {
        Simulated::Missing => {}
        Simulated::Stale => remarks.push(VerdictRemark::Stale),
        Simulated::Current(result) => {
            if result.runs == 1 {
                remarks.push(VerdictRemark::OneRun);
            }
            if forecast.and_then(|f| f.field.ok()).is_some_and(|f| apart(&f, case, result)) {
                remarks.push(VerdictRemark::Apart);
            }
        }
    }
    remarks
}

/// Whether forecast and check lie outside of each other's band of 5 to 95 %. One run has no band: its
/// force stands for both ends.
fn apart(field: &Field, case: &Case, result: &CheckResult) -> bool {
    if !result.broke() {
        return false;
    }
    let forecast = field.values.force;
    let half = FIVE_PER_CENT * variation(case.layout.punch) * forecast;
    let [low, high] = if result.runs > 1 { result.force.band } else { [result.force.mean; 2] };
    let outside = forecast < low || forecast > high;
    outside && (result.force.mean - forecast).abs() > half
}

/// What a capacity is read from.
enum Panel<'a> {
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
    fn force(&self, punch: f64) -> [Option<f64>; 2] {
        match self {
            Panel::Forecast(field) => {
                let mean = field.values.force;
                [Some(mean), Some(mean * characteristic_part(punch))]
            }
            Panel::Check(result) if !result.broke() => [None; 2],
            Panel::Check(result) => {
                let low = (result.runs > 1).then_some(result.force.band[0]);
                [Some(result.force.mean), low]
            }
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
            Panel::Forecast(field) => field.deflection_at(force),
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
            Panel::Forecast(field) => field.force_at(deflection.min(field.values.deflection)),
            Panel::Check(result) => match result.curve.failure {
                Some(end) if deflection >= end.deflection => end.force,
                _ => result.curve.force_at(deflection).max(0.0),
            },
        }
    }
}

#[cfg(test)]
#[path = "verdict_tests.rs"]
mod tests;
