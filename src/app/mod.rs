//! The state of the interactive program: what it holds, what a key does to it, undo. No input or
//! output happens here; [`message`] says what comes in and what is asked to be done.
//!
//! - [`keymap`]: which key means what where.
//! - [`update`]: what each message does; [`edit`]: edits of the list of layouts; [`entry`]: the line
//!   of text being typed; [`command`]: the `:` line; [`history`]: undo and redo.
//! - [`pasted`]: what comes from a clipboard, marked as such or not.
//! - [`checks`]: checks by simulation: what runs, which results there are, whether they are stale.
//! - [`studies`]: the pages of studies and the checks behind them.
//! - [`settings`]: what the user decided for all projects; [`open`]: opening another project, found
//!   by typed letters ([`fuzzy`]); [`copy`]: what goes to the clipboard; [`tour`]: the first run.
//! - [`derived`]: forecast and design answer of every layout, made anew after each edit.

pub mod checks;
pub(crate) mod command;
pub(crate) mod copy;
pub(crate) mod derived;
pub(crate) mod edit;
pub(crate) mod entry;
pub(crate) mod fuzzy;
pub(crate) mod history;
pub mod key;
pub mod keymap;
pub mod look;
pub mod message;
pub mod open;
pub(crate) mod output;
pub(crate) mod pages;
pub(crate) mod pasted;
pub(crate) mod saving;
pub mod settings;
pub(crate) mod studies;
pub mod tour;
pub(crate) mod update;

use crate::case::Input;
use crate::project::schema::{NamedLayout, Project};
use crate::units::LengthUnit;
use checks::Work;
use derived::LayoutResult;
use entry::LineEntry;
use history::{History, HistoryStep};
use keymap::Context;
use look::Look;
use saving::{FileWork, Then};
use settings::{Preferences, Settings};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use studies::Studies;

/// What lies over the main screen.
#[derive(Debug, Clone)]
pub enum Mode {
    /// Nothing.
    Main,
    /// A line of text is being typed.
    Entry(LineEntry),
    /// The help, scrolled down by so many lines.
    Help {
        /// First line shown.
        scroll: usize,
    },
    /// All warnings and numbers of the selected layout.
    Details {
        /// First line shown.
        scroll: usize,
    },
    /// The list of meshes with one marked.
    MeshPicker {
        /// The marked one, an index of [`App::meshes`].
        index: usize,
    },
    /// The list of what can be written, with one marked.
    Export {
        /// The marked one, an index of [`crate::export::ExportKind::ALL`].
        index: usize,
    },
    /// Quit with unsaved edits?
    ConfirmQuit,
    /// Replace a file that changed on disk, or that exists?
    ConfirmOverwrite {
        /// The other file to save to, or the project's own.
        path: Option<PathBuf>,
        /// What was to follow the save.
        then: Option<Then>,
    },
    /// The list of settings with one marked.
    Settings {
        /// The marked one, an index of [`settings::SettingItem::ALL`].
        index: usize,
    },
    /// Which project to open.
    Open(open::Picker),
    /// Open another project with unsaved edits in this one?
    ConfirmOpen {
        /// The other project's file.
        path: PathBuf,
    },
    /// A screen of the tour.
    Tour {
        /// Which one, an index of [`tour::stops`].
        stop: usize,
    },
    /// A page of a study.
    Study(keymap::StudyPage),
    /// Take back edits kept from a session that was cut off?
    ConfirmRecovery {
        /// The kept project.
        kept: Arc<Project>,
    },
}

impl Mode {
    /// The screen whose keys hold now; none while text is typed.
    fn context(&self) -> Option<Context> {
        Some(match self {
            Mode::Main => Context::Main,
            Mode::Entry(_) => return None,
            Mode::Help { .. } | Mode::Details { .. } => Context::Pager,
            Mode::MeshPicker { .. } => Context::MeshPicker,
            Mode::Study(page) => page.context(),
            Mode::Export { .. } => Context::Export,
            Mode::ConfirmQuit => Context::ConfirmQuit,
            Mode::ConfirmOverwrite { .. } => Context::ConfirmOverwrite,
            Mode::ConfirmRecovery { .. } => Context::ConfirmRecovery,
            Mode::Settings { .. } => Context::Settings,
            Mode::Open(_) => Context::Open,
            Mode::ConfirmOpen { .. } => Context::ConfirmOpen,
            Mode::Tour { .. } => Context::Tour,
        })
    }
}

/// How loud a message is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Something went as asked.
    Info,
    /// Something was refused or failed.
    Error,
}

/// The message in the bottom line, until the next key.
#[derive(Debug, Clone, PartialEq)]
pub struct Status {
    /// How loud.
    pub level: Level,
    /// What it says.
    pub text: String,
}

/// The whole state.
#[derive(Debug)]
pub struct App {
    project: Arc<Project>,
    saved: Arc<Project>,
    path: Option<PathBuf>,
    history: History,
    selected: usize,
    field: Input,
    mode: Mode,
    status: Option<Status>,
    results: Vec<LayoutResult>,
    look: Look,
    /// A unit asked for on the command line: it is not the project's and never saved.
    units: Option<LengthUnit>,
    size: (u16, u16),
    dirty: bool,
    files: FileWork,
    /// What the help lies over; it comes back when the help is closed.
    under_help: Box<Mode>,
    work: Work,
    studies: Studies,
    preferences: Preferences,
    /// The settings that hold: the kept ones with the flags of this run over them.
    settings: Settings,
}

/// What a program starts with.
#[derive(Debug)]
pub struct Start {
    /// The project.
    pub project: Arc<Project>,
    /// Its file, if it has one.
    pub path: Option<PathBuf>,
    /// A first message, such as where the sample was copied to.
    pub note: Option<String>,
    /// Edits kept from a session that was cut off.
    pub kept: Option<Arc<Project>>,
    /// The look of the screen.
    pub look: Look,
    /// Unit of lengths asked for on the command line, over the project's own.
    pub units: Option<LengthUnit>,
    /// Columns and rows.
    pub size: (u16, u16),
    /// Settings, and where they come from.
    pub preferences: Preferences,
}

impl App {
    /// The state at the start.
    pub fn new(start: Start) -> App {
        let level = if start.preferences.trouble.is_some() { Level::Error } else { Level::Info };
        let mut app = App {
            saved: start.project.clone(),
            project: start.project,
            path: start.path,
            history: History::default(),
            selected: 0,
            field: Input::Plate,
            mode: Mode::Main,
            status: start.note.map(|text| Status { level, text }),
            results: Vec::new(),
            look: start.look,
            units: start.units,
            size: start.size,
            dirty: true,
            files: FileWork::default(),
            under_help: Box::new(Mode::Main),
            work: Work::default(),
            studies: Studies::default(),
            settings: start.preferences.effective(),
            preferences: start.preferences,
        };
        if let Some(kept) = start.kept {
            app.mode = Mode::ConfirmRecovery { kept };
        } else if app.preferences.tour {
            app.start_tour();
        }
        app.derive();
        app
    }

    /// The project as it stands.
    pub fn project(&self) -> &Arc<Project> {
        &self.project
    }

    /// Its file, if it has one.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether there are edits that are not saved.
    pub fn edited(&self) -> bool {
        !Arc::ptr_eq(&self.project, &self.saved) && *self.project != *self.saved
    }

    /// Index of the selected layout; there always is one.
    pub fn selected(&self) -> usize {
        self.selected
    }

    /// The selected layout.
    pub fn layout(&self) -> &NamedLayout {
        &self.project.layouts[self.selected]
    }

    /// The selected input.
    pub fn field(&self) -> Input {
        self.field
    }

    /// What lies over the main screen.
    pub fn mode(&self) -> &Mode {
        &self.mode
    }

    /// The message of the bottom line.
    pub fn status(&self) -> Option<&Status> {
        self.status.as_ref()
    }

    /// Forecast and design answer of each layout, in the order of the list.
    pub(crate) fn results(&self) -> &[LayoutResult] {
        &self.results
    }

    /// Forecast and design answer of the selected layout.
    pub fn result(&self) -> &LayoutResult {
        &self.results[self.selected]
    }

    /// The look of the screen.
    pub(crate) fn look(&self) -> Look {
        self.look
    }

    /// Unit of lengths on the screen.
    pub fn units(&self) -> LengthUnit {
        self.units.unwrap_or(self.project.display.length_unit)
    }

    /// Columns and rows of the terminal.
    pub fn size(&self) -> (u16, u16) {
        self.size
    }

    /// The history of edits.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The screen whose keys hold now; none while text is typed.
    pub(crate) fn context(&self) -> Option<Context> {
        self.mode.context()
    }

    /// Whether something was asked to be drawn since this was asked last.
    pub(crate) fn take_dirty(&mut self) -> bool {
        std::mem::take(&mut self.dirty)
    }

    /// The project, if it has edits that are not saved.
    pub fn unsaved(&self) -> Option<Arc<Project>> {
        self.edited().then(|| self.project.clone())
    }

    fn inform(&mut self, text: impl Into<String>) {
        self.status = Some(Status { level: Level::Info, text: text.into() });
    }

    fn complain(&mut self, text: impl Into<String>) {
        self.status = Some(Status { level: Level::Error, text: text.into() });
    }

    /// Makes the forecasts anew.
    fn derive(&mut self) {
        self.selected = self.selected.min(self.project.layouts.len().saturating_sub(1));
        self.results = derived::all(&self.project);
    }

    /// The present as a step of the history.
    fn step(&self, label: String) -> HistoryStep {
        HistoryStep {
            project: self.project.clone(),
            selected: self.selected,
            field: self.field,
            label,
        }
    }

    /// Makes an edit that can be undone. An edit that changes nothing leaves no trace.
    fn edit(&mut self, label: impl Into<String>, change: impl FnOnce(&mut Project)) {
        let mut project = (*self.project).clone();
        change(&mut project);
        if project != *self.project {
            let before = self.step(label.into());
            self.history.record(before);
            self.project = Arc::new(project);
            self.derive();
        }
    }

    fn undo(&mut self) {
        let (project, selected, field) = (self.project.clone(), self.selected, self.field);
        match self.history.undo(|label| HistoryStep { project, selected, field, label }) {
            Some(step) => {
                let left = self.history.undo_depth();
                self.inform(format!("undone: {} ({left} more)", step.label));
                self.go_to(step);
            }
            None => self.inform("nothing to undo"),
        }
    }

    fn redo(&mut self) {
        let (project, selected, field) = (self.project.clone(), self.selected, self.field);
        match self.history.redo(|label| HistoryStep { project, selected, field, label }) {
            Some(step) => {
                let left = self.history.redo_depth();
                self.inform(format!("redone: {} ({left} more)", step.label));
                self.go_to(step);
            }
            None => self.inform("nothing to redo"),
        }
    }

    fn go_to(&mut self, step: HistoryStep) {
        self.project = self.with_checks(step.project);
        self.selected = step.selected;
        self.field = step.field;
        self.derive();
    }
}
