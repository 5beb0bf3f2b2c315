//! The sensitivity of the selected layout: forecast at once, checks where they were asked for.

use super::super::App;
use super::super::keymap::{Ask, StudyPage};
use super::campaign::Coverage;
use super::neighbour;
use crate::case::Case;
use crate::study::checks::CheckAnswer;
use crate::study::sensitivity::dem::{self, CheckedSensitivity};
use crate::study::sensitivity::{Effect, Sensitivity, sensitivity};

/// What the page shows.
#[derive(Debug)]
pub struct SensitivityView {
    /// The layout as a case.
    pub case: Case,
    /// By the forecast.
    pub forecast: Sensitivity,
    /// By checks, as far as there are any.
    pub checked: CheckedSensitivity,
    /// How much of it is checked.
    pub coverage: Coverage,
    /// The value whose changes are shown.
    pub effect: Effect,
    /// First line of the bars that is shown.
    pub scroll: usize,
}

/// Where the user is on the page.
#[derive(Debug, Default)]
pub(crate) struct SensitivityState {
    effect: Option<Effect>,
    scroll: usize,
    view: Option<SensitivityView>,
}

impl SensitivityState {
    /// The cases to check.
    pub(super) fn cases(&self) -> Vec<Case> {
        self.view.as_ref().map_or(Vec::new(), |view| dem::cases(&view.case))
    }
}

impl App {
    /// The sensitivity; nothing where the page is not open or the layout's mesh is not known.
    pub fn sensitivity(&self) -> Option<&SensitivityView> {
        self.studies.sensitivity.view.as_ref()
    }

    pub(super) fn make_sensitivity(&mut self) {
        let view = self.case(self.selected).map(|case| {
            let cases = dem::cases(&case);
            let answers: Vec<CheckAnswer> = cases.iter().map(|case| self.found(case)).collect();
            let asked = case.question.force.is_some();
            let state = &self.studies.sensitivity;
            let effect = state.effect.filter(|e| asked || *e != Effect::Utilisation);
            SensitivityView {
                forecast: sensitivity(&case),
                checked: dem::assemble(&case, &answers),
                coverage: self.coverage(self.purpose(StudyPage::Sensitivity, 0), &cases, &answers),
                effect: effect.unwrap_or(Effect::Force),
                scroll: state.scroll,
                case,
            }
        });
        self.studies.sensitivity.view = view;
    }

    pub(super) fn sensitivity_ask(&mut self, ask: Ask) {
        let next = match ask {
            Ask::NextColumn => true,
            Ask::PreviousColumn => false,
            _ => return,
        };
        let asked = self.layout().question.force.is_some();
        let state = &mut self.studies.sensitivity;
        let now = state.view.as_ref().map_or(Effect::Force, |view| view.effect);
        state.effect = Some(neighbour(now, next, asked));
    }

    pub(super) fn sensitivity_move(&mut self, lines: isize) {
        // Two lines an input.
        let most = 2 * crate::case::Input::VARIED.len() - 2;
        let state = &mut self.studies.sensitivity;
        state.scroll = state.scroll.saturating_add_signed(lines).min(most);
    }
}
