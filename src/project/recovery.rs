//! Unsaved work kept beside the file, for the day on which the program or the line breaks off.
//!
//! The copy of `dir/road-cut.ron` is `dir/.road-cut.ron.recovery`, or with a number in its name where
//! another session has that; where the directory cannot be written it is a file in the `recovery`
//! directory of the data directory, named after the path. It is written whole or not at all, like the
//! project itself, and has the mode of the project.
//!
//! A recovery file belongs to the session that wrote it: it is locked as long as that lives, and then
//! nobody is offered it nor touches it. One that is offered is locked by whoever was asked.

use super::disk;
use super::document::Document;
use super::draft::{Draft, Place};
use super::error::LoadError;
use super::home::Home;
use super::load;
use super::method_files;
use super::save::resolve;
use super::schema::Project;
use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Sessions of one file that can keep work at the same time, living and lost.
const MOST: usize = 20;

/// Unsaved work of an earlier run, nobody else's as long as this is there.
#[derive(Debug)]
pub struct Recovery {
    /// The file that holds it.
    pub path: PathBuf,
    /// When it was written, as far as the system knows.
    pub written: Option<SystemTime>,
    /// The text of the unsaved project.
    pub text: String,
    file: File,
}

/// The recovery file of this session.
#[derive(Debug)]
pub struct OwnRecovery {
    path: PathBuf,
    /// The project's file, links followed.
    of: Option<PathBuf>,
    /// Open, and locked where the disk keeps locks.
    file: File,
}

impl OwnRecovery {
    /// Makes what was kept by a lost session the recovery file of this one, for a document.
    pub fn adopt(kept: Recovery, document: &Document) -> OwnRecovery {
        OwnRecovery { path: kept.path, of: document.file(), file: kept.file }
    }

    /// Whether it is where it was written.
    pub fn stands(&self) -> bool {
        disk::same_place(&self.file, &self.path)
    }

    /// Throws it away; for after a save, a quit, or a refusal by the user.
    pub fn discard(self) {
        if self.stands() {
            // Where there is no right to, there is nothing to be said.
            let _ = fs::remove_file(&self.path);
        }
    }

    /// Writes another text in its place.
    fn rewrite(&mut self, text: &str) -> io::Result<()> {
        self.file = write(&self.path, self.of.as_deref(), text, Place::Over)?;
        Ok(())
    }
}

impl Recovery {
    /// When the project's file was written, where that was after this: the file then has changes that
    /// the kept work does not know.
    pub(crate) fn overtaken(&self, document: &Document) -> Option<SystemTime> {
        let file = fs::metadata(document.path()?).and_then(|about| about.modified()).ok()?;
        self.written.is_some_and(|written| written < file).then_some(file)
    }

    /// Throws it away.
    pub(crate) fn discard(self) {
        OwnRecovery { path: self.path, of: None, file: self.file }.discard();
    }
}

impl Document {
    /// The file behind the links.
    fn file(&self) -> Option<PathBuf> {
        self.path().map(|path| resolve(path).unwrap_or_else(|_| path.to_path_buf()))
    }

    /// Keeps unsaved work in this session's recovery file, which is made where there is none; returns
    /// where that is. A project without a file is kept in the data directory.
    ///
    /// # Errors
    /// What the system said, where neither place could be written, or what cannot be written.
    pub fn keep(
        &self,
        project: &Project,
        home: &Home,
        own: &mut Option<OwnRecovery>,
    ) -> io::Result<PathBuf> {
        let of = self.file();
        self.keep_at(&places(of.as_deref(), home), of, project, home, own)
    }

    /// The same in the data directory alone, without a look at the disk of the project's file, which does
    /// not answer.
    ///
    /// # Errors
    /// What the system said, or what cannot be written.
    pub(crate) fn keep_apart(
        &self,
        project: &Project,
        home: &Home,
        own: &mut Option<OwnRecovery>,
    ) -> io::Result<PathBuf> {
        // Links are not followed: what leads to the file by another name is not offered this.
        let mut places = places(self.path(), home);
        places.retain(|place| home.owns(place));
        self.keep_at(&places, None, project, home, own)
    }

    fn keep_at(
        &self,
        places: &[PathBuf],
        of: Option<PathBuf>,
        project: &Project,
        home: &Home,
        own: &mut Option<OwnRecovery>,
    ) -> io::Result<PathBuf> {
        let text = self.render(project).map_err(io::Error::other)?.text;
        if let Some(own) = own.as_mut().filter(|own| own.of == of)
            && own.rewrite(&text).is_ok()
        {
            return Ok(own.path.clone());
        }
        let made = make(places, of.as_deref(), home, &text)?;
        let path = made.path.clone();
        if let Some(former) = own.replace(made) {
            former.discard();
        }
        Ok(path)
    }

    /// Unsaved work of an earlier run on this file that differs from what the file holds now, and
    /// belongs to no living session. The newest, where there are several; while that is there, the next
    /// call finds the next.
    pub fn find_recovery(&self, home: &Home) -> Option<Recovery> {
        let mut found: Option<Recovery> = None;
        let places = places(self.file().as_deref(), home);
        for path in places.iter().flat_map(|place| names(place)) {
            let Some(recovery) = read(&path) else { continue };
            // In a file of an older version the text is the migrated one.
            if recovery.text == self.text || Some(&recovery.text) == self.on_disk.as_ref() {
                // All of it was saved before its session ended.
                recovery.discard();
            } else if found.as_ref().is_none_or(|other| other.written < recovery.written) {
                found = Some(recovery);
            }
        }
        found
    }

    /// Reads recovered work. The document stays that of the file, so that saving puts the recovered
    /// project in its place and not before.
    ///
    /// # Errors
    /// What is wrong with the recovered text.
    pub fn recover(&self, recovery: &Recovery) -> Result<Project, LoadError> {
        let parsed = load::parse_text(&recovery.text, &recovery.path.display().to_string())?;
        let mut project = parsed.project;
        match self.path() {
            Some(path) => method_files::resolve(&mut project, path)?,
            None => method_files::nowhere(&project, "")?,
        }
        // Layouts that are still in the file keep their comments: they are found by name, since
        // the text does not know which is which.
        for layout in &mut project.layouts {
            if let Some(same) = self.base.layouts.iter().find(|l| l.name == layout.name) {
                layout.uid = same.uid;
            }
        }
        Ok(project)
    }
}

/// Makes a recovery file under the first name that is free.
fn make(places: &[PathBuf], of: Option<&Path>, home: &Home, text: &str) -> io::Result<OwnRecovery> {
    let mut last = io::Error::from(ErrorKind::NotFound);
    for place in places {
        if let Some(parent) = place.parent().filter(|_| home.owns(place)) {
            // Fails with the write below, and better said there.
            let _ = fs::create_dir_all(parent);
        }
        for path in names(place) {
            if fs::symlink_metadata(&path).is_ok() {
                continue;
            }
            match write(&path, of, text, Place::Free) {
                Ok(file) => return Ok(OwnRecovery { path, of: of.map(Path::to_path_buf), file }),
                // Another session was faster.
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => {
                    last = error;
                    break;
                }
            }
        }
    }
    Err(last)
}

/// Writes a recovery file with the mode of the project's, or else for the user alone.
fn write(path: &Path, of: Option<&Path>, text: &str, place: Place) -> io::Result<File> {
    let draft = Draft::new(path, true)?;
    if let Some(project) = of.and_then(|of| disk::open(of).ok()) {
        draft.dress(&project)?;
    }
    draft.write(text.as_bytes())?;
    Ok(draft.put(place)?.file)
}

/// Where work on a file is kept, the better place first.
pub(super) fn places(file: Option<&Path>, home: &Home) -> Vec<PathBuf> {
    let mut places = Vec::new();
    if let Some(file) = file
        && let Some(name) = file.file_name()
    {
        places.push(file.with_file_name(format!(".{}.recovery", name.to_string_lossy())));
    }
    if let Some(dir) = home.data_dir() {
        places.push(dir.join("recovery").join(format!("{}.recovery", name_of_path(file))));
    }
    places
}

/// A name for what belongs to a file that is elsewhere.
pub(super) fn name_of_path(file: Option<&Path>) -> String {
    let Some(file) = file else { return "unnamed".to_string() };
    let whole = std::path::absolute(file).unwrap_or_else(|_| file.to_path_buf());
    let stem = file.file_name().map(|n| n.to_string_lossy().into_owned());
    format!("{}-{:016x}", stem.unwrap_or_default(), fingerprint(&whole))
}

/// The names that a recovery file may have at a place: `.p.ron.recovery`, `.p.ron.2.recovery`, ...
fn names(place: &Path) -> impl Iterator<Item = PathBuf> {
    (1..=MOST).map(move |n| match n {
        1 => place.to_path_buf(),
        _ => place.with_extension(format!("{n}.recovery")),
    })
}

/// A number for a path that is the same in every run (FNV-1a over its text).
fn fingerprint(path: &Path) -> u64 {
    let bytes = path.to_string_lossy().into_owned().into_bytes();
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// What a session that is no more has kept; nothing where there is none or it lives.
fn read(path: &Path) -> Option<Recovery> {
    if !fs::symlink_metadata(path).ok()?.is_file() {
        return None;
    }
    let file = disk::open(path).ok()?;
    match disk::try_lock(&file) {
        Err(TryLockError::WouldBlock) => return None,
        // A disk without locks does not tell the living from the dead.
        Ok(()) | Err(TryLockError::Error(_)) => {}
    }
    // Another session may have taken it meanwhile.
    if !disk::same_place(&file, path) {
        return None;
    }
    let bytes = load::read_bytes(path).ok()?;
    let written = file.metadata().and_then(|about| about.modified()).ok();
    // What is no text is refused when it is read as a project, and told then.
    let text = String::from_utf8_lossy(&bytes).into_owned();
    Some(Recovery { path: path.to_path_buf(), written, text, file })
}
