//! The verdict in words and as an object, the same wherever it is shown.

use super::objects;
use super::value::{Object, Value, kn};
use crate::case::Case;
use crate::study::mend::mend;
use crate::study::verdict::{Aspect, Checked, Judge, State, Verdict, VerdictRemark};
use crate::units::{LengthUnit, force_text, length_text, percent};
use crate::words::Choice;

/// A demand or capacity in kN or m, by its check.
fn number(aspect: Aspect, si: Option<f64>) -> Value {
    match aspect {
        Aspect::Deflection => si.into(),
        _ => si.map(kn).into(),
    }
}

fn names(aspect: Aspect) -> [&'static str; 3] {
    match aspect {
        Aspect::Deflection => ["demand_m", "capacity_m", "capacity_characteristic_m"],
        _ => ["demand_kN", "capacity_kN", "capacity_characteristic_kN"],
    }
}

/// One check as an object.
fn check(c: &Checked) -> Object {
    let [demand, mean, characteristic] = names(c.aspect);
    Object::new()
        .with("check", c.aspect.word())
        .with("state", c.state.word())
        .with("why", c.state.why())
        .with(demand, number(c.aspect, c.demand))
        .with(mean, number(c.aspect, c.capacity[0]))
        .with(characteristic, number(c.aspect, c.capacity[1]))
        .with("use", c.usage[0])
        .with("use_characteristic", c.usage[1])
        .with("by", c.judge.map(Judge::word))
}

/// The verdict as an object, with what would mend it.
pub(crate) fn object(case: &Case, v: &Verdict) -> Object {
    let remark = |r: &VerdictRemark| objects::remark(r.code(), r.weight(), r.sentence().into());
    let mend = mend(case, v).map(|m| {
        let name = m.input.row().name;
        Object::new()
            .with("input", name)
            .with(m.input.column(), super::columns::input(m.input, m.value))
    });
    Object::new()
        .with("verdict", v.finding().word())
        .with("basis", v.basis.word())
        .with("governing", v.governing().map(|c| c.aspect.word()))
        .with("use", v.largest_use())
        .with("checks", v.checks.iter().map(check).collect::<Value>())
        .with("remarks", v.remarks.iter().map(remark).collect::<Value>())
        .with("mend", mend)
}

/// The verdict in a few words: `FAILS: deflection 157 %`.
pub(crate) fn short(v: &Verdict) -> String {
    let word = v.finding().word();
    if let Some(c) = v.governing() {
        let usage = match (c.state, v.usage(c)) {
            (State::PassesThrough, _) => " passes through".to_string(),
            (_, Some(usage)) => format!(" {} %", percent(usage)),
            (_, None) => String::new(),
        };
        return format!("{word}: {}{usage}", c.aspect.word());
    }
    match v.checks.iter().find_map(|c| c.state.why()) {
        Some(why) => format!("{word}: {why}"),
        None => word.to_string(),
    }
}

/// A check as a sentence with its mark in front, nothing where it is not asked:
/// `x deflection: 0.629 m of 0.400 m, 157 %`.
pub(crate) fn sentence(c: &Checked, unit: LengthUnit) -> Option<String> {
    let text = |si: f64| match c.aspect {
        Aspect::Deflection => length_text(si, unit),
        _ => force_text(si),
    };
    let name = format!("{} {}", c.state.mark(), c.aspect.word());
    match c.state {
        State::NotAsked(_) => return None,
        State::NotJudged(why) => return Some(format!("{name}: not judged, {why}")),
        State::PassesThrough => return Some(format!("{name}: passes through in every run")),
        State::Pass | State::Fail => {}
    }
    let demand = c.demand.map_or("beyond failure".to_string(), text);
    let capacity = c.capacity[0].map_or(String::new(), |v| format!(" of {}", text(v)));
    let usage = match c.usage {
        [Some(mean), Some(low)] if mean != low => {
            format!("{} % mean, {} % characteristic", percent(mean), percent(low))
        }
        [Some(mean), _] => format!("{} %", percent(mean)),
        _ => "use unknown".to_string(),
    };
    let by = if c.judge == Some(Judge::Check) { ", by the check" } else { "" };
    Some(format!("{name}: {demand}{capacity}, {usage}{by}"))
}

/// What would mend it, as a sentence; nothing where nothing fails.
pub(crate) fn mended(case: &Case, v: &Verdict) -> Option<String> {
    let failing = v.checks.iter().any(|c| c.state.fails());
    failing.then(|| match mend(case, v) {
        Some(m) => format!("{} would pass, by the forecast", m.text()),
        None => "no plate or spacing alone, within the published ranges".to_string(),
    })
}
