//! A screen of the tour, over the main screen.

use super::text::{clear, heading, put, spot};
use super::theme::Theme;
use crate::app::tour::stops;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Columns of the widest box.
const WIDEST: u16 = 60;

/// Draws a screen of the tour in the middle of the area, or over all of a small one. Returns where its
/// text begins.
pub(crate) fn draw(stop: usize, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let stops = stops();
    let shown = stops.get(stop)?;
    let width = area.width.min(WIDEST);
    let columns = usize::from(width.saturating_sub(4)).max(10);
    let lines: Vec<String> = shown.lines.iter().flat_map(|line| wrapped(line, columns)).collect();
    let height = (lines.len() as u16 + 4).min(area.height);
    let place = Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    };
    clear(buf, place);
    let count = format!("{} of {}", stop + 1, stops.len());
    heading(buf, place, shown.title, &count, theme);
    // A small screen has no room for air.
    let top = if usize::from(height) >= lines.len() + 4 { 2 } else { 1 };
    for (row, line) in lines.iter().enumerate() {
        put(buf, place, top + row as u16, 2, line, theme.text);
    }
    if top == 2 {
        let last = height - 1;
        put(buf, place, last, 0, &theme.glyphs.rule().repeat(usize::from(width)), theme.heading);
    }
    spot(buf, place, top, 2)
}

/// A line in pieces; behind a key the pieces stand under its words.
fn wrapped(line: &str, columns: usize) -> Vec<String> {
    let words = line.find("  ").map_or(0, |gap| line.len() - line[gap..].trim_start().len());
    let indent = " ".repeat(words);
    let options = textwrap::Options::new(columns).subsequent_indent(&indent);
    textwrap::wrap(line, options).iter().map(std::string::ToString::to_string).collect()
}
