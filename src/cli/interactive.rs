//! The interactive program: `meshcast [PROJECT.ron]`.

use super::{UiFlags, headless_help, output};
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

/// Opens a project in the terminal: the one named, or the last one. Without a terminal on standard
/// input and output, prints the help of the headless commands to standard error: exit code 2.
pub fn interactive(path: Option<PathBuf>, flags: UiFlags) -> ExitCode {
    if !(io::stdin().is_terminal() && io::stdout().is_terminal()) {
        output::say(
            "error",
            "the interactive program needs a terminal; without one, use a command",
        );
        let _ = write!(io::stderr(), "\n{}", headless_help());
        return ExitCode::from(output::BAD_INPUT);
    }
    start(path, flags)
}

/// Hands the terminal over.
fn start(_path: Option<PathBuf>, _flags: UiFlags) -> ExitCode {
    output::say("error", "the interactive program is not part of this build; try --help");
    ExitCode::from(output::FAILURE)
}
