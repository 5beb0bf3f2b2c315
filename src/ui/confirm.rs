//! The questions that stop the work for a moment.

use super::text::{clear, heading, put, spot};
use super::theme::Theme;
use crate::app::keymap::{self, Context};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws a question with its keys in the middle of the area. Returns where it begins; nothing where
/// nothing is asked.
pub(crate) fn draw(
    context: Context,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let question = match context {
        Context::ConfirmQuit => "There are edits that are not saved.",
        Context::ConfirmOverwrite => {
            "The file on disk is not the one this project was read from, or another file has that name."
        }
        Context::ConfirmOpen => {
            "There are edits that are not saved; opening another project lets them go."
        }
        Context::ConfirmRecovery => {
            "A session of this file was cut off and its unsaved edits were kept."
        }
        _ => return None,
    };
    let width = area.width.min(60);
    let columns = usize::from(width.saturating_sub(4)).max(10);
    let mut lines: Vec<String> =
        textwrap::wrap(question, columns).iter().map(std::string::ToString::to_string).collect();
    lines.push(String::new());
    for b in keymap::of(context).filter(|b| b.hint.is_some()) {
        let text = format!("{:<7} {}", b.keys[0].to_string(), b.help);
        lines.extend(textwrap::wrap(&text, columns).iter().map(std::string::ToString::to_string));
    }
    let height = (lines.len() as u16 + 3).min(area.height);
    let x = area.x + (area.width - width) / 2;
    let y = area.y + (area.height - height) / 2;
    let place = Rect { x, y, width, height };
    clear(buf, place);
    heading(buf, place, context.heading(), "", theme);
    for (row, line) in lines.iter().enumerate() {
        put(buf, place, row as u16 + 1, 2, line, theme.text);
    }
    let last = height.saturating_sub(1);
    put(buf, place, last, 0, &theme.glyphs.rule().repeat(usize::from(width)), theme.heading);
    spot(buf, place, 1, 2)
}
