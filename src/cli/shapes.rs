//! Pieces of JSON that several subcommands print: SI with kN, field names by the paper's symbols.

use super::case::Case;
use super::output::{Fault, list, number};
use crate::curve::{Curve, Point};
use crate::forecast::Values;
use crate::units::to_kn;
use serde::Serialize;

/// The lines of objects as one object, or as a list with one line each.
pub fn objects(
    lines: impl Iterator<Item = Result<String, Fault>>,
    several: bool,
) -> Result<String, Fault> {
    let lines = lines.collect::<Result<Vec<String>, Fault>>()?;
    Ok(match lines.as_slice() {
        [one] if !several => format!("{one}\n"),
        [] => "[]\n".to_string(),
        all => format!("[\n{}\n]\n", all.join(",\n")),
    })
}

/// What was asked.
#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub struct InputsJson<'a> {
    #[serde(serialize_with = "number")]
    d_m: f64,
    #[serde(serialize_with = "number")]
    L_m: f64,
    #[serde(serialize_with = "number")]
    D_m: f64,
    #[serde(serialize_with = "number")]
    ex_m: f64,
    #[serde(serialize_with = "number")]
    ey_m: f64,
    mesh: &'a str,
    branch: &'static str,
}

impl<'a> InputsJson<'a> {
    /// Of a case.
    pub fn of(case: &'a Case) -> InputsJson<'a> {
        let entry = &case.entry;
        InputsJson {
            d_m: entry.plate,
            L_m: entry.spacing,
            D_m: entry.punch,
            ex_m: entry.ex,
            ey_m: entry.ey,
            mesh: &case.mesh.id,
            branch: entry.branch.word(),
        }
    }
}

/// A force with its deflection.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub struct Pair {
    /// Force, kN.
    #[serde(serialize_with = "number")]
    pub F_kN: f64,
    /// Deflection, m.
    #[serde(serialize_with = "number")]
    pub delta_m: f64,
}

/// Values as JSON.
pub fn pair(values: Values) -> Pair {
    Pair { F_kN: to_kn(values.force), delta_m: values.deflection }
}

impl From<Point> for Pair {
    fn from(p: Point) -> Pair {
        Pair { F_kN: to_kn(p.force), delta_m: p.deflection }
    }
}

/// A curve.
#[derive(Debug, Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
pub struct CurveJson {
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

/// A remark: its code, how much it weighs and what it says.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WarningJson {
    /// A stable word for programs.
    pub code: &'static str,
    /// `note`, `caution` or `outside`.
    pub weight: &'static str,
    /// The same for people.
    pub message: String,
}
