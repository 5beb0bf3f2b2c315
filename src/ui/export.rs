//! The list of what can be written.

use super::text::{clear, cut, heading, put, spot};
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
    let columns = usize::from(area.width);
    for (row, kind) in ExportKind::ALL.into_iter().enumerate() {
        let sign = if row == index { ">" } else { " " };
        let name = kind.file_name(&stem, &app.layout().name, 1);
        let text = format!(" {sign} {:<41} {name}", kind.about());
        let style = if row == index { theme.selected } else { theme.text };
        put(buf, area, 1 + row as u16, 0, &cut(&text, columns), style);
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
    let wrapped =
        lines.iter().flat_map(|line| textwrap::wrap(line, columns.saturating_sub(4).max(10)));
    let rows = usize::from(area.height.saturating_sub(top));
    for (row, line) in wrapped.take(rows).enumerate() {
        put(buf, area, top + row as u16, 2, &line, theme.text);
    }
    spot(buf, area, 1 + index as u16, 1)
}
