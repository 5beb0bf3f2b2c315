//! Where a text goes: standard output, or a file that is never overwritten by chance.

use super::output::{CommandEnd, Fault, Output};
use super::written::write_file;
use crate::export::form::Form;
use crate::project::home::typed_path;
use crate::project::{Overwrite, SaveError, same_file};
use clap::Args;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Flags of commands that write a text.
#[derive(Debug, Clone, Args)]
pub(crate) struct Destination {
    /// File to write; without it, or as `-`, standard output.
    #[arg(short = 'o', long = "output", value_name = "FILE")]
    file: Option<PathBuf>,
    /// Overwrite the file if there is one.
    #[arg(long, requires = "file")]
    force: bool,
}

impl Destination {
    /// The form among these that the file's ending says; the first of them where it says nothing.
    ///
    /// # Errors
    /// The ending says a form that is not among them, or the file is the one that is read.
    pub(crate) fn form(&self, among: &[Form], source: &Path) -> Result<Option<Form>, Fault> {
        self.check_source(source)?;
        Form::of_path(self.path().as_deref(), among)
            .map_err(|said| Fault::input(format!("--output: {said}")))
    }

    /// The file; a shell leaves a quoted `~` alone.
    fn path(&self) -> Option<PathBuf> {
        self.file.as_deref().filter(|path| *path != Path::new("-")).map(typed_path)
    }

    fn check_source(&self, source: &Path) -> Result<(), Fault> {
        match self.path() {
            Some(path) if same_file(&path, source) => Err(Fault::input(format!(
                "{} is the project itself, which is never overwritten; choose another name",
                path.display()
            ))),
            _ => Ok(()),
        }
    }

    /// Brings a text to its place; `source` is the file it was made from, which is never overwritten.
    ///
    /// # Errors
    /// Why the file was not written; it is as it was then.
    pub(crate) fn put(&self, text: String, notes: Vec<String>, source: &Path) -> CommandEnd {
        let Some(path) = self.path() else {
            return Ok(Output { result: text, notes, ..Output::default() });
        };
        self.check_source(source)?;
        let overwrite = if self.force { Overwrite::Yes } else { Overwrite::No };
        write_file(&path, &text, overwrite).map_err(fault)?;
        // The whole path, ready to be copied from another machine.
        let whole = std::path::absolute(&path).unwrap_or(path);
        Ok(Output { result: format!("{}\n", whole.display()), notes, ..Output::default() })
    }
}

fn fault(error: SaveError) -> Fault {
    let said = error.to_string();
    match error {
        SaveError::Exists(path) => Fault::input(format!(
            "{} exists already and is not overwritten; give --force, or choose another name",
            path.display()
        )),
        SaveError::Io { ref error, .. } if error.kind() != ErrorKind::NotFound => {
            Fault::Failure(said)
        }
        _ => Fault::input(said),
    }
}
