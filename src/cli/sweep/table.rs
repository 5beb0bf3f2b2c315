//! The points of a sweep as rows of a table.

use super::Swept;
use crate::show::columns::{self, CheckRow, PointRow, check_mean, check_more, point};
use crate::show::{self, table::Table};
use crate::study::sweep::{SweepAxis, SweepGrid};
use crate::study::verdict::{Simulated, Verdict, verdict};

/// A point of a sweep.
pub(super) struct SweptPoint<'a> {
    name: Option<&'a str>,
    first: f64,
    second: Option<f64>,
    point: PointRow<'a>,
    /// Whether it is enough, by the forecast and by its check.
    verdict: Verdict,
    /// Its check, where checks are asked for.
    pub(super) check: Option<CheckRow<'a>>,
}

/// The points of a layout, along the first input, row after row.
pub(super) fn rows(s: &Swept) -> impl Iterator<Item = SweptPoint<'_>> {
    s.sweep.points.iter().enumerate().map(|(index, outcome)| {
        let (first, second) = s.sweep.grid.at(index);
        let point = PointRow::from(outcome);
        let answer = s.checked.as_ref().and_then(|answers| answers.get(index));
        let case = s.sweep.grid.case(&s.case, index);
        let check = answer.map(|a| CheckRow::new(a, point.values, &case.asked()));
        let simulated = answer.map_or(Simulated::Missing, Simulated::made);
        let verdict = verdict(&case, outcome, simulated, s.basis);
        SweptPoint { name: s.name.as_deref(), first, second, point, verdict, check }
    })
}

/// What is varied and what it gives.
pub(super) fn table<'a>(grid: &SweepGrid, named: bool) -> Table<'a, SweptPoint<'a>> {
    let [force, deflection, utilisation, _, service, missing, warnings] = point();
    let first = grid.first.input;
    let second = |table: Table<'a, SweptPoint<'a>>, axis: &SweepAxis| {
        let input = axis.input;
        table.with(input.column(), move |p| p.second.map(|v| columns::input(input, v)).into())
    };
    let name = |p: &SweptPoint| p.name.map(String::from).into();
    let table = Table::new().when(named, |table| table.with("layout", name));
    let table = table.with(first.column(), move |p| columns::input(first, p.first));
    let table = grid.second.iter().fold(table, second);
    let table = table.part([force, deflection, utilisation, service], |p| Some(&p.point));
    let table = table.part(show::verdict::COLUMNS, |p| Some(&p.verdict));
    table.part([missing, warnings], |p| Some(&p.point))
}

/// The same with the checks.
pub(super) fn with_checks<'a>(table: Table<'a, SweptPoint<'a>>) -> Table<'a, SweptPoint<'a>> {
    table.part(check_mean(), |p| p.check.as_ref()).part(check_more(), |p| p.check.as_ref())
}
