//! What the screen may be made of: colours and signs. Chosen from flags, environment and the user.

/// Colours the terminal may be sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ColorMode {
    /// The sixteen named colours.
    #[default]
    Basic16,
    /// None: bold, reverse and underline only.
    None,
}

/// Signs that curves and frames are drawn with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Glyphs {
    /// Braille dots, 2 x 4 to a character.
    #[default]
    Braille,
    /// Half blocks, 1 x 2 to a character.
    Block,
    /// Plain ASCII, frames included.
    Ascii,
}

/// The look of the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Look {
    /// Colours.
    pub color: ColorMode,
    /// Signs.
    pub glyphs: Glyphs,
}
