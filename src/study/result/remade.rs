//! What another revision of solver or sampling changed: a kept result beside the one made again.

use super::make::fingerprint;
use super::{CheckResult, Revisions};
use crate::case::Case;
use crate::curve::Point;
use crate::study::checks::Difference;
use std::sync::Arc;

/// A kept result of another revision, and whether its inputs still are the case's, so that what is made
/// again differs by the revision alone.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Former {
    pub(crate) result: Arc<CheckResult>,
    pub(crate) same_inputs: bool,
}

impl Former {
    /// The kept result of a case, where another revision made it.
    pub(crate) fn of(kept: Option<&Arc<CheckResult>>, case: &Case) -> Option<Former> {
        let result = kept.filter(|kept| kept.by != Revisions::CURRENT)?.clone();
        let now = case.mesh.wire.as_ref().map(|w| fingerprint(&case.layout, w, &result.wanted));
        Some(Former { same_inputs: now == Some(result.inputs), result })
    }

    /// The mean first break that it had, N and m.
    pub(crate) fn mean(&self) -> Option<Point> {
        self.result.mean_break()
    }

    /// By which part force and deflection have moved to what they are now; nothing where one of the two
    /// has no break.
    pub(crate) fn moved(&self, now: Option<Point>) -> Option<Difference> {
        let (old, new) = (self.mean()?, now?);
        let deflection = Some(new.deflection / old.deflection - 1.0);
        Some(Difference { force: new.force / old.force - 1.0, deflection })
    }
}
