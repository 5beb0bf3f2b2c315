//! What a key can ask for.

use super::context::Context;
use crate::case::Input;

/// What a key can ask for. What that is stands with its keys, in [`super::table`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Action {
    FieldUp,
    FieldDown,
    Select(Input),
    StepDown,
    StepUp,
    CoarseDown,
    CoarseUp,
    Type,
    Clear,
    NextLayout,
    PreviousLayout,
    Add,
    Duplicate,
    Rename,
    Note,
    Delete,
    MoveUp,
    MoveDown,
    Overlay,
    PickMesh,
    /// The form of a mesh to be added to the project.
    AddMesh,
    /// The form of a mesh to be adopted from its tests.
    AdoptMesh,
    /// The marked mesh goes into the user's own catalogue too.
    KeepMesh,
    Branch,
    Blocks,
    /// The next kind of grid of the layout.
    Grid,
    /// The net turned under the layout.
    Twists,
    /// Other relations of the forecast.
    Method,
    Units,
    Basis,
    Undo,
    Redo,
    Save,
    Command,
    Details,
    Help,
    Suspend,
    Redraw,
    Quit,
    Up,
    Down,
    PageUp,
    PageDown,
    First,
    Last,
    Find,
    FindNext,
    Take,
    Close,
    SaveAndQuit,
    Discard,
    Overwrite,
    Restore,
    TakeOver,
    Reload,
    Check,
    CheckAll,
    Live,
    Fidelity,
    Stop,
    Export,
    NextWord,
    PreviousWord,
    Open,
    SaveAndOpen,
    CopyAnswer,
    CopyTable,
    CopyPage,
    NextStop,
    PreviousStop,
    Study(Ask),
}

/// The studies that have a page over the whole screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StudyPage {
    /// How the answer moves with each input.
    Sensitivity,
    /// One input over a range, or two over a map.
    Sweep,
    /// The layouts side by side.
    Compare,
    /// What just meets the design values.
    Design,
    /// One input off by so much.
    Tolerance,
}

impl StudyPage {
    /// The word for headings and messages.
    pub(crate) fn word(self) -> &'static str {
        match self {
            StudyPage::Sensitivity => "sensitivity",
            StudyPage::Sweep => "sweep",
            StudyPage::Compare => "compare",
            StudyPage::Design => "design",
            StudyPage::Tolerance => "tolerance",
        }
    }

    /// The screen whose keys hold on it.
    pub(crate) fn context(self) -> Context {
        match self {
            StudyPage::Sensitivity => Context::Sensitivity,
            StudyPage::Sweep => Context::Sweep,
            StudyPage::Compare => Context::Compare,
            StudyPage::Design => Context::Design,
            StudyPage::Tolerance => Context::Tolerance,
        }
    }
}

/// What a key can ask for on a page of a study, besides what it asks for elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ask {
    Open(StudyPage),
    NextColumn,
    PreviousColumn,
    SortNext,
    SortPrevious,
    Reverse,
    NextValue,
    MarkNext,
    MarkPrevious,
    SecondInput,
    /// The same as [`Ask::SecondInput`], but by a digit, which on a range begins a value.
    Two,
    Layer,
    Adopt,
    DesignForce,
    AllowableDeflection,
    LoadFactor,
    ResistanceFactor,
}
