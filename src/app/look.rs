//! How the program looks on the terminal at hand: colours or none, and which glyphs draw curves and
//! frames. Plain settings; `term` finds the defaults, `ui` obeys them.

pub use crate::show::glyphs::Glyphs;
use crate::words::Choice;
use std::fmt;

/// What colours may be used. Nothing on the screen means anything by colour alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ColorMode {
    /// The sixteen named colours, which follow the user's own palette.
    #[default]
    Basic16,
    /// No colour: bold, underline and reverse only.
    None,
}

/// What colours the user asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ColorChoice {
    /// Sixteen colours unless `NO_COLOR` or the terminal says otherwise.
    #[default]
    Auto,
    /// Sixteen colours, whatever the surroundings say.
    Basic16,
    None,
}

/// The two together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Look {
    /// Colours.
    pub color: ColorMode,
    /// Signs that curves, bars and marks are drawn with.
    pub glyphs: Glyphs,
}

impl Choice for ColorChoice {
    const ALL: &'static [ColorChoice] =
        &[ColorChoice::Auto, ColorChoice::Basic16, ColorChoice::None];

    fn word(self) -> &'static str {
        match self {
            ColorChoice::Auto => "auto",
            ColorChoice::Basic16 => "16",
            ColorChoice::None => "none",
        }
    }
}

impl fmt::Display for ColorMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ColorMode::Basic16 => "16 colours",
            ColorMode::None => "no colour",
        })
    }
}
