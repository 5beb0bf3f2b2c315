//! The keys of the pages of studies, and those that open them.

use super::super::key::{Code, Key};
use super::super::studies::{Ask, StudyPage};
use super::bindings::{bind, c, p};
use super::{Action as A, Binding, Context as C};

const fn ask(ask: Ask) -> A {
    A::Study(ask)
}

/// Their keys, a page after the other.
pub(super) const BINDINGS: &[Binding] = &[
    bind(
        C::Main,
        ask(Ask::Open(StudyPage::Sensitivity)),
        &[c('s')],
        "sensitivity: how the answer moves with each input, by forecast and check",
        Some("sensitivity"),
    ),
    bind(
        C::Main,
        ask(Ask::Open(StudyPage::Sweep)),
        &[c('w')],
        "sweep: one input over a range as a chart, or two as a map",
        Some("sweep"),
    ),
    bind(
        C::Main,
        ask(Ask::Open(StudyPage::Compare)),
        &[c('v')],
        "compare: all layouts in a table that can be sorted, with their curves",
        Some("compare"),
    ),
    bind(
        C::Main,
        ask(Ask::Open(StudyPage::Design)),
        &[c('g')],
        "design: which d, L or D just meets the design values",
        Some("design"),
    ),
    bind(
        C::Sensitivity,
        ask(Ask::NextColumn),
        &[p(Code::Right), c('e'), c(' ')],
        "show the change of the next value: F, delta, utilisation",
        Some("next value"),
    ),
    bind(
        C::Sensitivity,
        ask(Ask::PreviousColumn),
        &[p(Code::Left)],
        "show the change of the previous value",
        None,
    ),
    bind(
        C::Sensitivity,
        A::Check,
        &[c('c')],
        "check the layout and each step of d, L, D, ex, ey by simulation",
        Some("check"),
    ),
    bind(
        C::Sensitivity,
        A::Fidelity,
        &[c('f')],
        "how exactly the checks of studies compute",
        Some("fidelity"),
    ),
    bind(C::Sensitivity, A::NextLayout, &[p(Code::Tab)], "next layout", Some("layout")),
    bind(C::Sensitivity, A::PreviousLayout, &[p(Code::BackTab)], "previous layout", None),
    bind(C::Sensitivity, A::Down, &[p(Code::Down), c('j')], "scroll down", None),
    bind(C::Sensitivity, A::Up, &[p(Code::Up), c('k')], "scroll up", None),
    bind(
        C::Sweep,
        ask(Ask::NextColumn),
        &[p(Code::Right), c('+')],
        "next input, or a step up of its range or number of values",
        None,
    ),
    bind(C::Sweep, ask(Ask::PreviousColumn), &[p(Code::Left)], "the same back", None),
    bind(
        C::Sweep,
        A::Down,
        &[p(Code::Down), c('j')],
        "go on to the range, its number of values, the second input",
        Some("range"),
    ),
    bind(C::Sweep, A::Up, &[p(Code::Up), c('k')], "go back", None),
    bind(C::Sweep, A::Type, &[p(Code::Enter)], "type a value; a digit starts it too", None),
    bind(
        C::Sweep,
        ask(Ask::Two),
        &[c('2')],
        "a second input, which makes a map; on a range it starts a value",
        Some("map"),
    ),
    bind(C::Sweep, ask(Ask::SecondInput), &[c('m')], "a second input, or only one again", None),
    bind(C::Sweep, A::Check, &[c('c')], "check every point by simulation", Some("check")),
    bind(
        C::Sweep,
        ask(Ask::NextValue),
        &[c('e'), c(' ')],
        "show the next value: F, delta, utilisation",
        Some("value"),
    ),
    bind(C::Sweep, ask(Ask::MarkNext), &[c('>')], "mark the next point", Some("mark")),
    bind(C::Sweep, ask(Ask::MarkPrevious), &[c('<')], "mark the previous point", None),
    bind(
        C::Sweep,
        ask(Ask::Adopt),
        &[c('a')],
        "take the marked point into the layout; undo takes it back",
        Some("take"),
    ),
    bind(
        C::Sweep,
        ask(Ask::Layer),
        &[c('d')],
        "a map of the checks, or of the forecast, where one of them fits",
        None,
    ),
    bind(C::Sweep, A::Fidelity, &[c('f')], "how exactly the checks of studies compute", None),
    bind(C::Sweep, A::NextLayout, &[p(Code::Tab)], "next layout", None),
    bind(C::Sweep, A::PreviousLayout, &[p(Code::BackTab)], "previous layout", None),
    bind(C::Design, A::Down, &[p(Code::Down), c('j')], "next value", None),
    bind(C::Design, A::Up, &[p(Code::Up), c('k')], "previous value", None),
    bind(
        C::Design,
        A::Take,
        &[p(Code::Enter)],
        "take the marked value into the layout; undo takes it back",
        Some("take"),
    ),
    bind(
        C::Design,
        ask(Ask::DesignForce),
        &[c('F')],
        "type the design force; a digit starts it too",
        Some("force"),
    ),
    bind(
        C::Design,
        ask(Ask::AllowableDeflection),
        &[c('D')],
        "type the allowable deflection",
        Some("deflection"),
    ),
    bind(C::Design, ask(Ask::LoadFactor), &[c('L')], "type the partial factor on the load", None),
    bind(
        C::Design,
        ask(Ask::ResistanceFactor),
        &[c('R')],
        "type the partial factor on the resistance",
        None,
    ),
    bind(
        C::Design,
        ask(Ask::NextColumn),
        &[p(Code::Right), c('e'), c(' ')],
        "what has to be met: force, deflection or both",
        Some("asked"),
    ),
    bind(C::Design, ask(Ask::PreviousColumn), &[p(Code::Left)], "the same back", None),
    bind(
        C::Design,
        A::Check,
        &[c('c')],
        "check the layout and every value that can be taken by simulation",
        Some("check"),
    ),
    bind(C::Design, A::Fidelity, &[c('f')], "how exactly the checks of studies compute", None),
    bind(C::Design, A::NextLayout, &[p(Code::Tab)], "next layout", None),
    bind(C::Design, A::PreviousLayout, &[p(Code::BackTab)], "previous layout", None),
    bind(C::Compare, A::Down, &[p(Code::Down), c('j'), p(Code::Tab)], "next layout", None),
    bind(C::Compare, A::Up, &[p(Code::Up), c('k'), p(Code::BackTab)], "previous layout", None),
    bind(
        C::Compare,
        A::Take,
        &[p(Code::Enter)],
        "select the marked layout and go back to it",
        Some("select"),
    ),
    bind(C::Compare, ask(Ask::SortNext), &[c('>')], "sort by the next column", Some("sort")),
    bind(
        C::Compare,
        ask(Ask::SortPrevious),
        &[c('<')],
        "sort by the previous column; before the first is the project's order",
        None,
    ),
    bind(C::Compare, ask(Ask::Reverse), &[c('-')], "sort the other way round", Some("reverse")),
    bind(
        C::Compare,
        ask(Ask::NextColumn),
        &[p(Code::Right), c('l')],
        "show further columns",
        Some("columns"),
    ),
    bind(C::Compare, ask(Ask::PreviousColumn), &[p(Code::Left), c('h')], "columns before", None),
    bind(C::Compare, A::Check, &[c('c')], "check all layouts by simulation", Some("check all")),
];

/// A binding of no page yet: what it does, its keys, its help and its hint.
pub(super) type Bare = (A, &'static [Key], &'static str, Option<&'static str>);

/// Number of the keys that hold on every page.
pub(super) const SHARED: usize = 13;

/// Keys that hold on every page, those for the hint bar first.
pub(super) const EVERYWHERE: [Bare; SHARED] = [
    (A::Help, &[c('?'), p(Code::F(1))], "this help", Some("help")),
    (A::Close, &[c('q'), Key::ctrl('c')], "back", Some("back")),
    (
        A::Stop,
        &[p(Code::Esc), Key::ctrl('g')],
        "end the checks that run, keeping what is done; else back",
        None,
    ),
    (A::Undo, &[c('u')], "undo", None),
    (A::Redo, &[c('U'), Key::ctrl('r'), Key::ctrl('y')], "redo", None),
    (A::Units, &[c('t')], "lengths in m or mm", None),
    (A::Save, &[Key::ctrl('s')], "save", None),
    (ask(Ask::Open(StudyPage::Sensitivity)), &[c('s')], "sensitivity", None),
    (ask(Ask::Open(StudyPage::Sweep)), &[c('w')], "sweep", None),
    (ask(Ask::Open(StudyPage::Compare)), &[c('v')], "compare", None),
    (ask(Ask::Open(StudyPage::Design)), &[c('g')], "design", None),
    (A::Redraw, &[Key::ctrl('l')], "draw the screen anew", None),
    (A::Suspend, &[Key::ctrl('z')], "suspend", None),
];

/// The same on a page.
const fn on(context: C) -> [Binding; SHARED] {
    let (action, keys, help, hint) = EVERYWHERE[0];
    let mut all = [bind(context, action, keys, help, hint); SHARED];
    let mut at = 1;
    while at < SHARED {
        let (action, keys, help, hint) = EVERYWHERE[at];
        all[at] = bind(context, action, keys, help, hint);
        at += 1;
    }
    all
}

/// What holds on every page, page after page.
pub(super) static COMMON: [[Binding; SHARED]; 4] =
    [on(C::Sensitivity), on(C::Sweep), on(C::Compare), on(C::Design)];
