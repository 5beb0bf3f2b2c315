//! Sensitivity by checks: the same steps as by the forecast, each case an ensemble with the same seeds.
//!
//! The laboratory values are no input of a check, so their steps have none. A change holds what the
//! net does besides: it is stretched to a whole number of openings in each panel, so a step of L moves
//! that too.

use super::{Effect, ends};
use crate::case::{Case, Input};
use crate::study::checks::change::{CheckChange, KnownValue, change};
use crate::study::checks::{CheckAnswer, NoCheck};

/// How the checked values of a case move.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckedSensitivity {
    /// The case itself.
    pub base: CheckAnswer,
    /// One for each input, in the order of [`Input::VARIED`].
    pub bars: Vec<CheckedBar>,
}

/// One input, moved down and up.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckedBar {
    pub input: Input,
    /// Its value in the case, m or N.
    pub value: f64,
    /// One step down.
    pub lowered: CheckedStep,
    /// One step up.
    pub raised: CheckedStep,
}

/// An input moved by one step.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckedStep {
    /// The value that it is moved to, m or N.
    pub value: f64,
    /// The check there, or why there is none.
    pub answer: CheckAnswer,
    /// Change against the case; nothing where either has no first break.
    pub change: Option<CheckChange>,
}

impl CheckChange {
    /// The change of one value.
    pub(crate) fn of(&self, effect: Effect) -> Option<KnownValue> {
        match effect {
            Effect::Force => Some(self.force),
            Effect::Deflection => Some(self.deflection),
            Effect::Utilisation => self.utilisation,
            // Of a check the mean curve gives none.
            Effect::Service => None,
        }
    }
}

impl CheckedBar {
    /// The larger change of the two steps, without its sign; 0 where neither is known.
    pub(crate) fn largest(&self, effect: Effect) -> f64 {
        let size = |s: &CheckedStep| {
            s.change.and_then(|c| c.of(effect)).map_or(0.0, |known| known.value.abs())
        };
        size(&self.lowered).max(size(&self.raised))
    }
}

impl CheckedSensitivity {
    /// The bars by falling effect; equal ones in the order of [`Input::VARIED`].
    pub(crate) fn by(&self, effect: Effect) -> Vec<&CheckedBar> {
        let mut bars: Vec<&CheckedBar> = self.bars.iter().collect();
        bars.sort_by(|a, b| b.largest(effect).total_cmp(&a.largest(effect)));
        bars
    }

    /// The bar of an input.
    pub(crate) fn bar(&self, input: Input) -> Option<&CheckedBar> {
        self.bars.iter().find(|bar| bar.input == input)
    }
}

/// The inputs that a check knows.
fn checked(case: &Case) -> impl Iterator<Item = Input> {
    Input::varied(&case.layout).filter(|input| !input.is_laboratory())
}

/// The cases to check, eleven on a square grid: the case itself, then for each input that a check knows one step down
/// and one step up.
pub(crate) fn cases(case: &Case) -> Vec<Case> {
    let moved =
        checked(case).flat_map(|input| ends(case, input).map(|value| case.with(input, value)));
    std::iter::once(case.clone()).chain(moved).collect()
}

/// Puts the answers to [`cases`] together, in their order; those that are not there yet are
/// [`NoCheck::NotMade`], so a part of them is good for a part of the tornado.
pub(crate) fn assemble(case: &Case, answers: &[CheckAnswer]) -> CheckedSensitivity {
    let mut answers = answers.iter().cloned();
    let mut next = || answers.next().unwrap_or(Err(NoCheck::NotMade));
    let base = next();
    let bars = Input::varied(&case.layout)
        .map(|input| {
            let [lowered, raised] = ends(case, input).map(|value| {
                let answer = if input.is_laboratory() { Err(NoCheck::Laboratory) } else { next() };
                let both = base.as_ref().ok().zip(answer.as_ref().ok());
                let change = both.and_then(|(from, to)| change(from, to, &case.question));
                CheckedStep { value, answer, change }
            });
            CheckedBar { input, value: input.value(case), lowered, raised }
        })
        .collect();
    CheckedSensitivity { base, bars }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::example;
    use crate::dem::Flow;
    use crate::layout::{Grid, Layout};
    use crate::study::checks::checks;
    use crate::study::checks::tests::{SMALL, two};

    #[test]
    fn each_step_has_its_case_and_laboratory_values_have_none() {
        let case = example(SMALL, Some(4_000.0));
        let cases = cases(&case);
        assert_eq!(cases.len(), 11);
        let answers = checks(&cases, &two(), 1, &|_| Flow::Continue);
        let s = assemble(&case, &answers);
        assert_eq!(s.base, answers[0]);
        for (place, input) in checked(&case).enumerate() {
            let bar = s.bar(input).unwrap();
            let [low, high] = [1 + 2 * place, 2 + 2 * place];
            assert_eq!((&bar.lowered.answer, &bar.raised.answer), (&answers[low], &answers[high]));
            assert_eq!(bar.raised.value, input.value(&cases[high]));
            let change = bar.raised.change.unwrap();
            assert!(change.utilisation.is_some(), "{input:?}");
            // Another punch leaves the plates and the net as they are; another plate, spacing or an offset
            // gives other patterns of caught nodes.
            assert_eq!(change.paired, input == Input::Punch, "{input:?}");
        }
        for input in [Input::LabForce, Input::LabDeflection] {
            let bar = s.bar(input).unwrap();
            assert_eq!(bar.lowered.answer, Err(NoCheck::Laboratory));
            assert_eq!((bar.raised.change, bar.largest(Effect::Force)), (None, 0.0));
        }
        let order = s.by(Effect::Force);
        assert!(
            order
                .windows(2)
                .all(|w| { w[0].largest(Effect::Force) >= w[1].largest(Effect::Force) })
        );
        // A part of the answers is a part of the tornado.
        let part = assemble(&case, &answers[..2]);
        assert!(part.bars[0].lowered.change.is_some());
        assert_eq!(part.bars[0].raised.answer, Err(NoCheck::NotMade));
        assert_eq!(assemble(&case, &[]).base, Err(NoCheck::NotMade));
    }

    #[test]
    fn a_grid_of_two_spacings_has_both_moved() {
        let grid = Grid { up: Some(1.6), ..SMALL.grid };
        let case = example(Layout { grid, ..SMALL }, None);
        let cases = cases(&case);
        // Itself, and two steps of d, Lx, Ly, D, ex, ey.
        assert_eq!(cases.len(), 13);
        assert_eq!([5, 6].map(|k: usize| cases[k].layout.grid.up), [Some(1.44), Some(1.76)]);
        assert!(assemble(&case, &[]).bar(Input::SpacingUp).is_some());
    }
}
