//! A sweep as JSON and CSV: SI with kN, points along the first input, row after row.

use super::Swept;
use crate::case::{CaseValue, Input};
use crate::cli::dem::csv as dem_csv;
use crate::cli::dem::json::{CheckedJson, PlanJson};
use crate::cli::output::{Fault, cell, json_list, number, quoted};
use crate::cli::page::BASIS;
use crate::cli::shapes::{Head, InputsJson};
use crate::forecast::Values;
use crate::study::checks::CheckAnswer;
use crate::study::result::Wanted;
use crate::study::sweep::{Grid, SweepAxis};
use crate::units::{to_kn, without_noise};
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::fmt::Write;

/// One object, or a list of them with one line each.
pub(crate) fn json(
    swept: &[Swept],
    wanted: Option<&Wanted>,
    several: bool,
) -> Result<String, Fault> {
    json_list(swept.iter().map(|s| Report::of(s, wanted)), several)
}

#[derive(Serialize)]
struct Report<'a> {
    /// Of the layout itself; each point replaces what is varied.
    #[serde(flatten)]
    head: Head<'a>,
    vary: AxisJson,
    vary2: Option<AxisJson>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dem_plan: Option<PlanJson>,
    points: Vec<PointJson<'a>>,
    basis: &'static str,
}

#[derive(Serialize)]
struct AxisJson {
    input: &'static str,
    column: &'static str,
    #[serde(serialize_with = "number")]
    from: f64,
    #[serde(serialize_with = "number")]
    to: f64,
    steps: usize,
}

/// A point: what is varied by its column's name, then what it gives, and its check.
#[derive(Serialize)]
struct PointJson<'a> {
    #[serde(flatten)]
    forecast: ForecastJson<'a>,
    #[serde(flatten)]
    checked: Option<CheckedJson<'a>>,
}

struct ForecastJson<'a> {
    varied: [Option<(&'static str, f64)>; 2],
    outcome: &'a CaseValue,
}

/// What a point gives, in the units of output.
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ValuesJson {
    F_kN: Option<f64>,
    delta_m: Option<f64>,
    utilisation: Option<f64>,
    missing: Option<&'static str>,
    warnings: Vec<&'static str>,
}

impl Serialize for ForecastJson<'_> {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        let mut map = s.serialize_map(None)?;
        for (column, value) in self.varied.iter().flatten() {
            map.serialize_entry(column, &without_noise(*value))?;
        }
        let v = ValuesJson::of(self.outcome);
        map.serialize_entry("F_kN", &v.F_kN.map(without_noise))?;
        map.serialize_entry("delta_m", &v.delta_m.map(without_noise))?;
        map.serialize_entry("utilisation", &v.utilisation.map(without_noise))?;
        map.serialize_entry("missing", &v.missing)?;
        map.serialize_entry("warnings", &v.warnings)?;
        map.end()
    }
}

impl ValuesJson {
    fn of(outcome: &CaseValue) -> ValuesJson {
        let point = outcome.as_ref().ok();
        ValuesJson {
            F_kN: point.map(|p| to_kn(p.values().force)),
            delta_m: point.map(|p| p.values().deflection),
            utilisation: point.and_then(|p| p.utilisation()),
            missing: outcome.as_ref().err().map(|why| why.code()),
            warnings: point.iter().flat_map(|p| p.warnings.iter().map(|w| w.code())).collect(),
        }
    }
}

/// A value of an input in its unit of output.
fn shown(input: Input, value: f64) -> f64 {
    if input.is_force() { to_kn(value) } else { value }
}

fn varied(grid: &Grid, index: usize) -> [Option<(&'static str, f64)>; 2] {
    let (first, second) = grid.at(index);
    let of = |axis: &SweepAxis, value| (axis.input.column(), shown(axis.input, value));
    [Some(of(&grid.first, first)), grid.second.as_ref().zip(second).map(|(a, v)| of(a, v))]
}

/// The check of a point.
fn answer(s: &Swept, index: usize) -> Option<&CheckAnswer> {
    s.checked.as_ref()?.get(index)
}

/// F_a and delta_a of a point, where there are any.
fn forecast(outcome: &CaseValue) -> Option<Values> {
    outcome.as_ref().ok().map(|p| p.values())
}

impl<'a> Report<'a> {
    fn of(s: &'a Swept, wanted: Option<&Wanted>) -> Report<'a> {
        let grid = &s.sweep.grid;
        let axis = |a: &SweepAxis| AxisJson {
            input: a.input.word(),
            column: a.input.column(),
            from: shown(a.input, a.from),
            to: shown(a.input, a.to),
            steps: a.steps,
        };
        let points = s.sweep.points.iter().enumerate();
        Report {
            head: Head::of(
                s.name.as_deref(),
                grid.fingerprint(&s.case),
                InputsJson::of(&s.case.layout, &s.case.mesh, s.case.rule),
            ),
            vary: axis(&grid.first),
            vary2: grid.second.as_ref().map(axis),
            dem_plan: wanted.map(PlanJson::of),
            points: points
                .map(|(index, outcome)| PointJson {
                    forecast: ForecastJson { varied: varied(grid, index), outcome },
                    checked: answer(s, index)
                        .map(|answer| CheckedJson::of(answer, forecast(outcome), &s.case.question)),
                })
                .collect(),
            basis: BASIS,
        }
    }
}

/// One line a point.
pub(crate) fn csv(swept: &[Swept], grid: &Grid, dem: bool, several: bool) -> String {
    let mut out = String::from(if several { "layout," } else { "" });
    for axis in std::iter::once(&grid.first).chain(&grid.second) {
        out.push_str(axis.input.column());
        out.push(',');
    }
    out.push_str("F_kN,delta_m,utilisation,missing,warnings");
    out.push_str(if dem { dem_csv::COLUMNS } else { "" });
    out.push('\n');
    for s in swept {
        let name = match &s.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for (index, outcome) in s.sweep.points.iter().enumerate() {
            out.push_str(&name);
            for (_, value) in varied(grid, index).into_iter().flatten() {
                out.push_str(&cell(Some(value)));
                out.push(',');
            }
            let v = ValuesJson::of(outcome);
            let dem = answer(s, index).map_or(String::new(), |answer| {
                dem_csv::cells(answer, forecast(outcome), &s.case.question)
            });
            // Writing to a string cannot fail.
            let _ = writeln!(
                out,
                "{},{},{},{},{}{dem}",
                cell(v.F_kN),
                cell(v.delta_m),
                cell(v.utilisation),
                v.missing.unwrap_or_default(),
                v.warnings.join(";")
            );
        }
    }
    out
}
