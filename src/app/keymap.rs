//! The one key map: which key does what, in which screen, and how help and hint bar say it.

use super::key::{Code, Key};

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
}

impl Context {
    /// All screens, in the order of the help.
    pub const ALL: [Context; 6] = [
        Context::Main,
        Context::Pager,
        Context::MeshPicker,
        Context::ConfirmQuit,
        Context::ConfirmOverwrite,
        Context::ConfirmRecovery,
    ];

    /// Heading in the help.
    pub fn heading(self) -> &'static str {
        match self {
            Context::Main => "Main screen",
            Context::Pager => "Help and details",
            Context::MeshPicker => "Mesh list",
            Context::ConfirmQuit => "Unsaved edits",
            Context::ConfirmOverwrite => "File changed on disk",
            Context::ConfirmRecovery => "Edits kept from a lost session",
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

const fn bind(
    context: Context,
    action: Action,
    keys: &'static [Key],
    help: &'static str,
    hint: Option<&'static str>,
) -> Binding {
    Binding { context, action, keys, help, hint }
}

use Action as A;
use Context as C;

const fn p(code: Code) -> Key {
    Key::plain(code)
}
const fn c(ch: char) -> Key {
    Key::char(ch)
}

/// The key map. Hints stand in order of importance: a narrow screen shows the first ones.
pub const BINDINGS: &[Binding] = &[
    bind(
        C::Main,
        A::StepUp,
        &[p(Code::Right), c('+')],
        "increase the input by its small step",
        Some("step"),
    ),
    bind(C::Main, A::StepDown, &[p(Code::Left)], "decrease the input by its small step", None),
    bind(
        C::Main,
        A::CoarseUp,
        &[c('>'), Key::shift(Code::Right)],
        "increase the input by its large step",
        None,
    ),
    bind(
        C::Main,
        A::CoarseDown,
        &[c('<'), Key::shift(Code::Left)],
        "decrease the input by its large step",
        None,
    ),
    bind(
        C::Main,
        A::Type,
        &[p(Code::Enter)],
        "type a value, with or without a unit (250mm, 0.25); a digit starts it too",
        Some("type"),
    ),
    bind(C::Main, A::FieldDown, &[p(Code::Down)], "next input", None),
    bind(C::Main, A::FieldUp, &[p(Code::Up)], "previous input", None),
    bind(
        C::Main,
        A::Clear,
        &[p(Code::Delete), p(Code::Backspace)],
        "clear the input: no design value, offset 0, factor 1",
        None,
    ),
    bind(C::Main, A::NextLayout, &[p(Code::Tab), p(Code::PageDown)], "next layout", Some("layout")),
    bind(C::Main, A::PreviousLayout, &[p(Code::BackTab), p(Code::PageUp)], "previous layout", None),
    bind(C::Main, A::Help, &[c('?'), p(Code::F(1))], "this help", Some("help")),
    bind(
        C::Main,
        A::Quit,
        &[c('q'), Key::ctrl('c'), Key::ctrl('q')],
        "quit; asks when edits are unsaved",
        Some("quit"),
    ),
    bind(
        C::Main,
        A::Save,
        &[Key::ctrl('s')],
        "save; :w does the same where Ctrl+S does not arrive",
        Some("save"),
    ),
    bind(C::Main, A::Undo, &[c('u')], "undo", Some("undo")),
    bind(C::Main, A::Details, &[c('i')], "all warnings and numbers of this layout", Some("info")),
    bind(
        C::Main,
        A::Overlay,
        &[c('o')],
        "draw this layout's curve over the others, or stop (up to four)",
        Some("overlay"),
    ),
    bind(C::Main, A::Add, &[c('a')], "add a layout at the reference point", Some("add")),
    bind(C::Main, A::Duplicate, &[c('y')], "copy this layout", Some("copy")),
    bind(C::Main, A::PickMesh, &[c('m')], "pick the mesh of this layout", Some("mesh")),
    bind(
        C::Main,
        A::Command,
        &[c(':')],
        "command line: :w, :w PATH, :wq, :q!, :units mm and more, see below",
        Some("command"),
    ),
    bind(C::Main, A::Rename, &[c('r')], "rename this layout", Some("rename")),
    bind(C::Main, A::Delete, &[c('x')], "delete this layout; undo brings it back", Some("delete")),
    bind(C::Main, A::MoveUp, &[c('K')], "move this layout up the list", None),
    bind(C::Main, A::MoveDown, &[c('J')], "move this layout down the list", None),
    bind(C::Main, A::Note, &[c('n')], "edit this layout's note", Some("note")),
    bind(
        C::Main,
        A::Branch,
        &[c('b')],
        "branch of A.1-A.2: as published, or the lower force (conservative)",
        Some("branch"),
    ),
    bind(C::Main, A::Units, &[c('t')], "lengths in m or mm", Some("units")),
    bind(C::Main, A::Redo, &[c('U'), Key::ctrl('r'), Key::ctrl('y')], "redo", Some("redo")),
    bind(C::Main, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Main, A::Suspend, &[Key::ctrl('z')], "suspend; fg brings the program back", None),
    bind(C::Pager, A::Down, &[p(Code::Down), c('j')], "down a line", Some("down")),
    bind(C::Pager, A::Up, &[p(Code::Up), c('k')], "up a line", Some("up")),
    bind(
        C::Pager,
        A::PageDown,
        &[c(' '), p(Code::PageDown), p(Code::Right)],
        "down a page",
        Some("page"),
    ),
    bind(C::Pager, A::PageUp, &[p(Code::PageUp), p(Code::Left)], "up a page", None),
    bind(
        C::Pager,
        A::Close,
        &[
            c('q'),
            p(Code::Esc),
            Key::ctrl('g'),
            p(Code::Enter),
            c('?'),
            c('i'),
            p(Code::F(1)),
            Key::ctrl('c'),
        ],
        "back",
        Some("back"),
    ),
    bind(C::Pager, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Pager, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(C::MeshPicker, A::Down, &[p(Code::Down), c('j'), p(Code::Tab)], "next mesh", Some("next")),
    bind(
        C::MeshPicker,
        A::Up,
        &[p(Code::Up), c('k'), p(Code::BackTab)],
        "previous mesh",
        Some("previous"),
    ),
    bind(C::MeshPicker, A::Take, &[p(Code::Enter)], "use this mesh", Some("use")),
    bind(
        C::MeshPicker,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), c('q'), c('m'), Key::ctrl('c')],
        "back, keep the mesh",
        Some("back"),
    ),
    bind(C::MeshPicker, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::MeshPicker, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::ConfirmQuit,
        A::SaveAndQuit,
        &[c('s'), Key::ctrl('s')],
        "save and quit",
        Some("save and quit"),
    ),
    bind(C::ConfirmQuit, A::Discard, &[c('d')], "quit without saving", Some("discard")),
    bind(
        C::ConfirmQuit,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), c('q'), Key::ctrl('c')],
        "stay",
        Some("stay"),
    ),
    bind(C::ConfirmQuit, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::ConfirmQuit, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::ConfirmOverwrite,
        A::Overwrite,
        &[c('o')],
        "replace the file on disk with this project",
        Some("overwrite"),
    ),
    bind(
        C::ConfirmOverwrite,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), c('q'), Key::ctrl('c')],
        "do not save; :w PATH saves elsewhere",
        Some("do not save"),
    ),
    bind(C::ConfirmOverwrite, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::ConfirmOverwrite, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::ConfirmRecovery,
        A::Restore,
        &[c('r')],
        "take the kept edits back, as unsaved edits",
        Some("restore"),
    ),
    bind(C::ConfirmRecovery, A::Discard, &[c('d')], "drop the kept edits", Some("drop")),
    bind(
        C::ConfirmRecovery,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), c('q'), Key::ctrl('c')],
        "quit and decide later; the kept edits stay where they are",
        Some("quit"),
    ),
    bind(C::ConfirmRecovery, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::ConfirmRecovery, A::Suspend, &[Key::ctrl('z')], "suspend", None),
];

/// What a key does in a screen.
pub fn action(context: Context, key: Key) -> Option<Action> {
    of(context).find(|b| b.keys.contains(&key)).map(|b| b.action)
}

/// The bindings of a screen, in order.
pub fn of(context: Context) -> impl Iterator<Item = &'static Binding> {
    BINDINGS.iter().filter(move |b| b.context == context)
}

/// A command of the command line: its form and what it does, for the help.
pub struct CommandHelp {
    /// The form, as typed after the colon.
    pub form: &'static str,
    /// What it does.
    pub help: &'static str,
}

/// The commands, in the order of the help; `app::command` carries them out, and a test holds the two
/// together.
pub const COMMANDS: &[CommandHelp] = &[
    CommandHelp { form: "w", help: "save" },
    CommandHelp { form: "w PATH", help: "save to another file and go on with that one" },
    CommandHelp { form: "w!", help: "save over a file that changed on disk" },
    CommandHelp { form: "wq", help: "save and quit (also :x)" },
    CommandHelp { form: "q", help: "quit; asks when edits are unsaved" },
    CommandHelp { form: "q!", help: "quit without saving" },
    CommandHelp { form: "N", help: "select layout number N" },
    CommandHelp { form: "name TEXT", help: "name of the project" },
    CommandHelp { form: "site TEXT", help: "site of the project" },
    CommandHelp { form: "mesh ID", help: "mesh of this layout" },
    CommandHelp { form: "units m|mm", help: "unit of lengths" },
    CommandHelp { form: "glyphs braille|block|ascii", help: "signs that charts are drawn with" },
    CommandHelp { form: "color 16|none", help: "colours" },
    CommandHelp { form: "undo / redo", help: "the same as u and U" },
    CommandHelp { form: "help", help: "this help" },
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_key_has_two_meanings_in_one_screen() {
        let mut seen = HashSet::new();
        for b in BINDINGS {
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
        for b in BINDINGS {
            assert!(b.keys.iter().any(plain), "{:?} {:?}", b.context, b.action);
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
