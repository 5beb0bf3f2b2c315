//! Which result of a check is shown of a layout, and how it stands to the inputs.

use super::super::editor::Editor;
use super::Work;
use crate::fingerprint::Fingerprint;
use crate::study::result::make::fingerprint;
use crate::study::result::relief::Relief;
use crate::study::result::{CheckResult, Wanted};

/// How a result stands to the inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// Asked for, of the inputs as they are.
    Current,
    /// Live, of the inputs as they are; `true` while runs are to come.
    Live(bool),
    /// Of other inputs, or made by another revision of solver or sampling.
    Stale,
}

/// A result to be shown.
#[derive(Debug, Clone, Copy)]
pub struct ShownCheck<'a> {
    /// The check as the project keeps it.
    pub result: &'a CheckResult,
    /// The shape of the net, where this session made the result.
    pub relief: Option<&'a Relief>,
    /// How it stands to the inputs.
    pub standing: Standing,
}

impl ShownCheck<'_> {
    /// Whether its inputs are not the layout's any more.
    pub fn stale(&self) -> bool {
        self.standing == Standing::Stale
    }
}

/// Fingerprint of a layout's check as the inputs are now; nothing where it cannot be checked.
pub(super) fn inputs(editor: &Editor, index: usize, wanted: &Wanted) -> Option<Fingerprint> {
    let case = editor.case(index)?;
    let wire = case.mesh.wire.as_ref()?;
    Some(fingerprint(&case.layout, wire, wanted))
}

impl Work {
    /// The result of a layout that the project keeps, and whether it is current.
    pub(in crate::app) fn kept<'a>(
        &'a self,
        editor: &'a Editor,
        index: usize,
    ) -> Option<ShownCheck<'a>> {
        let layout = editor.layouts().get(index)?;
        let kept = layout.check.as_deref()?;
        let now = inputs(editor, index, &kept.wanted);
        let current = now.is_some_and(|now| kept.current(now));
        let shape = self
            .shapes
            .iter()
            .find(|(uid, made)| *uid == layout.uid && made.result.inputs == kept.inputs && current);
        Some(ShownCheck {
            result: kept,
            relief: shape.and_then(|(_, made)| made.relief.as_ref()),
            standing: if current { Standing::Current } else { Standing::Stale },
        })
    }

    /// The result to show for the selected layout: a current one that was asked for, or else in live
    /// mode a live one of these inputs, or else a stale one.
    pub(in crate::app) fn shown<'a>(
        &'a self,
        editor: &'a Editor,
        live: bool,
    ) -> Option<ShownCheck<'a>> {
        let kept = self.kept(editor, editor.selected());
        if kept.is_some_and(|shown| !shown.stale()) || !live {
            return kept;
        }
        let Some((made, more)) = self.live.result(editor.layout().uid) else { return kept };
        let now = inputs(editor, editor.selected(), &made.result.wanted);
        let current = now.is_some_and(|now| made.result.current(now));
        if !current && kept.is_some() {
            return kept;
        }
        Some(ShownCheck {
            result: &made.result,
            relief: made.relief.as_ref().filter(|_| current),
            standing: if current { Standing::Live(more) } else { Standing::Stale },
        })
    }
}
