//! The pages of studies: what each shows and what a key does on it.
//!
//! - [`sensitivity`], [`sweep`], [`compare`], [`design`]: a page each, with its state and what it shows.
//! - [`given`]: what they are made from; [`asked`]: what keys and typed texts do on them.
//!
//! What a page shows is made anew after each message while the page is open, and never while drawing.

mod asked;
pub(crate) mod compare;
pub(crate) mod design;
mod given;
pub(crate) mod sensitivity;
pub(crate) mod sweep;
pub(crate) mod tolerance;

use super::editor::Editor;
use super::keymap::StudyPage;
use super::message::Command;
use super::status::Status;
use super::work::Work;
use super::work::campaign::Purpose;
use crate::study::checks::RUNS;
use crate::study::exactness::Exactness;
use crate::study::result::Wanted;
use crate::study::sensitivity::Effect as Shown;
use crate::words::Choice;
use given::Given;

/// The studies' part of the state. It outlives the pages, so that a page comes back as it was.
#[derive(Debug, Default)]
pub(super) struct Studies {
    /// How exactly the checks of studies compute; quick where nothing was said.
    fidelity: Option<Exactness>,
    sensitivity: sensitivity::SensitivityState,
    sweep: sweep::SweepState,
    compare: compare::CompareState,
    design: design::DesignState,
    tolerance: tolerance::ToleranceState,
}

impl Studies {
    pub(super) fn sensitivity(&self) -> &sensitivity::SensitivityState {
        &self.sensitivity
    }

    pub(super) fn sweep(&self) -> &sweep::SweepState {
        &self.sweep
    }

    pub(super) fn compare(&self) -> &compare::CompareState {
        &self.compare
    }

    pub(super) fn design(&self) -> &design::DesignState {
        &self.design
    }

    pub(super) fn tolerance(&self) -> &tolerance::ToleranceState {
        &self.tolerance
    }

    /// How exactly the checks of studies compute.
    pub(super) fn fidelity(&self) -> Exactness {
        self.fidelity.unwrap_or(Exactness::Quick)
    }

    /// Takes the next fidelity; what to say.
    fn next_fidelity(&mut self) -> String {
        let next = match self.fidelity() {
            Exactness::Quick => Exactness::Standard,
            Exactness::Standard => Exactness::Fine,
            _ => Exactness::Quick,
        };
        self.fidelity = Some(next);
        format!("checks of studies are {}: {}", next.word(), next.about())
    }

    /// What studies ask of each check: as many runs in all cases, so that they share their draws.
    pub(super) fn wanted(&self, runs: Option<usize>) -> Wanted {
        Wanted { fidelity: self.fidelity(), runs: Some(runs.unwrap_or(RUNS)), seed: 0 }
    }

    /// Makes what a page shows anew. `runs` are those that the settings ask for.
    pub(super) fn follow(
        &mut self,
        page: StudyPage,
        editor: &Editor,
        work: &Work,
        runs: Option<usize>,
    ) {
        let given = Given { editor, work, wanted: self.wanted(runs) };
        match page {
            StudyPage::Sensitivity => self.sensitivity.follow(&given),
            StudyPage::Sweep => self.sweep.follow(&given),
            StudyPage::Compare => self.compare.follow(&given),
            StudyPage::Design => self.design.follow(&given),
            StudyPage::Tolerance => self.tolerance.follow(&given),
        }
    }

    /// Marks a layout in the comparison, by its place in the project.
    pub(super) fn mark_compared(&mut self, layout: usize) {
        self.compare.mark(layout);
    }

    /// Moves the mark of a page, or scrolls it.
    fn step(&mut self, page: StudyPage, lines: isize) {
        match page {
            StudyPage::Sensitivity => self.sensitivity.scroll(lines),
            StudyPage::Sweep => self.sweep.step(lines),
            StudyPage::Compare => self.compare.step(lines),
            StudyPage::Design => self.design.step(lines),
            StudyPage::Tolerance => self.tolerance.step(lines),
        }
    }

    /// Orders the checks of a page whose checks no project keeps.
    ///
    /// # Errors
    /// Why there is nothing to check.
    fn check(
        &self,
        page: StudyPage,
        editor: &Editor,
        work: &mut Work,
        runs: Option<usize>,
    ) -> Result<Command, Status> {
        let (cases, question) = match page {
            StudyPage::Sensitivity => (self.sensitivity.cases(), 0),
            StudyPage::Sweep => (self.sweep.cases().map_err(Status::error)?, self.sweep.question()),
            StudyPage::Design => (self.design.cases(), 0),
            StudyPage::Compare | StudyPage::Tolerance => (Vec::new(), 0),
        };
        let purpose = Purpose { page, uid: editor.layout().uid, question };
        work.start_campaign(purpose, cases, self.wanted(runs))
    }
}

/// The neighbour of a value that studies speak of, among those there are with or without a design
/// force.
fn neighbour(shown: Shown, next: bool, asked: bool) -> Shown {
    let all = Shown::all(asked);
    let at = all.iter().position(|one| *one == shown).unwrap_or(0);
    all[(at + if next { 1 } else { all.len() - 1 }) % all.len()]
}
