//! A forecast as JSON: SI with kN, one object a layout.

use super::{Answered, BASIS, VERSION};
use crate::cli::output::{Fault, json, number, optional};
use crate::cli::shapes::{CurveJson, InputsJson, Pair, WarningJson, objects, pair};
use crate::forecast::eccentricity::published;
use crate::forecast::{CURVE_POINTS, Values};
use crate::units::{to_kj, to_kn};
use serde::Serialize;

/// One object, or a list of them with one line each.
pub fn report(answered: &[Answered], several: bool) -> Result<String, Fault> {
    objects(answered.iter().map(|a| json(&Report::of(a))), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    layout: Option<&'a str>,
    version: &'static str,
    fingerprint: String,
    inputs: InputsJson<'a>,
    lab: Lab<'a>,
    field_reference: Pair,
    field: Option<Field>,
    other_branch: Option<OtherBranch>,
    eccentricity: EccentricityJson<'a>,
    ratios: Ratios,
    design: Option<Design>,
    curve: Option<CurveJson>,
    warnings: Vec<WarningJson>,
    basis: &'static str,
}

#[derive(Serialize)]
struct Lab<'a> {
    #[serde(flatten)]
    standard: Pair,
    statistic: &'static str,
    #[serde(serialize_with = "number")]
    panel_m: f64,
    #[serde(serialize_with = "number")]
    punch_m: f64,
    /// The record itself where it was measured on another panel.
    measured: Option<Pair>,
    source: &'a str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Field {
    #[serde(flatten)]
    values: Pair,
    regime: &'static str,
    branch: &'static str,
    relation: &'static str,
    #[serde(serialize_with = "number")]
    anchor_kN: f64,
    #[serde(serialize_with = "number")]
    secant_kN_per_m: f64,
    #[serde(serialize_with = "number")]
    tangent_kN_per_m: f64,
    #[serde(serialize_with = "number")]
    energy_kJ: f64,
}

#[derive(Serialize)]
struct OtherBranch {
    #[serde(flatten)]
    values: Pair,
    relation: &'static str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct EccentricityJson<'a> {
    #[serde(serialize_with = "number")]
    F: f64,
    #[serde(serialize_with = "number")]
    delta: f64,
    #[serde(serialize_with = "number")]
    F_sd: f64,
    #[serde(serialize_with = "number")]
    delta_sd: f64,
    supported: bool,
    sources: &'a [String],
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Ratios {
    #[serde(serialize_with = "number")]
    alpha_F: f64,
    #[serde(serialize_with = "number")]
    alpha_delta: f64,
    #[serde(rename = "default")]
    is_default: bool,
    #[serde(serialize_with = "optional")]
    F_field_over_lab: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_field_over_lab: Option<f64>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Design {
    #[serde(serialize_with = "number")]
    gamma_resistance: f64,
    #[serde(serialize_with = "number")]
    gamma_load: f64,
    #[serde(serialize_with = "number")]
    resistance_kN: f64,
    at_force: Option<AtForce>,
    at_deflection: Option<AtDeflection>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct AtForce {
    #[serde(serialize_with = "number")]
    F_kN: f64,
    #[serde(serialize_with = "number")]
    load_kN: f64,
    #[serde(serialize_with = "number")]
    utilisation: f64,
    #[serde(serialize_with = "number")]
    margin_kN: f64,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
    within_allowable: Option<bool>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct AtDeflection {
    #[serde(serialize_with = "number")]
    delta_m: f64,
    #[serde(serialize_with = "number")]
    F_kN: f64,
    #[serde(serialize_with = "number")]
    design_F_kN: f64,
    #[serde(serialize_with = "number")]
    energy_kJ: f64,
    beyond_failure: bool,
}

impl<'a> Report<'a> {
    fn of(a: &'a Answered) -> Report<'a> {
        let f = &a.forecast;
        let record = &a.case.mesh.laboratory;
        let measured = Values { force: record.force, deflection: record.deflection };
        Report {
            layout: a.case.name.as_deref(),
            version: VERSION,
            fingerprint: a.fingerprint.to_string(),
            inputs: InputsJson::of(&a.case),
            lab: Lab {
                standard: pair(f.laboratory),
                statistic: record.statistic.word(),
                panel_m: record.panel,
                punch_m: record.punch,
                measured: (measured != f.laboratory).then(|| pair(measured)),
                source: &record.source,
            },
            field_reference: pair(f.reference),
            field: f.field.map(|field| Field {
                values: pair(field.values),
                regime: field.regime.word(),
                branch: f.rule.word(),
                relation: field.branch.word(),
                // In the periodic cell each anchor carries the whole force of its cell.
                anchor_kN: to_kn(field.values.force),
                secant_kN_per_m: to_kn(field.secant_at(field.values.deflection)),
                tangent_kN_per_m: to_kn(field.tangent_at(field.values.deflection)),
                energy_kJ: to_kj(field.energy_to(field.values.deflection)),
            }),
            other_branch: f.field.and_then(|field| {
                let values = pair(field.other_branch?);
                Some(OtherBranch { values, relation: field.branch.other().word() })
            }),
            eccentricity: EccentricityJson {
                F: f.eccentricity.force,
                delta: f.eccentricity.deflection,
                F_sd: f.eccentricity.force_sd,
                delta_sd: f.eccentricity.deflection_sd,
                supported: f.eccentricity.supported,
                sources: published().sources(),
            },
            ratios: Ratios {
                alpha_F: f.ratios.force,
                alpha_delta: f.ratios.deflection,
                is_default: f.ratios.default,
                F_field_over_lab: f.force_over_lab(),
                delta_field_over_lab: f.deflection_over_lab(),
            },
            design: design(a),
            curve: f.field.map(|field| CurveJson::from(&field.curve(CURVE_POINTS))),
            warnings: f
                .warnings
                .iter()
                .map(|w| WarningJson {
                    code: w.code(),
                    weight: w.weight().word(),
                    message: w.message(),
                })
                .collect(),
            basis: BASIS,
        }
    }
}

fn design(a: &Answered) -> Option<Design> {
    let (answer, question) = (a.design?, &a.question);
    Some(Design {
        gamma_resistance: question.gamma_resistance,
        gamma_load: question.gamma_load,
        resistance_kN: to_kn(answer.resistance),
        at_force: answer.at_force.zip(question.force).map(|(at, force)| AtForce {
            F_kN: to_kn(force),
            load_kN: to_kn(at.load),
            utilisation: at.utilisation,
            margin_kN: to_kn(at.margin),
            delta_m: at.deflection,
            within_allowable: at.within_allowable,
        }),
        at_deflection: answer.at_deflection.zip(question.deflection).map(|(at, deflection)| {
            AtDeflection {
                delta_m: deflection,
                F_kN: to_kn(at.force),
                design_F_kN: to_kn(at.design_force),
                energy_kJ: to_kj(at.energy),
                beyond_failure: at.beyond_failure,
            }
        }),
    })
}
