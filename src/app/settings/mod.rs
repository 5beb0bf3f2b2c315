//! The user's settings: what they are, the words that name their values, and how they are changed.
//! Reading and writing the file is the business of [`crate::project::settings`].
//!
//! A flag of this run stands above the file of settings, that above the project (which only knows a
//! unit), and that above the default.

mod changes;
pub(crate) mod preferences;

pub use preferences::Preferences;

use super::look::{ColorChoice, Glyphs};
use crate::study::exactness::Exactness;
use crate::units::{ChosenUnits, ForceUnit, LengthUnit};
use crate::words::{Choice, words_of};

/// Most runs of a check that can be asked for.
pub(crate) const MOST_RUNS: usize = 10_000;

/// What the user decided for all projects.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    /// Unit of lengths; the project's own where nothing is said.
    pub units: Option<LengthUnit>,
    /// Unit of forces; nothing for the project's.
    pub forces: Option<ForceUnit>,
    /// Signs that charts are drawn with; what suits the terminal where nothing is said.
    pub glyphs: Option<Glyphs>,
    /// Colours.
    pub color: ColorChoice,
    /// How exactly a check computes.
    pub fidelity: Exactness,
    /// Runs of a check, 1 to [`MOST_RUNS`]; as many as needed where nothing is said.
    pub runs: Option<usize>,
    /// Whether a quick check follows every edit.
    pub live: bool,
    /// Whether the first-run tour was seen.
    pub tour_seen: bool,
}

/// The rows of the list of settings, which `:set` names too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SettingItem {
    /// Unit of lengths.
    Units,
    /// Unit of forces.
    Forces,
    /// Signs of charts.
    Glyphs,
    /// Colours.
    Color,
    /// How exactly a check computes.
    Fidelity,
    /// Runs of a check.
    Runs,
    /// Whether a quick check follows every edit.
    Live,
    /// Whether the tour was seen.
    Tour,
}

/// Numbers of runs that the arrows step through; others can be typed.
const STEPS: [&str; 8] = ["auto", "1", "2", "4", "8", "16", "32", "64"];

impl SettingItem {
    /// All settings, in the order of the screen and of the file.
    pub(crate) const ALL: [SettingItem; 8] = [
        SettingItem::Units,
        SettingItem::Forces,
        SettingItem::Glyphs,
        SettingItem::Color,
        SettingItem::Fidelity,
        SettingItem::Runs,
        SettingItem::Live,
        SettingItem::Tour,
    ];

    /// The name in the file, on the command line and on the screen.
    pub(crate) fn name(self) -> &'static str {
        match self {
            SettingItem::Units => "units",
            SettingItem::Forces => "forces",
            SettingItem::Glyphs => "glyphs",
            SettingItem::Color => "color",
            SettingItem::Fidelity => "fidelity",
            SettingItem::Runs => "runs",
            SettingItem::Live => "live",
            SettingItem::Tour => "tour",
        }
    }

    /// The setting of a name.
    pub(crate) fn named(name: &str) -> Option<SettingItem> {
        let name = if name == "colour" { "color" } else { name };
        SettingItem::ALL.into_iter().find(|item| item.name() == name)
    }

    /// What it is, in a few words.
    pub(crate) fn about(self) -> &'static str {
        match self {
            SettingItem::Units => "lengths: as the project says, m, mm, ft or in",
            SettingItem::Forces => "forces: as the project says, kN, kip or t",
            SettingItem::Glyphs => "signs that charts are drawn with",
            SettingItem::Color => "colours: what the terminal takes, 16 or none",
            SettingItem::Fidelity => "how exactly a check by simulation computes",
            SettingItem::Runs => "runs of a check; auto: 4 to 64, as needed",
            SettingItem::Live => "a quick check follows every edit",
            SettingItem::Tour => "the first-run tour; :tour shows it now",
        }
    }

    /// Its words, in the order in which the arrows go through them.
    fn words(self) -> Vec<&'static str> {
        let or = |first, others: Vec<&'static str>| [vec![first], others].concat();
        match self {
            SettingItem::Units => or("project", words_of(LengthUnit::ALL)),
            SettingItem::Forces => or("project", words_of(ForceUnit::ALL)),
            SettingItem::Glyphs => or("auto", words_of(Glyphs::ALL)),
            SettingItem::Color => words_of(ColorChoice::ALL),
            SettingItem::Fidelity => words_of(&Exactness::USUAL),
            SettingItem::Runs => STEPS.to_vec(),
            SettingItem::Live => vec!["off", "on"],
            SettingItem::Tour => vec!["due", "seen"],
        }
    }

    /// What it may be, for messages.
    pub(crate) fn allowed(self) -> String {
        match self {
            SettingItem::Runs => format!("auto or 1 to {MOST_RUNS}"),
            _ => self.words().join(", "),
        }
    }

    /// Whether a word is one of its values.
    pub(crate) fn takes(self, word: &str) -> bool {
        Settings::default().set(self, word).is_ok()
    }
}

impl Settings {
    /// The units shown whatever a project has.
    pub fn chosen_units(&self) -> ChosenUnits {
        ChosenUnits { length: self.units, force: self.forces }
    }

    /// The word for a setting's value.
    pub(crate) fn word(&self, item: SettingItem) -> String {
        match item {
            SettingItem::Units => self.units.map_or("project", LengthUnit::symbol).to_string(),
            SettingItem::Forces => self.forces.map_or("project", ForceUnit::symbol).to_string(),
            SettingItem::Glyphs => self.glyphs.map_or("auto", Glyphs::word).to_string(),
            SettingItem::Color => self.color.word().to_string(),
            SettingItem::Fidelity => self.fidelity.word().to_string(),
            SettingItem::Runs => self.runs.map_or("auto".to_string(), |n| n.to_string()),
            SettingItem::Live => if self.live { "on" } else { "off" }.to_string(),
            SettingItem::Tour => if self.tour_seen { "seen" } else { "due" }.to_string(),
        }
    }

    /// Gives a setting the value of a word.
    ///
    /// # Errors
    /// The words there are.
    pub(crate) fn set(&mut self, item: SettingItem, word: &str) -> Result<(), String> {
        let refusal = || format!("{}: {}", item.name(), item.allowed());
        // Runs take any number; all else takes a word of the list.
        if item != SettingItem::Runs && !item.words().contains(&word) {
            return Err(refusal());
        }
        match item {
            // The first word of these three stands for none of them.
            SettingItem::Units => self.units = LengthUnit::from_word(word),
            SettingItem::Forces => self.forces = ForceUnit::from_word(word),
            SettingItem::Glyphs => self.glyphs = Glyphs::from_word(word),
            SettingItem::Color => {
                self.color = ColorChoice::from_word(word).ok_or_else(refusal)?;
            }
            SettingItem::Fidelity => {
                self.fidelity = Exactness::from_word(word).ok_or_else(refusal)?;
            }
            SettingItem::Runs if word == "auto" => self.runs = None,
            SettingItem::Runs => match word.parse() {
                Ok(n) if (1..=MOST_RUNS).contains(&n) => self.runs = Some(n),
                _ => return Err(refusal()),
            },
            SettingItem::Live => self.live = word == "on",
            SettingItem::Tour => self.tour_seen = word == "seen",
        }
        Ok(())
    }

    /// The word after or before the present one; round and round. A number of runs between two
    /// steps goes on from where it would stand.
    pub(crate) fn neighbour(&self, item: SettingItem, forward: bool) -> &'static str {
        let words = item.words();
        let now = self.word(item);
        let at = words.iter().position(|w| *w == now);
        let count = words.len();
        let next = match (at, self.runs) {
            (Some(at), _) => (at + if forward { 1 } else { count - 1 }) % count,
            (None, Some(runs)) => {
                let above = words.iter().position(|w| w.parse().is_ok_and(|n: usize| n > runs));
                match (above, forward) {
                    (Some(above), true) => above,
                    (Some(above), false) => above - 1,
                    (None, true) => 0,
                    (None, false) => count - 1,
                }
            }
            (None, None) => 0,
        };
        words[next]
    }

    /// Every setting with its word, in the order of the file.
    pub(crate) fn to_words(&self) -> Vec<(SettingItem, String)> {
        SettingItem::ALL.into_iter().map(|item| (item, self.word(item))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_taken_and_comes_back() {
        for item in SettingItem::ALL {
            assert_eq!(SettingItem::named(item.name()), Some(item));
            for word in item.words() {
                let mut settings = Settings::default();
                settings.set(item, word).unwrap();
                assert_eq!(settings.word(item), *word);
            }
            assert!(!item.takes("nonsense"), "{item:?}");
            // The default is one of the words.
            assert!(item.words().contains(&Settings::default().word(item).as_str()));
        }
        for word in ["0", "10001", "-1", "1.5", ""] {
            assert!(!SettingItem::Runs.takes(word), "{word}");
        }
        assert!(SettingItem::Runs.takes("12"));
        assert!(!SettingItem::Fidelity.takes("reference"));
    }

    #[test]
    fn arrows_go_round() {
        for item in SettingItem::ALL {
            let mut settings = Settings::default();
            let start = settings.word(item);
            for forward in [true, false] {
                for _ in 0..item.words().len() {
                    let next = settings.neighbour(item, forward);
                    settings.set(item, next).unwrap();
                }
                assert_eq!(settings.word(item), start, "{item:?}");
            }
        }
        let typed = Settings { runs: Some(12), ..Settings::default() };
        assert_eq!(typed.neighbour(SettingItem::Runs, true), "16");
        assert_eq!(typed.neighbour(SettingItem::Runs, false), "8");
        let many = Settings { runs: Some(500), ..Settings::default() };
        assert_eq!(many.neighbour(SettingItem::Runs, true), "auto");
        assert_eq!(many.neighbour(SettingItem::Runs, false), "64");
    }
}
