//! The curves of a check as CSV: a header with the units, then one line a point. Runs count from 1.

use super::Checked;
use crate::curve::Point;
use crate::show::table::Table;
use crate::show::value::{Value, kn};
use crate::units::to_kn;

/// The table; several layouts share it, with the layout's name in front.
pub(crate) fn report(checked: &[Checked], several: bool) -> String {
    let table = Table::<(&Checked, usize, Point)>::new()
        .when(several, |table| table.with("layout", |row| row.0.name.clone().into()))
        .with("run", |row| row.1.into())
        .with("delta_m", |row| row.2.deflection.into())
        .with("F_kN", |row| kn(row.2.force))
        .with("anchor_normal_kN", |row| anchor(row, 0))
        .with("anchor_in_plane_kN", |row| anchor(row, 1));
    let rows = checked.iter().flat_map(|c| {
        let runs = c.ensemble.runs.iter().zip(1..);
        runs.flat_map(move |(run, k)| run.outcome.curve.points().map(move |p| (c, k, p)))
    });
    table.csv(rows, ";")
}

/// A part of the force of the run's worst anchor at its first break, the same on all its lines.
fn anchor(row: &(&Checked, usize, Point), part: usize) -> Value {
    let worst = row.0.ensemble.runs.get(row.1 - 1).and_then(|run| run.outcome.worst_anchor());
    worst.map(|a| to_kn(a.parts()[part])).into()
}
