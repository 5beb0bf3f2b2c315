//! Help and details: a page of text that scrolls.

use super::text::{clear, heading, put, put_right, spot};
use super::theme::Theme;
use crate::app::App;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws the page over the whole area. Returns where its text begins.
pub(crate) fn draw(
    app: &App,
    word: &str,
    scroll: usize,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    heading(buf, area, word, "", theme);
    let lines = app.page_lines();
    let rows = usize::from(area.height.saturating_sub(1));
    let body = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    for (row, line) in lines.iter().skip(scroll).take(rows).enumerate() {
        let style = if line.heading { theme.title } else { theme.text };
        put(buf, body, row as u16, 2, &line.text, style);
    }
    if lines.len() > rows {
        let last = (scroll + rows).min(lines.len());
        let text = format!(" {}-{last} of {} ", scroll + 1, lines.len());
        put_right(
            buf,
            Rect { width: area.width.saturating_sub(2), ..area },
            0,
            &text,
            theme.heading,
        );
    }
    spot(buf, body, 0, 2)
}
