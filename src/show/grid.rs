//! A grid of dots finer than characters, for curves and plans: braille, half blocks or plain ASCII.

use super::glyphs::Glyphs;
use super::picture::{Ink, Picture};

/// How a line is drawn, so that lines differ without colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pattern {
    /// Every dot.
    Solid,
    /// So many dots drawn, so many left out.
    Dashed(u16, u16),
}

impl Pattern {
    fn draws(self, count: u32) -> bool {
        match self {
            Pattern::Solid => true,
            Pattern::Dashed(on, off) => count % u32::from(on + off) < u32::from(on),
        }
    }
}

/// A pen: ink, pattern, and the character that stands for it in plain ASCII.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DotPen {
    /// Ink of the characters drawn.
    pub(crate) ink: Ink,
    /// Which dots are drawn.
    pub(crate) pattern: Pattern,
    /// The character in ASCII; `None` picks one by the height of the dots within it.
    pub(crate) ascii: Option<char>,
}

/// A grid of dots over a part of a picture.
pub(crate) struct DotGrid {
    width: usize,
    height: usize,
    glyphs: Glyphs,
    /// Dots of a character, across and down.
    resolution: (i32, i32),
    cells: Vec<Option<(u8, DotPen)>>,
}

/// Bit of each dot of a braille character, by column and row.
const BRAILLE: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

impl DotGrid {
    /// An empty grid of so many characters.
    pub(crate) fn new(width: usize, height: usize, glyphs: Glyphs) -> DotGrid {
        let resolution = match glyphs {
            Glyphs::Braille => (2, 4),
            Glyphs::Block => (1, 2),
            Glyphs::Ascii => (1, 3),
        };
        DotGrid { width, height, glyphs, resolution, cells: vec![None; width * height] }
    }

    /// An empty grid in which each character is one dot: the letter of the pen that drew it.
    pub(crate) fn letters(width: usize, height: usize) -> DotGrid {
        DotGrid { resolution: (1, 1), ..DotGrid::new(width, height, Glyphs::Ascii) }
    }

    /// Dots of the whole grid, across and down.
    pub(crate) fn dots(&self) -> (i32, i32) {
        let (x, y) = self.resolution;
        // Far fewer characters than 2^28.
        (self.width as i32 * x, self.height as i32 * y)
    }

    /// Sets a dot; (0, 0) is the top left one. Dots outside the grid are left out.
    pub(crate) fn dot(&mut self, x: i32, y: i32, pen: DotPen) {
        let (width, height) = self.dots();
        if x < 0 || y < 0 || x >= width || y >= height {
            return;
        }
        let (rx, ry) = self.resolution;
        let bit = match self.glyphs {
            Glyphs::Braille => BRAILLE[(x % rx) as usize][(y % ry) as usize],
            _ => 1 << (y % ry),
        };
        let cell = &mut self.cells[(y / ry) as usize * self.width + (x / rx) as usize];
        // The pen drawn last owns the character. Braille keeps the dots of others in it; in ASCII they
        // would pick a sign that belongs to neither.
        let bits = match cell {
            Some((_, other)) if self.glyphs == Glyphs::Ascii && *other != pen => 0,
            Some((bits, _)) => *bits,
            None => 0,
        };
        *cell = Some((bits | bit, pen));
    }

    /// Draws a line through points in dots (fractions allowed), the pattern running along it.
    pub(crate) fn line(&mut self, points: impl IntoIterator<Item = (f64, f64)>, pen: DotPen) {
        let mut count = 0;
        let mut last: Option<(f64, f64)> = None;
        for (x, y) in points {
            if !(x.is_finite() && y.is_finite()) {
                last = None;
                continue;
            }
            let Some((x0, y0)) = last.replace((x, y)) else { continue };
            let steps = (x - x0).abs().max((y - y0).abs()).ceil().clamp(1.0, 10_000.0) as i32;
            for i in 0..steps {
                let t = f64::from(i) / f64::from(steps);
                if pen.pattern.draws(count) {
                    self.dot(
                        (x0 + t * (x - x0)).floor() as i32,
                        (y0 + t * (y - y0)).floor() as i32,
                        pen,
                    );
                }
                count += 1;
            }
        }
        if let Some((x, y)) = last
            && pen.pattern.draws(count)
        {
            self.dot(x.floor() as i32, y.floor() as i32, pen);
        }
    }

    /// Puts the drawn characters into a picture, the top left one at a place; empty ones leave it as
    /// it is.
    pub(crate) fn put(&self, picture: &mut Picture, row: usize, column: usize) {
        for (i, cell) in self.cells.iter().enumerate() {
            let Some((bits, pen)) = cell else { continue };
            let sign = match self.glyphs {
                // U+2800 with eight dot bits is always a character.
                Glyphs::Braille => char::from_u32(0x2800 + u32::from(*bits)).unwrap_or(' '),
                Glyphs::Block => match bits {
                    0b01 => '▀',
                    0b10 => '▄',
                    _ => '█',
                },
                Glyphs::Ascii => pen.ascii.unwrap_or(match bits {
                    0b001 => '\'',
                    0b010 => '-',
                    0b100 => '.',
                    0b011 | 0b110 => '/',
                    _ => '|',
                }),
            };
            picture.set(row + i / self.width, column + i % self.width, sign, pen.ink);
        }
    }
}
