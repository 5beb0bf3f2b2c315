//! What is typed on a page of a study.

use super::super::App;
use super::super::field::Field;
use super::super::keymap::StudyPage;

use super::sweep::Slot;

/// What a typed text is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Typed {
    /// A design value or a partial factor of the selected layout.
    Design(Field),
    /// A part of a range: of the first input (0) or the second (1), and which.
    Range(usize, Slot),
}

impl Typed {
    /// The page it belongs to.
    pub(crate) fn page(self) -> StudyPage {
        match self {
            Typed::Design(_) => StudyPage::Design,
            Typed::Range(..) => StudyPage::Sweep,
        }
    }

    /// What the prompt says.
    pub(crate) fn prompt(self) -> &'static str {
        match self {
            Typed::Design(field) => field.phrase(),
            Typed::Range(_, Slot::Input) => "input",
            Typed::Range(_, Slot::From) => "from",
            Typed::Range(_, Slot::To) => "to",
            Typed::Range(_, Slot::Steps) => "number of values",
        }
    }
}

impl App {
    /// Takes a text.
    ///
    /// # Errors
    /// Why it is refused.
    pub(in crate::app) fn take_typed(&mut self, typed: Typed, text: &str) -> Result<(), String> {
        match typed {
            Typed::Design(field) => {
                let value = field.read(text, self.layout(), self.units())?;
                self.field = field;
                self.set_field(value);
                Ok(())
            }
            Typed::Range(axis, slot) => self.take_slot(axis, slot, text),
        }
    }
}
