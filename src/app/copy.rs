//! What `y` and `Y` copy: one line with the answer, the table of layouts, or the page being read.

use super::App;
use super::derived::LayoutResult;
use super::message::Command;
use crate::case::Input;
use crate::problem::summary;
use crate::project::schema::NamedLayout;
use crate::show::layouts::{self, LayoutParts, LayoutRow};
use crate::show::{say, verdict};
use crate::units::{force_text, length_text};

/// What is said when something was sent; nobody tells whether the terminal took it.
const SENT: &str = "copied, if the terminal takes OSC 52";

/// Columns of the table, those of an export that people look for.
const COLUMNS: [&str; 22] = [
    "layout",
    "mesh",
    "d_m",
    "L_m",
    "D_m",
    "ex_m",
    "ey_m",
    "F_kN",
    "delta_m",
    "design_F_kN",
    "utilisation",
    "verdict",
    "verdict_by",
    "use",
    "design_delta_m",
    "service_delta_m",
    "allowable_delta_m",
    "allowable_F_kN",
    "check_F_kN",
    "check_delta_m",
    "check_stale",
    "warnings",
];

impl App {
    /// Copies the answer of the selected layout.
    pub(super) fn copy_answer(&mut self) -> Vec<Command> {
        let text = self.answer_line();
        self.copy("the answer", text)
    }

    /// Copies the table of all layouts.
    pub(super) fn copy_table(&mut self) -> Vec<Command> {
        let text = self.layouts_table();
        self.copy("the table of layouts", text)
    }

    /// Copies the page that is being read.
    pub(super) fn copy_page(&mut self) -> Vec<Command> {
        let lines: Vec<String> = self.page_lines().into_iter().map(|line| line.text).collect();
        self.copy("the page", lines.join("\n") + "\n")
    }

    fn copy(&mut self, what: &str, text: String) -> Vec<Command> {
        self.inform(format!("{what}: {SENT}"));
        vec![Command::Copy { text }]
    }

    /// The selected layout with its answer, on one line.
    pub(crate) fn answer_line(&self) -> String {
        let layout = self.layout();
        let m = |v: f64| length_text(v, self.units());
        let answer = match (&self.result().derived, self.result().forecast().map(|f| f.field)) {
            (Err(problems), _) => summary(problems),
            (_, None) => String::new(),
            (_, Some(Err(why))) => why.sentence().into(),
            (Ok(derived), Some(Ok(field))) => {
                let mut text = say::values(field.values, self.units());
                if let Some(verdict) = self.result().asked_verdict() {
                    text += &format!(", {}", verdict::short(verdict));
                }
                if derived.forecast.extrapolated() {
                    text += ", extrapolated";
                }
                if let Some(shown) = self.shown_check().filter(|shown| shown.result.broke()) {
                    text += &format!(
                        "; check {}, {}{}",
                        force_text(shown.result.force.mean, self.units()),
                        m(shown.result.deflection.mean),
                        if shown.stale() { " (stale)" } else { "" }
                    );
                }
                text
            }
        };
        let inputs = [Input::Plate, Input::Spacing, Input::Punch, Input::OffsetX, Input::OffsetY]
            .map(|f| {
                let value = layout.get(f).map_or(String::new(), |v| f.entry_text(v, self.units()));
                format!("{} {value} {}", f.word(), f.unit(self.units()))
            });
        format!("{}: {answer}; {}; mesh {}", layout.name, inputs.join(", "), layout.mesh)
    }

    /// All layouts with their results, a line each, tabs between the columns.
    pub(crate) fn layouts_table(&self) -> String {
        let layouts = self.project().layouts.iter().zip(self.results()).enumerate();
        let rows = layouts.map(|(index, (layout, result))| self.row(index, layout, result));
        layouts::table().only(&COLUMNS).tabs(rows, " ")
    }

    fn row<'a>(
        &'a self,
        index: usize,
        layout: &'a NamedLayout,
        result: &'a LayoutResult,
    ) -> LayoutParts<'a> {
        LayoutParts::from(LayoutRow {
            name: &layout.name,
            mesh: &layout.mesh,
            layout: &layout.layout,
            question: &layout.question,
            case: result.case.as_ref(),
            derived: result.derived.as_ref().ok(),
            verdict: result.verdict.as_ref(),
            check: self.kept_check(index).map(|shown| (shown.result, shown.stale())),
        })
    }
}
