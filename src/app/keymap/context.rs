//! The screens that have keys of their own.

/// A screen with keys of its own. Text entry has none: there every key is text or edits it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Context {
    /// The main screen.
    Main,
    /// The main screen of a project without layouts.
    Empty,
    /// Help and details: text that scrolls.
    Pager,
    /// The list of meshes.
    MeshPicker,
    MeshForm,
    /// The form of a mesh to be adopted from its tests.
    AdoptForm,
    /// The question before quitting with unsaved edits.
    ConfirmQuit,
    /// The question before replacing a file that changed on disk.
    ConfirmOverwrite,
    /// The question whether to take back edits kept from a session that was cut off.
    ConfirmRecovery,
    /// The question before taking a file over from another session.
    ConfirmTakeOver,
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
    /// One input off by so much.
    Tolerance,
}

impl Context {
    /// All screens, in the order of the help.
    pub(crate) const ALL: [Context; 20] = [
        Context::Main,
        Context::Empty,
        Context::Pager,
        Context::MeshPicker,
        Context::MeshForm,
        Context::AdoptForm,
        Context::ConfirmQuit,
        Context::ConfirmOverwrite,
        Context::ConfirmRecovery,
        Context::ConfirmTakeOver,
        Context::Settings,
        Context::Open,
        Context::ConfirmOpen,
        Context::Tour,
        Context::Export,
        Context::Sensitivity,
        Context::Sweep,
        Context::Compare,
        Context::Design,
        Context::Tolerance,
    ];

    /// Whether it is a page of a study.
    pub(crate) fn is_study(self) -> bool {
        use Context as C;
        matches!(self, C::Sensitivity | C::Sweep | C::Compare | C::Design | C::Tolerance)
    }

    /// Whether it is a question; the hints of its keys ask it.
    pub(crate) fn asks(self) -> bool {
        use Context as C;
        matches!(
            self,
            C::ConfirmQuit
                | C::ConfirmOverwrite
                | C::ConfirmRecovery
                | C::ConfirmTakeOver
                | C::ConfirmOpen
        )
    }

    /// Heading in the help.
    pub(crate) fn heading(self) -> &'static str {
        match self {
            Context::Main => "Main screen",
            Context::Empty => "Main screen of a project without layouts",
            Context::Pager => "Help and details",
            Context::MeshPicker => "Mesh list",
            Context::MeshForm => "A mesh to add",
            Context::AdoptForm => "A mesh to adopt from its tests",
            Context::ConfirmQuit => "Unsaved edits",
            Context::ConfirmOverwrite => "File changed on disk",
            Context::ConfirmRecovery => "Edits kept from a lost session",
            Context::ConfirmTakeOver => "File held by another session",
            Context::Settings => "Settings",
            Context::Open => "List of projects",
            Context::ConfirmOpen => "Unsaved edits before opening",
            Context::Tour => "Tour",
            Context::Export => "What to write",
            Context::Sensitivity => "Sensitivity; the keys from q on hold on all pages of studies",
            Context::Sweep => "Sweep",
            Context::Compare => "Compare",
            Context::Design => "Design",
            Context::Tolerance => "Tolerance",
        }
    }
}
