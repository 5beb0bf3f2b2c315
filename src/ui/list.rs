//! What lists over the whole screen have in common: the entry that is marked, and lines below.

use super::text::{cut, put};
use super::theme::Theme;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// An entry in its row, with a sign in front where it is marked.
pub(super) fn entry(
    buf: &mut Buffer,
    area: Rect,
    row: usize,
    marked: bool,
    text: &str,
    theme: &Theme,
) {
    let (sign, style) = if marked { (">", theme.selected) } else { (" ", theme.text) };
    let text = cut(&format!(" {sign}{text}"), usize::from(area.width));
    put(buf, area, row as u16, 0, &text, style);
}

/// Sentences from a row on, wrapped to so many columns, as far as there is room.
pub(super) fn sentences(
    buf: &mut Buffer,
    area: Rect,
    (top, columns): (u16, usize),
    lines: &[String],
    theme: &Theme,
) {
    let wrapped = lines.iter().flat_map(|line| textwrap::wrap(line, columns.max(10)));
    for (row, line) in (top..area.height).zip(wrapped) {
        put(buf, area, row, 2, &line, theme.text);
    }
}
