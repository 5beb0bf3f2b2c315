//! The laboratory-to-field ratios.

use super::text::{below, heading, put, put_right};
use super::theme::Theme;
use crate::app::App;
use crate::units::{force_text, maybe_length_text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Draws the four ratios with their heading; with more rows the values they lead from and to.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    heading(buf, area, "laboratory to field", "", theme);
    let list = below(area, 1);
    let Some(forecast) = app.result().forecast() else { return };
    let ratio = |v: Option<f64>| v.map_or("-".to_string(), |v| format!("{v:.3}"));
    let mark = if forecast.ratios.default { "" } else { " own" };
    let mut rows = vec![
        ("alpha_F", format!("{:.3}{mark}", forecast.ratios.force)),
        ("alpha_delta", format!("{:.3}{mark}", forecast.ratios.deflection)),
        ("F_a/F_l*", ratio(forecast.force_over_lab())),
        ("delta_a/delta_l*", ratio(forecast.deflection_over_lab())),
    ];
    if list.height >= 8 {
        let m = |v: Option<f64>| maybe_length_text(v, app.units());
        rows.push(("F_l*", force_text(forecast.laboratory.force, app.units())));
        rows.push(("delta_l*", m(forecast.laboratory.deflection)));
        rows.push(("F_a*", force_text(forecast.reference.force, app.units())));
        rows.push(("delta_a*", m(forecast.reference.deflection)));
    }
    let e = &forecast.eccentricity;
    if list.height >= 10 {
        rows.push(("eccentricity, F", format!("{:.3} +-{:.3}", e.force, e.force_sd)));
        rows.push(("eccentricity, delta", format!("{:.3} +-{:.3}", e.deflection, e.deflection_sd)));
    }
    for (row, (name, value)) in rows.iter().enumerate() {
        put(buf, list, row as u16, 1, name, theme.text);
        let values = Rect { width: list.width.saturating_sub(1), ..list };
        put_right(buf, values, row as u16, value, theme.text);
    }
}
