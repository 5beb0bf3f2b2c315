//! A sensitivity as JSON: SI with kN, the inputs in the order of the definitions.

use super::Studied;
use crate::case::CaseValue;
use crate::cli::output::{Fault, json_list};
use crate::cli::page::BASIS;
use crate::show::columns::{CheckRow, PointRow, input, point};
use crate::show::objects::{self, change, check, head, inputs, plan};
use crate::show::value::{Object, Value};
use crate::show::verdict;
use crate::study::result::Wanted;
use crate::study::sensitivity::dem::{CheckedBar, CheckedStep};
use crate::study::sensitivity::{Bar, Effect, Step};
use crate::study::verdict::{Simulated, verdict as judge};

/// One object, or a list of them with one line each.
pub(crate) fn report(
    studied: &[Studied],
    wanted: Option<&Wanted>,
    several: bool,
) -> Result<String, Fault> {
    json_list(studied.iter().map(|s| one(s, wanted)), several)
}

fn one(s: &Studied, wanted: Option<&Wanted>) -> Object {
    let base = &s.sensitivity.base;
    let row = PointRow::from(base);
    let checks = s.checked.as_ref();
    let own = checks.map(|c| CheckRow::new(&c.base, row.values, &s.case.asked()));
    let simulated = checks.map_or(Simulated::Missing, |c| Simulated::made(&c.base));
    let own_verdict = judge(&s.case, base, simulated, s.basis);
    let bars = s.sensitivity.bars.iter();
    let bars = bars.map(|b| bar(s, b, checks.and_then(|c| c.bar(b.input))));
    let order = |by: &dyn Fn(Effect) -> Vec<&'static str>| {
        Object::new()
            .with("F", Value::Codes(by(Effect::Force)))
            .with("delta", Value::Codes(by(Effect::Deflection)))
    };
    let by_checks =
        checks.map(|c| order(&|e| c.by(e).iter().map(|bar| bar.input.word()).collect()));
    head(s.name.as_deref(), s.case.fingerprint(), inputs(&s.case))
        .with("base", objects::of_point(base))
        .with("verdict", verdict::object(&s.case, &own_verdict))
        .with("missing", row.missing)
        .maybe("check_plan", wanted.map(plan))
        .and(own.map(|own| check(&own, None)).unwrap_or_default())
        .with("sensitivity", bars.collect::<Value>())
        // Inputs by falling effect.
        .with("order", order(&|e| s.sensitivity.by(e).iter().map(|b| b.input.word()).collect()))
        .maybe("check_order", by_checks)
        .with("warnings", objects::warnings(row.warnings))
        .with("basis", BASIS)
}

fn bar(s: &Studied, bar: &Bar, checked: Option<&CheckedBar>) -> Object {
    let of = |at: &Step, checked: Option<&CheckedStep>| step(s, bar, at, checked);
    Object::new()
        .with("input", bar.input.word())
        .with("unit", super::unit(bar.input))
        .with("value", input(bar.input, bar.value))
        .with("low", of(&bar.lowered, checked.map(|c| &c.lowered)))
        .with("high", of(&bar.raised, checked.map(|c| &c.raised)))
}

fn step(s: &Studied, bar: &Bar, step: &Step, checked: Option<&CheckedStep>) -> Object {
    let outcome: &CaseValue = &step.outcome;
    let row = PointRow::from(outcome);
    let [.., missing, warnings] = point();
    let asked = s.case.with(bar.input, step.value).asked();
    let check = checked
        .map(|c| check(&CheckRow::new(&c.answer, row.values, &asked), Some(c.change.as_ref())));
    Object::new()
        .with("value", input(bar.input, step.value))
        .and(objects::of_point(outcome).unwrap_or_default())
        .columns(&verdict::COLUMNS, &s.judged(bar.input, step, checked))
        .with("change", step.change.as_ref().map(change))
        .columns(&[missing, warnings], &row)
        .and(check.unwrap_or_default())
}
