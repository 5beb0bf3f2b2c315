//! `meshcast forecast`: the forecast of one layout, or of all of a project, without a screen.
//!
//! - [`json`], [`csv`], [`text`]: the three forms of the result.

mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::{NamedCase, Source};
use super::output::{CommandEnd, Fault, Output, TableFormat};
use super::page::BASIS;
use super::verdict::VerdictFlags;
use crate::case::{Case, Derived};
use crate::forecast::Forecast;
use crate::forecast::design::Answer;
use crate::study::verdict::{Basis, Simulated, Verdict, verdict};
use clap::Args;

/// Forecast a layout from flags, or the layouts of a project, without a screen.
#[derive(Debug, Args)]
pub(crate) struct ForecastArgs {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    verdict: VerdictFlags,
    /// How the result is written: JSON in SI with kN; CSV holds the curves.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// One case with what follows from it.
#[derive(Debug)]
struct Answered {
    name: Option<String>,
    case: Case,
    forecast: Forecast,
    /// The answer to the design question, where there is a field value and a question.
    design: Option<Answer>,
    /// The verdict, by the forecast and by the check that is kept.
    verdict: Verdict,
}

/// Forecasts and writes the result in the form asked for.
pub(crate) fn run(args: &ForecastArgs, ui: &UiFlags) -> CommandEnd {
    let loaded = args.source.load(ui)?;
    let basis = args.verdict.basis(loaded.basis);
    let answered = loaded.cases.into_iter().map(|case| answered(case, basis));
    let answered = answered.collect::<Result<Vec<_>, _>>()?;
    let mut notes = Vec::new();
    let result = args.format.write(
        || text::report(&answered, loaded.unit),
        || json::report(&answered, loaded.several),
        || {
            let table;
            (table, notes) = csv::report(&answered, loaded.several);
            table
        },
    )?;
    let verdict = args.verdict.code(answered.iter().map(|a| &a.verdict));
    Ok(Output { result, notes, verdict, ..Output::default() })
}

fn answered(NamedCase { name, case, check }: NamedCase, basis: Basis) -> Result<Answered, Fault> {
    let Derived { forecast, answer } = case.derive()?;
    let design = answer.filter(|_| case.question.asks());
    let verdict = verdict(&case, &forecast, Simulated::of(check.as_deref(), &case), basis);
    Ok(Answered { name, case, forecast, design, verdict })
}
