//! The form by which a mesh is added or adopted.

use super::inputs::typed_text;
use super::layouts::first_shown;
use super::text::{clear, cut, heading, put};
use super::theme::Theme;
use crate::app::mesh_form::{FormKind, MeshForm};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Columns of the names of the rows, with the mark before them.
const LABEL: u16 = 13;

/// Fewest lines below the rows, for what is said of the marked one.
const LEAST_SAID: u16 = 2;

/// Draws it over the whole area. Returns the place of the cursor.
pub(crate) fn draw(
    form: &MeshForm,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    let (title, of) = match form.kind {
        FormKind::Record => ("a mesh for this project", "laboratory punch test, punch 1 m"),
        FormKind::Tests => ("a mesh to adopt", "from its own tests"),
    };
    heading(buf, area, title, of, theme);
    let mut place = None;
    let rows = form.rows();
    let (said, style) = match &form.error {
        Some(why) => (why.as_str(), theme.caution),
        None => (rows[form.index].about, theme.text),
    };
    let columns = usize::from(area.width.saturating_sub(3)).max(10);
    let said = textwrap::wrap(said, columns);
    // What is said of the marked row has its lines, as far as half of the screen goes.
    let below = (said.len() as u16).clamp(LEAST_SAID, area.height / 2);
    let room = usize::from(area.height.saturating_sub(1 + below)).clamp(1, rows.len());
    let first = first_shown(form.index, room, rows.len());
    let shown = rows.iter().zip(&form.lines).enumerate().skip(first).take(room);
    for (k, (row, line)) in shown {
        let at = Rect { y: area.y + 1 + (k - first) as u16, height: 1, ..area };
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
    let top = area.y + 1 + room as u16;
    let below = Rect { y: top, height: area.bottom().saturating_sub(top), ..area };
    for (row, line) in said.iter().enumerate() {
        put(buf, below, row as u16, 2, line, style);
    }
    place
}
