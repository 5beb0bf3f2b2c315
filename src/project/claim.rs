//! Who holds a project file. The session that opens a file first holds it and may save it; the next ones
//! are told who that is, and only read until they take the file over.
//!
//! A claim is a small file `.road-cut.ron.lock` beside the project (or in the data directory, where
//! that directory cannot be written) that says who, where and since when. It is locked as long as its
//! session lives, so that one left by a session that was killed is worth nothing. Taking over puts
//! another claim in its place, which the former holder notices before it saves. A disk that keeps no
//! locks leaves what the claim says: on this machine it can be seen whether the program still runs,
//! and on another one it cannot, which is said.

use super::disk;
use super::draft::{Draft, Place, Placed};
use super::home::{Home, known};
use super::in_time::in_time;
use super::load;
use super::recovery::name_of_path;
use super::save::resolve;
use super::time::time_text;
use serde::{Deserialize, Serialize};
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Who holds a project file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Holder {
    /// The user.
    pub name: String,
    /// The machine.
    pub host: String,
    /// The process there.
    pid: u32,
    /// Since when, in seconds since 1970.
    since: u64,
    /// Whether the disk says so; else nothing is known but that a claim was left.
    #[serde(skip, default = "sure")]
    pub sure: bool,
}

fn sure() -> bool {
    true
}

impl Holder {
    /// A holder, of now.
    pub fn new(name: &str, host: &str) -> Holder {
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
        let (name, host) = (name.to_owned(), host.to_owned());
        Holder { name, host, pid: std::process::id(), since: now.as_secs(), sure: true }
    }

    fn this() -> Holder {
        let (name, host) = disk::user_and_host();
        Holder::new(&name, &host)
    }

    /// Who, where and since when, for people: `anna on basalt since 2026-11-27 08:30 UTC`.
    pub fn text(&self) -> String {
        let since = time_text(SystemTime::UNIX_EPOCH + Duration::from_secs(self.since));
        // Whatever stands in the file, it goes to a screen.
        let clean =
            |text: &str| -> String { text.chars().filter(|c| !c.is_control()).take(40).collect() };
        let text = format!("{} on {} since {since}", clean(&self.name), clean(&self.host));
        match self.sure {
            true => text,
            false => format!("{text}, who may be gone: this disk keeps no locks"),
        }
    }

    /// Whether it may still be there, as far as that can be told without locks.
    fn may_live(&self) -> bool {
        let here = Holder::this();
        self.host != here.host || disk::runs(self.pid)
    }
}

/// The claim of this session.
#[derive(Debug)]
pub struct Claim {
    path: PathBuf,
    file: File,
    /// Whether the disk keeps locks: else nobody can tell whether its session still lives.
    locked: bool,
}

/// How this session stands to a file.
#[derive(Debug)]
pub enum Claimed {
    /// It holds the file.
    Mine(Claim),
    /// Another one does.
    Theirs(Holder),
    /// There is no place for a claim, so nobody can tell.
    Nowhere,
    /// The disk has not answered.
    Silent,
}

impl Claimed {
    /// Who else holds the file.
    pub(crate) fn holder(&self) -> Option<&Holder> {
        match self {
            Claimed::Theirs(holder) => Some(holder),
            Claimed::Mine(_) | Claimed::Nowhere | Claimed::Silent => None,
        }
    }

    /// What to tell of a file that is held, but not by a lock. Who comes second is told of this session by
    /// [`Holder::text`], with its doubt.
    pub(crate) fn doubt(&self) -> Option<&'static str> {
        match self {
            Claimed::Mine(Claim { locked: false, .. }) => Some(
                "this disk keeps no locks, as some network drives: nobody is kept from saving the same \
                 file, so edit it in one place at a time",
            ),
            Claimed::Silent => {
                Some("the disk has not said whether another session holds the file: is it away?")
            }
            Claimed::Mine(_) | Claimed::Theirs(_) | Claimed::Nowhere => None,
        }
    }
}

impl Claim {
    /// Whether nobody has taken the file over.
    pub(crate) fn holds(&self) -> bool {
        disk::same_place(&self.file, &self.path)
    }

    /// Who has taken it over; nobody where the claim has only gone.
    pub(crate) fn taken_by(&self) -> Option<Holder> {
        if self.holds() { None } else { read(&self.path) }
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        // While it is locked nobody else can take it as left.
        if self.holds() {
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// [`claim`] on a disk that has so long to answer.
pub(crate) fn claim_in_time(project: &Path, home: &Home, anyway: bool, time: Duration) -> Claimed {
    let (project, home) = (project.to_path_buf(), home.clone());
    in_time(time, move || claim(&project, &home, anyway)).unwrap_or(Claimed::Silent)
}

/// Claims a file for this session. With `anyway` it is taken over from whoever holds it.
pub fn claim(project: &Path, home: &Home, anyway: bool) -> Claimed {
    let file = resolve(project).unwrap_or_else(|_| project.to_path_buf());
    for place in places(&file, home) {
        if let Some(parent) = place.parent().filter(|_| home.owns(&place)) {
            // Fails with the claim, and then there is none.
            let _ = fs::create_dir_all(parent);
        }
        if let Ok(claimed) = claim_at(&place, anyway) {
            return claimed;
        }
    }
    Claimed::Nowhere
}

fn places(file: &Path, home: &Home) -> Vec<PathBuf> {
    let beside = file
        .file_name()
        .map(|name| file.with_file_name(format!(".{}.lock", name.to_string_lossy())));
    let apart = home
        .data_dir()
        .map(|dir| dir.join("recovery").join(format!("{}.lock", name_of_path(Some(file)))));
    beside.into_iter().chain(apart).collect()
}

fn claim_at(path: &Path, anyway: bool) -> io::Result<Claimed> {
    // Each round that ends without a claim found another session in the middle of the same.
    for _ in 0..50 {
        let former = match disk::open(path) {
            Ok(file) => Some(file),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            // A claim of another user that cannot be opened can still be replaced, or not at all.
            Err(error) if anyway && error.kind() == ErrorKind::PermissionDenied => None,
            Err(error) => return Err(error),
        };
        let mut place = if former.is_some() { Place::Over } else { Place::Free };
        if let Some(former) = &former {
            match held_by(path, former) {
                Some(holder) if !anyway => return Ok(Claimed::Theirs(holder)),
                _ if !disk::same_place(former, path) => continue,
                _ => {}
            }
        } else if anyway {
            place = Place::Over;
        }
        match put(path, place) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
            Ok(Placed { file, locked, .. }) => {
                return Ok(Claimed::Mine(Claim { path: path.to_path_buf(), file, locked }));
            }
        }
    }
    Err(ErrorKind::ResourceBusy.into())
}

/// Who holds by a claim that is there; nobody where its session is no more.
fn held_by(path: &Path, former: &File) -> Option<Holder> {
    let unknown = || Holder { since: 0, ..Holder::new("another session", "an unknown machine") };
    match disk::try_lock(former) {
        Ok(()) => None,
        Err(TryLockError::WouldBlock) => Some(read(path).unwrap_or_else(unknown)),
        Err(TryLockError::Error(_)) => {
            let holder = read(path).filter(Holder::may_live)?;
            Some(Holder { sure: false, ..holder })
        }
    }
}

fn read(path: &Path) -> Option<Holder> {
    known(&load::read_within(path, load::LARGEST_OWN_FILE).ok()?).ok()
}

fn put(path: &Path, place: Place) -> io::Result<Placed> {
    let draft = Draft::new(path, false)?;
    let text = ron::ser::to_string_pretty(&Holder::this(), ron::ser::PrettyConfig::new())
        .map_err(io::Error::other)?;
    draft.write(format!("{text}\n").as_bytes())?;
    draft.put(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mine(claimed: Claimed) -> Claim {
        match claimed {
            Claimed::Mine(claim) => claim,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_first_session_holds_a_file_and_the_next_is_told_who_that_is() {
        let dir = tempfile::tempdir().unwrap();
        let (project, home) = (dir.path().join("p.ron"), Home::at(None));
        let first = mine(claim(&project, &home, false));
        assert!(dir.path().join(".p.ron.lock").exists());
        let second = claim(&project, &home, false);
        let this = Holder::this();
        let holder = second.holder().unwrap();
        assert_eq!((&holder.name, &holder.host, holder.sure), (&this.name, &this.host, true));
        assert!(holder.text().contains(" UTC"), "{}", holder.text());
        drop(first);
        assert!(!dir.path().join(".p.ron.lock").exists());
        mine(claim(&project, &home, false));
    }

    #[test]
    fn a_claim_that_was_left_is_worth_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let (project, home) = (dir.path().join("p.ron"), Home::at(None));
        let first = mine(claim(&project, &home, false));
        // As by a kill: the lock goes, the file stays.
        let text = fs::read(&first.path).unwrap();
        drop(first);
        fs::write(dir.path().join(".p.ron.lock"), text).unwrap();
        mine(claim(&project, &home, false));
        fs::write(dir.path().join(".p.ron.lock"), "{".repeat(20_000)).unwrap();
        mine(claim(&project, &home, false));
    }

    #[test]
    fn who_takes_over_holds_and_the_former_knows() {
        let dir = tempfile::tempdir().unwrap();
        let (project, home) = (dir.path().join("p.ron"), Home::at(None));
        let first = mine(claim(&project, &home, false));
        assert!(first.holds() && first.taken_by().is_none());
        let second = mine(claim(&project, &home, true));
        assert!(second.holds() && !first.holds());
        assert!(first.taken_by().is_some());
        // The former's end leaves the claim of the other alone.
        drop(first);
        assert!(second.holds());
        assert!(claim(&project, &home, false).holder().is_some());
    }

    #[test]
    fn of_many_at_once_one_holds() {
        let dir = tempfile::tempdir().unwrap();
        let (project, home) = (dir.path().join("p.ron"), Home::at(None));
        for _ in 0..20 {
            let all: Vec<Claimed> = std::thread::scope(|scope| {
                let one = || claim(&project, &home, false);
                let threads: Vec<_> = (0..8).map(|_| scope.spawn(one)).collect();
                threads.into_iter().map(|thread| thread.join().unwrap()).collect()
            });
            let mine = all.iter().filter(|claimed| matches!(claimed, Claimed::Mine(_))).count();
            assert_eq!(mine, 1, "{all:?}");
        }
    }

    /// Seen: on a network drive without locks nothing was said of it. Cause: that no lock was to be had was
    /// passed over.
    #[test]
    fn a_disk_without_locks_is_told_and_who_comes_second_is_told_of_the_first() {
        let dir = tempfile::tempdir().unwrap();
        let (project, home) = (dir.path().join("p.ron"), Home::at(None));
        let first = claim(&project, &home, false);
        assert_eq!(first.doubt(), None, "a disk with locks");
        drop(first);
        disk::without_locks::on_it(|| {
            let first = claim(&project, &home, false);
            let said = first.doubt().expect("it is told");
            assert!(said.contains("keeps no locks") && said.contains("one place"), "{said}");
            // This process lives, so the claim counts; a claim of a process that is gone does not.
            let second = claim(&project, &home, false);
            let holder = second.holder().expect("it is held");
            assert!(!holder.sure && holder.text().contains("keeps no locks"), "{}", holder.text());
            let taken = mine(claim(&project, &home, true));
            assert!(taken.holds() && !taken.locked);
        });
    }

    #[test]
    fn without_locks_what_the_claim_says_is_said_with_its_doubt() {
        let holder = Holder { sure: false, ..Holder::new("anna", "basalt") };
        assert!(holder.text().starts_with("anna on basalt since 2"), "{}", holder.text());
        assert!(holder.text().ends_with("who may be gone: this disk keeps no locks"));
        assert!(holder.may_live());
        let (_, host) = disk::user_and_host();
        assert!(Holder::new("anna", &host).may_live());
        let gone = Holder { pid: 0x3fff_fff0, ..Holder::new("anna", &host) };
        assert!(!gone.may_live());
        let odd = Holder::new("a\u{1b}[2J\nb", "c");
        assert!(odd.text().starts_with("a[2Jb on c"), "{}", odd.text());
    }
}
