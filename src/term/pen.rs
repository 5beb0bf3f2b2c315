//! The terminal's pen: colours and attributes, and the shortest way from one to another.
//!
//! Only codes that every terminal since the eighties knows: named colours as 30-37 and 90-97 and not as
//! `38;5;n`, and attributes switched off by a reset, because a VT100 knows no single off-switches.

use crate::app::look::ColorMode;
use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// What makes a blank visible.
const INKED: Modifier = Modifier::REVERSED.union(Modifier::UNDERLINED).union(Modifier::CROSSED_OUT);

/// Attributes and their codes.
const CODES: [(Modifier, u8); 9] = [
    (Modifier::BOLD, 1),
    (Modifier::DIM, 2),
    (Modifier::ITALIC, 3),
    (Modifier::UNDERLINED, 4),
    (Modifier::SLOW_BLINK, 5),
    (Modifier::RAPID_BLINK, 5),
    (Modifier::REVERSED, 7),
    (Modifier::HIDDEN, 8),
    (Modifier::CROSSED_OUT, 9),
];

/// Colours by number, 0 to 15; `None` is the terminal's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Pen {
    fg: Option<u8>,
    bg: Option<u8>,
    modifier: Modifier,
}

impl Pen {
    /// The terminal's own colours, no attributes.
    pub(super) const PLAIN: Pen = Pen { fg: None, bg: None, modifier: Modifier::empty() };

    /// The pen a cell asks for.
    pub(super) fn of(cell: &Cell, color: ColorMode) -> Pen {
        match color {
            ColorMode::Basic16 => {
                Pen { fg: number(cell.fg), bg: number(cell.bg), modifier: cell.modifier }
            }
            ColorMode::None => Pen { fg: None, bg: None, modifier: cell.modifier },
        }
    }

    /// The same pen for a blank: of what cannot be seen there, nothing is left.
    pub(super) fn for_blank(self) -> Pen {
        if self.modifier.intersects(INKED) {
            self
        } else {
            Pen { fg: None, bg: self.bg, modifier: Modifier::empty() }
        }
    }

    /// The pen to draw a blank with when this one is in hand: this one where that makes no difference.
    pub(super) fn stretch_to_blank(self, blank: Pen) -> Pen {
        if blank.modifier.intersects(INKED) || self.modifier.intersects(INKED) {
            blank
        } else {
            Pen { bg: blank.bg, ..self }
        }
    }

    /// Writes the codes that lead from this pen to `next`; nothing when they are the same.
    pub(super) fn change(self, next: Pen, out: &mut Vec<u8>) {
        if self == next {
            return;
        }
        let lost = (self.fg.is_some() && next.fg.is_none())
            || (self.bg.is_some() && next.bg.is_none())
            || !next.modifier.contains(self.modifier);
        let from = if lost { Pen::PLAIN } else { self };
        out.extend_from_slice(b"\x1b[");
        let start = out.len();
        if lost {
            out.push(b'0');
        }
        for (modifier, code) in CODES {
            if next.modifier.contains(modifier) && !from.modifier.contains(modifier) {
                parameter(code, start, out);
            }
        }
        if next.fg != from.fg
            && let Some(n) = next.fg
        {
            parameter(if n < 8 { 30 + n } else { 82 + n }, start, out);
        }
        if next.bg != from.bg
            && let Some(n) = next.bg
        {
            parameter(if n < 8 { 40 + n } else { 92 + n }, start, out);
        }
        out.push(b'm');
    }
}

fn parameter(code: u8, start: usize, out: &mut Vec<u8>) {
    if out.len() > start {
        out.push(b';');
    }
    decimal(u16::from(code), out);
}

/// Writes a number in decimal.
pub(super) fn decimal(mut n: u16, out: &mut Vec<u8>) {
    let mut digits = [0u8; 5];
    let mut at = digits.len();
    loop {
        at -= 1;
        digits[at] = b'0' + (n % 10) as u8;
        n /= 10;
        if n == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}

/// The number of a named colour. Others are not for this program: they stand for the terminal's own.
fn number(color: Color) -> Option<u8> {
    Some(match color {
        Color::Black => 0,
        Color::Red => 1,
        Color::Green => 2,
        Color::Yellow => 3,
        Color::Blue => 4,
        Color::Magenta => 5,
        Color::Cyan => 6,
        Color::Gray => 7,
        Color::DarkGray => 8,
        Color::LightRed => 9,
        Color::LightGreen => 10,
        Color::LightYellow => 11,
        Color::LightBlue => 12,
        Color::LightMagenta => 13,
        Color::LightCyan => 14,
        Color::White => 15,
        Color::Indexed(n) if n < 16 => n,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::style::Style;

    fn pen(style: Style) -> Pen {
        let mut cell = Cell::default();
        cell.set_style(style);
        Pen::of(&cell, ColorMode::Basic16)
    }

    fn codes(from: Pen, to: Pen) -> String {
        let mut out = Vec::new();
        from.change(to, &mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn named_colours_are_classic_codes() {
        let plain = Pen::PLAIN;
        assert_eq!(codes(plain, pen(Style::new().red())), "\x1b[31m");
        assert_eq!(codes(plain, pen(Style::new().light_blue().on_white())), "\x1b[94;107m");
        assert_eq!(codes(plain, pen(Style::new().fg(Color::Indexed(8)))), "\x1b[90m");
        assert_eq!(codes(plain, pen(Style::new().fg(Color::Rgb(1, 2, 3)))), "");
    }

    #[test]
    fn what_is_added_is_added_and_what_goes_is_reset() {
        let bold_red = pen(Style::new().red().bold());
        assert_eq!(codes(pen(Style::new().red()), bold_red), "\x1b[1m");
        assert_eq!(codes(bold_red, pen(Style::new().red())), "\x1b[0;31m");
        assert_eq!(codes(bold_red, Pen::PLAIN), "\x1b[0m");
        assert_eq!(codes(bold_red, bold_red), "");
    }

    #[test]
    fn without_colour_attributes_alone_are_left() {
        let mut cell = Cell::default();
        cell.set_style(Style::new().red().on_blue().bold().reversed());
        let mono = Pen::of(&cell, ColorMode::None);
        assert_eq!(codes(Pen::PLAIN, mono), "\x1b[1;7m");
        assert_eq!(codes(mono, Pen::PLAIN), "\x1b[0m");
    }

    #[test]
    fn a_blank_takes_the_pen_at_hand() {
        let red = pen(Style::new().red().bold());
        let blank = pen(Style::new().green()).for_blank();
        assert_eq!(red.stretch_to_blank(blank), red);
        let reversed = pen(Style::new().reversed());
        assert_eq!(reversed.stretch_to_blank(blank), Pen::PLAIN);
    }

    #[test]
    fn numbers() {
        let mut out = Vec::new();
        for n in [0, 7, 10, 132, 65535] {
            decimal(n, &mut out);
            out.push(b' ');
        }
        assert_eq!(out, b"0 7 10 132 65535 ");
    }
}
