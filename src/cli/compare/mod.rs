//! `meshcast compare`: the layouts of a project side by side.
//!
//! - [`text`]: the table for people; [`both`]: that of the checks below it; [`json`], [`csv`]: for
//!   programs.

mod both;
mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::{Inputs, NamedCase};
use super::choice::one_of;
use super::dem::{DemFlags, Job};
use super::output::{CommandEnd, Output, TableFormat};
use super::verdict::VerdictFlags;
use crate::remark::Weight;
use crate::study::checks::CheckAnswer;
use crate::study::compare::{self, Column, CompareRow, Comparison};
use crate::study::result::Wanted;
use crate::study::verdict::Simulated;
use crate::words::Choice;
use clap::Args;
use std::path::PathBuf;

/// The layouts of a project in one table, and which of them governs.
///
/// Governing is the worst verdict, or the lowest force where no layout has a load.
#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// Project file.
    #[arg(value_name = "PROJECT.ron")]
    project: PathBuf,
    /// Column to sort by, rising; layouts with nothing there stand last [default: the project's order].
    #[arg(long, value_name = "COLUMN", value_parser = one_of(Column::ALL))]
    sort: Option<Column>,
    /// Sort falling.
    #[arg(long, requires = "sort")]
    descending: bool,
    #[command(flatten)]
    inputs: Inputs,
    #[command(flatten)]
    verdict: VerdictFlags,
    #[command(flatten)]
    dem: DemFlags,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// A comparison with its checks.
#[derive(Debug)]
struct Compared {
    comparison: Comparison,
    /// What is asked of the checks, and one answer for each row, where they are asked for.
    checked: Option<(Wanted, Vec<CheckAnswer>)>,
}

impl Compared {
    /// The check of a row.
    fn answer(&self, row: usize) -> Option<&CheckAnswer> {
        self.checked.as_ref()?.1.get(row)
    }
}

/// The mark of a row's warnings: `!` for what weighs more than a note.
fn mark(row: &CompareRow) -> &'static str {
    if row.weight() >= Some(Weight::Caution) { "!" } else { "" }
}

/// Compares and writes the result in the form asked for.
pub(crate) fn run(args: &CompareArgs, ui: &UiFlags) -> CommandEnd {
    let loaded = args.inputs.of_file(&args.project, None, ui)?;
    let mut interrupted = false;
    let checked = args.dem.wanted().map(|wanted| {
        let job =
            |c: &NamedCase| Job { name: c.name.clone().unwrap_or_default(), case: c.case.clone() };
        let jobs: Vec<Job> = loaded.cases.iter().map(job).collect();
        let done = args.dem.run(&wanted, &jobs);
        interrupted = done.interrupted;
        (wanted, done.answers)
    });
    let layouts = loaded.cases.iter().enumerate().map(|(row, c)| {
        let simulated = match &checked {
            Some((_, answers)) => answers.get(row).map_or(Simulated::Missing, Simulated::made),
            None => Simulated::of(c.check.as_deref(), &c.case),
        };
        let name = c.name.clone().unwrap_or_default();
        compare::LayoutToCompare { name, case: c.case.clone(), simulated }
    });
    let comparison = compare::compare(layouts, args.verdict.basis(loaded.basis));
    let order = match args.sort {
        Some(column) => comparison.sorted(column, args.descending),
        None => (0..comparison.rows.len()).collect(),
    };
    let compared = Compared { comparison, checked };
    let result = args.format.write(
        || text::report(&compared, &order, loaded.unit),
        || json::report(&compared, &order),
        || csv::report(&compared, &order),
    )?;
    let verdict = args.verdict.code(compared.comparison.rows.iter().map(|row| &row.verdict));
    Ok(Output { result, verdict, interrupted, ..Output::default() })
}
