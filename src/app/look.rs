//! How the program looks on the terminal at hand: colours or none, and which glyphs draw curves and
//! frames. Plain settings; `term` finds the defaults, `ui` obeys them.

pub use crate::show::glyphs::Glyphs;
use std::fmt;
use std::str::FromStr;

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
    /// None.
    None,
}

/// The two together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Look {
    /// Colours.
    pub color: ColorMode,
    /// Glyphs.
    pub glyphs: Glyphs,
}

/// A word that names no choice; the message lists those there are.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("'{given}' is none of {allowed}")]
pub struct UnknownLook {
    /// What was given.
    pub(crate) given: String,
    /// What would have done.
    pub(crate) allowed: &'static str,
}

impl FromStr for ColorChoice {
    type Err = UnknownLook;

    fn from_str(word: &str) -> Result<Self, UnknownLook> {
        match word {
            "auto" => Ok(ColorChoice::Auto),
            "16" => Ok(ColorChoice::Basic16),
            "none" => Ok(ColorChoice::None),
            _ => Err(UnknownLook { given: word.to_owned(), allowed: "auto, 16, none" }),
        }
    }
}

impl FromStr for Glyphs {
    type Err = UnknownLook;

    fn from_str(word: &str) -> Result<Self, UnknownLook> {
        match word {
            "braille" => Ok(Glyphs::Braille),
            "block" => Ok(Glyphs::Block),
            "ascii" => Ok(Glyphs::Ascii),
            _ => Err(UnknownLook { given: word.to_owned(), allowed: "braille, block, ascii" }),
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
