//! The chart: forecast curve with its failure point, overlays, laboratory test, design lines.

use super::check;
use super::curves::CurvePlot;
use super::text;
use super::theme::Theme;
use crate::app::App;
use crate::app::derived::LayoutResult;
use crate::axis::Axis;
use crate::curve::Point;
use crate::forecast::{Values, rescaled};
use crate::show::grid::{DotGrid, DotPen, Pattern};
use crate::show::picture::Ink;
use crate::show::plot::Plot;
use crate::units::{Units, force_text, length_text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Points a curve is drawn through.
const POINTS: usize = 101;
/// Columns left of the axis, for its labels.
const LABELS: u16 = 5;

/// Letters of overlaid layouts, in the order of the list.
pub(crate) fn overlay_letter(app: &App, index: usize) -> Option<char> {
    let layouts = &app.project().layouts;
    if !layouts.get(index)?.overlay {
        return None;
    }
    let before = layouts[..index].iter().filter(|l| l.overlay).count();
    ['A', 'B', 'C', 'D'].get(before).copied()
}

/// Draws the chart into an area: plot, axes and labels.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    if area.width < LABELS + 12 || area.height < 5 {
        return;
    }
    let Some(mut chart) = axes(app, area, theme) else { return };
    let mut grid = chart.plot.grid();
    let laboratory = app.result().forecast().and_then(|f| f.laboratory.both());
    if let Some(values) = laboratory {
        let pattern = Pattern::Dashed(1, 3);
        let pen = DotPen { ink: Ink::Laboratory, pattern, ascii: Some('.') };
        chart.curve(&rescaled(values, POINTS), pen, &mut grid);
    }
    design_lines(app, &chart, &mut grid);
    let overlays: Vec<(char, Values)> = overlays(app);
    for (k, (letter, values)) in overlays.iter().enumerate() {
        let (on, off) = [(6, 2), (3, 3), (8, 2), (2, 2)][k % 4];
        let ascii = Some(letter.to_ascii_lowercase());
        let pen = DotPen { ink: Ink::Overlay, pattern: Pattern::Dashed(on, off), ascii };
        chart.curve(&rescaled(*values, POINTS), pen, &mut grid);
    }
    check::curves(app, &chart, &mut grid);
    envelope(app, &chart, &mut grid);
    let field = field_values(app.result());
    if let Some(values) = field {
        let pen = DotPen { ink: Ink::Forecast, pattern: Pattern::Solid, ascii: None };
        chart.curve(&rescaled(values, POINTS), pen, &mut grid);
    }
    chart.plot.put(&grid);

    if let Some(values) = laboratory {
        laboratory_label(app, values, &mut chart, theme);
    }
    for (letter, values) in &overlays {
        chart.mark(end(values), *letter, Ink::Overlay);
    }
    check::marks(app, &mut chart);
    match field {
        Some(values) => {
            chart.mark(end(&values), 'X', Ink::Forecast);
        }
        None => {
            let row = chart.plot.size().1 / 2;
            let why = match app.result().forecast().map(|f| f.field) {
                Some(Ok(_)) => "no curve: the laboratory's deflection is missing".to_string(),
                Some(Err(why)) => format!("no value: {}", why.short()),
                None => "no value: ".to_string(),
            };
            chart.plot.text(row, 1, &why, Ink::Caution);
        }
    }
    text::draw(&chart.plot.picture, area, buf, theme);
}

/// Between which 90 % of the simulated curves lie, where a derived method is in use.
fn envelope(app: &App, chart: &CurvePlot, grid: &mut DotGrid) {
    let field = app.result().forecast().and_then(|f| f.field.ok());
    for curve in field.and_then(|field| field.envelope()).iter().flatten() {
        let pen = DotPen { ink: Ink::Forecast, pattern: Pattern::Dashed(1, 2), ascii: Some(',') };
        chart.curve(curve, pen, grid);
    }
}

/// Where a forecast's curve ends.
fn end(values: &Values) -> Point {
    Point { deflection: values.deflection, force: values.force }
}

/// F_a and delta_a of a layout's results.
fn field_values(result: &LayoutResult) -> Option<Values> {
    result.forecast().and_then(|f| f.field.ok()).and_then(|f| f.end())
}

/// The overlaid layouts but for the selected one, which is drawn anyway.
fn overlays(app: &App) -> Vec<(char, Values)> {
    (0..app.results().len())
        .filter(|i| *i != app.selected())
        .filter_map(|i| Some((overlay_letter(app, i)?, field_values(&app.results()[i])?)))
        .collect()
}

/// Axes that hold the forecast, the overlays and the design values. The laboratory force is far above
/// them; its curve runs out of the chart and a label says where to.
fn axes(app: &App, area: Rect, theme: &Theme) -> Option<CurvePlot> {
    let mut force: f64 = 0.0;
    let mut deflection: f64 = 0.0;
    let shown = overlays(app).into_iter().map(|o| o.1).chain(field_values(app.result()));
    for values in shown {
        force = force.max(values.force);
        deflection = deflection.max(values.deflection);
    }
    let checked = check::reach(app);
    force = force.max(checked.force);
    deflection = deflection.max(checked.deflection);
    if let Some(f) = app.result().forecast() {
        deflection = deflection.max(f.laboratory.deflection.unwrap_or(0.0));
        if force == 0.0 {
            force = f.laboratory.force;
        }
    }
    let asked = app.layout().asked();
    // A design value far beyond failure is named, not drawn: the curve must stay readable.
    let holding = |largest: f64, value: Option<f64>| match value {
        Some(v) if v < 1.6 * largest => largest.max(v),
        _ => largest,
    };
    let force = holding(force, asked.force.map(|f| f * asked.gamma_load));
    let deflection = holding(deflection, asked.deflection);
    let units = app.units();
    let (width, height) = (area.width - LABELS - 1, area.height - 2);
    let x = Axis::holding(deflection * units.per_metre(), u32::from(width / 10).clamp(2, 8));
    let y = Axis::holding(units.force(force) * 1.02, u32::from(height / 2).clamp(2, 8));
    let size = (usize::from(area.width), usize::from(area.height));
    let plot = Plot::new(size, usize::from(LABELS), x.into(), y.into(), theme.glyphs)?;
    Some(CurvePlot { plot, units })
}

/// Where the laboratory curve ends, or leaves the chart.
fn laboratory_label(app: &App, values: Values, chart: &mut CurvePlot, theme: &Theme) {
    let text = format!(
        "lab {} at {}",
        force_text(values.force, app.units()),
        length_text(values.deflection, app.units())
    );
    let inside = chart.mark(end(&values), 'l', Ink::Laboratory);
    let text = if inside { text } else { format!("{text} {}", theme.glyphs.up()) };
    chart.plot.text(0, 1, &text, Ink::Laboratory);
}

/// Design force across, allowable deflection upright, where they are set and on the chart.
fn design_lines(app: &App, chart: &CurvePlot, grid: &mut DotGrid) {
    let asked = app.layout().asked();
    let pen = |sign| DotPen { ink: Ink::Design, pattern: Pattern::Dashed(2, 4), ascii: Some(sign) };
    let end = chart.end();
    if let Some(load) = asked.force.map(|f| f * asked.gamma_load)
        && load <= end.force
    {
        let at = |deflection| Point { deflection, force: load };
        chart.line([at(0.0), at(end.deflection)], pen('-'), grid);
    }
    if let Some(deflection) = asked.deflection
        && deflection <= end.deflection
    {
        let at = |force| Point { deflection, force };
        chart.line([at(0.0), at(end.force)], pen(':'), grid);
    }
}

/// What a chart shows, with its units.
pub(super) fn axes_words(units: Units) -> String {
    format!("F ({}) over delta ({})", units.force_symbol(), units.symbol())
}

/// The axes and the design values in words, for the chart's heading.
pub(crate) fn caption(app: &App) -> String {
    let asked = app.layout().asked();
    let mut parts = vec![axes_words(app.units())];
    if let Some(f) = asked.force {
        parts.push(format!("design {}", app.units().force_number(f * asked.gamma_load, 3)));
    }
    if let Some(d) = asked.deflection {
        parts.push(format!("allowed {}", length_text(d, app.units())));
    }
    parts.join(", ")
}
