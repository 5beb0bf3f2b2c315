//! A forecast as JSON: SI with kN, one object a layout.

use super::{Answered, BASIS};
use crate::cli::output::{Fault, json_list, list, number, optional};
use crate::cli::shapes::{Design, Head, InputsJson, Pair, WarningJson, pair};
use crate::forecast::eccentricity::published;
use crate::forecast::{CURVE_POINTS, Values};
use crate::units::{to_kj, to_kn};
use serde::Serialize;

/// One object, or a list of them with one line each.
pub(crate) fn report(answered: &[Answered], several: bool) -> Result<String, Fault> {
    json_list(answered.iter().map(Report::of), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    head: Head<'a>,
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
struct CurveJson {
    #[serde(serialize_with = "list")]
    delta_m: Vec<f64>,
    #[serde(serialize_with = "list")]
    F_kN: Vec<f64>,
}

impl<'a> Report<'a> {
    fn of(a: &'a Answered) -> Report<'a> {
        let f = &a.forecast;
        let record = &a.case.mesh.laboratory;
        let measured = Values { force: record.force, deflection: record.deflection };
        Report {
            head: Head::of(
                a.name.as_deref(),
                a.case.fingerprint(),
                InputsJson::of(&f.layout, &a.case.mesh, f.rule),
            ),
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
            design: a.design.map(|answer| Design::of(&answer, &a.case.question)),
            curve: f.field.map(|field| {
                let curve = field.curve(CURVE_POINTS);
                CurveJson {
                    F_kN: curve.force.iter().map(|v| to_kn(*v)).collect(),
                    delta_m: curve.deflection,
                }
            }),
            warnings: f.warnings.iter().map(WarningJson::of).collect(),
            basis: BASIS,
        }
    }
}
