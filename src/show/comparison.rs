//! The table of a comparison: what its columns are called and what stands in them, for people.

use super::effect::{deflection, maybe_deflection, number};
use super::verdict;
use crate::study::compare::{Column, CompareRow, Comparison};
use crate::study::sensitivity::Effect;
use crate::units::{Units, force_text, percent};

/// Word and unit of a column.
pub(crate) fn head(column: Column, unit: Units) -> (&'static str, &'static str) {
    match column {
        Column::Name => ("layout", ""),
        Column::Mesh => ("mesh", ""),
        Column::Size(input) => (input.word(), input.unit(unit)),
        Column::Force => ("F_a", unit.force_symbol()),
        Column::Deflection => ("delta", unit.symbol()),
        Column::ForceRatio => ("F/Fl", ""),
        Column::DeflectionRatio => ("d/dl", ""),
        Column::Utilisation => ("F use", "%"),
        Column::Use => ("use", "%"),
        Column::DesignDeflection => ("at Fd", unit.symbol()),
        Column::ServiceDeflection => ("at F", unit.symbol()),
        Column::Warnings => ("warn", ""),
    }
}

/// Characters of a column, with a blank in front; names have what is left.
pub(crate) fn width(column: Column) -> usize {
    match column {
        Column::Mesh => 18,
        Column::Force | Column::Deflection => 7,
        _ => 6,
    }
}

/// What stands in a cell.
pub(crate) fn cell(row: &CompareRow, column: Column, unit: Units) -> String {
    let none = || "-".to_string();
    let size = |v: f64| unit.size_number(v);
    let ratio = |v: Option<f64>| v.map_or_else(none, |v| format!("{v:.3}"));
    let forecast = row.forecast();
    match column {
        Column::Name => row.name.clone(),
        Column::Mesh => row.case.mesh.id.clone(),
        Column::Size(input) => size(input.value(&row.case)),
        Column::Force => match row.values() {
            Ok(v) => number(v.force, Effect::Force, unit),
            Err(why) => why.short().into(),
        },
        Column::Deflection => maybe_deflection(row.values().ok().and_then(|v| v.deflection), unit),
        Column::ForceRatio => {
            ratio(forecast.and_then(super::super::forecast::Forecast::force_over_lab))
        }
        Column::DeflectionRatio => {
            ratio(forecast.and_then(super::super::forecast::Forecast::deflection_over_lab))
        }
        Column::Utilisation => row.utilisation().map_or_else(none, percent),
        Column::Use => verdict::usage(&row.verdict),
        Column::DesignDeflection => {
            let at = row.at_force().and_then(|a| a.deflection);
            at.map_or_else(none, |v| deflection(v, unit))
        }
        Column::ServiceDeflection => {
            let at = row.at_force().and_then(|a| a.service_deflection);
            at.map_or_else(none, |v| deflection(v, unit))
        }
        Column::Warnings => row.weight().map_or_else(none, |w| w.word().into()),
    }
}

/// How far a check is from the forecast, %.
pub(crate) fn over(part: Option<f64>) -> String {
    part.map_or_else(|| "-".to_string(), |v| format!("{:+.1}", 100.0 * v))
}

/// Which layout governs, and by what; without a final stop.
pub(crate) fn governing(c: &Comparison, unit: Units) -> (Option<&str>, String) {
    let Some((g, row)) = c.governing.and_then(|g| Some((g, c.rows.get(g.row)?))) else {
        return (None, "none, no layout has a value".to_string());
    };
    let why = match (g.by, row.values()) {
        (Some(_), _) => verdict::short(&row.verdict),
        (None, Ok(v)) => {
            format!("the lowest force, {}; no layout has a load", force_text(v.force, unit))
        }
        (None, Err(_)) => String::new(),
    };
    (Some(&row.name), why)
}
