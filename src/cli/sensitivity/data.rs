//! A sensitivity as JSON and CSV: SI with kN, the inputs in the order of the definitions.

use super::Studied;
use crate::cli::VERSION;
use crate::cli::output::{Fault, cell, json_list, number, optional, quoted};
use crate::cli::page::BASIS;
use crate::cli::shapes::{InputsJson, WarningJson};
use crate::study::case::{Input, Outcome};
use crate::study::sensitivity::{Bar, Change, Effect, Step};
use crate::units::to_kn;
use serde::Serialize;
use std::fmt::Write;

/// One object, or a list of them with one line each.
pub fn json(studied: &[Studied], several: bool) -> Result<String, Fault> {
    json_list(studied.iter().map(Report::of), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    layout: Option<&'a str>,
    version: &'static str,
    fingerprint: String,
    inputs: InputsJson<'a>,
    base: Option<Values>,
    missing: Option<&'static str>,
    sensitivity: Vec<BarJson>,
    /// Inputs by falling effect.
    order: Order,
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
struct BarJson {
    input: &'static str,
    unit: &'static str,
    #[serde(serialize_with = "number")]
    value: f64,
    low: StepJson,
    high: StepJson,
}

#[derive(Serialize)]
struct StepJson {
    #[serde(serialize_with = "number")]
    value: f64,
    #[serde(flatten)]
    values: Option<Values>,
    change: Option<ChangeJson>,
    missing: Option<&'static str>,
    warnings: Vec<&'static str>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ChangeJson {
    #[serde(serialize_with = "number")]
    F_kN: f64,
    #[serde(serialize_with = "number")]
    delta_m: f64,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
    /// Parts of the base's values.
    #[serde(serialize_with = "number")]
    F: f64,
    #[serde(serialize_with = "number")]
    delta: f64,
    other_branch: bool,
}

/// A value of an input in its unit of output.
fn shown(input: Input, value: f64) -> f64 {
    if input.is_force() { to_kn(value) } else { value }
}

fn unit(input: Input) -> &'static str {
    if input.is_force() { "kN" } else { "m" }
}

fn values(outcome: &Outcome) -> Option<Values> {
    outcome.as_ref().ok().map(|p| Values {
        F_kN: to_kn(p.values().force),
        delta_m: p.values().deflection,
        utilisation: p.utilisation(),
    })
}

fn codes(outcome: &Outcome) -> Vec<&'static str> {
    outcome.iter().flat_map(|p| p.warnings.iter().map(|w| w.code())).collect()
}

fn missing(outcome: &Outcome) -> Option<&'static str> {
    outcome.as_ref().err().map(|why| why.code())
}

impl<'a> Report<'a> {
    fn of(s: &'a Studied) -> Report<'a> {
        let base = &s.sensitivity.base;
        let order = |effect| s.sensitivity.by(effect).iter().map(|b| b.input.word()).collect();
        Report {
            layout: s.name.as_deref(),
            version: VERSION,
            fingerprint: s.case.fingerprint().to_string(),
            inputs: InputsJson::of(&s.case.layout, &s.case.mesh, s.case.rule),
            base: values(base),
            missing: missing(base),
            sensitivity: s.sensitivity.bars.iter().map(BarJson::of).collect(),
            order: Order { F: order(Effect::Force), delta: order(Effect::Deflection) },
            warnings: base.iter().flat_map(|p| p.warnings.iter().map(WarningJson::of)).collect(),
            basis: BASIS,
        }
    }
}

impl BarJson {
    fn of(bar: &Bar) -> BarJson {
        let step = |s: &Step| StepJson {
            value: shown(bar.input, s.value),
            values: values(&s.outcome),
            change: s.change.map(|c| ChangeJson::of(&c)),
            missing: missing(&s.outcome),
            warnings: codes(&s.outcome),
        };
        BarJson {
            input: bar.input.word(),
            unit: unit(bar.input),
            value: shown(bar.input, bar.value),
            low: step(&bar.lowered),
            high: step(&bar.raised),
        }
    }
}

impl ChangeJson {
    fn of(c: &Change) -> ChangeJson {
        ChangeJson {
            F_kN: to_kn(c.force),
            delta_m: c.deflection,
            utilisation: c.utilisation,
            F: c.force_part,
            delta: c.deflection_part,
            other_branch: c.other_branch,
        }
    }
}

/// One line a step: two for each input.
pub fn csv(studied: &[Studied], several: bool) -> String {
    let mut out = String::from(if several { "layout," } else { "" });
    out.push_str("input,unit,step,value,F_kN,delta_m,utilisation,change_F_kN,change_delta_m,change_utilisation,other_branch,missing,warnings\n");
    for s in studied {
        let name = match &s.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for bar in &s.sensitivity.bars {
            for (word, step) in [("low", &bar.lowered), ("high", &bar.raised)] {
                let (v, c) = (values(&step.outcome), step.change);
                // Writing to a string cannot fail.
                let _ = writeln!(
                    out,
                    "{name}{},{},{word},{},{},{},{},{},{},{},{},{},{}",
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
