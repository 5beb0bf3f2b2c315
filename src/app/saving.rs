//! Saving, and quitting and opening another project, which wait for what is being written.

use super::file_work::Then;
use super::message::{Command, SaveFailure, Saved};
use super::{App, Mode};
use crate::project::schema::Project;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl App {
    /// Saves, to the project's own file or to another one.
    pub(super) fn save(&mut self, path: Option<PathBuf>, overwrite: bool) -> Vec<Command> {
        if self.opening_holds() {
            return Vec::new();
        }
        vec![Command::Save { project: self.project().clone(), path, overwrite }]
    }

    /// Whether another project is being read, so that nothing may be written beside the present one;
    /// then that is said.
    pub(super) fn opening_holds(&mut self) -> bool {
        let Some(path) = self.files.opening() else { return false };
        let text = format!("{} is being opened; wait for it", path.display());
        self.complain(text);
        true
    }

    /// Saves, and then does something else if the save goes well.
    fn save_and(&mut self, then: Then) -> Vec<Command> {
        let commands = match self.files.saves(self.editor.project()) {
            true => Vec::new(),
            false => self.save(None, false),
        };
        if !commands.is_empty() || self.files.writing() {
            self.files.wait(then);
        }
        commands
    }

    /// Quits, unless edits are unsaved: then it asks.
    pub(super) fn ask_to_quit(&mut self) -> Vec<Command> {
        if self.edited() && !self.files.saves(self.editor.project()) {
            self.screen.show(Mode::ConfirmQuit);
            return Vec::new();
        }
        self.quit(None)
    }

    /// Quits when all that was asked to be written is written; asked again, at once.
    pub(super) fn quit(&mut self, discarded: Option<Arc<Project>>) -> Vec<Command> {
        if self.files.writing() && !self.files.waits_to_quit() {
            self.files.wait(Then::Quit { discarded });
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
        self.screen.show(Mode::Main);
        match self.edited() {
            true => self.save_and(Then::Quit { discarded: None }),
            false => self.quit(None),
        }
    }

    /// The question before opening was answered: save first.
    pub(super) fn save_and_open(&mut self) -> Vec<Command> {
        match self.screen.take() {
            Mode::ConfirmOpen { path } => self.save_and(Then::Open(path)),
            other => {
                self.screen.show(other);
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
        if self.files.saves(self.editor.project()) {
            self.files.wait(Then::Open(path));
        } else {
            self.screen.show(Mode::ConfirmOpen { path });
        }
        Vec::new()
    }

    fn open(&mut self, path: PathBuf) -> Vec<Command> {
        self.files.open(path.clone(), self.project().clone());
        vec![Command::OpenProject { path }]
    }

    /// The edits in question are let go.
    pub(super) fn discard(&mut self) -> Vec<Command> {
        match self.screen.take() {
            Mode::ConfirmQuit => self.quit(Some(self.project().clone())),
            // The edits stay where they are until the other project is open.
            Mode::ConfirmOpen { path } => self.open(path),
            Mode::ConfirmRecovery { .. } => {
                self.inform("the kept edits were dropped");
                vec![Command::ForgetRecovery]
            }
            other => {
                self.screen.show(other);
                Vec::new()
            }
        }
    }

    /// The file that is there is replaced.
    pub(super) fn overwrite(&mut self) -> Vec<Command> {
        match self.screen.take() {
            Mode::ConfirmOverwrite { path, then } => {
                let commands = self.save(path, true);
                if let Some(then) = then.filter(|_| !commands.is_empty()) {
                    self.files.wait(then);
                }
                commands
            }
            other => {
                self.screen.show(other);
                Vec::new()
            }
        }
    }

    /// A save has ended.
    pub(super) fn saved(&mut self, result: Result<Saved, SaveFailure>) -> Vec<Command> {
        self.files.saved();
        match result {
            Ok(saved) => {
                let name = saved.path.display().to_string();
                self.inform(match saved.note {
                    Some(note) => format!("saved {name}; {note}"),
                    None => format!("saved {name}"),
                });
                self.editor.saved(saved.project, saved.path);
                self.go_on()
            }
            Err(failure) => {
                let then = self.files.take_what_waits();
                // A text that is being typed is not taken away; saving again asks again.
                if failure.overwrite_helps && !matches!(self.screen.mode(), Mode::Entry(_)) {
                    self.screen.show(Mode::ConfirmOverwrite { path: failure.path, then });
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
            Some(Then::Quit { discarded: Some(of) }) if Arc::ptr_eq(&of, self.project()) => {
                self.quit(Some(of))
            }
            Some(Then::Quit { .. }) => self.ask_to_quit(),
            Some(Then::Open(path)) => self.ask_to_open(&path),
            None => Vec::new(),
        }
    }

    /// Edits kept from a lost session are taken back.
    pub(super) fn restore(&mut self) {
        match self.screen.take() {
            Mode::ConfirmRecovery { kept } => {
                self.editor.restore(&kept);
                self.inform("the kept edits are back, not saved yet; u undoes this");
            }
            other => self.screen.show(other),
        }
    }
}
