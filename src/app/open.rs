//! Opening another project: the list with its text line, the question before edits would be lost,
//! and the change to what was opened.

use super::entry::{EditTarget, LineEntry};
use super::fuzzy;
use super::history::History;
use super::key::Key;
use super::message::{Command, FoundProject, OpenFailure, OpenedProject};
use super::{App, Mode};
use crate::case::Input;
use std::path::Path;
use std::sync::Arc;

/// The screen that asks which project to open.
#[derive(Debug, Clone)]
pub struct Picker {
    /// The letters typed.
    pub(crate) entry: LineEntry,
    /// What there is; nothing until it was found.
    pub(crate) found: Vec<FoundProject>,
    /// The marked one, an index of [`Picker::matches`].
    pub(crate) index: usize,
    /// Why the last one could not be opened.
    pub(crate) error: Option<String>,
}

impl Picker {
    fn new(error: Option<String>) -> Picker {
        let entry = LineEntry::new(EditTarget::File, "");
        Picker { entry, found: Vec::new(), index: 0, error }
    }

    /// What fits the letters typed, the best first; all, in their order, where nothing is typed.
    pub(crate) fn matches(&self) -> Vec<&FoundProject> {
        let typed = self.entry.text();
        let fits = self.found.iter().filter_map(|f| Some((fuzzy::score(typed, &f.shown)?, f)));
        let mut fits: Vec<(i64, &FoundProject)> = fits.collect();
        if !typed.trim().is_empty() {
            fits.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
        }
        fits.into_iter().map(|(_, f)| f).collect()
    }

    /// Marks the first one worth it: not gone, and not the one that is open.
    fn mark_first(&mut self) {
        let matches = self.matches();
        let open = |f: &&FoundProject| !f.missing && !f.current;
        let first = matches.iter().position(open);
        self.index = first.or(matches.iter().position(|f| !f.missing)).unwrap_or(0);
    }

    /// Moves the mark; what is gone is passed over.
    fn step(&mut self, lines: isize) {
        let there: Vec<bool> = self.matches().iter().map(|f| !f.missing).collect();
        let target = self.index.saturating_add_signed(lines).min(there.len().saturating_sub(1));
        let mut ahead: Box<dyn Iterator<Item = usize>> =
            if lines > 0 { Box::new(target..there.len()) } else { Box::new((0..=target).rev()) };
        if let Some(next) = ahead.find(|i| there.get(*i) == Some(&true)) {
            self.index = next;
        }
    }

    /// A key that is part of the text.
    pub(super) fn key(&mut self, key: Key) {
        let before = self.entry.text().to_string();
        self.entry.key(key);
        if self.entry.text() != before {
            self.error = None;
            self.mark_first();
        }
    }

    /// Pasted text.
    pub(super) fn paste(&mut self, text: &str) {
        self.entry.paste(text);
        self.mark_first();
    }
}

impl App {
    /// Shows the list of projects and asks for them.
    pub(super) fn show_picker(&mut self, error: Option<String>) -> Vec<Command> {
        self.mode = Mode::Open(Picker::new(error));
        vec![Command::ListProjects]
    }

    /// The projects were found.
    pub(super) fn found_projects(&mut self, found: Vec<FoundProject>) {
        if let Mode::Open(picker) = &mut self.mode {
            picker.found = found;
            picker.mark_first();
        }
    }

    /// Moves the mark of the list.
    pub(super) fn step_picker(&mut self, lines: isize) {
        if let Mode::Open(picker) = &mut self.mode {
            picker.step(lines);
        }
    }

    /// Enter in the list: the marked one, or where nothing fits the text as a path.
    pub(super) fn take_project(&mut self) -> Vec<Command> {
        let Mode::Open(picker) = &self.mode else { return Vec::new() };
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
        let Some(opening) = self.files.opened() else { return Vec::new() };
        match result {
            // Edits made meanwhile were not asked about.
            Ok(_) if self.edited() && !Arc::ptr_eq(&opening.of, &self.project) => {
                self.mode = Mode::ConfirmOpen { path: opening.path };
                Vec::new()
            }
            Ok(opened) => {
                let stop = self.forget_work();
                self.adopt(opened);
                stop.into_iter().chain([Command::TakeOver]).collect()
            }
            Err(failure) => match &mut self.mode {
                Mode::Open(picker) => {
                    picker.error = Some(failure.message);
                    Vec::new()
                }
                Mode::Main => self.show_picker(Some(failure.message)),
                _ => {
                    self.complain(failure.message.lines().next().unwrap_or("it cannot be opened"));
                    Vec::new()
                }
            },
        }
    }

    /// Goes on with another project; nothing of the former one is left.
    fn adopt(&mut self, opened: OpenedProject) {
        let name = opened.path.display().to_string();
        self.saved = opened.project.clone();
        self.project = opened.project;
        self.path = Some(opened.path);
        self.history = History::default();
        self.selected = 0;
        self.field = Input::Plate;
        self.units = self.settings.units;
        self.files.drop_what_waits();
        self.mode = match opened.kept {
            Some(kept) => Mode::ConfirmRecovery { kept },
            None => Mode::Main,
        };
        self.inform(opened.note.unwrap_or_else(|| format!("opened {name}")));
        self.derive();
    }
}
