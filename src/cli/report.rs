//! `meshcast report`: a project, its results and how to repeat them, as one file.

use super::UiFlags;
use super::destination::Destination;
use super::output::CommandEnd;
use super::source::ProjectFile;
use crate::export::form::Form;
use crate::export::{Check, Report, ReportSource};
use crate::project::schema::TitleBlock;
use clap::{Args, ValueEnum};

/// Write a report that holds everything: inputs, method, values at each step, pictures, warnings.
#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    #[command(flatten)]
    project: ProjectFile,
    /// How to write it [default: by the file's ending, else html].
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// The short form: the first page, then one page a layout.
    #[arg(long)]
    short: bool,
    #[command(flatten)]
    head: Head,
    #[command(flatten)]
    to: Destination,
}

/// What the head of the report says, above what the project says.
#[derive(Debug, Args)]
#[command(next_help_heading = "Head of the report (above the project's)")]
struct Head {
    /// For whom it is.
    #[arg(long, value_name = "TEXT")]
    client: Option<String>,
    /// Who made it.
    #[arg(long, value_name = "TEXT")]
    author: Option<String>,
    /// Who checked it.
    #[arg(long, value_name = "TEXT")]
    checker: Option<String>,
    /// Its revision.
    #[arg(long, value_name = "TEXT")]
    revision: Option<String>,
    /// Its date, as it shall stand there.
    #[arg(long, value_name = "TEXT")]
    date: Option<String>,
}

impl Head {
    fn over(&self, title: &mut TitleBlock) {
        for (name, given) in [
            ("client", &self.client),
            ("author", &self.author),
            ("checker", &self.checker),
            ("revision", &self.revision),
            ("date", &self.date),
        ] {
            if let (Some(text), Some(field)) = (given, title.field_mut(name)) {
                field.clone_from(text);
            }
        }
    }
}

/// The form of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// One page for a browser, to read or to print.
    Html,
    /// Markdown (CommonMark with tables); the pictures stand at the end as data.
    Md,
}

/// Writes the report.
pub(crate) fn run(args: &ReportArgs, ui: &UiFlags) -> CommandEnd {
    let form = match args.format {
        Some(Format::Html) => args.to.form(&[Form::Html], &args.project.path)?,
        Some(Format::Md) => args.to.form(&[Form::Markdown], &args.project.path)?,
        None => args.to.form(&[Form::Html, Form::Markdown], &args.project.path)?,
    };
    let (opened, cases) = args.project.open(None)?;
    let file_name = opened.document.title();
    let unit = ui.units_over(opened.project.display.units);
    let checks: Vec<Option<Check>> =
        cases.iter().map(|case| Check::from_kept(case, unit, &file_name)).collect();
    let mut project = opened.project.clone();
    args.head.over(&mut project.title);
    let report = Report {
        project: &project,
        cases: &cases,
        checks: &checks,
        source: ReportSource {
            file_name: &file_name,
            text: opened.document.on_disk(),
            edited: false,
        },
        unit,
        short: args.short,
    };
    let text = match form {
        Some(Form::Markdown) => report.markdown(),
        _ => report.html(),
    };
    args.to.put(text, Vec::new(), &args.project.path)
}
