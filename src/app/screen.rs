//! What is on the screen: what lies over the main screen, the message of the bottom line, look and
//! size. What they show is the business of the other parts.

use super::entry::{EditTarget, LineEntry};
use super::file_work::Then;
use super::keymap::{Context, StudyPage};
use super::look::{ColorMode, Glyphs, Look};
use super::mesh_form::{FormKind, MeshForm};
use super::message::KeptEdits;
use super::picker::Picker;
use super::status::Status;
use std::path::PathBuf;

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
        /// The marked one, an index of [`super::App::meshes`].
        index: usize,
    },
    /// The form of a mesh to be added.
    MeshForm(Box<MeshForm>),
    /// The list of what can be written, with one marked.
    Export {
        /// The marked one, an index of [`crate::export::ExportKind::ALL`].
        index: usize,
    },
    /// Quit with unsaved edits?
    ConfirmQuit,
    /// Replace a file that changed on disk, or that exists?
    ConfirmOverwrite {
        /// Why it is asked.
        why: String,
        /// The other file to save to, or the project's own.
        path: Option<PathBuf>,
        /// What was to follow the save.
        then: Option<Then>,
    },
    /// Take the file over from the session that holds it?
    ConfirmTakeOver {
        /// Who holds it.
        why: String,
        /// The other file to save to, or the project's own.
        path: Option<PathBuf>,
        /// What was to follow the save.
        then: Option<Then>,
    },
    /// The list of settings with one marked.
    Settings {
        /// The marked one, an index of [`super::settings::SettingItem::ALL`].
        index: usize,
    },
    /// Which project to open.
    Open(Picker),
    /// Open another project with unsaved edits in this one?
    ConfirmOpen {
        /// The other project's file.
        path: PathBuf,
    },
    /// A screen of the tour.
    Tour {
        /// Which one, an index of [`super::tour::stops`].
        stop: usize,
    },
    /// A page of a study.
    Study(StudyPage),
    /// Take back edits kept from a session that was cut off?
    ConfirmRecovery {
        /// They.
        kept: KeptEdits,
    },
}

impl Mode {
    /// The screen whose keys hold now; none while text is typed.
    pub(super) fn context(&self) -> Option<Context> {
        Some(match self {
            Mode::Main => Context::Main,
            Mode::Entry(_) => return None,
            Mode::Help { .. } | Mode::Details { .. } => Context::Pager,
            Mode::MeshPicker { .. } => Context::MeshPicker,
            Mode::MeshForm(form) if form.kind == FormKind::Tests => Context::AdoptForm,
            Mode::MeshForm(_) => Context::MeshForm,
            Mode::Study(page) => page.context(),
            Mode::Export { .. } => Context::Export,
            Mode::ConfirmQuit => Context::ConfirmQuit,
            Mode::ConfirmOverwrite { .. } => Context::ConfirmOverwrite,
            Mode::ConfirmRecovery { .. } => Context::ConfirmRecovery,
            Mode::ConfirmTakeOver { .. } => Context::ConfirmTakeOver,
            Mode::Settings { .. } => Context::Settings,
            Mode::Open(_) => Context::Open,
            Mode::ConfirmOpen { .. } => Context::ConfirmOpen,
            Mode::Tour { .. } => Context::Tour,
        })
    }
}

/// The screen's part of the state.
#[derive(Debug)]
pub(super) struct Screen {
    mode: Mode,
    /// What the help lies over; it comes back when the help is closed.
    under_help: Mode,
    /// What is looked through while the text to look for is typed, and afterwards.
    looked_through: Mode,
    /// The text that was looked for last.
    sought: String,
    /// The form of a mesh to be adopted, as it was left.
    left_form: Option<Box<MeshForm>>,
    status: Option<Status>,
    look: Look,
    size: (u16, u16),
    dirty: bool,
}

impl Screen {
    /// The main screen of a look and a size.
    pub(super) fn new(look: Look, size: (u16, u16), status: Option<Status>) -> Screen {
        Screen {
            mode: Mode::Main,
            under_help: Mode::Main,
            looked_through: Mode::Main,
            sought: String::new(),
            left_form: None,
            status,
            look,
            size,
            dirty: true,
        }
    }

    /// What lies over the main screen.
    pub(super) fn mode(&self) -> &Mode {
        &self.mode
    }

    /// Shows something in place of what is shown.
    pub(super) fn show(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// Goes back to the main screen; what was shown.
    pub(super) fn take(&mut self) -> Mode {
        std::mem::replace(&mut self.mode, Mode::Main)
    }

    /// Closes what shows a layout: there is none.
    pub(super) fn leave_layout(&mut self) {
        if matches!(self.mode, Mode::Study(_) | Mode::MeshPicker { .. } | Mode::Details { .. }) {
            self.mode = Mode::Main;
        }
    }

    /// Begins to type.
    pub(super) fn type_into(&mut self, target: EditTarget, text: impl Into<String>) {
        self.mode = Mode::Entry(LineEntry::new(target, text));
    }

    /// Begins to type what to look for in what is shown.
    pub(super) fn type_sought(&mut self) {
        let entry = Mode::Entry(LineEntry::new(EditTarget::Find, ""));
        self.looked_through = std::mem::replace(&mut self.mode, entry);
    }

    /// The text to look for: a new one, or where that is empty the last one.
    pub(super) fn sought(&mut self, text: &str) -> String {
        if !text.is_empty() {
            self.sought = text.to_string();
        }
        self.sought.clone()
    }

    /// First line that is shown of a page of text.
    pub(super) fn first_line(&self) -> usize {
        match self.mode {
            Mode::Help { scroll } | Mode::Details { scroll } => scroll,
            _ => 0,
        }
    }

    /// Shows what lies under the line that is typed; the line.
    pub(super) fn take_entry(&mut self) -> Option<LineEntry> {
        let behind = self.behind();
        match std::mem::replace(&mut self.mode, behind) {
            Mode::Entry(entry) => Some(entry),
            other => {
                self.mode = other;
                None
            }
        }
    }

    /// The line that is typed.
    pub(super) fn entry(&mut self) -> Option<&mut LineEntry> {
        match &mut self.mode {
            Mode::Entry(entry) => Some(entry),
            _ => None,
        }
    }

    /// The list of projects.
    pub(super) fn picker(&mut self) -> Option<&mut Picker> {
        match &mut self.mode {
            Mode::Open(picker) => Some(picker),
            _ => None,
        }
    }

    pub(super) fn mesh_form(&mut self) -> Option<&mut MeshForm> {
        match &mut self.mode {
            Mode::MeshForm(form) => Some(form),
            _ => None,
        }
    }

    /// Keeps what stands in the form of a mesh to be adopted, for when it is shown again.
    pub(super) fn leave_form(&mut self) {
        if let Mode::MeshForm(form) = &self.mode
            && form.kind == FormKind::Tests
        {
            self.left_form = Some(form.clone());
        }
    }

    /// That form, to be shown again.
    pub(super) fn take_left_form(&mut self) -> Option<Box<MeshForm>> {
        self.left_form.take()
    }

    /// What stood in it is done with.
    pub(super) fn forget_form(&mut self) {
        self.left_form = None;
    }

    /// Whether text is taken: a line is typed, a form filled in, or letters to look for.
    pub(super) fn takes_text(&self) -> bool {
        matches!(self.mode, Mode::Entry(_) | Mode::Open(_) | Mode::MeshForm(_))
    }

    /// The page of a study that is open, also while a text for it is typed.
    pub(super) fn page(&self) -> Option<StudyPage> {
        match &self.mode {
            Mode::Study(page) => Some(*page),
            Mode::Entry(LineEntry { target: EditTarget::Study(typed), .. }) => Some(typed.page()),
            _ => None,
        }
    }

    /// What is under the text that is typed, or under the list that lies over everything now.
    fn behind(&self) -> Mode {
        if matches!(&self.mode, Mode::Entry(entry) if entry.target == EditTarget::Find) {
            return self.looked_through.clone();
        }
        let page = match self.mode {
            Mode::Entry(_) => self.page(),
            _ => None,
        };
        page.map_or(Mode::Main, Mode::Study)
    }

    /// Closes what is shown.
    pub(super) fn close(&mut self) {
        self.mode = self.behind();
    }

    /// Shows the help over what is shown, or closes it.
    pub(super) fn toggle_help(&mut self) {
        if let Mode::Help { .. } = self.mode {
            self.mode = std::mem::replace(&mut self.under_help, Mode::Main);
        } else {
            self.under_help = std::mem::replace(&mut self.mode, Mode::Help { scroll: 0 });
        }
    }

    /// What the help lies over.
    pub(super) fn under_help(&self) -> &Mode {
        &self.under_help
    }

    /// Moves the mark of a list of so many entries round and round, and as far as the ends with more lines
    /// than there are.
    pub(super) fn turn(&mut self, lines: isize, count: usize) {
        if let Mode::Export { index } | Mode::MeshPicker { index } = &mut self.mode {
            *index = match (lines.unsigned_abs() > count, lines > 0) {
                (true, true) => count.saturating_sub(1),
                (true, false) => 0,
                (false, _) => (*index as isize + lines).rem_euclid(count.max(1) as isize) as usize,
            };
        }
    }

    /// Moves the mark of the settings, the first line of a page or the stop of the tour, up to `last`.
    pub(super) fn scroll(&mut self, lines: isize, last: usize) {
        if let Mode::Help { scroll: at }
        | Mode::Details { scroll: at }
        | Mode::Settings { index: at }
        | Mode::Tour { stop: at } = &mut self.mode
        {
            *at = at.saturating_add_signed(lines).min(last);
        }
    }

    /// Lines of a page of text.
    pub(super) fn page_lines(&self) -> usize {
        usize::from(self.size.1).saturating_sub(4).max(1)
    }

    /// The message of the bottom line.
    pub(super) fn status(&self) -> Option<&Status> {
        self.status.as_ref()
    }

    /// Says something in the bottom line.
    pub(super) fn say(&mut self, status: Status) {
        self.status = Some(status);
    }

    /// Takes the message away.
    pub(super) fn hush(&mut self) {
        self.status = None;
    }

    /// Colours and glyphs.
    pub(super) fn look(&self) -> Look {
        self.look
    }

    /// Takes other glyphs.
    pub(super) fn set_glyphs(&mut self, glyphs: Glyphs) {
        self.look.glyphs = glyphs;
    }

    /// Takes other colours.
    pub(super) fn set_color(&mut self, color: ColorMode) {
        self.look.color = color;
    }

    /// Columns and rows.
    pub(super) fn size(&self) -> (u16, u16) {
        self.size
    }

    /// The terminal has another size.
    pub(super) fn resize(&mut self, width: u16, height: u16) {
        self.size = (width, height);
    }

    /// Asks to be drawn.
    pub(super) fn touch(&mut self) {
        self.dirty = true;
    }

    /// Whether something was asked to be drawn since this was asked last.
    pub(super) fn take_dirty(&mut self) -> bool {
        std::mem::take(&mut self.dirty)
    }
}
