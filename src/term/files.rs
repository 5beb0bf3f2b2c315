//! The real outside world: the project's file, its recovery file, the list of recent projects.

use super::exports::{self, ExportWanted};
use super::found;
use super::program::Host;
use super::saving::{self, Wanted};
use crate::app::message::{
    Exported, FoundProject, KeptEdits, Message, OpenFailure, OpenedProject, SaveFailure, Saved,
};
use crate::app::saving::READS_ONLY;
use crate::app::settings::{SettingItem, Settings};
use crate::mesh::MeshType;
use crate::project::home::typed_path;
use crate::project::method_files;
use crate::project::schema::MethodFile;
use crate::project::{
    self, Claimed, Document, FileStamp, Holder, Home, MOMENT, Opened, OwnRecovery, Project,
    Recovery, claim_in_time, in_time, put_away, same_file, time_text,
};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, SystemTime};

/// How long a disk may take for something; one that takes longer is left to itself.
#[derive(Debug, Clone, Copy)]
struct Patience {
    /// For a save. Much longer than for a look: one that is given up may still come to pass.
    saving: Duration,
    /// To say who holds a file and whether it has changed.
    looking: Duration,
    /// For the recovery file; then it goes to the data directory.
    keeping: Duration,
    /// At the end of the session.
    leaving: Duration,
}

impl Default for Patience {
    fn default() -> Patience {
        let [saving, looking, keeping, leaving] = [30, 10, 5, 2].map(Duration::from_secs);
        Patience { saving, looking, keeping, leaving }
    }
}

/// Why nothing is known of a file.
const NO_ANSWER: &str = "the disk does not answer";
/// How a recovery file is written.
type Keeps = fn(&Document, &Project, &Home, &mut Option<OwnRecovery>) -> io::Result<PathBuf>;
/// A recovery file, shared with whoever writes it.
type Keep = Arc<Mutex<Option<OwnRecovery>>>;

/// The files of one open project. Every lock is only held to look at or replace what is behind it, but for
/// [`saving`](FileHost::saving), which the loop does not take, and those of recovery files while these are
/// written, which nobody waits for without end.
#[derive(Debug)]
pub struct FileHost {
    home: Home,
    document: Mutex<Arc<Document>>,
    /// How this session stands to the project's file.
    claim: Mutex<Arc<Claimed>>,
    /// Another file that was taken over to be saved to.
    taken: Mutex<Option<(PathBuf, Claimed)>>,
    /// This session's recovery file.
    own: Mutex<Keep>,
    /// Another one in the data directory, where the disk of the first does not answer.
    apart: Keep,
    /// What a lost session kept, while the user is asked about it.
    offered: Mutex<Option<Recovery>>,
    /// What was opened last and has not taken over.
    next: Mutex<Option<Next>>,
    /// Held by whoever changes how this session stands to the file, so that nobody takes a change of its
    /// own for another's.
    saving: Arc<Mutex<()>>,
    watched: Mutex<Watched>,
    /// Shared with a look that has not come back: there is no point in another one.
    looking: Arc<()>,
    patience: Patience,
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
        FileHost::with(document, home, Patience::default())
    }

    fn with(document: Document, home: Home, patience: Patience) -> (FileHost, Beginning) {
        let claim = document
            .path()
            .map_or(Claimed::Nowhere, |path| claim_in_time(path, &home, false, patience.looking));
        let (offered, beginning) = begin(&document, &home, &claim);
        let host = FileHost {
            home,
            document: Mutex::new(Arc::new(document)),
            claim: Mutex::new(Arc::new(claim)),
            taken: Mutex::default(),
            own: Mutex::default(),
            apart: Keep::default(),
            offered: Mutex::new(offered),
            next: Mutex::default(),
            saving: Arc::default(),
            watched: Mutex::default(),
            looking: Arc::default(),
            patience,
        };
        (host, beginning)
    }

    fn document(&self) -> Arc<Document> {
        Arc::clone(&lock(&self.document))
    }

    fn claim(&self) -> Arc<Claimed> {
        Arc::clone(&lock(&self.claim))
    }

    /// How this session stands to the project's file from now on.
    fn stand(&self, claim: Claimed) {
        put_away(std::mem::replace(&mut *lock(&self.claim), Arc::new(claim)));
    }

    /// The claim of another file that was taken over to save the project to it.
    fn taken(&self, path: &Path) -> Option<Claimed> {
        lock(&self.taken).take().filter(|(taken, _)| taken == path).map(|(_, claimed)| claimed)
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
        let typed = path.map(typed_path);
        let other = typed.filter(|typed| Some(typed.as_path()) != before.path());
        let wanted = Wanted {
            project: Arc::clone(project),
            asked: path.map(Path::to_path_buf),
            claim: self.claim(),
            taken: other.as_deref().and_then(|other| self.taken(other)),
            home: self.home.clone(),
            before: Arc::clone(&before),
            other,
            overwrite,
        };
        let Some(done) = in_time(self.patience.saving, move || wanted.write()) else {
            return Err(saving::unanswered(self.patience.saving, path));
        };
        if let Some(claim) = done.claim {
            self.stand(claim);
        }
        let (document, report) = done.written?;
        let moved = before.path() != document.path();
        *lock(&self.document) = Arc::new(document);
        if moved {
            let _ = self.forget_recovery();
        }
        // Not to be found at the next start is no reason to call the save failed.
        let _ = self.home.remember(&report.path);
        let note = saving::note(&report);
        Ok(Saved { project: Arc::clone(project), path: report.path, note })
    }

    fn take_file(&self, path: Option<&Path>) -> Option<Holder> {
        let _saving = lock(&self.saving);
        match path.map(typed_path) {
            Some(path) => {
                let claimed = claim_in_time(&path, &self.home, true, self.patience.looking);
                *lock(&self.taken) = Some((path, claimed));
            }
            None => {
                let (document, claim, home) = (self.document(), self.claim(), self.home.clone());
                let work = move || saving::standing(&claim, document.path(), &home, true);
                if let Some(Some(claim)) = in_time(self.patience.looking, work) {
                    self.stand(claim);
                }
            }
        }
        self.claim().holder().cloned()
    }

    /// Whoever finds the recovery file being written writes another one: that may be a thread that will
    /// not go on.
    fn recover(&self, project: &Project) -> Result<PathBuf, String> {
        let document = self.document();
        let own = Arc::clone(&lock(&self.own));
        let works =
            [(own, Document::keep as Keeps), (Arc::clone(&self.apart), Document::keep_apart)];
        let mut why = NO_ANSWER.to_owned();
        for (own, keep) in works {
            let (document, project, home) =
                (Arc::clone(&document), project.clone(), self.home.clone());
            let kept = in_time(self.patience.keeping, move || {
                let mut own = match own.try_lock() {
                    Ok(own) => own,
                    Err(TryLockError::Poisoned(own)) => own.into_inner(),
                    Err(TryLockError::WouldBlock) => return None,
                };
                Some(keep(&document, &project, &home, &mut own))
            });
            match kept.flatten() {
                Some(Ok(path)) => return Ok(path),
                Some(Err(error)) => why = error.to_string(),
                None => {}
            }
        }
        Err(why)
    }

    fn forget_recovery(&self) -> Result<(), String> {
        let all = [std::mem::take(&mut *lock(&self.own)), Arc::clone(&self.apart)];
        all.map(|own| discard(own, self.patience.keeping)).into_iter().collect()
    }

    fn recovery_stands(&self) -> bool {
        let own = Arc::clone(&lock(&self.own));
        match own.try_lock() {
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
        let own = OwnRecovery::adopt(kept, &document);
        *lock(&self.own) = Arc::new(Mutex::new(Some(own)));
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
            let holder = self.claim().holder().cloned();
            (None, None, Beginning { kept: None, holder, note: migrated(&document) })
        } else {
            let claim = claim_in_time(path, &self.home, false, self.patience.looking);
            let (offered, beginning) = begin(&document, &self.home, &claim);
            (Some(claim), offered, beginning)
        };
        *lock(&self.next) = Some(Next { document, claim, offered });
        let Beginning { kept, holder, note } = beginning;
        let (project, path) = (Arc::new(project), path.clone());
        Ok(OpenedProject { project, path, note, kept, holder })
    }

    fn read_method(&self, path: &Path, of: &Path) -> Result<MethodFile, String> {
        method_files::name(&typed_path(path), of)
    }

    fn take_over(&self) {
        if let Some(next) = lock(&self.next).take() {
            let _ = discard(std::mem::take(&mut *lock(&self.own)), MOMENT);
            let _ = discard(Arc::clone(&self.apart), MOMENT);
            *lock(&self.document) = Arc::new(next.document);
            *lock(&self.offered) = next.offered;
            if let Some(claim) = next.claim {
                self.stand(claim);
            }
        }
    }

    fn let_go(&self) {
        put_away(lock(&self.next).take());
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

    fn keep_mesh(&self, mesh: &Arc<MeshType>) -> Result<String, String> {
        let file = self.home.keep_own_mesh(mesh)?;
        Ok(format!("{} is in your own catalogue too: {}", mesh.id, file.display()))
    }

    fn tidy(&self) {
        self.home.sweep();
        if let Some(path) = self.document().path() {
            project::sweep_beside(path);
        }
    }

    fn watch(&self) -> Vec<Message> {
        let Ok(_saving) = self.saving.try_lock() else { return Vec::new() };
        if Arc::strong_count(&self.looking) > 1 {
            return Vec::new();
        }
        let (document, claim, home) = (self.document(), self.claim(), self.home.clone());
        let (former, seen) = (lock(&self.watched).stamp, Arc::clone(&self.looking));
        let before = claim.holder().cloned();
        let look = move || {
            let now = saving::standing(&claim, document.path(), &home, false);
            let stamp = document.path().and_then(FileStamp::of);
            let changed = (stamp != former).then(|| document.changed_on_disk());
            drop(seen);
            (now, stamp, changed)
        };
        let Some((now, stamp, changed)) = in_time(self.patience.looking, look) else {
            return Vec::new();
        };
        let mut news = Vec::new();
        if let Some(now) = now {
            let holder = now.holder().cloned();
            self.stand(now);
            if holder != before {
                news.push(Message::Held(holder));
            }
        }
        if let Some(changed) = changed {
            let mut watched = lock(&self.watched);
            if changed || watched.changed {
                news.push(Message::ChangedOnDisk(changed));
            }
            *watched = Watched { stamp, changed };
        }
        news
    }

    fn leave(&self) {
        let claim = std::mem::replace(&mut *lock(&self.claim), Arc::new(Claimed::Nowhere));
        let others =
            (lock(&self.next).take(), lock(&self.taken).take(), lock(&self.offered).take());
        let saving = Arc::clone(&self.saving);
        in_time(self.patience.leaving, move || {
            // Whoever is looking has the claim as well.
            let _saving = lock(&saving);
            drop((claim, others));
        });
    }
}

/// Throws a recovery file away, or leaves that to its disk.
fn discard(own: Keep, time: Duration) -> Result<(), String> {
    let discarded = in_time(time, move || {
        if let Some(own) = lock(&own).take() {
            own.discard();
        }
    });
    discarded.ok_or_else(|| NO_ANSWER.to_owned())
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

#[cfg(test)]
#[path = "files_tests.rs"]
mod tests;
