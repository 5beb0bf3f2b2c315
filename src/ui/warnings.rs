//! On wide screens: the warnings in whole sentences, and points of the curve.

use super::text::{below, heading, put};
use super::theme::Theme;
use crate::app::App;
use crate::units::length_text;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Draws the warnings, as many lines as fit.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    heading(buf, area, "to know", "", theme);
    let list = below(area, 1);
    let Some(forecast) = app.result().forecast() else { return };
    let columns = usize::from(list.width.saturating_sub(2)).max(10);
    let options = textwrap::Options::new(columns).subsequent_indent("  ");
    let mut texts: Vec<String> =
        forecast.warnings.iter().map(|w| format!("! {}", w.sentence(app.units()))).collect();
    if texts.is_empty() {
        texts.push("All inputs are inside the published ranges.".into());
    }
    texts.push("Lowest of the arrangements computed: a block in every cell; each anchor carries the force of its whole cell, more where blocks face each other. Published relations are for square grids.".into());
    let lines = texts.iter().flat_map(|t| textwrap::wrap(t, options.clone()));
    for (row, line) in lines.take(usize::from(list.height)).enumerate() {
        put(buf, list, row as u16, 1, &line, theme.text);
    }
}

/// Columns of the table along the curve.
pub(crate) const TABLE: u16 = 48;

/// Draws force, stiffness and energy at parts of the failure deflection.
pub(crate) fn curve_table(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    heading(buf, area, "along the curve", "", theme);
    let list = below(area, 1);
    let field = app.result().forecast().and_then(|f| f.field.ok());
    let Some(end) = field.and_then(|field| field.end()) else { return };
    let units = app.units();
    let force = format!("F {}", units.force_symbol());
    let header =
        format!("{:<8} {force:>6} {:>10} {:>10} {:>7}", "delta", "tangent", "secant", "energy");
    put(buf, list, 0, 1, &header, theme.heading);
    let (stiffness, energy) = (units.stiffness_symbol(), units.energy_symbol());
    let header = format!("{:<15} {stiffness:>10} {stiffness:>10} {energy:>7}", "");
    put(buf, list, 1, 1, &header, theme.heading);
    for (row, percent) in [25, 50, 75, 90, 100].into_iter().enumerate() {
        let delta = end.deflection * f64::from(percent) / 100.0;
        let text = format!(
            "{:<8} {:>6} {:>10} {:>10} {:>7}",
            length_text(delta, units),
            units.force_number(end.force_at(delta), 3),
            units.stiffness_number(end.tangent_at(delta)),
            units.stiffness_number(end.secant_at(delta)),
            units.energy_number(end.energy_to(delta)),
        );
        put(buf, list, row as u16 + 2, 1, &text, theme.text);
    }
}
