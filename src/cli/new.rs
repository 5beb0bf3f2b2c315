//! `meshcast new PATH`: a new project file with one layout and comments that explain the format.

use super::output::{self, CommandEnd, Fault};
use super::written::create;
use crate::project::{SaveError, new_project};
use clap::Args;
use std::io::ErrorKind;
use std::path::PathBuf;

/// Make a new project file, with comments that explain the format.
#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Where to put it; an existing file is never overwritten.
    #[arg(value_name = "PATH")]
    path: PathBuf,
}

/// Makes the file and says where it is.
pub(crate) fn run(args: &NewArgs) -> CommandEnd {
    let stem = args.path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    // A name is a line of its own in the file: no control characters, and never too long.
    let name: String = stem.chars().filter(|c| !c.is_control()).take(60).collect();
    let name = if name.trim().is_empty() { "project" } else { name.trim() };
    create(&args.path, &new_project(name)).map_err(|e| match e {
        SaveError::Exists(path) => Fault::input(format!(
            "{} exists already and is not overwritten; choose another name",
            path.display()
        )),
        SaveError::Io { ref error, .. } if error.kind() == ErrorKind::NotFound => {
            Fault::input(e.to_string())
        }
        SaveError::Io { .. } => Fault::Failure(e.to_string()),
        other => Fault::input(other.to_string()),
    })?;
    output::result(format!("{}\n", args.path.display()))
}
