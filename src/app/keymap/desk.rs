//! The keys of the screens around the work: settings, opening, the tour.

use super::super::key::{Code, Key};
use super::bindings::{bind, c, p};
use super::{Action as A, Binding, Context as C};

/// Their keys, a screen after the other.
pub(super) const BINDINGS: &[Binding] = &[
    bind(
        C::Settings,
        A::Down,
        &[p(Code::Down), c('j'), p(Code::Tab)],
        "next setting",
        Some("next"),
    ),
    bind(C::Settings, A::Up, &[p(Code::Up), c('k'), p(Code::BackTab)], "previous setting", None),
    bind(
        C::Settings,
        A::NextWord,
        &[p(Code::Right), c(' '), c('l'), c('+')],
        "next value; it holds at once and is kept",
        Some("change"),
    ),
    bind(
        C::Settings,
        A::PreviousWord,
        &[p(Code::Left), c('h'), c('-')],
        "previous value",
        Some("change back"),
    ),
    bind(
        C::Settings,
        A::Close,
        &[c('q'), p(Code::Esc), p(Code::Enter), Key::ctrl('g'), Key::ctrl('c')],
        "back",
        Some("back"),
    ),
    bind(C::Settings, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Settings, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::Main,
        A::Open,
        &[c('O'), Key::ctrl('o')],
        "open another project: recent ones and those near by",
        Some("open"),
    ),
    bind(
        C::Open,
        A::Take,
        &[p(Code::Enter)],
        "open the marked one, or the text as a path",
        Some("open"),
    ),
    bind(
        C::Open,
        A::Down,
        &[p(Code::Down), p(Code::Tab), Key::ctrl('n')],
        "next; what is gone is passed over",
        Some("next"),
    ),
    bind(C::Open, A::Up, &[p(Code::Up), p(Code::BackTab), Key::ctrl('p')], "previous", None),
    bind(C::Open, A::PageDown, &[p(Code::PageDown)], "down a page", None),
    bind(C::Open, A::PageUp, &[p(Code::PageUp)], "up a page", None),
    bind(
        C::Open,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), Key::ctrl('c')],
        "back; all other keys are letters to look for",
        Some("back"),
    ),
    bind(C::Open, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Open, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::ConfirmOpen,
        A::SaveAndOpen,
        &[c('s'), Key::ctrl('s')],
        "save, then open the other one",
        Some("save and open"),
    ),
    bind(
        C::ConfirmOpen,
        A::Discard,
        &[c('d')],
        "open the other one without saving",
        Some("discard"),
    ),
    bind(
        C::ConfirmOpen,
        A::Close,
        &[p(Code::Esc), Key::ctrl('g'), c('q'), Key::ctrl('c')],
        "stay",
        Some("stay"),
    ),
    bind(C::ConfirmOpen, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::ConfirmOpen, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    bind(
        C::Main,
        A::CopyAnswer,
        &[c('y')],
        "copy this layout's answer, where the terminal takes OSC 52",
        Some("copy"),
    ),
    bind(
        C::Main,
        A::CopyTable,
        &[c('Y')],
        "copy the table of all layouts, tabs between columns",
        None,
    ),
    bind(C::Pager, A::CopyPage, &[c('y'), c('Y')], "copy the page", Some("copy")),
    bind(
        C::Tour,
        A::NextStop,
        &[p(Code::Enter), c(' '), p(Code::Right)],
        "the next screen; after the last the work begins",
        Some("next"),
    ),
    bind(C::Tour, A::PreviousStop, &[p(Code::Left), p(Code::Backspace)], "back", Some("back")),
    bind(
        C::Tour,
        A::Close,
        &[c('q'), p(Code::Esc), Key::ctrl('g'), Key::ctrl('c')],
        "end the tour; :tour shows it again",
        Some("end"),
    ),
    bind(C::Tour, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Tour, A::Suspend, &[Key::ctrl('z')], "suspend", None),
    // Help is the same key everywhere; what lies under it comes back.
    help(C::Pager),
    help(C::MeshPicker),
    help(C::ConfirmQuit),
    help(C::ConfirmOverwrite),
    help(C::ConfirmRecovery),
    help(C::Settings),
    help(C::Open),
    help(C::ConfirmOpen),
    help(C::Tour),
];

/// The keys of the help.
const HELP: &[Key] = &[c('?'), p(Code::F(1))];

const fn help(context: C) -> Binding {
    bind(context, A::Help, HELP, "help, and back to here", Some("help"))
}
