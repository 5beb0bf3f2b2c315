//! `meshcast forecast`: the forecast of one layout, or of all of a project, without a screen.
//!
//! - [`json`], [`csv`], [`text`]: the three forms of the result.

mod csv;
mod json;
mod text;

use super::case::{Case, Inputs};
use super::output::{Fault, Outcome, Output};
use super::{UiFlags, VERSION};
use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, Question, answer};
use crate::forecast::fingerprint::of_inputs;
use crate::forecast::{Forecast, forecast};
use crate::project;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Forecast a layout from flags, or the layouts of a project, without a screen.
#[derive(Debug, Args)]
pub struct ForecastArgs {
    /// Project file; without it, one layout from the flags below.
    #[arg(value_name = "PROJECT.ron")]
    project: Option<PathBuf>,
    /// Only the layout of this name.
    #[arg(long, value_name = "NAME", requires = "project", allow_hyphen_values = true)]
    layout: Option<String>,
    #[command(flatten)]
    inputs: Inputs,
    /// How the result is written: JSON in SI with kN; CSV holds the curves.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// How a forecast is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A text for people.
    Text,
    /// JSON, SI with kN.
    Json,
    /// The curves, with a header line.
    Csv,
}

/// What stands with every answer: what the method is a forecast of.
const BASIS: &str = "lower bound: a block in every cell (not one block on a large mesh); anchors on a square grid, net hung with its twists down the slope";

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
pub fn run(args: &ForecastArgs, ui: &UiFlags) -> Outcome {
    let mut unit = ui.units;
    let cases = match &args.project {
        None => vec![args.inputs.alone()?],
        Some(path) => {
            let opened = project::load(path)?;
            unit = unit.or(Some(opened.project.display.length_unit));
            args.inputs.of_project(&opened.project, args.layout.as_deref())?
        }
    };
    let answered = cases.into_iter().map(answered).collect::<Result<Vec<_>, _>>()?;
    let several = args.project.is_some() && args.layout.is_none();
    match args.format {
        Format::Text => Ok(Output {
            result: text::report(&answered, unit.unwrap_or_default()),
            ..Output::default()
        }),
        Format::Json => {
            Ok(Output { result: json::report(&answered, several)?, ..Output::default() })
        }
        Format::Csv => Ok(csv::report(&answered, several)),
    }
}

fn answered(case: Case) -> Result<Answered, Fault> {
    let question = case.question();
    let layout = case.entry.layout();
    let rule = case.entry.branch;
    let forecast = forecast(&layout, &case.mesh, rule)
        .map_err(|found| Fault::Input(found.iter().map(|p| p.to_string()).collect()))?;
    let fingerprint = of_inputs(&layout, &case.mesh, rule, &question);
    let design = forecast.field.filter(|_| asks(&question)).map(|field| answer(&field, &question));
    Ok(Answered { case, forecast, fingerprint, question, design })
}
