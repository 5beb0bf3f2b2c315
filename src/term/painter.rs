//! Turns the difference between two screens into the bytes that make one of the other.

use super::cells::{Charset, Shown, shown_row};
use super::pen::Pen;
use super::travel::{Cursor, skip_cost, travel};
use crate::app::look::ColorMode;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use std::mem;

/// Attributes off, cursor home, everything cleared.
const CLEAR: &[u8] = b"\x1b[0m\x1b[H\x1b[2J";
/// Clears from the cursor to the end of the row.
const CLEAR_TAIL: &[u8] = b"\x1b[K";
/// Shows the cursor.
const SHOW: &[u8] = b"\x1b[?25h";
/// Hides the cursor.
const HIDE: &[u8] = b"\x1b[?25l";
/// Fewer changed cells than this are not worth a [`CLEAR_TAIL`].
const SHORT_TAIL: usize = 4;

/// Bytes sent so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Meter {
    /// Frames that sent something.
    pub frames: u64,
    /// Bytes of all frames.
    pub bytes: u64,
    /// Bytes of the last frame, 0 when it changed nothing.
    pub last: usize,
    /// Bytes of the largest frame.
    pub largest: usize,
}

/// Remembers what the terminal shows and says how to change it.
#[derive(Debug)]
pub struct Painter {
    charset: Charset,
    color: ColorMode,
    shown: Option<Buffer>,
    next: Buffer,
    pen: Pen,
    cursor: Option<Cursor>,
    /// Whether the terminal shows its cursor, as far as is known.
    visible: Option<bool>,
    out: Vec<u8>,
    meter: Meter,
}

impl Painter {
    /// Knows nothing of the terminal yet but that its cursor is hidden: the first frame clears it.
    pub fn new(charset: Charset) -> Painter {
        Painter {
            charset,
            color: ColorMode::Basic16,
            shown: None,
            next: Buffer::empty(Rect::ZERO),
            pen: Pen::PLAIN,
            cursor: None,
            visible: Some(false),
            out: Vec::new(),
            meter: Meter::default(),
        }
    }

    /// Trusts nothing that was sent before: the next frame clears the terminal and draws all of it.
    pub(crate) fn forget(&mut self) {
        self.shown = None;
        self.visible = None;
    }

    /// Draws a screen of this size into an empty buffer and returns the bytes to send: none when the
    /// terminal shows just that. A new size or colour mode draws all of it. Drawing says where the
    /// cursor is to stand when all is done, if it is to be seen.
    pub fn paint(
        &mut self,
        (width, height): (u16, u16),
        color: ColorMode,
        draw: impl FnOnce(&mut Buffer) -> Option<Position>,
    ) -> &[u8] {
        let area = Rect::new(0, 0, width, height);
        if mem::replace(&mut self.color, color) != color
            || self.shown.as_ref().is_some_and(|shown| shown.area != area)
        {
            self.shown = None;
        }
        self.next.resize(area);
        self.next.reset();
        let place = draw(&mut self.next).filter(|place| area.contains(*place));

        self.out.clear();
        let mut shown = match self.shown.take() {
            Some(shown) => shown,
            None => {
                self.out.extend_from_slice(CLEAR);
                self.pen = Pen::PLAIN;
                self.cursor = Some(Cursor { row: 0, column: Some(0) });
                Buffer::empty(area)
            }
        };
        self.send_difference(&shown);
        self.rest(place);
        mem::swap(&mut shown, &mut self.next);
        self.shown = Some(shown);

        self.meter.last = self.out.len();
        self.meter.bytes += self.out.len() as u64;
        self.meter.largest = self.meter.largest.max(self.out.len());
        self.meter.frames += u64::from(!self.out.is_empty());
        &self.out
    }

    /// What has been sent so far.
    pub fn meter(&self) -> Meter {
        self.meter
    }

    fn send_difference(&mut self, shown: &Buffer) {
        let next = mem::take(&mut self.next);
        let mut before = Vec::new();
        let mut after = Vec::new();
        for y in 0..next.area.height {
            shown_row(shown, y, self.color, self.charset, &mut before);
            shown_row(&next, y, self.color, self.charset, &mut after);
            self.send_row(y, &before, &after);
        }
        self.next = next;
    }

    /// Leaves the cursor where it is wanted.
    fn rest(&mut self, place: Option<Position>) {
        if let Some(place) = place {
            self.go(place.y, place.x, &[]);
        }
        if self.visible != Some(place.is_some()) {
            self.visible = Some(place.is_some());
            self.out.extend_from_slice(if place.is_some() { SHOW } else { HIDE });
        }
    }

    fn send_row(&mut self, y: u16, before: &[Shown<'_>], after: &[Shown<'_>]) {
        let tail = tail_to_clear(before, after);
        let mut x = 0;
        // The cell after a character that some terminal draws wider than others.
        let mut doubtful = None;
        for (column, (old, new)) in before.iter().zip(after).enumerate().take(tail) {
            if let Shown::Head { text, pen, .. } = new
                && (old != new || doubtful == Some(column))
            {
                self.go(y, column as u16, after);
                if new.width() > 1 {
                    self.blank(y, column as u16, new, after.len());
                }
                self.write(text, *pen);
                x = column as u16 + new.width();
                self.advance(y, x, new, after.len());
                if !new.is_plain() {
                    doubtful = Some(usize::from(x));
                }
            }
        }
        if tail < after.len() {
            self.go(y, tail as u16, if usize::from(x) <= tail { after } else { &[] });
            self.set_pen(self.pen.stretch_to_blank(Pen::PLAIN));
            self.out.extend_from_slice(CLEAR_TAIL);
        }
    }

    /// Clears the cells of a wide character before it is drawn: a terminal that draws it narrow would
    /// leave what was in the second.
    fn blank(&mut self, y: u16, x: u16, wide: &Shown<'_>, width: usize) {
        let Shown::Head { pen, .. } = wide else { return };
        for column in x..x + wide.width() {
            self.write(" ", pen.for_blank());
            self.advance(y, column + 1, &Shown::BLANK, width);
        }
        self.go(y, x, &[]);
    }

    /// Where the cursor is after a character whose next column is `x`.
    fn advance(&mut self, y: u16, x: u16, drawn: &Shown<'_>, width: usize) {
        self.cursor = if !drawn.is_plain() {
            None
        } else {
            Some(Cursor { row: y, column: (usize::from(x) < width).then_some(x) })
        };
    }

    /// Moves the cursor; over a short gap of unchanged cells by writing them again where that is
    /// shorter.
    fn go(&mut self, y: u16, x: u16, row: &[Shown<'_>]) {
        if let Some(Cursor { row: at_row, column: Some(at) }) = self.cursor
            && at_row == y
            && at < x
            && let Some(gap) = row.get(usize::from(at)..usize::from(x))
            && self.rewrite(gap, skip_cost(x - at))
        {
            self.cursor = Some(Cursor { row: y, column: Some(x) });
            return;
        }
        if self.cursor != Some(Cursor { row: y, column: Some(x) }) {
            travel(self.cursor, y, x, &mut self.out);
            self.cursor = Some(Cursor { row: y, column: Some(x) });
        }
    }

    /// Writes cells again when that takes no more than `budget` bytes and no other pen.
    fn rewrite(&mut self, gap: &[Shown<'_>], budget: usize) -> bool {
        let start = self.out.len();
        for shown in gap {
            if let Shown::Head { text, pen, .. } = shown
                && shown.is_plain()
                && self.pen_for(text, *pen) == self.pen
                && self.out.len() - start + text.len() <= budget
            {
                self.out.extend_from_slice(text.as_bytes());
            } else {
                self.out.truncate(start);
                return false;
            }
        }
        true
    }

    fn write(&mut self, text: &str, pen: Pen) {
        self.set_pen(self.pen_for(text, pen));
        self.out.extend_from_slice(text.as_bytes());
    }

    fn pen_for(&self, text: &str, pen: Pen) -> Pen {
        if text == " " { self.pen.stretch_to_blank(pen) } else { pen }
    }

    fn set_pen(&mut self, pen: Pen) {
        self.pen.change(pen, &mut self.out);
        self.pen = pen;
    }
}

/// The column from which the row is blank and better cleared than overwritten; its end when there is
/// none.
fn tail_to_clear(before: &[Shown<'_>], after: &[Shown<'_>]) -> usize {
    let blanks = after.iter().rev().take_while(|shown| **shown == Shown::BLANK).count();
    let tail = after.len() - blanks;
    let first = (tail..after.len()).find(|x| before.get(*x) != after.get(*x));
    let last = (tail..after.len()).rfind(|x| before.get(*x) != after.get(*x));
    match (first, last) {
        (Some(first), Some(last)) if last - first + 1 >= SHORT_TAIL => first,
        _ => after.len(),
    }
}

#[cfg(test)]
#[path = "painter_tests.rs"]
mod tests;
