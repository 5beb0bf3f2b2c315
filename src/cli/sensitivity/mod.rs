//! `meshcast sensitivity`: how the answer moves with each input.
//!
//! - [`text`]: tornadoes drawn in characters; [`data`]: JSON and CSV.

mod data;
mod text;

use super::UiFlags;
use super::case::Source;
use super::output::{Outcome, TableFormat, result};
use crate::study::case::Case;
use crate::study::sensitivity::{Sensitivity, sensitivity};
use clap::Args;

/// How F, delta and utilisation move with each input, both ways, largest effect first.
///
/// Steps: 10 % of d, L, D, F_l* and delta_l*, a twentieth of L for ex and ey. Each input moves alone.
#[derive(Debug, Args)]
pub struct SensitivityArgs {
    #[command(flatten)]
    source: Source,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// One layout with its sensitivity.
#[derive(Debug)]
struct Studied {
    name: Option<String>,
    case: Case,
    sensitivity: Sensitivity,
}

/// Studies each layout and writes the result in the form asked for.
pub fn run(args: &SensitivityArgs, ui: &UiFlags) -> Outcome {
    let loaded = args.source.load(ui)?;
    let studied: Vec<Studied> = loaded
        .cases
        .into_iter()
        .map(|c| {
            let case = c.study();
            Studied { sensitivity: sensitivity(&case), name: c.name, case }
        })
        .collect();
    match args.format {
        TableFormat::Text => result(text::report(&studied, loaded.unit)),
        TableFormat::Json => result(data::json(&studied, loaded.several)?),
        TableFormat::Csv => result(data::csv(&studied, loaded.several)),
    }
}
