//! `meshcast export`: curves and tables as CSV, chart and plan as SVG.

use super::UiFlags;
use super::destination::Destination;
use super::output::{CommandEnd, Fault};
use super::source::ProjectFile;
use crate::export::form::Form;
use crate::export::svg::{Series, chart, plan};
use crate::export::{Check, ExportedLayout, csv};
use crate::show::table::with_decimal_comma;
use clap::{Args, ValueEnum};

/// Write curves or a table as CSV, a chart or a plan as SVG.
#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    #[command(flatten)]
    project: ProjectFile,
    /// Only the layout of this name; a plan always is of one layout.
    #[arg(long, value_name = "NAME", allow_hyphen_values = true)]
    layout: Option<String>,
    /// What to write [default: the curves, or the chart where SVG is asked for].
    #[arg(long, value_enum)]
    what: Option<What>,
    /// How to write it; follows from what is written, or from the file's ending.
    #[arg(long, value_enum)]
    format: Option<Format>,
    #[command(flatten)]
    to: Destination,
}

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    /// The points of the forecast curves (CSV, m and kN).
    Curve,
    /// All inputs and results, one line a layout (CSV, m and kN).
    Table,
    /// Force over deflection (SVG).
    Chart,
    /// The cell of one layout from above (SVG).
    Plan,
}

/// How it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Comma-separated values with a header line.
    Csv,
    /// The same for spreadsheets with a decimal comma: semicolons between the fields.
    CsvComma,
    /// A picture for reports.
    Svg,
}

impl Format {
    fn form(self) -> Form {
        match self {
            Format::Csv | Format::CsvComma => Form::Csv,
            Format::Svg => Form::Svg,
        }
    }
}

impl What {
    fn format(self) -> Format {
        match self {
            What::Curve | What::Table => Format::Csv,
            What::Chart | What::Plan => Format::Svg,
        }
    }

    fn word(self) -> &'static str {
        match self {
            What::Curve => "curve",
            What::Table => "table",
            What::Chart => "chart",
            What::Plan => "plan",
        }
    }
}

/// Writes what is asked for.
pub(crate) fn run(args: &ExportArgs, ui: &UiFlags) -> CommandEnd {
    let what = what(args)?;
    let (opened, cases) = args.project.open(args.layout.as_deref())?;
    let unit = ui.units_over(opened.project.display.units);
    let without = cases.iter().filter_map(|case| Some((case, case.forecast().field.err()?)));
    let notes: Vec<String> = without
        .map(|(case, why)| format!("layout {:?}: {}", case.entry.name, why.sentence()))
        .collect();
    let (text, notes) = match what {
        What::Curve => (csv::case_curves(&cases), notes),
        What::Table => (csv::table(&cases), Vec::new()),
        What::Chart => {
            let title = match cases.as_slice() {
                [one] => {
                    format!("{}, {}: force over deflection", opened.project.name, one.entry.name)
                }
                _ => format!("{}: force over deflection", opened.project.name),
            };
            let file_name = opened.document.title();
            let checks: Vec<Option<Check>> =
                cases.iter().map(|case| Check::from_kept(case, unit, &file_name)).collect();
            let series: Vec<Series<'_>> = cases
                .iter()
                .zip(&checks)
                .map(|(case, check)| Series { case, check: check.as_ref() })
                .collect();
            (chart(&series, &title, unit), notes)
        }
        What::Plan => (plan(only_one(&cases)?, unit), Vec::new()),
    };
    let comma = args.format == Some(Format::CsvComma);
    let text = if comma { with_decimal_comma(&text) } else { text };
    args.to.put(text, notes, &args.project.path)
}

fn what(args: &ExportArgs) -> Result<What, Fault> {
    match (args.what, args.format) {
        (Some(what), Some(format)) if what.format().form() != format.form() => {
            let (right, others) = match format {
                Format::Csv | Format::CsvComma => ("CSV", "curve, table"),
                Format::Svg => ("SVG", "chart, plan"),
            };
            Err(Fault::input(format!(
                "--what = {}: there is no such thing as {right}; allowed with this --format: {others}",
                what.word()
            )))
        }
        (Some(what), _) => args.to.form(&[what.format().form()], &args.project.path).map(|_| what),
        (None, format) => {
            let among = match format {
                Some(format) => vec![format.form()],
                None => vec![Form::Csv, Form::Svg],
            };
            Ok(match args.to.form(&among, &args.project.path)? {
                Some(Form::Svg) => What::Chart,
                _ => What::Curve,
            })
        }
    }
}

fn only_one(cases: &[ExportedLayout]) -> Result<&ExportedLayout, Fault> {
    match cases {
        [one] => Ok(one),
        [] => Err(Fault::input("the project has no layouts, so there is no plan")),
        all => {
            let names: Vec<String> =
                all.iter().take(12).map(|case| format!("{:?}", case.entry.name)).collect();
            Err(Fault::input(format!(
                "--layout: a plan is of one layout; allowed: {}",
                names.join(", ")
            )))
        }
    }
}
