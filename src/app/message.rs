//! What reaches the program's state, and what the state asks to be done. The state itself does no
//! input or output: the room that runs the loop carries out the effects and answers with messages.

use super::key::Key;
use super::settings::{SettingItem, Settings};
use crate::export::ExportKind;
use crate::job::{News, Order};
use crate::mesh::MeshType;
use crate::project::schema::MethodFile;
use crate::project::{Holder, Project};
use crate::units::Units;
use std::path::PathBuf;
use std::sync::Arc;

/// Something that happened.
#[derive(Debug, Clone)]
pub enum Message {
    /// A key was pressed.
    Key(Key),
    /// Text was pasted (bracketed paste), line ends included.
    Paste(String),
    /// Text keys that came faster than anybody types: a paste that the terminal did not mark.
    Burst(Vec<Key>),
    /// The terminal has this size now.
    Resize {
        /// Columns.
        width: u16,
        /// Rows.
        height: u16,
    },
    /// A save that was asked for has ended.
    Saved(Result<Saved, SaveFailure>),
    /// What was asked for of files takes longer than a file takes.
    StillAtFiles {
        /// Time since it was begun, s.
        seconds: u64,
    },
    /// Something went wrong behind the screen, in words; the program goes on.
    Trouble(String),
    /// The terminal hung up or the program is told to end: keep what is unsaved and go.
    HangUp,
    /// A file was written from the project, or why not.
    Exported(Result<Exported, String>),
    /// News of work behind the screen.
    Work(News),
    /// The program runs again after it was suspended; the whole screen must be drawn.
    Resumed,
    /// Settings or a mesh were kept in the user's folder, with what is to be known of it, or could not be, and why.
    KeptAtHome(Result<Option<String>, String>),
    /// The project files that were found.
    Projects(Vec<FoundProject>),
    /// Another project was read, or could not be.
    Opened(Result<OpenedProject, OpenFailure>),
    /// A method's file was read, or could not be.
    MethodRead {
        /// The file of the project that is to name it.
        of: PathBuf,
        /// The file as that project names it, with what is in it; or why not.
        result: Result<MethodFile, String>,
    },
    /// Who holds the project's file, so that this session only reads it; nobody else.
    Held(Option<Holder>),
    /// Whether the file on disk is another one than was last read or written.
    ChangedOnDisk(bool),
    /// What another lost session kept, where the last one's was let go.
    Kept(KeptEdits),
}

/// A save that worked.
#[derive(Debug, Clone)]
pub struct Saved {
    /// The project as it was written.
    pub project: Arc<Project>,
    /// The file it went to.
    pub path: PathBuf,
    /// What the user should know of it, such as comments that could not be kept.
    pub note: Option<String>,
}

/// A save that did not.
#[derive(Debug, Clone)]
pub struct SaveFailure {
    /// What went wrong and what to do, for people.
    pub message: String,
    /// Whether saving again with `overwrite` would help: the file changed on disk since it was opened.
    pub overwrite_helps: bool,
    /// Who holds the file, where that is the reason; taking it over would help.
    pub holder: Option<Holder>,
    /// The other file that was asked for, or `None` for the project's own.
    pub path: Option<PathBuf>,
}

/// A file that was written from the project.
#[derive(Debug, Clone)]
pub struct Exported {
    /// Where it is.
    pub path: PathBuf,
    /// What the user should know of it.
    pub note: Option<String>,
}

/// A project file that can be opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FoundProject {
    /// The file.
    pub path: PathBuf,
    /// The file as the list shows it and as typed letters are matched.
    pub shown: String,
    /// Whether it was open before.
    pub recent: bool,
    /// Whether it is gone.
    pub missing: bool,
    /// Whether it is the one that is open.
    pub current: bool,
}

/// A project that was opened in place of the former one.
#[derive(Debug, Clone)]
pub struct OpenedProject {
    /// What its file holds, without kept edits.
    pub project: Arc<Project>,
    /// Its file.
    pub path: PathBuf,
    /// What the user should know of it.
    pub note: Option<String>,
    /// Edits kept from a session of it that was cut off.
    pub kept: Option<KeptEdits>,
    /// Who else holds the file.
    pub holder: Option<Holder>,
}

/// Edits kept from a session that was cut off.
#[derive(Debug, Clone)]
pub struct KeptEdits {
    /// The project with them.
    pub project: Arc<Project>,
    /// When they were made, and where they differ from the file, a line each.
    pub about: Vec<String>,
}

/// A project that could not be opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OpenFailure {
    /// What went wrong, by file, line and field; may have several lines.
    pub message: String,
}

/// Something to be done outside the state.
#[derive(Debug, Clone)]
pub enum Command {
    /// Write the project, to its own file or to another one, and answer with [`Message::Saved`].
    Save {
        /// What to write.
        project: Arc<Project>,
        /// Where to, or the file it was opened from. A relative path is taken from the working directory.
        path: Option<PathBuf>,
        /// Whether to replace a file that changed on disk, or that exists when `path` is given.
        overwrite: bool,
    },
    /// Keep unsaved edits in the recovery file, quickly and without questions.
    Recover {
        /// What to keep.
        project: Arc<Project>,
    },
    /// Take the file over from another session, and answer with [`Message::Held`].
    TakeFile {
        /// Another file that is to be saved to, or `None` for the project's own.
        path: Option<PathBuf>,
    },
    /// Edits kept from a session that was cut off are edits of this one now.
    TakeKept,
    /// The kept edits are not wanted; drop them.
    DropKept,
    /// The project that was opened last is not wanted any more.
    LetGo,
    /// Drop the recovery file: everything is saved or the user let the edits go.
    ForgetRecovery,
    /// Do this behind the screen; its news come as [`Message::Work`].
    Work(Order),
    /// End what runs behind the screen.
    StopWork,
    /// Write a report, a chart or a table, and answer with [`Message::Exported`].
    Export {
        /// What.
        kind: ExportKind,
        project: Arc<Project>,
        /// Whether it has edits that are not in its file.
        edited: bool,
        /// The layout selected, an index.
        layout: usize,
        /// Unit of lengths.
        unit: Units,
        /// Where to; beside the project under a free name where nothing is said.
        path: Option<PathBuf>,
        /// Whether to replace a file that is there.
        overwrite: bool,
    },
    /// Give the terminal back and stop until continued.
    Suspend,
    /// Draw the whole screen anew.
    Redraw,
    /// End the program.
    Quit,
    /// Keep a setting for the next start, and answer with [`Message::KeptAtHome`].
    KeepSettings {
        /// The setting that was changed; the others may have been changed by another session.
        changed: SettingItem,
        /// What holds in this session.
        settings: Settings,
    },
    /// Put a mesh of the project into the user's own catalogue too, and answer with [`Message::KeptAtHome`].
    KeepMesh {
        /// The mesh.
        mesh: Arc<MeshType>,
    },
    /// Put a text into the clipboard of the terminal, if it takes that.
    Copy { text: String },
    /// Look for project files, and answer with [`Message::Projects`].
    ListProjects,
    /// Read a project that is to take the place of this one, and answer with [`Message::Opened`].
    OpenProject {
        /// Its file. A relative path is taken from the working directory.
        path: PathBuf,
    },
    /// Read a method's file that the project is to name, and answer with [`Message::MethodRead`].
    ReadMethod {
        /// The file. A relative path is taken from the working directory.
        path: PathBuf,
        /// The project's file.
        of: PathBuf,
    },
    /// Go on with the project that was opened last: what is saved from now on goes to its file, and
    /// unsaved edits of the former one are let go.
    TakeOver,
}
