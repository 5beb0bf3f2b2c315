//! The changes that the user makes to settings, and what follows from them.

use super::super::message::Command;
use super::super::{App, Mode};
use super::SettingItem;

impl App {
    /// Changes a setting for this session and the next ones; a flag of this run gives way.
    ///
    /// # Errors
    /// The words there are.
    fn set_setting(&mut self, item: SettingItem, word: &str) -> Result<Vec<Command>, String> {
        let settings = self.choices.set(item, word)?;
        let mut commands = vec![Command::KeepSettings { changed: item, settings }];
        match item {
            SettingItem::Units | SettingItem::Forces => {
                self.editor.show_units(self.settings().chosen_units());
            }
            SettingItem::Glyphs => self.screen.set_glyphs(self.choices.look().glyphs),
            SettingItem::Color => self.screen.set_color(self.choices.look().color),
            SettingItem::Live if !self.settings().live => commands.extend(self.work.end_live()),
            SettingItem::Live | SettingItem::Fidelity | SettingItem::Runs | SettingItem::Tour => {}
        }
        Ok(commands)
    }

    /// Changes a setting to one of its own words.
    pub(in crate::app) fn choose(&mut self, item: SettingItem, word: &str) -> Vec<Command> {
        self.set_setting(item, word).unwrap_or_else(|refusal| {
            self.complain(refusal);
            Vec::new()
        })
    }

    /// The marked setting's next or previous word.
    pub(in crate::app) fn change_marked_setting(&mut self, forward: bool) -> Vec<Command> {
        let Mode::Settings { index } = *self.screen.mode() else { return Vec::new() };
        let Some(item) = SettingItem::ALL.get(index).copied() else { return Vec::new() };
        self.choose(item, self.settings().neighbour(item, forward))
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
            self.screen.show(Mode::Settings { index: 0 });
            return Ok(Vec::new());
        }
        let Some(item) = SettingItem::named(name) else {
            let names: Vec<&str> = SettingItem::ALL.iter().map(|item| item.name()).collect();
            return Err(format!("settings: {}", names.join(", ")));
        };
        let commands = self.set_setting(item, word)?;
        self.inform(format!("{name} {word}, for this and the next sessions"));
        Ok(commands)
    }
}
