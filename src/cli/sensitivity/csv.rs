//! A sensitivity as CSV: one line a step, two for each input.

use super::{Studied, unit};
use crate::case::Input;
use crate::show::columns::{
    self, CHANGE, CHECK_CHANGE, CheckRow, PointRow, check_mean, check_more, point,
};
use crate::show::table::Table;
use crate::show::verdict;
use crate::study::checks::change::CheckChange;
use crate::study::sensitivity::Change;
use crate::study::verdict::Verdict;

/// One step of an input.
struct StepRow<'a> {
    name: Option<&'a str>,
    input: Input,
    word: &'static str,
    value: f64,
    point: PointRow<'a>,
    verdict: Verdict,
    change: Option<Change>,
    check: Option<CheckRow<'a>>,
    check_change: Option<CheckChange>,
}

/// The steps of all layouts, with the checks where there are any; several layouts share one table with
/// the layout's name in front.
pub(crate) fn report(studied: &[Studied], checks: bool, several: bool) -> String {
    let [force, deflection, utilisation, _, service, missing, warnings] = point();
    let table = Table::<StepRow>::new()
        .when(several, |table| table.with("layout", |s| s.name.map(String::from).into()))
        .with("input", |s| s.input.word().into())
        .with("unit", |s| unit(s.input).into())
        .with("step", |s| s.word.into())
        .with("value", |s| columns::input(s.input, s.value))
        .part([force, deflection, utilisation, service], |s| Some(&s.point))
        .part(verdict::COLUMNS, |s| Some(&s.verdict))
        .part(CHANGE, |s| s.change.as_ref())
        .part([missing, warnings], |s| Some(&s.point))
        .when(checks, |table| {
            table
                .part(check_mean(), |s| s.check.as_ref())
                .part(check_more(), |s| s.check.as_ref())
                .part(CHECK_CHANGE, |s| s.check_change.as_ref())
        });
    table.csv(studied.iter().flat_map(rows), ";")
}

fn rows(s: &Studied) -> impl Iterator<Item = StepRow<'_>> {
    s.sensitivity.bars.iter().flat_map(move |bar| {
        let checked = s.checked.as_ref().and_then(|c| c.bar(bar.input));
        let steps = [
            ("low", &bar.lowered, checked.map(|c| &c.lowered)),
            ("high", &bar.raised, checked.map(|c| &c.raised)),
        ];
        steps.map(|(word, step, checked)| {
            let point = PointRow::from(&step.outcome);
            let asked = s.case.with(bar.input, step.value).asked();
            let check = checked.map(|c| CheckRow::new(&c.answer, point.values, &asked));
            StepRow {
                name: s.name.as_deref(),
                input: bar.input,
                word,
                value: step.value,
                point,
                verdict: s.judged(bar.input, step, checked),
                change: step.change,
                check,
                check_change: checked.and_then(|c| c.change),
            }
        })
    })
}
