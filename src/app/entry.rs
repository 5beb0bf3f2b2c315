//! The line of text being typed: a value, a name, a note or a command.

use super::field::Field;
use super::key::{Code, Key};
use super::studies::typed::Typed;
use tui_input::{Input, InputRequest};

/// What the text is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// The value of an input.
    Value(Field),
    /// The name of the selected layout.
    Name,
    /// The note of the selected layout.
    Note,
    /// A command.
    Command,
    /// A project to open.
    File,
    /// Something on a page of a study.
    Study(Typed),
}

impl Target {
    /// What the prompt says.
    pub fn prompt(self) -> &'static str {
        match self {
            Target::Value(_) => "value",
            Target::Name => "name",
            Target::Note => "note",
            Target::Command => ":",
            Target::File => "open",
            Target::Study(typed) => typed.prompt(),
        }
    }
}

/// A line being typed.
#[derive(Debug, Clone)]
pub struct Entry {
    /// What it is for.
    pub target: Target,
    /// The text with its cursor.
    pub input: Input,
    /// Why the text was refused, until it is changed.
    pub error: Option<String>,
}

/// Most characters taken in one line.
const LONGEST: usize = 500;

/// What a key did to the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The line goes on.
    Typing,
    /// Enter: take the text.
    Take,
    /// Esc or Ctrl+G: drop it.
    Drop,
}

impl Entry {
    /// A line for `target` that starts as `text`, cursor at its end.
    pub fn new(target: Target, text: impl Into<String>) -> Entry {
        Entry { target, input: Input::new(text.into()), error: None }
    }

    /// The text so far.
    pub fn text(&self) -> &str {
        self.input.value()
    }

    /// Index of the character under the cursor.
    pub fn cursor(&self) -> usize {
        self.input.cursor()
    }

    /// What a key does.
    pub fn key(&mut self, key: Key) -> Outcome {
        use InputRequest as R;
        let request = match key {
            Key { code: Code::Enter, .. } => return Outcome::Take,
            Key { code: Code::Esc, .. } => return Outcome::Drop,
            Key { code: Code::Char('g' | 'c'), ctrl: true, .. } => return Outcome::Drop,
            Key { code: Code::Char(c), ctrl: false, alt: false, .. } => {
                return self.insert(c);
            }
            Key { code: Code::Char('a'), ctrl: true, .. } => R::GoToStart,
            Key { code: Code::Char('e'), ctrl: true, .. } => R::GoToEnd,
            Key { code: Code::Char('u'), ctrl: true, .. } => R::DeleteLine,
            Key { code: Code::Char('k'), ctrl: true, .. } => R::DeleteTillEnd,
            Key { code: Code::Char('w'), ctrl: true, .. } => R::DeletePrevWord,
            Key { code: Code::Char('h'), ctrl: true, .. } | Key { code: Code::Backspace, .. } => {
                // Backspace in an empty command line leaves it, as in other programs.
                if self.target == Target::Command && self.text().is_empty() {
                    return Outcome::Drop;
                }
                R::DeletePrevChar
            }
            Key { code: Code::Delete, .. } => R::DeleteNextChar,
            Key { code: Code::Left, ctrl: true, .. } => R::GoToPrevWord,
            Key { code: Code::Right, ctrl: true, .. } => R::GoToNextWord,
            Key { code: Code::Left, .. } => R::GoToPrevChar,
            Key { code: Code::Right, .. } => R::GoToNextChar,
            Key { code: Code::Home, .. } => R::GoToStart,
            Key { code: Code::End, .. } => R::GoToEnd,
            _ => return Outcome::Typing,
        };
        if self.input.handle(request).is_some_and(|change| change.value) {
            self.error = None;
        }
        Outcome::Typing
    }

    /// Inserts pasted text; line ends and tabs become spaces, other control characters are left out.
    pub fn paste(&mut self, text: &str) {
        for c in text.trim_end_matches(['\r', '\n']).chars() {
            let c = if matches!(c, '\r' | '\n' | '\t') { ' ' } else { c };
            self.insert(c);
        }
    }

    fn insert(&mut self, c: char) -> Outcome {
        if !c.is_control() && self.text().chars().count() < LONGEST {
            self.input.handle(InputRequest::InsertChar(c));
            self.error = None;
        }
        Outcome::Typing
    }
}
