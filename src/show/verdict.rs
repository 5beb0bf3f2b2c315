//! The verdict in words and as an object, the same wherever it is shown.

use super::objects;
use super::value::{NamedColumn, Object, Value, kn};
use crate::case::{Case, CaseValue};
use crate::study::checks::CheckAnswer;
use crate::study::mend::mend;
use crate::study::sweep::SweepGrid;
use crate::study::verdict::{
    Aspect, Basis, Checked, Finding, Judge, Simulated, State, Verdict, VerdictRemark, verdict,
};
use crate::units::{Units, force_text, length_text, percent};
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

/// The columns of a verdict in tables: its word, what governs it, and the use on the basis that
/// decides.
pub(crate) const COLUMNS: [NamedColumn<Verdict>; 3] = [
    ("verdict", |v| v.finding().word().into()),
    ("verdict_by", |v| v.governing().map(|c| c.aspect.word()).into()),
    ("use", |v| v.largest_use().into()),
];

/// Whether it is not enough.
pub(crate) fn fails(v: &Verdict) -> bool {
    v.finding() == Finding::Fails
}

/// The governing use in per cent for a narrow column, without its sign.
pub(crate) fn usage(v: &Verdict) -> String {
    match v.governing() {
        Some(c) if c.state == State::PassesThrough => "slips".into(),
        Some(c) => v.usage(c).map_or("-".into(), per_cent),
        None => "-".into(),
    }
}

/// A use in per cent; what is beyond all measure is not told to the digit.
pub(crate) fn per_cent(usage: f64) -> String {
    if usage < 10.0 { percent(usage) } else { ">1000".into() }
}

/// The verdict in a few words: `FAILS: deflection 157 %`.
pub(crate) fn short(v: &Verdict) -> String {
    let word = v.finding().word();
    if let Some(c) = v.governing() {
        let usage = match (c.state, v.usage(c)) {
            (State::PassesThrough, _) => " passes through".to_string(),
            (_, Some(usage)) => format!(" {} %", per_cent(usage)),
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
pub(crate) fn sentence(c: &Checked, unit: Units) -> Option<String> {
    let text = |si: f64| match c.aspect {
        Aspect::Deflection => length_text(si, unit),
        _ => force_text(si, unit),
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
            format!("{} % mean, {} % characteristic", per_cent(mean), per_cent(low))
        }
        [Some(mean), _] => format!("{} %", per_cent(mean)),
        _ => "use unknown".to_string(),
    };
    let by = if c.judge == Some(Judge::Check) { ", by the check" } else { "" };
    Some(format!("{name}: {demand}{capacity}, {usage}{by}"))
}

/// What is to be said behind the verdict itself: each check that is asked, what to know, what would mend
/// it.
pub(crate) fn lines(case: &Case, v: &Verdict, unit: Units) -> Vec<String> {
    let checks = v.checks.iter().filter_map(|c| sentence(c, unit));
    let remarks = v.remarks.iter().map(|r| format!("! {}", r.sentence()));
    checks.chain(remarks).chain(mended(case, v)).collect()
}

/// What would mend it, as a sentence; nothing where nothing fails.
fn mended(case: &Case, v: &Verdict) -> Option<String> {
    if v.finding() != Finding::Fails {
        return None;
    }
    Some(match mend(case, v) {
        Some(m) => format!("mended by {}, by the forecast", m.text()),
        None if v.checks.iter().any(|c| c.state.fails() && c.judge == Some(Judge::Check)) => {
            "what would mend it is not known: the check fails it, and only the forecast is searched"
                .into()
        }
        None => "not mended by plate or spacing alone within the published ranges".into(),
    })
}

/// The marks of the verdicts on the points of a sweep, by their forecasts and the checks that there are;
/// none where nothing is asked.
pub(crate) fn marks(
    base: &Case,
    grid: &SweepGrid,
    points: &[CaseValue],
    answers: &[CheckAnswer],
    basis: Basis,
) -> Vec<char> {
    if !base.question.asks() {
        return Vec::new();
    }
    let mark = |(index, outcome): (usize, &CaseValue)| {
        let made = answers.get(index).map_or(Simulated::Missing, Simulated::made);
        verdict(&grid.case(base, index), outcome, made, basis).finding().mark()
    };
    points.iter().enumerate().map(mark).collect()
}

/// The verdict on a case by its forecast alone, in a few words; nothing where nothing is asked.
pub(crate) fn of_outcome(case: &Case, outcome: &CaseValue, basis: Basis) -> Option<String> {
    let v = verdict(case, outcome, Simulated::Missing, basis);
    (v.finding() != Finding::NotAsked).then(|| short(&v))
}

/// A check in a cell of a table: `85.4 / 96.5 %` for mean and characteristic values,
/// `157 % (0.629 m)` for a deflection with what is reached.
pub(crate) fn cell(c: &Checked, unit: Units) -> String {
    match (c.state, c.usage) {
        (State::NotAsked(_), _) => "-".into(),
        (State::NotJudged(_), _) => "not judged".into(),
        (State::PassesThrough, _) => "passes through".into(),
        (_, [Some(mean), _]) if c.aspect == Aspect::Deflection => {
            let demand = c.demand.map_or("fails".into(), |v| length_text(v, unit));
            format!("{} % ({demand})", per_cent(mean))
        }
        (_, [Some(mean), Some(low)]) if mean != low => {
            format!("{} / {} %", per_cent(mean), per_cent(low))
        }
        (_, [Some(mean), _]) => format!("{} %", per_cent(mean)),
        _ => "-".into(),
    }
}

/// A check in a narrow panel, in kN or the unit of lengths: `x deflect. 157 % 0.629/0.400`; nothing
/// where it is not asked. The capacity is that of the basis that decides.
pub(crate) fn brief(v: &Verdict, c: &Checked, unit: Units) -> Option<String> {
    let word = match c.aspect {
        Aspect::Deflection => "deflect.",
        other => other.word(),
    };
    let name = format!("{} {word}", c.state.mark());
    let number = |si: f64| {
        let text = match c.aspect {
            Aspect::Deflection => length_text(si, unit),
            _ => force_text(si, unit),
        };
        text.split(' ').next().map(String::from)
    };
    let number = |si: Option<f64>| si.and_then(number).unwrap_or("-".into());
    match c.state {
        State::NotAsked(_) => None,
        State::NotJudged(_) => Some(format!("{name} not judged")),
        State::PassesThrough => Some(format!("{name} passes through")),
        State::Pass | State::Fail => {
            let (demand, capacity) = (number(c.demand), number(c.capacity[v.basis as usize]));
            let used = v.usage(c).map_or("-".into(), per_cent);
            Some(format!("{name} {used} % {demand}/{capacity}"))
        }
    }
}
