//! Tolerance: what a layout gives where one input is not what it should be, as a hole that is drilled
//! beside its mark or a block that is larger than it was taken to be, by the forecast.
//!
//! The input goes from its value less the tolerance to its value plus it. The worst need not be at an
//! end, for a branch of Eqs. A.1-A.2 or a limit of the method may lie between them.

use super::sensitivity::{Change, change};
use super::sweep::SweepAxis;
use super::verdict::{Basis, Simulated, Verdict, verdict};
use crate::case::{Case, CaseValue, Input};
use crate::problem::Problem;
use crate::units::without_noise;

/// Values that are looked at, both ends and the middle among them.
pub(crate) const VALUES: usize = 81;

/// What a layout gives over the tolerance of an input.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tolerance {
    pub(crate) input: Input,
    /// How far the input may be off either way, m or N, above 0.
    pub(crate) off: f64,
    /// The input as low as it may be, as it should be, as high as it may be, and where it is worst.
    pub(crate) places: [TolerancePlace; 4],
}

/// One value of the input.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TolerancePlace {
    /// `low`, `planned`, `high` or `worst`.
    pub(crate) word: &'static str,
    /// The input, m or N.
    pub(crate) value: f64,
    /// What the case gives there, or why it has no value.
    pub(crate) outcome: CaseValue,
    /// Change against the input as it should be; nothing where either has no values.
    pub(crate) change: Option<Change>,
    /// Whether it is enough there.
    pub(crate) verdict: Verdict,
}

impl TolerancePlace {
    /// How bad it is: a place without values is the worst of all, then the largest use decides, and
    /// the lowest force where no load is set.
    fn badness(&self) -> f64 {
        match (&self.outcome, self.verdict.largest_use()) {
            (Err(_), _) => f64::INFINITY,
            (Ok(_), Some(usage)) => usage,
            (Ok(point), None) => -point.values().force,
        }
    }
}

/// The tolerance of an input of a case.
///
/// # Errors
/// The tolerance is not above 0, by `off`.
pub(crate) fn tolerance(
    case: &Case,
    input: Input,
    off: f64,
    basis: Basis,
) -> Result<Tolerance, Vec<Problem>> {
    let value = input.value(case);
    if !value.is_finite() {
        let problem = Problem::new(input.word(), "this layout has no such value to be off");
        return Err(vec![problem]);
    }
    let [from, to] = [value - off, value + off].map(without_noise);
    if !(off > 0.0 && off.is_finite()) {
        let problem = Problem::new("off", "a tolerance is above 0").value(input.text(off));
        return Err(vec![problem]);
    }
    // An end may make no sense, as a block of no size: then that is what there is to say of it.
    let axis = SweepAxis { input, from, to, steps: VALUES };
    let planned = case.outcome();
    let place = |word, value| {
        let moved = case.with(input, value);
        let outcome = moved.outcome();
        let verdict = verdict(&moved, &outcome, Simulated::Missing, basis);
        TolerancePlace { word, value, change: change(&planned, &outcome), outcome, verdict }
    };
    let ends = [place("low", from), place("planned", value), place("high", to)];
    // Of equals the first one, and the planned value before all.
    let mut worst = ends[1].clone();
    for value in axis.values() {
        let here = place("worst", value);
        if here.badness() > worst.badness() {
            worst = here;
        }
    }
    let [low, planned, high] = ends;
    let worst = TolerancePlace { word: "worst", ..worst };
    Ok(Tolerance { input, off, places: [low, planned, high, worst] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{NoValue, example};
    use crate::layout::{Layout, REFERENCE};

    fn of(case: &Case, input: Input, off: f64) -> Tolerance {
        tolerance(case, input, off, Basis::Mean).unwrap()
    }

    #[test]
    fn a_plate_that_is_smaller_than_planned_worked_by_hand() {
        // F_a = 29.1 x (1.5 d + 0.45) kN here: 32 mm less of d = 0.32 m is 29.1 x 0.048 kN less.
        let t = of(&example(REFERENCE, None), Input::Plate, 0.032);
        let [low, planned, high, worst] = &t.places;
        assert_eq!((low.value, planned.value, high.value), (0.288, 0.32, 0.352));
        assert!((low.change.unwrap().force + 29_100.0 * 0.048).abs() < 1e-6);
        assert!((high.change.unwrap().force - 29_100.0 * 0.048).abs() < 1e-6);
        assert_eq!((worst.value, worst.word), (0.288, "worst"));
    }

    #[test]
    fn the_worst_may_lie_between_the_ends() {
        // The force is the lowest where the block hits the middle of its cell, and rises to both sides.
        let t = of(&example(REFERENCE, Some(10_000.0)), Input::OffsetX, 0.6);
        let [low, planned, high, worst] = &t.places;
        let use_of = |p: &TolerancePlace| p.outcome.as_ref().unwrap().utilisation().unwrap();
        assert!(use_of(low) <= use_of(worst) && use_of(high) <= use_of(worst));
        assert!(use_of(planned) <= use_of(worst));
        // Half a metre of D either way passes a value of D where the forecast jumps, D = d.
        let near = Layout { punch: 0.3, ..REFERENCE };
        let t = of(&example(near, Some(10_000.0)), Input::Punch, 0.1);
        assert!(
            t.places[2].change.unwrap().other_branch && !t.places[0].change.unwrap().other_branch
        );
    }

    #[test]
    fn a_place_without_a_value_is_the_worst() {
        // Punch 0.55 m from the plate's edge in x, D/2 = 0.5: 0.15 m more runs onto the plate.
        let t = of(&example(Layout { ex: 0.79, ey: 1.5, ..REFERENCE }, None), Input::OffsetX, 0.15);
        assert!(t.places[3].outcome.is_err() && t.places[0].outcome.is_ok());
        assert!(t.places[3].value <= t.places[2].value);
    }

    #[test]
    fn an_end_that_makes_no_sense_is_said_and_the_others_stand() {
        let t = of(&example(REFERENCE, None), Input::Punch, 1.0);
        assert!(matches!(t.places[0].outcome, Err(NoValue::Senseless(_))));
        assert!(t.places[1].outcome.is_ok() && t.places[3].outcome.is_err());
    }

    #[test]
    fn what_is_no_tolerance_is_refused() {
        for off in [0.0, -0.1, f64::NAN, f64::INFINITY] {
            let found = tolerance(&example(REFERENCE, None), Input::Plate, off, Basis::Mean);
            assert_eq!(found.unwrap_err()[0].field, "off", "{off}");
        }
    }
}
