//! A bad input as a value: which field, what stood there, what is allowed and what to do.
//!
//! Rooms below `project` and `cli` only know fields. Those two rooms add the file and the line
//! or the flag, and print the whole.

use crate::words::in_text;
use std::fmt;

/// One thing wrong with one field of the input.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Path of the field inside what was checked, for example `laboratory.force`. Empty for the whole.
    pub field: String,
    /// What stood there, as a person would write it, unit included. Empty if nothing did.
    pub value: String,
    /// What is wrong, as a short sentence without a final stop.
    pub message: String,
    /// The allowed range with its unit, or the allowed words. Empty where the message says it all.
    pub allowed: String,
    /// What to do about it, as a short sentence. Empty where the range says it all.
    pub advice: String,
}

impl Problem {
    /// What is wrong with a text of any number of lines, if it has characters that cannot be shown.
    pub(crate) fn of_text(field: &str, text: &str) -> Option<Problem> {
        (!text.chars().all(in_text)).then(|| {
            Problem::new(field, "the text has characters that cannot be shown")
                .allowed("letters, digits, signs, line feeds and tabs")
        })
    }

    /// A problem with `field`, of which `message` says what is wrong.
    pub(crate) fn new(field: impl Into<String>, message: impl Into<String>) -> Self {
        Problem {
            field: field.into(),
            value: String::new(),
            message: message.into(),
            allowed: String::new(),
            advice: String::new(),
        }
    }

    /// The same problem with the value that stood there.
    pub(crate) fn value(mut self, value: impl Into<String>) -> Self {
        self.value = value.into();
        self
    }

    /// The same problem with the allowed range.
    pub(crate) fn allowed(mut self, allowed: impl Into<String>) -> Self {
        self.allowed = allowed.into();
        self
    }

    /// The same problem with advice on what to do.
    pub(crate) fn advice(mut self, advice: impl Into<String>) -> Self {
        self.advice = advice.into();
        self
    }

    /// The same problem under another name of its field, if that is in a list of pairs of such.
    pub(crate) fn renamed(mut self, names: &[(&str, &str)]) -> Self {
        if let Some((_, name)) = names.iter().find(|(field, _)| *field == self.field) {
            self.field = (*name).to_string();
        }
        self
    }

    /// The same problem seen from the parent: `under("layouts[2]")` turns `d` into `layouts[2].d`.
    pub(crate) fn under(mut self, parent: &str) -> Self {
        self.field = match (parent.is_empty(), self.field.is_empty()) {
            (true, _) => self.field,
            (_, true) => parent.to_string(),
            // The item of a list.
            _ if self.field.starts_with('[') => format!("{parent}{}", self.field),
            _ => format!("{parent}.{}", self.field),
        };
        self
    }
}

/// Some problems in a line: the first, and how many there are besides. Never empty, so that nobody is
/// refused without a word.
pub(crate) fn summary(found: &[Problem]) -> String {
    match found {
        [] => "no reason is known".into(),
        [one] => one.to_string(),
        [first, others @ ..] => format!("{first} (and {} more)", others.len()),
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.field.is_empty() {
            write!(f, "{}", self.field)?;
            if !self.value.is_empty() {
                write!(f, " = {}", self.value)?;
            }
            write!(f, ": ")?;
        }
        write!(f, "{}", self.message)?;
        if !self.allowed.is_empty() {
            write!(f, "; allowed: {}", self.allowed)?;
        }
        if !self.advice.is_empty() {
            write!(f, "; {}", self.advice)?;
        }
        Ok(())
    }
}

impl std::error::Error for Problem {}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fault: screens showed an empty reason where a list of problems was empty.
    #[test]
    fn a_refusal_never_shows_an_empty_reason() {
        assert_eq!(summary(&[]), "no reason is known");
        let two = [Problem::new("d", "too small"), Problem::new("L", "too large")];
        assert_eq!(summary(&two[..1]), two[0].to_string());
        assert_eq!(summary(&two), format!("{} (and 1 more)", two[0]));
    }
}
