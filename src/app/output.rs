//! Writing reports, charts and tables to files: the list to choose from, and the `:export` command.

use super::message::{Command, Exported};
use super::{App, Mode};
use crate::export::ExportKind;
use std::path::PathBuf;

impl App {
    /// The marked kind of the list is written beside the project, under a name that is free.
    pub(super) fn take_export(&mut self) -> Vec<Command> {
        let Mode::Export { index } = *self.screen.mode() else { return Vec::new() };
        self.screen.show(Mode::Main);
        match ExportKind::ALL.get(index) {
            Some(kind) => self.export(*kind, None, false),
            None => Vec::new(),
        }
    }

    fn export(&mut self, kind: ExportKind, path: Option<PathBuf>, overwrite: bool) -> Vec<Command> {
        if self.opening_holds() {
            return Vec::new();
        }
        vec![Command::Export {
            kind,
            project: self.project().clone(),
            edited: self.edited(),
            layout: self.selected(),
            unit: self.units(),
            path,
            overwrite,
        }]
    }

    /// The `export` command: `export`, `export report`, `export chart portal.svg`.
    ///
    /// # Errors
    /// What there is to write.
    pub(super) fn export_command(
        &mut self,
        rest: &str,
        overwrite: bool,
    ) -> Result<Vec<Command>, String> {
        let (word, path) = match rest.split_once(char::is_whitespace) {
            Some((word, path)) => (word, path.trim()),
            None => (rest, ""),
        };
        if word.is_empty() {
            self.screen.show(Mode::Export { index: 0 });
            return Ok(Vec::new());
        }
        let Some(kind) = ExportKind::named(word) else {
            let words: Vec<&str> = ExportKind::ALL.iter().map(|kind| kind.word()).collect();
            return Err(format!("export one of: {}", words.join(", ")));
        };
        let path = (!path.is_empty()).then(|| PathBuf::from(path));
        Ok(self.export(kind, path, overwrite))
    }

    /// A file was written, or not.
    pub(super) fn exported(&mut self, result: Result<Exported, String>) {
        match result {
            Ok(Exported { path, note }) => {
                let note = note.map_or(String::new(), |note| format!("; {note}"));
                self.inform(format!("written: {}{note}", path.display()));
            }
            Err(why) => self.complain(why),
        }
    }
}
