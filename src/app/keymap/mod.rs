//! The one key map: which key does what, in which screen, and how help and hint bar say it.
//!
//! What a key can ask for and the screens stand here; [`bindings`] has the keys, [`commands`] the
//! commands of the `:` line.

mod bindings;
mod commands;
mod desk;
mod output;
mod studies;

pub use commands::COMMANDS;

use super::key::Key;
use super::studies::Ask;
use bindings::BINDINGS;

/// What a key can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Action {
    /// Select the input above.
    FieldUp,
    /// Select the input below.
    FieldDown,
    /// Decrease the input by its small step.
    StepDown,
    /// Increase the input by its small step.
    StepUp,
    /// Decrease the input by its large step.
    CoarseDown,
    /// Increase the input by its large step.
    CoarseUp,
    /// Edit the input's value as text.
    Type,
    /// Clear an optional input, centre an offset, put a factor back to 1.
    Clear,
    /// Select the next layout.
    NextLayout,
    /// Select the previous layout.
    PreviousLayout,
    /// Add a layout at the reference point.
    Add,
    /// Copy the layout.
    Duplicate,
    /// Rename the layout.
    Rename,
    /// Edit the layout's note.
    Note,
    /// Delete the layout.
    Delete,
    /// Move the layout up the list.
    MoveUp,
    /// Move the layout down the list.
    MoveDown,
    /// Draw the layout's curve over the others, or stop.
    Overlay,
    /// Pick the layout's mesh.
    PickMesh,
    /// Switch the branch rule.
    Branch,
    /// Switch the unit of lengths.
    Units,
    /// Undo the last edit.
    Undo,
    /// Redo what was undone.
    Redo,
    /// Save the project.
    Save,
    /// Open the command line.
    Command,
    /// Show all warnings and numbers of the layout.
    Details,
    /// Show the help.
    Help,
    /// Suspend the program.
    Suspend,
    /// Draw the screen anew.
    Redraw,
    /// Leave the program.
    Quit,
    /// Scroll or move up.
    Up,
    /// Scroll or move down.
    Down,
    /// Scroll a page up.
    PageUp,
    /// Scroll a page down.
    PageDown,
    /// Take the marked entry.
    Take,
    /// Close this screen, change nothing.
    Close,
    /// Save, then quit.
    SaveAndQuit,
    /// Quit without saving.
    Discard,
    /// Replace the file on disk.
    Overwrite,
    /// Take back the unsaved edits that were kept.
    Restore,
    /// Check the layout by simulation.
    Check,
    /// Check all layouts.
    CheckAll,
    /// Switch live checks.
    Live,
    /// Take the next fidelity of checks.
    Fidelity,
    /// End what runs behind the screen.
    Stop,
    /// Choose what to write to a file.
    Export,
    /// Give the marked setting its next word.
    NextWord,
    /// Give the marked setting its previous word.
    PreviousWord,
    /// Show the projects that can be opened.
    Open,
    /// Save, then open the other project.
    SaveAndOpen,
    /// Copy the layout's answer.
    CopyAnswer,
    /// Copy the table of all layouts.
    CopyTable,
    /// Copy the page being read.
    CopyPage,
    /// The next screen of the tour.
    NextStop,
    /// The screen of the tour before.
    PreviousStop,
    /// Something on a page of a study, or the page itself.
    Study(Ask),
}

/// A screen with keys of its own. Text entry has none: there every key is text or edits it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Context {
    /// The main screen.
    Main,
    /// Help and details: text that scrolls.
    Pager,
    /// The list of meshes.
    MeshPicker,
    /// The question before quitting with unsaved edits.
    ConfirmQuit,
    /// The question before replacing a file that changed on disk.
    ConfirmOverwrite,
    /// The question whether to take back edits kept from a session that was cut off.
    ConfirmRecovery,
    /// The list of settings.
    Settings,
    /// The list of projects to open.
    Open,
    /// The question before opening another project with unsaved edits.
    ConfirmOpen,
    /// The tour of the first run.
    Tour,
    /// The list of what can be written.
    Export,
    /// How the answer moves with each input.
    Sensitivity,
    /// One input over a range, or two over a map.
    Sweep,
    /// The layouts side by side.
    Compare,
    /// What just meets the design values.
    Design,
}

impl Context {
    /// All screens, in the order of the help.
    pub(crate) const ALL: [Context; 15] = [
        Context::Main,
        Context::Pager,
        Context::MeshPicker,
        Context::ConfirmQuit,
        Context::ConfirmOverwrite,
        Context::ConfirmRecovery,
        Context::Settings,
        Context::Open,
        Context::ConfirmOpen,
        Context::Tour,
        Context::Export,
        Context::Sensitivity,
        Context::Sweep,
        Context::Compare,
        Context::Design,
    ];

    /// Heading in the help.
    pub(crate) fn heading(self) -> &'static str {
        match self {
            Context::Main => "Main screen",
            Context::Pager => "Help and details",
            Context::MeshPicker => "Mesh list",
            Context::ConfirmQuit => "Unsaved edits",
            Context::ConfirmOverwrite => "File changed on disk",
            Context::ConfirmRecovery => "Edits kept from a lost session",
            Context::Settings => "Settings",
            Context::Open => "List of projects",
            Context::ConfirmOpen => "Unsaved edits before opening",
            Context::Tour => "Tour",
            Context::Export => "What to write",
            Context::Sensitivity => "Sensitivity; the keys from q on hold on all pages of studies",
            Context::Sweep => "Sweep",
            Context::Compare => "Compare",
            Context::Design => "Design",
        }
    }
}

/// One line of the key map.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    /// The screen it belongs to.
    pub context: Context,
    /// What it does.
    pub action: Action,
    /// Its keys; the first is the one to teach.
    pub keys: &'static [Key],
    /// What it does, for the help.
    pub help: &'static str,
    /// A word for the hint bar, for the bindings that belong there.
    pub hint: Option<&'static str>,
}

/// What a key does in a screen.
pub(crate) fn action(context: Context, key: Key) -> Option<Action> {
    of(context).find(|b| b.keys.contains(&key)).map(|b| b.action)
}

/// The bindings of a screen, in order.
pub(crate) fn of(context: Context) -> impl Iterator<Item = &'static Binding> {
    all().filter(move |b| b.context == context)
}

/// Whether a page of a study has an action from the keys that hold on all of them, which the help
/// lists with the first one.
pub(crate) fn shared(context: Context, action: Action) -> bool {
    matches!(context, Context::Sweep | Context::Compare | Context::Design)
        && studies::EVERYWHERE.iter().any(|e| e.0 == action)
}

/// The bindings of all screens.
pub fn all() -> impl Iterator<Item = &'static Binding> {
    let lists = [BINDINGS, output::BINDINGS, desk::BINDINGS, studies::BINDINGS];
    lists.into_iter().flatten().chain(studies::COMMON.iter().flatten())
}

#[cfg(test)]
mod tests {
    use super::super::key::Code;
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_key_has_two_meanings_in_one_screen() {
        let mut seen = HashSet::new();
        for b in all() {
            for key in b.keys {
                assert!(seen.insert((b.context, *key)), "{key} twice in {:?}", b.context);
            }
        }
    }

    #[test]
    fn every_action_can_be_reached_by_a_key_that_every_terminal_sends() {
        // Function keys, Alt and Shift with arrows do not arrive everywhere; control keys may be
        // eaten by serial hops, and saving and leaving have the command line for that case.
        let plain = |k: &Key| !k.alt && !k.shift && !matches!(k.code, Code::F(_));
        for b in all() {
            assert!(b.keys.iter().any(plain), "{:?} {:?}", b.context, b.action);
        }
    }

    #[test]
    fn every_screen_has_help() {
        for context in Context::ALL {
            let help = action(context, Key::char('?'));
            assert_eq!(help, Some(Action::Help), "{context:?}");
        }
    }

    #[test]
    fn every_screen_can_be_left_without_escape() {
        // Escape is slow or lost on some links.
        for context in Context::ALL {
            let leave = [Action::Close, Action::Quit];
            assert!(
                of(context).any(|b| leave.contains(&b.action)
                    && b.keys.iter().any(|k| k.code != Code::Esc && k.code != Code::Enter)),
                "{context:?}"
            );
        }
    }
}
