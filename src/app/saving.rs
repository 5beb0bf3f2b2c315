//! Files that are read and written behind the screen, and what waits for them: quitting and opening
//! another project wait for the save that was asked for.

use super::message::{Command, SaveFailure, Saved};
use super::{App, Mode};
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
}

impl FileWork {
    /// Notes what is asked for.
    pub(super) fn note(&mut self, commands: &[Command]) {
        for command in commands {
            match command {
                Command::Save { project, .. } => self.saves.push_back(project.clone()),
                Command::Export { .. } | Command::KeepSettings { .. } => self.others += 1,
                Command::OpenProject { .. } => self.opens += 1,
                _ => {}
            }
        }
    }

    /// Whether the last save that was asked for is of this very project and has not ended.
    fn saves(&self, project: &Arc<Project>) -> bool {
        self.saves.back().is_some_and(|last| Arc::ptr_eq(last, project))
    }

    fn writing(&self) -> bool {
        !self.saves.is_empty() || self.others > 0
    }

    /// A file that is no project was written; a failure drops what waited.
    pub(super) fn written(&mut self, well: bool) {
        self.others = self.others.saturating_sub(1);
        if !well {
            self.drop_what_waits();
        }
    }

    /// What waited and need not wait any more.
    fn due(&mut self) -> Option<Then> {
        let ready = match &self.then {
            Some(Then::Quit { .. }) => !self.writing(),
            Some(Then::Open(_)) => self.saves.is_empty(),
            None => false,
        };
        self.then.take_if(|_| ready)
    }

    /// A project was read, or could not be: what was wanted of it, unless something else is by now.
    pub(super) fn opened(&mut self) -> Option<Opening> {
        self.opens = self.opens.saturating_sub(1);
        self.opening.take_if(|_| self.opens == 0)
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

impl App {
    /// Saves, to the project's own file or to another one.
    pub(super) fn save(&mut self, path: Option<PathBuf>, overwrite: bool) -> Vec<Command> {
        if self.opening_holds() {
            return Vec::new();
        }
        vec![Command::Save { project: self.project.clone(), path, overwrite }]
    }

    /// Whether another project is being read, so that nothing may be written beside the present one;
    /// then that is said.
    pub(super) fn opening_holds(&mut self) -> bool {
        let Some(opening) = &self.files.opening else { return false };
        let text = format!("{} is being opened; wait for it", opening.path.display());
        self.complain(text);
        true
    }

    /// Saves, and then does something else if the save goes well.
    fn save_and(&mut self, then: Then) -> Vec<Command> {
        let commands = match self.files.saves(&self.project) {
            true => Vec::new(),
            false => self.save(None, false),
        };
        if !commands.is_empty() || self.files.writing() {
            self.files.then = Some(then);
        }
        commands
    }

    /// Quits, unless edits are unsaved: then it asks.
    pub(super) fn ask_to_quit(&mut self) -> Vec<Command> {
        if self.edited() && !self.files.saves(&self.project) {
            self.mode = Mode::ConfirmQuit;
            return Vec::new();
        }
        self.quit(None)
    }

    /// Quits when all that was asked to be written is written; asked again, at once.
    pub(super) fn quit(&mut self, discarded: Option<Arc<Project>>) -> Vec<Command> {
        let waits = matches!(self.files.then, Some(Then::Quit { .. }));
        if self.files.writing() && !waits {
            self.files.then = Some(Then::Quit { discarded });
            self.inform("still writing, then it quits; asked again it quits at once");
            return Vec::new();
        }
        let last = match discarded {
            Some(_) => Some(Command::ForgetRecovery),
            None => self.unsaved().map(|project| Command::Recover { project }),
        };
        last.into_iter().chain([Command::Quit]).collect()
    }

    /// Saves what is unsaved and quits.
    pub(super) fn save_and_quit(&mut self) -> Vec<Command> {
        self.mode = Mode::Main;
        match self.edited() {
            true => self.save_and(Then::Quit { discarded: None }),
            false => self.quit(None),
        }
    }

    /// The question before opening was answered: save first.
    pub(super) fn save_and_open(&mut self) -> Vec<Command> {
        match std::mem::replace(&mut self.mode, Mode::Main) {
            Mode::ConfirmOpen { path } => self.save_and(Then::Open(path)),
            other => {
                self.mode = other;
                Vec::new()
            }
        }
    }

    /// Opens a project; unsaved edits are asked about first.
    pub(super) fn ask_to_open(&mut self, path: &Path) -> Vec<Command> {
        let path = path.to_path_buf();
        if !self.edited() {
            return self.open(path);
        }
        if self.files.saves(&self.project) {
            self.files.then = Some(Then::Open(path));
        } else {
            self.mode = Mode::ConfirmOpen { path };
        }
        Vec::new()
    }

    fn open(&mut self, path: PathBuf) -> Vec<Command> {
        self.files.opening = Some(Opening { path: path.clone(), of: self.project.clone() });
        vec![Command::OpenProject { path }]
    }

    /// The edits in question are let go.
    pub(super) fn discard(&mut self) -> Vec<Command> {
        match std::mem::replace(&mut self.mode, Mode::Main) {
            Mode::ConfirmQuit => self.quit(Some(self.project.clone())),
            // The edits stay where they are until the other project is open.
            Mode::ConfirmOpen { path } => self.open(path),
            Mode::ConfirmRecovery { .. } => {
                self.inform("the kept edits were dropped");
                vec![Command::ForgetRecovery]
            }
            other => {
                self.mode = other;
                Vec::new()
            }
        }
    }

    /// The file that is there is replaced.
    pub(super) fn overwrite(&mut self) -> Vec<Command> {
        match std::mem::replace(&mut self.mode, Mode::Main) {
            Mode::ConfirmOverwrite { path, then } => {
                let commands = self.save(path, true);
                self.files.then = then.filter(|_| !commands.is_empty());
                commands
            }
            other => {
                self.mode = other;
                Vec::new()
            }
        }
    }

    /// A save has ended.
    pub(super) fn saved(&mut self, result: Result<Saved, SaveFailure>) -> Vec<Command> {
        self.files.saves.pop_front();
        match result {
            Ok(saved) => {
                self.saved = saved.project;
                let name = saved.path.display().to_string();
                self.inform(match saved.note {
                    Some(note) => format!("saved {name}; {note}"),
                    None => format!("saved {name}"),
                });
                self.path = Some(saved.path);
                self.go_on()
            }
            Err(failure) => {
                let then = self.files.then.take();
                // A text that is being typed is not taken away; saving again asks again.
                if failure.overwrite_helps && !matches!(self.mode, Mode::Entry(_)) {
                    self.mode = Mode::ConfirmOverwrite { path: failure.path, then };
                }
                self.complain(failure.message);
                Vec::new()
            }
        }
    }

    /// Does what waited for something to be written, once it is. Edits made meanwhile are in no file,
    /// and are asked about.
    pub(super) fn go_on(&mut self) -> Vec<Command> {
        match self.files.due() {
            Some(Then::Quit { discarded: Some(of) }) if Arc::ptr_eq(&of, &self.project) => {
                self.quit(Some(of))
            }
            Some(Then::Quit { .. }) => self.ask_to_quit(),
            Some(Then::Open(path)) => self.ask_to_open(&path),
            None => Vec::new(),
        }
    }
}
