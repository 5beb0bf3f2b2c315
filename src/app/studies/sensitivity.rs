//! The sensitivity of the selected layout: forecast at once, checks where they were asked for.

use super::super::keymap::{Ask, StudyPage};
use super::super::work::campaign::Coverage;
use super::given::Given;
use super::neighbour;
use crate::case::Case;
use crate::study::sensitivity::dem::{self, CheckedSensitivity};
use crate::study::sensitivity::{Effect, Sensitivity, sensitivity};

/// What the page shows.
#[derive(Debug)]
pub struct SensitivityView {
    /// The layout as a case.
    pub case: Case,
    /// How its forecast moves, in m, N and parts of 1.
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
    /// What the page shows.
    pub(in crate::app) fn view(&self) -> Option<&SensitivityView> {
        self.view.as_ref()
    }

    /// Makes what the page shows anew.
    pub(super) fn follow(&mut self, given: &Given) {
        self.view = given.case().map(|case| {
            let cases = dem::cases(&case);
            let answers = given.answers(&cases);
            let asked = case.asked().force.is_some();
            let effect = self.effect.filter(|e| Effect::all(asked).contains(e));
            let purpose = given.purpose(StudyPage::Sensitivity, 0);
            SensitivityView {
                forecast: sensitivity(&case),
                checked: dem::assemble(&case, &answers),
                coverage: given.coverage(purpose, &cases, &answers),
                effect: effect.unwrap_or(Effect::Force),
                scroll: self.scroll,
                case,
            }
        });
    }

    /// The cases to check.
    pub(super) fn cases(&self) -> Vec<Case> {
        self.view.as_ref().map_or(Vec::new(), |view| dem::cases(&view.case))
    }

    /// What a key asks for. `asked` says whether a design force is set.
    pub(super) fn ask(&mut self, ask: Ask, asked: bool) {
        let next = match ask {
            Ask::NextColumn => true,
            Ask::PreviousColumn => false,
            _ => return,
        };
        let now = self.view.as_ref().map_or(Effect::Force, |view| view.effect);
        self.effect = Some(neighbour(now, next, asked));
    }

    /// Scrolls the bars.
    pub(super) fn scroll(&mut self, lines: isize) {
        // Two lines an input.
        let inputs = self.view.as_ref().map_or(0, |view| view.checked.bars.len());
        let most = (2 * inputs).saturating_sub(2);
        self.scroll = self.scroll.saturating_add_signed(lines).min(most);
    }
}
