//! The curves of a check as CSV: a header with the units, then one line a point. Runs count from 1.

use super::Checked;
use crate::curve::Point;
use crate::show::table::Table;
use crate::show::value::kn;

/// The table; several layouts share it, with the layout's name in front.
pub(crate) fn report(checked: &[Checked], several: bool) -> String {
    let table = Table::<(&Checked, usize, Point)>::new()
        .when(several, |table| table.with("layout", |row| row.0.name.clone().into()))
        .with("run", |row| row.1.into())
        .with("delta_m", |row| row.2.deflection.into())
        .with("F_kN", |row| kn(row.2.force));
    let rows = checked.iter().flat_map(|c| {
        let runs = c.ensemble.runs.iter().zip(1..);
        runs.flat_map(move |(run, k)| run.outcome.curve.points().map(move |p| (c, k, p)))
    });
    table.csv(rows, ";")
}
