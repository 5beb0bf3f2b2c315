//! What is typed on a page of a study: a design value of the layout.

use super::super::App;
use super::super::field::Field;
use super::Page;

/// What a typed text is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Typed {
    /// A design value or a partial factor of the selected layout.
    Design(Field),
}

impl Typed {
    /// The page it belongs to.
    pub fn page(self) -> Page {
        match self {
            Typed::Design(_) => Page::Compare,
        }
    }

    /// What the prompt says.
    pub fn prompt(self) -> &'static str {
        match self {
            Typed::Design(field) => field.phrase(),
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
            }
        }
        Ok(())
    }
}
