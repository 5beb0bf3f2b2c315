//! The real outside world: the project's file, its recovery file, the list of recent projects.

use super::program::Host;
use crate::app::message::{SaveFailure, Saved};
use crate::app::settings::Settings;
use crate::project::{Document, Home, Overwrite, Project, SaveError, SaveReport};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The files of one open project.
#[derive(Debug)]
pub struct FileHost {
    home: Home,
    document: Mutex<Arc<Document>>,
}

impl FileHost {
    /// For a project that was just opened.
    pub fn new(document: Document, home: Home) -> FileHost {
        FileHost { home, document: Mutex::new(Arc::new(document)) }
    }

    /// The lock is only held to copy or replace a pointer: nobody waits for a disk behind it.
    fn slot(&self) -> MutexGuard<'_, Arc<Document>> {
        self.document.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn document(&self) -> Arc<Document> {
        Arc::clone(&self.slot())
    }
}

impl Host for FileHost {
    /// Saves, drops recovery files that the save made pointless, and remembers the project for the
    /// next start.
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
            Some(path) => document.save_as(path, project, overwrite),
            None => document.save(project, overwrite),
        };
        let report = result.map_err(|error| failure(&error, path))?;
        before.discard_recovery(&self.home);
        document.discard_recovery(&self.home);
        *self.slot() = Arc::new(document);
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

    fn keep_settings(&self, settings: &Settings) -> Result<Option<String>, String> {
        super::preferences::keep(&self.home, settings)
    }
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
