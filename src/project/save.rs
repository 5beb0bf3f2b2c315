//! Project to file: atomic, durable, and never over somebody else's changes.

use super::disk;
use super::document::{Document, holds};
use super::draft::{self, Draft, Place};
use super::hold::{Held, hold};
use super::load;
use super::method_files;
use super::patch::Rendered;
use super::schema::Project;
use super::write::Unwritable;
use crate::problem::{Problem, summary};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Whether to save over a file that is not as it was when it was opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overwrite {
    /// Refuse.
    No,
    /// Save all the same.
    Yes,
}

/// A save that went well.
#[derive(Debug, Clone, PartialEq)]
pub struct SaveReport {
    /// The file as it was named.
    pub path: PathBuf,
    /// Whether the comments of the old text are kept.
    pub comments_kept: bool,
    /// The format version that the file had before, where it was an older one.
    pub migrated_from: Option<u32>,
    /// Whether the file had been deleted meanwhile, and was made again.
    pub recreated: bool,
    /// What the system said when the file was in place but could not be brought to the disk for sure.
    pub(crate) unsure: Option<String>,
}

/// Why a save did not happen. The file on disk is as it was.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// The project has no file yet.
    #[error("this project has no file yet; save it under a name")]
    NoPath,
    /// The file is not as it was when it was opened.
    #[error("{} was changed by something else since it was opened; save again to overwrite it, or save under another name", .0.display())]
    ChangedOnDisk(PathBuf),
    /// There is a file of that name already.
    #[error("{} exists already; save again to overwrite it, or choose another name", .0.display())]
    Exists(PathBuf),
    /// The file is marked as read-only.
    #[error("{} is read-only; change its mode (chmod u+w) or save under another name", .0.display())]
    ReadOnly(PathBuf),
    /// The path leads to something that is no ordinary file.
    #[error("{} is no ordinary file; save under another name", .0.display())]
    NotAFile(PathBuf),
    /// Somebody else is saving it, for longer than that takes.
    #[error("{} is held by another program; try again, or save under another name", .0.display())]
    Busy(PathBuf),
    /// A save makes a new file, and that would not be all that the old one is.
    #[error("{} would lose {}; save again to go on, or save under another name", .0.display(), .1.join(", "))]
    Loses(PathBuf, Vec<String>),
    /// The project names a method by a file that it would not find from there.
    #[error("copy {0} into that folder first: the project looks for it there")]
    MethodAway(String),
    /// The project itself is wrong.
    #[error("the project cannot be saved: {}", summary(.0))]
    Unsound(Vec<Problem>),
    /// No file can hold a part of the project.
    #[error("the project cannot be saved: {0}")]
    Unwritable(#[from] Unwritable),
    /// The system refused.
    #[error("{} cannot be saved: {}; nothing was changed", .path.display(), explain(.error))]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
}

fn explain(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::PermissionDenied => "you may not write in its directory".to_string(),
        ErrorKind::ReadOnlyFilesystem => "the disk is read-only".to_string(),
        ErrorKind::StorageFull => "the disk is full".to_string(),
        ErrorKind::QuotaExceeded => "your disk quota is used up".to_string(),
        ErrorKind::NotFound => "its directory does not exist".to_string(),
        _ => error.to_string(),
    }
}

impl Document {
    /// Saves an edited project to its file.
    ///
    /// The text is written to a new file beside it, brought to the disk, and put in its place in
    /// one step, so that the old or the new text stands there whatever happens. The mode stays; a
    /// symbolic link stays and the file it leads to is saved. A file that was deleted meanwhile is
    /// made again.
    ///
    /// # Errors
    /// [`SaveError`]; nothing was changed then, neither the file nor the document.
    pub fn save(
        &mut self,
        project: &Project,
        overwrite: Overwrite,
    ) -> Result<SaveReport, SaveError> {
        let path = self.path.clone().ok_or(SaveError::NoPath)?;
        let rendered = self.checked_text(project)?;
        let target = resolve(&path)?;
        let held = hold(&target)?;
        if let Some(held) = &held
            && overwrite == Overwrite::No
            && (self.unseen
                || self.on_disk.as_ref().map(String::as_bytes) != Some(held.bytes.as_slice()))
        {
            return Err(match self.on_disk {
                Some(_) => SaveError::ChangedOnDisk(path),
                None => SaveError::Exists(path),
            });
        }
        let recreated = held.is_none() && self.on_disk.is_some();
        let unsure = replace(&path, &target, held, &rendered.text, overwrite)?;
        Ok(self.saved(path, project, rendered, recreated, unsure))
    }

    /// Saves an edited project to another file, which is its file from then on.
    ///
    /// # Errors
    /// [`SaveError`]; nothing was changed then. [`SaveError::Exists`] if there is such a file and
    /// `overwrite` is no.
    pub fn save_as(
        &mut self,
        path: &Path,
        project: &Project,
        overwrite: Overwrite,
    ) -> Result<SaveReport, SaveError> {
        if self.path.as_deref() == Some(path) {
            return self.save(project, overwrite);
        }
        let rendered = self.checked_text(project)?;
        method_files::follow(project, path).map_err(SaveError::MethodAway)?;
        let target = resolve(path)?;
        let held = hold(&target)?;
        if held.is_some() && overwrite == Overwrite::No {
            return Err(SaveError::Exists(path.to_path_buf()));
        }
        let unsure = replace(path, &target, held, &rendered.text, overwrite)?;
        Ok(self.saved(path.to_path_buf(), project, rendered, false, unsure))
    }

    fn checked_text(&self, project: &Project) -> Result<Rendered, SaveError> {
        project.check().map_err(SaveError::Unsound)?;
        let rendered = self.render(project)?;
        if !holds(&rendered.text, project) {
            let problem = Problem::new("", "the file would not hold what is on the screen");
            return Err(SaveError::Unsound(vec![problem]));
        }
        Ok(rendered)
    }

    /// The document after a save.
    fn saved(
        &mut self,
        path: PathBuf,
        project: &Project,
        rendered: Rendered,
        recreated: bool,
        unsure: Option<String>,
    ) -> SaveReport {
        let report = SaveReport {
            path: path.clone(),
            comments_kept: rendered.comments_kept,
            migrated_from: self.migrated_from.take(),
            recreated,
            unsure,
        };
        // The text was read back before it was written, so this always succeeds.
        if let Ok(parsed) = load::parse_text(&rendered.text, "") {
            self.tree = parsed.tree;
        }
        self.path = Some(path);
        self.on_disk = Some(rendered.text.clone());
        self.text = rendered.text;
        self.base = project.clone();
        self.unseen = false;
        report
    }
}

/// Makes a new project file.
///
/// # Errors
/// [`SaveError::Exists`] if there is such a file, or what the system said.
pub fn create(path: &Path, text: &str) -> Result<(), SaveError> {
    write_file(path, text, Overwrite::No)
}

/// Writes a text to a file with the care that a project gets: in one step, on the disk, mode and
/// symbolic links kept. For what is made from a project, such as a report.
///
/// # Errors
/// [`SaveError::Exists`] if there is such a file and `overwrite` is no, or what the system said.
pub(crate) fn write_file(path: &Path, text: &str, overwrite: Overwrite) -> Result<(), SaveError> {
    let target = resolve(path)?;
    let held = hold(&target)?;
    if held.is_some() && overwrite == Overwrite::No {
        return Err(SaveError::Exists(path.to_path_buf()));
    }
    // What a report or a table is beyond its text is nothing to ask about.
    replace(path, &target, held, text, Overwrite::Yes).map(|_| ())
}

/// Puts a text in the place of a file that is held, or where there is none; `path` is the file as it was
/// named. What the system said where the new file is in place but perhaps not on the disk.
fn replace(
    path: &Path,
    target: &Path,
    held: Option<Held>,
    text: &str,
    overwrite: Overwrite,
) -> Result<Option<String>, SaveError> {
    let failed = |error| SaveError::Io { path: path.to_path_buf(), error };
    let draft = Draft::new(target, held.is_some()).map_err(failed)?;
    if let Some(held) = &held {
        let mut lost = draft.dress(&held.file).map_err(failed)?;
        let links = disk::links(&held.file);
        if links > 1 {
            lost.insert(
                0,
                format!("its other names ({links} hard links, which keep the old text)"),
            );
        }
        if !lost.is_empty() && overwrite == Overwrite::No {
            return Err(SaveError::Loses(path.to_path_buf(), lost));
        }
    }
    draft.write(text.as_bytes()).map_err(failed)?;
    let place = if held.is_some() { Place::Over } else { Place::Free };
    match draft.put(place) {
        Ok(placed) => Ok(placed.unsure.map(|error| error.to_string())),
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            Err(SaveError::Exists(path.to_path_buf()))
        }
        Err(error) => Err(failed(error)),
    }
}

/// Removes what killed saves left in the directory of a file.
pub(crate) fn sweep_beside(path: &Path) {
    let file = resolve(path).unwrap_or_else(|_| path.to_path_buf());
    if let Some(dir) = file.parent() {
        draft::sweep(dir);
    }
}

/// Whether two paths lead to one file that is there.
pub(crate) fn same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    }
}

/// The file behind a chain of symbolic links; the path itself if there is none.
/// A link that leads to no file yet is followed too, so that the link stays.
pub(super) fn resolve(path: &Path) -> Result<PathBuf, SaveError> {
    let mut at = path.to_path_buf();
    for _ in 0..40 {
        match fs::symlink_metadata(&at) {
            Ok(about) if about.file_type().is_symlink() => {
                let next = fs::read_link(&at)
                    .map_err(|error| SaveError::Io { path: path.to_path_buf(), error })?;
                at = match at.parent() {
                    Some(parent) => parent.join(next),
                    None => next,
                };
            }
            _ => return Ok(at),
        }
    }
    Err(SaveError::NotAFile(path.to_path_buf()))
}
