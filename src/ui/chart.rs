//! The chart: forecast curve with its failure point, overlays, laboratory test, design lines.

use super::canvas::{Canvas, DotPen, Pattern};
use super::check;
use super::text::{put, put_right, width};
use super::theme::Theme;
use crate::app::App;
use crate::app::derived::Derived;
use crate::axis::Axis;
use crate::curve::{Curve, Point};
use crate::forecast::{Values, rescaled};
use crate::units::{force_text, length_text, significant, to_kn};
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
    let plot = Rect {
        x: area.x + LABELS + 1,
        y: area.y,
        width: area.width - LABELS - 1,
        height: area.height - 2,
    };
    let scale = ChartScale::of(app, plot);
    axes(area, plot, &scale, buf, theme);

    let mut canvas = Canvas::new(plot, theme.glyphs);
    let laboratory = app.result().forecast().map(|f| f.laboratory);
    if let Some(values) = laboratory {
        let pen =
            DotPen { style: theme.laboratory, pattern: Pattern::Dashed(1, 3), ascii: Some('.') };
        canvas.line(scale.dots(&rescaled(values, POINTS), &canvas), pen);
    }
    design_lines(app, &scale, &mut canvas, theme);
    let overlays: Vec<(char, Values)> = overlays(app);
    for (k, (letter, values)) in overlays.iter().enumerate() {
        let pattern = [(6, 2), (3, 3), (8, 2), (2, 2)][k % 4];
        let pen = DotPen {
            style: theme.overlay,
            pattern: Pattern::Dashed(pattern.0, pattern.1),
            ascii: Some(letter.to_ascii_lowercase()),
        };
        canvas.line(scale.dots(&rescaled(*values, POINTS), &canvas), pen);
    }
    check::curves(app, &scale, &mut canvas, theme);
    let field = field_values(app.result());
    if let Some(values) = field {
        let pen = DotPen { style: theme.forecast, pattern: Pattern::Solid, ascii: None };
        canvas.line(scale.dots(&rescaled(values, POINTS), &canvas), pen);
    }
    canvas.show(buf);

    if let Some(values) = laboratory {
        laboratory_label(app, values, &scale, plot, buf, theme);
    }
    for (letter, values) in &overlays {
        mark(&letter.to_string(), *values, &scale, plot, buf, theme.overlay);
    }
    check::marks(app, &scale, plot, buf, theme);
    match field {
        Some(values) => mark("X", values, &scale, plot, buf, theme.forecast),
        None => {
            let text = "no field value: punch on a plate";
            put(buf, plot, plot.height / 2, 1, text, theme.caution);
        }
    }
}

/// F_a and delta_a of a layout's results.
fn field_values(result: &Derived) -> Option<Values> {
    result.forecast().and_then(|f| f.field).map(|f| f.values)
}

/// The overlaid layouts but for the selected one, which is drawn anyway.
fn overlays(app: &App) -> Vec<(char, Values)> {
    (0..app.results().len())
        .filter(|i| *i != app.selected())
        .filter_map(|i| Some((overlay_letter(app, i)?, field_values(&app.results()[i])?)))
        .collect()
}

/// The two axes, in the units shown.
pub(super) struct ChartScale {
    x: Axis,
    y: Axis,
    /// Units of length on the screen in a metre.
    per_metre: f64,
}

impl ChartScale {
    /// Axes that hold the forecast, the overlays and the design values. The laboratory force is far
    /// above them; its curve runs out of the chart and a label says where to.
    fn of(app: &App, plot: Rect) -> ChartScale {
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
            deflection = deflection.max(f.laboratory.deflection);
            if force == 0.0 {
                force = f.laboratory.force;
            }
        }
        let layout = app.layout();
        // A design value far beyond failure is named, not drawn: the curve must stay readable.
        let holding = |largest: f64, value: Option<f64>| match value {
            Some(v) if v < 1.6 * largest => largest.max(v),
            _ => largest,
        };
        let force = holding(force, layout.design_force.map(|f| f * layout.gamma_load));
        let deflection = holding(deflection, layout.allowable_deflection);
        let per_metre = app.units().per_metre();
        ChartScale {
            x: Axis::holding(deflection * per_metre, u32::from(plot.width / 10).clamp(2, 8)),
            y: Axis::holding(to_kn(force) * 1.02, u32::from(plot.height / 2).clamp(2, 8)),
            per_metre,
        }
    }

    fn part(&self, point: Point) -> (f64, f64) {
        (point.deflection * self.per_metre / self.x.end(), to_kn(point.force) / self.y.end())
    }

    /// A curve in dots of a canvas; points above the chart end it.
    pub(super) fn dots(&self, curve: &Curve, canvas: &Canvas) -> Vec<(f64, f64)> {
        curve.points().map(|p| self.dot(p, canvas)).take_while(|d| d.1 > -1.0).collect()
    }

    pub(super) fn dot(&self, point: Point, canvas: &Canvas) -> (f64, f64) {
        let (w, h) = canvas.dots();
        let (x, y) = self.part(point);
        (x * f64::from(w - 1) + 0.5, (1.0 - y) * f64::from(h - 1) + 0.5)
    }

    /// Column and row of a point in the plot, if it is inside.
    pub(super) fn cell(&self, point: Point, plot: Rect) -> Option<(u16, u16)> {
        let (x, y) = self.part(point);
        if !(0.0..=1.0).contains(&x) || !(0.0..=1.0).contains(&y) {
            return None;
        }
        let column = (x * f64::from(plot.width - 1)).round() as u16;
        let row = ((1.0 - y) * f64::from(plot.height - 1)).round() as u16;
        Some((column, row))
    }
}

fn axes(area: Rect, plot: Rect, scale: &ChartScale, buf: &mut Buffer, theme: &Theme) {
    for row in 0..plot.height {
        put(buf, area, row, LABELS, theme.upright(), theme.heading);
    }
    let rule = theme.rule().repeat(usize::from(plot.width));
    put(buf, area, plot.height, LABELS, &format!("{}{rule}", theme.corner()), theme.heading);
    for (value, label) in scale.y.ticks() {
        let row = ((1.0 - value / scale.y.end()) * f64::from(plot.height - 1)).round() as u16;
        // The zero stands at the corner, below the last row of the plot.
        let row = if value == 0.0 { plot.height } else { row };
        put_right(buf, Rect { width: LABELS - 1, ..area }, row, &label, theme.text);
    }
    let labels = plot.height + 1;
    for (value, label) in scale.x.ticks() {
        let column = (value / scale.x.end() * f64::from(plot.width - 1)).round() as u16;
        let start = column.saturating_sub(width(&label) / 2);
        let start = start.min(plot.width.saturating_sub(width(&label)));
        put(buf, area, labels, LABELS + 1 + start, &label, theme.text);
    }
}

/// A letter at a curve's end.
fn mark(
    sign: &str,
    values: Values,
    scale: &ChartScale,
    plot: Rect,
    buf: &mut Buffer,
    style: ratatui::style::Style,
) {
    let point = Point { deflection: values.deflection, force: values.force };
    if let Some((column, row)) = scale.cell(point, plot) {
        put(buf, plot, row, column, sign, style);
    }
}

/// Where the laboratory curve ends, or leaves the chart.
fn laboratory_label(
    app: &App,
    values: Values,
    scale: &ChartScale,
    plot: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) {
    let text = format!(
        "lab {} at {}",
        force_text(values.force),
        length_text(values.deflection, app.units())
    );
    let end = Point { deflection: values.deflection, force: values.force };
    match scale.cell(end, plot) {
        Some((column, row)) => {
            put(buf, plot, row, column, "l", theme.laboratory);
            put(buf, plot, 0, 1, &text, theme.laboratory);
        }
        None => {
            let arrow = if theme.glyphs == crate::app::look::Glyphs::Ascii { "^" } else { "↑" };
            put(buf, plot, 0, 1, &format!("{text} {arrow}"), theme.laboratory);
        }
    }
}

/// Design force across, allowable deflection upright, where they are set and on the chart.
fn design_lines(app: &App, scale: &ChartScale, canvas: &mut Canvas, theme: &Theme) {
    let layout = app.layout();
    let pen =
        |ascii| DotPen { style: theme.design, pattern: Pattern::Dashed(2, 4), ascii: Some(ascii) };
    let end_x = scale.x.end() / scale.per_metre;
    let end_y = scale.y.end() * 1000.0;
    if let Some(load) = layout.design_force.map(|f| f * layout.gamma_load)
        && load <= end_y
    {
        let at = |deflection| Point { deflection, force: load };
        let line = [scale.dot(at(0.0), canvas), scale.dot(at(end_x), canvas)];
        canvas.line(line, pen('-'));
    }
    if let Some(deflection) = layout.allowable_deflection
        && deflection <= end_x
    {
        let at = |force| Point { deflection, force };
        let line = [scale.dot(at(0.0), canvas), scale.dot(at(end_y), canvas)];
        canvas.line(line, pen(':'));
    }
}

/// The axes and the design values in words, for the chart's heading.
pub(crate) fn caption(app: &App) -> String {
    let layout = app.layout();
    let mut parts = vec![format!("F (kN) over delta ({})", app.units().symbol())];
    if let Some(f) = layout.design_force {
        parts.push(format!("design {}", significant(to_kn(f * layout.gamma_load), 3)));
    }
    if let Some(d) = layout.allowable_deflection {
        parts.push(format!("allowed {}", length_text(d, app.units())));
    }
    parts.join(", ")
}
