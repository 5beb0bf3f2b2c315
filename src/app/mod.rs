//! The state of the interactive program: what it holds, what a key does to it, undo. No input or
//! output happens here; [`message`] says what comes in and what is asked to be done.
//!
//! The state has parts, each with fields of its own that nobody else writes:
//!
//! - [`editor`]: the project, its history and what follows from it, and what is selected.
//! - [`work`]: checks behind the screen, what runs and which results there are; [`studies`]: the pages.
//! - [`screen`]: what lies over the main screen, and what the bottom line says.
//! - [`settings`]: what the user decided for all projects; [`file_work`]: files being read and written.
//!
//! [`App`] puts them together. What a message does to them stands in [`update`], with [`command`] for the
//! `:` line, [`pasted`], [`saving`], [`open`], [`output`], [`checking`], [`copy`], [`method_naming`] and [`tour`]; the texts
//! of help and details in [`pages`]. [`keymap`] says which key means what where, [`entry`] is the line of
//! text being typed, [`picker`] the list of projects, searched by [`fuzzy`]; [`mesh_form`]
//! and [`mesh_adding`] add a mesh, [`adopt_form`] and [`adopting`] adopt one from its tests.

mod adopt_form;
mod adopting;
mod campaigning;
mod checking;
pub(crate) mod command;
pub(crate) mod copy;
pub(crate) mod derived;
mod editor;
pub(crate) mod entry;
mod file_work;
mod find;
mod fuzzy;
pub mod key;
pub mod keymap;
pub mod look;
mod mesh_adding;
pub(crate) mod mesh_form;
pub mod message;
mod method_naming;
mod open;
mod output;
pub(crate) mod pages;
mod pasted;
pub(crate) mod picker;
pub(crate) mod saving;
mod screen;
pub mod settings;
mod status;
pub(crate) mod studies;
pub mod tour;
mod update;
pub mod work;

pub use screen::Mode;
pub use status::{Level, Status};

use crate::case::Input;
use crate::curve::Point;
use crate::project::Holder;
use crate::project::schema::{NamedLayout, Project};
use crate::study::result::Wanted;
use crate::study::result::remade::Former;
use crate::units::{ChosenUnits, Units};
use derived::LayoutResult;
use editor::{Editor, History, MeshChoice};
use entry::Slot;
use file_work::FileWork;
use keymap::{Context, StudyPage};
use look::Look;
use message::{Command, KeptEdits};
use screen::Screen;
use settings::preferences::Choices;
use settings::{Preferences, Settings};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use studies::Studies;
use studies::compare::{ColumnHead, CompareView};
use studies::design::DesignView;
use studies::sensitivity::SensitivityView;
use studies::sweep::SweepView;
use studies::tolerance::ToleranceView;
use work::campaign::RunningCampaign;
use work::shown::ShownCheck;
use work::steps::RunningSteps;
use work::{RunningCheck, Work};

/// The whole state.
#[derive(Debug)]
pub struct App {
    editor: Editor,
    work: Work,
    studies: Studies,
    screen: Screen,
    choices: Choices,
    files: FileWork,
}

/// What a program starts with.
#[derive(Debug)]
pub struct Start {
    /// What its file holds, without kept edits.
    pub project: Arc<Project>,
    /// Its file, if it has one.
    pub path: Option<PathBuf>,
    /// A first message, such as where the sample was copied to.
    pub note: Option<String>,
    /// Edits kept from a session that was cut off.
    pub kept: Option<KeptEdits>,
    /// Who else holds the file.
    pub holder: Option<Holder>,
    /// The look of the screen.
    pub look: Look,
    /// Unit of lengths asked for on the command line, over the project's own.
    pub units: ChosenUnits,
    /// Columns and rows.
    pub size: (u16, u16),
    /// Settings, and where they come from.
    pub preferences: Preferences,
}

impl Start {
    /// A project in no file, on a screen of 80 columns and 24 rows, with settings as they come.
    pub(crate) fn of(project: Project) -> Start {
        Start {
            project: Arc::new(project),
            path: None,
            note: None,
            kept: None,
            holder: None,
            look: Look::default(),
            units: ChosenUnits::default(),
            size: (80, 24),
            preferences: Preferences::default(),
        }
    }
}

impl App {
    /// The state at the start.
    pub fn new(start: Start) -> App {
        let trouble = start.preferences.trouble.is_some();
        let status = start.note.map(if trouble { Status::error } else { Status::info });
        let mut app = App {
            editor: Editor::new(start.project, start.path, start.units),
            work: Work::default(),
            studies: Studies::default(),
            screen: Screen::new(start.look, start.size, status),
            choices: Choices::new(start.preferences),
            files: FileWork::new(start.holder),
        };
        if let Some(kept) = start.kept {
            app.screen.show(Mode::ConfirmRecovery { kept });
        } else if app.preferences().tour {
            app.start_tour();
        }
        app
    }

    fn inform(&mut self, text: impl Into<String>) {
        self.screen.say(Status::info(text));
    }

    fn complain(&mut self, text: impl Into<String>) {
        self.screen.say(Status::error(text));
    }

    /// Says how something went.
    fn tell(&mut self, said: Result<String, String>) {
        self.screen.say(said.map_or_else(Status::error, Status::info));
    }

    fn undo(&mut self) {
        let said = self.editor.undo();
        self.inform(said);
    }

    fn redo(&mut self) {
        let said = self.editor.redo();
        self.inform(said);
    }

    /// A live check, if one should follow what was done.
    fn follow_edit(&mut self) -> Option<Command> {
        if self.live() { self.work.follow_edit(&self.editor) } else { None }
    }

    /// Makes what the open page shows anew.
    fn follow_page(&mut self) {
        if let Some(page) = self.screen.page() {
            let runs = self.choices.settings().runs;
            self.studies.follow(page, &self.editor, &self.work, runs);
        }
    }
}

/// The project.
impl App {
    /// The project as it stands.
    pub fn project(&self) -> &Arc<Project> {
        self.editor.project()
    }

    /// Its file, if it has one.
    pub fn path(&self) -> Option<&Path> {
        self.editor.path()
    }

    /// Who else holds the file, so that this session only reads it.
    pub fn holder(&self) -> Option<&Holder> {
        self.files.holder()
    }

    /// Whether the file on disk is another one than was last read or written.
    pub(crate) fn changed_on_disk(&self) -> bool {
        self.files.changed()
    }

    /// Whether there are edits that are not saved.
    pub fn edited(&self) -> bool {
        self.editor.edited()
    }

    /// The project, if it has edits that are not saved.
    pub fn unsaved(&self) -> Option<Arc<Project>> {
        self.edited().then(|| self.project().clone())
    }

    /// Whether the project has no layouts.
    pub(crate) fn empty(&self) -> bool {
        self.editor.empty()
    }

    /// Index of the selected layout; 0 where there is none.
    pub fn selected(&self) -> usize {
        self.editor.selected()
    }

    /// The selected layout; a stand-in that no screen shows where there is none.
    pub fn layout(&self) -> &NamedLayout {
        self.editor.layout()
    }

    /// The selected input.
    pub fn field(&self) -> Input {
        self.editor.field()
    }

    /// What follows from each layout, in the order of the list.
    pub(crate) fn results(&self) -> &[LayoutResult] {
        self.editor.results()
    }

    /// What follows from the selected layout.
    pub fn result(&self) -> &LayoutResult {
        self.editor.result()
    }

    /// Unit of lengths on the screen.
    pub fn units(&self) -> Units {
        self.editor.units()
    }

    /// The history of edits.
    pub fn history(&self) -> &History {
        self.editor.history()
    }

    /// The meshes to choose from: the project's own first, then the catalogue.
    pub(crate) fn meshes(&self) -> Vec<MeshChoice> {
        self.editor.meshes()
    }
}

/// The screen and the settings.
impl App {
    /// What lies over the main screen.
    pub fn mode(&self) -> &Mode {
        self.screen.mode()
    }

    /// The page of a study that is open, also while a text for it is typed.
    pub fn page_open(&self) -> Option<StudyPage> {
        self.screen.page()
    }

    /// The screen whose keys hold now; none while text is typed.
    pub(crate) fn context(&self) -> Option<Context> {
        match self.mode().context()? {
            Context::Main if self.editor.empty() => Some(Context::Empty),
            context => Some(context),
        }
    }

    /// The message of the bottom line.
    pub fn status(&self) -> Option<&Status> {
        self.screen.status()
    }

    /// The look of the screen.
    pub(crate) fn look(&self) -> Look {
        self.screen.look()
    }

    /// Columns and rows of the terminal.
    pub fn size(&self) -> (u16, u16) {
        self.screen.size()
    }

    /// Whether something was asked to be drawn since this was asked last.
    pub(crate) fn take_dirty(&mut self) -> bool {
        self.screen.take_dirty()
    }

    /// The settings that hold in this session, flags included.
    pub fn settings(&self) -> &Settings {
        self.choices.settings()
    }

    /// Where the settings come from.
    pub fn preferences(&self) -> &Preferences {
        self.choices.preferences()
    }
}

/// Checks.
impl App {
    /// Whether a quick check follows each edit.
    pub(crate) fn live(&self) -> bool {
        self.settings().live
    }

    /// The result of a layout that the project keeps, and whether it is current.
    pub fn kept_check(&self, index: usize) -> Option<ShownCheck<'_>> {
        self.work.kept(&self.editor, index)
    }

    /// The result to show for the selected layout.
    pub fn shown_check(&self) -> Option<ShownCheck<'_>> {
        self.work.shown(&self.editor, self.live())
    }

    /// What another solver or sampling had found of a layout that this session checked again.
    pub(crate) fn former(&self, uid: u64) -> Option<&Former> {
        self.work.former(uid)
    }

    /// Why there is no live result for the selected layout.
    pub(crate) fn live_refusal(&self) -> Option<&str> {
        self.work.live_refusal(self.layout().uid).filter(|_| self.live())
    }

    /// Whether a live check is under way.
    pub(crate) fn live_running(&self) -> bool {
        self.work.live_running()
    }

    /// The order of the user's that runs.
    pub fn running(&self) -> Option<&RunningCheck> {
        self.work.running()
    }

    /// The curves of the selected layout's runs as far as they have come.
    pub(crate) fn growing(&self) -> &[Vec<Point>] {
        self.work.growing(self.layout().uid)
    }

    /// The long work of steps that runs.
    pub(crate) fn steps(&self) -> Option<&RunningSteps> {
        self.work.steps()
    }

    /// The campaign that runs.
    pub fn campaign(&self) -> Option<&RunningCampaign> {
        self.work.campaign()
    }
}

/// Studies. What a page shows is there while it is open and the layout's mesh is known.
impl App {
    /// What studies ask of each check.
    pub(crate) fn study_wanted(&self) -> Wanted {
        self.studies.wanted(self.settings().runs)
    }

    pub fn sensitivity(&self) -> Option<&SensitivityView> {
        self.studies.sensitivity().view()
    }

    pub fn sweep(&self) -> Option<&SweepView> {
        self.studies.sweep().view()
    }

    /// The slot of the sweep that the arrows change: of the first input (0) or the second (1).
    pub(crate) fn sweep_slot(&self) -> (usize, Slot) {
        self.studies.sweep().slot()
    }

    /// The design page.
    pub fn design(&self) -> Option<&DesignView> {
        self.studies.design().view()
    }

    /// The tolerance of one input.
    pub fn tolerance(&self) -> Option<&ToleranceView> {
        self.studies.tolerance().view()
    }

    pub fn comparison(&self) -> Option<&CompareView> {
        self.studies.compare().view()
    }

    /// The marked layout of the comparison, by its place in the project.
    pub fn comparison_marked(&self) -> usize {
        self.studies.compare().marked()
    }

    /// The column the comparison is sorted by, and whether falling.
    pub fn comparison_sort(&self) -> Option<(ColumnHead, bool)> {
        self.studies.compare().sort()
    }

    /// The first column that is shown behind the name, by its place in [`ColumnHead::ALL`] less 1.
    pub(crate) fn comparison_first(&self) -> usize {
        self.studies.compare().first()
    }
}
