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
];
