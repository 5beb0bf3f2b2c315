//! What a check says beside a forecast, read once for every way to show it. Newtons and metres.

use super::{Difference, difference, utilisation};
use crate::forecast::Values;
use crate::forecast::design::Question;
use crate::study::verdict::Verdict;

/// The figures of a check; without a first break there are no means.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    /// Mean force and deflection at the first break.
    pub mean: Option<Values>,
    /// Their standard errors; nothing where a single run broke.
    pub error: Option<Values>,
    /// 5 % and 95 % points of the force, where a run counts.
    pub force_band: Option<[f64; 2]>,
    /// Likewise of the deflection.
    pub deflection_band: Option<[f64; 2]>,
    /// Utilisation by the mean force, where a design force is set.
    pub utilisation: Option<f64>,
    /// How far the means are from the forecast, where both are there.
    pub difference: Option<Difference>,
}

impl Figures {
    /// Of a check beside a forecast, where there is one, for a design question.
    pub fn of(verdict: &Verdict, forecast: Option<Values>, question: &Question) -> Figures {
        let (force, deflection) = (&verdict.force, &verdict.deflection);
        let several = verdict.breaks.len() > 1;
        let counted = verdict.runs > 0;
        let mean =
            verdict.broke().then_some(Values { force: force.mean, deflection: deflection.mean });
        Figures {
            mean,
            error: mean
                .filter(|_| several)
                .map(|_| Values { force: force.error, deflection: deflection.error }),
            force_band: counted.then_some(force.band),
            deflection_band: counted.then_some(deflection.band),
            utilisation: mean.and_then(|v| utilisation(question, v.force)),
            difference: forecast.and_then(|forecast| difference(verdict, forecast)),
        }
    }
}
