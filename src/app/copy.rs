//! What `y` and `Y` copy: one line with the answer, the table of layouts, or the page being read.

use super::App;
use super::message::Command;
use crate::case::Input;
use crate::units::{force_text, length_text, shortest, significant, to_kn};

/// What is said when something was sent; nobody tells whether the terminal took it.
const SENT: &str = "copied, if the terminal takes OSC 52";

/// Columns of the table, tabs between them; names and units as in the CSV of an export.
const COLUMNS: &str = "layout\tmesh\td_m\tL_m\tD_m\tex_m\tey_m\tF_kN\tdelta_m\tdesign_F_kN\t\
                       utilisation\tload_delta_m\tallowable_delta_m\tallowable_F_kN\tcheck_F_kN\t\
                       check_delta_m\tcheck_stale\twarnings";

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
        let answer = match (&self.result().derived, self.result().forecast().and_then(|f| f.field))
        {
            (Err(problems), _) => {
                problems.first().map_or("no forecast".into(), ToString::to_string)
            }
            (_, None) => "no field value: outside the method".into(),
            (Ok(derived), Some(field)) => {
                let mut text = format!(
                    "F_a {}, delta_a {}",
                    force_text(field.values.force),
                    m(field.values.deflection)
                );
                if let Some(a) = self.result().answer().and_then(|d| d.at_force) {
                    text += &format!(
                        ", use {:.0} % at {} kN",
                        a.utilisation * 100.0,
                        significant(to_kn(a.load), 3)
                    );
                }
                if derived.forecast.extrapolated() {
                    text += ", extrapolated";
                }
                if let Some(shown) = self.shown_check().filter(|shown| shown.result.broke()) {
                    text += &format!(
                        "; check {}, {}{}",
                        force_text(shown.result.force.mean),
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
        let mut table = format!("{COLUMNS}\n");
        let layouts = self.project().layouts.iter().zip(self.results());
        for (index, (layout, result)) in layouts.enumerate() {
            let check = self.kept_check(index).filter(|shown| shown.result.broke());
            let forecast = result.forecast();
            let field = forecast.and_then(|f| f.field).map(|f| f.values);
            let at_force = result.answer().and_then(|d| d.at_force);
            let at_deflection = result.answer().and_then(|d| d.at_deflection);
            let kn = |v: Option<f64>| v.map_or(String::new(), |v| significant(to_kn(v), 5));
            let plain = |v: Option<f64>| v.map_or(String::new(), |v| significant(v, 5));
            let input = |v: f64| shortest(v);
            let warnings =
                forecast.map_or(Vec::new(), |f| f.warnings.iter().map(|w| w.code()).collect());
            let cells = [
                // A tab in a name would be a column.
                layout.name.replace(['\t', '\n', '\r'], " "),
                layout.mesh.clone(),
                input(layout.layout.plate),
                input(layout.layout.spacing),
                input(layout.layout.punch),
                input(layout.layout.ex),
                input(layout.layout.ey),
                kn(field.map(|v| v.force)),
                plain(field.map(|v| v.deflection)),
                kn(layout.question.force),
                plain(at_force.map(|a| a.utilisation)),
                plain(at_force.and_then(|a| a.deflection)),
                plain(layout.question.deflection),
                kn(at_deflection.map(|a| a.force)),
                kn(check.map(|c| c.result.force.mean)),
                plain(check.map(|c| c.result.deflection.mean)),
                check.map_or(String::new(), |c| c.stale().to_string()),
                warnings.join(" "),
            ];
            table.push_str(&cells.join("\t"));
            table.push('\n');
        }
        table
    }
}
