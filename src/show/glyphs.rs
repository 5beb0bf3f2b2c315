//! Sets of signs that curves, rules and bars are drawn with.

use crate::words::Choice;

/// Which characters draw curves and frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Glyphs {
    /// Braille patterns, eight dots a cell, and box drawing.
    #[default]
    Braille,
    /// Block elements and box drawing, for fonts without braille.
    Block,
    /// Nothing beyond ASCII.
    Ascii,
}

impl Glyphs {
    /// The sign that rules are drawn with.
    pub(crate) fn rule(self) -> &'static str {
        match self {
            Glyphs::Ascii => "-",
            _ => "─",
        }
    }

    /// The sign of a vertical axis.
    pub(crate) fn upright(self) -> &'static str {
        match self {
            Glyphs::Ascii => "|",
            _ => "│",
        }
    }

    /// The sign where both axes meet.
    pub(crate) fn corner(self) -> &'static str {
        match self {
            Glyphs::Ascii => "+",
            _ => "└",
        }
    }

    /// The sign of what lies above.
    pub(crate) fn up(self) -> &'static str {
        match self {
            Glyphs::Ascii => "^",
            _ => "↑",
        }
    }
}

impl Choice for Glyphs {
    const ALL: &'static [Glyphs] = &[Glyphs::Braille, Glyphs::Block, Glyphs::Ascii];

    fn word(self) -> &'static str {
        match self {
            Glyphs::Braille => "braille",
            Glyphs::Block => "block",
            Glyphs::Ascii => "ascii",
        }
    }
}
