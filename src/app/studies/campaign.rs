//! The checks of a page's cases. Answers are kept by the fingerprint of what they were made from, so a
//! case that was checked once is known wherever it comes up again, and an edit leaves nothing that
//! could be taken for current.

use super::super::App;
use super::super::keymap::StudyPage;
use super::super::message::Command;
use crate::case::Case;
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::job::campaign::Campaign;
use crate::job::news::{News, Progress, What};
use crate::job::order::Task;
use crate::study::checks::{CheckAnswer, NoCheck, RUNS, inputs};
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
    /// The page.
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
    pub(crate) purpose: Purpose,
    /// Of all cases of the page.
    all: Fingerprint,
    /// The cases that are checked, by fingerprint.
    keys: Vec<Fingerprint>,
    /// How far it is; nothing in its first quarter of a second.
    pub(crate) progress: Option<Progress>,
    /// Cases that are done.
    pub(crate) done: usize,
}

impl RunningCampaign {
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
}

/// Whether an answer is the whole of it, and asking again would give nothing else.
fn whole(answer: &CheckAnswer) -> bool {
    match answer {
        Ok(result) => !result.partial(),
        Err(why) => *why != NoCheck::NotMade,
    }
}

impl App {
    /// What studies ask of each check: as many runs in all cases, so that they share their draws.
    pub(crate) fn study_wanted(&self) -> Wanted {
        let runs = self.settings.runs.unwrap_or(RUNS);
        Wanted { fidelity: self.study_fidelity(), runs: Some(runs), seed: 0 }
    }

    /// The campaign that runs.
    pub fn campaign(&self) -> Option<&RunningCampaign> {
        self.studies.campaigns.running.as_ref()
    }

    /// The check of a case as its inputs are, or why there is none.
    pub(super) fn found(&self, case: &Case) -> CheckAnswer {
        match inputs(case, &self.study_wanted()) {
            Ok(key) => {
                let kept = self.studies.campaigns.answers.get(&key);
                kept.map_or(Err(NoCheck::NotMade), |answer| (**answer).clone())
            }
            Err(why) => Err(why),
        }
    }

    fn all_of(&self, cases: &[Case]) -> Fingerprint {
        let wanted = self.study_wanted();
        let taken = cases.iter().fold(Fingerprinter::new("campaign"), |of, case| {
            of.text(&inputs(case, &wanted).map_or(String::new(), |key| key.to_string()))
        });
        taken.finish()
    }

    /// What a page asks of the selected layout.
    pub(super) fn purpose(&self, page: StudyPage, question: u64) -> Purpose {
        Purpose { page, uid: self.layout().uid, question }
    }

    /// How much of some cases is checked.
    pub(super) fn coverage(
        &self,
        purpose: Purpose,
        cases: &[Case],
        answers: &[CheckAnswer],
    ) -> Coverage {
        let have = answers.iter().filter(|a| !matches!(a, Err(NoCheck::NotMade))).count();
        let last = self.studies.campaigns.last.get(&purpose);
        let stale = have < cases.len() && last.is_some_and(|last| *last != self.all_of(cases));
        Coverage { have, of: cases.len(), stale }
    }

    /// Orders the checks of the cases that have none yet.
    pub(super) fn start_campaign(&mut self, purpose: Purpose, cases: Vec<Case>) -> Vec<Command> {
        if cases.is_empty() {
            self.complain("there is nothing to check here");
            return Vec::new();
        }
        let wanted = self.study_wanted();
        let all = self.all_of(&cases);
        let (mut keys, mut missing) = (Vec::new(), Vec::new());
        for case in cases {
            let key = match inputs(&case, &wanted) {
                Ok(key) => key,
                Err(why) => {
                    self.complain(format!("no check: {}", why.sentence()));
                    return Vec::new();
                }
            };
            let known = self.studies.campaigns.answers.get(&key).is_some_and(|a| whole(a));
            if !known && !keys.contains(&key) {
                keys.push(key);
                missing.push(case);
            }
        }
        if missing.is_empty() {
            self.inform(format!(
                "all of it is checked, {} fidelity; f takes the next",
                wanted.fidelity.word()
            ));
            return Vec::new();
        }
        let order = self.order(Task::Campaign(Campaign { cases: missing, wanted }));
        self.give_way();
        self.studies.campaigns.running = Some(RunningCampaign {
            number: order.number,
            purpose,
            all,
            keys,
            progress: None,
            done: 0,
        });
        vec![Command::Work(order)]
    }

    /// Forgets the campaign that runs: something else takes its place.
    pub(in crate::app) fn drop_campaign(&mut self) {
        self.studies.campaigns.running = None;
    }

    /// Takes news of a campaign; whether they were of one.
    pub(in crate::app) fn campaign_news(&mut self, news: &News) -> bool {
        let campaigns = &mut self.studies.campaigns;
        let Some(running) = campaigns.running.as_mut().filter(|r| r.number == news.number) else {
            return matches!(news.what, What::Case { .. });
        };
        match &news.what {
            What::Progress(progress) => running.progress = Some(progress.clone()),
            What::Case { index, answer, .. } => {
                running.done += 1;
                let key = running.keys.get(*index).copied();
                campaigns.last.insert(running.purpose, running.all);
                if let Some(key) = key {
                    campaigns.keep(key, answer.clone());
                }
            }
            What::Ended { cancelled } => {
                let (done, total) = (running.done, running.total());
                campaigns.running = None;
                if *cancelled {
                    self.inform(format!("ended early; {done} of {total} cases are kept"));
                } else {
                    self.inform(format!("{total} cases checked"));
                }
            }
            What::Failed => campaigns.running = None,
            What::Made { .. } | What::Refused { .. } => {}
        }
        true
    }
}
