//! The list of what can be written.

use super::list::{entry, sentences};
use super::text::{clear, heading, spot};
use super::theme::Theme;
use crate::app::App;
use crate::export::ExportKind;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws the list over the whole area. Returns the place of the marked entry.
pub(crate) fn draw(
    app: &App,
    index: usize,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    heading(buf, area, "write to a file", "", theme);
    let stem =
        app.path().and_then(|p| p.file_stem()).map_or("meshcast".into(), |s| s.to_string_lossy());
    for (row, kind) in ExportKind::ALL.into_iter().enumerate() {
        let name = kind.file_name(&stem, &app.layout().name, 1);
        let text = format!(" {:<41} {name}", kind.about());
        entry(buf, area, 1 + row, row == index, &text, theme);
    }
    let (checked, stale) = (0..app.project().layouts.len())
        .filter_map(|i| app.kept_check(i))
        .fold((0, 0), |(checked, stale), shown| (checked + 1, stale + usize::from(shown.stale())));
    let lines = [
        "Files go beside the project, under a name that is free; :export report PATH takes another place, :export! replaces what is there.".to_string(),
        format!(
            "Checks by simulation are in reports, charts and the table: {checked} of {} layouts have one, {stale} stale. C checks them all.",
            app.project().layouts.len()
        ),
        if app.edited() {
            "The project has unsaved edits: a report says so and names no file that gives its numbers. Ctrl+S saves.".into()
        } else {
            String::new()
        },
    ];
    let top = 2 + ExportKind::ALL.len() as u16;
    sentences(buf, area, (top, usize::from(area.width).saturating_sub(4)), &lines, theme);
    spot(buf, area, 1 + index as u16, 1)
}
