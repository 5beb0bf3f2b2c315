//! A comparison as JSON: SI with kN, in the order asked for.

use super::{Compared, mark};
use crate::cli::VERSION;
use crate::cli::output::{Fault, json};
use crate::cli::page::BASIS;
use crate::show::columns::{CheckRow, OVER_LAB, PointRow, RATIOS, point};
use crate::show::objects::{self, check, design, inputs, plan};
use crate::show::value::{Object, Value, kn};
use crate::show::verdict;
use crate::study::verdict::Aspect;

/// One object with a list of the layouts.
pub(crate) fn report(compared: &Compared, order: &[usize]) -> Result<String, Fault> {
    let c = &compared.comparison;
    let governing = c.governing.map(|g| {
        let row = &c.rows[g.row];
        Object::new()
            .with("layout", row.name.clone())
            .with("by", g.by.map_or("F", Aspect::word))
            .with("utilisation", row.utilisation())
            .with("use", row.verdict.largest_use())
            .with("F_kN", row.values().ok().map(|v| kn(v.force)))
    });
    let report = Object::new()
        .with("version", VERSION)
        .with("fingerprint", c.fingerprint().to_string())
        .with("governing", governing)
        .maybe("check_plan", compared.checked.as_ref().map(|(wanted, _)| plan(wanted)))
        .maybe("remark", c.mixed())
        .with("layouts", order.iter().map(|index| one(compared, *index)).collect::<Value>())
        .with("basis", BASIS);
    Ok(json(&report)? + "\n")
}

fn one(compared: &Compared, index: usize) -> Object {
    let c = &compared.comparison;
    let row = &c.rows[index];
    let given = PointRow::from(row);
    let [_, _, utilisation, _, service, missing, _] = point();
    let ratios = row.forecast();
    let ratios = ratios.map(|f| Object::new().columns(&RATIOS, f).columns(&OVER_LAB, f));
    let question = &row.case.question;
    let check = compared
        .answer(index)
        .map(|answer| check(&CheckRow::new(answer, given.values, &row.case.asked()), None));
    Object::new()
        .with("layout", row.name.clone())
        .with("fingerprint", row.case.fingerprint().to_string())
        .with("inputs", inputs(&row.case))
        .with("field", given.values.map(objects::values))
        .with("ratios", ratios)
        .columns(&[utilisation, service], &given)
        .with("design", given.answer.map(|answer| design(&answer, &row.case.asked())))
        .maybe("verdict", question.asks().then(|| verdict::object(&row.case, &row.verdict)))
        .and(check.unwrap_or_default())
        .with("governing", c.governing.is_some_and(|g| g.row == index))
        .with("mark", mark(row))
        .columns(&[missing], &given)
        .with("warnings", objects::warnings(given.warnings))
}
