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
    /// What further edits belong to the same step.
    pub run: Run,
}

/// Edits that are undone together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Run {
    /// The edit is alone.
    Alone,
    /// Steps of an input of a layout, by its number, one way: a key held down.
    Steps(u64, Input, bool),
    /// Checks that came in one after the other, of layouts by their numbers.
    Checks(Vec<u64>),
}

impl Run {
    /// Takes another edit in, if it belongs here.
    fn takes(&mut self, other: &Run) -> bool {
        match (self, other) {
            (Run::Checks(these), Run::Checks(more)) => {
                these.extend(more);
                true
            }
            (Run::Steps(uid, input, up), Run::Steps(layout, of, way)) => {
                (*uid, *input, *up) == (*layout, *of, *way)
            }
            _ => false,
        }
    }

    /// Whether it is a check of a layout.
    pub(crate) fn checks(&self, uid: u64) -> bool {
        matches!(self, Run::Checks(layouts) if layouts.contains(&uid))
    }
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
        let undone = !self.future.is_empty();
        self.future.clear();
        if let Some(last) = self.past.back_mut()
            && !undone
            && last.run.takes(&before.run)
        {
            if let Run::Checks(layouts) = &last.run {
                last.label = format!("checks of {} layouts", layouts.len());
            }
            return;
        }
        if self.past.len() == MOST_STEPS {
            self.past.pop_front();
        }
        self.past.push_back(before);
    }

    /// Takes one step back: gives the state to return to and keeps `now` for a redo. The label of
    /// the edit travels with it.
    pub(crate) fn undo(&mut self, now: impl FnOnce(String) -> HistoryStep) -> Option<HistoryStep> {
        let step = self.past.pop_back()?;
        self.future.push(HistoryStep { run: step.run.clone(), ..now(step.label.clone()) });
        Some(step)
    }

    /// Takes one undone step forward again.
    pub(crate) fn redo(&mut self, now: impl FnOnce(String) -> HistoryStep) -> Option<HistoryStep> {
        let step = self.future.pop()?;
        self.past.push_back(HistoryStep { run: step.run.clone(), ..now(step.label.clone()) });
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
