//! Looking for a text in a page, or for a layout by a part of its name.

use super::keymap::StudyPage;
use super::{App, Mode};
use crate::export::ExportKind;
use crate::mesh::MeshType;

impl App {
    /// Goes to the next place of a text in what is shown, round and round; an empty text is the last one.
    pub(super) fn find(&mut self, text: &str) {
        let sought = self.screen.sought(text).to_lowercase();
        if sought.is_empty() {
            return self.inform("nothing to find yet: / and a text");
        }
        let holds = |line: &str| line.to_lowercase().contains(&sought);
        let found = match self.screen.mode() {
            Mode::Help { .. } | Mode::Details { .. } => {
                let lines = self.page_lines();
                let hits: Vec<bool> = lines.iter().map(|line| holds(&line.text)).collect();
                let first = self.screen.first_line();
                after(first, &hits).inspect(|line| {
                    let last = lines.len().saturating_sub(self.screen.page_lines());
                    self.screen.scroll(*line as isize - first as isize, last);
                })
            }
            Mode::Main | Mode::Study(StudyPage::Compare) => {
                let layouts = &self.project().layouts;
                let hits: Vec<bool> = layouts.iter().map(|layout| holds(&layout.name)).collect();
                let compare = matches!(self.screen.mode(), Mode::Study(_));
                let now =
                    if compare { self.studies.compare().marked() } else { self.editor.selected() };
                after(now, &hits).inspect(|index| match compare {
                    true => self.studies.mark_compared(*index),
                    false => self.editor.select(*index),
                })
            }
            Mode::MeshPicker { index } => {
                let here = |mesh: &MeshType| holds(&mesh.id) || holds(mesh.title());
                let hits: Vec<bool> = self.meshes().iter().map(|c| here(&c.mesh)).collect();
                let now = *index;
                after(now, &hits).inspect(|at| {
                    self.screen.turn(*at as isize - now as isize, hits.len());
                })
            }
            Mode::Export { index } => {
                let here = |k: &ExportKind| holds(k.word()) || holds(k.about());
                let hits: Vec<bool> = ExportKind::ALL.iter().map(here).collect();
                let now = *index;
                after(now, &hits).inspect(|at| {
                    self.screen.turn(*at as isize - now as isize, hits.len());
                })
            }
            _ => return,
        };
        if found.is_none() {
            self.inform(format!("{sought:?} is not here"));
        }
    }
}

/// The next true one behind a place, round and round.
fn after(now: usize, hits: &[bool]) -> Option<usize> {
    let count = hits.len();
    (1..=count).map(|step| (now + step) % count).find(|at| hits[*at])
}
