//! What is said of the slips that people make most.

use super::{DEEPEST, Parser, Step, SyntaxError};
use crate::project::text::{Entry, NodeKind, line_column};
use crate::units::{self, Quantity, Units};

impl Parser<'_> {
    /// A unit without quotes, or no number at all.
    pub(super) fn not_a_number(&self, start: usize, shown: &str) -> SyntaxError {
        let quantity = [Quantity::Length, Quantity::Force]
            .into_iter()
            .any(|q| units::parse(shown, q, Units::METRES).is_ok());
        let error = self.error(start, "this is no number").with_value(shown);
        if quantity {
            self.error(start, "a value with a unit stands in quotes")
                .with_value(shown)
                .with_advice(format!("write \"{shown}\""))
        } else {
            error.with_advice("write an ordinary number such as 0.32")
        }
    }

    /// No field name where one is due: mostly a decimal comma.
    pub(super) fn key_missing(&mut self, entries: &[Entry]) -> SyntaxError {
        let start = self.at;
        let shown = self.word_at(start);
        if let Some(Entry { key: Some((key, _)), value, comma: Some(comma) }) = entries.last()
            && matches!(value.kind, NodeKind::Number(_))
            && shown.starts_with(|c: char| c.is_ascii_digit())
        {
            let before = value.span.slice(self.text).to_string();
            let gap = if comma.end == start { "" } else { " " };
            let (at, written) = (value.span.start, format!("{before},{gap}{shown}"));
            self.path.push(Step::Key(key.clone()));
            return self
                .error(at, "a decimal point is written as a point, not as a comma")
                .with_value(written)
                .with_advice(format!("write {before}.{shown}"));
        }
        let quoted = shown == "\"";
        self.error(start, "a field's name is expected here").with_value(shown).with_advice(
            if quoted { "names stand without quotes: name: \"bench 2\"" } else { "name: value" },
        )
    }

    /// Deeper than any project; `what` says what of.
    pub(super) fn too_deep(&self, at: usize, what: &str) -> SyntaxError {
        self.error(at, what).with_advice(format!("a project needs fewer than {DEEPEST} levels"))
    }

    pub(super) fn unclosed(&self, open: usize) -> SyntaxError {
        let bracket = self.text[open..].chars().next().unwrap_or('(');
        self.error(open, format!("the {bracket} that opens here is never closed")).with_advice(
            format!("the file ends in line {}", line_column(self.text, self.text.len()).0),
        )
    }

    pub(super) fn comma_missing(
        &mut self,
        previous: &Entry,
        open: usize,
        close: char,
    ) -> SyntaxError {
        let shown = self.word_at(self.at);
        if let Some((key, _)) = &previous.key {
            self.path.push(Step::Key(key.clone()));
        }
        let value = previous.value.span.slice(self.text);
        let number = matches!(previous.value.kind, NodeKind::Number(_));
        if number && matches!(shown, "m" | "mm" | "cm" | "kN" | "N" | "MN") {
            return self
                .error(previous.value.span.start, "a value with a unit stands in quotes")
                .with_value(format!("{value} {shown}"))
                .with_advice(format!("write \"{value} {shown}\""));
        }
        if matches!(shown, ")" | "]" | "}") {
            let (line, _) = line_column(self.text, open);
            return self.error(
                self.at,
                format!(
                    "{shown} stands here, but the bracket opened in line {line} closes with {close}"
                ),
            );
        }
        if shown == "=" && previous.key.is_none() {
            return self
                .error(self.at, format!("a colon is missing behind {value}"))
                .with_advice(format!("write {value}: and not {value} ="));
        }
        let behind = previous.key.as_ref().map_or("this value", |k| k.0.as_str());
        self.error(previous.value.span.end, format!("a comma is missing behind {behind}"))
            .with_advice("fields and list items are separated by commas")
    }
}
