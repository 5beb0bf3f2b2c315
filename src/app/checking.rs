//! What keys and commands ask of the work behind the screen.

use super::App;
use super::message::Command;
use super::settings::SettingItem;

impl App {
    /// Orders the check of the selected layout, or of all.
    pub(super) fn start_check(&mut self, all: bool) -> Vec<Command> {
        match self.work.start_check(&self.editor, all, self.choices.wanted()) {
            Ok(order) => vec![order],
            Err(why) => {
                self.complain(why);
                Vec::new()
            }
        }
    }

    /// Ends what runs.
    pub(super) fn stop_work(&mut self) -> Vec<Command> {
        let (stop, said) = self.work.stop();
        if let Some(said) = said {
            self.screen.say(said);
        }
        stop.into_iter().collect()
    }

    /// Switches live mode.
    pub(super) fn toggle_live(&mut self) -> Vec<Command> {
        let on = !self.settings().live;
        let commands = self.choose(SettingItem::Live, if on { "on" } else { "off" });
        self.inform(match on {
            true => "live: a quick check follows each edit; l switches it off",
            false => "live mode off",
        });
        commands
    }

    /// Takes the next fidelity.
    pub(super) fn next_fidelity(&mut self) -> Vec<Command> {
        let word = self.settings().neighbour(SettingItem::Fidelity, true);
        let commands = self.choose(SettingItem::Fidelity, word);
        self.inform(format!("checks are {word}: {}", self.settings().fidelity.about()));
        commands
    }
}
