//! The user's own place: where the first project goes, which one was open last, and which before,
//! where the settings are.
//!
//! Everything here may fail without harm: without a home directory, or with one that cannot be
//! written, the program starts all the same and says what it cannot keep.

use super::document::{self, Opened};
use super::draft::{sweep, write_atomically};
use super::error::{Cause, LoadError};
use super::hold::rewrite;
use super::load::{LARGEST_OWN_FILE, read_within};
use super::read;
use super::text::parser;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Environment variable that names one directory for data and settings in place of the system's own.
pub(crate) const DATA_DIR_VARIABLE: &str = "MESHCAST_DATA_DIR";

/// Most paths in the list of recent projects.
const MOST_RECENT: usize = 20;

/// Name of the sample in the data directory.
const SAMPLE_NAME: &str = "road-cut.ron";
const SAMPLE: &str = include_str!("../../projects/road-cut.ron");

/// The user's directories for data and settings, if there are any.
#[derive(Debug, Clone, PartialEq)]
pub struct Home {
    dir: Option<PathBuf>,
    /// Where the file of settings is.
    config: Option<PathBuf>,
}

/// A project to start with.
#[derive(Debug, Clone)]
pub struct FirstProject {
    /// The project.
    pub opened: Opened,
    /// Something the user should know, for example that the project is kept nowhere yet.
    pub note: Option<String>,
}

/// What is remembered from run to run; unknown fields of a newer version are passed over.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
struct State {
    /// Projects that were open, the last one first, as absolute paths.
    recent: Vec<PathBuf>,
}

impl Home {
    /// The data directory of this system, or the one that `MESHCAST_DATA_DIR` names. Nothing is made.
    pub(crate) fn find() -> Home {
        let named = std::env::var_os(DATA_DIR_VARIABLE).filter(|dir| !dir.is_empty());
        if let Some(dir) = named {
            return Home::at(Some(PathBuf::from(dir)));
        }
        let dirs = directories::ProjectDirs::from("", "", "meshcast");
        Home {
            dir: dirs.as_ref().map(|d| d.data_dir().to_path_buf()),
            config: dirs.as_ref().map(|d| d.config_dir().to_path_buf()),
        }
    }

    /// A data directory at a place, or none; for tests.
    pub fn at(dir: Option<PathBuf>) -> Home {
        Home { config: dir.clone(), dir }
    }

    /// The data directory; it need not exist.
    pub(crate) fn data_dir(&self) -> Option<&Path> {
        self.dir.as_deref()
    }

    /// The file of settings; it need not exist.
    pub(crate) fn settings_file(&self) -> Option<PathBuf> {
        self.config.as_ref().map(|dir| dir.join("settings.ron"))
    }

    /// Removes what killed sessions left half written in the user's directories.
    pub(crate) fn sweep(&self) {
        let kept = self.dir.as_ref().map(|dir| dir.join("recovery"));
        for dir in [&self.dir, &self.config, &kept].into_iter().flatten() {
            sweep(dir);
        }
    }

    /// Whether a file is one of the program's own and no project.
    pub(crate) fn keeps(&self, path: &Path) -> bool {
        [self.state_file(), self.settings_file()].iter().flatten().any(|own| own == path)
    }

    pub(super) fn owns(&self, path: &Path) -> bool {
        self.dir.as_ref().is_some_and(|dir| path.starts_with(dir))
    }

    /// The project to start with when none is named: the last one, or on the first run a copy of the
    /// sample in the data directory. Where that cannot be made, the sample stands in no file. A last
    /// project that cannot be opened any more is passed over with a note, and so is a list of projects
    /// that cannot be read.
    ///
    /// # Errors
    /// Never but for a fault in the sample that the program brings along.
    pub fn start_project(&self) -> Result<FirstProject, LoadError> {
        let (state, mut note) = match self.state() {
            Ok(state) => (state, None),
            Err(why) => (State::default(), Some(format!("The list of recent projects: {why}."))),
        };
        if let Some(last) = state.recent.first() {
            match document::load(last) {
                Ok(opened) => return Ok(FirstProject { opened, note }),
                Err(error) => note = Some(passed_over(last, &error)),
            }
        }
        let Some(dir) = &self.dir else {
            return unsaved(note, "There is no data directory");
        };
        let path = dir.join(SAMPLE_NAME);
        let made = if fs::symlink_metadata(&path).is_ok() {
            Ok(())
        } else {
            fs::create_dir_all(dir)
                .and_then(|()| write_atomically(&path, SAMPLE.as_bytes()))
                .map(|_| ())
        };
        match made {
            Ok(()) => match document::load(&path) {
                Ok(opened) => Ok(FirstProject { opened, note }),
                Err(error) => unsaved(note, &passed_over(&path, &error)),
            },
            Err(_) => unsaved(note, &format!("{} cannot be written", dir.display())),
        }
    }

    /// Notes that a project was opened or saved; the next start opens it.
    ///
    /// # Errors
    /// What the system said. There is nothing to be done about it, but `Ok(false)` without a data
    /// directory and the error let a caller tell.
    pub fn remember(&self, path: &Path) -> io::Result<bool> {
        let Some(file) = self.state_file() else { return Ok(false) };
        // One name for one file, however it was reached.
        let path = fs::canonicalize(path).or_else(|_| std::path::absolute(path))?;
        rewrite(&file, |old| {
            // A list that cannot be read is made anew; the start has said so.
            let mut state: State = old.and_then(|old| known(old).ok()).unwrap_or_default();
            if state.recent.first() == Some(&path) {
                return Ok(None);
            }
            state.recent.retain(|p| *p != path && fs::canonicalize(p).ok().as_ref() != Some(&path));
            state.recent.insert(0, path.clone());
            state.recent.truncate(MOST_RECENT);
            let text = ron::ser::to_string_pretty(&state, ron::ser::PrettyConfig::new())
                .map_err(io::Error::other)?;
            Ok(Some(format!("{text}\n").into_bytes()))
        })?;
        Ok(true)
    }

    /// Projects that were open, the last one first, at most 20. Some may be gone by now.
    pub fn recent(&self) -> Vec<PathBuf> {
        self.state().unwrap_or_default().recent
    }

    fn state_file(&self) -> Option<PathBuf> {
        self.dir.as_ref().map(|dir| dir.join("state.ron"))
    }

    /// What is remembered; nothing where there is no file.
    ///
    /// # Errors
    /// What is wrong with the file, in a few words.
    fn state(&self) -> Result<State, String> {
        let Some(file) = self.state_file() else { return Ok(State::default()) };
        match read_within(&file, LARGEST_OWN_FILE) {
            Ok(bytes) => known(&bytes)
                .map_err(|()| format!("{} cannot be read and begins anew", file.display())),
            Err(error) if error.cause == Cause::NotFound => Ok(State::default()),
            Err(error) => Err(error.in_one_line()),
        }
    }
}

/// What a file of the program's own holds, as far as this version knows it.
pub(super) fn known<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, ()> {
    if bytes.len() as u64 > LARGEST_OWN_FILE {
        return Err(());
    }
    let text = std::str::from_utf8(bytes).map_err(|_| ())?;
    let tree = parser::parse(text).map_err(|_| ())?;
    read::what_is_known(text, &tree.root).ok_or(())
}

/// What is said of a project that cannot be opened at the start.
fn passed_over(path: &Path, error: &LoadError) -> String {
    let why = error.faults.first().map_or("", |f| f.problem.message.as_str());
    format!("The last project, {}: {why}.", path.display())
}

impl FirstProject {
    /// The sample in no file, for a start on which nothing else can be shown.
    ///
    /// # Errors
    /// Never but for a fault in the sample.
    pub(crate) fn sample(why: &str) -> Result<FirstProject, LoadError> {
        unsaved(None, why)
    }
}

/// A path as it was typed: `~` at its beginning is the home directory, as a shell would have it. Where
/// there is none, and for `~name`, the path stays.
pub(crate) fn typed_path(path: &Path) -> PathBuf {
    let mut parts = path.components();
    if parts.next() == Some(Component::Normal("~".as_ref()))
        && let Some(dirs) = directories::BaseDirs::new()
    {
        return dirs.home_dir().join(parts.as_path());
    }
    path.to_path_buf()
}

/// The sample in no file.
fn unsaved(note: Option<String>, why: &str) -> Result<FirstProject, LoadError> {
    let mut said = note.map(|n| n + " ").unwrap_or_default();
    said.push_str(why.trim_end_matches('.'));
    said.push_str(": this is the sample, kept nowhere until you save it under a name.");
    Ok(FirstProject { opened: document::parse(SAMPLE, SAMPLE_NAME)?, note: Some(said) })
}
