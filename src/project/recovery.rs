//! Unsaved work kept beside the file, for the day on which the program or the line breaks off.
//!
//! The copy of `dir/road-cut.ron` is `dir/.road-cut.ron.recovery`; where that directory cannot be
//! written it is a file in the `recovery` directory of the data directory, named after the path.
//! It is written whole or not at all, like the project itself.

use super::document::Document;
use super::error::LoadError;
use super::home::Home;
use super::load;
use super::save::{resolve, write_atomically};
use super::schema::Project;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Unsaved work of an earlier run.
#[derive(Debug, Clone, PartialEq)]
pub struct Recovery {
    /// The file that holds it.
    pub path: PathBuf,
    /// When it was written, as far as the system knows.
    pub written: Option<SystemTime>,
    /// The text of the unsaved project.
    pub text: String,
}

impl Document {
    /// Keeps unsaved work; returns the file that holds it. A project without a file is kept in the
    /// data directory.
    ///
    /// # Errors
    /// What the system said, where neither place could be written, or what cannot be written.
    pub fn keep(&self, project: &Project, home: &Home) -> io::Result<PathBuf> {
        let text = self.render(project).map_err(io::Error::other)?.text;
        let mut last = io::Error::from(io::ErrorKind::NotFound);
        for place in places(self.path(), home) {
            if let Some(parent) = place.parent().filter(|_| home.owns(&place)) {
                // Fails with the write below, and better said there.
                let _ = fs::create_dir_all(parent);
            }
            match write_atomically(&place, text.as_bytes()) {
                Ok(()) => return Ok(place),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    /// Unsaved work of an earlier run on this file that differs from what the file holds now.
    pub fn find_recovery(&self, home: &Home) -> Option<Recovery> {
        places(self.path(), home)
            .into_iter()
            .filter_map(|path| read(&path))
            .filter(|recovery| recovery.text != self.text)
            // In a file of an older version the text is the migrated one.
            .filter(|recovery| Some(&recovery.text) != self.on_disk.as_ref())
            .max_by_key(|recovery| recovery.written)
    }

    /// Reads recovered work. The document stays that of the file, so that saving puts the recovered
    /// project in its place and not before.
    ///
    /// # Errors
    /// What is wrong with the recovered text.
    pub fn recover(&self, recovery: &Recovery) -> Result<Project, LoadError> {
        let parsed = load::parse_text(&recovery.text, &recovery.path.display().to_string())?;
        let mut project = parsed.project;
        // Layouts that are still in the file keep their comments: they are found by name, since
        // the text does not know which is which.
        for layout in &mut project.layouts {
            if let Some(same) = self.base.layouts.iter().find(|l| l.name == layout.name) {
                layout.uid = same.uid;
            }
        }
        Ok(project)
    }

    /// Throws kept work away; for after a save, a quit, or a refusal by the user.
    pub fn discard_recovery(&self, home: &Home) {
        for place in places(self.path(), home) {
            // Where there is nothing to throw away, or no right to, there is nothing to be said.
            let _ = fs::remove_file(place);
        }
    }
}

/// Where work on a file is kept, the better place first.
fn places(path: Option<&Path>, home: &Home) -> Vec<PathBuf> {
    let mut places = Vec::new();
    let file = path.map(|p| resolve(p).unwrap_or_else(|_| p.to_path_buf()));
    if let Some(file) = &file
        && let Some(name) = file.file_name()
    {
        places.push(file.with_file_name(format!(".{}.recovery", name.to_string_lossy())));
    }
    if let Some(dir) = home.data_dir() {
        let name = match &file {
            Some(file) => {
                let whole = std::path::absolute(file).unwrap_or_else(|_| file.clone());
                let stem = file.file_name().map(|n| n.to_string_lossy().into_owned());
                format!("{}-{:016x}", stem.unwrap_or_default(), fingerprint(&whole))
            }
            None => "unnamed".to_string(),
        };
        places.push(dir.join("recovery").join(format!("{name}.recovery")));
    }
    places
}

/// A number for a path that is the same in every run (FNV-1a over its text).
fn fingerprint(path: &Path) -> u64 {
    let bytes = path.to_string_lossy().into_owned().into_bytes();
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

fn read(path: &Path) -> Option<Recovery> {
    let bytes = load::read_bytes(path).ok()?;
    let written = fs::metadata(path).and_then(|about| about.modified()).ok();
    Some(Recovery { path: path.to_path_buf(), written, text: String::from_utf8(bytes).ok()? })
}
