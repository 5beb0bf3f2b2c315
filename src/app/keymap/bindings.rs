//! The keys of every screen.

use super::super::key::{Code, Key};
use super::{Action as A, Binding, Context as C};

pub(super) const fn bind(
    context: C,
    action: A,
    keys: &'static [Key],
    help: &'static str,
    hint: Option<&'static str>,
) -> Binding {
    Binding { context, action, keys, help, hint }
}

pub(super) const fn p(code: Code) -> Key {
    Key::plain(code)
}
pub(super) const fn c(ch: char) -> Key {
    Key::char(ch)
}

/// The key map. Hints stand in order of importance: a narrow screen shows the first ones.
pub(super) const BINDINGS: &[Binding] = &[
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
    bind(C::Main, A::Duplicate, &[c('d')], "duplicate this layout", Some("duplicate")),
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
        &[c('q'), p(Code::Esc), Key::ctrl('g'), p(Code::Enter), c('i'), Key::ctrl('c')],
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
