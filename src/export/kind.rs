//! What the program writes at a key press, and what its file is called.

use super::svg::{Series, chart, plan};
use super::{Case, Check, Report, Source, cases, csv};
use crate::problem::Problem;
use crate::project::Project;
use crate::units::LengthUnit;

/// What can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
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

impl Kind {
    /// All of them, in the order of the list.
    pub const ALL: [Kind; 7] = [
        Kind::ReportHtml,
        Kind::ReportMarkdown,
        Kind::Chart,
        Kind::ChartAll,
        Kind::Plan,
        Kind::Curves,
        Kind::Table,
    ];

    /// What it is, for people.
    pub fn about(self) -> &'static str {
        match self {
            Kind::ReportHtml => "report of the project, one HTML page",
            Kind::ReportMarkdown => "report of the project, Markdown",
            Kind::Chart => "chart of this layout, SVG",
            Kind::ChartAll => "chart of all layouts, SVG",
            Kind::Plan => "plan of this layout, SVG",
            Kind::Curves => "points of all curves, CSV",
            Kind::Table => "inputs and results of all layouts, CSV",
        }
    }

    /// The word for the command line of the program.
    pub fn word(self) -> &'static str {
        match self {
            Kind::ReportHtml => "report",
            Kind::ReportMarkdown => "markdown",
            Kind::Chart => "chart",
            Kind::ChartAll => "charts",
            Kind::Plan => "plan",
            Kind::Curves => "curves",
            Kind::Table => "table",
        }
    }

    /// The kind of a word.
    pub fn named(word: &str) -> Option<Kind> {
        Kind::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// Whether it is of one layout.
    pub fn of_one(self) -> bool {
        matches!(self, Kind::Chart | Kind::Plan)
    }

    /// The file's ending.
    pub fn ending(self) -> &'static str {
        match self {
            Kind::ReportHtml => "html",
            Kind::ReportMarkdown => "md",
            Kind::Chart | Kind::ChartAll | Kind::Plan => "svg",
            Kind::Curves | Kind::Table => "csv",
        }
    }

    /// Name of a file for it beside a project's: `road-cut-portal-chart.svg`. `nth` above 1 makes
    /// another one where that is taken.
    pub fn file_name(self, stem: &str, layout: &str, nth: usize) -> String {
        let mut parts = vec![plain(stem)];
        if self.of_one() {
            parts.push(plain(layout));
        }
        parts.push(match self {
            Kind::ReportMarkdown => "report".into(),
            other => other.word().to_string(),
        });
        if nth > 1 {
            parts.push(nth.to_string());
        }
        parts.retain(|part| !part.is_empty());
        format!("{}.{}", parts.join("-"), self.ending())
    }

    /// The text of it.
    ///
    /// # Errors
    /// What makes no sense in the project.
    pub fn text(
        self,
        project: &Project,
        layout: usize,
        source: Source<'_>,
        unit: LengthUnit,
    ) -> Result<String, Vec<Problem>> {
        let all = match (self.of_one(), project.layouts.get(layout)) {
            (true, Some(entry)) => vec![Case::of(project, entry)?],
            _ => cases(project)?,
        };
        let checks: Vec<Option<Check>> =
            all.iter().map(|case| Check::of(case, unit, source.file_name)).collect();
        let series = || -> Vec<Series<'_>> {
            all.iter()
                .zip(&checks)
                .map(|(case, check)| Series { case, check: check.as_ref() })
                .collect()
        };
        let title = |name: &str| format!("{name}: force over deflection");
        Ok(match self {
            Kind::ReportHtml | Kind::ReportMarkdown => {
                let report = Report { project, cases: &all, checks: &checks, source, unit };
                if self == Kind::ReportHtml { report.html() } else { report.markdown() }
            }
            Kind::Chart => {
                let name = all.first().map_or("", |case| case.entry.name.as_str());
                chart(&series(), &title(&format!("{}, {name}", project.name)), unit)
            }
            Kind::ChartAll => chart(&series(), &title(&project.name), unit),
            Kind::Plan => all.first().map_or(String::new(), |case| plan(case, unit)),
            Kind::Curves => csv::case_curves(&all),
            Kind::Table => csv::table(&all),
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
        let name = |kind: Kind, nth| kind.file_name("road-cut", "Portal / east ..", nth);
        assert_eq!(name(Kind::ReportHtml, 1), "road-cut-report.html");
        assert_eq!(name(Kind::Chart, 2), "road-cut-Portal-east-chart-2.svg");
        assert_eq!(Kind::Table.file_name("../..", "", 1), "table.csv");
        for kind in Kind::ALL {
            assert_eq!(Kind::named(kind.word()), Some(kind));
        }
    }

    #[test]
    fn every_kind_has_a_text() {
        let project = Project::starter("Slope");
        let source = Source { file_name: "slope.ron", text: None, edited: false };
        for kind in Kind::ALL {
            let text = kind.text(&project, 0, source, LengthUnit::Metre).unwrap();
            let start = match kind.ending() {
                "html" => "<!DOCTYPE",
                "svg" => "<svg",
                "md" => "# ",
                _ => "layout,",
            };
            assert!(text.contains(start), "{kind:?}: {}", &text[..60]);
        }
    }
}
