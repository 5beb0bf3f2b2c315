//! Design solutions as CSV: one line a place, the ends of the range and every crossing, rising.

use super::{Solved, side};
use crate::show::columns::{PointRow, point};
use crate::show::table::Table;
use crate::study::solve::{Place, Solution};

/// A place in the range of what is solved for.
struct PlaceRow<'a> {
    name: Option<&'a str>,
    solution: &'a Solution,
    place: &'static str,
    value: f64,
    rounded: Option<f64>,
    met: &'static str,
    point: PointRow<'a>,
}

/// The places of all layouts; several layouts share one table with the layout's name in front.
pub(crate) fn report(solved: &[Solved], several: bool) -> String {
    let table = Table::<PlaceRow>::new()
        .when(several, |table| table.with("layout", |p| p.name.map(String::from).into()))
        .with("solve", |p| p.solution.input.word().into())
        .with("requirement", |p| p.solution.requirement.word().into())
        .with("place", |p| p.place.into())
        .with("value_m", |p| p.value.into())
        .with("rounded_m", |p| p.rounded.into())
        .with("met", |p| p.met.into())
        .part(point(), |p| Some(&p.point));
    let solutions = solved.iter().flat_map(|s| s.solutions.iter().map(move |found| (s, found)));
    table.csv(solutions.flat_map(|(s, found)| rows(s, found)), ";")
}

fn rows<'a>(s: &'a Solved, solution: &'a Solution) -> impl Iterator<Item = PlaceRow<'a>> {
    let name = s.name.as_deref();
    let end = move |place: &'static str, p: &'a Place| PlaceRow {
        name,
        solution,
        place,
        value: p.value,
        rounded: None,
        met: if p.met() { "yes" } else { "no" },
        point: PointRow::from(&p.outcome),
    };
    let [low, high] = &solution.ends;
    let crossings = solution.crossings.iter().map(move |c| PlaceRow {
        name,
        solution,
        place: c.kind.word(),
        value: c.value,
        rounded: c.rounded,
        met: side(c),
        point: PointRow::from(&c.point),
    });
    std::iter::once(end("low_end", low)).chain(crossings).chain([end("high_end", high)])
}
