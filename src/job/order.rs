//! What can be ordered, and what is told of it.

use super::campaign::Campaign;
use super::checks::Checks;
use super::desk::{Ticket, Urgency};
use crate::curve::Point;
use crate::problem::Problem;
use crate::study::checks::CheckAnswer;
use crate::study::result::make::Made;
use std::sync::Arc;

/// Work to be done behind the screen.
#[derive(Debug, Clone)]
pub struct Order {
    /// Number of the order, never used before in this session: news of older ones can be told apart.
    pub number: u64,
    /// What is to be done.
    pub task: Task,
    /// Threads it may use, at least 1.
    pub threads: usize,
}

/// The kinds of work.
#[derive(Debug, Clone)]
pub enum Task {
    /// Checks of layouts, one after the other.
    Checks(Checks),
    /// Checks of the cases of a study.
    Campaign(Campaign),
}

impl Order {
    /// Whether somebody waits for it.
    pub(crate) fn urgency(&self) -> Urgency {
        match &self.task {
            Task::Checks(checks) if checks.live => Urgency::Live,
            Task::Checks(_) | Task::Campaign(_) => Urgency::Asked,
        }
    }

    /// Does it. `tell` is called from several threads, at most four times a second for progress and
    /// at once for results.
    pub fn carry_out(&self, ticket: &Ticket, tell: &(dyn Fn(News) + Sync)) {
        match &self.task {
            Task::Checks(checks) => checks.carry_out(self, ticket, tell),
            Task::Campaign(campaign) => campaign.carry_out(self, ticket, tell),
        }
        tell(News { number: self.number, what: What::Ended { cancelled: ticket.cancelled() } });
    }
}

/// News of an order.
#[derive(Debug, Clone)]
pub struct News {
    /// Number of the order.
    pub number: u64,
    /// What is new.
    pub what: What,
}

/// What is new of an order.
#[derive(Debug, Clone)]
pub enum What {
    /// It has come so far.
    Progress(Progress),
    /// A check's result so far, or the whole of it.
    Made {
        /// The layout, by its uid.
        uid: u64,
        /// The result.
        made: Arc<Made>,
        /// Whether more runs of it are to come.
        more: bool,
        /// Whether nobody asked for it.
        live: bool,
    },
    /// A case of a campaign is done.
    Case {
        /// Its place among the campaign's cases.
        index: usize,
        /// How many there are.
        total: usize,
        /// Its check, or why there is none.
        answer: Arc<CheckAnswer>,
    },
    /// A layout cannot be checked.
    Refused {
        /// The layout, by its uid.
        uid: u64,
        /// Why.
        problems: Vec<Problem>,
    },
    /// Nothing more comes.
    Ended {
        /// Whether it was ended early.
        cancelled: bool,
    },
    /// It ended by a fault of the program.
    Failed,
}

/// How far an order has come.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Progress {
    /// The layout it is at, by its uid; 0 for a campaign.
    pub uid: u64,
    /// Which of how many layouts or cases, from 0.
    pub part: usize,
    /// How many layouts or cases there are.
    pub parts: usize,
    /// Runs of it that are done.
    pub done: usize,
    /// Runs of it to be made as far as is known.
    pub planned: usize,
    /// How much of all is done, 0 to 1.
    pub fraction: f64,
    /// Time left, s.
    pub left: f64,
    /// The curves of this layout's runs as far as they have come.
    pub curves: Vec<Vec<Point>>,
}
