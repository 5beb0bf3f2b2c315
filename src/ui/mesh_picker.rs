//! The list of meshes to choose from, with the record of the marked one.

use super::layouts::first_shown;
use super::list::{entry, sentences};
use super::text::{clear, heading, spot};
use super::theme::Theme;
use crate::app::App;
use crate::show::say;
use crate::units::{force_text, length_text, maybe_length_text};
use crate::words::Choice;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Rows of the record below the list.
const RECORD: u16 = 8;

/// Draws the list over the whole area. Returns the place of the marked mesh.
pub(crate) fn draw(
    app: &App,
    index: usize,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    let meshes = app.meshes();
    heading(buf, area, "mesh of this layout", &format!("{} of {}", index + 1, meshes.len()), theme);
    let record = RECORD.min(area.height / 2);
    let list = Rect { y: area.y + 1, height: area.height.saturating_sub(1 + record), ..area };
    let rows = usize::from(list.height);
    let first = first_shown(index, rows, meshes.len());
    for (row, i) in (first..meshes.len()).take(rows).enumerate() {
        let mesh = &meshes[i].mesh;
        let used = if mesh.id == app.layout().mesh { "*" } else { " " };
        let inline = if meshes[i].inline { " (in this project)" } else { "" };
        let text = format!(
            "{used} {:<16} {:>9} {:>8}  {}{inline}",
            mesh.id,
            force_text(mesh.laboratory.force, app.units()),
            maybe_length_text(mesh.laboratory.deflection, app.units()),
            mesh.title()
        );
        entry(buf, list, row, i == index, &text, theme);
    }
    let place = spot(buf, list, index.saturating_sub(first) as u16, 1);
    let Some(choice) = meshes.get(index) else { return place };
    let below = Rect { y: list.bottom(), height: record, ..area };
    heading(buf, below, "its record", "", theme);
    let lab = &choice.mesh.laboratory;
    let mut lines = vec![
        format!(
            "punch test {} at {}, {}; panel {}, punch {}",
            force_text(lab.force, app.units()),
            maybe_length_text(lab.deflection, app.units()),
            lab.statistic.word(),
            length_text(lab.panel, app.units()),
            length_text(lab.punch, app.units())
        ),
        format!("standard: {}", if lab.standard.is_empty() { "not stated" } else { &lab.standard }),
    ];
    lines.push(match (&choice.mesh.ratios, &choice.mesh.adopted) {
        (Some(r), _) => format!(
            "its own ratios: alpha_F {:.3}, alpha_delta {:.3}; {}",
            r.force, r.deflection, r.source
        ),
        (None, Some(a)) => format!("adopted by {}", say::adopted(a, app.units())),
        (None, None) if choice.mesh.reference => {
            "the mesh of the paper: the default ratios are its own".into()
        }
        (None, None) => "no ratios of its own: the reference's are assumed, with a warning".into(),
    });
    lines.push(format!("source: {}", lab.source));
    if choice.inline {
        lines.push("C keeps it in your own catalogue too, for other projects".into());
    }
    sentences(buf, below, (1, usize::from(below.width).saturating_sub(3)), &lines, theme);
    place
}
