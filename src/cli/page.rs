//! A text for people: lines of at most 80 columns with a word in front.

pub(crate) use crate::case::{input_unit, input_value};
pub(crate) use crate::units::percent;

use super::VERSION;
use super::output::wrapped;
use crate::case::Case;
use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, Question};
use crate::layout::{Blocks, Layout, PunchShape};
use crate::show::{say, verdict};
use crate::study::verdict::Verdict;
use crate::units::{
    Units, energy_text, force_text, length_entry, length_text, maybe_length_text, shortest,
};
use crate::words::Choice;
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// What stands with every answer: what the method is a forecast of.
pub(crate) const BASIS: &str = "lowest of the arrangements computed: a block in every cell (not one block on a large mesh); published relations are for anchors on a square grid";

/// Shape and blocks of a layout behind its other inputs, where they are not the paper's.
pub(crate) fn blocks_said(layout: &Layout) -> String {
    let (blocks, shape) = (layout.blocks, layout.shape);
    let of = |said: bool, words: String| if said { words } else { String::new() };
    of(shape != PunchShape::default(), format!(", {}", shape.word()))
        + &of(blocks != Blocks::Paper, format!(", blocks {}", blocks.word()))
}

/// Widest line, columns.
pub(crate) const WIDTH: usize = 80;
/// Columns of the words in front.
pub(crate) const MARGIN: usize = 14;

/// Columns of a layout's name in a table.
pub(crate) const NAME: usize = 14;

/// The lines of one layout.
#[derive(Debug)]
pub(crate) struct Page {
    /// Lines so far, each at most [`WIDTH`] columns.
    pub(crate) lines: Vec<String>,
    /// Unit of lengths.
    pub(crate) unit: Units,
}

impl Page {
    /// An empty page.
    pub(crate) fn new(unit: Units) -> Page {
        Page { lines: Vec::new(), unit }
    }

    /// A line, or more if the text is long, with a word in front.
    pub(crate) fn line(&mut self, head: &str, text: impl AsRef<str>) {
        self.lines.extend(wrapped(&format!("{head:<MARGIN$}"), text.as_ref(), WIDTH));
    }

    /// A computed length.
    pub(crate) fn length(&self, metres: f64) -> String {
        length_text(metres, self.unit)
    }

    /// A computed length that may be missing.
    pub(crate) fn maybe_length(&self, metres: Option<f64>) -> String {
        maybe_length_text(metres, self.unit)
    }

    /// A length as entered.
    pub(crate) fn entry(&self, metres: f64) -> String {
        format!("{} {}", length_entry(metres, self.unit), self.unit.symbol())
    }
    /// What a result is of: the layout's name or the command's, version, fingerprint, inputs, mesh.
    pub(crate) fn inputs(
        &mut self,
        command: &str,
        name: Option<&str>,
        fingerprint: Fingerprint,
        case: &Case,
    ) {
        let made_by = format!("meshcast {VERSION}, inputs {fingerprint}");
        match name {
            Some(name) => self.line("layout", format!("{name}   [{made_by}]")),
            None => self.line(command, format!("[{made_by}]")),
        }
        let l = &case.layout;
        let text = format!(
            "d {}, {}, D {}, ex {}, ey {}{}",
            self.entry(l.plate),
            say::grid(l, self.unit),
            self.entry(l.punch),
            self.entry(l.ex),
            self.entry(l.ey),
            blocks_said(l)
        );
        self.line("inputs", text);
        self.line("mesh", format!("{} ({})", case.mesh.id, case.mesh.title()));
    }

    /// The answer to a design question.
    pub(crate) fn design(&mut self, answer: &Answer, question: &Question) {
        let (on_load, on_resistance) =
            (shortest(question.gamma_load), shortest(question.gamma_resistance));
        self.line(
            "design",
            format!(
                "resistance {} with gamma_resistance {on_resistance}; gamma_load {on_load}",
                force_text(answer.resistance, self.unit)
            ),
        );
        if let (Some(at), Some(force)) = (&answer.at_force, question.force) {
            let deflection = match at.deflection {
                Some(reached) => format!(", at {}", self.length(reached)),
                None if at.beyond_failure => ", beyond failure".to_string(),
                None => String::new(),
            };
            self.line(
                "  at force",
                format!(
                    "{} factored to {}: use {} %{deflection}",
                    force_text(force, self.unit),
                    force_text(at.load, self.unit),
                    percent(at.utilisation)
                ),
            );
        }
        if let (Some(at), Some(deflection)) = (&answer.at_deflection, question.deflection) {
            let fails = if at.beyond_failure { " (fails before)" } else { "" };
            self.line(
                "  at delta",
                format!(
                    "{}{fails}: {} mobilised, {} factored, {}",
                    self.entry(deflection),
                    force_text(at.force, self.unit),
                    force_text(at.design_force, self.unit),
                    energy_text(at.energy, self.unit)
                ),
            );
        }
    }

    /// The verdict: in a word, each check that is asked, what to know, what would mend it.
    pub(crate) fn verdict(&mut self, case: &Case, v: &Verdict) {
        self.line("VERDICT", format!("{}; {} values", verdict::short(v), v.basis.word()));
        for line in verdict::lines(case, v, self.unit) {
            self.line("", line);
        }
    }

    /// The lines as a text.
    pub(crate) fn text(&self) -> String {
        self.lines.join("\n") + "\n"
    }
}

/// A name in exactly so many columns, cut with `~` where it is longer.
pub(crate) fn cut(name: &str, columns: usize) -> String {
    let mut text = String::new();
    if name.width() < columns {
        text.push_str(name);
    } else {
        for c in name.chars() {
            if text.width() + c.width().unwrap_or(0) > columns - 2 {
                break;
            }
            text.push(c);
        }
        text.push('~');
    }
    let room = columns - text.width();
    text + &" ".repeat(room)
}

/// What a result says where there is no layout.
pub(crate) const NO_LAYOUTS: &str = "The project has no layouts.\n";

/// The pages of all layouts, an empty line between them.
pub(crate) fn pages<T>(all: &[T], one: impl Fn(&T) -> String) -> String {
    if all.is_empty() {
        return NO_LAYOUTS.to_string();
    }
    all.iter().map(one).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_short_and_do_not_hide_a_limit() {
        assert_eq!([percent(0.961), percent(1.002), percent(1.0)], ["96.1", "100.2", "100"]);
    }
}
