//! The list of projects to open, with the letters typed above it.

use super::inputs::typed_text;
use super::layouts::first_shown;
use super::text::{clear, cut, heading, put};
use super::theme::Theme;
use crate::app::message::FoundProject;
use crate::app::picker::Picker;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use std::path::Path;

/// Columns of the file's name.
const NAME: usize = 26;

/// Draws the list over the whole area. Returns the place of the cursor in the letters.
pub(crate) fn draw(
    picker: &Picker,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    let matches = picker.matches();
    let count = format!("{} of {}", matches.len(), picker.found.len());
    heading(buf, area, "open a project", &count, theme);
    let prompt = Rect { y: area.y + 1, height: area.height.min(2).saturating_sub(1), ..area };
    let end = put(buf, prompt, 0, 1, "find: ", theme.key);
    let line = Rect { x: area.x + end, width: area.width.saturating_sub(end), ..prompt };
    let cursor = typed_text(&picker.entry, line, buf, theme);

    let columns = usize::from(area.width.saturating_sub(3)).max(10);
    let error: Vec<String> =
        picker.error.iter().flat_map(|text| text.lines()).fold(Vec::new(), |mut lines, line| {
            lines
                .extend(textwrap::wrap(line, columns).iter().map(std::string::ToString::to_string));
            lines
        });
    let rows = area.height.saturating_sub(2);
    let below = match error.len() as u16 {
        0 => 0,
        lines => (lines + 1).min(rows * 2 / 3),
    };
    let list = Rect { y: area.y + 2, height: rows - below, ..area };
    let first = first_shown(picker.index, usize::from(list.height), matches.len());
    for (row, (i, found)) in
        matches.iter().enumerate().skip(first).take(usize::from(list.height)).enumerate()
    {
        let style = if i == picker.index && !found.missing { theme.selected } else { theme.text };
        let sign = if i == picker.index && !found.missing { ">" } else { " " };
        let text = format!(" {sign}{}", entry(found));
        put(buf, list, row as u16, 0, &cut(&text, usize::from(list.width)), style);
    }
    if matches.is_empty() {
        let said = match (picker.found.is_empty(), picker.entry.text().trim().is_empty()) {
            (_, false) => "no project fits; Enter takes the text as a path",
            (true, true) => "no projects found near by; type a path",
            (false, true) => "",
        };
        put(buf, list, 0, 2, said, theme.text);
    }
    if below > 0 {
        let place = Rect { y: list.bottom(), height: below, ..area };
        heading(buf, place, "it was not opened; the present project stays", "", theme);
        for (row, line) in error.iter().enumerate() {
            put(buf, place, 1 + row as u16, 2, line, theme.text);
        }
    }
    cursor
}

/// A line of the list: name, what is to be known of it, folder.
fn entry(found: &FoundProject) -> String {
    let path = Path::new(&found.shown);
    let name = path.file_name().map_or_else(|| found.shown.clone(), |n| n.to_string_lossy().into());
    let folder = path.parent().map(|p| p.display().to_string()).unwrap_or_default();
    let sign = if found.current { "*" } else { " " };
    let word = match (found.missing, found.current, found.recent) {
        (true, ..) => "gone",
        (_, true, _) => "open",
        (.., true) => "recent",
        _ => "",
    };
    format!("{sign} {:<NAME$} {word:<7} {folder}", cut(&name, NAME))
}
