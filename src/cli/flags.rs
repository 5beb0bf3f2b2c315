//! Flags of the interactive program, which every subcommand takes too.

use crate::units::LengthUnit;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

/// Flags that decide how the interactive program looks. What is missing is left to the environment
/// (`NO_COLOR` means no colour), the project and the user's settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Args)]
pub struct UiFlags {
    /// Colours of the screen; NO_COLOR in the environment means none.
    #[arg(long, global = true, value_enum, value_name = "COLOURS", help_heading = "Screen")]
    pub color: Option<ColorFlag>,
    /// Signs that curves are drawn with.
    #[arg(long, global = true, value_enum, value_name = "SIGNS", help_heading = "Screen")]
    pub glyphs: Option<GlyphFlag>,
    /// Unit of lengths on the screen and in text results; files, JSON and CSV are always in metres.
    #[arg(long, global = true, value_name = "UNIT", value_parser = length_unit(), help_heading = "Screen")]
    pub units: Option<LengthUnit>,
}

/// Which colours to use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum ColorFlag {
    /// What the terminal can show.
    Auto,
    /// The sixteen named colours at most.
    #[value(name = "16")]
    Sixteen,
    /// No colour.
    None,
}

/// Which signs to draw curves with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum GlyphFlag {
    /// Braille dots, two by four a character.
    Braille,
    /// Block characters.
    Block,
    /// Plain ASCII.
    Ascii,
}

fn length_unit() -> impl TypedValueParser<Value = LengthUnit> {
    PossibleValuesParser::new([LengthUnit::Metre.symbol(), LengthUnit::Millimetre.symbol()]).map(
        |word| {
            if word == LengthUnit::Millimetre.symbol() {
                LengthUnit::Millimetre
            } else {
                LengthUnit::Metre
            }
        },
    )
}
