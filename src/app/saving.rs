//! Saving, and quitting and opening another project, which wait for what is being written.

use super::file_work::Then;
use super::message::{Command, SaveFailure, Saved};
use super::status::Status;
use super::{App, Mode};
use crate::project::Holder;
use crate::project::schema::Project;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What follows from another session's holding the file.
pub(crate) const READS_ONLY: &str = "read only; :own takes it over";

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

    /// Files take so long, s: nobody need wait for them.
    pub(super) fn still_at_files(&mut self, seconds: u64) {
        let what = match (self.files.saving(), self.files.writing()) {
            (true, _) => "saving",
            (false, true) => "writing",
            // What is read can be left alone, and what has ended meanwhile was told.
            (false, false) => return,
        };
        let quitting = match self.files.waits_to_quit() {
            true => "asked again it quits at once",
            false => "the edits are kept, quitting is possible",
        };
        self.inform(format!("still {what}, {seconds} s; {quitting}"));
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
                vec![Command::DropKept]
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
            Mode::ConfirmOverwrite { path, then, .. } => {
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
                self.files.set_holder(None);
                self.files.set_changed(false);
                self.go_on()
            }
            Err(failure) => {
                let then = self.files.take_what_waits();
                // A text that is being typed is not taken away; saving again asks again.
                let (why, path) = (failure.message.clone(), failure.path);
                let own = path.is_none();
                let free = !matches!(self.screen.mode(), Mode::Entry(_));
                if failure.holder.is_some() && free {
                    self.screen.show(Mode::ConfirmTakeOver { why, path, then });
                } else if failure.overwrite_helps && free {
                    self.screen.show(Mode::ConfirmOverwrite { why, path, then });
                }
                if failure.holder.is_some() && own {
                    self.files.set_holder(failure.holder);
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
    pub(super) fn restore(&mut self) -> Vec<Command> {
        match self.screen.take() {
            Mode::ConfirmRecovery { kept } => {
                self.editor.restore(&kept.project);
                self.inform("the kept edits are back, not saved yet; u undoes this");
                vec![Command::TakeKept]
            }
            other => {
                self.screen.show(other);
                Vec::new()
            }
        }
    }

    /// The file is taken over from the session that holds it, and saved.
    pub(super) fn take_over(&mut self) -> Vec<Command> {
        match self.screen.take() {
            Mode::ConfirmTakeOver { path, then, .. } => {
                let save = self.save(path.clone(), false);
                if let Some(then) = then.filter(|_| !save.is_empty()) {
                    self.files.wait(then);
                }
                let first = (!save.is_empty()).then_some(Command::TakeFile { path });
                first.into_iter().chain(save).collect()
            }
            other => {
                self.screen.show(other);
                Vec::new()
            }
        }
    }

    /// The file is taken over from the session that holds it.
    pub(super) fn take_file(&mut self) -> Vec<Command> {
        match self.files.holder() {
            Some(_) => vec![Command::TakeFile { path: None }],
            None => {
                self.inform("no other session is known to hold this file");
                Vec::new()
            }
        }
    }

    /// Another session holds the file, or none does.
    pub(super) fn held(&mut self, holder: Option<Holder>) {
        let said = match &holder {
            Some(holder) => Status::error(format!("held by {}; {READS_ONLY}", holder.text())),
            None => Status::info("the file is this session's now"),
        };
        if self.files.set_holder(holder.clone()) != holder {
            self.screen.say(said);
        }
    }

    /// The file on disk is another one than was last read or written, or not any more.
    pub(super) fn changed(&mut self, changed: bool) {
        if changed {
            self.inform("the file was changed on disk by something else; :reload reads it anew");
        }
        self.files.set_changed(changed);
    }

    /// The file is read anew, as another program left it; unsaved edits are asked about, unless that
    /// was the question.
    pub(super) fn reload(&mut self) -> Vec<Command> {
        let asked = matches!(self.screen.mode(), Mode::ConfirmOverwrite { .. });
        match (self.editor.path().map(Path::to_path_buf), self.screen.mode()) {
            (None, _) => {
                self.complain("this project has no file yet");
                Vec::new()
            }
            (_, Mode::ConfirmOverwrite { path: Some(_), .. }) => {
                self.complain("that is another file; :open PATH opens it");
                Vec::new()
            }
            (Some(path), _) if asked => {
                self.screen.show(Mode::Main);
                self.open(path)
            }
            (Some(path), _) => self.ask_to_open(&path),
        }
    }
}
