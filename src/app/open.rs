//! Opening another project: the list to choose from, and the change to what was opened.

use super::editor::Editor;
use super::message::{Command, OpenFailure, OpenedProject};
use super::picker::Picker;
use super::{App, Mode};
use std::path::Path;
use std::sync::Arc;

impl App {
    /// Shows the list of projects and asks for them.
    pub(super) fn show_picker(&mut self, error: Option<String>) -> Vec<Command> {
        self.screen.show(Mode::Open(Picker::new(error)));
        vec![Command::ListProjects]
    }

    /// Enter in the list: the marked one, or where nothing fits the text as a path.
    pub(super) fn take_project(&mut self) -> Vec<Command> {
        let Mode::Open(picker) = self.screen.mode() else { return Vec::new() };
        let typed = picker.entry.text().trim().to_string();
        match picker.matches().get(picker.index) {
            Some(found) if found.missing => {
                let gone = format!("{} is gone", found.shown);
                self.complain(gone);
                Vec::new()
            }
            Some(found) => {
                let path = found.path.clone();
                self.ask_to_open(&path)
            }
            None if typed.is_empty() => Vec::new(),
            None => self.ask_to_open(Path::new(&typed)),
        }
    }

    /// A project was read, or could not be: then all stays, with the reason.
    pub(super) fn opened(&mut self, result: Result<OpenedProject, OpenFailure>) -> Vec<Command> {
        let Some(opening) = self.files.opened() else {
            // A later one may be there already, and is not to be let go.
            return if self.files.reading() { Vec::new() } else { vec![Command::LetGo] };
        };
        match result {
            // Edits made meanwhile were not asked about.
            Ok(_) if self.edited() && !Arc::ptr_eq(&opening.of, self.project()) => {
                self.screen.show(Mode::ConfirmOpen { path: opening.path });
                vec![Command::LetGo]
            }
            Ok(opened) => {
                let stop = self.work.forget();
                self.adopt(opened);
                stop.into_iter().chain([Command::TakeOver]).collect()
            }
            Err(failure) => {
                if let Some(picker) = self.screen.picker() {
                    picker.refuse(failure.message);
                } else if let Mode::Main = self.screen.mode() {
                    return self.show_picker(Some(failure.message));
                } else {
                    self.complain(failure.message.lines().next().unwrap_or("it cannot be opened"));
                }
                Vec::new()
            }
        }
    }

    /// Goes on with another project; nothing of the former one is left.
    fn adopt(&mut self, opened: OpenedProject) {
        let OpenedProject { project, path, note, kept, holder } = opened;
        let said = note.unwrap_or_else(|| format!("opened {}", path.display()));
        // The same file read anew is looked at where it was left.
        let again = self.path() == Some(path.as_path());
        let left = again.then(|| (self.layout().name.clone(), self.field()));
        let own = self.editor.take_offered();
        self.editor = Editor::new(project, Some(path), self.settings().chosen_units());
        self.editor.offer(own);
        if let Some((name, field)) = left {
            let same = self.editor.layouts().iter().position(|l| l.name == name);
            self.editor.select(same.unwrap_or(0));
            self.editor.select_field(field);
        }
        self.files.set_holder(holder);
        self.files.set_changed(false);
        self.files.drop_what_waits();
        self.screen.show(kept.map_or(Mode::Main, |kept| Mode::ConfirmRecovery { kept }));
        self.inform(said);
    }
}
