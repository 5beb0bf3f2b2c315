//! The settings of a session: what is kept, what flags lay over it, and the changes the user makes.

use super::super::look::{ColorChoice, ColorMode, Look};
use super::{SettingItem, Settings};
use crate::study::result::Wanted;
use std::path::PathBuf;

/// What a session knows of settings when it starts.
#[derive(Debug, Clone, Default)]
pub struct Preferences {
    /// What the file of settings says, or the defaults.
    pub kept: Settings,
    /// Flags of this run with their words; they stand above the file and are never kept.
    pub flags: Vec<(SettingItem, String)>,
    /// Colours and glyphs where neither a flag nor a setting says otherwise.
    pub auto: Look,
    /// The file of settings, for people; none where there is no place for one.
    pub file: Option<PathBuf>,
    /// What is wrong with the file of settings, in full; defaults hold then.
    pub trouble: Option<String>,
    /// Whether to start with the tour.
    pub tour: bool,
}

impl Preferences {
    /// What holds in this session: the kept settings with the flags laid over them.
    pub fn effective(&self) -> Settings {
        let mut settings = self.kept.clone();
        for (item, word) in &self.flags {
            // A flag's word was checked where the command line was read.
            let _ = settings.set(*item, word);
        }
        settings
    }

    /// Whether a flag of this run decides a setting.
    pub fn is_flag(&self, item: SettingItem) -> bool {
        self.flags.iter().any(|(flag, _)| *flag == item)
    }

    /// Colours and glyphs that settings lead to.
    pub fn look(&self, settings: &Settings) -> Look {
        Look {
            color: match settings.color {
                ColorChoice::Auto => self.auto.color,
                ColorChoice::Basic16 => ColorMode::Basic16,
                ColorChoice::None => ColorMode::None,
            },
            glyphs: settings.glyphs.unwrap_or(self.auto.glyphs),
        }
    }
}

/// The settings' part of the state: where they come from, and what holds.
#[derive(Debug)]
pub(in crate::app) struct Choices {
    preferences: Preferences,
    /// What holds: what is kept, with the flags of this run over it.
    settings: Settings,
}

impl Choices {
    /// The settings of a session.
    pub(in crate::app) fn new(preferences: Preferences) -> Choices {
        Choices { settings: preferences.effective(), preferences }
    }

    /// The settings that hold.
    pub(in crate::app) fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Where they come from.
    pub(in crate::app) fn preferences(&self) -> &Preferences {
        &self.preferences
    }

    /// Colours and glyphs that they lead to.
    pub(in crate::app) fn look(&self) -> Look {
        self.preferences.look(&self.settings)
    }

    /// What a check is asked for.
    pub(in crate::app) fn wanted(&self) -> Wanted {
        Wanted { fidelity: self.settings.fidelity, runs: self.settings.runs, seed: 0 }
    }

    /// Changes a setting for this session and the next ones; a flag of this run gives way. What is to
    /// be kept now.
    ///
    /// # Errors
    /// The words there are.
    pub(in crate::app) fn set(
        &mut self,
        item: SettingItem,
        word: &str,
    ) -> Result<Settings, String> {
        self.preferences.kept.set(item, word)?;
        self.preferences.flags.retain(|(flag, _)| *flag != item);
        self.settings = self.preferences.effective();
        Ok(self.preferences.kept.clone())
    }
}
