//! The keys of the list of what can be written.

use super::super::key::{Code, Key};
use super::bindings::{bind, c, p};
use super::{Action as A, Binding, Context as C};

/// Its keys, and the one that opens it.
pub(super) const BINDINGS: &[Binding] = &[
    bind(C::Main, A::Export, &[c('e')], "export a report, chart, plan or table", Some("export")),
    bind(C::Export, A::Down, &[p(Code::Down), c('j'), p(Code::Tab)], "next", Some("next")),
    bind(C::Export, A::Up, &[p(Code::Up), c('k'), p(Code::BackTab)], "previous", None),
    bind(
        C::Export,
        A::Take,
        &[p(Code::Enter)],
        "write it beside the project, under a name that is free",
        Some("write"),
    ),
    bind(
        C::Export,
        A::Close,
        &[c('q'), p(Code::Esc), c('e'), Key::ctrl('g'), Key::ctrl('c')],
        "back",
        Some("back"),
    ),
    bind(C::Export, A::Help, &[c('?'), p(Code::F(1))], "help, and back to here", Some("help")),
    bind(C::Export, A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    bind(C::Export, A::Suspend, &[Key::ctrl('z')], "suspend", None),
];
