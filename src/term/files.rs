//! The project's file behind the interactive program: saving and the recovery file.

use super::program::Host;
use crate::app::message::{SaveFailure, Saved};
use crate::project::home::Home;
use crate::project::{Document, Overwrite, Project, SaveError, SaveReport};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};

/// One open project file.
pub struct FileHost {
    /// The document that saves; held while a save runs.
    document: Mutex<Document>,
    /// A copy of it for the recovery file, held for a moment only: the panic hook and the signal
    /// thread must never wait for a save.
    shadow: Mutex<Document>,
    home: Home,
}

impl FileHost {
    /// The host of an open document.
    pub fn new(document: Document, home: Home) -> FileHost {
        FileHost { shadow: Mutex::new(document.clone()), document: Mutex::new(document), home }
    }
}

/// The value, also after a panic elsewhere: documents change in one step, never half.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

impl Host for FileHost {
    fn save(
        &self,
        project: &Arc<Project>,
        path: Option<&Path>,
        overwrite: bool,
    ) -> Result<Saved, SaveFailure> {
        let mut document = lock(&self.document);
        let how = if overwrite { Overwrite::Yes } else { Overwrite::No };
        let before = document.clone();
        let result = match path {
            Some(path) => document.save_as(path, project, how),
            None => document.save(project, how),
        };
        match result {
            Ok(report) => {
                // What was kept of the old file is saved now, under whichever name.
                before.discard_recovery(&self.home);
                *lock(&self.shadow) = document.clone();
                // Not being able to remember the file is no reason to call the save a failure.
                let _ = self.home.remember(&report.path);
                Ok(Saved { project: project.clone(), note: note(&report), path: report.path })
            }
            Err(error) => Err(SaveFailure {
                overwrite_helps: matches!(
                    error,
                    SaveError::ChangedOnDisk(_) | SaveError::Exists(_)
                ),
                path: path.map(Path::to_path_buf),
                message: match error {
                    SaveError::NoPath => "no file yet; type :w PATH to save it".to_string(),
                    other => other.to_string(),
                },
            }),
        }
    }

    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        let document = lock(&self.shadow).clone();
        document.keep(project, &self.home).map_err(|e| e.to_string())
    }

    fn forget_recovery(&self) -> Result<(), String> {
        let document = lock(&self.shadow).clone();
        document.discard_recovery(&self.home);
        Ok(())
    }
}

/// What the user should know of a save.
fn note(report: &SaveReport) -> Option<String> {
    let mut parts = Vec::new();
    if !report.comments_kept {
        parts.push("the comments in it could not be kept".to_string());
    }
    if let Some(version) = report.migrated_from {
        parts.push(format!("brought from format {version} to the current one"));
    }
    if report.recreated {
        parts.push("it had been deleted and was made again".to_string());
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}
