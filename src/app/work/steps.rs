//! Long work of several steps behind the screen, whatever it is: a campaign of random layouts with its method.

use super::super::message::Command;
use super::super::status::Status;
use super::Work;
use crate::job::news::{StepProgress, What};
use crate::job::order::Task;

/// Work of steps that runs.
#[derive(Debug, Clone)]
pub(crate) struct RunningSteps {
    pub(super) number: u64,
    /// What it is, in a word.
    name: &'static str,
    /// How far it is; nothing in its first quarter of a second.
    progress: Option<StepProgress>,
}

impl RunningSteps {
    /// What it is, in a word.
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// How far it is; nothing in its first quarter of a second.
    pub(crate) fn progress(&self) -> Option<&StepProgress> {
        self.progress.as_ref()
    }
}

impl Work {
    /// The work of steps that runs.
    pub(in crate::app) fn steps(&self) -> Option<&RunningSteps> {
        self.steps.as_ref()
    }

    /// Whether work of steps of this number runs.
    pub(in crate::app) fn at_steps(&self, number: u64) -> bool {
        self.steps.as_ref().is_some_and(|steps| steps.number == number)
    }

    /// Orders work of steps; whatever runs gives way.
    pub(in crate::app) fn start_steps(&mut self, name: &'static str, task: Task) -> Command {
        let order = self.order(task);
        self.running = None;
        self.campaigns.drop_running();
        self.live.give_way();
        self.steps = Some(RunningSteps { number: order.number, name, progress: None });
        Command::Work(order)
    }

    /// Takes news of work of steps; what is to be said. The last word is heard of any: what gave way to
    /// another order was asked for, and what it kept is there.
    pub(super) fn step_news(&mut self, number: u64, what: What) -> Option<Status> {
        let mine = self.steps.as_mut().filter(|steps| steps.number == number);
        match (what, mine) {
            (What::Step(progress), Some(steps)) => {
                steps.progress = Some(progress);
                None
            }
            (What::Told(Ok(said)), _) => Some(Status::info(said)),
            (What::Told(Err(why)), _) => Some(Status::error(why)),
            (What::Ended { .. } | What::Failed, Some(_)) => {
                self.steps = None;
                None
            }
            _ => None,
        }
    }
}
