//! The top line and the bottom line: title; message, prompt or the most important keys.

use super::check;
use super::inputs::typed_text;
use super::text::{clear, cut, put, put_right, width};
use super::theme::Theme;
use crate::app::entry::{EditTarget, LineEntry};
use crate::app::keymap;
use crate::app::{App, Level, Mode};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws the title: program, file with a star for unsaved edits, how it stands on disk, mesh.
pub(crate) fn title(app: &App, row: Rect, buf: &mut Buffer, theme: &Theme) {
    let file = match app.path() {
        Some(path) => path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned(),
        None => "not saved to a file".to_string(),
    };
    let star = if app.edited() { " *" } else { "" };
    let held = if app.holder().is_some() { "  read only" } else { "" };
    let changed = if app.changed_on_disk() { "  changed on disk" } else { "" };
    let mesh = match app.result().mesh() {
        Some(mesh) => mesh.title().to_string(),
        None if app.empty() => String::new(),
        None => app.layout().mesh.clone(),
    };
    let room = usize::from(row.width);
    let left = format!(" meshcast  {}{star}{held}{changed}", cut(&file, room / 3));
    let end = put(buf, row, 0, 0, &left, theme.title);
    let right = cut(&mesh, room.saturating_sub(usize::from(end) + 3));
    let row = Rect { width: row.width.saturating_sub(1), ..row };
    put_right(buf, row, 0, &right, theme.text);
}

/// Most lines that a message takes of the screen.
const MESSAGE_LINES: usize = 6;

/// Draws the bottom line. `roomy` tells that a message may take some of the lines above it. Returns the place of
/// the cursor where text is typed in it.
pub(crate) fn bottom(
    app: &App,
    row: Rect,
    roomy: bool,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    if let Mode::Entry(entry) = app.mode() {
        // The value that is refused stands in its own row.
        if let (Some(error), EditTarget::Value(_)) = (&entry.error, entry.target) {
            message(Level::Error, error, (row, roomy), buf, theme);
            return None;
        }
        return prompt(app, entry, row, buf, theme);
    }
    if let Some(status) = app.status() {
        message(status.level, &status.text, (row, roomy), buf, theme);
        return None;
    }
    let asked = app.context().is_some_and(keymap::Context::asks);
    if !asked && let Some(text) = check::progress(app) {
        put(buf, row, 0, 1, &cut(&text, usize::from(row.width) - 1), theme.check);
        return None;
    }
    hints(app, row, buf, theme);
    None
}

/// Draws a message, until the next key. One that is too long for its line takes some of those above it. On a small
/// screen, where the answer stands there, only what was refused does.
fn message(level: Level, said: &str, (row, roomy): (Rect, bool), buf: &mut Buffer, theme: &Theme) {
    let (style, head) = match level {
        Level::Info => (theme.title, " "),
        Level::Error => (theme.error, " ! "),
    };
    let text = format!("{head}{said}");
    let columns = usize::from(row.width);
    let most = if roomy || level == Level::Error { MESSAGE_LINES } else { 1 };
    if width(&text) <= row.width || most == 1 {
        put(buf, row, 0, 0, &cut(&text, columns), style);
        return;
    }
    let indent = " ".repeat(head.len());
    let options = textwrap::Options::new(columns).initial_indent(head).subsequent_indent(&indent);
    let mut lines = textwrap::wrap(said, options);
    if lines.len() > most {
        // The rest is told to be there.
        let rest = lines.split_off(most - 1).join(" ");
        lines.push(cut(&rest, columns).into());
    }
    let height = (lines.len() as u16).min(row.y);
    let over = Rect { y: row.y + 1 - height, height, ..row };
    clear(buf, over);
    for (k, line) in lines.iter().enumerate() {
        put(buf, over, k as u16, 0, line, style);
    }
}

/// As many hints of the key map as fit, the most important first.
fn hints(app: &App, row: Rect, buf: &mut Buffer, theme: &Theme) {
    let Some(context) = app.context() else { return };
    let mut column = 1;
    for binding in keymap::of(context) {
        let Some(word) = binding.hint else { continue };
        let key = binding.keys[0].to_string();
        let key = if word == "step" { "arrows".to_string() } else { key };
        if column + width(&key) + 1 + width(word) > row.width {
            break;
        }
        column = put(buf, row, 0, column, &key, theme.key);
        column = put(buf, row, 0, column + 1, word, theme.text) + 2;
    }
}

/// The line of text being typed, or for a value its range.
fn prompt(
    app: &App,
    entry: &LineEntry,
    row: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    if let Some(error) = &entry.error {
        // A refused command or name still shows its text: the reason stands before it.
        let room = usize::from(row.width) * 2 / 3;
        let end = put(buf, row, 0, 0, &cut(&format!(" ! {error} "), room), theme.error);
        let rest = Rect { x: row.x + end, width: row.width.saturating_sub(end), ..row };
        return typed_text(entry, rest, buf, theme);
    }
    match entry.target {
        EditTarget::Value(field) => {
            let allowed = field.allowed_in(&app.layout().layout, app.units());
            let text = format!(" {}: {allowed}", field.row().phrase);
            // The keys are said whole or not at all.
            let keys = ["; Enter takes, Esc drops", "; Enter, Esc", ""];
            let fits = |keys: &&str| width(&text) + width(keys) <= row.width;
            let text = format!("{text}{}", keys.into_iter().find(fits).unwrap_or_default());
            put(buf, row, 0, 0, &cut(&text, usize::from(row.width)), theme.text);
            None
        }
        target => {
            let prompt = match target {
                EditTarget::Command => " :".to_string(),
                _ => format!(" {}: ", target.prompt()),
            };
            let end = put(buf, row, 0, 0, &prompt, theme.key);
            typed_text(
                entry,
                Rect { x: row.x + end, width: row.width.saturating_sub(end), ..row },
                buf,
                theme,
            )
        }
    }
}
