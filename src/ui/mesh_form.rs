//! The form by which a mesh is added.

use super::inputs::typed_text;
use super::text::{clear, cut, heading, put};
use super::theme::Theme;
use crate::app::mesh_form::{MeshForm, ROWS};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Columns of the names of the rows, with the mark before them.
const LABEL: u16 = 13;

/// Draws it over the whole area. Returns the place of the cursor.
pub(crate) fn draw(
    form: &MeshForm,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    heading(buf, area, "a mesh for this project", "laboratory punch test, punch 1 m", theme);
    let mut place = None;
    for (k, (row, line)) in ROWS.iter().zip(&form.lines).enumerate() {
        let at = Rect { y: area.y + 1 + k as u16, height: 1, ..area };
        if at.y >= area.bottom() {
            break;
        }
        let here = k == form.index;
        let label = format!(" {}{}", if here { ">" } else { " " }, row.label);
        put(buf, at, 0, 0, &label, if here { theme.key } else { theme.text });
        let room = at.width.saturating_sub(LABEL + 1);
        let field = Rect { x: at.x + LABEL, width: room, ..at };
        if here {
            place = typed_text(line, field, buf, theme);
        } else {
            put(buf, field, 0, 0, &cut(line.text(), usize::from(room)), theme.text);
        }
    }
    let top = area.y + 1 + ROWS.len() as u16;
    let below = Rect { y: top, height: area.bottom().saturating_sub(top), ..area };
    let (said, style) = match &form.error {
        Some(why) => (why.as_str(), theme.caution),
        None => (ROWS[form.index].about, theme.text),
    };
    let columns = usize::from(area.width.saturating_sub(3)).max(10);
    for (row, line) in textwrap::wrap(said, columns).iter().enumerate() {
        put(buf, below, row as u16, 2, line, style);
    }
    place
}
