//! Checks as further columns of a study's CSV: SI with kN.

use crate::cli::output::cell;
use crate::forecast::Values;
use crate::forecast::design::Question;
use crate::study::checks::CheckAnswer;
use crate::study::checks::change::CheckChange;
use crate::study::checks::figures::Figures;
use crate::units::to_kn;

/// Names of the columns of [`cells`], each with a comma in front.
pub(crate) const COLUMNS: &str = ",F_dem_kN,delta_dem_m,utilisation_dem,F_dem_low_kN,F_dem_high_kN,delta_dem_low_m,delta_dem_high_m,F_dem_error_kN,delta_dem_error_m,difference_F_pct,difference_delta_pct,runs_dem,slipped_dem,dem_missing";

/// Names of the columns of [`change`], likewise.
pub(crate) const CHANGES: &str = ",change_F_dem_kN,change_delta_dem_m,change_utilisation_dem,change_F_dem_error_kN,change_delta_dem_error_m,change_utilisation_dem_error";

/// An answer beside a forecast, each field with a comma in front.
pub(crate) fn cells(answer: &CheckAnswer, forecast: Option<Values>, question: &Question) -> String {
    let result = answer.as_ref().ok();
    let f = result.map(|v| Figures::of(v, forecast, question));
    let mean = f.and_then(|f| f.mean);
    let error = f.and_then(|f| f.error);
    let [low, high] = split(f.and_then(|f| f.force_band));
    let [near, far] = split(f.and_then(|f| f.deflection_band));
    let difference = f.and_then(|f| f.difference);
    let count = |n: Option<usize>| n.map_or_else(String::new, |n| n.to_string());
    let fields = [
        cell(mean.map(|v| to_kn(v.force))),
        cell(mean.map(|v| v.deflection)),
        cell(f.and_then(|f| f.utilisation)),
        cell(low.map(to_kn)),
        cell(high.map(to_kn)),
        cell(near),
        cell(far),
        cell(error.map(|v| to_kn(v.force))),
        cell(error.map(|v| v.deflection)),
        cell(difference.map(|d| 100.0 * d.force)),
        cell(difference.map(|d| 100.0 * d.deflection)),
        count(result.map(|v| v.runs)),
        count(result.map(|v| v.slipped)),
        answer.as_ref().err().map_or("", |why| why.code()).to_string(),
    ];
    joined(&fields)
}

/// A change, likewise.
pub(crate) fn change(change: Option<&CheckChange>) -> String {
    let used = change.and_then(|c| c.utilisation);
    let fields = [
        cell(change.map(|c| to_kn(c.force.value))),
        cell(change.map(|c| c.deflection.value)),
        cell(used.map(|k| k.value)),
        cell(change.and_then(|c| c.force.error).map(to_kn)),
        cell(change.and_then(|c| c.deflection.error)),
        cell(used.and_then(|k| k.error)),
    ];
    joined(&fields)
}

fn split(band: Option<[f64; 2]>) -> [Option<f64>; 2] {
    band.map_or([None; 2], |band| band.map(Some))
}

fn joined(fields: &[String]) -> String {
    fields.iter().flat_map(|field| [",", field.as_str()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::checks::NoCheck;

    #[test]
    fn each_column_has_a_cell() {
        let none = cells(&Err(NoCheck::Laboratory), None, &Question::default());
        assert_eq!(none.matches(',').count(), COLUMNS.matches(',').count());
        assert!(none.ends_with(",laboratory"));
        assert_eq!(change(None).len(), CHANGES.matches(',').count());
    }
}
