//! Undo and redo: whole projects, shared where nothing changed. Project files are small, so a step
//! costs a few kilobytes at the most.

use crate::case::Input;
use crate::project::schema::Project;
use std::collections::VecDeque;
use std::sync::Arc;

/// Steps kept; older ones are forgotten.
pub(crate) const MOST_STEPS: usize = 5_000;

/// A state to come back to, with the place the user was at.
#[derive(Debug, Clone)]
pub(crate) struct HistoryStep {
    /// The project as it was.
    pub project: Arc<Project>,
    /// Index of the selected layout.
    pub selected: usize,
    /// The selected input.
    pub field: Input,
    /// What the edit did, for the status line: `L of gully`.
    pub label: String,
}

/// The past and the undone future of a project.
#[derive(Debug, Default)]
pub struct History {
    past: VecDeque<HistoryStep>,
    future: Vec<HistoryStep>,
}

impl History {
    /// Remembers the state before an edit; what was undone is forgotten.
    pub(crate) fn record(&mut self, before: HistoryStep) {
        self.future.clear();
        if self.past.len() == MOST_STEPS {
            self.past.pop_front();
        }
        self.past.push_back(before);
    }

    /// Takes one step back: gives the state to return to and keeps `now` for a redo. The label of
    /// the edit travels with it.
    pub(crate) fn undo(&mut self, now: impl FnOnce(String) -> HistoryStep) -> Option<HistoryStep> {
        let step = self.past.pop_back()?;
        self.future.push(now(step.label.clone()));
        Some(step)
    }

    /// Takes one undone step forward again.
    pub(crate) fn redo(&mut self, now: impl FnOnce(String) -> HistoryStep) -> Option<HistoryStep> {
        let step = self.future.pop()?;
        self.past.push_back(now(step.label.clone()));
        Some(step)
    }

    /// How many steps can be undone.
    pub fn undo_depth(&self) -> usize {
        self.past.len()
    }

    /// How many steps can be redone.
    pub(crate) fn redo_depth(&self) -> usize {
        self.future.len()
    }
}
