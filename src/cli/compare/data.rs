//! A comparison as JSON and CSV: SI with kN, in the order asked for.

use super::Compared;
use crate::cli::VERSION;
use crate::cli::dem::csv as dem_csv;
use crate::cli::dem::json::{CheckedJson, PlanJson};
use crate::cli::output::{Fault, cell, number, optional, quoted};
use crate::cli::page::BASIS;
use crate::cli::shapes::{Design, InputsJson, Pair, WarningJson, pair};
use crate::forecast::warning::Weight;
use crate::study::compare::CompareRow;
use crate::units::to_kn;
use serde::Serialize;
use std::fmt::Write;

#[derive(Serialize)]
struct Report<'a> {
    version: &'static str,
    fingerprint: String,
    governing: Option<GoverningJson<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    dem_plan: Option<PlanJson>,
    layouts: Vec<RowJson<'a>>,
    basis: &'static str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct GoverningJson<'a> {
    layout: &'a str,
    by: &'static str,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
    #[serde(serialize_with = "optional")]
    F_kN: Option<f64>,
}

#[derive(Serialize)]
struct RowJson<'a> {
    layout: &'a str,
    fingerprint: String,
    inputs: InputsJson<'a>,
    field: Option<Pair>,
    ratios: Option<RatiosJson>,
    #[serde(serialize_with = "optional")]
    utilisation: Option<f64>,
    design: Option<Design>,
    #[serde(flatten)]
    checked: Option<CheckedJson<'a>>,
    governing: bool,
    mark: &'static str,
    missing: Option<&'static str>,
    warnings: Vec<WarningJson>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct RatiosJson {
    #[serde(serialize_with = "number")]
    alpha_F: f64,
    #[serde(serialize_with = "number")]
    alpha_delta: f64,
    #[serde(serialize_with = "optional")]
    F_field_over_lab: Option<f64>,
    #[serde(serialize_with = "optional")]
    delta_field_over_lab: Option<f64>,
}

/// The mark of a row's warnings: `!` for what weighs more than a note.
pub(crate) fn mark(row: &CompareRow) -> &'static str {
    if row.weight() >= Some(Weight::Caution) { "!" } else { "" }
}

/// One object with a list of the layouts.
pub(crate) fn json(compared: &Compared, order: &[usize]) -> Result<String, Fault> {
    let c = &compared.comparison;
    let report = Report {
        version: VERSION,
        fingerprint: c.fingerprint().to_string(),
        governing: c.governing.map(|g| GoverningJson {
            layout: &c.rows[g.row].name,
            by: if g.utilisation.is_some() { "utilisation" } else { "F" },
            utilisation: g.utilisation,
            F_kN: c.rows[g.row].values().ok().map(|v| to_kn(v.force)),
        }),
        dem_plan: compared.checked.as_ref().map(|(wanted, _)| PlanJson::of(wanted)),
        layouts: order.iter().map(|i| row(compared, *i)).collect(),
        basis: BASIS,
    };
    Ok(crate::cli::output::json(&report)? + "\n")
}

fn row(compared: &Compared, index: usize) -> RowJson<'_> {
    let c = &compared.comparison;
    let row = &c.rows[index];
    let forecast = row.forecast.as_ref().ok();
    let values = row.values();
    RowJson {
        layout: &row.name,
        fingerprint: row.case.fingerprint().to_string(),
        inputs: InputsJson::of(&row.case.layout, &row.case.mesh, row.case.rule),
        field: values.as_ref().ok().map(|v| pair(*v)),
        ratios: forecast.map(|f| RatiosJson {
            alpha_F: f.ratios.force,
            alpha_delta: f.ratios.deflection,
            F_field_over_lab: f.force_over_lab(),
            delta_field_over_lab: f.deflection_over_lab(),
        }),
        utilisation: row.utilisation(),
        design: row.answer.map(|answer| Design::of(&answer, &row.case.question)),
        checked: compared.answer(index).map(|answer| {
            CheckedJson::of(answer, values.as_ref().ok().copied(), &row.case.question)
        }),
        governing: c.governing.is_some_and(|g| g.row == index),
        mark: mark(row),
        missing: values.err().map(|why| why.code()),
        warnings: forecast.map_or(Vec::new(), |f| f.warnings.iter().map(WarningJson::of).collect()),
    }
}

/// One line a layout.
pub(crate) fn csv(compared: &Compared, order: &[usize]) -> String {
    let c = &compared.comparison;
    let mut out = String::from(
        "layout,mesh,d_m,L_m,D_m,ex_m,ey_m,F_kN,delta_m,F_field_over_lab,delta_field_over_lab,utilisation,design_delta_m,governing,missing,warnings",
    );
    out.push_str(if compared.checked.is_some() { dem_csv::COLUMNS } else { "" });
    out.push('\n');
    for index in order {
        let row = &c.rows[*index];
        let (l, forecast, values) = (&row.case.layout, row.forecast.as_ref().ok(), row.values());
        let codes: Vec<&str> =
            forecast.iter().flat_map(|f| f.warnings.iter().map(|w| w.code())).collect();
        let value = values.as_ref().ok();
        let dem = compared.answer(*index).map_or(String::new(), |answer| {
            dem_csv::cells(answer, value.copied(), &row.case.question)
        });
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{dem}",
            quoted(&row.name),
            quoted(&row.case.mesh.id),
            cell(Some(l.plate)),
            cell(Some(l.spacing)),
            cell(Some(l.punch)),
            cell(Some(l.ex)),
            cell(Some(l.ey)),
            cell(value.map(|v| to_kn(v.force))),
            cell(value.map(|v| v.deflection)),
            cell(forecast.and_then(|f| f.force_over_lab())),
            cell(forecast.and_then(|f| f.deflection_over_lab())),
            cell(row.utilisation()),
            cell(row.answer.and_then(|a| a.at_force).and_then(|at| at.deflection)),
            c.governing.is_some_and(|g| g.row == *index),
            values.as_ref().err().map_or("", |why| why.code()),
            codes.join(";")
        );
    }
    out
}
