//! The line of text being typed: a value, a name, a note or a command.

use super::key::{Code, Key};
use super::keymap::StudyPage;
use crate::case::Input;
use crate::words::shown;
use tui_input::{Input as TextInput, InputRequest};

/// What the text is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EditTarget {
    /// The value of an input.
    Value(Input),
    /// The name of the selected layout.
    Name,
    /// The note of the selected layout.
    Note,
    Command,
    /// A project to open.
    File,
    /// A row of the form of a mesh.
    Mesh,
    /// A text or a name to look for.
    Find,
    /// Something on a page of a study.
    Study(Typed),
}

impl EditTarget {
    /// What the prompt says.
    pub(crate) fn prompt(self) -> &'static str {
        match self {
            EditTarget::Value(_) => "value",
            EditTarget::Name => "name",
            EditTarget::Note => "note",
            EditTarget::Command => ":",
            EditTarget::File => "open",
            EditTarget::Mesh => "mesh",
            EditTarget::Find => "find",
            EditTarget::Study(typed) => typed.prompt(),
        }
    }
}

/// What a text typed on a page of a study is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Typed {
    /// A design value or a partial factor of the selected layout.
    Design(Input),
    /// A part of a range: of the first input (0) or the second (1), and which.
    Range(usize, Slot),
    /// How far an input may be off.
    Off,
}

impl Typed {
    /// The page it belongs to.
    pub(crate) fn page(self) -> StudyPage {
        match self {
            Typed::Design(_) => StudyPage::Design,
            Typed::Range(..) => StudyPage::Sweep,
            Typed::Off => StudyPage::Tolerance,
        }
    }

    /// What the prompt says.
    pub(crate) fn prompt(self) -> &'static str {
        match self {
            Typed::Design(field) => field.row().phrase,
            Typed::Range(_, Slot::Input) => "input",
            Typed::Range(_, Slot::From) => "from",
            Typed::Range(_, Slot::To) => "to",
            Typed::Range(_, Slot::Steps) => "number of values",
            Typed::Off => "off by",
        }
    }
}

/// What is chosen or typed at the head of the page of the sweep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Slot {
    /// Which input.
    Input,
    /// First value of its range.
    From,
    /// Last value of its range.
    To,
    /// Number of values.
    Steps,
}

/// A line being typed.
#[derive(Debug, Clone)]
pub struct LineEntry {
    /// What it is for.
    pub(crate) target: EditTarget,
    /// The text with its cursor.
    pub(crate) input: TextInput,
    /// Why the text was refused, until it is changed.
    pub(crate) error: Option<String>,
}

/// Most characters taken in one line.
const LONGEST: usize = 500;

/// What a key did to the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineKey {
    /// The line goes on.
    Typing,
    /// Enter: take the text.
    Take,
    /// Esc or Ctrl+G: drop it.
    Drop,
}

impl LineEntry {
    /// A line for `target` that starts as `text`, cursor at its end.
    pub(crate) fn new(target: EditTarget, text: impl Into<String>) -> LineEntry {
        LineEntry { target, input: TextInput::new(text.into()), error: None }
    }

    /// The text so far.
    pub(crate) fn text(&self) -> &str {
        self.input.value()
    }

    /// Index of the character under the cursor.
    pub(crate) fn cursor(&self) -> usize {
        self.input.cursor()
    }

    /// What a key does.
    pub(crate) fn key(&mut self, key: Key) -> LineKey {
        use InputRequest as R;
        let request = match key {
            Key { code: Code::Enter, .. } => return LineKey::Take,
            Key { code: Code::Esc, .. } => return LineKey::Drop,
            Key { code: Code::Char('g' | 'c'), ctrl: true, .. } => return LineKey::Drop,
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
                if self.target == EditTarget::Command && self.text().is_empty() {
                    return LineKey::Drop;
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
            _ => return LineKey::Typing,
        };
        if self.input.handle(request).is_some_and(|change| change.value) {
            self.error = None;
        }
        LineKey::Typing
    }

    /// Inserts pasted text; line ends and tabs become spaces, other control characters are left out.
    pub(crate) fn paste(&mut self, text: &str) {
        for c in text.trim_end_matches(['\r', '\n']).chars() {
            let c = if matches!(c, '\r' | '\n' | '\t') { ' ' } else { c };
            self.insert(c);
        }
    }

    fn insert(&mut self, c: char) -> LineKey {
        if shown(c) && self.text().chars().count() < LONGEST {
            self.input.handle(InputRequest::InsertChar(c));
            self.error = None;
        }
        LineKey::Typing
    }
}
