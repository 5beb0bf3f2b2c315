//! The inputs of the selected layout with units, marks and ranges; the one being typed in place.

use super::layouts::first_shown;
use super::text::{below, heading, put, put_right, spot};
use super::theme::Theme;
use crate::app::entry::{EditTarget, LineEntry};
use crate::app::{App, Mode};
use crate::case::Input;
use crate::units::length_entry;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Columns from which a range fits beside each value.
const WITH_RANGES: u16 = 38;

/// Draws the inputs with their heading; the last row is the range of the selected one. Returns the
/// place of the selected value, or of the cursor in what is typed.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    heading(buf, area, "inputs", "", theme);
    draw_rows(app, below(area, 1), buf, theme)
}

/// The same without the heading, for small screens.
pub(crate) fn draw_rows(
    app: &App,
    list: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let mut place = None;
    let rows = usize::from(list.height.saturating_sub(1));
    let inputs = Input::of_layout(&app.layout().layout);
    let at = inputs.iter().position(|f| *f == app.field()).unwrap_or(0);
    let first = first_shown(at, rows, inputs.len());
    for (row, field) in inputs[first..].iter().take(rows).enumerate() {
        let here = line(app, *field, list, row as u16, buf, theme);
        if *field == app.field() {
            place = here;
        }
    }
    let range = range_line(app);
    put(buf, list, list.height.saturating_sub(1), 0, &range, theme.heading);
    place
}

/// One input: `>L  spacing     3.00 m`. Returns where its value begins, or the cursor in it.
fn line(
    app: &App,
    field: Input,
    list: Rect,
    row: u16,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let selected = field == app.field();
    let unit = field.unit(app.units());
    let value = app.layout().get(field);
    let sign = if selected { ">" } else { " " };
    let style = if selected { theme.title } else { theme.text };
    put(
        buf,
        list,
        row,
        0,
        &format!("{sign}{:<2} {}", field.word_in(&app.layout().layout), field.row().label),
        style,
    );

    let column = 13.min(list.width);
    let typed = match app.mode() {
        Mode::Entry(entry) if selected && entry.target == EditTarget::Value(field) => Some(entry),
        _ => None,
    };
    if let Some(entry) = typed {
        return typing(entry, list, row, column, buf, theme);
    }
    let text = value.map_or("-".to_string(), |v| field.entry_text(v, app.units()));
    let outside = value.is_some_and(|v| field.row().published.is_some_and(|range| !range.holds(v)));
    let shown = format!("{text:>8}");
    let end =
        put(buf, list, row, column, &shown, if selected { theme.selected } else { theme.text });
    put(buf, list, row, end + 1, unit, theme.text);
    if outside {
        put(buf, list, row, end + 3, "!", theme.caution);
    }
    if list.width >= WITH_RANGES {
        put_right(buf, list, row, &short_range(app, field), theme.heading);
    }
    let blank = shown.len() - shown.trim_start().len();
    spot(buf, list, row, column + blank as u16)
}

/// The text being typed, with its cursor.
fn typing(
    entry: &LineEntry,
    list: Rect,
    row: u16,
    column: u16,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let room = usize::from(list.width.saturating_sub(column)).max(4);
    typed_text(
        entry,
        Rect { x: list.x + column, y: list.y + row, width: room as u16, height: 1 },
        buf,
        theme,
    )
}

/// A line of typed text with its cursor in a row of the screen; long text scrolls with the cursor, whose
/// place is returned.
pub(crate) fn typed_text(
    entry: &LineEntry,
    row: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let room = usize::from(row.width);
    let chars: Vec<char> = entry.text().chars().collect();
    let cursor = entry.cursor().min(chars.len());
    let first = (cursor + 1).saturating_sub(room);
    let blank = " ".repeat(room);
    let style = theme.text.add_modifier(ratatui::style::Modifier::UNDERLINED);
    put(buf, row, 0, 0, &blank, style);
    let (mut column, mut at) = (0, 0);
    for (i, c) in chars.iter().enumerate().skip(first) {
        if i == cursor {
            at = column;
        }
        let style = if i == cursor { theme.selected } else { style };
        column = put(buf, row, 0, column, &c.to_string(), style);
    }
    if cursor == chars.len() {
        at = column;
        put(buf, row, 0, column, " ", theme.selected);
    }
    spot(buf, row, 0, at)
}

/// The published range of an input as `0.16-0.48`, or the cell for an offset.
fn short_range(app: &App, field: Input) -> String {
    let m = |v: f64| length_entry(v, app.units());
    match (field.row().published, field) {
        (Some(range), _) => format!("{}..{}", m(range.min), m(range.max)),
        (None, Input::OffsetX) => format!("+-{}", m(app.layout().layout.sides()[0] / 2.0)),
        (None, Input::OffsetY) => format!("+-{}", m(app.layout().layout.sides()[1] / 2.0)),
        _ => String::new(),
    }
}

/// The range of the selected input in words.
pub(crate) fn range_line(app: &App) -> String {
    let field = app.field();
    match field.row().published {
        Some(range) => format!(
            " published {} to {} {}",
            length_entry(range.min, app.units()),
            length_entry(range.max, app.units()),
            app.units().symbol()
        ),
        None => format!(" {}", field.allowed_in(&app.layout().layout, app.units())),
    }
}
