//! A sweep: its ranges at the head, the forecast as a line with the checks' points and bands, and the
//! marked point in words. Maps are drawn by [`super::map`].

use super::super::text::{self, below, cut, heading, put, put_right, spot};
use super::super::theme::Theme;
use super::{map, nothing, plan, size, value};
use crate::app::App;
use crate::app::entry::Slot;
use crate::app::studies::sweep::SweepView;
use crate::case::{self, Input, input_unit, input_value};
use crate::show::effect;
use crate::show::grid::{DotPen, Pattern};
use crate::show::picture::Ink;
use crate::show::plot::Plot;
use crate::show::{say, verdict};
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::Effect;
use crate::units::{Units, percent};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;

/// Columns from which a table of all points stands beside the chart.
const WITH_TABLE: u16 = 100;
/// Columns of that table.
const TABLE: u16 = 51;

/// Draws the page.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let name = &app.layout().name;
    let Some(view) = app.sweep() else {
        heading(buf, area, &format!("sweep of {name}"), "", theme);
        nothing("the mesh of this layout is not known", area, buf, theme);
        return None;
    };
    let unit = app.units();
    let (symbol, symbol_unit) = (effect::symbol(view.shown), effect::unit(view.shown, unit));
    let title = format!("sweep of {name}: {symbol}, {symbol_unit}");
    heading(buf, area, &title, &value(view.shown, view.case.asked().force.is_some()), theme);
    let mut rest = below(area, 1);
    let mut place = None;
    for axis in 0..view.axes.len() {
        place = head(app, view, axis, rest, buf, theme).or(place);
        rest = below(rest, 1);
    }
    if let Some(problem) = view.problems.first() {
        nothing(&problem.to_string(), rest, buf, theme);
        return place;
    }
    let notes = notes(app, view, theme);
    // On a low screen the marked point is enough.
    let most = if rest.height < 12 { 1 } else { 3 };
    let foot = (notes.len() as u16).min(most).min(rest.height.saturating_sub(5));
    let body = Rect { height: rest.height - foot, ..rest };
    if view.axes.len() > 1 {
        map::draw(app, view, body, buf, theme);
    } else if area.width >= WITH_TABLE {
        let chart = Rect { width: body.width - TABLE - 1, ..body };
        line(app, view, chart, buf, theme);
        table(app, view, Rect { x: chart.right() + 1, width: TABLE, ..body }, buf, theme);
    } else {
        line(app, view, body, buf, theme);
    }
    let foot = Rect { y: body.bottom(), height: foot, ..rest };
    let columns = usize::from(foot.width.saturating_sub(2));
    for (row, (text, style)) in notes.iter().enumerate() {
        put(buf, foot, row as u16, 1, &cut(text, columns), *style);
    }
    place
}

/// One range: `>vary L from 1.25 to 4.50 m in 9 values`, the chosen part marked. Returns its place.
fn head(
    app: &App,
    view: &SweepView,
    axis: usize,
    row: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let range = view.axes.get(axis)?;
    let mut place = None;
    let unit = app.units();
    let (chosen, slot) = app.sweep_slot();
    let here = chosen == axis;
    let sign = if here { ">" } else { " " };
    let word = if axis == 0 { "vary" } else { "and" };
    let narrow = row.width < 60;
    let mut column = put(buf, row, 0, 0, &format!("{sign}{word:<5}"), theme.text);
    let value = |v: f64| input_value(range.input, v, unit);
    let parts = [
        (Slot::Input, "", range.input.symbol_in(&view.case.layout).to_string()),
        (Slot::From, if narrow { " " } else { "  from " }, value(range.from)),
        (Slot::To, " to ", value(range.to)),
        (Slot::Steps, if narrow { " in " } else { "  in " }, range.steps.to_string()),
    ];
    for (part, before, text) in parts {
        column = put(buf, row, 0, column, before, theme.text);
        let chosen = here && part == slot;
        if chosen {
            place = spot(buf, row, 0, column + 1);
        }
        let style = if chosen { theme.selected } else { theme.title };
        column = put(buf, row, 0, column, &format!("[{text}]"), style);
        if part == Slot::To {
            column = put(buf, row, 0, column + 1, input_unit(range.input, unit), theme.text);
        }
    }
    let outside = range
        .input
        .row()
        .published
        .is_some_and(|published| !published.holds(range.from) || !published.holds(range.to));
    if outside {
        put(buf, row, 0, column + 1, "! beyond the published range", theme.caution);
    } else if !narrow {
        put(buf, row, 0, column + 1, "values", theme.text);
    }
    place
}

/// The forecast as a line, the checks as points with their bands.
fn line(app: &App, view: &SweepView, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let (unit, shown) = (app.units(), view.shown);
    let Some(range) = view.axes.first() else { return };
    let across = |v: f64| case::shown(range.input, v, unit);
    let up = |v: f64| effect::in_unit(v, shown, unit);
    let forecast: Vec<(f64, f64)> = view
        .line
        .iter()
        .map(|(at, outcome)| {
            let y = outcome.as_ref().ok().and_then(|p| effect::read(p, shown));
            (across(*at), y.map_or(f64::NAN, up))
        })
        .collect();
    let columns: &[f64] = view.grid.as_ref().map_or(&[], |grid| &grid.columns);
    let checked: Vec<(f64, &Figures)> = columns
        .iter()
        .zip(&view.figures)
        .filter_map(|(at, figures)| Some((across(*at), figures.as_ref()?)))
        .collect();
    let found = |figures: &Figures| effect::found(figures, shown).map(up);
    let band = |figures: &Figures| effect::band(figures, shown).map(|ends| ends.map(up));
    let mut seen: Vec<f64> = forecast.iter().map(|p| p.1).filter(|y| y.is_finite()).collect();
    for (_, figures) in &checked {
        seen.extend(found(figures));
        seen.extend(band(figures).into_iter().flatten());
    }
    let ends = seen.iter().map(|y| (*y, *y)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let Some((least, most)) = ends else {
        return nothing(
            "no value anywhere in the range; below it is said why at the mark",
            area,
            buf,
            theme,
        );
    };
    // The limit of the utilisation stands on the chart where it is near.
    let limit = (shown == Effect::Utilisation).then_some(100.0).filter(|v| {
        let room = 0.5 * (most - least).max(1.0);
        (least - room..=most + room).contains(v)
    });
    let (least, most) = limit.map_or((least, most), |v: f64| (least.min(v), most.max(v)));
    let ends = (across(range.from), across(range.to));
    let Some(mut plot) = Plot::holding(size(area), ends, (least, most), theme.glyphs) else {
        return;
    };
    let mut lines = plot.grid();
    if let Some(limit) = limit {
        let pen = DotPen { ink: Ink::Design, pattern: Pattern::Dashed(2, 4), ascii: Some('-') };
        plot.curve([(ends.0, limit), (ends.1, limit)], pen, &mut lines);
    }
    let pen = DotPen { ink: Ink::Forecast, pattern: Pattern::Solid, ascii: None };
    plot.curve(forecast.iter().copied(), pen, &mut lines);
    plot.put(&lines);
    // The bands lie over the line: a character has one ink.
    let mut bands = plot.grid();
    let pen = DotPen { ink: Ink::Check, pattern: Pattern::Solid, ascii: Some(':') };
    for (x, figures) in &checked {
        if let Some([low, high]) = band(figures) {
            plot.curve([(*x, low), (*x, high)], pen, &mut bands);
        }
    }
    plot.put(&bands);
    for (x, figures) in &checked {
        if let Some(y) = found(figures) {
            plot.mark(*x, y, 'o', Ink::Check);
        }
    }
    let marked = columns.get(view.marked).zip(view.points.get(view.marked));
    if let Some((at, Ok(point))) = marked
        && let Some(y) = effect::read(point, shown)
    {
        plot.mark(across(*at), up(y), 'X', Ink::Forecast);
    }
    // Where the layout itself is.
    plot.mark_axis(across(range.input.value(&view.case)), '^', Ink::Title);
    text::draw(&plot.picture, area, buf, theme);
}

/// A point of the sweep in words.
fn place(view: &SweepView, unit: Units) -> String {
    let Some(grid) = &view.grid else { return String::new() };
    let (first, second) = grid.at(view.marked);
    let text = |input: Input, v: f64| {
        format!("{} {} {}", input.symbol(), input_value(input, v, unit), input_unit(input, unit))
    };
    match (&grid.second, second) {
        (Some(axis), Some(v))
            if input_unit(axis.input, unit) == input_unit(grid.first.input, unit) =>
        {
            let (symbol, at) =
                (grid.first.input.symbol(), input_value(grid.first.input, first, unit));
            format!("{symbol} {at}, {}", text(axis.input, v))
        }
        (Some(axis), Some(v)) => {
            format!("{}, {}", text(grid.first.input, first), text(axis.input, v))
        }
        _ => text(grid.first.input, first),
    }
}

fn notes(app: &App, view: &SweepView, theme: &Theme) -> Vec<(String, Style)> {
    let unit = app.units();
    let mut lines = Vec::new();
    let forecast = match view.points.get(view.marked) {
        Some(Ok(point)) => {
            let mark = if point.doubtful() { " !" } else { "" };
            let case = view.grid.as_ref().map(|grid| grid.case(&view.case, view.marked));
            let found = case.zip(view.points.get(view.marked));
            let found = found.and_then(|(case, outcome)| {
                verdict::of_outcome(&case, outcome, app.project().basis)
            });
            let found = found.map_or(String::new(), |found| format!(", {found}"));
            say::point(point, unit) + &found + mark
        }
        Some(Err(why)) => why.sentence(),
        None => String::new(),
    };
    lines.push((format!("X {}: {forecast}", place(view, unit)), theme.forecast));
    let check = match (view.figures.get(view.marked), view.answers.get(view.marked)) {
        (Some(Some(f)), _) => say::check(f, unit),
        (_, Some(Err(why))) if why.code() == "impossible" => format!("none: {}", why.sentence()),
        _ => String::new(),
    };
    let coverage = view.coverage;
    let count =
        format!("{} of {} checks, {}", coverage.have, coverage.of, plan(&app.study_wanted()));
    let (text, style) = match (&view.no_dem, coverage.stale, coverage.any()) {
        (Some(why), ..) => (format!("no DEM: {}", why.sentence()), theme.text),
        (None, true, false) => {
            ("DEM stale: of other inputs; c checks these, u undoes the edit".into(), theme.caution)
        }
        (None, _, true) if !check.is_empty() => (format!("o DEM {check}"), theme.check),
        (None, false, false) if app.campaign().is_none() => {
            ("DEM: not made; c checks every point".into(), theme.text)
        }
        _ => (format!("o DEM: {count}"), theme.check),
    };
    lines.push((text, style));
    if coverage.any() && !check.is_empty() {
        let own = if view.axes.len() == 1 { "; ^ as it is" } else { "" };
        lines.push((format!("  {count}; band 5 to 95 %{own}"), theme.text));
    }
    lines
}

/// All points as a table.
fn table(app: &App, view: &SweepView, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let unit = app.units();
    let Some(grid) = &view.grid else { return };
    let input = grid.first.input;
    let ends = [9, 16, 23, 29, 36, 44, 51];
    let write = |buf: &mut Buffer, row: u16, texts: [String; 7], style: Style| {
        for (end, text) in ends.into_iter().zip(texts) {
            put_right(buf, Rect { width: end, ..area }, row, &text, style);
        }
    };
    let words = [input.symbol(), "F_a", "delta", "use", "at F", "DEM F", "/F_a"].map(String::from);
    write(buf, 0, words, theme.heading);
    let (m, kn) = (unit.symbol(), unit.force_symbol());
    let units = [input_unit(input, unit), kn, m, "%", m, kn, "%"].map(String::from);
    write(buf, 1, units, theme.heading);
    let rows = usize::from(area.height.saturating_sub(2));
    let first = super::super::layouts::first_shown(view.marked, rows, view.points.len());
    for (line, index) in (first..view.points.len()).take(rows).enumerate() {
        let none = || "-".to_string();
        let (force, delta, used, service) = match &view.points[index] {
            Ok(p) => (
                unit.force_number(p.values().force, 3),
                effect::maybe_deflection(p.values().deflection, unit),
                p.utilisation().map_or_else(none, percent),
                p.service_deflection().map_or_else(none, |v| effect::deflection(v, unit)),
            ),
            Err(why) => (String::new(), why.short().to_string(), String::new(), String::new()),
        };
        let f = view.figures.get(index).and_then(|f| f.as_ref());
        let dem = f.and_then(|f| f.mean).map_or_else(none, |v| unit.force_number(v.force, 3));
        let over =
            f.and_then(|f| f.difference).map_or_else(none, |d| format!("{:+.1}", 100.0 * d.force));
        let at = input_value(input, grid.at(index).0, unit);
        let style = if index == view.marked { theme.selected } else { theme.text };
        write(buf, 2 + line as u16, [at, force, delta, used, service, dem, over], style);
    }
}
