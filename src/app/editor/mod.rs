//! The project being edited: what stands in it, what follows from it, what can be undone, and which
//! layout and input are selected.
//!
//! [`layouts`] has the edits of a layout and of the list of layouts, [`history`] undo and redo.

mod history;
mod layouts;

pub(super) use history::History;
pub(super) use layouts::{GridKind, MeshChoice};

use super::derived::{self, LayoutResult};
use crate::case::{Case, Input};
use crate::layout;
use crate::mesh::{MeshType, REFERENCE_ID};
use crate::problem::Problem;
use crate::project::schema::{NamedLayout, Project};
use crate::study::result::CheckResult;
use crate::units::{ChosenUnits, Units};
use history::{HistoryStep, Run};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is said where a layout is asked for and the project has none.
pub(super) const NONE: &str = "this project has no layouts yet; a adds one";

/// The editor's part of the state.
#[derive(Debug)]
pub(super) struct Editor {
    project: Arc<Project>,
    saved: Arc<Project>,
    path: Option<PathBuf>,
    history: History,
    selected: usize,
    field: Input,
    results: Vec<LayoutResult>,
    /// What stands for the selected layout of a project without layouts; never shown.
    stand_in: (NamedLayout, LayoutResult),
    /// A unit asked for beside the project: it is not the project's and never saved.
    units: ChosenUnits,
    /// Meshes of the user's own, which a project that takes one holds itself.
    own: Vec<Arc<MeshType>>,
}

impl Editor {
    /// A project as it stands in its file.
    pub(super) fn new(project: Arc<Project>, path: Option<PathBuf>, units: ChosenUnits) -> Editor {
        Editor {
            results: derived::all(&project),
            saved: project.clone(),
            project,
            path,
            history: History::default(),
            selected: 0,
            field: Input::Plate,
            stand_in: (
                NamedLayout::new("", layout::REFERENCE, REFERENCE_ID),
                LayoutResult {
                    case: None,
                    derived: Err(vec![Problem::new("layouts", NONE)]),
                    verdict: None,
                },
            ),
            units,
            own: Vec::new(),
        }
    }

    /// Offers meshes of the user's own.
    pub(super) fn offer(&mut self, own: Vec<Arc<MeshType>>) {
        self.own = own;
    }

    /// Those that are offered, for the next project.
    pub(super) fn take_offered(&mut self) -> Vec<Arc<MeshType>> {
        std::mem::take(&mut self.own)
    }

    /// Offers one more of them.
    pub(super) fn offer_too(&mut self, mesh: &Arc<MeshType>) {
        if !self.own.iter().any(|there| there.id == mesh.id) {
            self.own.push(mesh.clone());
        }
    }

    /// The project as it stands.
    pub(super) fn project(&self) -> &Arc<Project> {
        &self.project
    }

    /// Its file, if it has one.
    pub(super) fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// Whether there are edits that are not saved.
    pub(super) fn edited(&self) -> bool {
        !Arc::ptr_eq(&self.project, &self.saved) && *self.project != *self.saved
    }

    /// A project was written to a file, as it was then.
    pub(super) fn saved(&mut self, project: Arc<Project>, path: PathBuf) {
        self.saved = project;
        self.path = Some(path);
    }

    pub(super) fn layouts(&self) -> &[NamedLayout] {
        &self.project.layouts
    }

    /// Whether the project has no layouts.
    pub(super) fn empty(&self) -> bool {
        self.project.layouts.is_empty()
    }

    /// Index of the selected layout; 0 where there is none.
    pub(super) fn selected(&self) -> usize {
        self.selected
    }

    /// The selected layout; a stand-in where there is none.
    pub(super) fn layout(&self) -> &NamedLayout {
        self.project.layouts.get(self.selected).unwrap_or(&self.stand_in.0)
    }

    /// The selected input.
    pub(super) fn field(&self) -> Input {
        // Another layout may have one spacing where the last had two.
        let there = self.field.stands_in(&self.layout().layout);
        if there { self.field } else { Input::Spacing }
    }

    /// What follows from each layout, in the order of the list.
    pub(super) fn results(&self) -> &[LayoutResult] {
        &self.results
    }

    /// What follows from the selected layout.
    pub(super) fn result(&self) -> &LayoutResult {
        self.results.get(self.selected).unwrap_or(&self.stand_in.1)
    }

    /// A layout as a case; nothing where its mesh is not known.
    pub(super) fn case(&self, index: usize) -> Option<&Case> {
        self.results.get(index)?.case.as_ref()
    }

    /// Units on the screen.
    pub(super) fn units(&self) -> Units {
        self.units.over(self.project.display.units)
    }

    /// Shows other units than the project's own, or those again.
    pub(super) fn show_units(&mut self, units: ChosenUnits) {
        self.units = units;
    }

    /// The history of edits.
    pub(super) fn history(&self) -> &History {
        &self.history
    }

    /// Selects a layout; one that there is not leaves the selection.
    pub(super) fn select(&mut self, index: usize) {
        if index < self.project.layouts.len() {
            self.selected = index;
        }
    }

    /// Selects the next or the previous layout, round and round.
    pub(super) fn select_neighbour(&mut self, next: bool) {
        let count = self.project.layouts.len().max(1);
        self.selected = (self.selected + if next { 1 } else { count - 1 }) % count;
    }

    /// Selects an input.
    pub(super) fn select_field(&mut self, field: Input) {
        self.field = field;
    }

    /// Selects the input below or above, if there is one.
    pub(super) fn select_next_field(&mut self, down: bool) {
        let (fields, here) = (Input::of_layout(&self.layout().layout), self.field());
        let next = fields.windows(2).find_map(|pair| match down {
            true => (pair[0] == here).then_some(pair[1]),
            false => (pair[1] == here).then_some(pair[0]),
        });
        self.field = next.unwrap_or(here);
    }

    /// Makes the forecasts anew.
    fn derive(&mut self) {
        self.selected = self.selected.min(self.project.layouts.len().saturating_sub(1));
        self.results = derived::all(&self.project);
    }

    /// The present as a step of the history.
    fn step(&self, label: String) -> HistoryStep {
        HistoryStep {
            project: self.project.clone(),
            selected: self.selected,
            field: self.field,
            label,
            run: Run::Alone,
        }
    }

    /// Makes an edit that can be undone. An edit that changes nothing leaves no trace; whether it
    /// changed something.
    fn edit(&mut self, label: impl Into<String>, change: impl FnOnce(&mut Project)) -> bool {
        self.edit_in(Run::Alone, label, change)
    }

    /// The same as a part of a run of edits that are undone together.
    fn edit_in(
        &mut self,
        run: Run,
        label: impl Into<String>,
        change: impl FnOnce(&mut Project),
    ) -> bool {
        let mut project = (*self.project).clone();
        change(&mut project);
        let changed = project != *self.project;
        if changed {
            let before = HistoryStep { run, ..self.step(label.into()) };
            self.history.record(before);
            self.project = Arc::new(project);
            self.derive();
        }
        changed
    }

    /// Makes an edit of the selected layout, see [`Editor::edit`]; without one nothing happens.
    fn edit_layout(
        &mut self,
        label: impl Into<String>,
        change: impl FnOnce(&mut NamedLayout),
    ) -> bool {
        let at = self.selected;
        self.edit(label, |project| {
            if let Some(layout) = project.layouts.get_mut(at) {
                change(layout);
            }
        })
    }

    /// Takes back edits kept from a lost session, as an edit.
    pub(super) fn restore(&mut self, kept: &Project) {
        self.edit("kept edits taken back", |project| *project = kept.clone());
    }

    /// Undoes the last edit; what to say.
    pub(super) fn undo(&mut self) -> String {
        let now = self.step(String::new());
        match self.history.undo(|label| HistoryStep { label, ..now }) {
            Some(step) => {
                let left = self.history.undo_depth();
                let said = format!("undone: {} ({left} more)", step.label);
                self.go_to(step);
                said
            }
            None => "nothing to undo".into(),
        }
    }

    /// Does again what was undone; what to say.
    pub(super) fn redo(&mut self) -> String {
        let now = self.step(String::new());
        match self.history.redo(|label| HistoryStep { label, ..now }) {
            Some(step) => {
                let left = self.history.redo_depth();
                let said = format!("redone: {} ({left} more)", step.label);
                self.go_to(step);
                said
            }
            None => "nothing to redo".into(),
        }
    }

    fn go_to(&mut self, step: HistoryStep) {
        self.project = self.with_checks(step.project, &step.run);
        self.selected = step.selected;
        self.field = step.field;
        self.derive();
    }

    /// Keeps the result of a check beside its layout, as a step of undo.
    pub(super) fn keep_check(&mut self, index: usize, result: CheckResult) {
        if let Some(layout) = self.project.layouts.get(index) {
            let (run, label) = (Run::Checks(vec![layout.uid]), format!("check of {}", layout.name));
            let before = HistoryStep { run, ..self.step(label) };
            self.history.record(before);
        }
        let mut project = (*self.project).clone();
        if let Some(layout) = project.layouts.get_mut(index) {
            layout.check = Some(Arc::new(result));
            self.project = Arc::new(project);
            self.derive();
        }
    }

    /// Another state of the project with the results of checks that there are now, but for those that
    /// are undone or done again themselves.
    fn with_checks(&self, other: Arc<Project>, undone: &Run) -> Arc<Project> {
        let newer = |uid: u64| self.project.layouts.iter().find(|l| l.uid == uid);
        let differs = |l: &NamedLayout| {
            !undone.checks(l.uid) && newer(l.uid).is_some_and(|now| now.check != l.check)
        };
        if !other.layouts.iter().any(differs) {
            return other;
        }
        let mut project = (*other).clone();
        for layout in &mut project.layouts {
            if let Some(now) = newer(layout.uid).filter(|_| !undone.checks(layout.uid)) {
                layout.check.clone_from(&now.check);
            }
        }
        Arc::new(project)
    }
}
