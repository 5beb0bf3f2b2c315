//! The questions that stop the work for a moment.

use super::text::{clear, heading, put, spot};
use super::theme::Theme;
use crate::app::keymap;
use crate::app::{App, Mode};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Rows for keys, heading and rules of a question.
const KEYS: usize = 10;

/// Draws a question with its keys in the middle of the area. Returns where it begins; nothing where
/// nothing is asked.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let (question, more): (&str, &[String]) = match app.mode() {
        Mode::ConfirmQuit => ("There are edits that are not saved.", &[]),
        Mode::ConfirmOverwrite { why, .. } | Mode::ConfirmTakeOver { why, .. } => (why, &[]),
        Mode::ConfirmOpen { .. } => {
            ("There are edits that are not saved; opening another project lets them go.", &[])
        }
        Mode::ConfirmRecovery { kept } => {
            ("A session of this file was cut off and its unsaved edits were kept.", &kept.about)
        }
        _ => return None,
    };
    let context = app.context()?;
    let width = area.width.min(60);
    let columns = usize::from(width.saturating_sub(4)).max(10);
    let wrapped = |text: &str| -> Vec<String> {
        textwrap::wrap(text, columns).iter().map(ToString::to_string).collect()
    };
    let mut lines = wrapped(question);
    // The keys must be seen whatever else there is to say.
    let room = usize::from(area.height).saturating_sub(KEYS + lines.len());
    let mut told: Vec<String> = more.iter().flat_map(|line| wrapped(line)).collect();
    if told.len() > room {
        told.truncate(room.saturating_sub(1));
        told.push("and more".to_string());
    }
    lines.extend(told);
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
