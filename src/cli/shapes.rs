//! Parts of JSON results that several commands share, by the names that `forecast` gave them: SI with
//! kN.

use super::VERSION;
use super::output::{list, number, optional};
use crate::curve::{Curve, Point};
use crate::fingerprint::Fingerprint;
use crate::forecast::Values;
use crate::forecast::design::{Answer, Question};
use crate::forecast::warning::Warning;
use crate::layout::{BranchRule, Layout};
use crate::mesh::MeshType;
use crate::units::{to_kj, to_kn};
use serde::Serialize;

/// How the result of a layout begins. To be flattened.
#[derive(Debug, Serialize)]
pub(crate) struct Head<'a> {
    /// Its name, in the list of a project.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) layout: Option<&'a str>,
    /// Version of the program.
    pub(crate) version: &'static str,
    /// Of all that the result was made from.
    pub(crate) fingerprint: String,
    /// The layout with its mesh.
    pub(crate) inputs: InputsJson<'a>,
}

/// The inputs of a layout.
#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct InputsJson<'a> {
    #[serde(serialize_with = "number")]
    pub(crate) d_m: f64,
    #[serde(serialize_with = "number")]
    pub L_m: f64,
    #[serde(serialize_with = "number")]
    pub D_m: f64,
    #[serde(serialize_with = "number")]
    pub(crate) ex_m: f64,
    #[serde(serialize_with = "number")]
    pub(crate) ey_m: f64,
    pub(crate) mesh: &'a str,
    pub(crate) branch: &'static str,
}

/// How a case differs from a study's base. To be flattened.
#[derive(Debug, Clone, Copy, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct ChangeValues {
    #[serde(serialize_with = "number")]
    pub F_kN: f64,
    #[serde(serialize_with = "number")]
    pub(crate) delta_m: f64,
    #[serde(serialize_with = "optional")]
    pub(crate) utilisation: Option<f64>,
    /// Parts of the base's values.
    #[serde(serialize_with = "number")]
    pub F: f64,
    #[serde(serialize_with = "number")]
    pub(crate) delta: f64,
}

/// A force with its deflection.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct Pair {
    #[serde(serialize_with = "number")]
    pub F_kN: f64,
    #[serde(serialize_with = "number")]
    pub(crate) delta_m: f64,
}

/// The answer to a design question, with the factors that act.
#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct Design {
    #[serde(serialize_with = "number")]
    pub(crate) gamma_resistance: f64,
    #[serde(serialize_with = "number")]
    pub(crate) gamma_load: f64,
    #[serde(serialize_with = "number")]
    pub(crate) resistance_kN: f64,
    pub(crate) at_force: Option<AtForce>,
    pub(crate) at_deflection: Option<AtDeflection>,
}

/// For the design force.
#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct AtForce {
    #[serde(serialize_with = "number")]
    pub F_kN: f64,
    #[serde(serialize_with = "number")]
    pub load_kN: f64,
    #[serde(serialize_with = "number")]
    pub utilisation: f64,
    #[serde(serialize_with = "number")]
    pub margin_kN: f64,
    #[serde(serialize_with = "optional")]
    pub delta_m: Option<f64>,
    pub within_allowable: Option<bool>,
}

/// For the allowable deflection.
#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct AtDeflection {
    #[serde(serialize_with = "number")]
    pub(crate) delta_m: f64,
    #[serde(serialize_with = "number")]
    pub F_kN: f64,
    #[serde(serialize_with = "number")]
    pub(crate) design_F_kN: f64,
    #[serde(serialize_with = "number")]
    pub(crate) energy_kJ: f64,
    pub(crate) beyond_failure: bool,
}

/// A warning.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct WarningJson {
    pub(crate) code: &'static str,
    pub(crate) weight: &'static str,
    pub(crate) message: String,
}

/// A force with its deflection, converted.
pub(crate) fn pair(values: Values) -> Pair {
    Pair { F_kN: to_kn(values.force), delta_m: values.deflection }
}

impl<'a> Head<'a> {
    /// Of a layout's name, where it has one, a fingerprint and the inputs.
    pub(crate) fn of(
        name: Option<&'a str>,
        fingerprint: Fingerprint,
        inputs: InputsJson<'a>,
    ) -> Head<'a> {
        Head { layout: name, version: VERSION, fingerprint: fingerprint.to_string(), inputs }
    }
}

impl<'a> InputsJson<'a> {
    /// Of a layout with its mesh.
    pub(crate) fn of(layout: &Layout, mesh: &'a MeshType, rule: BranchRule) -> InputsJson<'a> {
        InputsJson {
            d_m: layout.plate,
            L_m: layout.spacing,
            D_m: layout.punch,
            ex_m: layout.ex,
            ey_m: layout.ey,
            mesh: &mesh.id,
            branch: rule.word(),
        }
    }
}

impl WarningJson {
    /// Of a warning.
    pub(crate) fn of(w: &Warning) -> WarningJson {
        WarningJson { code: w.code(), weight: w.weight().word(), message: w.message() }
    }
}

impl Design {
    /// Of an answer to a question.
    pub(crate) fn of(answer: &Answer, question: &Question) -> Design {
        Design {
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
        }
    }
}

impl From<Point> for Pair {
    fn from(p: Point) -> Pair {
        Pair { F_kN: to_kn(p.force), delta_m: p.deflection }
    }
}

/// A curve.
#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub(crate) struct CurveJson {
    #[serde(serialize_with = "list")]
    delta_m: Vec<f64>,
    #[serde(serialize_with = "list")]
    F_kN: Vec<f64>,
}

impl From<&Curve> for CurveJson {
    fn from(curve: &Curve) -> CurveJson {
        CurveJson {
            delta_m: curve.deflection.clone(),
            F_kN: curve.force.iter().map(|v| to_kn(*v)).collect(),
        }
    }
}
