//! What the system knows of files beyond the standard library: which file it is, mode, owner, attributes.

use std::fs::{File, OpenOptions, TryLockError};
use std::io;
use std::path::Path;
use std::time::SystemTime;

/// What tells one state of a file from another without reading it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FileStamp {
    modified: Option<SystemTime>,
    length: u64,
    number: u64,
}

impl FileStamp {
    /// Of the file at a path; none where there is none.
    pub(crate) fn of(path: &Path) -> Option<FileStamp> {
        let about = std::fs::metadata(path).ok()?;
        let number = system::number(&about);
        Some(FileStamp { modified: about.modified().ok(), length: about.len(), number })
    }
}

pub(super) use system::{
    dress, links, private, rename_to_free, runs, same_place, sync_directory, user_and_host,
};

/// Locks a file, if nobody else does; some disks, among them network drives, keep no locks.
pub(super) fn try_lock(file: &File) -> Result<(), TryLockError> {
    #[cfg(test)]
    if without_locks::here() {
        return Err(TryLockError::Error(io::ErrorKind::Unsupported.into()));
    }
    file.try_lock()
}

/// A disk without locks, for tests: what such a disk answers, to this thread.
#[cfg(test)]
pub(super) mod without_locks {
    use std::cell::Cell;

    thread_local!(static HERE: Cell<bool> = const { Cell::new(false) });

    pub(super) fn here() -> bool {
        HERE.get()
    }

    /// Does something on such a disk.
    pub(in crate::project) fn on_it<T>(work: impl FnOnce() -> T) -> T {
        HERE.set(true);
        let done = work();
        HERE.set(false);
        done
    }
}

/// Disks that do not answer, for tests.
#[cfg(test)]
pub(crate) mod silent {
    use std::path::{Path, PathBuf};
    use std::sync::{Condvar, Mutex};

    static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
    static ANSWERS: Condvar = Condvar::new();

    /// As long as this lives, whoever opens a file of a folder waits.
    pub(crate) struct Silent(PathBuf);

    /// A folder falls silent.
    pub(crate) fn falls(folder: &Path) -> Silent {
        FOLDERS.lock().unwrap().push(folder.to_path_buf());
        Silent(folder.to_path_buf())
    }

    impl Drop for Silent {
        fn drop(&mut self) {
            FOLDERS.lock().unwrap().retain(|folder| *folder != self.0);
            ANSWERS.notify_all();
        }
    }

    pub(super) fn wait(path: &Path) {
        let silent = |folders: &mut Vec<PathBuf>| folders.iter().any(|f| path.starts_with(f));
        drop(ANSWERS.wait_while(FOLDERS.lock().unwrap(), silent).unwrap());
    }
}

/// Opens a file to be read, without waiting for whoever writes a pipe.
pub(super) fn open_to_read(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true);
    system::never_wait(&mut options);
    options.open(path)
}

/// Opens a file to be read and locked, for writing too where that is allowed: some disks lock nothing
/// else. Never waits for anybody, as a pipe would have it.
pub(super) fn open(path: &Path) -> io::Result<File> {
    #[cfg(test)]
    silent::wait(path);
    let open = |write: bool| {
        let mut options = OpenOptions::new();
        options.read(true).write(write);
        system::never_wait(&mut options);
        options.open(path)
    };
    open(true).or_else(|error| match error.kind() {
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => open(false),
        _ => Err(error),
    })
}

#[cfg(unix)]
mod system {
    use rustix::fs::{
        Mode, fchmod, fchown, fgetxattr, fgetxattr_query, flistxattr, flistxattr_query, fsetxattr,
    };
    use rustix::fs::{XattrFlags, fstat};
    use rustix::io::Errno;
    use std::ffi::CStr;
    use std::fs::{self, File, OpenOptions};
    use std::io;
    use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
    use std::path::Path;

    /// Most bytes of names or of one value of attributes that are carried along.
    const MOST_BYTES: usize = 64 * 1024;

    pub(super) fn never_wait(options: &mut OpenOptions) {
        options.custom_flags(libc::O_NONBLOCK);
    }

    /// A new file is to be the user's alone.
    pub(in crate::project) fn private(options: &mut OpenOptions, private: bool) {
        if private {
            options.mode(0o600);
        }
    }

    /// Whether an open file still stands at a path.
    pub(in crate::project) fn same_place(file: &File, path: &Path) -> bool {
        match (file.metadata(), fs::symlink_metadata(path)) {
            (Ok(a), Ok(b)) => (a.dev(), a.ino()) == (b.dev(), b.ino()),
            _ => false,
        }
    }

    /// The number by which the disk knows a file.
    pub(super) fn number(about: &fs::Metadata) -> u64 {
        about.ino()
    }

    /// How many names a file has.
    pub(in crate::project) fn links(file: &File) -> u64 {
        file.metadata().map_or(1, |about| about.nlink())
    }

    /// Gives a file mode, owner and attributes of another one; what it cannot have, in words.
    pub(in crate::project) fn dress(file: &File, like: &File) -> io::Result<Vec<String>> {
        let (old, new) = (fstat(like)?, fstat(file)?);
        if (old.st_uid, old.st_gid) != (new.st_uid, new.st_gid) {
            // Only root may give files away; the group is worth a try of its own.
            let group = Some(rustix::fs::Gid::from_raw(old.st_gid));
            let owner = Some(rustix::fs::Uid::from_raw(old.st_uid));
            let _ = fchown(file, owner, group).or_else(|_| fchown(file, None, group));
        }
        fchmod(file, Mode::from_raw_mode(old.st_mode))?;
        let new = fstat(file)?;
        let mut lost = strangers((old.st_uid, old.st_gid), (new.st_uid, new.st_gid));
        for name in names(like) {
            let Ok(name) = CStr::from_bytes_with_nul(&name) else { continue };
            if value(like, name) != value(file, name) && !carry(like, file, name) {
                let shown = name.to_string_lossy();
                lost.push(match shown.as_ref() {
                    "system.posix_acl_access" | "system.nfs4_acl" => "its access list".to_owned(),
                    _ => format!("its attribute {shown}"),
                });
            }
        }
        Ok(lost)
    }

    /// What a file loses that belongs to others after all: its owner and its group, by their numbers.
    fn strangers(old: (u32, u32), new: (u32, u32)) -> Vec<String> {
        let owner = (old.0 != new.0).then(|| format!("its owner (user {})", old.0));
        let group = (old.1 != new.1).then(|| format!("its group ({})", old.1));
        owner.into_iter().chain(group).collect()
    }

    /// Names of a file's attributes, each with its zero; none where the disk has no attributes.
    fn names(file: &File) -> Vec<Vec<u8>> {
        let size = flistxattr_query(file).unwrap_or(0).min(MOST_BYTES);
        let mut bytes = vec![0_u8; size];
        let Ok(size) = flistxattr(file, &mut bytes[..]) else { return Vec::new() };
        bytes.truncate(size);
        bytes.split_inclusive(|b| *b == 0).map(<[u8]>::to_vec).collect()
    }

    fn value(file: &File, name: &CStr) -> Result<Vec<u8>, Errno> {
        let size = fgetxattr_query(file, name)?;
        let mut bytes = vec![0_u8; size.min(MOST_BYTES)];
        let size = fgetxattr(file, name, &mut bytes[..])?;
        bytes.truncate(size);
        Ok(bytes)
    }

    fn carry(from: &File, to: &File, name: &CStr) -> bool {
        value(from, name).and_then(|value| fsetxattr(to, name, &value, XattrFlags::empty())).is_ok()
    }

    /// Gives a file a name that must be free.
    #[cfg(any(target_os = "linux", target_os = "android"))]
    pub(in crate::project) fn rename_to_free(from: &Path, to: &Path) -> io::Result<()> {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        match renameat_with(CWD, from, CWD, to, RenameFlags::NOREPLACE) {
            Err(Errno::INVAL | Errno::NOSYS | Errno::OPNOTSUPP) => link(from, to),
            other => Ok(other?),
        }
    }

    #[cfg(not(any(target_os = "linux", target_os = "android")))]
    pub(in crate::project) use link as rename_to_free;

    /// A second name, which must be free, and the first one taken away. Where the disk has no second
    /// names there is a moment in which somebody else's new file could be replaced.
    pub(in crate::project) fn link(from: &Path, to: &Path) -> io::Result<()> {
        match fs::hard_link(from, to) {
            Ok(()) => fs::remove_file(from),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => Err(error),
            Err(_) if fs::symlink_metadata(to).is_ok() => Err(io::ErrorKind::AlreadyExists.into()),
            Err(_) => fs::rename(from, to),
        }
    }

    /// Brings a directory to the disk. A disk that knows no such thing is none to complain of, nor is
    /// a directory that may not be opened.
    pub(in crate::project) fn sync_directory(dir: &Path) -> io::Result<()> {
        let Ok(opened) = File::open(dir) else { return Ok(()) };
        match opened.sync_all() {
            Err(error) if harmless(&error) => Ok(()),
            other => other,
        }
    }

    fn harmless(error: &io::Error) -> bool {
        let known = [Errno::INVAL, Errno::NOSYS, Errno::OPNOTSUPP, Errno::ROFS, Errno::BADF];
        Errno::from_io_error(error).is_some_and(|errno| known.contains(&errno))
    }

    /// Whether a process of this machine is there.
    pub(in crate::project) fn runs(process: u32) -> bool {
        let id = i32::try_from(process).ok().and_then(rustix::process::Pid::from_raw);
        id.is_some_and(|id| rustix::process::test_kill_process(id) != Err(Errno::SRCH))
    }

    /// The user and the machine, for people.
    pub(in crate::project) fn user_and_host() -> (String, String) {
        let named = ["USER", "LOGNAME"].iter().find_map(|name| std::env::var(name).ok());
        let named = named.filter(|name| !name.trim().is_empty());
        let number = rustix::process::getuid().as_raw();
        let listed =
            || fs::read_to_string("/etc/passwd").ok().and_then(|all| name_in(&all, number));
        let user = named.or_else(listed).unwrap_or_else(|| format!("user {number}"));
        let host = rustix::system::uname().nodename().to_string_lossy().into_owned();
        (user, host)
    }

    /// The name of a user in the system's list of them, a line each: `name:x:number:...`.
    fn name_in(list: &str, number: u32) -> Option<String> {
        list.lines().find_map(|line| {
            let mut parts = line.split(':');
            let (name, _, theirs) = (parts.next()?, parts.next()?, parts.next()?);
            (theirs.parse() == Ok(number) && !name.is_empty()).then(|| name.to_owned())
        })
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn a_user_without_a_variable_has_the_name_of_the_systems_list() {
            let list =
                "root:x:0:0:root:/root:/bin/sh\n# rem\n:x:7::\nanna:x:1000:1000::/home/anna:\n";
            assert_eq!(name_in(list, 1000).as_deref(), Some("anna"));
            assert_eq!((name_in(list, 7), name_in(list, 1001)), (None, None));
        }

        #[test]
        fn a_fault_of_the_disk_is_told_apart_from_a_disk_that_cannot() {
            assert!(harmless(&Errno::INVAL.into()));
            for errno in [Errno::IO, Errno::NOSPC, Errno::DQUOT, Errno::STALE] {
                assert!(!harmless(&errno.into()), "{errno:?}");
            }
        }

        #[test]
        fn an_owner_or_group_that_a_save_would_lose_is_named() {
            let anna = (1000, 100);
            assert_eq!(strangers(anna, anna), Vec::<String>::new());
            assert_eq!(strangers(anna, (1001, 100)), ["its owner (user 1000)"]);
            assert_eq!(strangers(anna, (1000, 7)), ["its group (100)"]);
            let both = ["its owner (user 1000)", "its group (100)"];
            assert_eq!(strangers(anna, (1001, 7)), both);
        }

        /// Only root can make a file of somebody else's; where the tests run as root, the copy goes back to
        /// its owner and nothing is lost.
        #[test]
        fn roots_save_leaves_a_file_with_its_owner() {
            use rustix::fs::{Gid, Uid};
            let dir = tempfile::tempdir().unwrap();
            let make = |name: &str| {
                let path = dir.path().join(name);
                OpenOptions::new().read(true).write(true).create_new(true).open(path).unwrap()
            };
            let (old, new) = (make("old"), make("new"));
            if fchown(&old, Some(Uid::from_raw(1)), Some(Gid::from_raw(1))).is_err() {
                return;
            }
            assert_eq!(dress(&new, &old).unwrap(), Vec::<String>::new());
            let about = fstat(&new).unwrap();
            assert_eq!((about.st_uid, about.st_gid), (1, 1));
        }

        #[test]
        fn attributes_go_along() {
            let dir = tempfile::tempdir().unwrap();
            let make = |name: &str| {
                let path = dir.path().join(name);
                OpenOptions::new().read(true).write(true).create_new(true).open(path).unwrap()
            };
            let (old, new) = (make("old"), make("new"));
            if fsetxattr(&old, c"user.note", b"north", XattrFlags::empty()).is_err() {
                // This disk keeps none.
                return;
            }
            assert_eq!(dress(&new, &old).unwrap(), Vec::<String>::new());
            assert_eq!(value(&new, c"user.note").unwrap(), b"north");
        }
    }
}

#[cfg(not(unix))]
mod system {
    use std::fs::{self, File, OpenOptions};
    use std::io;
    use std::path::Path;

    pub(super) fn never_wait(_options: &mut OpenOptions) {}

    pub(in crate::project) fn private(_options: &mut OpenOptions, _private: bool) {}

    /// An open file cannot be replaced here.
    pub(in crate::project) fn same_place(_file: &File, path: &Path) -> bool {
        path.exists()
    }

    pub(super) fn number(_about: &fs::Metadata) -> u64 {
        0
    }

    pub(in crate::project) fn links(_file: &File) -> u64 {
        1
    }

    pub(in crate::project) fn dress(_file: &File, _like: &File) -> io::Result<Vec<String>> {
        Ok(Vec::new())
    }

    pub(in crate::project) fn rename_to_free(from: &Path, to: &Path) -> io::Result<()> {
        if to.exists() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        fs::rename(from, to)
    }

    pub(in crate::project) fn sync_directory(_dir: &Path) -> io::Result<()> {
        Ok(())
    }

    /// Nothing is known of it.
    pub(in crate::project) fn runs(_process: u32) -> bool {
        true
    }

    pub(in crate::project) fn user_and_host() -> (String, String) {
        let named = |name: &str| std::env::var(name).unwrap_or_else(|_| "somebody".to_owned());
        (named("USERNAME"), named("COMPUTERNAME"))
    }
}
