//! What the bottom line says.

/// How loud a message is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Something went as asked.
    Info,
    /// Something was refused or failed.
    Error,
}

/// The message in the bottom line, until the next key.
#[derive(Debug, Clone, PartialEq)]
pub struct Status {
    /// How loud.
    pub level: Level,
    /// What it says.
    pub text: String,
}

impl Status {
    /// Something went as asked.
    pub(super) fn info(text: impl Into<String>) -> Status {
        Status { level: Level::Info, text: text.into() }
    }

    /// Something was refused or failed.
    pub(super) fn error(text: impl Into<String>) -> Status {
        Status { level: Level::Error, text: text.into() }
    }
}
