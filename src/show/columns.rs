//! The columns of results: what each is called, in which unit, and how to get it. JSON, CSV, and copied
//! and exported tables take them from here; SI with kN.
//!
//! A check's columns begin with `check_`; in JSON they are an object `check` with the same names behind
//! that.

use super::value::{NamedColumn, Value, kn};
use crate::case::{CasePoint, CaseValue, Input, Question};
use crate::forecast::design::Answer;
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Forecast, Strength};
use crate::study::checks::change::CheckChange;
use crate::study::checks::figures::Figures;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::compare::CompareRow;
use crate::study::result::CheckResult;
use crate::study::sensitivity::Change;
use crate::units::{to_kj, to_kn};
use crate::words::Choice;

/// What a case gives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointRow<'a> {
    /// F_a and delta_a.
    pub(crate) values: Option<Strength>,
    /// Answer to the design question.
    pub(crate) answer: Option<Answer>,
    /// Why there are no values: a code.
    pub(crate) missing: Option<&'static str>,
    /// What to distrust.
    pub(crate) warnings: &'a [Warning],
}

impl<'a> From<&'a CaseValue> for PointRow<'a> {
    fn from(outcome: &'a CaseValue) -> PointRow<'a> {
        match outcome {
            Ok(point) => PointRow::from(point),
            Err(why) => {
                PointRow { values: None, answer: None, missing: Some(why.code()), warnings: &[] }
            }
        }
    }
}

impl<'a> From<&'a CasePoint> for PointRow<'a> {
    fn from(point: &'a CasePoint) -> PointRow<'a> {
        let (values, answer) = (Some(point.values()), Some(point.answer));
        PointRow { values, answer, missing: None, warnings: &point.warnings }
    }
}

impl<'a> From<&'a CompareRow> for PointRow<'a> {
    fn from(row: &'a CompareRow) -> PointRow<'a> {
        let values = row.values();
        PointRow {
            values: values.as_ref().ok().copied(),
            answer: row.answer(),
            missing: values.err().map(|why| why.code()),
            warnings: row.forecast().map_or(&[], |f| &f.warnings),
        }
    }
}

/// Force, deflection and utilisation; deflection at the factored design force and at that without its
/// factor; why there is nothing; what is warned of.
pub(crate) fn point<'a>() -> [NamedColumn<PointRow<'a>>; 7] {
    [
        ("F_kN", |p| p.values.map(|v| to_kn(v.force)).into()),
        ("delta_m", |p| p.values.and_then(|v| v.deflection).into()),
        ("utilisation", |p| p.answer.and_then(|a| a.at_force).map(|at| at.utilisation).into()),
        ("design_delta_m", |p| p.answer.and_then(|a| a.at_force?.deflection).into()),
        ("service_delta_m", |p| p.answer.and_then(|a| a.at_force?.service_deflection).into()),
        ("missing", |p| p.missing.into()),
        ("warnings", |p| codes(p.warnings)),
    ]
}

/// The codes of warnings.
pub(crate) fn codes(warnings: &[Warning]) -> Value {
    Value::Codes(warnings.iter().map(Warning::code).collect())
}

/// The ratios of the mesh.
pub(crate) const RATIOS: [NamedColumn<Forecast>; 2] =
    [("alpha_F", |f| f.ratios.force.into()), ("alpha_delta", |f| f.ratios.deflection.into())];

/// What a field forecast says of its failure point besides force and deflection. In the periodic cell
/// each anchor carries the whole force of its cell.
pub(crate) const STIFFNESS: [NamedColumn<Field>; 4] = [
    ("anchor_kN", |f| kn(f.values.force)),
    ("secant_kN_per_m", |f| f.end().map(|v| to_kn(v.secant_at(v.deflection))).into()),
    ("tangent_kN_per_m", |f| f.end().map(|v| to_kn(v.tangent_at(v.deflection))).into()),
    ("energy_kJ", |f| f.end().map(|v| to_kj(v.energy_to(v.deflection))).into()),
];

/// Field values over laboratory values.
pub(crate) const OVER_LAB: [NamedColumn<Forecast>; 2] = [
    ("F_field_over_lab", |f| f.force_over_lab().into()),
    ("delta_field_over_lab", |f| f.deflection_over_lab().into()),
];

/// An input's value, SI, as its column has it.
pub(crate) fn input(input: Input, value: f64) -> Value {
    if input.in_kilo() { kn(value) } else { value.into() }
}

/// How the values of a case move with an input.
pub(crate) const CHANGE: [NamedColumn<Change>; 5] = [
    ("change_F_kN", |c| kn(c.force)),
    ("change_delta_m", |c| c.deflection.into()),
    ("change_utilisation", |c| c.utilisation.into()),
    ("change_service_delta_m", |c| c.service.into()),
    ("other_branch", |c| c.other_branch.into()),
];

/// A check beside a forecast.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CheckRow<'a> {
    /// The check, if it was made.
    pub(crate) result: Option<&'a CheckResult>,
    /// Why there is none.
    pub(crate) missing: Option<&'a NoCheck>,
    /// What it says.
    pub(crate) figures: Option<Figures>,
}

impl<'a> CheckRow<'a> {
    /// An answer beside a forecast, where there is one, for a design question.
    pub(crate) fn new(
        answer: &'a CheckAnswer,
        forecast: Option<Strength>,
        question: &Question,
    ) -> CheckRow<'a> {
        let (result, missing) = (answer.as_ref().ok(), answer.as_ref().err());
        let figures = result.map(|result| Figures::of(result, forecast, question));
        CheckRow { result, missing, figures }
    }

    fn read(&self, part: impl Fn(&Figures) -> Option<f64>) -> Value {
        self.figures.as_ref().and_then(part).into()
    }
}

/// Mean force and deflection at the first break of a check, and the utilisation by that force.
pub(crate) fn check_mean<'a>() -> [NamedColumn<CheckRow<'a>>; 3] {
    [
        ("check_F_kN", |c| c.read(|f| f.mean.map(|v| to_kn(v.force)))),
        ("check_delta_m", |c| c.read(|f| f.mean.map(|v| v.deflection))),
        ("check_utilisation", |c| c.read(|f| f.utilisation)),
    ]
}

/// How many runs a check has.
pub(crate) fn check_runs<'a>() -> NamedColumn<CheckRow<'a>> {
    ("check_runs", |c| c.result.map(|v| v.runs).into())
}

/// How well it was made.
pub(crate) fn check_fidelity<'a>() -> NamedColumn<CheckRow<'a>> {
    ("check_fidelity", |c| c.result.map(|v| v.wanted.fidelity.word()).into())
}

/// What a table says of a check behind its means: band, standard errors, difference from the forecast
/// in per cent, runs.
pub(crate) fn check_more<'a>() -> [NamedColumn<CheckRow<'a>>; 11] {
    [
        ("check_F_low_kN", |c| c.read(|f| f.force_band.map(|b| to_kn(b[0])))),
        ("check_F_high_kN", |c| c.read(|f| f.force_band.map(|b| to_kn(b[1])))),
        ("check_delta_low_m", |c| c.read(|f| f.deflection_band.map(|b| b[0]))),
        ("check_delta_high_m", |c| c.read(|f| f.deflection_band.map(|b| b[1]))),
        ("check_F_error_kN", |c| c.read(|f| f.error.map(|e| to_kn(e.force)))),
        ("check_delta_error_m", |c| c.read(|f| f.error.map(|e| e.deflection))),
        ("difference_F_pct", |c| c.read(|f| f.difference.map(|d| 100.0 * d.force))),
        ("difference_delta_pct", |c| {
            c.read(|f| f.difference.and_then(|d| d.deflection).map(|d| 100.0 * d))
        }),
        check_runs(),
        ("check_slipped", |c| c.result.map(|v| v.slipped).into()),
        ("check_missing", |c| c.missing.map(super::super::study::checks::NoCheck::code).into()),
    ]
}

/// How the means of a check move with an input, and their standard errors.
pub(crate) const CHECK_CHANGE: [NamedColumn<CheckChange>; 6] = [
    ("check_change_F_kN", |c| kn(c.force.value)),
    ("check_change_delta_m", |c| c.deflection.value.into()),
    ("check_change_utilisation", |c| c.utilisation.map(|k| k.value).into()),
    ("check_change_F_error_kN", |c| c.force.error.map(to_kn).into()),
    ("check_change_delta_error_m", |c| c.deflection.error.into()),
    ("check_change_utilisation_error", |c| c.utilisation.and_then(|k| k.error).into()),
];
