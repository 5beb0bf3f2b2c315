//! The tolerance of an input as lines, for texts and the screen.

use super::effect::maybe_deflection;
use super::verdict;
use crate::case::{CasePoint, input_unit, input_value};
use crate::study::tolerance::{Tolerance, TolerancePlace};
use crate::units::Units;

/// A line, and whether it is one that fails or has no value.
pub(crate) struct ToleranceLine {
    pub(crate) text: String,
    pub(crate) bad: bool,
}

/// What is off and by how much: `L 3.00 m, off by up to 0.10 m either way`.
pub(crate) fn title(t: &Tolerance, unit: Units) -> String {
    let value = |si| format!("{} {}", input_value(t.input, si, unit), input_unit(t.input, unit));
    let [_, planned, ..] = &t.places;
    format!("{} {}, by up to {} either way", t.input.symbol(), value(planned.value), value(t.off))
}

/// A head and a line a place.
pub(crate) fn lines(t: &Tolerance, unit: Units) -> Vec<ToleranceLine> {
    let symbol = format!("{}, {}", t.input.symbol(), input_unit(t.input, unit));
    let delta = format!("delta, {}", unit.symbol());
    let force = format!("F, {}", unit.force_symbol());
    let head = format!("{:<9}{symbol:>12}{force:>9}{:>9}{delta:>11}  verdict", "", "change");
    let mut lines = vec![ToleranceLine { text: head, bad: false }];
    for place in &t.places {
        let value = input_value(t.input, place.value, unit);
        let text = format!("{:<9}{value:>12}{}", place.word, rest(place, unit));
        let bad = place.outcome.is_err() || verdict::fails(&place.verdict);
        lines.push(ToleranceLine { text, bad });
    }
    lines
}

fn rest(place: &TolerancePlace, unit: Units) -> String {
    match &place.outcome {
        Ok(point) => {
            let change =
                place.change.map_or("-".into(), |c| format!("{:+.1} %", 100.0 * c.force_part));
            let force = unit.force_number(point.values().force, 3);
            let delta = maybe_deflection(point.values().deflection, unit);
            let jump =
                if place.change.is_some_and(|c| c.other_branch) { " (other branch)" } else { "" };
            let verdict = if asked(point) { verdict::short(&place.verdict) } else { String::new() };
            format!("{force:>9}{change:>9}{delta:>11}  {verdict}{jump}").trim_end().to_string()
        }
        Err(why) => format!("  {}", why.short()),
    }
}

fn asked(point: &CasePoint) -> bool {
    point.answer.at_force.is_some() || point.answer.at_deflection.is_some()
}
