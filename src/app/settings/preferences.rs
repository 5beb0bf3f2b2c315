//! The settings of a session: what is kept, what flags lay over it, and the changes the user makes.

use super::super::look::{ColorChoice, ColorMode, Look};
use super::super::message::Command;
use super::super::{App, Mode};
use super::{SettingItem, Settings};
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

impl App {
    /// The settings that hold in this session, flags included.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Where the settings come from.
    pub fn preferences(&self) -> &Preferences {
        &self.preferences
    }

    /// Changes a setting for this session and the next ones; a flag of this run gives way.
    ///
    /// # Errors
    /// The words there are.
    pub(in crate::app) fn set_setting(
        &mut self,
        item: SettingItem,
        word: &str,
    ) -> Result<Vec<Command>, String> {
        self.preferences.kept.set(item, word)?;
        self.preferences.flags.retain(|(flag, _)| *flag != item);
        self.settings = self.preferences.effective();
        match item {
            SettingItem::Units => self.units = self.settings.units,
            SettingItem::Glyphs => self.look.glyphs = self.preferences.look(&self.settings).glyphs,
            SettingItem::Color => self.look.color = self.preferences.look(&self.settings).color,
            SettingItem::Fidelity | SettingItem::Runs | SettingItem::Live | SettingItem::Tour => {}
        }
        let mut effects = vec![Command::KeepSettings { settings: self.preferences.kept.clone() }];
        if item == SettingItem::Live && !self.settings.live {
            effects.extend(self.end_live());
        }
        Ok(effects)
    }

    /// The marked setting's next or previous word.
    pub(in crate::app) fn change_marked_setting(&mut self, forward: bool) -> Vec<Command> {
        let Mode::Settings { index } = self.mode else { return Vec::new() };
        let Some(item) = SettingItem::ALL.get(index).copied() else { return Vec::new() };
        let word = self.settings.neighbour(item, forward);
        // The word is one of the list, so it is taken.
        self.set_setting(item, word).unwrap_or_default()
    }

    /// The `set` command: the list of settings, or one of them at once.
    ///
    /// # Errors
    /// The settings there are, or the words of one.
    pub(in crate::app) fn set_command(&mut self, text: &str) -> Result<Vec<Command>, String> {
        let (name, word) = match text.split_once([' ', '=']) {
            Some((name, word)) => (name.trim(), word.trim()),
            None => (text, ""),
        };
        if name.is_empty() {
            self.mode = Mode::Settings { index: 0 };
            return Ok(Vec::new());
        }
        let Some(item) = SettingItem::named(name) else {
            let names: Vec<&str> = SettingItem::ALL.iter().map(|item| item.name()).collect();
            return Err(format!("settings: {}", names.join(", ")));
        };
        let effects = self.set_setting(item, word)?;
        self.inform(format!("{name} {word}, for this and the next sessions"));
        Ok(effects)
    }
}
