//! `meshcast forecast`: the forecast of one layout, or of all of a project, without a screen.
//!
//! - [`json`], [`csv`], [`text`]: the three forms of the result.

mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::Source;
use super::output::{CommandEnd, Fault, TableFormat, result};
use super::page::BASIS;
use crate::case::{Case, Derived, NamedCase};
use crate::forecast::Forecast;
use crate::forecast::design::Answer;
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

/// One case with what follows from it.
#[derive(Debug)]
struct Answered {
    name: Option<String>,
    case: Case,
    forecast: Forecast,
    /// The answer to the design question, where there is a field value and a question.
    design: Option<Answer>,
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

fn answered(NamedCase { name, case }: NamedCase) -> Result<Answered, Fault> {
    let Derived { forecast, answer } = case.derive()?;
    let design = answer.filter(|_| case.question.asks());
    Ok(Answered { name, case, forecast, design })
}
