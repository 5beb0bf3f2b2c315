//! A file on its way: written beside the place it is meant for, under a name of its own, brought to the
//! disk, and put in its place in one step. One that is given up is removed at once, and one that a
//! killed program left is removed by a later start ([`sweep`]).
//!
//! A draft is locked as long as its program lives. The lock goes along into the place, so that whoever
//! keeps the file open holds it: recovery files and claims are known to belong to somebody by that.

use super::disk;
use std::collections::hash_map::RandomState;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, Hasher};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// What the name of a draft ends with, behind 16 hexadecimal digits.
const ENDING: &str = ".saving";
/// Bytes of the target's name that a draft's name takes over: a name has at most 255.
const NAME_KEPT: usize = 200;
/// Files that are looked at for drafts that were left.
const MOST_LOOKED_AT: usize = 10_000;
/// Age of a draft that is taken as left where the disk keeps no locks.
const LEFT_FOR_SURE: Duration = Duration::from_secs(24 * 3600);

/// Whether a draft may take the place of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// It replaces what is there.
    Over,
    /// There must be nothing: `AlreadyExists` otherwise.
    Free,
}

/// A file that is in its place.
#[derive(Debug)]
pub(super) struct Placed {
    /// It, open and locked where the disk keeps locks.
    pub(super) file: File,
    /// Whether the disk keeps locks.
    pub(super) locked: bool,
    /// What the system said when the directory was to be brought to the disk: the file is in place, but
    /// may be gone after a loss of power.
    pub(super) unsure: Option<io::Error>,
}

/// A file on its way.
#[derive(Debug)]
pub(super) struct Draft {
    /// Where it is now.
    path: PathBuf,
    target: PathBuf,
    /// None once it is in its place.
    file: Option<File>,
    locked: bool,
}

impl Draft {
    /// An empty one for a target. It is the user's alone until [`Draft::dress`]; where there is nothing
    /// to be like, it gets the mode of any new file.
    ///
    /// # Errors
    /// What the system said.
    pub(super) fn new(target: &Path, private: bool) -> io::Result<Draft> {
        // A bare name has an empty parent, which no system call takes.
        let target = match target.parent() {
            Some(parent) if parent.as_os_str().is_empty() => Path::new(".").join(target),
            _ => target.to_path_buf(),
        };
        for _ in 0..100 {
            let path = draft_path(&target).ok_or(ErrorKind::InvalidInput)?;
            let mut options = OpenOptions::new();
            options.write(true).read(true).create_new(true);
            disk::private(&mut options, private);
            match options.open(&path) {
                Ok(file) => {
                    // Where the disk keeps no locks, nobody will know that it is in use.
                    let locked = disk::try_lock(&file).is_ok();
                    return Ok(Draft { path, target, file: Some(file), locked });
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(ErrorKind::AlreadyExists.into())
    }

    fn file(&self) -> io::Result<&File> {
        self.file.as_ref().ok_or_else(|| ErrorKind::NotFound.into())
    }

    /// Gives it mode, owner and attributes of a file. What it cannot have, in words.
    ///
    /// # Errors
    /// What the system said; nothing of this is a reason to stop.
    pub(super) fn dress(&self, like: &File) -> io::Result<Vec<String>> {
        disk::dress(self.file()?, like)
    }

    /// Writes its text.
    ///
    /// # Errors
    /// What the system said.
    pub(super) fn write(&self, bytes: &[u8]) -> io::Result<()> {
        self.file()?.write_all(bytes)
    }

    /// Brings it to the disk and puts it in its place.
    ///
    /// # Errors
    /// What the system said; then all is as before.
    pub(super) fn put(mut self, place: Place) -> io::Result<Placed> {
        self.file()?.sync_all()?;
        match place {
            Place::Over => fs::rename(&self.path, &self.target)?,
            Place::Free => disk::rename_to_free(&self.path, &self.target)?,
        }
        let file = self.file.take().ok_or(ErrorKind::NotFound)?;
        // The rename is on the disk once the directory is.
        let unsure = self.target.parent().and_then(|dir| disk::sync_directory(dir).err());
        Ok(Placed { file, locked: self.locked, unsure })
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if self.file.is_some() {
            // Where that fails, a later start sweeps it.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Puts bytes in the place of a file in one step, and on the disk, with the mode and attributes of the
/// file as far as they can be kept.
///
/// # Errors
/// What the system said; then all is as before.
pub(super) fn write_atomically(target: &Path, bytes: &[u8]) -> io::Result<Placed> {
    let old = disk::open(target).ok();
    let draft = Draft::new(target, old.is_some())?;
    if let Some(old) = &old {
        draft.dress(old)?;
    }
    draft.write(bytes)?;
    draft.put(Place::Over)
}

/// A name for a draft that nothing has: that of the target, 16 digits and an ending.
fn draft_path(target: &Path) -> Option<PathBuf> {
    let name = target.file_name()?.to_string_lossy();
    let mut kept = NAME_KEPT.min(name.len());
    while !name.is_char_boundary(kept) {
        kept -= 1;
    }
    let mut chance = RandomState::new().build_hasher();
    chance.write_u32(std::process::id());
    let number = chance.finish();
    Some(target.with_file_name(OsString::from(format!(".{}.{number:016x}{ENDING}", &name[..kept]))))
}

/// Whether a name is that of a draft.
fn is_draft(name: &str) -> bool {
    let Some(rest) = name.strip_prefix('.').and_then(|name| name.strip_suffix(ENDING)) else {
        return false;
    };
    let Some((kept, digits)) = rest.rsplit_once('.') else { return false };
    !kept.is_empty()
        && digits.len() == 16
        && digits.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b))
}

/// Removes drafts in a directory that belong to no living program, and nothing else.
pub(super) fn sweep(dir: &Path) {
    let dir = if dir.as_os_str().is_empty() { Path::new(".") } else { dir };
    let Ok(entries) = fs::read_dir(dir) else { return };
    for entry in entries.take(MOST_LOOKED_AT).flatten() {
        let plain = entry.file_type().is_ok_and(|kind| kind.is_file());
        if plain && is_draft(&entry.file_name().to_string_lossy()) && is_left(&entry.path()) {
            // Not to be allowed to is no fault of this session.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether nobody is writing a draft any more.
fn is_left(path: &Path) -> bool {
    let Ok(file) = disk::open(path) else { return false };
    match disk::try_lock(&file) {
        // A draft is there for a moment before it is locked.
        Ok(()) => age(&file).is_some_and(|age| age > Duration::from_secs(2)),
        Err(fs::TryLockError::WouldBlock) => false,
        Err(fs::TryLockError::Error(_)) => age(&file).is_some_and(|age| age > LEFT_FOR_SURE),
    }
}

fn age(file: &File) -> Option<Duration> {
    SystemTime::now().duration_since(file.metadata().ok()?.modified().ok()?).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(dir: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(dir)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_draft_that_is_given_up_leaves_nothing() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("p.ron");
        let draft = Draft::new(&target, false).unwrap();
        draft.write(b"half").unwrap();
        assert!(is_draft(&names(dir.path())[0]), "{:?}", names(dir.path()));
        drop(draft);
        assert_eq!(names(dir.path()), Vec::<String>::new());
        fs::write(&target, "old").unwrap();
        let draft = Draft::new(&target, false).unwrap();
        draft.write(b"new").unwrap();
        assert_eq!(draft.put(Place::Free).unwrap_err().kind(), ErrorKind::AlreadyExists);
        assert_eq!(fs::read(&target).unwrap(), b"old");
        assert_eq!(names(dir.path()), ["p.ron"]);
    }

    #[test]
    fn a_later_start_sweeps_what_a_killed_save_left_and_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let old = SystemTime::now() - Duration::from_secs(60);
        let make = |name: &str| {
            let file = File::create(dir.path().join(name)).unwrap();
            file.set_modified(old).unwrap();
            file
        };
        let others = [".p.ron.0123456789abcde.saving", ".p.ron.backup", "p.ron.saving", ".saving"];
        for name in others {
            make(name);
        }
        make(".p.ron.0123456789abcdef.saving");
        let living = make(".p.ron.0123456789abcde0.saving");
        living.lock().unwrap();
        sweep(dir.path());
        let mut left: Vec<String> = others.iter().map(ToString::to_string).collect();
        left.push(".p.ron.0123456789abcde0.saving".into());
        left.sort();
        assert_eq!(names(dir.path()), left);
        // Its writer has died.
        drop(living);
        sweep(dir.path());
        assert_eq!(names(dir.path()).len(), others.len());
    }

    #[test]
    fn a_long_name_has_drafts_too() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join(format!("{}.ron", "ü".repeat(125)));
        write_atomically(&target, b"text").unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"text");
    }
}
