//! Design solutions as JSON and CSV: SI with kN.

use super::Solved;
use crate::case::{CasePoint, CaseValue};
use crate::cli::output::{Fault, cell, json_list, number, optional, quoted};
use crate::cli::page::BASIS;
use crate::cli::shapes::{Head, InputsJson, Pair, WarningJson, pair};
use crate::forecast::design::Question;
use crate::study::solve::{Crossing, Place, Solution};
use crate::units::to_kn;
use serde::Serialize;
use std::fmt::Write;

/// One object, or a list of them with one line each.
pub(crate) fn json(solved: &[Solved], several: bool) -> Result<String, Fault> {
    json_list(solved.iter().map(Report::of), several)
}

#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    question: QuestionJson,
    field: Option<Pair>,
    design: Option<crate::cli::shapes::Design>,
    solutions: Vec<SolutionJson>,
    warnings: Vec<WarningJson>,
    basis: &'static str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct QuestionJson {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
    #[serde(serialize_with = "number")]
    gamma_load: f64,
    #[serde(serialize_with = "number")]
    gamma_resistance: f64,
}

#[derive(Serialize)]
struct SolutionJson {
    solve: &'static str,
    requirement: &'static str,
    met: &'static str,
    #[serde(serialize_with = "crate::cli::output::list")]
    range_m: Vec<f64>,
    spans: Vec<SpanJson>,
    crossings: Vec<CrossingJson>,
    ends: Vec<PlaceJson>,
    best: Option<PlaceJson>,
}

#[derive(Serialize)]
struct SpanJson {
    #[serde(serialize_with = "number")]
    from_m: f64,
    #[serde(serialize_with = "number")]
    to_m: f64,
}

#[derive(Serialize)]
struct CrossingJson {
    #[serde(serialize_with = "number")]
    value_m: f64,
    /// The nearest whole millimetre that meets it.
    #[serde(serialize_with = "optional")]
    rounded_m: Option<f64>,
    met: &'static str,
    kind: &'static str,
    #[serde(flatten)]
    values: ValuesJson,
    beyond: ValuesJson,
}

#[derive(Serialize)]
struct PlaceJson {
    #[serde(serialize_with = "number")]
    value_m: f64,
    met: bool,
    #[serde(serialize_with = "optional")]
    margin: Option<f64>,
    #[serde(flatten)]
    values: ValuesJson,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ValuesJson {
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_m: Option<f64>,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
    /// Deflection at the factored design force.
    #[serde(serialize_with = "optional")]
    design_delta_m: Option<f64>,
    missing: Option<&'static str>,
    warnings: Vec<&'static str>,
}

impl ValuesJson {
    fn of(outcome: Result<&CasePoint, &'static str>) -> ValuesJson {
        let point = outcome.ok();
        ValuesJson {
            F_kN: point.map(|p| to_kn(p.values().force)),
            delta_m: point.map(|p| p.values().deflection),
            utilisation: point.and_then(|p| p.utilisation()),
            design_delta_m: point.and_then(|p| p.answer.at_force?.deflection),
            missing: outcome.err(),
            warnings: point.iter().flat_map(|p| p.warnings.iter().map(|w| w.code())).collect(),
        }
    }

    fn of_outcome(outcome: &CaseValue) -> ValuesJson {
        ValuesJson::of(outcome.as_ref().map_err(|why| why.code()))
    }
}

/// Whether a requirement is met in the range: `everywhere`, `nowhere` or `partly`.
fn met(s: &Solution) -> &'static str {
    if s.always() {
        "everywhere"
    } else if s.never() {
        "nowhere"
    } else {
        "partly"
    }
}

fn side(c: &Crossing) -> &'static str {
    if c.met_above { "above" } else { "below" }
}

impl QuestionJson {
    fn of(q: &Question) -> QuestionJson {
        QuestionJson {
            F_kN: q.force.map(to_kn),
            delta_m: q.deflection,
            gamma_load: q.gamma_load,
            gamma_resistance: q.gamma_resistance,
        }
    }
}

impl PlaceJson {
    fn of(p: &Place) -> PlaceJson {
        PlaceJson {
            value_m: p.value,
            met: p.met(),
            margin: p.margin,
            values: ValuesJson::of_outcome(&p.outcome),
        }
    }
}

impl SolutionJson {
    fn of(s: &Solution) -> SolutionJson {
        SolutionJson {
            solve: s.input.word(),
            requirement: s.requirement.word(),
            met: met(s),
            range_m: vec![s.range.min, s.range.max],
            spans: s.spans.iter().map(|p| SpanJson { from_m: p.from, to_m: p.to }).collect(),
            crossings: s
                .crossings
                .iter()
                .map(|c| CrossingJson {
                    value_m: c.value,
                    rounded_m: c.rounded,
                    met: side(c),
                    kind: c.kind.word(),
                    values: ValuesJson::of(Ok(&c.point)),
                    beyond: ValuesJson::of_outcome(&c.beyond),
                })
                .collect(),
            ends: s.ends.iter().map(PlaceJson::of).collect(),
            best: s.best.as_ref().map(PlaceJson::of),
        }
    }
}

impl<'a> Report<'a> {
    fn of(s: &'a Solved) -> Report<'a> {
        let point = s.outcome.as_ref().ok();
        Report {
            head: Head::of(
                s.name.as_deref(),
                s.case.question_fingerprint(),
                InputsJson::of(&s.case.layout, &s.case.mesh, s.case.rule),
            ),
            question: QuestionJson::of(&s.case.question),
            field: point.map(|p| pair(p.values())),
            design: point.map(|p| crate::cli::shapes::Design::of(&p.answer, &s.case.question)),
            solutions: s.solutions.iter().map(SolutionJson::of).collect(),
            warnings: point.iter().flat_map(|p| p.warnings.iter().map(WarningJson::of)).collect(),
            basis: BASIS,
        }
    }
}

/// One line a place: the ends of the range and every crossing, rising.
pub(crate) fn csv(solved: &[Solved], several: bool) -> String {
    let mut out = String::from(if several { "layout," } else { "" });
    out.push_str(
        "solve,requirement,place,value_m,rounded_m,met,F_kN,delta_m,utilisation,design_delta_m,missing,warnings\n",
    );
    for s in solved {
        let name = match &s.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for solution in &s.solutions {
            let front = format!("{name}{},{}", solution.input.word(), solution.requirement.word());
            let [low, high] = &solution.ends;
            let mut line =
                |place: &str, value: f64, rounded: Option<f64>, met: &str, v: &ValuesJson| {
                    // Writing to a string cannot fail.
                    let _ = writeln!(
                        out,
                        "{front},{place},{},{},{met},{},{},{},{},{},{}",
                        cell(Some(value)),
                        cell(rounded),
                        cell(v.F_kN),
                        cell(v.delta_m),
                        cell(v.utilisation),
                        cell(v.design_delta_m),
                        v.missing.unwrap_or_default(),
                        v.warnings.join(";")
                    );
                };
            let yes_no = |p: &Place| if p.met() { "yes" } else { "no" };
            line("low_end", low.value, None, yes_no(low), &ValuesJson::of_outcome(&low.outcome));
            for c in &solution.crossings {
                line(c.kind.word(), c.value, c.rounded, side(c), &ValuesJson::of(Ok(&c.point)));
            }
            line(
                "high_end",
                high.value,
                None,
                yes_no(high),
                &ValuesJson::of_outcome(&high.outcome),
            );
        }
    }
    out
}
