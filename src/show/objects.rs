//! Parts of results as JSON objects, by the names of the columns: SI with kN.

use super::columns::{CheckRow, check_mean, point};
use super::value::{Object, Value, kn};
use crate::VERSION;
use crate::case::{Case, CaseValue, Input, Question};
use crate::curve::Curve;
use crate::fingerprint::Fingerprint;
use crate::forecast::Strength;
use crate::forecast::design::Answer;
use crate::forecast::warning::Warning;
use crate::layout::{Blocks, MethodChoice, PunchShape, Twists};
use crate::remark::Weight;
use crate::study::checks::change::CheckChange;
use crate::study::result::{CheckResult, Wanted};
use crate::study::sensitivity::Change;
use crate::units::{Units, to_kj, to_kn};
use crate::words::Choice;

/// How the result of a layout begins: its name, in the list of a project, what made it, its inputs.
pub(crate) fn head(name: Option<&str>, fingerprint: Fingerprint, inputs: Object) -> Object {
    Object::new()
        .maybe("layout", name.map(String::from))
        .with("version", VERSION)
        .with("fingerprint", fingerprint.to_string())
        .with("inputs", inputs)
}

/// The inputs of a case.
pub(crate) fn inputs(case: &Case) -> Object {
    let layout = &case.layout;
    let sizes = Input::GEOMETRY
        .iter()
        .filter(|input| input.stands_in(layout))
        .fold(Object::new(), |object, input| object.with(input.column(), input.value(case)));
    let grid = &layout.grid;
    let sizes = sizes
        .maybe("stagger", grid.stagger.then_some(true))
        .maybe("twists", (grid.twists != Twists::default()).then(|| grid.twists.word()));
    let (blocks, shape) = (layout.blocks, layout.shape);
    let sizes = sizes.maybe("shape", (shape != PunchShape::default()).then(|| shape.word()));
    let sizes = sizes.maybe("blocks", (blocks != Blocks::default()).then(|| blocks.word()));
    let method = case.layout.method;
    let sizes = sizes.maybe("method", (method != MethodChoice::default()).then(|| method.word()));
    sizes.with("mesh", case.mesh.id.clone()).with("branch", case.rule.word())
}

/// A force (N) with its deflection (m).
pub(crate) fn pair(force: f64, deflection: impl Into<Option<f64>>) -> Object {
    Object::new().with("F_kN", kn(force)).with("delta_m", deflection.into())
}

/// The same of values.
pub(crate) fn values(values: Strength) -> Object {
    pair(values.force, values.deflection)
}

/// A force with its deflection; nothing in both where there is none.
pub(crate) fn maybe_pair<D: Into<Option<f64>>>(pair: Option<(f64, D)>) -> Object {
    let (force, deflection) = pair.map(|p| (to_kn(p.0), p.1.into())).unzip();
    Object::new().with("F_kN", force).with("delta_m", deflection.flatten())
}

pub(crate) fn curve(curve: &Curve) -> Object {
    Object::new()
        .with("delta_m", Value::Numbers(curve.deflection.clone()))
        .with("F_kN", Value::Numbers(curve.force.iter().map(|v| to_kn(*v)).collect()))
}

/// Two ends; nothing in both where there are none.
pub(crate) fn ends(ends: Option<[f64; 2]>) -> Value {
    let ends = ends.map_or([None; 2], |ends| ends.map(Some));
    ends.into_iter().map(Value::from).collect()
}

/// Warnings of a forecast.
pub(crate) fn warnings(warnings: &[Warning]) -> Value {
    let object = |w: &Warning| remark(w.code(), w.weight(), w.sentence(Units::METRES));
    warnings.iter().map(object).collect()
}

/// A remark: a stable code, how much it weighs, a sentence.
pub(crate) fn remark(code: &str, weight: Weight, sentence: String) -> Object {
    Object::new()
        .with("code", code.to_string())
        .with("weight", weight.word())
        .with("message", sentence)
}

/// The answer to a design question, with the factors that act.
pub(crate) fn design(answer: &Answer, question: &Question) -> Object {
    let at_force = answer.at_force.zip(question.force).map(|(at, force)| {
        Object::new()
            .with("F_kN", kn(force))
            .with("load_kN", kn(at.load))
            .with("utilisation", at.utilisation)
            .with("margin_kN", kn(at.margin))
            .with("delta_m", at.deflection)
            .with("service_delta_m", at.service_deflection)
            .with("within_allowable", at.within_allowable)
    });
    let at_deflection = answer.at_deflection.zip(question.deflection).map(|(at, deflection)| {
        Object::new()
            .with("delta_m", deflection)
            .with("F_kN", kn(at.force))
            .with("design_F_kN", kn(at.design_force))
            .with("energy_kJ", to_kj(at.energy))
            .with("beyond_failure", at.beyond_failure)
    });
    Object::new()
        .with("gamma_resistance", question.gamma_resistance)
        .with("gamma_load", question.gamma_load)
        .with("resistance_kN", kn(answer.resistance))
        .with("at_force", at_force)
        .with("at_deflection", at_deflection)
}

/// Force, deflection, utilisation and service deflection of a case that has them.
pub(crate) fn of_point(outcome: &CaseValue) -> Option<Object> {
    outcome.as_ref().ok()?;
    let [force, deflection, utilisation, _, service, ..] = point();
    Some(Object::new().columns(&[force, deflection, utilisation, service], &outcome.into()))
}

/// How the values of a case differ from a study's base, also as parts of the base's.
pub(crate) fn change(c: &Change) -> Object {
    moved((c.force, c.deflection), c.utilisation, (c.force_part, c.deflection_part))
        .with("service_delta_m", c.service)
        .with("other_branch", c.other_branch)
}

fn moved(
    values: (f64, Option<f64>),
    utilisation: Option<f64>,
    parts: (f64, Option<f64>),
) -> Object {
    pair(values.0, values.1)
        .with("utilisation", utilisation)
        .with("F", parts.0)
        .with("delta", parts.1)
}

/// What all checks of a study have in common.
pub(crate) fn plan(wanted: &Wanted) -> Object {
    Object::new()
        .with("fidelity", wanted.fidelity.word())
        .with("runs", wanted.runs)
        .with("seed", Value::Count(wanted.seed))
        .with("seeds", "the same in all cases")
}

/// A check as three values: it, or why it is missing. `change` is that against a study's base, with
/// nothing in it where it is not known; only checks that have a base say it.
pub(crate) fn check(row: &CheckRow, change: Option<Option<&CheckChange>>) -> Object {
    Object::new()
        .with("check", row.result.map(|result| made(row, result, change)))
        .with("check_missing", row.missing.map(super::super::study::checks::NoCheck::code))
        .with("check_reason", row.missing.map(super::super::study::checks::NoCheck::sentence))
}

fn made(row: &CheckRow, result: &CheckResult, change: Option<Option<&CheckChange>>) -> Object {
    let mean = check_mean().into_iter().fold(Object::new(), |object, (name, get)| {
        object.with(name.trim_start_matches("check_"), get(row))
    });
    let f = row.figures;
    let band = Object::new()
        .with("F_kN", ends(f.and_then(|f| f.force_band).map(|b| b.map(to_kn))))
        .with("delta_m", ends(f.and_then(|f| f.deflection_band)));
    let difference = f.and_then(|f| f.difference);
    let difference = difference.map(|d| {
        Object::new().with("F", 100.0 * d.force).with("delta", d.deflection.map(|d| 100.0 * d))
    });
    let error = f.and_then(|f| f.error).map(|v| (v.force, v.deflection));
    mean.with("band", band)
        .with("standard_error", maybe_pair(error))
        .with("runs", result.runs)
        // How many of them are in the mean: those that broke a wire.
        .with("broken", result.breaks.len())
        .with("slipped", result.slipped)
        // The worst of the runs' own estimates, as a part.
        .with("error_estimate", result.quality.error_estimate)
        .with("difference_pct", difference)
        .maybe("change", change.map(|change| Value::from(change.map(check_change))))
        .with("fingerprint", result.inputs.to_string())
        .with(
            "warnings",
            result.flags.iter().map(|flag| Value::from(flag.code().to_string())).collect::<Value>(),
        )
}

fn check_change(c: &CheckChange) -> Object {
    let error = Object::new()
        .with("F_kN", c.force.error.map(to_kn))
        .with("delta_m", c.deflection.error)
        .with("utilisation", c.utilisation.and_then(|k| k.error));
    let utilisation = c.utilisation.map(|k| k.value);
    let parts = (c.force_part, Some(c.deflection_part));
    moved((c.force.value, Some(c.deflection.value)), utilisation, parts)
        .with("standard_error", error)
        // Whether the errors are those of pairs of runs with the same seed.
        .with("paired", c.paired)
}
