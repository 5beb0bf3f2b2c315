//! `meshcast forecast`: the forecast of one layout, or of all of a project, without a screen.
//!
//! - [`json`], [`csv`], [`text`]: the three forms of the result.

mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::{Case, Source};
use super::output::{CommandEnd, Fault, TableFormat, result};
use super::page::BASIS;
use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, Question, answer};
use crate::forecast::fingerprint::of_inputs;
use crate::forecast::{Forecast, forecast};
use clap::Args;

/// Forecast a layout from flags, or the layouts of a project, without a screen.
#[derive(Debug, Args)]
pub(crate) struct ForecastArgs {
    #[command(flatten)]
    source: Source,
    /// How the result is written: JSON in SI with kN; CSV holds the curves.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// One case with its answer.
#[derive(Debug)]
struct Answered {
    case: Case,
    forecast: Forecast,
    fingerprint: Fingerprint,
    question: Question,
    /// The answer to the design questions, where there is a field value and a question.
    design: Option<Answer>,
}

/// Whether anything is asked beyond the forecast itself.
fn asks(question: &Question) -> bool {
    *question != Question::default()
}

/// Forecasts and writes the result in the form asked for.
pub(crate) fn run(args: &ForecastArgs, ui: &UiFlags) -> CommandEnd {
    let loaded = args.source.load(ui)?;
    let answered = loaded.cases.into_iter().map(answered).collect::<Result<Vec<_>, _>>()?;
    match args.format {
        TableFormat::Text => result(text::report(&answered, loaded.unit)),
        TableFormat::Json => result(json::report(&answered, loaded.several)?),
        TableFormat::Csv => Ok(csv::report(&answered, loaded.several)),
    }
}

fn answered(case: Case) -> Result<Answered, Fault> {
    let question = case.question();
    let layout = case.entry.layout();
    let rule = case.entry.branch;
    let forecast = forecast(&layout, &case.mesh, rule)
        .map_err(|found| Fault::Input(found.iter().map(|p| p.to_string()).collect()))?;
    let fingerprint = of_inputs(&layout, &case.mesh, rule);
    let design = forecast.field.filter(|_| asks(&question)).map(|field| answer(&field, &question));
    Ok(Answered { case, forecast, fingerprint, question, design })
}
