//! A key press as the program knows it, free of any terminal library.

use std::fmt;

/// Which key, without its modifiers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Code {
    /// A printable character as typed: `?` is `?`, not Shift with `/`.
    Char(char),
    Enter,
    /// Escape.
    Esc,
    Tab,
    /// Shift with Tab.
    BackTab,
    Backspace,
    Delete,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow left.
    Left,
    /// Arrow right.
    Right,
    PageUp,
    PageDown,
    Home,
    End,
    /// A function key, from 1.
    F(u8),
}

/// A key press. Shift is part of the character for printable keys and stands on its own only for arrows
/// and their like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    /// Which key.
    pub code: Code,
    /// Control held.
    pub ctrl: bool,
    /// Alt held.
    pub alt: bool,
    /// Shift held, for keys that print nothing.
    pub shift: bool,
}

impl Key {
    /// A key without modifiers.
    pub const fn plain(code: Code) -> Key {
        Key { code, ctrl: false, alt: false, shift: false }
    }

    /// A printable character.
    pub const fn char(c: char) -> Key {
        Key::plain(Code::Char(c))
    }

    /// Control with a character.
    pub const fn ctrl(c: char) -> Key {
        Key { code: Code::Char(c), ctrl: true, alt: false, shift: false }
    }

    /// Shift with a key that prints nothing.
    pub const fn shift(code: Code) -> Key {
        Key { code, ctrl: false, alt: false, shift: true }
    }
}

/// The key in words, as the help prints it: `Ctrl+S`, `Shift+Left`, `Enter`, `?`.
impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.ctrl {
            write!(f, "Ctrl+")?;
        }
        if self.alt {
            write!(f, "Alt+")?;
        }
        if self.shift {
            write!(f, "Shift+")?;
        }
        match self.code {
            Code::Char(' ') => write!(f, "Space"),
            Code::Char(c) if self.ctrl => write!(f, "{}", c.to_ascii_uppercase()),
            Code::Char(c) => write!(f, "{c}"),
            Code::Enter => write!(f, "Enter"),
            Code::Esc => write!(f, "Esc"),
            Code::Tab => write!(f, "Tab"),
            Code::BackTab => write!(f, "Shift+Tab"),
            Code::Backspace => write!(f, "Backspace"),
            Code::Delete => write!(f, "Delete"),
            Code::Up => write!(f, "Up"),
            Code::Down => write!(f, "Down"),
            Code::Left => write!(f, "Left"),
            Code::Right => write!(f, "Right"),
            Code::PageUp => write!(f, "PgUp"),
            Code::PageDown => write!(f, "PgDn"),
            Code::Home => write!(f, "Home"),
            Code::End => write!(f, "End"),
            Code::F(n) => write!(f, "F{n}"),
        }
    }
}
