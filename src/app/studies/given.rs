//! What the pages are made from: the project being edited and the checks that were made.

use super::super::editor::Editor;
use super::super::keymap::StudyPage;
use super::super::work::Work;
use super::super::work::campaign::{Coverage, Purpose};
use super::super::work::shown::ShownCheck;
use crate::case::Case;
use crate::project::schema::NamedLayout;
use crate::study::checks::CheckAnswer;
use crate::study::result::Wanted;

/// Project and checks, and what is asked of checks.
pub(super) struct Given<'a> {
    pub(super) editor: &'a Editor,
    pub(super) work: &'a Work,
    pub(super) wanted: Wanted,
}

impl<'a> Given<'a> {
    /// The selected layout as a case; nothing where its mesh is not known.
    pub(super) fn case(&self) -> Option<Case> {
        self.editor.case(self.editor.selected()).cloned()
    }

    /// The layouts whose mesh is known, with their places in the project.
    pub(super) fn cases(&self) -> impl Iterator<Item = (usize, &'a NamedLayout, &'a Case)> {
        let (editor, layouts) = (self.editor, self.editor.layouts().iter().enumerate());
        layouts.filter_map(|(index, layout)| Some((index, layout, editor.case(index)?)))
    }

    /// The check of a layout that the project keeps.
    pub(super) fn kept(&self, index: usize) -> Option<ShownCheck<'a>> {
        self.work.kept(self.editor, index)
    }

    /// The checks of some cases as their inputs are, or why there are none.
    pub(super) fn answers(&self, cases: &[Case]) -> Vec<CheckAnswer> {
        cases.iter().map(|case| self.work.found(case, &self.wanted)).collect()
    }

    /// What a page asks of the selected layout.
    pub(super) fn purpose(&self, page: StudyPage, question: u64) -> Purpose {
        Purpose { page, uid: self.editor.layout().uid, question }
    }

    /// How much of some cases is checked.
    pub(super) fn coverage(
        &self,
        purpose: Purpose,
        cases: &[Case],
        answers: &[CheckAnswer],
    ) -> Coverage {
        self.work.coverage(purpose, cases, answers, &self.wanted)
    }
}
