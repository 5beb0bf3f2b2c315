//! What the loop needs from the program's state and from the outside world.

use super::exports::ExportWanted;
use crate::app::look::Look;
use crate::app::message::{
    Command, Exported, FoundProject, KeptEdits, Message, OpenFailure, OpenedProject, SaveFailure,
    Saved,
};
use crate::app::settings::{SettingItem, Settings};
use crate::mesh::MeshType;
use crate::project::schema::MethodFile;
use crate::project::{Holder, Project};
use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The state of an interactive program, as the loop sees it.
pub trait Program {
    /// Takes a message in; what it returns is carried out in this order.
    fn update(&mut self, message: Message) -> Vec<Command>;

    /// Draws the whole screen into an empty buffer of the terminal's size. Returns where the cursor is to
    /// stand; without a place it is hidden.
    fn draw(&self, buffer: &mut Buffer) -> Option<Position>;

    /// Whether anything shown has changed since the last call. A `true` too many costs time but no
    /// bytes; a `false` too many leaves an old screen.
    fn take_dirty(&mut self) -> bool;

    /// The project when it has edits that are not on disk. Asked after every message: hand out the
    /// same `Arc` as long as nothing changed.
    fn unsaved(&self) -> Option<Arc<Project>>;

    /// Colours and glyphs as set now. A change of colours draws the screen anew.
    fn look(&self) -> Look;
}

/// The outside world: files. What may wait for a disk is called by a thread of its own, one call after
/// the other; the recovery file is the business of the loop. Shared with the panic hook and the signal thread, which call
/// [`recover`](Host::recover) at any moment, also while another call of this host has not returned;
/// so `recover` must not wait for a lock that `save` holds.
pub trait Host: Send + Sync {
    /// Writes the project to `path`, or to its own file. The recovery file stays: there may be edits
    /// that were made meanwhile.
    ///
    /// # Errors
    /// Why nothing was written, or that the file has changed.
    fn save(
        &self,
        project: &Arc<Project>,
        path: Option<&Path>,
        overwrite: bool,
    ) -> Result<Saved, SaveFailure>;

    /// Keeps unsaved edits in the recovery file and says where that is.
    ///
    /// # Errors
    /// Why they could not be kept.
    fn recover(&self, project: &Project) -> Result<PathBuf, String>;

    /// Drops the recovery file; there being none is fine.
    ///
    /// # Errors
    /// Why it is still there.
    fn forget_recovery(&self) -> Result<(), String>;

    /// Takes a file over from the session that holds it, the project's own or one that is to be saved to;
    /// who holds the project's own file then.
    fn take_file(&self, _path: Option<&Path>) -> Option<Holder> {
        None
    }

    /// Whether the recovery file is where it was written, if one was.
    fn recovery_stands(&self) -> bool {
        true
    }

    /// What a lost session kept was taken back: its recovery file is this session's now.
    fn take_kept(&self) {}

    /// What a lost session kept is not wanted; what another one kept, if there is more.
    fn drop_kept(&self) -> Option<KeptEdits> {
        None
    }

    /// Keeps a setting that was changed; says what the user should know of it, or why it cannot be done. A host
    /// without a place for them forgets them.
    ///
    /// # Errors
    /// Why they are not kept.
    fn keep_settings(
        &self,
        _changed: SettingItem,
        _settings: &Settings,
    ) -> Result<Option<String>, String> {
        Ok(None)
    }

    /// Puts a mesh into the user's own catalogue too; what to say of it. A host without a place for it says so.
    ///
    /// # Errors
    /// Why it is not there.
    fn keep_mesh(&self, _mesh: &Arc<MeshType>) -> Result<String, String> {
        Err("there is no folder for a catalogue of your own".into())
    }

    /// Writes a report, a chart or a table. A host without files says so.
    ///
    /// # Errors
    /// Why nothing was written.
    fn export(&self, _wanted: ExportWanted<'_>) -> Result<Exported, String> {
        Err("nothing can be written here".to_owned())
    }

    /// Project files that can be opened: recent ones, then those near by.
    fn list(&self) -> Vec<FoundProject> {
        Vec::new()
    }

    /// Reads a project that may take the place of the present one, see
    /// [`take_over`](Host::take_over).
    ///
    /// # Errors
    /// Why it cannot be read.
    fn open(&self, _path: &Path) -> Result<OpenedProject, OpenFailure> {
        Err(OpenFailure { message: "no other project can be opened here".to_owned() })
    }

    /// Reads a method's file that was typed, and names it for the project in the file `of`.
    ///
    /// # Errors
    /// Why it cannot be named.
    fn read_method(&self, _path: &Path, _of: &Path) -> Result<MethodFile, String> {
        Err("no file can be read here".to_owned())
    }

    /// Goes on with the project that was opened last; the recovery file of the present one is dropped.
    fn take_over(&self) {}

    /// What was opened last is not wanted.
    fn let_go(&self) {}

    /// Removes what killed sessions left half written.
    fn tidy(&self) {}

    /// Looks at the project's file: who holds it and whether it changed, where that is news. Called by a
    /// thread of its own, again and again.
    fn watch(&self) -> Vec<Message> {
        Vec::new()
    }

    /// The session ends: what it holds is given back.
    fn leave(&self) {}
}
