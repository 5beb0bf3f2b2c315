//! CSV: a header whose names carry the units, then one line a point or a layout; names and units are
//! those of the JSON of `meshcast forecast`, lengths m, forces kN.

use super::ExportedLayout;
use super::check::current;
use crate::curve::{Curve, Point};
use crate::forecast::CURVE_POINTS;
use crate::show::layouts::{self, LayoutParts, LayoutRow};
use crate::show::table::Table;
use crate::show::value::kn;

/// Curves one below the other. Where `named`, the name of its layout stands before every point.
pub(crate) fn curves<'a>(
    curves: impl IntoIterator<Item = (&'a str, Curve)>,
    named: bool,
) -> String {
    let table = Table::<(&str, Point)>::new()
        .when(named, |table| table.with("layout", |row| row.0.to_string().into()))
        .with("delta_m", |row| row.1.deflection.into())
        .with("F_kN", |row| kn(row.1.force));
    let points = |(name, curve): (&'a str, Curve)| {
        curve.points().map(|point| (name, point)).collect::<Vec<_>>()
    };
    table.csv(curves.into_iter().flat_map(points), " ")
}

/// The forecast curves of cases; those without a field value have none.
pub fn case_curves(cases: &[ExportedLayout]) -> String {
    let curves_of = cases.iter().filter_map(|case| {
        Some((case.entry.name.as_str(), case.forecast().field.ok()?.end()?.curve(CURVE_POINTS)))
    });
    curves(curves_of, true)
}

/// All inputs and results, one line a layout. What does not apply is left empty.
pub fn table(cases: &[ExportedLayout]) -> String {
    let row = |case| LayoutParts::from(row(case));
    layouts::table().csv(cases.iter().map(row), " ")
}

fn row(exported: &ExportedLayout) -> LayoutRow<'_> {
    let entry = &exported.entry;
    LayoutRow {
        name: &entry.name,
        mesh: &entry.mesh,
        layout: &entry.layout,
        question: &entry.question,
        case: Some(&exported.case),
        derived: Some(&exported.derived),
        verdict: Some(&exported.verdict),
        check: entry.check.as_deref().map(|check| (check, !current(exported, check))),
    }
}
