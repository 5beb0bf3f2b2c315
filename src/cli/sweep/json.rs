//! A sweep as JSON: SI with kN, points along the first input, row after row.

use super::{Swept, table};
use crate::cli::output::{Fault, json_list};
use crate::cli::page::BASIS;
use crate::show::columns::input;
use crate::show::objects::{check, head, inputs, plan};
use crate::show::value::{Object, Value};
use crate::study::result::Wanted;
use crate::study::sweep::SweepAxis;

/// One object, or a list of them with one line each.
pub(crate) fn report(
    swept: &[Swept],
    wanted: Option<&Wanted>,
    several: bool,
) -> Result<String, Fault> {
    json_list(swept.iter().map(|s| one(s, wanted)), several)
}

fn one(s: &Swept, wanted: Option<&Wanted>) -> Object {
    let grid = &s.sweep.grid;
    let axis = |a: &SweepAxis| {
        Object::new()
            .with("input", a.input.word())
            .with("column", a.input.column())
            .with("from", input(a.input, a.from))
            .with("to", input(a.input, a.to))
            .with("steps", a.steps)
    };
    let columns = table::table(grid, false);
    let points = table::rows(s).map(|point| {
        let object = columns.object(&point);
        object
            .and(point.check.iter().fold(Object::new(), |object, row| object.and(check(row, None))))
    });
    // The inputs are those of the layout itself; each point replaces what is varied.
    head(s.name.as_deref(), grid.fingerprint(&s.case), inputs(&s.case))
        .with("vary", axis(&grid.first))
        .with("vary2", grid.second.as_ref().map(axis))
        .maybe("check_plan", wanted.map(plan))
        .with("points", points.collect::<Value>())
        .with("basis", BASIS)
}
