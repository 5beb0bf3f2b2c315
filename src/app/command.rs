//! The `:` line. Its forms stand in [`super::keymap::COMMANDS`], from which the help is made.

use super::App;
use super::editor::GridKind;
use super::look::{ColorMode, Glyphs};
use super::message::Command;
use crate::layout::{PunchShape, Twists};
use crate::study::verdict::Basis;
use crate::units::ChosenUnits;
use crate::words::Choice;
use std::path::{Path, PathBuf};

impl App {
    /// Carries out a command.
    ///
    /// # Errors
    /// Why it cannot be done; the text stays in the line then.
    pub(super) fn command(&mut self, text: &str) -> Result<Vec<Command>, String> {
        let text = text.trim();
        let (word, rest) = match text.split_once(char::is_whitespace) {
            Some((word, rest)) => (word, rest.trim()),
            None => (text, ""),
        };
        // A command that takes nothing must be given nothing: a slip is no reason to act.
        let plain = |allowed: &[&str]| allowed.contains(&word) && !rest.is_empty();
        if plain(&["wq", "x", "q", "q!", "undo", "redo", "help", "h", "tour", "own", "reload"]) {
            return Err(format!("{word} takes nothing after it"));
        }
        match word {
            "" => {}
            "w" | "write" => return Ok(self.save(path_of(rest), false)),
            "w!" => return Ok(self.save(path_of(rest), true)),
            "own" => return Ok(self.take_file()),
            "reload" => return Ok(self.reload()),
            "wq" | "x" => return Ok(self.save_and_quit()),
            "q" | "quit" => return Ok(self.ask_to_quit()),
            "q!" => return Ok(self.quit(Some(self.project().clone()))),
            "export" => return self.export_command(rest, false),
            "export!" => return self.export_command(rest, true),
            "check" => match rest {
                "" => return Ok(self.start_check(false)),
                "all" => return Ok(self.start_check(true)),
                _ => return Err("check, or check all".into()),
            },
            "method" => return self.method_command(rest),
            "campaign" => return self.campaign_command(rest),
            "fidelity" | "runs" | "live" => return self.set_command(text),
            "undo" => self.undo(),
            "redo" => self.redo(),
            "help" | "h" => self.screen.toggle_help(),
            "name" | "site" | "client" | "author" | "checker" | "revision" | "date" => {
                self.editor.name_project(word, rest)?;
            }
            "basis" => {
                let basis = Basis::from_word(rest).ok_or("basis mean or basis characteristic")?;
                let said = self.editor.set_basis(basis);
                self.inform(said);
            }
            "mesh" => self.editor.set_mesh(rest)?,
            "grid" => {
                let kind = GridKind::from_word(rest)
                    .ok_or("grid square, grid rectangular or grid staggered")?;
                let said = self.editor.set_grid(kind);
                self.inform(said);
            }
            "twists" => {
                let twists = Twists::from_word(rest).ok_or("twists down or twists across")?;
                let said = self.editor.set_twists(twists);
                self.inform(said);
            }
            "shape" => {
                let shape =
                    PunchShape::from_word(rest).ok_or("shape dome, shape sphere or shape flat")?;
                let said = self.editor.set_shape(shape);
                self.inform(said);
            }
            "units" => {
                let chosen = ChosenUnits::read(rest).map_err(|e| format!("units: {e}"))?;
                self.editor.set_units(chosen);
            }
            "glyphs" => match rest {
                "braille" => self.screen.set_glyphs(Glyphs::Braille),
                "block" => self.screen.set_glyphs(Glyphs::Block),
                "ascii" => self.screen.set_glyphs(Glyphs::Ascii),
                _ => return Err("glyphs braille, block or ascii".into()),
            },
            "color" | "colour" => match rest {
                "16" => self.screen.set_color(ColorMode::Basic16),
                "none" => self.screen.set_color(ColorMode::None),
                _ => return Err("color 16 or color none".into()),
            },
            "tour" => self.start_tour(),
            "open" | "e" if rest.is_empty() => return Ok(self.show_picker(None)),
            "open" | "e" => return Ok(self.ask_to_open(Path::new(rest))),
            "set" => return self.set_command(rest),
            _ => match word.parse::<usize>() {
                Ok(n) if rest.is_empty() && (1..=self.editor.layouts().len()).contains(&n) => {
                    self.editor.select(n - 1);
                }
                Ok(_) if self.editor.empty() => return Err(super::editor::NONE.into()),
                Ok(_) => return Err(format!("layouts are 1 to {}", self.editor.layouts().len())),
                Err(_) => return Err(format!("no command {word:?}; ? lists them")),
            },
        }
        Ok(Vec::new())
    }
}

fn path_of(text: &str) -> Option<PathBuf> {
    (!text.is_empty()).then(|| PathBuf::from(text))
}
