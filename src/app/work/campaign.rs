//! The checks of a page's cases. Answers are kept by the fingerprint of what they were made from, so a
//! case that was checked once is known wherever it comes up again, and an edit leaves nothing that
//! could be taken for current.

use super::super::keymap::StudyPage;
use super::super::message::Command;
use super::super::status::Status;
use super::Work;
use crate::case::Case;
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::job::campaign::Campaign;
use crate::job::news::{Progress, What};
use crate::job::order::Task;
use crate::study::checks::{CheckAnswer, NoCheck, inputs};
use crate::study::result::Wanted;
use crate::words::Choice;
use std::collections::{HashMap, VecDeque};
use std::sync::Arc;

/// Answers kept; older ones are forgotten. One takes about ten kilobytes.
const MOST_ANSWERS: usize = 2000;

/// The campaigns of a session.
#[derive(Debug, Default)]
pub(crate) struct Campaigns {
    answers: HashMap<Fingerprint, Arc<CheckAnswer>>,
    order: VecDeque<Fingerprint>,
    running: Option<RunningCampaign>,
    /// What was checked last, by what it was asked for: the fingerprint of all cases.
    last: HashMap<Purpose, Fingerprint>,
}

/// What cases are for: other inputs make the checks of the same purpose stale.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Purpose {
    pub(crate) page: StudyPage,
    /// The layout, by its uid.
    pub(crate) uid: u64,
    /// What the page asks of it, as the ranges of a sweep; 0 where there is nothing to choose.
    pub(crate) question: u64,
}

/// A campaign that runs.
#[derive(Debug, Clone)]
pub struct RunningCampaign {
    number: u64,
    /// What it is for.
    purpose: Purpose,
    /// Of all cases of the page.
    all: Fingerprint,
    /// The cases that are checked, by fingerprint.
    keys: Vec<Fingerprint>,
    /// How far it is; nothing in its first quarter of a second.
    progress: Option<Progress>,
    /// Cases that are done.
    done: usize,
}

impl RunningCampaign {
    pub(crate) fn page(&self) -> StudyPage {
        self.purpose.page
    }

    /// How far it is; nothing in its first quarter of a second.
    pub(crate) fn progress(&self) -> Option<&Progress> {
        self.progress.as_ref()
    }

    /// Cases that are checked in all.
    pub(crate) fn total(&self) -> usize {
        self.keys.len()
    }
}

/// How much of a page is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    /// Cases that have an answer.
    pub have: usize,
    /// All cases.
    pub of: usize,
    /// Whether other inputs of this layout were checked, and these were not yet.
    pub stale: bool,
}

impl Coverage {
    /// Whether there is something to show or to come.
    pub(crate) fn any(&self) -> bool {
        self.have > 0
    }
}

impl Campaigns {
    fn keep(&mut self, key: Fingerprint, answer: Arc<CheckAnswer>) {
        if self.answers.insert(key, answer).is_none() {
            self.order.push_back(key);
        }
        if self.order.len() > MOST_ANSWERS
            && let Some(oldest) = self.order.pop_front()
        {
            self.answers.remove(&oldest);
        }
    }

    /// Whether this is the order of the campaign that runs.
    pub(super) fn runs(&self, number: u64) -> bool {
        self.running.as_ref().is_some_and(|running| running.number == number)
    }

    /// Forgets the campaign that runs: something else takes its place.
    pub(super) fn drop_running(&mut self) {
        self.running = None;
    }

    /// Takes news of the campaign that runs; what is to be said.
    pub(super) fn news(&mut self, what: What) -> Option<Status> {
        let running = self.running.as_mut()?;
        match what {
            What::Progress(progress) => running.progress = Some(progress),
            What::Case { index, answer, .. } => {
                running.done += 1;
                let key = running.keys.get(index).copied();
                self.last.insert(running.purpose, running.all);
                if let Some(key) = key {
                    self.keep(key, answer);
                }
            }
            What::Ended { cancelled } => {
                let (done, total) = (running.done, running.total());
                self.running = None;
                return Some(Status::info(match cancelled {
                    true => format!("ended early; {done} of {total} cases are kept"),
                    false => format!("{total} cases checked"),
                }));
            }
            What::Failed => self.running = None,
            What::Made { .. }
            | What::Refused { .. }
            | What::Step(_)
            | What::Told(_)
            | What::Adopted { .. }
            | What::FormRefused(_) => {}
        }
        None
    }
}

/// Whether an answer is the whole of it, and asking again would give nothing else.
fn whole(answer: &CheckAnswer) -> bool {
    match answer {
        Ok(result) => !result.partial(),
        Err(why) => *why != NoCheck::NotMade,
    }
}

fn all_of(cases: &[Case], wanted: &Wanted) -> Fingerprint {
    let taken = cases.iter().fold(Fingerprinter::new("campaign"), |of, case| {
        // A case that cannot be checked counts as one such.
        of.text(&inputs(case, wanted).map_or(String::new(), |key| key.to_string()))
    });
    taken.finish()
}

impl Work {
    /// The campaign that runs.
    pub(in crate::app) fn campaign(&self) -> Option<&RunningCampaign> {
        self.campaigns.running.as_ref()
    }

    /// The check of a case as its inputs are, or why there is none.
    pub(in crate::app) fn found(&self, case: &Case, wanted: &Wanted) -> CheckAnswer {
        let kept = self.campaigns.answers.get(&inputs(case, wanted)?);
        kept.map_or(Err(NoCheck::NotMade), |answer| (**answer).clone())
    }

    /// How much of some cases is checked.
    pub(in crate::app) fn coverage(
        &self,
        purpose: Purpose,
        cases: &[Case],
        answers: &[CheckAnswer],
        wanted: &Wanted,
    ) -> Coverage {
        let have = answers.iter().filter(|a| !matches!(a, Err(NoCheck::NotMade))).count();
        let last = self.campaigns.last.get(&purpose);
        let stale = have < cases.len() && last.is_some_and(|last| *last != all_of(cases, wanted));
        Coverage { have, of: cases.len(), stale }
    }

    /// Orders the checks of the cases that have none yet.
    ///
    /// # Errors
    /// Why nothing is to be checked: there is nothing, it is all known, or it cannot be.
    pub(in crate::app) fn start_campaign(
        &mut self,
        purpose: Purpose,
        cases: Vec<Case>,
        wanted: Wanted,
    ) -> Result<Command, Status> {
        if cases.is_empty() {
            return Err(Status::error("there is nothing to check here"));
        }
        let all = all_of(&cases, &wanted);
        let (mut keys, mut missing) = (Vec::new(), Vec::new());
        for case in cases {
            let no_check = |why: NoCheck| Status::error(format!("no check: {}", why.sentence()));
            let key = inputs(&case, &wanted).map_err(no_check)?;
            let known = self.campaigns.answers.get(&key).is_some_and(|answer| whole(answer));
            if !known && !keys.contains(&key) {
                keys.push(key);
                missing.push(case);
            }
        }
        if missing.is_empty() {
            let word = wanted.fidelity.word();
            let text = format!("all of it is checked, {word} fidelity; f takes the next");
            return Err(Status::info(text));
        }
        let order = self.order(Task::Campaign(Campaign { cases: missing, wanted }));
        self.running = None;
        self.steps = None;
        self.live.give_way();
        let (number, progress) = (order.number, None);
        self.campaigns.running =
            Some(RunningCampaign { number, purpose, all, keys, progress, done: 0 });
        Ok(Command::Work(order))
    }
}
