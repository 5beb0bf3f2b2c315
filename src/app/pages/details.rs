//! The details: all warnings and numbers of the selected layout.

use super::text::{PageLine, TextPage};
use super::{check, method};
use crate::app::App;
use crate::case::Derived;
use crate::forecast::{Forecast, Strength, Values};
use crate::show::{say, verdict};
use crate::units::{
    Units, energy_text, force_text, length_text, maybe_length_text, percent, shortest,
};
use crate::words::Choice;

/// All there is to know of the selected layout.
pub(super) fn details(app: &App, width: usize) -> Vec<PageLine> {
    let mut page = TextPage::new(width);
    let layout = app.layout();
    page.heading(&format!("{} - {}", layout.name, app.project().name));
    if !layout.note.is_empty() {
        page.text(&format!("  {}", layout.note), 2);
    }
    match &app.result().derived {
        Err(problems) => {
            for p in problems {
                page.text(&format!("  {p}"), 4);
            }
        }
        Ok(Derived { forecast, .. }) => {
            judged(&mut page, app);
            page.heading("Warnings");
            if forecast.warnings.is_empty() {
                page.text("  none: all inputs are inside the published ranges", 2);
            }
            for w in &forecast.warnings {
                page.text(&format!("  ! {}", w.sentence(app.units())), 4);
            }
            check::section(&mut page, app);
            check::remade(&mut page, app);
            numbers(&mut page, app, forecast);
        }
    }
    page.heading("The method");
    method(&mut page);
    page.lines
}

/// Whether it is enough: each check, what to know beside it, and what would mend it.
fn judged(page: &mut TextPage, app: &App) {
    let result = app.result();
    let (Some(case), Some(v)) = (&result.case, result.verdict.as_ref()) else { return };
    page.heading(&format!("Verdict, by {} values (B changes that)", v.basis.word()));
    page.text(&format!("  {}", verdict::short(v)), 2);
    for line in verdict::lines(case, v, app.units()) {
        page.text(&format!("  {line}"), 4);
    }
}

fn numbers(page: &mut TextPage, app: &App, forecast: &Forecast) {
    let unit = app.units();
    let m = |v: f64| length_text(v, unit);
    if let Some(mesh) = &app.result().mesh() {
        page.heading("Mesh and laboratory");
        page.row("mesh", &format!("{} ({})", mesh.title(), mesh.id));
        let lab = &mesh.laboratory;
        page.row(
            "punch test",
            &format!(
                "{}, {} ({}), panel {}, punch {}",
                force_text(lab.force, unit),
                maybe_length_text(lab.deflection, unit),
                lab.statistic.word(),
                m(lab.panel),
                m(lab.punch)
            ),
        );
        if !lab.standard.is_empty() {
            page.row("standard", &lab.standard);
        }
        page.row("source", &lab.source);
    }
    page.row("F_l*, delta_l* (standard panel)", &pair(forecast.laboratory, unit));
    page.heading("Laboratory to field");
    let origin = if forecast.ratios.default { "double-twist reference" } else { "the mesh's own" };
    page.row(
        "alpha_F, alpha_delta",
        &format!("{:.3}, {:.3} ({origin})", forecast.ratios.force, forecast.ratios.deflection),
    );
    page.row("F_a*, delta_a* (step 1)", &pair(forecast.reference, unit));
    let e = &forecast.eccentricity;
    page.row(
        "eccentricity factors on F, delta",
        &format!(
            "{:.3} +-{:.3}, {:.3} +-{:.3}",
            e.force, e.force_sd, e.deflection, e.deflection_sd
        ),
    );
    let Ok(field) = forecast.field else { return };
    page.row("F_a, delta_a (step 2)", &pair(field.values, unit));
    match field.method {
        None => page.row(
            "branch of A.1-A.2",
            &format!("{} (rule: {})", field.branch.word(), forecast.rule.word()),
        ),
        Some(method) => page.row("method", &say::derived(method, &field, app.units())),
    }
    if let Some(published) = field.published {
        page.row("by the published method", &say::beside(published, field.values, unit));
    }
    if let Some(other) = field.other_branch {
        page.row("by the other branch", &pair(other, unit));
    }
    match (forecast.force_over_lab(), forecast.deflection_over_lab()) {
        (Some(f), Some(d)) => page.row("F_a/F_l*, delta_a/delta_l*", &format!("{f:.3}, {d:.3}")),
        (Some(f), None) => page.row("F_a/F_l*", &format!("{f:.3}")),
        _ => {}
    }
    let blocks = app.layout().layout;
    page.row("shape of the block in the check", blocks.shape.word());
    page.row("blocks of other cells", blocks.blocks.word());
    let (which, said) = say::anchors(&blocks, field.values.force, app.units());
    page.row(which, &said);
    if let Some(end) = field.end() {
        curve(page, &end, unit);
    }
    design(page, app, unit);
}

/// A few points of the curve, with stiffness and energy.
fn curve(page: &mut TextPage, end: &Values, unit: Units) {
    page.heading("Curve (Eq. 3)");
    let stiffness = unit.stiffness_symbol();
    page.text(
        &format!(
            "  part of delta_a  delta     {:<7} {:<13} {:<12} energy {}",
            format!("F {}", unit.force_symbol()),
            format!("tangent {stiffness}"),
            format!("secant {stiffness}"),
            unit.energy_symbol()
        ),
        2,
    );
    for percent in [25, 50, 75, 90, 100] {
        let delta = end.deflection * f64::from(percent) / 100.0;
        page.text(
            &format!(
                "  {percent:>8} %       {:<9} {:<7} {:<13} {:<12} {}",
                length_text(delta, unit),
                unit.force_number(end.force_at(delta), 3),
                unit.stiffness_number(end.tangent_at(delta)),
                unit.stiffness_number(end.secant_at(delta)),
                unit.energy_number(end.energy_to(delta)),
            ),
            2,
        );
    }
}

fn design(page: &mut TextPage, app: &App, unit: Units) {
    let layout = app.layout();
    let Some(answer) = app.result().answer() else { return };
    if answer.at_force.is_none() && answer.at_deflection.is_none() {
        return;
    }
    page.heading("Design");
    page.row(
        "partial factors",
        &format!(
            "load {}, resistance {}",
            shortest(layout.question.gamma_load),
            shortest(layout.question.gamma_resistance)
        ),
    );
    page.row("design resistance F_a / factor", &force_text(answer.resistance, unit));
    if let Some(a) = answer.at_force {
        page.row("design load F x factor", &force_text(a.load, unit));
        page.row("utilisation", &format!("{} %", percent(a.utilisation)));
        page.row("margin", &force_text(a.margin, unit));
        page.row(
            "deflection under it",
            &match (a.deflection, a.beyond_failure) {
                (Some(reached), _) => length_text(reached, unit),
                (None, true) => "beyond failure".into(),
                (None, false) => "-".into(),
            },
        );
        if let Some(reached) = a.service_deflection {
            page.row("deflection without the load factor", &length_text(reached, unit));
        }
    }
    if let Some(a) = answer.at_deflection {
        page.row("force at the allowed deflection", &force_text(a.force, unit));
        page.row("the same / resistance factor", &force_text(a.design_force, unit));
        page.row("energy up to there", &energy_text(a.energy, unit));
        if a.beyond_failure {
            page.text("  the panel fails before the allowed deflection is reached", 2);
        }
    }
}

fn pair(values: Strength, unit: Units) -> String {
    format!("{}, {}", force_text(values.force, unit), maybe_length_text(values.deflection, unit))
}
