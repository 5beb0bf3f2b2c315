//! `meshcast compare`: the layouts of a project side by side.
//!
//! - [`text`]: the table for people; [`data`]: JSON and CSV.

mod data;
mod text;

use super::UiFlags;
use super::case::Inputs;
use super::output::{Outcome, TableFormat, result};
use crate::study::compare::{Column, compare};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;

/// The layouts of a project in one table, and which of them governs.
///
/// Governing is the highest utilisation, or the lowest force where no layout has a design force.
#[derive(Debug, Args)]
pub struct CompareArgs {
    /// Project file.
    #[arg(value_name = "PROJECT.ron")]
    project: PathBuf,
    /// Column to sort by, rising; layouts with nothing there stand last [default: the project's order].
    #[arg(long, value_name = "COLUMN", value_parser = column())]
    sort: Option<Column>,
    /// Sort falling.
    #[arg(long, requires = "sort")]
    descending: bool,
    #[command(flatten)]
    inputs: Inputs,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

fn column() -> impl TypedValueParser<Value = Column> {
    PossibleValuesParser::new(Column::ALL.map(Column::word)).map(|word| {
        // One of these words, as the parser in front sees to.
        Column::ALL.into_iter().find(|c| c.word() == word).unwrap_or(Column::Name)
    })
}

/// Compares and writes the result in the form asked for.
pub fn run(args: &CompareArgs, ui: &UiFlags) -> Outcome {
    let loaded = args.inputs.of_file(&args.project, None, ui)?;
    let cases = loaded.cases.iter().map(|c| (c.entry.name.clone(), c.study()));
    let comparison = compare(cases);
    let order = match args.sort {
        Some(column) => comparison.sorted(column, args.descending),
        None => (0..comparison.rows.len()).collect(),
    };
    match args.format {
        TableFormat::Text => result(text::report(&comparison, &order, loaded.unit)),
        TableFormat::Json => result(data::json(&comparison, &order)?),
        TableFormat::Csv => result(data::csv(&comparison, &order)),
    }
}
