//! The main screen of a project without layouts: what it is called and how it goes on.

use super::text::{below, cut, heading, put, spot};
use super::theme::Theme;
use crate::app::App;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws it. Returns the place of the offer.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    heading(buf, area, "layouts", "none", theme);
    let list = below(area, 2);
    let room = usize::from(list.width.saturating_sub(2));
    put(buf, list, 0, 2, &cut(&app.project().name, room), theme.title);
    let offer = "This project has no layouts yet: a adds one at the reference point of the method.";
    for (row, line) in textwrap::wrap(offer, room.max(10)).iter().enumerate() {
        put(buf, list, row as u16 + 2, 2, line, theme.text);
    }
    spot(buf, list, 2, 2)
}
