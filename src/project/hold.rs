//! A file that is about to be replaced, held against others who are about to do the same: of two saves
//! at the same moment the second finds what the first one wrote.

use super::disk;
use super::draft::{Draft, Place};
use super::load::LARGEST_FILE;
use super::save::SaveError;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Read};
use std::path::Path;
use std::thread;
use std::time::Duration;

/// Tries to hold a file, one every [`PAUSE`]: a save takes some milliseconds.
const TRIES: usize = 200;
const PAUSE: Duration = Duration::from_millis(10);

/// A file that is held until this is dropped.
#[derive(Debug)]
pub(super) struct Held {
    pub(super) file: File,
    /// What stands in it; of more than a project can be, only the beginning.
    pub(super) bytes: Vec<u8>,
}

/// Holds a file; nothing if there is none.
///
/// # Errors
/// Why it cannot be replaced.
pub(super) fn hold(target: &Path) -> Result<Option<Held>, SaveError> {
    let failed = |error| SaveError::Io { path: target.to_path_buf(), error };
    for _ in 0..TRIES {
        match fs::metadata(target) {
            Ok(about) if !about.is_file() => {
                return Err(SaveError::NotAFile(target.to_path_buf()));
            }
            Ok(about) if about.permissions().readonly() => {
                return Err(SaveError::ReadOnly(target.to_path_buf()));
            }
            Ok(_) => {}
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(failed(error)),
        }
        let file = match disk::open(target) {
            Ok(file) => file,
            Err(error) if error.kind() == ErrorKind::NotFound => continue,
            Err(error) => return Err(failed(error)),
        };
        match disk::try_lock(&file) {
            Err(TryLockError::WouldBlock) => thread::sleep(PAUSE),
            // A disk without locks: what can be seen is compared all the same.
            Ok(()) | Err(TryLockError::Error(_)) if disk::same_place(&file, target) => {
                let bytes = beginning(&file).map_err(failed)?;
                return Ok(Some(Held { file, bytes }));
            }
            // Somebody put another file there meanwhile.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
    }
    Err(SaveError::Busy(target.to_path_buf()))
}

fn beginning(file: &File) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(LARGEST_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Makes a small file of the program's own anew from what stands in it, so that no change of another
/// session in between is lost. `change` returns nothing where nothing is to be done.
///
/// # Errors
/// What the system said.
pub(super) fn rewrite(
    target: &Path,
    mut change: impl FnMut(Option<&[u8]>) -> io::Result<Option<Vec<u8>>>,
) -> io::Result<()> {
    if let Some(dir) = target.parent() {
        fs::create_dir_all(dir)?;
    }
    for _ in 0..TRIES {
        let held = match hold(target) {
            Ok(held) => held,
            Err(SaveError::Io { error, .. }) => return Err(error),
            Err(other) => return Err(io::Error::other(other.to_string())),
        };
        let Some(bytes) = change(held.as_ref().map(|held| held.bytes.as_slice()))? else {
            return Ok(());
        };
        let draft = Draft::new(target, held.is_some())?;
        draft.write(&bytes)?;
        let put = match &held {
            Some(held) => {
                draft.dress(&held.file)?;
                draft.put(Place::Over)
            }
            None => draft.put(Place::Free),
        };
        match put {
            Err(error) if held.is_none() && error.kind() == ErrorKind::AlreadyExists => {}
            other => return other.map(|_| ()),
        }
    }
    Err(ErrorKind::ResourceBusy.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_change_of_another_session_is_lost() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("made/list");
        let one = |word: String| {
            rewrite(&target, |old| Ok(Some([old.unwrap_or_default(), word.as_bytes()].concat())))
        };
        thread::scope(|scope| {
            for n in 0..8 {
                let one = &one;
                scope.spawn(move || (0..5).for_each(|m| one(format!("{n}{m} ")).unwrap()));
            }
        });
        let text = fs::read_to_string(&target).unwrap();
        assert_eq!(text.split(' ').count(), 41, "{text}");
    }

    #[test]
    fn a_file_that_others_hold_is_waited_for_and_then_refused() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("p.ron");
        fs::write(&target, "text").unwrap();
        let mine = hold(&target).unwrap().unwrap();
        assert_eq!(mine.bytes, b"text");
        assert!(matches!(hold(&target), Err(SaveError::Busy(_))));
        drop(mine);
        assert!(hold(&target).unwrap().is_some());
    }
}
