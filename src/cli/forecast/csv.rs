//! Forecast curves as CSV: nothing but the table of [`crate::export::csv`], so that any reader of CSV
//! takes it; several layouts share one table with the layout's name in front.

use super::Answered;
use crate::export::csv::curves;
use crate::forecast::CURVE_POINTS;
use crate::forecast::warning::Warning;
use crate::remark::Weight;
use crate::units::Units;

/// The table, and a note for every layout that has no curve.
pub(crate) fn report(answered: &[Answered], several: bool) -> (String, Vec<String>) {
    let with_curve = answered.iter().filter_map(|a| {
        let name = a.name.as_deref().unwrap_or_default();
        Some((name, a.forecast.field.ok()?.end()?.curve(CURVE_POINTS)))
    });
    (curves(with_curve, several), answered.iter().filter_map(no_curve).collect())
}

/// Why a layout has no curve, if it has none.
fn no_curve(a: &Answered) -> Option<String> {
    if a.forecast.field.is_ok_and(|field| field.end().is_some()) {
        return None;
    }
    let name = a.name.as_ref().map_or(String::new(), |n| format!("layout {n:?}: "));
    let tells = |w: &&Warning| w.weight() == Weight::Outside || **w == Warning::StrengthOnly;
    let why = a.forecast.warnings.iter().find(tells);
    let why = why.map_or_else(|| "no field value".into(), |w| w.sentence(Units::METRES));
    Some(format!("{name}no curve; {why}"))
}
