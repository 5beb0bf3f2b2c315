//! `meshcast sensitivity`: how the answer moves with each input.
//!
//! - [`text`]: tornadoes drawn in characters; [`both`]: those of forecast and check side by side;
//!   [`json`], [`csv`]: for programs.

mod both;
mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::Source;
use super::dem::{DemFlags, Done, Job};
use super::output::{CommandEnd, Output, TableFormat};
use super::verdict::BasisFlag;
use crate::case::{Case, Input};
use crate::study::sensitivity::dem::{self, CheckedSensitivity};
use crate::study::sensitivity::{Sensitivity, Step, sensitivity};
use crate::study::verdict::{Basis, Simulated, Verdict, verdict};
use clap::Args;

/// How F, delta and utilisation move with each input, both ways, largest effect first.
///
/// Steps: 10 % of d, L, D, F_l* and delta_l*, a twentieth of L for ex and ey. Each input moves alone.
/// With --dem the same steps by discrete elements beside it; F_l* and delta_l* are no inputs of those.
#[derive(Debug, Args)]
pub(crate) struct SensitivityArgs {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    basis: BasisFlag,
    #[command(flatten)]
    dem: DemFlags,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// One layout with its sensitivity.
#[derive(Debug)]
struct Studied {
    name: Option<String>,
    case: Case,
    /// Which value of a capacity verdicts go by.
    basis: Basis,
    sensitivity: Sensitivity,
    /// The same by checks, where they are asked for.
    checked: Option<CheckedSensitivity>,
}

impl Studied {
    /// The verdict on a step of an input, by the forecast and by its check.
    fn judged(&self, input: Input, step: &Step, checked: Option<&dem::CheckedStep>) -> Verdict {
        let case = self.case.with(input, step.value);
        let simulated = checked.map_or(Simulated::Missing, |c| Simulated::made(&c.answer));
        verdict(&case, &step.outcome, simulated, self.basis)
    }
}

/// The unit of an input's values for programs.
fn unit(input: Input) -> &'static str {
    if input.is_force() { "kN" } else { "m" }
}

/// Studies each layout and writes the result in the form asked for.
pub(crate) fn run(args: &SensitivityArgs, ui: &UiFlags) -> CommandEnd {
    let loaded = args.source.load(ui)?;
    let basis = args.basis.basis(loaded.basis);
    let mut studied: Vec<Studied> = loaded
        .cases
        .into_iter()
        .map(|c| {
            let case = c.case;
            Studied { sensitivity: sensitivity(&case), name: c.name, case, basis, checked: None }
        })
        .collect();
    let wanted = args.dem.wanted();
    let mut interrupted = false;
    if let Some(wanted) = &wanted {
        let jobs: Vec<Job> = studied.iter().flat_map(jobs).collect();
        let done = args.dem.run(wanted, &jobs);
        interrupted = done.interrupted;
        put(&mut studied, done);
    }
    let result = args.format.write(
        || text::report(&studied, wanted.as_ref(), loaded.unit),
        || json::report(&studied, wanted.as_ref(), loaded.several),
        || csv::report(&studied, wanted.is_some(), loaded.several),
    )?;
    Ok(Output { result, interrupted, ..Output::default() })
}

/// The checks of a layout.
fn jobs(s: &Studied) -> Vec<Job> {
    let front = s.name.as_ref().map_or(String::new(), |name| format!("{name:?}, "));
    let named = |(place, case): (usize, Case)| {
        // The case itself, then two for each input that a check knows.
        let moved = place.checked_sub(1).and_then(|p| Input::varied(&s.case.layout).nth(p / 2));
        let name = match moved {
            Some(input) => format!("{front}{} {}", input.word(), input.text(input.value(&case))),
            None => format!("{front}as it is"),
        };
        Job { name, case }
    };
    dem::cases(&s.case).into_iter().enumerate().map(named).collect()
}

/// Gives each layout its own answers.
fn put(studied: &mut [Studied], done: Done) {
    let mut answers = done.answers.as_slice();
    for s in studied {
        let count = dem::cases(&s.case).len().min(answers.len());
        let (own, rest) = answers.split_at(count);
        s.checked = Some(dem::assemble(&s.case, own));
        answers = rest;
    }
}
