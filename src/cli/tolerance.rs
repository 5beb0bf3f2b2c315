//! `meshcast tolerance`: what a layout gives where one input is not what it should be.

use super::UiFlags;
use super::case::Source;
use super::choice::one_of;
use super::output::{CommandEnd, Fault, Output, TableFormat, json_list};
use super::page::{BASIS, Page, pages};
use super::quantity::of_input;
use super::verdict::VerdictFlags;
use crate::case::{Case, Input};
use crate::show::columns::{self, CHANGE, PointRow, point};
use crate::show::objects::{head, inputs};
use crate::show::table::Table;
use crate::show::value::{Object, Value};
use crate::show::{tolerance as show, verdict};
use crate::study::tolerance::{Tolerance, TolerancePlace, tolerance};
use crate::units::Units;
use clap::Args;

/// What a layout gives where one input is off by so much either way, and where that is worst.
///
/// For a hole drilled beside its mark, a plate cut too small, a block larger than it was taken to be.
/// Worst is the largest use, the lowest force where no load is set, and any value that the method has no
/// answer for.
#[derive(Debug, Args)]
pub(crate) struct ToleranceArgs {
    #[command(flatten)]
    source: Source,
    /// The input that may be off.
    #[arg(long, value_name = "INPUT", value_parser = one_of(&Input::VARIED))]
    vary: Input,
    /// How far, either way.
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    off: String,
    #[command(flatten)]
    verdict: VerdictFlags,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// One layout with what it gives.
struct Studied {
    name: Option<String>,
    case: Case,
    found: Tolerance,
}

/// Studies each layout and writes the result in the form asked for.
pub(crate) fn run(args: &ToleranceArgs, ui: &UiFlags) -> CommandEnd {
    let off =
        of_input(args.vary, &args.off).map_err(|said| Fault::input(format!("--off: {said}")))?;
    let loaded = args.source.load(ui)?;
    let basis = args.verdict.basis(loaded.basis);
    let mut studied = Vec::new();
    for c in loaded.cases {
        let found = tolerance(&c.case, args.vary, off, basis).map_err(|found| {
            Fault::from(
                found.into_iter().map(|p| p.renamed(&[("off", "--off")])).collect::<Vec<_>>(),
            )
        })?;
        studied.push(Studied { name: c.name, case: c.case, found });
    }
    let result = args.format.write(
        || pages(&studied, |s| text(s, loaded.unit)),
        || json_list(studied.iter().map(json), loaded.several),
        || table(args.vary, loaded.several).csv(studied.iter().flat_map(rows), ";"),
    )?;
    let worst = studied.iter().map(|s| &s.found.places[3].verdict);
    Ok(Output { result, verdict: args.verdict.code(worst), ..Output::default() })
}

/// A place with its layout.
type Row<'a> = (Option<&'a str>, &'a TolerancePlace, PointRow<'a>);

fn rows(s: &Studied) -> impl Iterator<Item = Row<'_>> {
    s.found.places.iter().map(|p| (s.name.as_deref(), p, PointRow::from(&p.outcome)))
}

fn table<'a>(input: Input, named: bool) -> Table<'a, Row<'a>> {
    Table::new()
        .when(named, |table| table.with("layout", |row: &Row| row.0.map(String::from).into()))
        .with("place", |row| row.1.word.into())
        .with(input.column(), move |row| columns::input(input, row.1.value))
        .part(point(), |row| Some(&row.2))
        .part(verdict::COLUMNS, |row| Some(&row.1.verdict))
        .part(CHANGE, |row| row.1.change.as_ref())
}

fn json(s: &Studied) -> Object {
    let columns = table(s.found.input, false);
    head(s.name.as_deref(), s.case.question_fingerprint(), inputs(&s.case))
        .with("vary", s.found.input.word())
        .with("off", columns::input(s.found.input, s.found.off))
        .with("places", rows(s).map(|row| columns.object(&row)).collect::<Value>())
        .with("basis", BASIS)
}

fn text(s: &Studied, unit: Units) -> String {
    let mut page = Page::new(unit);
    let fingerprint = s.case.question_fingerprint();
    page.inputs("tolerance", s.name.as_deref(), fingerprint, &s.case);
    page.line("off", show::title(&s.found, unit));
    page.lines.extend(show::lines(&s.found, unit).into_iter().map(|line| line.text));
    page.line("basis", BASIS);
    page.text()
}
