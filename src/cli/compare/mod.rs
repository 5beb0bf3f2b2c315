//! `meshcast compare`: the layouts of a project side by side.
//!
//! - [`text`]: the table for people; [`both`]: that of the checks below it; [`json`], [`csv`]: for
//!   programs.

mod both;
mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::Inputs;
use super::choice::one_of;
use super::dem::{DemFlags, Job};
use super::output::{CommandEnd, Output, TableFormat, csv_as};
use super::verdict::VerdictFlags;
use crate::remark::Weight;
use crate::study::checks::CheckAnswer;
use crate::study::compare::{Column, CompareRow, Comparison, compare};
use crate::study::result::Wanted;
use crate::study::verdict::{Basis, Simulated, Verdict, verdict};
use crate::words::Choice;
use clap::Args;
use std::path::PathBuf;

/// The layouts of a project in one table, and which of them governs.
///
/// Governing is the highest utilisation, or the lowest force where no layout has a design force.
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
    /// The verdict on each row, by the forecast and by its check where there is one.
    verdicts: Vec<Verdict>,
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
    let cases = loaded.cases.into_iter().map(|c| (c.name.unwrap_or_default(), c.case));
    let comparison = compare(cases);
    let order = match args.sort {
        Some(column) => comparison.sorted(column, args.descending),
        None => (0..comparison.rows.len()).collect(),
    };
    let mut interrupted = false;
    let checked = args.dem.wanted().map(|wanted| {
        let rows = comparison.rows.iter();
        let jobs: Vec<Job> =
            rows.map(|row| Job { name: row.name.clone(), case: row.case.clone() }).collect();
        let done = args.dem.run(&wanted, &jobs);
        interrupted = done.interrupted;
        (wanted, done.answers)
    });
    let basis = args.verdict.basis(loaded.basis);
    let verdicts = judged(&comparison, checked.as_ref().map(|(_, answers)| answers), basis);
    let compared = Compared { comparison, checked, verdicts };
    let result = match args.format {
        TableFormat::Text => text::report(&compared, &order, loaded.unit),
        TableFormat::Json => json::report(&compared, &order)?,
        TableFormat::Csv | TableFormat::CsvComma => {
            csv_as(args.format, csv::report(&compared, &order))
        }
    };
    let verdict = args.verdict.code(compared.verdicts.iter());
    Ok(Output { result, verdict, interrupted, ..Output::default() })
}

/// The verdict on each row.
fn judged(c: &Comparison, answers: Option<&Vec<CheckAnswer>>, basis: Basis) -> Vec<Verdict> {
    let simulated = |row: usize| match answers.and_then(|all| all.get(row)) {
        Some(Ok(result)) => Simulated::Current(result),
        _ => Simulated::Missing,
    };
    let rows = c.rows.iter().enumerate();
    rows.map(|(at, r)| verdict(&r.case, r.forecast(), simulated(at), basis)).collect()
}
