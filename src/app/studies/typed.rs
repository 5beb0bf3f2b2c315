//! What is typed on the pages of studies.

use super::super::App;
use super::super::entry::Typed;

impl App {
    /// Takes a text.
    ///
    /// # Errors
    /// Why it is refused.
    pub(in crate::app) fn take_typed(&mut self, typed: Typed, text: &str) -> Result<(), String> {
        match typed {
            Typed::Design(field) => {
                let value = field.read(text, &self.layout().layout, self.units())?;
                self.field = field;
                self.set_field(value);
                Ok(())
            }
            Typed::Range(axis, slot) => self.take_slot(axis, slot, text),
        }
    }
}
