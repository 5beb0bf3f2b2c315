//! Files that are read and written behind the screen, and what waits for them.

use super::message::Command;
use crate::project::Holder;
use crate::project::schema::Project;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What follows when nothing is being written any more.
#[derive(Debug, Clone)]
pub enum Then {
    /// The program ends.
    Quit {
        /// The edits that the user let go, as they were.
        discarded: Option<Arc<Project>>,
    },
    /// Another project is opened.
    Open(PathBuf),
}

/// A project that is being read.
#[derive(Debug)]
pub(super) struct Opening {
    /// Its file.
    pub(super) path: PathBuf,
    /// The present project as it was when that was asked for.
    pub(super) of: Arc<Project>,
}

/// What is being read and written.
#[derive(Debug, Default)]
pub(super) struct FileWork {
    /// The projects that are being saved, in the order in which that was asked for.
    saves: VecDeque<Arc<Project>>,
    /// Other files that are being written: exports, settings.
    others: usize,
    /// Projects that are being read, wanted or not.
    opens: usize,
    opening: Option<Opening>,
    then: Option<Then>,
    /// Who else holds the project's file.
    holder: Option<Holder>,
    /// Whether that is another one than was last read or written.
    changed: bool,
}

impl FileWork {
    /// Nothing is read or written; the project's file may be held by another session.
    pub(super) fn new(holder: Option<Holder>) -> FileWork {
        FileWork { holder, ..FileWork::default() }
    }

    /// Who else holds the project's file.
    pub(super) fn holder(&self) -> Option<&Holder> {
        self.holder.as_ref()
    }

    /// Another session holds the file, or none does; who held it before.
    pub(super) fn set_holder(&mut self, holder: Option<Holder>) -> Option<Holder> {
        std::mem::replace(&mut self.holder, holder)
    }

    /// Whether the file on disk is another one than was last read or written.
    pub(super) fn changed(&self) -> bool {
        self.changed
    }

    /// The file on disk is another one, or not any more.
    pub(super) fn set_changed(&mut self, changed: bool) {
        self.changed = changed;
    }

    /// Notes what is asked for.
    pub(super) fn note(&mut self, commands: &[Command]) {
        for command in commands {
            match command {
                Command::Save { project, .. } => self.saves.push_back(project.clone()),
                Command::Export { .. }
                | Command::KeepSettings { .. }
                | Command::KeepMesh { .. } => self.others += 1,
                Command::OpenProject { .. } => self.opens += 1,
                _ => {}
            }
        }
    }

    /// Whether the last save that was asked for is of this very project and has not ended.
    pub(super) fn saves(&self, project: &Arc<Project>) -> bool {
        self.saves.back().is_some_and(|last| Arc::ptr_eq(last, project))
    }

    /// Whether any project is being saved.
    pub(super) fn saving(&self) -> bool {
        !self.saves.is_empty()
    }

    /// Whether anything is being written.
    pub(super) fn writing(&self) -> bool {
        !self.saves.is_empty() || self.others > 0
    }

    /// The oldest save has ended.
    pub(super) fn saved(&mut self) {
        self.saves.pop_front();
    }

    /// A file that is no project was written; a failure drops what waited.
    pub(super) fn written(&mut self, well: bool) {
        self.others = self.others.saturating_sub(1);
        if !well {
            self.drop_what_waits();
        }
    }

    /// What waited and need not wait any more.
    pub(super) fn due(&mut self) -> Option<Then> {
        let ready = match &self.then {
            Some(Then::Quit { .. }) => !self.writing(),
            Some(Then::Open(_)) => self.saves.is_empty(),
            None => false,
        };
        self.then.take_if(|_| ready)
    }

    /// Something follows when nothing is being written any more.
    pub(super) fn wait(&mut self, then: Then) {
        self.then = Some(then);
    }

    /// Whether that is the end of the program.
    pub(super) fn waits_to_quit(&self) -> bool {
        matches!(self.then, Some(Then::Quit { .. }))
    }

    /// What waited is put off; it.
    pub(super) fn take_what_waits(&mut self) -> Option<Then> {
        self.then.take()
    }

    /// A project is read, with the present one as it is.
    pub(super) fn open(&mut self, path: PathBuf, of: Arc<Project>) {
        self.opening = Some(Opening { path, of });
    }

    /// The file of the project that is being read, if one is and is wanted.
    pub(super) fn opening(&self) -> Option<&Path> {
        self.opening.as_ref().map(|opening| opening.path.as_path())
    }

    /// A project was read, or could not be: what was wanted of it, unless something else is by now.
    pub(super) fn opened(&mut self) -> Option<Opening> {
        self.opens = self.opens.saturating_sub(1);
        self.opening.take_if(|_| self.opens == 0)
    }

    /// Whether a project is still being read, wanted or not.
    pub(super) fn reading(&self) -> bool {
        self.opens > 0
    }

    /// What waited is not wanted any more.
    pub(super) fn drop_what_waits(&mut self) {
        self.then = None;
    }

    /// The project that is being read is not wanted any more.
    pub(super) fn stop_opening(&mut self) {
        self.opening = None;
    }
}
