//! Why the interactive program could not run.

use std::io;

/// Why the interactive program could not start.
#[derive(Debug, thiserror::Error)]
pub enum TermError {
    /// Standard input or output is a file or a pipe.
    #[error("this is not a terminal: {0} is a file or a pipe")]
    NoTerminal(&'static str),
    /// The terminal refused to be set up.
    #[error("cannot set up the terminal: {0}")]
    Setup(#[source] io::Error),
}
