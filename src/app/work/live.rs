//! The quick check that follows each edit in live mode.

use super::super::editor::Editor;
use super::super::message::Command;
use super::{Work, target};
use crate::fingerprint::Fingerprint;
use crate::job::checks::Checks;
use crate::job::news::What;
use crate::job::order::Task;
use crate::problem;
use crate::study::exactness::Exactness;
use crate::study::result::Wanted;
use crate::study::result::make::Made;
use std::sync::Arc;

/// Runs of a live check: few enough to be there while one turns a value, enough for a band.
pub(crate) const LIVE_RUNS: usize = 4;

/// What live checks are asked for.
fn wanted() -> Wanted {
    Wanted { fidelity: Exactness::Quick, runs: Some(LIVE_RUNS), seed: 0 }
}

/// What live mode has made and makes.
#[derive(Debug, Default)]
pub(super) struct Live {
    /// The order that runs or waits.
    order: Option<u64>,
    /// What the last order was for.
    key: Option<(u64, Fingerprint)>,
    result: Option<LiveResult>,
    /// Why the last order gave nothing, and for which layout.
    refused: Option<(u64, String)>,
}

#[derive(Debug)]
struct LiveResult {
    uid: u64,
    made: Arc<Made>,
    more: bool,
}

impl Live {
    /// Whether an order runs or waits.
    pub(super) fn running(&self) -> bool {
        self.order.is_some()
    }

    /// Whether it is this one.
    pub(super) fn runs(&self, number: u64) -> bool {
        self.order == Some(number)
    }

    /// The order is ended; whether there was one.
    pub(super) fn give_way(&mut self) -> bool {
        self.order.take().is_some()
    }

    /// The result of a layout, and whether more runs of it are to come.
    pub(super) fn result(&self, uid: u64) -> Option<(&Made, bool)> {
        let result = self.result.as_ref().filter(|result| result.uid == uid)?;
        Some((&result.made, result.more))
    }

    /// Takes news of the order.
    pub(super) fn news(&mut self, what: What) {
        match what {
            What::Made { uid, made, more, live: true } => {
                self.result = Some(LiveResult { uid, made, more });
            }
            What::Refused { uid, problems } => {
                self.refused = Some((uid, problem::summary(&problems)));
                self.result = None;
            }
            What::Ended { .. } | What::Failed => self.order = None,
            What::Made { .. }
            | What::Progress(_)
            | What::Case { .. }
            | What::Step(_)
            | What::Told(_)
            | What::Adopted { .. }
            | What::FormRefused(_) => {}
        }
    }
}

impl Work {
    /// Whether a live check is under way.
    pub(in crate::app) fn live_running(&self) -> bool {
        self.live.running()
    }

    /// Why there is no live result of a layout.
    pub(in crate::app) fn live_refusal(&self, uid: u64) -> Option<&str> {
        let (of, why) = self.live.refused.as_ref()?;
        (*of == uid).then_some(why.as_str())
    }

    /// Live mode was switched off: what it made goes, and what it runs ends.
    pub(in crate::app) fn end_live(&mut self) -> Option<Command> {
        self.live.key = None;
        self.live.result = None;
        self.stop_live()
    }

    /// A live check, if the inputs are others than those of the last one.
    pub(in crate::app) fn follow_edit(&mut self, editor: &Editor) -> Option<Command> {
        let wanted = wanted();
        let (at, uid) = (editor.selected(), editor.layout().uid);
        let key = super::shown::inputs(editor, at, &wanted).map(|now| (uid, now));
        if key == self.live.key {
            return None;
        }
        self.live.key = key;
        self.live.refused = None;
        let known = self.kept(editor, at).is_some_and(|shown| !shown.stale());
        let Some(target) = target(editor, at).filter(|_| key.is_some() && !known) else {
            return self.stop_live();
        };
        let order = self.order(Task::Checks(Checks { targets: vec![target], wanted, live: true }));
        self.live.order = Some(order.number);
        Some(Command::Work(order))
    }

    /// Ends a live check; what was asked for goes on.
    fn stop_live(&mut self) -> Option<Command> {
        let stop = self.live.give_way() && self.running.is_none();
        stop.then_some(Command::StopWork)
    }
}
