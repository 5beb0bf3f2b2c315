//! What a check says beside a forecast, read once for every way to show it. Newtons and metres.

use super::{Difference, difference, utilisation};
use crate::forecast::design::Question;
use crate::forecast::{Strength, Values};
use crate::study::result::CheckResult;

/// The figures of a check; without a first break there are no means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Mean force and deflection at the first break.
    pub(crate) mean: Option<Values>,
    /// Their standard errors; nothing where a single run broke.
    pub(crate) error: Option<Values>,
    /// 5 % and 95 % points of the force, where a run counts.
    pub(crate) force_band: Option<[f64; 2]>,
    /// Likewise of the deflection.
    pub(crate) deflection_band: Option<[f64; 2]>,
    /// Utilisation by the mean force, where a design force is set.
    pub(crate) utilisation: Option<f64>,
    /// How far the means are from the forecast, where both are there.
    pub(crate) difference: Option<Difference>,
}

impl Figures {
    /// Of a check beside a forecast, where there is one, for a design question.
    pub(crate) fn of(
        result: &CheckResult,
        forecast: Option<Strength>,
        question: &Question,
    ) -> Figures {
        let (force, deflection) = (&result.force, &result.deflection);
        let several = result.breaks.len() > 1;
        let counted = result.runs > 0;
        let mean = result.broke().then_some(Values::new(force.mean, deflection.mean));
        Figures {
            mean,
            error: mean.filter(|_| several).map(|_| Values::new(force.error, deflection.error)),
            force_band: counted.then_some(force.band),
            deflection_band: counted.then_some(deflection.band),
            utilisation: mean.and_then(|v| utilisation(question, v.force)),
            difference: forecast.and_then(|forecast| difference(result, forecast)),
        }
    }
}
