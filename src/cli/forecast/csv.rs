//! Forecast curves as CSV: nothing but the table of [`crate::export::csv`], so that any reader of CSV
//! takes it; several layouts share one table with the layout's name in front.

use super::Answered;
use crate::cli::output::Output;
use crate::export::csv::curves;
use crate::forecast::CURVE_POINTS;
use crate::remark::Weight;

/// The table, with a note for every layout that has no curve.
pub(crate) fn report(answered: &[Answered], several: bool) -> Output {
    let with_curve = answered.iter().filter_map(|a| {
        let name = a.name.as_deref().unwrap_or_default();
        Some((name, a.forecast.field.ok()?.curve(CURVE_POINTS)))
    });
    let result = curves(with_curve, several);
    let notes = answered.iter().filter(|a| a.forecast.field.is_err()).map(no_curve).collect();
    Output { result, notes, ..Output::default() }
}

fn no_curve(a: &Answered) -> String {
    let name = a.name.as_ref().map_or(String::new(), |n| format!("layout {n:?}: "));
    let why = a.forecast.warnings.iter().find(|w| w.weight() == Weight::Outside);
    format!(
        "{name}no curve; {}",
        why.map_or_else(|| "no field value".into(), crate::forecast::warning::Warning::sentence)
    )
}
