//! Flags of the interactive program, which every subcommand takes too.

use super::choice::explained;
use crate::app::look::{ColorChoice, Glyphs};
use crate::app::settings::{SettingItem, Settings};
use crate::study::exactness::Exactness;
use crate::units::{ChosenUnits, Units};
use crate::words::Choice;
use clap::Args;

/// Flags that decide how the interactive program looks. What is missing is left to the environment
/// (`NO_COLOR` means no colour), the project and the user's settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Args)]
pub(crate) struct UiFlags {
    /// Colours of the screen; NO_COLOR in the environment means none.
    #[arg(long, global = true, value_name = "COLOURS", value_parser = explained(COLORS), help_heading = "Screen")]
    pub(crate) color: Option<ColorChoice>,
    /// Signs that curves are drawn with.
    #[arg(long, global = true, value_name = "SIGNS", value_parser = explained(GLYPHS), help_heading = "Screen")]
    pub(crate) glyphs: Option<Glyphs>,
    /// Units on the screen and in text results: m, mm, ft or in, kN, kip or t, or two as in ft,kip;
    /// files, JSON and CSV are always in metres and kN.
    #[arg(long, global = true, value_name = "UNITS", value_parser = ChosenUnits::read, help_heading = "Screen")]
    pub(crate) units: Option<ChosenUnits>,
}

impl UiFlags {
    /// The units of a result where the project has these.
    pub(crate) fn units_over(&self, project: Units) -> Units {
        self.units.unwrap_or_default().over(project)
    }
}

/// Flags of the interactive program alone: each is a setting too, and stands above the kept one for
/// this run. Subcommands have flags of their own for these.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Args)]
pub(crate) struct StartFlags {
    /// How exactly checks compute in the program.
    #[arg(long, value_name = "FIDELITY", value_parser = explained(FIDELITIES), help_heading = "Program")]
    pub(crate) fidelity: Option<Exactness>,
    /// Runs of a check in the program: auto or a number.
    #[arg(long, value_name = "N", value_parser = runs, help_heading = "Program")]
    pub(crate) runs: Option<Runs>,
    /// Start with live mode on: a quick check follows every edit.
    #[arg(long, overrides_with = "no_live", help_heading = "Program")]
    pub(crate) live: bool,
    /// Start with live mode off.
    #[arg(long, overrides_with = "live", help_heading = "Program")]
    pub(crate) no_live: bool,
    /// Start with the tour.
    #[arg(long, overrides_with = "no_tour", help_heading = "Program")]
    pub(crate) tour: bool,
    /// Start without the first-run tour.
    #[arg(long, overrides_with = "tour", help_heading = "Program")]
    pub(crate) no_tour: bool,
}

/// How many runs; none is as many as needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Runs(pub(crate) Option<usize>);

fn runs(text: &str) -> Result<Runs, String> {
    let mut settings = Settings::default();
    settings
        .set(SettingItem::Runs, text)
        .map_err(|_| format!("allowed: {}", SettingItem::Runs.allowed()))?;
    Ok(Runs(settings.runs))
}

/// What each fidelity means; the reference is for comparing the others with it.
const FIDELITIES: &[(Exactness, &str)] = &[
    (Exactness::Auto, "Quick runs, as slow as it takes for a mean known to 1 %"),
    (Exactness::Quick, "Errors within 3 %"),
    (Exactness::Standard, "Errors within 1 %"),
    (Exactness::Fine, "Errors within 0.2 %"),
];

/// What each choice of colours means.
const COLORS: &[(ColorChoice, &str)] = &[
    (ColorChoice::Auto, "What the terminal can show"),
    (ColorChoice::Basic16, "The sixteen named colours at most"),
    (ColorChoice::None, "No colour"),
];

/// What each set of signs is.
const GLYPHS: &[(Glyphs, &str)] = &[
    (Glyphs::Braille, "Braille dots, two by four a character"),
    (Glyphs::Block, "Block characters"),
    (Glyphs::Ascii, "Plain ASCII"),
];

impl StartFlags {
    /// Whether any of them was given.
    pub(crate) fn any(&self) -> bool {
        *self != StartFlags::default()
    }
}

/// The flags of this run as settings with their words.
pub(crate) fn settings(ui: &UiFlags, start: &StartFlags) -> Vec<(SettingItem, String)> {
    fn word<T: Choice>(choice: T) -> String {
        choice.word().to_string()
    }
    let switch = |on: bool, off: bool, words: [&str; 2]| match (on, off) {
        (true, _) => Some(words[0].to_string()),
        (_, true) => Some(words[1].to_string()),
        _ => None,
    };
    [
        (SettingItem::Units, ui.units.and_then(|u| u.length).map(word)),
        (SettingItem::Forces, ui.units.and_then(|u| u.force).map(word)),
        (SettingItem::Glyphs, ui.glyphs.map(word)),
        (SettingItem::Color, ui.color.map(word)),
        (SettingItem::Fidelity, start.fidelity.map(word)),
        (SettingItem::Runs, start.runs.map(|r| r.0.map_or("auto".into(), |n| n.to_string()))),
        (SettingItem::Live, switch(start.live, start.no_live, ["on", "off"])),
        (SettingItem::Tour, switch(start.tour, start.no_tour, ["due", "seen"])),
    ]
    .into_iter()
    .filter_map(|(item, word)| Some((item, word?)))
    .collect()
}
