//! Project to file: atomic, durable, and never over somebody else's changes.

use super::document::{Document, holds};
use super::load;
use super::patch::Rendered;
use super::schema::Project;
use super::write::Unwritable;
use crate::problem::{Problem, summary};
use atomic_write_file::OpenOptions;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
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
        let now = current_text(&target)?;
        if let Some(now) = &now
            && overwrite == Overwrite::No
            && self.on_disk.as_ref().map(String::as_bytes) != Some(now.as_slice())
        {
            return Err(match self.on_disk {
                Some(_) => SaveError::ChangedOnDisk(path),
                None => SaveError::Exists(path),
            });
        }
        let recreated = now.is_none() && self.on_disk.is_some();
        self.write(path, &target, project, rendered, recreated)
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
        let target = resolve(path)?;
        if current_text(&target)?.is_some() && overwrite == Overwrite::No {
            return Err(SaveError::Exists(path.to_path_buf()));
        }
        self.write(path.to_path_buf(), &target, project, rendered, false)
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

    fn write(
        &mut self,
        path: PathBuf,
        target: &Path,
        project: &Project,
        rendered: Rendered,
        recreated: bool,
    ) -> Result<SaveReport, SaveError> {
        let failed = |error| SaveError::Io { path: path.clone(), error };
        write_atomically(target, rendered.text.as_bytes()).map_err(failed)?;
        let report = SaveReport {
            path: path.clone(),
            comments_kept: rendered.comments_kept,
            migrated_from: self.migrated_from.take(),
            recreated,
        };
        // The text was read back before it was written, so this always succeeds.
        if let Ok(parsed) = load::parse_text(&rendered.text, "") {
            self.tree = parsed.tree;
        }
        self.path = Some(path);
        self.on_disk = Some(rendered.text.clone());
        self.text = rendered.text;
        self.base = project.clone();
        Ok(report)
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
    if current_text(&target)?.is_some() && overwrite == Overwrite::No {
        return Err(SaveError::Exists(path.to_path_buf()));
    }
    write_atomically(&target, text.as_bytes())
        .map_err(|error| SaveError::Io { path: path.to_path_buf(), error })
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

/// What stands in a file that is to be replaced; nothing if there is no file.
fn current_text(target: &Path) -> Result<Option<Vec<u8>>, SaveError> {
    match fs::metadata(target) {
        Ok(about) if !about.is_file() => return Err(SaveError::NotAFile(target.to_path_buf())),
        Ok(about) if about.permissions().readonly() => {
            return Err(SaveError::ReadOnly(target.to_path_buf()));
        }
        Ok(_) => {}
        Err(e) if e.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(SaveError::Io { path: target.to_path_buf(), error }),
    }
    match fs::read(target) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(SaveError::Io { path: target.to_path_buf(), error }),
    }
}

/// Puts bytes in the place of a file in one step, and on the disk.
pub(super) fn write_atomically(target: &Path, bytes: &[u8]) -> io::Result<()> {
    // A bare name has an empty parent, which no system call takes.
    let target = match target.parent() {
        Some(parent) if parent.as_os_str().is_empty() => Path::new(".").join(target),
        _ => target.to_path_buf(),
    };
    let mut file = OpenOptions::new().open(&target)?;
    file.write_all(bytes)?;
    // Brings the file to the disk, then renames it.
    file.commit()?;
    // The rename is on the disk once the directory is. Some file systems cannot do that; the new
    // text is in place all the same.
    if let Some(parent) = target.parent() {
        let _ = File::open(parent).and_then(|dir| dir.sync_all());
    }
    Ok(())
}
