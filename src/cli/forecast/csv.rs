//! Forecast curves as CSV: a header with the units, then one line a point; nothing else, so that any
//! reader of CSV takes it. Several layouts share one table with the layout's name in front.

use super::Answered;
use crate::cli::output::{Output, quoted};
use crate::forecast::CURVE_POINTS;
use crate::forecast::warning::Weight;
use crate::units::{to_kn, without_noise};
use std::fmt::Write;

/// The table, with a note for every layout that has no curve.
pub fn report(answered: &[Answered], several: bool) -> Output {
    let mut result = String::new();
    let mut notes = Vec::new();
    result.push_str(if several { "layout,delta_m,F_kN\n" } else { "delta_m,F_kN\n" });
    for a in answered {
        let Some(field) = &a.forecast.field else {
            notes.push(no_curve(a));
            continue;
        };
        let name = match &a.case.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for point in field.curve(CURVE_POINTS).points() {
            let (delta, force) =
                (without_noise(point.deflection), without_noise(to_kn(point.force)));
            // Writing to a string cannot fail.
            let _ = writeln!(result, "{name}{delta},{force}");
        }
    }
    Output { result, notes, ..Output::default() }
}

fn no_curve(a: &Answered) -> String {
    let name = a.case.name.as_ref().map_or(String::new(), |n| format!("layout {n:?}: "));
    let why = a.forecast.warnings.iter().find(|w| w.weight() == Weight::Outside);
    format!("{name}no curve; {}", why.map_or_else(|| "no field value".into(), |w| w.message()))
}
