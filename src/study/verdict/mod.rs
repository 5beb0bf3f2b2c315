//! The verdict on a layout: is it enough, by strength, by deflection and for the anchors.
//!
//! Service load F_k: the design force, or the pressure on the cell's area. Ultimate load
//! F_d = gamma_load F_k. Three checks:
//!
//! - strength: F_d gamma_resistance / capacity, at most 1;
//! - deflection: delta(F_k) over the allowed one on the mean curve; where the panel does not carry F_k,
//!   F_k over the force at the allowed deflection, and it fails;
//! - anchor: F_d times the worst anchor's share over what an anchor takes: the share that the check has at
//!   its first break, else 1 by statics, and where blocks face each other an upper bound, the estimate.
//!
//! The capacity is the mean, or the characteristic value: of the forecast F_a (1 - 1.645 V), of a check
//! the 5 % point of the distribution over alignments and slacks. Both are given; the basis says which one decides. Where a check by
//! simulation stands for the inputs as they are, it is judged beside the forecast and the larger use
//! counts. What is left out by all this (the scatter of a mesh's production, sliding of the block, the
//! puncture at a plate) is why no word here is "safe".

mod judge;

pub use judge::{Forecasted, verdict};

use super::checks::CheckAnswer;
use super::result::CheckResult;
use super::result::make::fingerprint;
use crate::case::Case;
use crate::remark::Weight;
use crate::words::Choice;

/// Use above which a caution makes a verdict doubtful.
const NEAR_LIMIT: f64 = 0.8;

/// Which value of a capacity decides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    #[default]
    Mean,
    /// The characteristic value, which 5 % fall below.
    Characteristic,
}

impl Basis {
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
    /// An upper bound.
    Estimate,
}

impl Judge {
    /// The word in output.
    pub fn word(self) -> &'static str {
        match self {
            Judge::Forecast => "forecast",
            Judge::Check => "check",
            Judge::Statics => "statics",
            Judge::Estimate => "estimate",
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

impl<'a> Simulated<'a> {
    /// How the check that is kept of a case stands to its inputs as they are now.
    pub(crate) fn of(kept: Option<&'a CheckResult>, case: &Case) -> Simulated<'a> {
        let Some(result) = kept else { return Simulated::Missing };
        let wire = case.mesh.wire.as_ref();
        let now = wire.map(|wire| fingerprint(&case.layout, wire, &result.wanted));
        match now.is_some_and(|now| result.current(now)) {
            true => Simulated::Current(result),
            false => Simulated::Stale,
        }
    }

    /// One that has just been made of a case as it is, or none.
    pub(crate) fn made(answer: &'a CheckAnswer) -> Simulated<'a> {
        answer.as_ref().map_or(Simulated::Missing, Simulated::Current)
    }

    /// Whether there is one that does not count.
    pub(crate) fn stale(&self) -> bool {
        matches!(self, Simulated::Stale)
    }
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
    /// The laws that fit the tests of an adopted mesh differ by more than a plain pass allows.
    WideLaws,
    /// The check is of a single block in a field that is too small.
    Unsettled,
    /// A single block without a check, by relations of a block in every cell.
    OneBlock,
}

impl VerdictRemark {
    /// Stable identifier for programs.
    pub(crate) fn code(self) -> &'static str {
        match self {
            VerdictRemark::Stale => "stale_check",
            VerdictRemark::Apart => "forecast_and_check_apart",
            VerdictRemark::OneRun => "one_run",
            VerdictRemark::Extrapolated => "extrapolated",
            VerdictRemark::WideLaws => "wide_laws",
            VerdictRemark::Unsettled => "check_not_converged",
            VerdictRemark::OneBlock => "one_block_by_relations_of_many",
        }
    }

    /// How much it weighs: near the limit a caution makes the verdict doubtful.
    pub(crate) fn weight(self) -> Weight {
        match self {
            VerdictRemark::OneRun => Weight::Note,
            _ => Weight::Caution,
        }
    }

    /// Whether it makes any pass a doubtful one, however far from the limit: the laws of an adopted mesh, which is
    /// asked for, and a single block, whose deflection is up to 1.7 times the forecast's.
    fn never_plain(self) -> bool {
        matches!(self, VerdictRemark::WideLaws | VerdictRemark::OneBlock)
    }

    /// A few words for a narrow panel.
    pub(crate) fn short(self) -> &'static str {
        match self {
            VerdictRemark::Stale => "stale check not counted",
            VerdictRemark::Apart => "forecast and check apart",
            VerdictRemark::OneRun => "one run, no lower value",
            VerdictRemark::Extrapolated => "extrapolated",
            VerdictRemark::WideLaws => "law of the mesh uncertain",
            VerdictRemark::Unsettled => "check not converged",
            VerdictRemark::OneBlock => "one block: check it",
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
            VerdictRemark::Unsettled => {
                "the check of a single block is not converged; in a larger field it would take less"
            }
            VerdictRemark::OneBlock => {
                "a single block is forecast as if there were one in every cell; without a check it is never a plain pass"
            }
            VerdictRemark::WideLaws => {
                "the laws that fit the tests of this mesh differ by more than 15 %; more data would narrow them"
            }
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

    /// By how much it is worse than others, to sort by: the largest use, and without end where the block
    /// passes through.
    pub(crate) fn severity(&self) -> f64 {
        match self.governing() {
            Some(c) if c.state == State::PassesThrough => f64::INFINITY,
            _ => self.largest_use().unwrap_or(f64::NEG_INFINITY),
        }
    }

    /// Use of the check that governs, 1 where demand meets capacity; nothing where none does.
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
        } else if self.remarks.iter().any(|r| r.never_plain())
            || caution && self.largest_use() > Some(NEAR_LIMIT)
        {
            Finding::Doubtful
        } else {
            Finding::Passes
        }
    }
}

#[cfg(test)]
mod tests;
