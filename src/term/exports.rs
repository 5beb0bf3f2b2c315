//! Writing reports, charts and tables beside a project.

use crate::app::message::Exported;
use crate::export::form::Form;
use crate::export::{ExportKind, ReportSource};
use crate::project::home::typed_path;
use crate::project::{Document, Overwrite, Project, SaveError, same_file, write_file};
use crate::units::Units;
use std::path::{Path, PathBuf};

/// What is to be written.
#[derive(Debug, Clone, Copy)]
pub struct ExportWanted<'a> {
    /// What it is.
    pub kind: ExportKind,
    pub project: &'a Project,
    /// Whether the project has edits that are not in its file.
    pub edited: bool,
    /// The layout selected, an index.
    pub layout: usize,
    /// Unit of lengths.
    pub unit: Units,
    /// Where to; beside the project under a free name where nothing is said.
    pub path: Option<&'a Path>,
    /// Whether to replace a file that is there.
    pub overwrite: bool,
}

/// Names that are tried before giving up.
const MOST_NAMES: usize = 1000;

/// Writes it.
///
/// # Errors
/// Why it was not, for people.
pub(super) fn write(document: &Document, wanted: ExportWanted<'_>) -> Result<Exported, String> {
    let title = document.title();
    let source = ReportSource {
        file_name: if document.path().is_some() { &title } else { "" },
        text: document.on_disk(),
        edited: wanted.edited,
    };
    let text =
        wanted.kind.text(wanted.project, wanted.layout, source, wanted.unit).map_err(|found| {
            found.iter().map(std::string::ToString::to_string).collect::<Vec<_>>().join("; ")
        })?;
    let note = wanted.edited.then(|| "edits are not saved yet".to_string());
    if let Some(path) = wanted.path {
        let path = &typed_path(path);
        if document.path().is_some_and(|own| same_file(own, path)) {
            return Err("that is the project itself, which is never overwritten".into());
        }
        Form::of_path(Some(path), &[wanted.kind.form()])?;
        let overwrite = if wanted.overwrite { Overwrite::Yes } else { Overwrite::No };
        return match write_file(path, &text, overwrite) {
            Ok(()) => Ok(Exported { path: path.clone(), note }),
            Err(SaveError::Exists(path)) => {
                Err(format!("{} exists; :export! replaces it", path.display()))
            }
            Err(other) => Err(other.to_string()),
        };
    }
    let folder = document.path().and_then(Path::parent).map_or(PathBuf::new(), Path::to_path_buf);
    let stem = document
        .path()
        .and_then(Path::file_stem)
        .map_or("meshcast".into(), |s| s.to_string_lossy());
    let layout = wanted.project.layouts.get(wanted.layout).map_or("", |l| l.name.as_str());
    for nth in 1..=MOST_NAMES {
        let path = folder.join(wanted.kind.file_name(&stem, layout, nth));
        match write_file(&path, &text, Overwrite::No) {
            Ok(()) => return Ok(Exported { path, note }),
            Err(SaveError::Exists(_)) => {}
            Err(other) => return Err(other.to_string()),
        }
    }
    Err(format!(
        "there are {MOST_NAMES} files of that name already; :export KIND PATH takes another"
    ))
}

#[cfg(test)]
#[path = "exports_tests.rs"]
mod tests;
