//! What the program writes at a key press, and what its file is called.

use super::form::Form;
use super::svg::{Series, chart, plan};
use super::{Check, ExportedLayout, Report, ReportSource, csv, exported};
use crate::problem::Problem;
use crate::project::Project;
use crate::units::Units;

/// What can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExportKind {
    /// The whole project as one HTML page.
    ReportHtml,
    /// The same as Markdown.
    ReportMarkdown,
    /// Chart of the selected layout, SVG.
    Chart,
    /// Chart of all layouts, SVG.
    ChartAll,
    /// Plan of the selected layout, SVG.
    Plan,
    /// Points of all curves, CSV.
    Curves,
    /// All inputs and results, CSV.
    Table,
}

impl ExportKind {
    /// All of them, in the order of the list.
    pub(crate) const ALL: [ExportKind; 7] = [
        ExportKind::ReportHtml,
        ExportKind::ReportMarkdown,
        ExportKind::Chart,
        ExportKind::ChartAll,
        ExportKind::Plan,
        ExportKind::Curves,
        ExportKind::Table,
    ];

    /// What it is, for people.
    pub(crate) fn about(self) -> &'static str {
        match self {
            ExportKind::ReportHtml => "report of the project, one HTML page",
            ExportKind::ReportMarkdown => "report of the project, Markdown",
            ExportKind::Chart => "chart of this layout, SVG",
            ExportKind::ChartAll => "chart of all layouts, SVG",
            ExportKind::Plan => "plan of this layout, SVG",
            ExportKind::Curves => "points of all curves, CSV",
            ExportKind::Table => "inputs and results of all layouts, CSV",
        }
    }

    /// The word for the command line of the program.
    pub(crate) fn word(self) -> &'static str {
        match self {
            ExportKind::ReportHtml => "report",
            ExportKind::ReportMarkdown => "markdown",
            ExportKind::Chart => "chart",
            ExportKind::ChartAll => "charts",
            ExportKind::Plan => "plan",
            ExportKind::Curves => "curves",
            ExportKind::Table => "table",
        }
    }

    /// The kind of a word.
    pub(crate) fn named(word: &str) -> Option<ExportKind> {
        ExportKind::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// Whether it is of one layout.
    pub(crate) fn of_one(self) -> bool {
        matches!(self, ExportKind::Chart | ExportKind::Plan)
    }

    /// How it is written.
    pub(crate) fn form(self) -> Form {
        match self {
            ExportKind::ReportHtml => Form::Html,
            ExportKind::ReportMarkdown => Form::Markdown,
            ExportKind::Chart | ExportKind::ChartAll | ExportKind::Plan => Form::Svg,
            ExportKind::Curves | ExportKind::Table => Form::Csv,
        }
    }

    /// Name of a file for it beside a project's: `road-cut-portal-chart.svg`. `nth` above 1 makes
    /// another one where that is taken.
    pub(crate) fn file_name(self, stem: &str, layout: &str, nth: usize) -> String {
        let mut parts = vec![plain(stem)];
        if self.of_one() {
            parts.push(plain(layout));
        }
        parts.push(match self {
            ExportKind::ReportMarkdown => "report".into(),
            other => other.word().to_string(),
        });
        if nth > 1 {
            parts.push(nth.to_string());
        }
        parts.retain(|part| !part.is_empty());
        format!("{}.{}", parts.join("-"), self.form().endings()[0])
    }

    /// The text of it.
    ///
    /// # Errors
    /// What makes no sense in the project.
    pub fn text(
        self,
        project: &Project,
        layout: usize,
        source: ReportSource<'_>,
        unit: Units,
    ) -> Result<String, Vec<Problem>> {
        let all = match (self.of_one(), project.layouts.get(layout)) {
            (true, Some(entry)) => vec![ExportedLayout::new(project, entry)?],
            _ => exported(project)?,
        };
        let checks: Vec<Option<Check>> =
            all.iter().map(|case| Check::from_kept(case, unit, source.file_name)).collect();
        let series = || -> Vec<Series<'_>> {
            all.iter()
                .zip(&checks)
                .map(|(case, check)| Series { case, check: check.as_ref() })
                .collect()
        };
        let title = |name: &str| format!("{name}: force over deflection");
        Ok(match self {
            ExportKind::ReportHtml | ExportKind::ReportMarkdown => {
                let report =
                    Report { project, cases: &all, checks: &checks, source, unit, short: false };
                if self == ExportKind::ReportHtml { report.html() } else { report.markdown() }
            }
            ExportKind::Chart => {
                let name = all.first().map_or("", |case| case.entry.name.as_str());
                chart(&series(), &title(&format!("{}, {name}", project.name)), unit)
            }
            ExportKind::ChartAll => chart(&series(), &title(&project.name), unit),
            ExportKind::Plan => all.first().map_or(String::new(), |case| plan(case, unit)),
            ExportKind::Curves => csv::case_curves(&all),
            ExportKind::Table => csv::table(&all),
        })
    }
}

/// A word for a file name: letters and digits, all else a dash, not too long.
fn plain(text: &str) -> String {
    let dashed: String = text
        .chars()
        .map(|c| if c.is_alphanumeric() || c == '_' { c } else { '-' })
        .take(40)
        .collect();
    let parts: Vec<&str> = dashed.split('-').filter(|part| !part.is_empty()).collect();
    parts.join("-")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_in_the_file_and_are_safe() {
        let name = |kind: ExportKind, nth| kind.file_name("road-cut", "Portal / east ..", nth);
        assert_eq!(name(ExportKind::ReportHtml, 1), "road-cut-report.html");
        assert_eq!(name(ExportKind::Chart, 2), "road-cut-Portal-east-chart-2.svg");
        assert_eq!(ExportKind::Table.file_name("../..", "", 1), "table.csv");
        for kind in ExportKind::ALL {
            assert_eq!(ExportKind::named(kind.word()), Some(kind));
        }
    }

    #[test]
    fn every_kind_has_a_text() {
        let project = Project::starter("Slope");
        let source = ReportSource { file_name: "slope.ron", text: None, edited: false };
        for kind in ExportKind::ALL {
            let text = kind.text(&project, 0, source, Units::METRES).unwrap();
            let start = match kind.form() {
                Form::Html => "<!DOCTYPE",
                Form::Svg => "<svg",
                Form::Markdown => "# ",
                Form::Csv => "layout,",
            };
            assert!(text.contains(start), "{kind:?}: {}", &text[..60]);
        }
    }
}
