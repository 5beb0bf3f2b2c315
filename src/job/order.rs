//! What can be ordered.

use super::adoption::AdoptJob;
use super::campaign::Campaign;
use super::checks::Checks;
use super::desk::{Ticket, Urgency};
use super::method::MethodJob;
use super::news::{News, What};

/// Work to be done behind the screen.
#[derive(Debug, Clone)]
pub struct Order {
    /// Number of the order, never used before in this session: news of older ones can be told apart.
    pub number: u64,
    /// What is to be done.
    pub task: Task,
}

/// The kinds of work.
#[derive(Debug, Clone)]
pub enum Task {
    /// Checks of layouts, one after the other.
    Checks(Checks),
    /// Checks of the cases of a study.
    Campaign(Campaign),
    /// A campaign of random layouts and the method derived from it.
    Method(MethodJob),
    /// A mesh adopted from its own tests.
    Adopt(Box<AdoptJob>),
}

impl Order {
    /// Whether somebody waits for it.
    pub(crate) fn urgency(&self) -> Urgency {
        match &self.task {
            Task::Checks(checks) if checks.live => Urgency::Live,
            Task::Checks(_) | Task::Campaign(_) | Task::Method(_) | Task::Adopt(_) => {
                Urgency::Asked
            }
        }
    }

    /// Does it on so many threads, at least 1. `tell` is called from several of them, at most four
    /// times a second for progress and at once for results.
    pub fn carry_out(&self, threads: usize, ticket: &Ticket, tell: &(dyn Fn(News) + Sync)) {
        let say = |what: What| tell(News { number: self.number, what });
        match &self.task {
            Task::Checks(checks) => checks.carry_out(threads, ticket, &say),
            Task::Campaign(campaign) => campaign.carry_out(threads, ticket, &say),
            Task::Method(job) => job.carry_out(threads, ticket, &say),
            Task::Adopt(job) => job.carry_out(threads, ticket, &say),
        }
        say(What::Ended { cancelled: ticket.cancelled() });
    }
}
