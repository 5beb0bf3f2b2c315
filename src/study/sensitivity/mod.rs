//! Sensitivity: how F_a, delta_a and the utilisation of a case move with each of its inputs, both
//! ways, by the forecast.
//!
//! Step: 10 % of d, L (Lx and Ly), D, F_l* and delta_l*, a twentieth of L for ex and ey. Each input moves alone;
//! with L the offsets stay as they are in metres.
//!
//! - [`dem`]: the same by checks.

pub(crate) mod dem;

use crate::case::{Case, CaseValue, Input};
use crate::units::without_noise;

/// Step of d, L, D, F_l* and delta_l* as a part of the value.
pub(crate) const RELATIVE_STEP: f64 = 0.1;
/// Step of ex and ey as a part of the spacing, of the smaller one where there are two.
pub(crate) const OFFSET_STEP: f64 = 0.05;

/// Size of an input's step in a case, m or N, above 0.
pub(crate) fn step(case: &Case, input: Input) -> f64 {
    if input.is_offset() {
        OFFSET_STEP * case.layout.least()
    } else {
        RELATIVE_STEP * input.value(case)
    }
}

/// The value of an input one step down and one step up, m or N, without the noise of the product, so
/// that D = 1.1 d is met where it is meant.
pub(crate) fn ends(case: &Case, input: Input) -> [f64; 2] {
    let (value, step) = (input.value(case), step(case, input));
    [without_noise(value - step), without_noise(value + step)]
}

/// The cases of a sensitivity, fourteen on a square grid: for each input in the order of [`Input::VARIED`]
/// one step down, then one step up.
pub fn cases(case: &Case) -> Vec<Case> {
    Input::varied(&case.layout)
        .flat_map(|input| ends(case, input).map(|value| case.with(input, value)))
        .collect()
}

/// How the values of a case move.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The case itself.
    pub base: CaseValue,
    /// One for each input, in the order of [`Input::VARIED`].
    pub bars: Vec<Bar>,
}

/// One input, moved down and up.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    pub input: Input,
    /// Its value in the case, m or N.
    pub value: f64,
    /// One step down.
    pub lowered: Step,
    /// One step up.
    pub raised: Step,
}

/// An input moved by one step.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The value that it is moved to, m or N.
    pub value: f64,
    /// What the case gives there, or why the step is not possible.
    pub outcome: CaseValue,
    /// Change against the case; nothing where either has no values.
    pub change: Option<Change>,
}

/// Change of a case's values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Of F_a, N.
    pub force: f64,
    /// Of delta_a, m, where it is known both times.
    pub deflection: Option<f64>,
    /// Of the utilisation, where a design force is set; 0.01 is one per cent of the resistance.
    pub utilisation: Option<f64>,
    /// Of the service deflection, where a design force is set and reached both times, m.
    pub service: Option<f64>,
    /// Of F_a, as a part of the case's.
    pub force_part: f64,
    /// Of delta_a, as a part of the case's.
    pub deflection_part: Option<f64>,
    /// Whether another branch of Eqs. A.1-A.2 is taken, so that the change holds a jump.
    pub other_branch: bool,
}

/// The value whose change is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// F_a, N.
    Force,
    /// delta_a, m.
    Deflection,
    /// Utilisation, dimensionless.
    Utilisation,
    /// Deflection at the design force without its factor, m.
    Service,
}

impl Effect {
    /// Those there are, in the order shown; the last two only where a design force is set.
    pub(crate) fn all(asked: bool) -> &'static [Effect] {
        let all = &[Effect::Force, Effect::Deflection, Effect::Utilisation, Effect::Service];
        if asked { all } else { &all[..2] }
    }
}

impl Change {
    /// The change of one value.
    pub(crate) fn of(&self, effect: Effect) -> Option<f64> {
        match effect {
            Effect::Force => Some(self.force),
            Effect::Deflection => self.deflection,
            Effect::Utilisation => self.utilisation,
            Effect::Service => self.service,
        }
    }
}

impl Bar {
    /// The larger change of the two steps, without its sign; 0 where neither is possible.
    pub(crate) fn largest(&self, effect: Effect) -> f64 {
        let size = |s: &Step| s.change.and_then(|c| c.of(effect)).map_or(0.0, f64::abs);
        size(&self.lowered).max(size(&self.raised))
    }
}

impl Sensitivity {
    /// The bars by falling effect, as a tornado shows them; equal ones in the order of [`Input::VARIED`].
    pub(crate) fn by(&self, effect: Effect) -> Vec<&Bar> {
        let mut bars: Vec<&Bar> = self.bars.iter().collect();
        bars.sort_by(|a, b| b.largest(effect).total_cmp(&a.largest(effect)));
        bars
    }
}

/// The sensitivity of a case by the forecast.
pub fn sensitivity(case: &Case) -> Sensitivity {
    let base = case.outcome();
    let step = |input: Input, value: f64| {
        let outcome = case.with(input, value).outcome();
        Step { value, change: change(&base, &outcome), outcome }
    };
    let bars = Input::varied(&case.layout)
        .filter(|input| case.get(*input).is_some())
        .map(|input| {
            let [low, high] = ends(case, input);
            let (lowered, raised) = (step(input, low), step(input, high));
            Bar { input, value: input.value(case), lowered, raised }
        })
        .collect();
    Sensitivity { base, bars }
}

/// How the values of a case move; nothing where either has none.
pub(super) fn change(base: &CaseValue, moved: &CaseValue) -> Option<Change> {
    let (Ok(base), Ok(moved)) = (base, moved) else { return None };
    let (from, to) = (base.values(), moved.values());
    let deflection = to.deflection.zip(from.deflection);
    Some(Change {
        force: to.force - from.force,
        deflection: deflection.map(|(to, from)| to - from),
        utilisation: moved.utilisation().zip(base.utilisation()).map(|(to, from)| to - from),
        service: (moved.service_deflection().zip(base.service_deflection()))
            .map(|(to, from)| to - from),
        force_part: to.force / from.force - 1.0,
        deflection_part: deflection.map(|(to, from)| to / from - 1.0),
        other_branch: moved.branch() != base.branch(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{NoValue, example as case};
    use crate::forecast::NoField;
    use crate::layout::{Layout, REFERENCE};

    fn bar(s: &Sensitivity, input: Input) -> &Bar {
        s.bars.iter().find(|b| b.input == input).unwrap()
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-9 * b.abs().max(1e-3)
    }

    #[test]
    fn the_reference_panel_worked_by_hand() {
        // F_a = 29.1 x (0.06 D + 0.94) x (1.5 d + 0.45) x (0.16 L/3 + 0.84) kN, 27.063 kN here.
        let s = sensitivity(&case(REFERENCE, Some(13_531.5)));
        let raised = |input| bar(&s, input).raised.change.unwrap();
        let lowered = |input| bar(&s, input).lowered.change.unwrap();
        // d + 10 %: 1.5 x 0.032 = 0.048 of 0.93.
        assert!(close(raised(Input::Plate).force, 29_100.0 * 0.048));
        // L + 10 %: 0.016 of 1; delta in proportion.
        assert!(close(raised(Input::Spacing).force_part, 0.016));
        assert!(close(raised(Input::Spacing).deflection_part.unwrap(), 0.1));
        // D - 10 %: 0.006 less of 1; delta 0.03 x 0.81 - 0.16 x 0.9 + 1.13 = 1.0103 of 1.
        assert!(close(lowered(Input::Punch).force_part, -0.006));
        assert!(close(lowered(Input::Punch).deflection_part.unwrap(), 0.0103));
        // F_l* and delta_l* scale their own and leave the other alone.
        assert!(close(lowered(Input::LabForce).force, -2_706.3));
        assert_eq!(lowered(Input::LabForce).deflection, Some(0.0));
        assert!(close(raised(Input::LabDeflection).deflection.unwrap(), 0.063_504));
        // Utilisation 0.5: over 1.1 it is 0.4545...
        assert!(close(raised(Input::LabForce).utilisation.unwrap(), 0.5 / 1.1 - 0.5));
        // The step of the offsets is a twentieth of 3 m.
        let ex = bar(&s, Input::OffsetX);
        assert_eq!((ex.lowered.value, ex.raised.value), (-0.15, 0.15));
        assert_eq!(ex.lowered.change, ex.raised.change);
        let order: Vec<Input> = s.by(Effect::Force).iter().map(|b| b.input).collect();
        assert_eq!(order[0], Input::LabForce);
        assert_eq!(order.last(), Some(&Input::LabDeflection), "it does not move F at all");
        assert_eq!(cases(&case(REFERENCE, None)).len(), 14);
    }

    #[test]
    fn a_step_over_the_branch_change_is_marked() {
        // D = 0.30 m, d = 0.32 m: D + 10 % = 0.33 m is above d.
        let s = sensitivity(&case(Layout { punch: 0.3, ..REFERENCE }, None));
        assert!(bar(&s, Input::Punch).raised.change.unwrap().other_branch);
        assert!(!bar(&s, Input::Punch).lowered.change.unwrap().other_branch);
        // Exactly D = d is still the small punch: 0.3 x 1.1 is noisy in floating point.
        let s = sensitivity(&case(Layout { punch: 0.33, plate: 0.3, ..REFERENCE }, None));
        assert!(bar(&s, Input::Plate).raised.change.unwrap().other_branch);
        assert_eq!(bar(&s, Input::Plate).raised.value, 0.33);
    }

    #[test]
    fn steps_that_are_not_possible_say_why() {
        // Punch 0.55 m from the plate's edge in x, D/2 = 0.5: a step of 0.15 m runs onto the plate.
        let s = sensitivity(&case(Layout { ex: 0.79, ey: 1.5, ..REFERENCE }, None));
        let raised = &bar(&s, Input::OffsetX).raised;
        assert_eq!(
            (&raised.outcome, raised.change),
            (&Err(NoValue::Outside(NoField::PunchOnPlate)), None)
        );
        assert!(bar(&s, Input::OffsetX).lowered.change.is_some());
        // D = 0.95 L: 10 % more is beyond L, and L less is below D.
        let s = sensitivity(&case(
            Layout { plate: 0.05, spacing: 3.0, punch: 2.85, ex: 0.0, ey: 0.0, ..REFERENCE },
            None,
        ));
        for step in [&bar(&s, Input::Punch).raised, &bar(&s, Input::Spacing).lowered] {
            assert!(matches!(step.outcome, Err(NoValue::Senseless(_))), "{step:?}");
        }
        // A case without values has no changes, but its steps stand.
        let s = sensitivity(&case(Layout { ex: 1.5, ey: 1.5, ..REFERENCE }, None));
        assert!(s.base.is_err() && s.bars.iter().all(|b| b.raised.change.is_none()));
    }
}
