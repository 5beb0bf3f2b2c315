//! Small helpers to put text into a part of the screen; nothing is ever drawn outside of it.

use super::theme::Theme;
use crate::show::picture::Picture;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

/// Columns a text takes.
pub(crate) fn width(text: &str) -> u16 {
    UnicodeWidthStr::width(text).min(usize::from(u16::MAX)) as u16
}

/// Puts a text at a row and column of an area, cut at its edge. Returns the column behind it.
pub(crate) fn put(
    buf: &mut Buffer,
    area: Rect,
    row: u16,
    column: u16,
    text: &str,
    style: Style,
) -> u16 {
    let area = area.intersection(buf.area);
    if row >= area.height || column >= area.width {
        return column;
    }
    let room = usize::from(area.width - column);
    let (end, _) = buf.set_stringn(area.x + column, area.y + row, text, room, style);
    end - area.x
}

/// Puts a text so that it ends at the right edge of an area.
pub(crate) fn put_right(buf: &mut Buffer, area: Rect, row: u16, text: &str, style: Style) {
    put(buf, area, row, area.width.saturating_sub(width(text)), text, style);
}

/// Puts a drawing at the top left of an area, cut at its edges; blanks leave the screen as it is.
pub(crate) fn draw(picture: &Picture, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let area = area.intersection(buf.area);
    for (row, column, sign, ink) in picture.cells() {
        if row < usize::from(area.height) && column < usize::from(area.width) {
            // Within the area, and so within u16.
            let place = (area.x + column as u16, area.y + row as u16);
            buf[place].set_char(sign).set_style(theme.ink(ink));
        }
    }
}

/// The cell at a row and column of an area, for the terminal's cursor to stand on; none where nothing
/// can be drawn.
pub(crate) fn spot(buf: &Buffer, area: Rect, row: u16, column: u16) -> Option<Position> {
    let place = Position::new(area.x.checked_add(column)?, area.y.checked_add(row)?);
    area.intersection(buf.area).contains(place).then_some(place)
}

/// A heading: a rule with a word in it, and one at its right end.
pub(crate) fn heading(buf: &mut Buffer, area: Rect, word: &str, right: &str, theme: &Theme) {
    if area.is_empty() {
        return;
    }
    put(buf, area, 0, 0, &theme.glyphs.rule().repeat(usize::from(area.width)), theme.heading);
    put(buf, area, 0, 2, &format!(" {word} "), theme.heading);
    if !right.is_empty() && width(word) + width(right) + 8 <= area.width {
        let text = format!(" {right} ");
        let column = area.width - width(&text) - 1;
        put(buf, area, 0, column, &text, theme.heading);
    }
}

/// Fills an area with blanks.
pub(crate) fn clear(buf: &mut Buffer, area: Rect) {
    for y in area.top()..area.bottom().min(buf.area.bottom()) {
        for x in area.left()..area.right().min(buf.area.right()) {
            buf[(x, y)].reset();
        }
    }
}

/// The part of an area below its first `rows` rows.
pub(crate) fn below(area: Rect, rows: u16) -> Rect {
    let rows = rows.min(area.height);
    Rect { y: area.y + rows, height: area.height - rows, ..area }
}

/// A text cut to a width, with `..` where something is missing.
pub(crate) fn cut(text: &str, columns: usize) -> String {
    if UnicodeWidthStr::width(text) <= columns {
        return text.to_string();
    }
    let mut out = String::new();
    for c in text.chars() {
        let mut next = out.clone();
        next.push(c);
        if UnicodeWidthStr::width(next.as_str()) + 2 > columns {
            break;
        }
        out = next;
    }
    format!("{out}{}", &".."[..columns.min(2)])
}
