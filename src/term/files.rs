//! The real outside world: the project's file, its recovery file, the list of recent projects.

use super::exports::{self, ExportWanted};
use super::found;
use super::program::Host;
use crate::app::message::{
    Exported, FoundProject, KeptEdits, Message, OpenFailure, OpenedProject, SaveFailure, Saved,
};
use crate::app::saving::READS_ONLY;
use crate::app::settings::{SettingItem, Settings};
use crate::job::adoption;
use crate::project::home::typed_path;
use crate::project::{
    self, Claimed, Document, FileStamp, Holder, Home, Opened, Overwrite, OwnRecovery, Project,
    Recovery, SaveError, SaveReport, claim, same_file, time_text,
};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::SystemTime;

/// The files of one open project. Every lock is only held to look at or replace what is behind it,
/// but for [`own`](FileHost::own), which is held while the recovery file is written.
#[derive(Debug)]
pub struct FileHost {
    home: Home,
    document: Mutex<Arc<Document>>,
    /// How this session stands to the project's file.
    claim: Mutex<Claimed>,
    /// Another file that was taken over to be saved to.
    taken: Mutex<Option<(PathBuf, Claimed)>>,
    /// This session's recovery file.
    own: Mutex<Option<OwnRecovery>>,
    /// What a lost session kept, while the user is asked about it.
    offered: Mutex<Option<Recovery>>,
    /// What was opened last and has not taken over.
    next: Mutex<Option<Next>>,
    /// Held by a save, so that nobody takes its own change of the file for another's.
    saving: Mutex<()>,
    watched: Mutex<Watched>,
}

/// A project that may take the place of the present one.
#[derive(Debug)]
struct Next {
    document: Document,
    /// None where it is the present file read anew.
    claim: Option<Claimed>,
    offered: Option<Recovery>,
}

/// What the watch saw last.
#[derive(Debug, Default)]
struct Watched {
    stamp: Option<FileStamp>,
    changed: bool,
}

/// What is to be known of a project at its start.
#[derive(Debug)]
pub(crate) struct Beginning {
    /// Edits kept from a session that was cut off.
    pub(crate) kept: Option<KeptEdits>,
    /// Who else holds the file.
    pub(crate) holder: Option<Holder>,
    /// What is to be said.
    pub(crate) note: Option<String>,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl FileHost {
    /// For a project that was just opened: its file is claimed, if nobody else holds it.
    pub(crate) fn new(document: Document, home: Home) -> (FileHost, Beginning) {
        let claim = document.path().map_or(Claimed::Nowhere, |path| claim(path, &home, false));
        let (offered, beginning) = begin(&document, &home, &claim);
        let host = FileHost {
            home,
            document: Mutex::new(Arc::new(document)),
            claim: Mutex::new(claim),
            taken: Mutex::default(),
            own: Mutex::default(),
            offered: Mutex::new(offered),
            next: Mutex::default(),
            saving: Mutex::default(),
            watched: Mutex::default(),
        };
        (host, beginning)
    }

    fn document(&self) -> Arc<Document> {
        Arc::clone(&lock(&self.document))
    }

    /// Who holds the project's file after this session has tried to, where it did not hold it or lost it.
    /// With `anyway` it takes the file over.
    fn hold(&self, anyway: bool) -> Option<Holder> {
        let document = self.document();
        let mut mine = lock(&self.claim);
        let lost = match &*mine {
            Claimed::Mine(claim) if claim.holds() => return None,
            Claimed::Mine(claim) => claim.taken_by(),
            Claimed::Theirs(_) => None,
            Claimed::Nowhere => return None,
        };
        *mine = match (lost, document.path()) {
            (Some(holder), _) if !anyway => Claimed::Theirs(holder),
            (_, Some(path)) => claim(path, &self.home, anyway),
            (_, None) => Claimed::Nowhere,
        };
        mine.holder().cloned()
    }

    /// The claim of another file, to which the project is to be saved.
    fn claim_other(&self, path: &Path) -> Claimed {
        match lock(&self.taken).take() {
            Some((taken, claimed)) if taken == path => claimed,
            _ => claim(path, &self.home, false),
        }
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
        let _saving = lock(&self.saving);
        let before = self.document();
        let mut document = Document::clone(&before);
        let overwrite = if overwrite { Overwrite::Yes } else { Overwrite::No };
        let typed = path.map(typed_path);
        let other = typed.as_deref().filter(|typed| Some(*typed) != before.path());
        let claimed =
            other.map(|other| match before.path().is_some_and(|own| same_file(own, other)) {
                true => Claimed::Nowhere,
                false => self.claim_other(other),
            });
        let holder = match &claimed {
            Some(claimed) => claimed.holder().cloned(),
            None => self.hold(false),
        };
        if let Some(holder) = holder {
            return Err(held_by(holder, path));
        }
        let result = match &typed {
            Some(path) => document.save_as(path, project, overwrite),
            None => document.save(project, overwrite),
        };
        let report = result.map_err(|error| failure(&error, path))?;
        for file in before.path().into_iter().chain([report.path.as_path()]) {
            adoption::forget(project, file);
        }
        let moved = before.path() != document.path();
        *lock(&self.document) = Arc::new(document);
        if let Some(claimed) = claimed {
            *lock(&self.claim) = claimed;
        }
        if moved && let Some(own) = lock(&self.own).take() {
            own.discard();
        }
        // Not to be found at the next start is no reason to call the save failed.
        let _ = self.home.remember(&report.path);
        let note = note(&report);
        Ok(Saved { project: Arc::clone(project), path: report.path, note })
    }

    fn take_file(&self, path: Option<&Path>) -> Option<Holder> {
        let Some(path) = path.map(typed_path) else { return self.hold(true) };
        let claimed = claim(&path, &self.home, true);
        *lock(&self.taken) = Some((path, claimed));
        lock(&self.claim).holder().cloned()
    }

    /// Whoever finds the recovery file being written writes another one: that may be a thread that will
    /// not go on.
    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        let document = self.document();
        match self.own.try_lock() {
            Ok(mut own) => document.keep(project, &self.home, &mut own),
            Err(TryLockError::Poisoned(own)) => {
                document.keep(project, &self.home, &mut own.into_inner())
            }
            Err(TryLockError::WouldBlock) => document.keep(project, &self.home, &mut None),
        }
        .map_err(|error| error.to_string())
    }

    fn forget_recovery(&self) -> Result<(), String> {
        if let Some(own) = lock(&self.own).take() {
            own.discard();
        }
        Ok(())
    }

    fn recovery_stands(&self) -> bool {
        match self.own.try_lock() {
            Ok(own) => own.as_ref().is_none_or(OwnRecovery::stands),
            Err(_) => true,
        }
    }

    fn take_kept(&self) {
        let Some(kept) = lock(&self.offered).take() else { return };
        let mut document = lock(&self.document);
        if kept.overtaken(&document).is_some() {
            let mut behind = Document::clone(&document);
            behind.falls_behind();
            *document = Arc::new(behind);
        }
        *lock(&self.own) = Some(OwnRecovery::adopt(kept, &document));
    }

    fn drop_kept(&self) -> Option<KeptEdits> {
        let mut offered = lock(&self.offered);
        offered.take()?.discard();
        let (recovery, kept) = offer(&self.document(), &self.home).0?;
        *offered = Some(recovery);
        Some(kept)
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
        let again = self.document().path().is_some_and(|own| same_file(own, path));
        let (claim, offered, beginning) = if again {
            let holder = lock(&self.claim).holder().cloned();
            (None, None, Beginning { kept: None, holder, note: migrated(&document) })
        } else {
            let claim = claim(path, &self.home, false);
            let (offered, beginning) = begin(&document, &self.home, &claim);
            (Some(claim), offered, beginning)
        };
        *lock(&self.next) = Some(Next { document, claim, offered });
        let Beginning { kept, holder, note } = beginning;
        let (project, path) = (Arc::new(project), path.clone());
        Ok(OpenedProject { project, path, note, kept, holder })
    }

    fn take_over(&self) {
        if let Some(next) = lock(&self.next).take() {
            let _ = self.forget_recovery();
            *lock(&self.document) = Arc::new(next.document);
            *lock(&self.offered) = next.offered;
            if let Some(claim) = next.claim {
                *lock(&self.claim) = claim;
            }
        }
    }

    fn let_go(&self) {
        lock(&self.next).take();
    }

    fn export(&self, wanted: ExportWanted<'_>) -> Result<Exported, String> {
        exports::write(&self.document(), wanted)
    }

    fn keep_settings(
        &self,
        changed: SettingItem,
        settings: &Settings,
    ) -> Result<Option<String>, String> {
        super::preferences::keep(&self.home, changed, settings)
    }

    fn tidy(&self) {
        self.home.sweep();
        if let Some(path) = self.document().path() {
            project::sweep_beside(path);
        }
    }

    fn watch(&self) -> Vec<Message> {
        let Ok(_saving) = self.saving.try_lock() else { return Vec::new() };
        let mut news = Vec::new();
        let before = lock(&self.claim).holder().cloned();
        let holder = self.hold(false);
        if holder != before {
            news.push(Message::Held(holder));
        }
        let document = self.document();
        let mut watched = lock(&self.watched);
        let stamp = document.path().and_then(FileStamp::of);
        if stamp != watched.stamp {
            let changed = document.changed_on_disk();
            if changed || watched.changed {
                news.push(Message::ChangedOnDisk(changed));
            }
            *watched = Watched { stamp, changed };
        }
        news
    }

    fn leave(&self) {
        self.let_go();
        lock(&self.taken).take();
        lock(&self.offered).take();
        *lock(&self.claim) = Claimed::Nowhere;
    }
}

/// What is to be known of a project that was opened, and what a lost session kept of it.
fn begin(document: &Document, home: &Home, claim: &Claimed) -> (Option<Recovery>, Beginning) {
    let holder = claim.holder().cloned();
    let held = holder.as_ref().map(|holder| format!("held by {}; {READS_ONLY}", holder.text()));
    let (found, unreadable) = offer(document, home);
    let (offered, kept) = found.unzip();
    let unreadable = unreadable
        .map(|path| format!("edits kept from a lost session cannot be read: {}", path.display()));
    let doubt = || claim.doubt().map(str::to_owned);
    let note = held.or(unreadable).or_else(|| migrated(document)).or_else(doubt);
    (offered, Beginning { kept, holder, note })
}

/// The newest edits that a lost session kept and that can be read; one passed over on the way to them,
/// which cannot.
fn offer(document: &Document, home: &Home) -> (Option<(Recovery, KeptEdits)>, Option<PathBuf>) {
    // Not found again as long as they are there, but by a disk without locks.
    let mut unreadable: Vec<Recovery> = Vec::new();
    let mut found = None;
    while let Some(kept) = document.find_recovery(home) {
        if let Ok(project) = document.recover(&kept) {
            let about = about(document, &kept, &project);
            found = Some((kept, KeptEdits { about, project: Arc::new(project) }));
            break;
        }
        if unreadable.iter().any(|other| other.path == kept.path) {
            break;
        }
        unreadable.push(kept);
    }
    (found, unreadable.into_iter().next().map(|kept| kept.path))
}

/// Of kept edits: when they were made and the file was, and what differs.
fn about(document: &Document, kept: &Recovery, project: &Project) -> Vec<String> {
    let mut about = Vec::new();
    let time = |time: Option<SystemTime>| time.map_or("an unknown time".to_owned(), time_text);
    match kept.overtaken(document) {
        Some(file) => about.push(format!(
            "They are of {}, OLDER than the file, which is of {}: something else has changed it since.",
            time(kept.written),
            time_text(file)
        )),
        None => about.push(format!("They are of {}, newer than the file.", time(kept.written))),
    }
    let differs = project::difference(document.base(), project);
    if !differs.is_empty() {
        about.push("What they change in the file:".to_owned());
        about.extend(differs.into_iter().map(|line| format!("  {line}")));
    }
    about
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
    if let Some(why) = &report.unsure {
        notes.push(format!(
            "but the disk did not confirm it ({why}): it may be lost with the power"
        ));
    }
    (!notes.is_empty()).then(|| notes.join("; "))
}

#[cfg(test)]
#[path = "files_tests.rs"]
mod tests;
