//! The keys of every screen, a line each: what it does, its keys (the first is the one to teach), a
//! word for the hint bar where it belongs there, and what the help says of it.
//!
//! Hints stand in order of importance: a narrow screen shows the first ones. rustfmt would stand each
//! line on five, so it is told to leave the tables alone.

use super::super::key::{Code, Key};
use super::action::Ask::{
    Adopt, AllowableDeflection, DesignForce, Layer, LoadFactor, MarkNext, MarkPrevious, NextColumn,
    NextValue, PreviousColumn, ResistanceFactor, Reverse, SecondInput, SortNext, SortPrevious, Two,
};
use super::action::StudyPage::{self, Compare, Design, Sensitivity, Sweep, Tolerance};
use super::action::{Action as A, Ask};
use super::{Binding, Context};
use crate::case::Input;

const UP: Key = Key::plain(Code::Up);
const DOWN: Key = Key::plain(Code::Down);
const LEFT: Key = Key::plain(Code::Left);
const RIGHT: Key = Key::plain(Code::Right);
const PAGE_UP: Key = Key::plain(Code::PageUp);
const PAGE_DOWN: Key = Key::plain(Code::PageDown);
const HOME: Key = Key::plain(Code::Home);
const END: Key = Key::plain(Code::End);
const ENTER: Key = Key::plain(Code::Enter);
const ESC: Key = Key::plain(Code::Esc);
const TAB: Key = Key::plain(Code::Tab);
const BACK_TAB: Key = Key::plain(Code::BackTab);
const BACKSPACE: Key = Key::plain(Code::Backspace);
const DELETE: Key = Key::plain(Code::Delete);
const F1: Key = Key::plain(Code::F(1));

const fn c(c: char) -> Key {
    Key::char(c)
}

const fn ctrl(c: char) -> Key {
    Key::ctrl(c)
}

const fn shift(code: Code) -> Key {
    Key::shift(code)
}

const fn open(page: StudyPage) -> A {
    A::Study(Ask::Open(page))
}

/// A line; an empty hint is none.
const fn k(action: A, keys: &'static [Key], hint: &'static str, help: &'static str) -> Binding {
    Binding { action, keys, help, hint: if hint.is_empty() { None } else { Some(hint) } }
}

const FIDELITY: &str = "how exactly the checks of studies compute";

/// The keys of a screen alone.
pub(super) const fn own(context: Context) -> &'static [Binding] {
    match context {
        Context::Main => MAIN,
        Context::Empty => EMPTY,
        Context::Pager => PAGER,
        Context::MeshPicker => MESH_PICKER,
        Context::MeshForm => MESH_FORM,
        Context::AdoptForm => ADOPT_FORM,
        Context::ConfirmQuit => CONFIRM_QUIT,
        Context::ConfirmOverwrite => CONFIRM_OVERWRITE,
        Context::ConfirmRecovery => CONFIRM_RECOVERY,
        Context::ConfirmTakeOver => CONFIRM_TAKE_OVER,
        Context::Settings => SETTINGS,
        Context::Open => OPEN,
        Context::ConfirmOpen => CONFIRM_OPEN,
        Context::Tour => TOUR,
        Context::Export => EXPORT,
        Context::Sensitivity => SENSITIVITY,
        Context::Tolerance => TOLERANCE,
        Context::Sweep => SWEEP,
        Context::Compare => COMPARE,
        Context::Design => DESIGN,
    }
}

/// The main screen.
#[rustfmt::skip]
const MAIN: &[Binding] = &[
    k(A::StepUp,         &[RIGHT, c('+')],                "step",        "increase the input by its small step"),
    k(A::Help,           &[c('?'), F1],                   "help",        "this help"),
    k(A::Quit,           &[c('q'), ctrl('c'), ctrl('q')], "quit",        "quit; asks when edits are unsaved"),
    k(A::StepDown,       &[LEFT],                         "",            "decrease the input by its small step"),
    k(A::CoarseUp,       &[c('>'), shift(Code::Right)],   "",            "increase the input by its large step"),
    k(A::CoarseDown,     &[c('<'), shift(Code::Left)],    "",            "decrease the input by its large step"),
    k(A::Type,           &[ENTER],                        "type",        "type a value, with or without a unit (250mm, 0.25); a digit starts it too"),
    k(A::FieldDown,      &[DOWN, c('j')],                 "",            "next input"),
    k(A::FieldUp,        &[UP, c('k')],                   "",            "previous input"),
    k(A::First,          &[HOME],                         "",            "first input"),
    k(A::Last,           &[END],                          "",            "last input"),
    k(A::Select(Input::Plate),   &[c('d')],               "",            "to d, the side of the plates"),
    k(A::Select(Input::Spacing), &[c('L')],               "",            "to L, the spacing of the anchors"),
    k(A::Select(Input::Punch),   &[c('D')],               "",            "to D, the diameter of the block"),
    k(A::Find,           &[c('/')],                       "",            "find a layout by a part of its name; / and Enter goes on to the next"),
    k(A::Clear,          &[DELETE, BACKSPACE],            "",            "clear the input: no design value, offset 0, factor 1"),
    k(A::NextLayout,     &[TAB, PAGE_DOWN],               "layout",      "next layout"),
    k(A::PreviousLayout, &[BACK_TAB, PAGE_UP],            "",            "previous layout"),
    k(A::Save,           &[ctrl('s')],                    "save",        "save; :w does the same where Ctrl+S does not arrive"),
    k(A::Check,          &[c('c')],                       "check",       "check this layout by simulation, over random alignments"),
    k(A::Live,           &[c('l')],                       "live",        "live: a quick check after each edit"),
    k(A::Undo,           &[c('u')],                       "undo",        "undo"),
    k(A::Details,        &[c('i')],                       "info",        "all warnings and numbers of this layout"),
    k(A::Overlay,        &[c('o')],                       "overlay",     "draw this layout's curve over the others, or stop (up to four)"),
    k(A::Add,            &[c('a')],                       "add",         "add a layout at the reference point"),
    k(A::Duplicate,      &[c('A')],                       "duplicate",   "duplicate this layout"),
    k(A::PickMesh,       &[c('m')],                       "mesh",        "pick the mesh of this layout"),
    k(A::Command,        &[c(':')],                       "command",     "command line: :w, :w PATH, :wq, :q!, :units mm and more, see below"),
    k(A::Rename,         &[c('r')],                       "rename",      "rename this layout"),
    k(A::Delete,         &[c('x')],                       "delete",      "delete this layout; undo brings it back"),
    k(A::MoveUp,         &[c('K')],                       "",            "move this layout up the list"),
    k(A::MoveDown,       &[c('J')],                       "",            "move this layout down the list"),
    k(A::Note,           &[c('n')],                       "note",        "edit this layout's note"),
    k(A::Branch,         &[c('b')],                       "branch",      "branch of A.1-A.2: as published, or the lower force (conservative)"),
    k(A::Blocks,         &[c('p')],                       "blocks",      "how the blocks of other cells stand: paper, repeated, mirrored, single, or the worst"),
    k(A::Grid,           &[c('P')],                       "",            "grid of anchors: one spacing L, two (Lx and Ly), or staggered"),
    k(A::Twists,         &[c('T')],                       "",            "turn the net: twists down the slope or across it"),
    k(A::Method,         &[c('M')],                       "",            "the forecast's relations: the paper's, or those derived from simulations"),
    k(A::Units,          &[c('t')],                       "units",       "lengths in m or mm, or in ft or in"),
    k(A::Basis,          &[c('B')],                       "",            "verdicts by mean or by characteristic values, for the project"),
    k(A::Redo,           &[c('U'), ctrl('r'), ctrl('y')], "redo",        "redo"),
    k(A::CheckAll,       &[c('C')],                       "",            "check all layouts"),
    k(A::Fidelity,       &[c('f')],                       "fidelity",    "how exactly checks compute: auto, quick, standard, fine"),
    k(A::Stop,           &[ESC, ctrl('g')],               "",            "end the check that runs; what is done is kept"),
    k(A::Redraw,         &[ctrl('l')],                    "",            "draw the screen anew"),
    k(A::Suspend,        &[ctrl('z')],                    "",            "suspend; fg brings the program back"),
    k(A::Export,         &[c('e')],                       "export",      "export a report, chart, plan or table"),
    k(A::Open,           &[c('O'), ctrl('o')],            "open",        "open another project: recent ones and those near by"),
    k(A::CopyAnswer,     &[c('y')],                       "copy",        "copy this layout's answer, where the terminal takes OSC 52"),
    k(A::CopyTable,      &[c('Y')],                       "",            "copy the table of all layouts, tabs between columns"),
    k(open(Sensitivity), &[c('s')],                       "sensitivity", "sensitivity: how the answer moves with each input, by forecast and check"),
    k(open(Sweep),       &[c('w')],                       "sweep",       "sweep: one input over a range as a chart, or two as a map"),
    k(open(Compare),     &[c('v')],                       "compare",     "compare: all layouts in a table that can be sorted, with their curves"),
    k(open(Design),      &[c('g')],                       "design",      "design: which d, L or D just meets the design values"),
    k(open(Tolerance),   &[c('S')],                       "",            "tolerance: what the answer is where one input is off by so much"),
];

/// The main screen of a project without layouts: what needs none.
#[rustfmt::skip]
const EMPTY: &[Binding] = &[
    k(A::Add,            &[c('a'), ENTER],                "add",         "add a layout at the reference point"),
    k(A::Help,           &[c('?'), F1],                   "help",        "this help"),
    k(A::Quit,           &[c('q'), ctrl('c'), ctrl('q')], "quit",        "quit; asks when edits are unsaved"),
    k(A::Open,           &[c('O'), ctrl('o')],            "open",        "open another project: recent ones and those near by"),
    k(A::Save,           &[ctrl('s')],                    "save",        "save; :w does the same where Ctrl+S does not arrive"),
    k(A::Undo,           &[c('u')],                       "undo",        "undo"),
    k(A::Redo,           &[c('U'), ctrl('r'), ctrl('y')], "redo",        "redo"),
    k(A::Command,        &[c(':')],                       "command",     "command line"),
    k(A::Units,          &[c('t')],                       "units",       "lengths in m or mm, or in ft or in"),
    k(A::Redraw,         &[ctrl('l')],                    "",            "draw the screen anew"),
    k(A::Suspend,        &[ctrl('z')],                    "",            "suspend; fg brings the program back"),
];

/// Help and details.
#[rustfmt::skip]
const PAGER: &[Binding] = &[
    k(A::Down,     &[DOWN, c('j')],                   "down", "down a line"),
    k(A::Up,       &[UP, c('k')],                     "up",   "up a line"),
    k(A::PageDown, &[c(' '), PAGE_DOWN, RIGHT],       "page", "down a page"),
    k(A::PageUp,   &[PAGE_UP, LEFT],                  "",     "up a page"),
    k(A::First,    &[HOME, c('g')],                   "",     "to the beginning"),
    k(A::Last,     &[END, c('G')],                    "",     "to the end"),
    k(A::Find,     &[c('/')],                         "find", "find a text"),
    k(A::FindNext, &[c('n')],                         "",     "find it once more"),
    k(A::Close,    &[c('q'), ESC, ctrl('g'), ENTER, c('i'), ctrl('c')], "back", "back"),
    k(A::CopyPage, &[c('y'), c('Y')],                 "copy", "copy the page"),
];

/// The list of meshes.
#[rustfmt::skip]
const MESH_PICKER: &[Binding] = &[
    k(A::Down,  &[DOWN, c('j'), TAB],              "next",     "next mesh"),
    k(A::Up,    &[UP, c('k'), BACK_TAB],           "previous", "previous mesh"),
    k(A::First, &[HOME, PAGE_UP],                  "",         "first mesh"),
    k(A::Last,  &[END, PAGE_DOWN],                 "",         "last mesh"),
    k(A::Take,  &[ENTER],                          "use",      "use this mesh"),
    k(A::AddMesh, &[c('a')],                       "add",      "add a mesh to the project, by a form"),
    k(A::AdoptMesh, &[c('A')],                     "adopt",    "adopt a mesh from its own tests: laws, runs and a method of its own, by a form"),
    k(A::KeepMesh, &[c('C')],                      "",         "keep a mesh of this project in your own catalogue too, for other projects"),
    k(A::Find,  &[c('/')],                         "find",     "find a text in the list; Enter with nothing typed finds the next"),
    k(A::Close, &[ESC, ctrl('g'), c('q'), c('m'), ctrl('c')], "back",     "back, keep the mesh"),
];

#[rustfmt::skip]
const MESH_FORM: &[Binding] = &[
    k(A::Take,  &[ENTER],                        "next",     "the next row; in the last one the mesh is added and given to the layout"),
    k(A::Down,  &[DOWN, TAB],                    "",         "the next row"),
    k(A::Up,    &[UP, BACK_TAB],                 "previous", "the row above"),
    k(A::First, &[PAGE_UP],                      "",         "the first row"),
    k(A::Last,  &[PAGE_DOWN],                    "",         "the last row"),
    k(A::Close, &[ESC, ctrl('g'), ctrl('c')],    "back",     "back to the list, no mesh is added; all other keys are text"),
];

/// The form of a mesh to be adopted.
#[rustfmt::skip]
const ADOPT_FORM: &[Binding] = &[
    k(A::Take,  &[ENTER],                        "next",     "the next row; from the last one the work begins"),
    k(A::Down,  &[DOWN, TAB],                    "",         "the next row"),
    k(A::Up,    &[UP, BACK_TAB],                 "previous", "the row above"),
    k(A::First, &[PAGE_UP],                      "",         "the first row"),
    k(A::Last,  &[PAGE_DOWN],                    "",         "the last row"),
    k(A::Close, &[ESC, ctrl('g'), ctrl('c')],    "back",     "back to the list; what stands in the form stays; all other keys are text"),
];

/// Quit with unsaved edits?
#[rustfmt::skip]
const CONFIRM_QUIT: &[Binding] = &[
    k(A::SaveAndQuit, &[c('s'), ctrl('s')],              "save and quit", "save and quit"),
    k(A::Discard,     &[c('d')],                         "discard",       "quit without saving"),
    k(A::Close,       &[ESC, ctrl('g'), c('q'), ctrl('c')], "stay",          "stay"),
];

/// Replace a file that changed on disk?
#[rustfmt::skip]
const CONFIRM_OVERWRITE: &[Binding] = &[
    k(A::Overwrite, &[c('o')],                         "overwrite",   "replace the file on disk with this project"),
    k(A::Reload,    &[c('r')],                         "reload",      "read the file on disk anew; the edits here are let go"),
    k(A::Close,     &[ESC, ctrl('g'), c('q'), ctrl('c')], "do not save", "do not save; :w PATH saves elsewhere"),
];

/// Take the file over from the session that holds it?
#[rustfmt::skip]
const CONFIRM_TAKE_OVER: &[Binding] = &[
    k(A::TakeOver, &[c('t')],                         "take over",   "take the file over and save; the other session only reads then"),
    k(A::Close,    &[ESC, ctrl('g'), c('q'), ctrl('c')], "do not save", "do not save; :w PATH saves elsewhere"),
];

/// Take back edits of a session that was cut off?
#[rustfmt::skip]
const CONFIRM_RECOVERY: &[Binding] = &[
    k(A::Restore, &[c('r')],                         "restore", "take the kept edits back, as unsaved edits"),
    k(A::Discard, &[c('d')],                         "drop",    "drop the kept edits"),
    k(A::Close,   &[ESC, ctrl('g'), c('q'), ctrl('c')], "quit",    "quit and decide later; the kept edits stay where they are"),
];

/// The list of settings.
#[rustfmt::skip]
const SETTINGS: &[Binding] = &[
    k(A::Down,         &[DOWN, c('j'), TAB],              "next",        "next setting"),
    k(A::Up,           &[UP, c('k'), BACK_TAB],           "",            "previous setting"),
    k(A::First,        &[HOME, PAGE_UP],                  "",            "first setting"),
    k(A::Last,         &[END, PAGE_DOWN],                 "",            "last setting"),
    k(A::NextWord,     &[RIGHT, c(' '), c('l'), c('+')],  "change",      "next value; it holds at once and is kept"),
    k(A::PreviousWord, &[LEFT, c('h'), c('-')],           "change back", "previous value"),
    k(A::Close,        &[c('q'), ESC, ENTER, ctrl('g'), ctrl('c')], "back",        "back"),
];

/// The list of projects.
#[rustfmt::skip]
const OPEN: &[Binding] = &[
    k(A::Take,     &[ENTER],                     "open", "open the marked one, or the text as a path"),
    k(A::Down,     &[DOWN, TAB, ctrl('n')],      "next", "next; what is gone is passed over"),
    k(A::Up,       &[UP, BACK_TAB, ctrl('p')],   "",     "previous"),
    k(A::PageDown, &[PAGE_DOWN],                 "",     "down a page"),
    k(A::PageUp,   &[PAGE_UP],                   "",     "up a page"),
    k(A::First,    &[HOME],                      "",     "first"),
    k(A::Last,     &[END],                       "",     "last"),
    k(A::Close,    &[ESC, ctrl('g'), ctrl('c')], "back", "back; all other keys are letters to look for"),
];

/// Open another project with unsaved edits?
#[rustfmt::skip]
const CONFIRM_OPEN: &[Binding] = &[
    k(A::SaveAndOpen, &[c('s'), ctrl('s')],              "save and open", "save, then open the other one"),
    k(A::Discard,     &[c('d')],                         "discard",       "open the other one without saving"),
    k(A::Close,       &[ESC, ctrl('g'), c('q'), ctrl('c')], "stay",          "stay"),
];

#[rustfmt::skip]
const TOUR: &[Binding] = &[
    k(A::NextStop,     &[ENTER, c(' '), RIGHT],           "next", "the next screen; after the last the work begins"),
    k(A::PreviousStop, &[LEFT, BACKSPACE],                "back", "back"),
    k(A::Close,        &[c('q'), ESC, ctrl('g'), ctrl('c')], "end",  "end the tour; :tour shows it again"),
];

/// The list of what can be written.
#[rustfmt::skip]
const EXPORT: &[Binding] = &[
    k(A::Down,  &[DOWN, c('j'), TAB],              "next",  "next"),
    k(A::Up,    &[UP, c('k'), BACK_TAB],           "",      "previous"),
    k(A::First, &[HOME, PAGE_UP],                  "",      "first"),
    k(A::Last,  &[END, PAGE_DOWN],                 "",      "last"),
    k(A::Find,  &[c('/')],                         "",      "find a text in the list"),
    k(A::Take,  &[ENTER],                          "write", "write it beside the project, under a name that is free"),
    k(A::Close, &[c('q'), ESC, c('e'), ctrl('g'), ctrl('c')], "back",  "back"),
];

/// The page of the sensitivity.
#[rustfmt::skip]
const SENSITIVITY: &[Binding] = &[
    k(A::Study(NextColumn),     &[RIGHT, c('e'), c(' ')], "next value", "show the change of the next value: F, delta, use, delta at F"),
    k(A::Study(PreviousColumn), &[LEFT],                  "",           "show the change of the previous value"),
    k(A::Check,                 &[c('c')],                "check",      "check the layout and each step of d, L, D, ex, ey by simulation"),
    k(A::Fidelity,              &[c('f')],                "fidelity",   FIDELITY),
    k(A::NextLayout,            &[TAB],                   "layout",     "next layout"),
    k(A::PreviousLayout,        &[BACK_TAB],              "",           "previous layout"),
    k(A::Down,                  &[DOWN, c('j')],          "",           "scroll down"),
    k(A::Up,                    &[UP, c('k')],            "",           "scroll up"),
    k(A::First,                 &[HOME, PAGE_UP],         "",           "to the first input"),
    k(A::Last,                  &[END, PAGE_DOWN],        "",           "to the last input"),
];

/// The page of the sweep.
#[rustfmt::skip]
const SWEEP: &[Binding] = &[
    k(A::Study(NextColumn),     &[RIGHT, c('+')],  "",      "next input, or a step up of its range or number of values"),
    k(A::Study(PreviousColumn), &[LEFT],           "",      "the same back"),
    k(A::Down,                  &[DOWN, c('j')],   "range", "go on to the range, its number of values, the second input"),
    k(A::Up,                    &[UP, c('k')],     "",      "go back"),
    k(A::Type,                  &[ENTER],          "",      "type a value; a digit starts it too"),
    k(A::Study(Two),            &[c('2')],         "map",   "a second input, which makes a map; on a range it starts a value"),
    k(A::Study(SecondInput),    &[c('m')],         "",      "a second input, or only one again"),
    k(A::Check,                 &[c('c')],         "check", "check every point by simulation"),
    k(A::Study(NextValue),      &[c('e'), c(' ')], "value", "show the next value: F, delta, use, delta at F"),
    k(A::Study(MarkNext),       &[c('>')],         "mark",  "mark the next point"),
    k(A::Study(MarkPrevious),   &[c('<')],         "",      "mark the previous point"),
    k(A::Study(Adopt),          &[c('a')],         "take",  "take the marked point into the layout; undo takes it back"),
    k(A::Study(Layer),          &[c('d')],         "",      "a map of the checks, or of the forecast, where one of them fits"),
    k(A::Fidelity,              &[c('f')],         "",      FIDELITY),
    k(A::NextLayout,            &[TAB],            "",      "next layout"),
    k(A::PreviousLayout,        &[BACK_TAB],       "",      "previous layout"),
];

/// The page of the comparison.
#[rustfmt::skip]
const COMPARE: &[Binding] = &[
    k(A::Down,                  &[DOWN, c('j'), TAB],    "",          "next layout"),
    k(A::Up,                    &[UP, c('k'), BACK_TAB], "",          "previous layout"),
    k(A::PageDown,              &[PAGE_DOWN],            "",          "down a page"),
    k(A::PageUp,                &[PAGE_UP],              "",          "up a page"),
    k(A::First,                 &[HOME],                 "",          "first layout"),
    k(A::Last,                  &[END],                  "",          "last layout"),
    k(A::Find,                  &[c('/')],               "",          "find a layout by a part of its name"),
    k(A::Take,                  &[ENTER],                "select",    "select the marked layout and go back to it"),
    k(A::Study(SortNext),       &[c('>')],               "sort",      "sort by the next column"),
    k(A::Study(SortPrevious),   &[c('<')],               "",          "sort by the previous column; before the first is the project's order"),
    k(A::Study(Reverse),        &[c('-')],               "reverse",   "sort the other way round"),
    k(A::Study(NextColumn),     &[RIGHT, c('l')],        "columns",   "show further columns"),
    k(A::Study(PreviousColumn), &[LEFT, c('h')],         "",          "columns before"),
    k(A::Check,                 &[c('c')],               "check all", "check all layouts by simulation"),
];

/// The page of the design.
#[rustfmt::skip]
const DESIGN: &[Binding] = &[
    k(A::Down,                       &[DOWN, c('j')],          "",           "next value"),
    k(A::Up,                         &[UP, c('k')],            "",           "previous value"),
    k(A::First,                      &[HOME, PAGE_UP],         "",           "first value"),
    k(A::Last,                       &[END, PAGE_DOWN],        "",           "last value"),
    k(A::Take,                       &[ENTER],                 "take",       "take the marked value into the layout; undo takes it back"),
    k(A::Study(DesignForce),         &[c('F')],                "force",      "type the design force; a digit starts it too"),
    k(A::Study(AllowableDeflection), &[c('D')],                "deflection", "type the allowable deflection"),
    k(A::Study(LoadFactor),          &[c('L')],                "",           "type the partial factor on the load"),
    k(A::Study(ResistanceFactor),    &[c('R')],                "",           "type the partial factor on the resistance"),
    k(A::Study(NextColumn),          &[RIGHT, c('e'), c(' ')], "asked",      "what has to be met: force, deflection or both"),
    k(A::Study(PreviousColumn),      &[LEFT],                  "",           "the same back"),
    k(A::Check,                      &[c('c')],                "check",      "check the layout and every value that can be taken by simulation"),
    k(A::Fidelity,                   &[c('f')],                "",           FIDELITY),
    k(A::NextLayout,                 &[TAB],                   "",           "next layout"),
    k(A::PreviousLayout,             &[BACK_TAB],              "",           "previous layout"),
];

/// The page of the tolerance.
#[rustfmt::skip]
const TOLERANCE: &[Binding] = &[
    k(A::Study(NextColumn),     &[RIGHT, DOWN, c('e'), c(' ')], "next input", "the next input"),
    k(A::Study(PreviousColumn), &[LEFT, UP],                    "",           "the input before"),
    k(A::Type,                  &[ENTER],                       "off",        "type how far it may be off; a digit starts it too"),
    k(A::NextLayout,            &[TAB],                         "layout",     "next layout"),
    k(A::PreviousLayout,        &[BACK_TAB],                    "",           "previous layout"),
];

/// What holds on all screens but the main one, which says the same at its own place.
#[rustfmt::skip]
pub(super) const EVERYWHERE: &[Binding] = &[
    k(A::Help,    &[c('?'), F1], "help", "help, and back to here"),
    k(A::Redraw,  &[ctrl('l')],  "",     "draw the screen anew"),
    k(A::Suspend, &[ctrl('z')],  "",     "suspend"),
];

/// What holds on all pages of studies.
#[rustfmt::skip]
pub(super) const PAGES: &[Binding] = &[
    k(A::Close,          &[c('q'), ctrl('c')],            "back", "back"),
    k(A::Stop,           &[ESC, ctrl('g')],               "",     "end the checks that run, keeping what is done; else back"),
    k(A::Undo,           &[c('u')],                       "",     "undo"),
    k(A::Redo,           &[c('U'), ctrl('r'), ctrl('y')], "",     "redo"),
    k(A::Units,          &[c('t')],                       "",     "lengths in m or mm, or in ft or in"),
    k(A::Save,           &[ctrl('s')],                    "",     "save"),
    k(open(Sensitivity), &[c('s')],                       "",     "sensitivity"),
    k(open(Sweep),       &[c('w')],                       "",     "sweep"),
    k(open(Compare),     &[c('v')],                       "",     "compare"),
    k(open(Design),      &[c('g')],                       "",     "design"),
    k(open(Tolerance),   &[c('S')],                       "",     "tolerance"),
];
