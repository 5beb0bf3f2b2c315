//! Checks in the JSON of a study: SI with kN.

use crate::cli::output::{number, optional};
use crate::cli::shapes::ChangeValues;
use crate::dem::Fidelity;
use crate::forecast::Values;
use crate::forecast::design::Question;
use crate::study::checks::CheckAnswer;
use crate::study::checks::change::{CheckChange, KnownValue};
use crate::study::checks::figures::Figures;
use crate::study::result::{CheckResult, Wanted};
use crate::units::{to_kn, without_noise};
use serde::Serialize;

/// What all checks of a study have in common.
#[derive(Debug, Serialize)]
pub(crate) struct PlanJson {
    fidelity: Fidelity,
    runs: Option<usize>,
    seed: u64,
    seeds: &'static str,
}

impl PlanJson {
    /// Of what is asked.
    pub(crate) fn of(wanted: &Wanted) -> PlanJson {
        PlanJson {
            fidelity: wanted.fidelity,
            runs: wanted.runs,
            seed: wanted.seed,
            seeds: "the same in all cases",
        }
    }
}

/// A case's check in an object: it, or why it is missing. To be flattened.
#[derive(Debug, Serialize)]
pub(crate) struct CheckedJson<'a> {
    dem: Option<DemJson<'a>>,
    dem_missing: Option<&'static str>,
    dem_reason: Option<String>,
}

#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct DemJson<'a> {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
    band: BandJson,
    standard_error: ErrorJson,
    runs: usize,
    /// How many of them are in the mean: those that broke a wire.
    broken: usize,
    slipped: usize,
    /// The worst of the runs' own estimates, as a part.
    #[serde(serialize_with = "number")]
    error_estimate: f64,
    difference_pct: Option<DifferenceJson>,
    #[serde(skip_serializing_if = "Option::is_none")]
    change: Option<Option<ChangeJson>>,
    fingerprint: String,
    warnings: &'a [String],
}

#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct BandJson {
    F_kN: [Option<f64>; 2],
    delta_m: [Option<f64>; 2],
}

#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ErrorJson {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
}

/// Per cent of the forecast.
#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct DifferenceJson {
    #[serde(serialize_with = "number")]
    F: f64,
    #[serde(serialize_with = "number")]
    delta: f64,
}

#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ChangeJson {
    #[serde(flatten)]
    values: ChangeValues,
    standard_error: ChangeErrorJson,
    /// Whether the errors are those of pairs of runs with the same seed.
    paired: bool,
}

#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ChangeErrorJson {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
}

impl<'a> CheckedJson<'a> {
    /// Of an answer beside a forecast.
    pub(crate) fn of(
        answer: &'a CheckAnswer,
        forecast: Option<Values>,
        question: &Question,
    ) -> CheckedJson<'a> {
        CheckedJson {
            dem: answer.as_ref().ok().map(|v| DemJson::of(v, forecast, question)),
            dem_missing: answer.as_ref().err().map(|why| why.code()),
            dem_reason: answer.as_ref().err().map(|why| why.reason()),
        }
    }

    /// The same with the change against a study's base, which may be missing.
    pub(crate) fn changed(mut self, change: Option<&CheckChange>) -> CheckedJson<'a> {
        if let Some(dem) = &mut self.dem {
            dem.change = Some(change.map(ChangeJson::of));
        }
        self
    }
}

impl<'a> DemJson<'a> {
    fn of(result: &'a CheckResult, forecast: Option<Values>, question: &Question) -> DemJson<'a> {
        let f = Figures::of(result, forecast, question);
        let both = |band: Option<[f64; 2]>, unit: fn(f64) -> f64| match band {
            Some(band) => band.map(|v| Some(without_noise(unit(v)))),
            None => [None; 2],
        };
        DemJson {
            F_kN: f.mean.map(|v| to_kn(v.force)),
            delta_m: f.mean.map(|v| v.deflection),
            utilisation: f.utilisation,
            band: BandJson {
                F_kN: both(f.force_band, to_kn),
                delta_m: both(f.deflection_band, |v| v),
            },
            standard_error: ErrorJson {
                F_kN: f.error.map(|v| to_kn(v.force)),
                delta_m: f.error.map(|v| v.deflection),
            },
            runs: result.runs,
            broken: result.breaks.len(),
            slipped: result.slipped,
            error_estimate: result.quality.error_estimate,
            difference_pct: f
                .difference
                .map(|d| DifferenceJson { F: 100.0 * d.force, delta: 100.0 * d.deflection }),
            change: None,
            fingerprint: result.inputs.to_string(),
            warnings: &result.warnings,
        }
    }
}

impl ChangeJson {
    fn of(c: &CheckChange) -> ChangeJson {
        let error = |k: &KnownValue| k.error;
        ChangeJson {
            values: ChangeValues {
                F_kN: to_kn(c.force.value),
                delta_m: c.deflection.value,
                utilisation: c.utilisation.map(|k| k.value),
                F: c.force_part,
                delta: c.deflection_part,
            },
            standard_error: ChangeErrorJson {
                F_kN: error(&c.force).map(to_kn),
                delta_m: error(&c.deflection),
                utilisation: c.utilisation.as_ref().and_then(error),
            },
            paired: c.paired,
        }
    }
}
