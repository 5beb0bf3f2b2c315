//! A sensitivity as JSON and CSV: SI with kN, the inputs in the order of the definitions.

use super::Studied;
use crate::case::Case;
use crate::case::{CaseValue, Input};
use crate::cli::dem::csv as dem_csv;
use crate::cli::dem::json::{CheckedJson, PlanJson};
use crate::cli::output::{Fault, cell, json_list, number, optional, quoted};
use crate::cli::page::BASIS;
use crate::cli::shapes::{ChangeValues, Head, InputsJson, WarningJson};
use crate::study::result::Wanted;
use crate::study::sensitivity::dem::{CheckedBar, CheckedStep};
use crate::study::sensitivity::{Bar, Change, Effect, Step};
use crate::units::to_kn;
use serde::Serialize;
use std::fmt::Write;

/// One object, or a list of them with one line each.
pub(crate) fn json(
    studied: &[Studied],
    wanted: Option<&Wanted>,
    several: bool,
) -> Result<String, Fault> {
    json_list(studied.iter().map(|s| Report::of(s, wanted)), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    base: Option<Values>,
    missing: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dem_plan: Option<PlanJson>,
    /// The check of the case itself.
    #[serde(flatten)]
    checked: Option<CheckedJson<'a>>,
    sensitivity: Vec<BarJson<'a>>,
    /// Inputs by falling effect.
    order: Order,
    /// The same by the checks.
    #[serde(skip_serializing_if = "Option::is_none")]
    order_dem: Option<Order>,
    warnings: Vec<WarningJson>,
    basis: &'static str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Order {
    F: Vec<&'static str>,
    delta: Vec<&'static str>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct Values {
    #[serde(serialize_with = "number")]
    F_kN: f64,
    #[serde(serialize_with = "number")]
    delta_m: f64,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
}

#[derive(Serialize)]
struct BarJson<'a> {
    input: &'static str,
    unit: &'static str,
    #[serde(serialize_with = "number")]
    value: f64,
    low: StepJson<'a>,
    high: StepJson<'a>,
}

#[derive(Serialize)]
struct StepJson<'a> {
    #[serde(serialize_with = "number")]
    value: f64,
    #[serde(flatten)]
    values: Option<Values>,
    change: Option<ChangeJson>,
    missing: Option<&'static str>,
    warnings: Vec<&'static str>,
    #[serde(flatten)]
    checked: Option<CheckedJson<'a>>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ChangeJson {
    #[serde(flatten)]
    values: ChangeValues,
    other_branch: bool,
}

/// A value of an input in its unit of output.
fn shown(input: Input, value: f64) -> f64 {
    if input.is_force() { to_kn(value) } else { value }
}

fn unit(input: Input) -> &'static str {
    if input.is_force() { "kN" } else { "m" }
}

fn values(outcome: &CaseValue) -> Option<Values> {
    outcome.as_ref().ok().map(|p| Values {
        F_kN: to_kn(p.values().force),
        delta_m: p.values().deflection,
        utilisation: p.utilisation(),
    })
}

/// F_a and delta_a, where there are any.
fn forecast(outcome: &CaseValue) -> Option<crate::forecast::Values> {
    outcome.as_ref().ok().map(|p| p.values())
}

fn codes(outcome: &CaseValue) -> Vec<&'static str> {
    outcome.iter().flat_map(|p| p.warnings.iter().map(|w| w.code())).collect()
}

fn missing(outcome: &CaseValue) -> Option<&'static str> {
    outcome.as_ref().err().map(|why| why.code())
}

impl<'a> Report<'a> {
    fn of(s: &'a Studied, wanted: Option<&Wanted>) -> Report<'a> {
        let base = &s.sensitivity.base;
        let checked = s.checked.as_ref();
        let found = |effect| checked.map(|c| c.by(effect).iter().map(|b| b.input.word()).collect());
        let order = |effect| s.sensitivity.by(effect).iter().map(|b| b.input.word()).collect();
        Report {
            head: Head::of(
                s.name.as_deref(),
                s.case.fingerprint(),
                InputsJson::of(&s.case.layout, &s.case.mesh, s.case.rule),
            ),
            base: values(base),
            missing: missing(base),
            dem_plan: wanted.map(PlanJson::of),
            checked: checked.map(|c| CheckedJson::of(&c.base, forecast(base), &s.case.question)),
            sensitivity: (s.sensitivity.bars.iter())
                .map(|bar| BarJson::of(&s.case, bar, checked.and_then(|c| c.bar(bar.input))))
                .collect(),
            order: Order { F: order(Effect::Force), delta: order(Effect::Deflection) },
            order_dem: found(Effect::Force)
                .zip(found(Effect::Deflection))
                .map(|(force, delta)| Order { F: force, delta }),
            warnings: base.iter().flat_map(|p| p.warnings.iter().map(WarningJson::of)).collect(),
            basis: BASIS,
        }
    }
}

impl<'a> BarJson<'a> {
    fn of(case: &Case, bar: &Bar, checked: Option<&'a CheckedBar>) -> BarJson<'a> {
        let step = |s: &Step, checked: Option<&'a CheckedStep>| StepJson {
            value: shown(bar.input, s.value),
            values: values(&s.outcome),
            change: s.change.map(|c| ChangeJson::of(&c)),
            missing: missing(&s.outcome),
            warnings: codes(&s.outcome),
            checked: checked.map(|c| {
                CheckedJson::of(&c.answer, forecast(&s.outcome), &case.question)
                    .changed(c.change.as_ref())
            }),
        };
        BarJson {
            input: bar.input.word(),
            unit: unit(bar.input),
            value: shown(bar.input, bar.value),
            low: step(&bar.lowered, checked.map(|c| &c.lowered)),
            high: step(&bar.raised, checked.map(|c| &c.raised)),
        }
    }
}

impl ChangeJson {
    fn of(c: &Change) -> ChangeJson {
        ChangeJson {
            values: ChangeValues {
                F_kN: to_kn(c.force),
                delta_m: c.deflection,
                utilisation: c.utilisation,
                F: c.force_part,
                delta: c.deflection_part,
            },
            other_branch: c.other_branch,
        }
    }
}

/// One line a step: two for each input.
pub(crate) fn csv(studied: &[Studied], dem: bool, several: bool) -> String {
    let mut out = String::from(if several { "layout," } else { "" });
    out.push_str("input,unit,step,value,F_kN,delta_m,utilisation,change_F_kN,change_delta_m,change_utilisation,other_branch,missing,warnings");
    if dem {
        out.push_str(dem_csv::COLUMNS);
        out.push_str(dem_csv::CHANGES);
    }
    out.push('\n');
    for s in studied {
        let name = match &s.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for bar in &s.sensitivity.bars {
            let checked = s.checked.as_ref().and_then(|c| c.bar(bar.input));
            let steps = [
                ("low", &bar.lowered, checked.map(|c| &c.lowered)),
                ("high", &bar.raised, checked.map(|c| &c.raised)),
            ];
            for (word, step, checked) in steps {
                let (v, c) = (values(&step.outcome), step.change);
                let dem = checked.map_or(String::new(), |c| {
                    let cells =
                        dem_csv::cells(&c.answer, forecast(&step.outcome), &s.case.question);
                    cells + &dem_csv::change(c.change.as_ref())
                });
                // Writing to a string cannot fail.
                let _ = writeln!(
                    out,
                    "{name}{},{},{word},{},{},{},{},{},{},{},{},{},{}{dem}",
                    bar.input.word(),
                    unit(bar.input),
                    cell(Some(shown(bar.input, step.value))),
                    cell(v.as_ref().map(|v| v.F_kN)),
                    cell(v.as_ref().map(|v| v.delta_m)),
                    cell(v.as_ref().and_then(|v| v.utilisation)),
                    cell(c.map(|c| to_kn(c.force))),
                    cell(c.map(|c| c.deflection)),
                    cell(c.and_then(|c| c.utilisation)),
                    c.map_or(String::new(), |c| c.other_branch.to_string()),
                    missing(&step.outcome).unwrap_or_default(),
                    codes(&step.outcome).join(";")
                );
            }
        }
    }
    out
}
