//! All layouts in a table that can be sorted, and their curves in one chart.

use super::super::answer;
use super::super::layouts::first_shown;
use super::super::text::{self, below, cut, heading, put, put_right, spot, width};
use super::super::theme::Theme;
use super::size;
use crate::app::App;
use crate::app::studies::compare::{ColumnHead, CompareView};
use crate::forecast::rescaled;
use crate::remark::Weight;
use crate::show::comparison;
use crate::show::effect;
use crate::show::grid::{DotPen, Pattern};
use crate::show::names::shortened;
use crate::show::picture::Ink;
use crate::show::plot::{self, Plot};
use crate::study::compare::{Column, CompareRow};
use crate::study::sensitivity::Effect;
use crate::study::verdict::Finding;
use crate::units::{Units, percent};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Curves that can be told apart in one chart, the marked one included.
const CURVES: usize = 6;
/// Columns below which the answers stand before the inputs.
const NARROW: u16 = 60;
/// Points a curve is drawn through.
const POINTS: usize = 61;

/// Draws the page: table above, curves below, or beside each other where there is room.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let view = app.comparison()?;
    let title = match app.comparison_sort() {
        Some((head, falling)) => {
            format!("compare: by {}, {}", title(head, app.units()).0, way(falling))
        }
        None => "compare: in the project's order".to_string(),
    };
    let right = format!("{} layouts", app.project().layouts.len());
    heading(buf, area, &title, &right, theme);
    let rest = below(area, 1);
    let rows = view.order.len() as u16;
    // Two lines of head, one of what governs; the chart gets what is left, or nothing.
    let wanted = rows + 3;
    let chart = rest.height.saturating_sub(wanted).max(rest.height / 2);
    let chart = if rest.height >= 16 { chart.min(rest.height - 7) } else { 0 };
    let table_area = Rect { height: rest.height - chart, ..rest };
    let place = table(app, view, table_area, buf, theme);
    let lower = below(rest, table_area.height);
    if lower.height > plot::SMALLEST.1 as u16 {
        let words = super::super::chart::axes_words(app.units());
        heading(buf, lower, &words, &legend(view), theme);
        curves(app, view, below(lower, 1), buf, theme);
    }
    place
}

fn way(falling: bool) -> &'static str {
    if falling { "falling" } else { "rising" }
}

/// Word and unit of a column.
fn title(head: ColumnHead, unit: Units) -> (&'static str, &'static str) {
    let m = unit.symbol();
    match head {
        ColumnHead::Of(column) => comparison::head(column, unit),
        ColumnHead::DemForce => ("DEM F", unit.force_symbol()),
        ColumnHead::DemOverForce => ("/F_a", "%"),
        ColumnHead::DemDeflection => ("DEM d", m),
        ColumnHead::DemOverDeflection => ("/d_a", "%"),
        ColumnHead::DemUtilisation => ("DEM u", "%"),
    }
}

fn columns_of(head: ColumnHead) -> u16 {
    match head {
        // A few characters.
        ColumnHead::Of(column) => comparison::width(column) as u16,
        ColumnHead::DemForce | ColumnHead::DemDeflection => 7,
        _ => 6,
    }
}

/// What stands in a cell.
fn cell(view: &CompareView, row: usize, head: ColumnHead, unit: Units) -> String {
    let Some(r) = view.comparison.rows.get(row) else { return String::new() };
    let none = || "-".to_string();
    let checked = view.checked.get(row).and_then(|c| c.as_ref());
    match head {
        ColumnHead::Of(column) => comparison::cell(r, column, unit),
        ColumnHead::DemForce => match (checked, view.number(row, head)) {
            (None, _) => none(),
            (Some(_), None) => "none".into(),
            (Some(c), Some(v)) => {
                let mark = match (c.stale, c.partial) {
                    (true, _) => "s",
                    (false, true) => "p",
                    _ => "",
                };
                effect::number(v, Effect::Force, unit) + mark
            }
        },
        ColumnHead::DemDeflection => {
            view.number(row, head).map_or_else(none, |v| effect::deflection(v, unit))
        }
        ColumnHead::DemUtilisation => view.number(row, head).map_or_else(none, percent),
        ColumnHead::DemOverForce | ColumnHead::DemOverDeflection => match checked {
            Some(c) if c.stale => "stale".into(),
            _ => comparison::over(view.number(row, head)),
        },
    }
}

/// Draws the table. Returns the place of the marked layout.
fn table(
    app: &App,
    view: &CompareView,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let unit = app.units();
    let sort = app.comparison_sort();
    let mut heads = ColumnHead::ALL[1..].to_vec();
    if area.width < NARROW {
        // Where a few columns fit, the answers come before the inputs.
        heads.rotate_left(5);
    }
    let name = name_columns(view, &heads, area.width);
    // As many columns behind the name as fit.
    let mut shown: Vec<(ColumnHead, u16)> = Vec::new();
    let mut end = 4 + name;
    for head in heads.iter().skip(app.comparison_first()) {
        end += columns_of(*head);
        if end > area.width {
            break;
        }
        shown.push((*head, end));
    }
    let head_style = |head: ColumnHead| match sort {
        Some((by, _)) if by == head => theme.selected,
        _ => theme.heading,
    };
    put(buf, area, 0, 4, "layout", head_style(ColumnHead::Of(Column::Name)));
    for (head, end) in &shown {
        let (word, symbol) = title(*head, unit);
        let part = Rect { width: *end, ..area };
        put_right(buf, part, 0, word, head_style(*head));
        put_right(buf, part, 1, symbol, theme.heading);
    }
    if app.comparison_first() > 0 {
        put(buf, area, 1, 4, "<- more", theme.heading);
    }
    if app.comparison_first() + shown.len() < heads.len() {
        put(buf, area, 1, 4 + name.saturating_sub(2), "->", theme.heading);
    }
    let list = Rect { height: area.height.saturating_sub(3), ..below(area, 2) };
    let rows = usize::from(list.height);
    let marked = app.comparison_marked();
    let at = view.order.iter().position(|row| view.layouts.get(*row) == Some(&marked));
    let first = first_shown(at.unwrap_or(0), rows, view.order.len());
    let place = spot(buf, list, at.unwrap_or(0).saturating_sub(first) as u16, 0);
    let names: Vec<&str> = view.comparison.rows.iter().map(|r| r.name.as_str()).collect();
    let names = shortened(&names, usize::from(name) - 1);
    for (line, row) in view.order.iter().skip(first).take(rows).enumerate() {
        let line = line as u16;
        let here = view.layouts.get(*row) == Some(&marked);
        let governs = view.comparison.governing.is_some_and(|g| g.row == *row);
        let style = if here { theme.selected } else { theme.text };
        if here {
            put(buf, list, line, 0, &" ".repeat(usize::from(list.width)), style);
        }
        let sign = if here { ">" } else { " " };
        let letter = view.letter(*row).unwrap_or(' ');
        let star = if governs { '*' } else { ' ' };
        let compared = view.comparison.rows.get(*row);
        let finding = compared.map_or(Finding::NotAsked, |r| r.verdict.finding());
        put(buf, list, line, 0, &format!("{sign}{letter}{star}"), style);
        let marked = if here { style } else { answer::style(finding, theme) };
        put(buf, list, line, 3, &finding.mark().to_string(), marked);
        put(buf, list, line, 4, names.get(*row).map_or("", String::as_str), style);
        let doubt = compared.and_then(CompareRow::weight);
        if doubt >= Some(Weight::Caution) {
            put(buf, list, line, 3 + name, "!", if here { style } else { theme.caution });
        }
        for (head, end) in &shown {
            let room = usize::from(columns_of(*head)) - 1;
            let text = cut(&cell(view, *row, *head, unit), room);
            put_right(buf, Rect { width: *end, ..list }, line, &text, style);
        }
    }
    let foot = Rect { y: list.bottom(), height: 1.min(area.height), ..area };
    let hidden = view.order.len().saturating_sub(rows);
    let more = if hidden > 0 { format!(" {hidden} more ") } else { String::new() };
    let room = usize::from(area.width.saturating_sub(width(&more) + 1));
    let mixed =
        if view.comparison.mixed().is_some() { "! not of one kind or standard; " } else { "" };
    put(
        buf,
        foot,
        0,
        1,
        &cut(&format!("{mixed}{}", governing(view, app.units(), room)), room),
        theme.title,
    );
    put_right(buf, foot, 0, &more, theme.heading);
    place
}

/// Columns for the names: as wide as the longest, where the columns up to the use still fit, and where
/// all fit the rest too.
fn name_columns(view: &CompareView, heads: &[ColumnHead], all: u16) -> u16 {
    let longest = view.comparison.rows.iter().map(|r| width(&r.name)).max().unwrap_or(0);
    let upto = |last: usize| heads.iter().take(last).map(|head| columns_of(*head)).sum::<u16>();
    let used = heads.iter().position(|head| *head == ColumnHead::Of(Column::Use));
    let room = all.saturating_sub(4 + upto(used.map_or(0, |at| at + 1)));
    // One column for the sign of a doubt behind the name.
    (longest + 1).clamp(10, room.max(10))
}

/// Which layout governs, by what, and how many fail, in so many columns; of all that the name is cut.
fn governing(view: &CompareView, units: Units, columns: usize) -> String {
    let c = &view.comparison;
    let left = match view.unknown {
        0 => String::new(),
        n => format!("; {n} left out, mesh not known"),
    };
    let stale = view.checked.iter().flatten().any(|c| c.stale);
    let stale = if stale { "; s: stale check" } else { "" };
    let fail = c.rows.iter().filter(|row| row.verdict.finding() == Finding::Fails).count();
    let fail = match fail {
        0 => String::new(),
        n => format!("; {n} of {} fail", c.rows.len()),
    };
    let (name, why) = comparison::governing(c, units);
    let colon = if name.is_some() { " " } else { ": " };
    let rest = format!("{why}{fail}{stale}{left}");
    let word = if columns < usize::from(NARROW) { "" } else { "governing" };
    let head = format!("* {word}{colon}").replace("  ", " ");
    let room = columns.saturating_sub(head.len() + usize::from(width(&rest)) + 2);
    let names: Vec<&str> = c.rows.iter().map(|r| r.name.as_str()).collect();
    let short = shortened(&names, room.max(8));
    let governs = c.governing.filter(|_| name.is_some()).and_then(|g| short.get(g.row));
    let name = governs.map_or(String::new(), |name| format!("{name}: "));
    cut(&format!("{head}{name}{rest}"), columns)
}

/// The rows whose curves are drawn: the marked one and the first of the others.
fn drawn(app: &App, view: &CompareView) -> Vec<usize> {
    let marked = |row: &usize| view.layouts.get(*row) == Some(&app.comparison_marked());
    let has = |row: &usize| view.comparison.rows.get(*row).is_some_and(|r| r.values().is_ok());
    let others = view.order.iter().filter(|r| !marked(r) && has(r)).take(CURVES - 1);
    let mut all: Vec<usize> = others.copied().collect();
    all.extend(view.order.iter().filter(|r| marked(r) && has(r)));
    all
}

fn legend(view: &CompareView) -> String {
    let count = view.comparison.rows.iter().filter(|r| r.values().is_ok()).count();
    match count {
        0 => "no layout has a value".into(),
        n if n > CURVES => format!("letters as above; {CURVES} of {n} curves"),
        _ => "letters as above".into(),
    }
}

fn curves(app: &App, view: &CompareView, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let units = app.units();
    let rows = drawn(app, view);
    let values: Vec<_> = rows
        .iter()
        .filter_map(|row| Some((*row, view.comparison.rows.get(*row)?.values().ok()?.both()?)))
        .collect();
    let largest = |read: fn(&crate::forecast::Values) -> f64| {
        values.iter().map(|(_, v)| read(v)).fold(0.0, f64::max)
    };
    if values.is_empty() {
        return;
    }
    let x = (0.0, largest(|v| v.deflection) * units.per_metre());
    let y = (0.0, units.force(largest(|v| v.force)));
    let Some(mut plot) = Plot::holding(size(area), x, y, theme.glyphs) else { return };
    let mut grid = plot.grid();
    let marked = |row: usize| view.layouts.get(row) == Some(&app.comparison_marked());
    for (place, (row, v)) in values.iter().enumerate() {
        let (on, off) = [(6, 2), (3, 3), (8, 2), (2, 2), (5, 4)][place % 5];
        let ascii = view.letter(*row).unwrap_or('?').to_ascii_lowercase();
        let pen = if marked(*row) {
            DotPen { ink: Ink::Forecast, pattern: Pattern::Solid, ascii: None }
        } else {
            let pattern = Pattern::Dashed(on, off);
            DotPen { ink: Ink::Overlay, pattern, ascii: Some(ascii) }
        };
        let curve = rescaled(*v, POINTS);
        let points =
            curve.points().map(|p| (p.deflection * units.per_metre(), units.force(p.force)));
        plot.curve(points, pen, &mut grid);
    }
    plot.put(&grid);
    for (row, v) in &values {
        let ink = if marked(*row) { Ink::Forecast } else { Ink::Overlay };
        let letter = view.letter(*row).unwrap_or('?');
        plot.mark(v.deflection * units.per_metre(), units.force(v.force), letter, ink);
    }
    text::draw(&plot.picture, area, buf, theme);
}
