//! What the selected layout gives where one input is not what it should be.

use super::super::keymap::Ask;
use super::given::Given;
use super::sweep::read;
use crate::case::{Case, Input};
use crate::problem::Problem;
use crate::study::sensitivity::step;
use crate::study::tolerance::{Tolerance, tolerance};
use crate::study::verdict::Basis;
use crate::units::Units;
use std::collections::HashMap;

/// What the page shows.
#[derive(Debug)]
pub struct ToleranceView {
    /// The tolerance of the chosen input, or why there is none.
    pub(crate) found: Result<Tolerance, Vec<Problem>>,
    pub(crate) input: Input,
}

/// Where the user is on the page.
#[derive(Debug, Default)]
pub(crate) struct ToleranceState {
    /// The chosen input, by its place among those that vary.
    chosen: usize,
    /// Whether the layout has a second spacing.
    two: bool,
    /// What was typed, m or N.
    typed: HashMap<Input, f64>,
    view: Option<ToleranceView>,
}

impl ToleranceState {
    /// What the page shows.
    pub(in crate::app) fn view(&self) -> Option<&ToleranceView> {
        self.view.as_ref()
    }

    fn input(&self) -> Input {
        Input::VARIED[self.chosen % Input::VARIED.len()]
    }

    /// Makes what the page shows anew. Where nothing was typed an input is off by its step in a sensitivity.
    pub(super) fn follow(&mut self, given: &Given) {
        let basis = given.editor.project().basis;
        let case = given.case();
        self.two = case.as_ref().is_some_and(|case| Input::SpacingUp.stands_in(&case.layout));
        if !self.two && self.input() == Input::SpacingUp {
            self.step(-1);
        }
        let input = self.input();
        self.view = case.filter(|case| case.get(input).is_some()).map(|case| {
            let off = self.typed.get(&input).copied().unwrap_or_else(|| step(&case, input));
            ToleranceView { found: tolerance(&case, input, off, basis), input }
        });
    }

    /// What a key asks for.
    pub(super) fn ask(&mut self, ask: Ask) {
        match ask {
            Ask::NextColumn => self.step(1),
            Ask::PreviousColumn => self.step(-1),
            _ => {}
        }
    }

    /// Another input, round and round.
    pub(super) fn step(&mut self, by: isize) {
        let count = Input::VARIED.len();
        let by = by.clamp(-(count as isize), count as isize);
        self.chosen = (self.chosen + count).saturating_add_signed(by) % count;
        if !self.two && self.input() == Input::SpacingUp {
            let on = if by < 0 { count - 1 } else { 1 };
            self.chosen = (self.chosen + on) % count;
        }
    }

    /// Takes how far the input may be off.
    ///
    /// # Errors
    /// Why it is refused.
    pub(super) fn take(&mut self, case: &Case, text: &str, unit: Units) -> Result<(), String> {
        let (input, off) = (self.input(), read(self.input(), text, unit)?);
        tolerance(case, input, off, Basis::default()).map_err(|found| found[0].to_string())?;
        self.typed.insert(input, off);
        Ok(())
    }
}
