//! Pastes: they go into the field that is open, and never act as keys.
//!
//! On the main screen and the pages of studies a pasted number begins an entry, as its first digit would
//! if it were typed. Anything else that is pasted where no text is taken is refused with a word.

use super::key::{Code, Key};
use super::keymap::{self, Action};
use super::message::Command;
use super::{App, Mode};

/// What is said of a paste that has no place to go.
const NO_PLACE: &str = "nothing was pasted: no field is open (Enter, n and : open one)";

impl App {
    /// Text of a marked paste.
    pub(super) fn paste(&mut self, text: &str) {
        self.screen.hush();
        if self.paste_into_field(text) {
            return;
        }
        let text = text.trim();
        let first = text.chars().next().filter(|c| begins_number(*c));
        let first = first.filter(|c| self.may_open_field(*c) && !text.contains(['\r', '\n']));
        if let Some(first) = first {
            self.key(Key::char(first));
            if self.paste_into_field(&text[first.len_utf8()..]) {
                return;
            }
        }
        self.complain(NO_PLACE);
    }

    /// Puts text into the field that is open; `false` when there is none.
    fn paste_into_field(&mut self, text: &str) -> bool {
        if let Some(entry) = self.screen.entry() {
            entry.paste(text);
        } else if let Some(picker) = self.screen.picker() {
            picker.paste(text);
        } else if let Some(form) = self.screen.mesh_form() {
            form.line().paste(text);
        } else {
            return false;
        }
        true
    }

    /// A paste that came as keys. A single line is typed text if it begins in a field or opens one, and
    /// so are lines that are commands all of them: their Enter is meant. Several lines in a field become
    /// one, as in a marked paste. The rest would be keys by chance, and is refused.
    pub(super) fn burst(&mut self, keys: &[Key]) -> Vec<Command> {
        let text: String = keys.iter().map(|key| character(*key)).collect();
        let body = text.trim_end_matches('\r');
        let single = !body.contains('\r') && text.len() - body.len() <= 1;
        let in_field = self.screen.takes_text();
        let commands = body.split('\r').all(|line| line.starts_with(':'));
        let opens = text.chars().next().is_some_and(|c| self.may_open_field(c));
        if in_field && !single {
            self.paste(&text);
            return Vec::new();
        }
        if in_field || (opens && (commands || single)) {
            return self.type_in(keys);
        }
        self.screen.hush();
        let count = keys.len();
        self.complain(format!(
            "{count} keys at once, as of a paste: no field is open, nothing done"
        ));
        Vec::new()
    }

    /// Types keys as long as there is a field for them, or they open one.
    fn type_in(&mut self, keys: &[Key]) -> Vec<Command> {
        let mut effects = Vec::new();
        for key in keys {
            if !self.may_open_field(character(*key)) && !self.screen.takes_text() {
                break;
            }
            effects.extend(self.key(*key));
        }
        effects
    }

    /// Whether a key by itself does no more here than to begin a command or a value; whether a page of a
    /// study takes a value is seen when it did.
    fn may_open_field(&self, c: char) -> bool {
        let Some(context) = self.context() else { return false };
        match keymap::action(context, Key::char(c)) {
            Some(action) => action == Action::Command,
            None if self.editor.empty() => false,
            None => begins_number(c) && matches!(self.screen.mode(), Mode::Main | Mode::Study(_)),
        }
    }
}

/// A digit or sign with which a value begins.
fn begins_number(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '.' | '-')
}

/// The character that a key stands for in a text.
fn character(key: Key) -> char {
    match key.code {
        Code::Char(c) => c,
        Code::Tab => '\t',
        _ => '\r',
    }
}
