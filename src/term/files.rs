//! The real outside world: the project's file, its recovery file, the list of recent projects.

use super::exports::{self, ExportWanted};
use super::found;
use super::program::Host;
use crate::app::message::{Exported, FoundProject, OpenFailure, OpenedProject, SaveFailure, Saved};
use crate::app::settings::Settings;
use crate::project::home::typed_path;
use crate::project::{self, Document, Home, Opened, Overwrite, Project, SaveError, SaveReport};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The files of one open project.
#[derive(Debug)]
pub struct FileHost {
    home: Home,
    document: Mutex<Arc<Document>>,
    /// What was opened last and has not taken over.
    next: Mutex<Option<Arc<Document>>>,
}

impl FileHost {
    /// For a project that was just opened.
    pub(crate) fn new(document: Document, home: Home) -> FileHost {
        FileHost { home, document: Mutex::new(Arc::new(document)), next: Mutex::default() }
    }

    /// The lock is only held to copy or replace a pointer: nobody waits for a disk behind it.
    fn slot(&self) -> MutexGuard<'_, Arc<Document>> {
        self.document.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn next(&self) -> MutexGuard<'_, Option<Arc<Document>>> {
        self.next.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn document(&self) -> Arc<Document> {
        Arc::clone(&self.slot())
    }
}

impl Host for FileHost {
    /// Saves, and remembers the project for the next start. A project that goes on with another file
    /// leaves no recovery file with the former one.
    fn save(
        &self,
        project: &Arc<Project>,
        path: Option<&Path>,
        overwrite: bool,
    ) -> Result<Saved, SaveFailure> {
        let before = self.document();
        let mut document = Document::clone(&before);
        let overwrite = if overwrite { Overwrite::Yes } else { Overwrite::No };
        let result = match path {
            Some(path) => document.save_as(&typed_path(path), project, overwrite),
            None => document.save(project, overwrite),
        };
        let report = result.map_err(|error| failure(&error, path))?;
        let moved = before.path() != document.path();
        *self.slot() = Arc::new(document);
        if moved {
            before.discard_recovery(&self.home);
        }
        // Not to be found at the next start is no reason to call the save failed.
        let _ = self.home.remember(&report.path);
        let note = note(&report);
        Ok(Saved { project: Arc::clone(project), path: report.path, note })
    }

    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        self.document().keep(project, &self.home).map_err(|error| error.to_string())
    }

    fn forget_recovery(&self) -> Result<(), String> {
        self.document().discard_recovery(&self.home);
        Ok(())
    }

    fn list(&self) -> Vec<FoundProject> {
        let document = self.document();
        let folder = document.path().and_then(Path::parent);
        let folder = folder.filter(|dir| !dir.as_os_str().is_empty());
        // A working directory that is gone leaves the project's own folder.
        let near = [std::env::current_dir().ok(), folder.map(Path::to_path_buf)];
        found::list(&self.home, document.path(), &near.into_iter().flatten().collect::<Vec<_>>())
    }

    fn open(&self, path: &Path) -> Result<OpenedProject, OpenFailure> {
        let path = &typed_path(path);
        let opened = project::load(path).map_err(|e| OpenFailure { message: e.to_string() })?;
        let Opened { document, project } = opened;
        let _ = self.home.remember(path);
        // The present project itself: its recovery file holds edits of this session, which are let go.
        let again = self.document().path().is_some_and(|own| project::same_file(own, path));
        let (kept, note) = if again { (None, None) } else { kept(&document, &self.home) };
        let note = note.or_else(|| migrated(&document));
        *self.next() = Some(Arc::new(document));
        Ok(OpenedProject { project: Arc::new(project), path: path.clone(), note, kept })
    }

    fn take_over(&self) {
        if let Some(next) = self.next().take() {
            self.document().discard_recovery(&self.home);
            *self.slot() = next;
        }
    }

    fn export(&self, wanted: ExportWanted<'_>) -> Result<Exported, String> {
        exports::write(&self.document(), wanted)
    }

    fn keep_settings(&self, settings: &Settings) -> Result<Option<String>, String> {
        super::preferences::keep(&self.home, settings)
    }
}

/// Edits of a project kept from a session that was cut off, or what is to be said of them.
pub(crate) fn kept(document: &Document, home: &Home) -> (Option<Arc<Project>>, Option<String>) {
    let Some(kept) = document.find_recovery(home) else { return (None, None) };
    match document.recover(&kept) {
        Ok(project) => (Some(Arc::new(project)), None),
        Err(_) => {
            let path = kept.path.display();
            (None, Some(format!("edits kept from a lost session cannot be read: {path}")))
        }
    }
}

/// What to say of a file in an older format.
pub(crate) fn migrated(document: &Document) -> Option<String> {
    document.migrated_from().map(|version| {
        format!("the file has the older format {version}; saving brings it up to date")
    })
}

fn failure(error: &SaveError, path: Option<&Path>) -> SaveFailure {
    SaveFailure {
        message: match error {
            SaveError::NoPath => "no file yet; type :w PATH to save it".to_owned(),
            other => other.to_string(),
        },
        overwrite_helps: matches!(error, SaveError::ChangedOnDisk(_) | SaveError::Exists(_)),
        path: path.map(Path::to_path_buf),
    }
}

/// What the user should know of a save that worked.
fn note(report: &SaveReport) -> Option<String> {
    let mut notes = Vec::new();
    if !report.comments_kept {
        notes.push("the comments in it could not be kept".to_owned());
    }
    if let Some(version) = report.migrated_from {
        notes.push(format!("brought from format {version} to the current one"));
    }
    if report.recreated {
        notes.push("it had been deleted and was made again".to_owned());
    }
    (!notes.is_empty()).then(|| notes.join("; "))
}

#[cfg(test)]
#[path = "files_tests.rs"]
mod tests;
