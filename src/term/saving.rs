//! A save, as it is made by a thread that may be left to its disk: it touches nothing of the session's own.

use crate::app::message::SaveFailure;
use crate::job::adoption;
use crate::project::{
    Claimed, Document, Holder, Home, Overwrite, Project, SaveError, SaveReport, claim, same_file,
};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// A save that is wanted.
#[derive(Debug)]
pub(super) struct Wanted {
    pub(super) project: Arc<Project>,
    /// The file as it was asked for; none for the project's own.
    pub(super) asked: Option<PathBuf>,
    /// It, where that is not the project's own.
    pub(super) other: Option<PathBuf>,
    pub(super) overwrite: bool,
    pub(super) before: Arc<Document>,
    /// How the session stands to the project's own file.
    pub(super) claim: Arc<Claimed>,
    /// The claim of the other file, if it was taken over.
    pub(super) taken: Option<Claimed>,
    pub(super) home: Home,
}

/// A save that has ended.
#[derive(Debug)]
pub(super) struct Done {
    /// How the session stands to the file that is the project's own now, where that is otherwise than before.
    pub(super) claim: Option<Claimed>,
    pub(super) written: Result<(Document, SaveReport), SaveFailure>,
}

impl Wanted {
    /// Saves.
    pub(super) fn write(self) -> Done {
        let Wanted { project, asked, other, before, claim: own, taken, home, .. } = self;
        let claimed = match &other {
            // The project's own file under another name.
            Some(other) if before.path().is_some_and(|own| same_file(own, other)) => {
                Some(Claimed::Nowhere)
            }
            Some(other) => Some(taken.unwrap_or_else(|| claim(other, &home, false))),
            None => standing(&own, before.path(), &home, false),
        };
        let holder = claimed.as_ref().unwrap_or(&own).holder().cloned();
        let written = match holder {
            Some(holder) => Err(held_by(holder, asked.as_deref())),
            None => {
                let mut document = Document::clone(&before);
                let overwrite = if self.overwrite { Overwrite::Yes } else { Overwrite::No };
                match &other {
                    Some(path) => document.save_as(path, &project, overwrite),
                    None => document.save(&project, overwrite),
                }
                .map(|report| {
                    for file in before.path().into_iter().chain([report.path.as_path()]) {
                        adoption::forget(&project, file);
                    }
                    (document, report)
                })
                .map_err(|error| failure(&error, asked.as_deref()))
            }
        };
        // Another file that was not written to is none of ours.
        let claim = claimed.filter(|_| written.is_ok() || other.is_none());
        Done { claim, written }
    }
}

/// How a session stands to the project's file after it has tried to hold it, where it did not or does not
/// any more; none where nothing has changed. With `anyway` it takes the file over.
pub(super) fn standing(
    now: &Claimed,
    path: Option<&Path>,
    home: &Home,
    anyway: bool,
) -> Option<Claimed> {
    let lost = match now {
        Claimed::Mine(claim) if claim.holds() => return None,
        Claimed::Mine(claim) => claim.taken_by(),
        Claimed::Theirs(_) | Claimed::Silent => None,
        Claimed::Nowhere => return None,
    };
    Some(match (lost, path) {
        (Some(holder), _) if !anyway => Claimed::Theirs(holder),
        (_, Some(path)) => claim(path, home, anyway),
        (_, None) => Claimed::Nowhere,
    })
}

/// The failure of a save that was given up.
pub(super) fn unanswered(time: Duration, path: Option<&Path>) -> SaveFailure {
    SaveFailure {
        message: format!(
            "not known to be saved: no answer of the disk in {} s; :w PATH saves elsewhere",
            time.as_secs()
        ),
        overwrite_helps: false,
        holder: None,
        path: path.map(Path::to_path_buf),
    }
}

fn failure(error: &SaveError, path: Option<&Path>) -> SaveFailure {
    SaveFailure {
        message: match error {
            SaveError::NoPath => "no file yet; type :w PATH to save it".to_owned(),
            other => other.to_string(),
        },
        overwrite_helps: matches!(
            error,
            SaveError::ChangedOnDisk(_) | SaveError::Exists(_) | SaveError::Loses(..)
        ),
        holder: None,
        path: path.map(Path::to_path_buf),
    }
}

/// The failure of a save to a file that another session holds.
fn held_by(holder: Holder, path: Option<&Path>) -> SaveFailure {
    SaveFailure {
        message: format!("not saved: the file is held by {}", holder.text()),
        overwrite_helps: false,
        holder: Some(holder),
        path: path.map(Path::to_path_buf),
    }
}

/// What the user should know of a save that worked.
pub(super) fn note(report: &SaveReport) -> Option<String> {
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
    if let Some(why) = &report.unsure {
        notes.push(format!(
            "but the disk did not confirm it ({why}): it may be lost with the power"
        ));
    }
    (!notes.is_empty()).then(|| notes.join("; "))
}
