//! The list of settings with their values and where each comes from.

use super::list::{entry, sentences};
use super::text::{clear, heading, spot};
use super::theme::Theme;
use crate::app::App;
use crate::app::settings::{SettingItem, Settings};
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
    heading(buf, area, "settings, for all projects", "", theme);
    let preferences = app.preferences();
    let default = Settings::default();
    for (row, item) in SettingItem::ALL.into_iter().enumerate() {
        let word = app.settings().word(item);
        let from = if preferences.is_flag(item) {
            "flag"
        } else if word != default.word(item) {
            "kept"
        } else {
            ""
        };
        let text = format!(" {:<10}{word:<10}{from:<6}{}", item.name(), item.about());
        entry(buf, area, 1 + row, row == index, &text, theme);
    }
    let mut lines = vec![
        "A flag of this run stands above what is kept, that above the project's own unit. \
         What is changed here holds at once and is kept."
            .to_string(),
    ];
    lines.push(match &preferences.file {
        Some(file) => format!("File: {}", file.display()),
        None => "There is no place for a file of settings: nothing is kept.".to_string(),
    });
    if let Some(trouble) = &preferences.trouble {
        lines.push(
            "At the start the file could not be read; the first change puts it aside:".into(),
        );
        lines.extend(trouble.lines().map(str::to_string));
    }
    let top = 2 + SettingItem::ALL.len() as u16;
    sentences(buf, area, (top, usize::from(area.width).saturating_sub(4)), &lines, theme);
    spot(buf, area, 1 + index as u16, 1)
}
