//! What a terminal shows of a row of cells: wide characters cover the cell after them, and nothing that
//! could command the terminal gets through.

use super::pen::Pen;
use crate::app::look::ColorMode;
use crate::words::shown;
use ratatui::buffer::{Buffer, Cell};
use unicode_width::UnicodeWidthStr;

/// What the terminal takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Charset {
    /// UTF-8.
    #[default]
    Utf8,
    /// ASCII; anything else is shown as `?`.
    Ascii,
}

/// One column of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown<'a> {
    /// A character begins here.
    Head {
        /// The character with its combining marks.
        text: &'a str,
        /// Columns it takes, 1 or 2.
        width: u16,
        /// How it is drawn.
        pen: Pen,
    },
    /// Covered by the wide character before it.
    Tail,
}

impl Shown<'_> {
    /// An untouched cell of a cleared screen.
    pub(super) const BLANK: Shown<'static> = Shown::Head { text: " ", width: 1, pen: Pen::PLAIN };

    /// Columns that the cursor moves when this is written.
    pub(super) fn width(&self) -> u16 {
        match self {
            Shown::Head { width, .. } => *width,
            Shown::Tail => 1,
        }
    }

    /// Whether every terminal agrees how far the cursor moves: not after wide or combined characters,
    /// nor after pictures, which some draw wide.
    pub(super) fn is_plain(&self) -> bool {
        match self {
            Shown::Head { text, width, .. } => {
                let mut chars = text.chars();
                let first = chars.next().unwrap_or(' ');
                *width == 1 && chars.next().is_none() && !is_picture(first)
            }
            Shown::Tail => false,
        }
    }
}

/// Fills `row` with what is shown of row `y` of a buffer, counted from its top.
pub(super) fn shown_row<'a>(
    buffer: &'a Buffer,
    y: u16,
    color: ColorMode,
    charset: Charset,
    row: &mut Vec<Shown<'a>>,
) {
    row.clear();
    let width = usize::from(buffer.area.width);
    let start = usize::from(y) * width;
    let cells = buffer.content.get(start..start + width).unwrap_or_default();
    let mut x = 0;
    while let Some(cell) = cells.get(x) {
        let (text, columns) = printable(cell, cells.len() - x, charset);
        let pen = Pen::of(cell, color);
        let pen = if text == " " { pen.for_blank() } else { pen };
        row.push(Shown::Head { text, width: columns, pen });
        x += 1;
        if columns == 2 {
            row.push(Shown::Tail);
            x += 1;
        }
    }
}

/// The text of a cell that is safe to send, and its width. Control characters would be commands; bytes
/// beyond ASCII may be, to a terminal that does not expect UTF-8.
fn printable(cell: &Cell, room: usize, charset: Charset) -> (&str, u16) {
    let text = cell.symbol();
    match text.as_bytes() {
        [byte] if (b' '..=b'~').contains(byte) => return (text, 1),
        [] => return (" ", 1),
        _ => {}
    }
    if !text.chars().all(shown) {
        return ("?", 1);
    }
    if charset == Charset::Ascii && !text.is_ascii() {
        return ("?", 1);
    }
    let text = agreed(text);
    match text.width() {
        0 => (" ", 1),
        1 => (text, 1),
        2 if room >= 2 => (text, 2),
        // Too wide for the row, or for any cell.
        _ => (" ", 1),
    }
}

/// Signs that are drawn as pictures in two columns by some terminals: dingbats, emoji, flags.
fn is_picture(c: char) -> bool {
    matches!(c, '\u{2600}'..='\u{27bf}' | '\u{2b00}'..='\u{2bff}' | '\u{1f000}'..)
}

/// The part of a character with marks that all terminals know the width of. About what asks for another
/// look of the same sign they disagree: variation selectors, skin tones, tags, and signs joined to one
/// picture. Without it the sign itself is left. Letters keep their joiners, which spell words.
fn agreed(text: &str) -> &str {
    let letter = text.chars().next().is_some_and(char::is_alphabetic);
    let doubtful = |c: char| match c {
        '\u{fe00}'..='\u{fe0f}' => true,
        '\u{200d}' | '\u{1f1e6}'..='\u{1f1ff}' | '\u{1f3fb}'..='\u{1f3ff}' => !letter,
        '\u{e0000}'..='\u{e01ef}' => true,
        _ => false,
    };
    let end = text.char_indices().skip(1).find(|(_, c)| doubtful(*c));
    end.map_or(text, |(at, _)| &text[..at])
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::layout::Rect;
    use ratatui::style::Style;

    fn texts(symbols: &[&str], charset: Charset) -> Vec<String> {
        let mut buffer = Buffer::empty(Rect::new(0, 0, symbols.len() as u16, 1));
        for (cell, symbol) in buffer.content.iter_mut().zip(symbols) {
            cell.set_symbol(symbol).set_style(Style::new());
        }
        let mut row = Vec::new();
        shown_row(&buffer, 0, ColorMode::Basic16, charset, &mut row);
        let text = |shown: &Shown<'_>| match shown {
            Shown::Head { text, .. } => (*text).to_owned(),
            Shown::Tail => "<".to_owned(),
        };
        row.iter().map(text).collect()
    }

    #[test]
    fn nothing_commands_the_terminal() {
        let row = texts(&["a", "\x1b[2J", "\n", "\u{9b}", ""], Charset::Utf8);
        assert_eq!(row, ["a", "?", "?", "?", " "]);
    }

    #[test]
    fn wide_characters_cover_the_next_cell_and_do_not_leave_the_row() {
        assert_eq!(texts(&["網", "x", "b"], Charset::Utf8), ["網", "<", "b"]);
        assert_eq!(texts(&["a", "網"], Charset::Utf8), ["a", " "]);
    }

    #[test]
    fn of_a_picture_the_part_is_left_whose_width_is_certain() {
        for (text, shown) in [
            ("🏔\u{fe0f}", "🏔"),
            ("♻\u{fe0f}", "♻"),
            ("1\u{fe0f}\u{20e3}", "1"),
            ("👨\u{200d}👩\u{200d}👧", "👨"),
            ("👍\u{1f3fd}", "👍"),
            ("🇮\u{1f1f9}", "🇮"),
            ("é", "é"),
            ("e\u{301}", "e\u{301}"),
            ("क\u{94d}\u{200d}", "क\u{94d}\u{200d}"),
        ] {
            assert_eq!(texts(&[text, ""], Charset::Utf8)[0], shown);
        }
    }

    #[test]
    fn a_plain_terminal_gets_ascii() {
        assert_eq!(texts(&["⣿", "é", "網", " "], Charset::Ascii), ["?", "?", "?", " "]);
        assert_eq!(texts(&["⣿", "é"], Charset::Utf8), ["⣿", "é"]);
    }
}
