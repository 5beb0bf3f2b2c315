//! A comparison as CSV: one line a layout, in the order asked for.

use super::Compared;
use crate::case::Input;
use crate::show::columns::{self, CheckRow, OVER_LAB, PointRow, check_mean, check_more, point};
use crate::show::table::Table;
use crate::show::verdict;
use crate::study::compare::CompareRow;
use crate::words::Choice;

struct LayoutRow<'a> {
    row: &'a CompareRow,
    point: PointRow<'a>,
    governing: bool,
    check: Option<CheckRow<'a>>,
}

/// The layouts, with the checks where there are any.
pub(crate) fn report(compared: &Compared, order: &[usize]) -> String {
    let [force, deflection, utilisation, at_load, service, missing, warnings] = point();
    let start = Table::<LayoutRow>::new()
        .with("layout", |l| l.row.name.clone().into())
        .with("mesh", |l| l.row.case.mesh.id.clone().into());
    let table = Input::GEOMETRY
        .into_iter()
        .fold(start, |table, input| {
            let value = move |l: &LayoutRow| l.row.case.get(input);
            table.with(input.column(), move |l| value(l).map(|v| columns::input(input, v)).into())
        })
        .with("stagger", |l| l.row.case.layout.grid.stagger.into())
        .with("twists", |l| l.row.case.layout.grid.twists.word().into())
        .part([force, deflection], |l| Some(&l.point))
        .part(OVER_LAB, |l| l.row.forecast())
        .part([utilisation, at_load, service], |l| Some(&l.point))
        .with("governing", |l| l.governing.into())
        .part(verdict::COLUMNS, |l| Some(&l.row.verdict))
        .part([missing, warnings], |l| Some(&l.point))
        .when(compared.checked.is_some(), |table| {
            table.part(check_mean(), |l| l.check.as_ref()).part(check_more(), |l| l.check.as_ref())
        });
    table.csv(order.iter().map(|index| one(compared, *index)), ";")
}

fn one(compared: &Compared, index: usize) -> LayoutRow<'_> {
    let c = &compared.comparison;
    let row = &c.rows[index];
    let point = PointRow::from(row);
    let answer = compared.answer(index);
    LayoutRow {
        row,
        point,
        governing: c.governing.is_some_and(|g| g.row == index),
        check: answer.map(|a| CheckRow::new(a, point.values, &row.case.asked())),
    }
}
