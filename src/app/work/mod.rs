//! Work behind the screen as the state knows it: what was ordered, how far it is, which results there are
//! and whether they still are the layout's.
//!
//! A result that the user asked for is kept in the project beside its layout. It is no step of undo:
//! undoing an edit brings back the inputs, and a result that was stale is current again. Live results
//! are kept here only.
//!
//! - [`shown`]: which result is shown of a layout; [`live`]: the quick check that follows each edit.
//! - [`campaign`]: the checks of the cases of a study; [`steps`]: long work of several steps.

pub(crate) mod campaign;
pub(crate) mod live;
pub mod shown;
pub(crate) mod steps;

use super::editor::Editor;
use super::message::Command;
use super::status::Status;
use crate::curve::Point;
use crate::job::checks::{CheckTarget, Checks};
use crate::job::news::{News, Progress, What};
use crate::job::order::{Order, Task};
use crate::problem::{self, Problem};
use crate::study::result::Wanted;
use crate::study::result::make::Made;
use crate::study::result::remade::Former;
use crate::units::{force_text, length_text, significant};
use campaign::Campaigns;
use live::Live;
use std::sync::Arc;
use steps::RunningSteps;

/// An order of the user's that runs.
#[derive(Debug, Clone, Default)]
pub struct RunningCheck {
    number: u64,
    progress: Option<Progress>,
    /// How many layouts it is for.
    targets: usize,
    /// Layouts that could not be checked.
    refused: Vec<String>,
}

impl RunningCheck {
    /// How far it is; nothing in its first quarter of a second.
    pub(crate) fn progress(&self) -> Option<&Progress> {
        self.progress.as_ref()
    }
}

/// The part of the state that knows of work.
#[derive(Debug, Default)]
pub(super) struct Work {
    /// Orders so far.
    orders: u64,
    running: Option<RunningCheck>,
    live: Live,
    campaigns: Campaigns,
    steps: Option<RunningSteps>,
    /// The last results with their shape, which the project does not keep.
    shapes: Vec<(u64, Arc<Made>)>,
    /// What another solver or sampling had made of layouts that this session checked again.
    formers: Vec<(u64, Former)>,
}

impl Work {
    /// The order of the user's that runs.
    pub(super) fn running(&self) -> Option<&RunningCheck> {
        self.running.as_ref()
    }

    /// The curves of a layout's runs as far as they have come.
    pub(super) fn growing(&self, uid: u64) -> &[Vec<Point>] {
        let progress = self.running.as_ref().and_then(RunningCheck::progress);
        progress.filter(|progress| progress.uid == uid).map_or(&[], |progress| &progress.curves)
    }

    /// What stood beside a layout before this session made its check again by another solver or sampling.
    pub(super) fn former(&self, uid: u64) -> Option<&Former> {
        self.formers.iter().find(|(of, _)| *of == uid).map(|(_, former)| former)
    }

    fn order(&mut self, task: Task) -> Order {
        self.orders += 1;
        Order { number: self.orders, task }
    }

    /// Orders the check of the selected layout, or of all.
    ///
    /// # Errors
    /// Why there is nothing to check.
    pub(super) fn start_check(
        &mut self,
        editor: &Editor,
        all: bool,
        wanted: Wanted,
    ) -> Result<Command, String> {
        let chosen = if all { 0..editor.layouts().len() } else { one(editor.selected()) };
        let targets: Vec<CheckTarget> = chosen.filter_map(|i| target(editor, i)).collect();
        if editor.empty() {
            return Err(super::editor::NONE.into());
        }
        if targets.is_empty() {
            return Err("this layout's mesh is not known, so it cannot be checked".into());
        }
        let running = RunningCheck { targets: targets.len(), ..RunningCheck::default() };
        let order = self.order(Task::Checks(Checks { targets, wanted, live: false }));
        self.campaigns.drop_running();
        self.steps = None;
        self.running = Some(RunningCheck { number: order.number, ..running });
        // The worker ends a live check for it.
        self.live.give_way();
        Ok(Command::Work(order))
    }

    /// Ends what runs behind the screen; what is to be said.
    pub(super) fn stop(&mut self) -> (Option<Command>, Option<Status>) {
        if self.campaign().is_some() || self.steps.is_some() {
            return (Some(Command::StopWork), None);
        }
        let live = self.live.give_way();
        match (&self.running, live) {
            (Some(_), _) => (Some(Command::StopWork), None),
            (None, true) => {
                let said = Status::info("live check ended; l switches live mode off");
                (Some(Command::StopWork), Some(said))
            }
            (None, false) => (None, Some(Status::info("nothing is running; q quits, ? helps"))),
        }
    }

    /// Another project takes the place of this one: what runs ends, and no result is left. Numbers of
    /// orders go on, so that late news of the former project find nobody.
    pub(super) fn forget(&mut self) -> Option<Command> {
        let asked = self.campaign().is_some() || self.running.is_some() || self.steps.is_some();
        let busy = asked || self.live.running();
        self.campaigns.drop_running();
        // Answers are of inputs, whatever project has them.
        let campaigns = std::mem::take(&mut self.campaigns);
        *self = Work { orders: self.orders, campaigns, ..Work::default() };
        busy.then_some(Command::StopWork)
    }

    /// Takes news; what is to be said.
    pub(super) fn news(&mut self, editor: &mut Editor, news: News) -> Option<Status> {
        if self.campaigns.runs(news.number) {
            return self.campaigns.news(news.what);
        }
        if self.live.runs(news.number) {
            self.live.news(news.what);
            return None;
        }
        let of_steps = self.steps.as_ref().is_some_and(|steps| steps.number == news.number);
        if of_steps || matches!(news.what, What::Step(_) | What::Told(_)) {
            return self.step_news(news.number, news.what);
        }
        let asked = self.running.as_mut().filter(|running| running.number == news.number);
        match (news.what, asked) {
            (What::Progress(progress), Some(running)) => {
                running.progress = Some(progress);
                None
            }
            // Also of an order that was pushed aside: it was asked for, and it is whole.
            (What::Made { uid, made, live: false, .. }, _) => self.keep(editor, uid, made),
            (What::Refused { uid, problems }, Some(running)) => {
                Some(running.refuse(editor, uid, &problems))
            }
            (What::Ended { cancelled }, Some(_)) => {
                self.running.take()?.ended(cancelled, self.formers.len())
            }
            (What::Failed, Some(_)) => {
                self.running = None;
                None
            }
            _ => None,
        }
    }

    /// Keeps a result in the project.
    fn keep(&mut self, editor: &mut Editor, uid: u64, made: Arc<Made>) -> Option<Status> {
        let index = editor.layouts().iter().position(|layout| layout.uid == uid)?;
        let result = &made.result;
        if result.curve.deflection.is_empty() {
            return None;
        }
        let have_better = self.kept(editor, index).is_some_and(|old| {
            !old.stale() && !old.result.partial() && old.result.runs > result.runs
        });
        if result.partial() && have_better {
            return None;
        }
        let name = &editor.layouts()[index].name;
        let text = if result.broke() {
            let part = significant(100.0 * result.force.uncertainty(), 2);
            format!(
                "{name}: {} at {}, {}",
                force_text(result.force.mean, editor.units()),
                length_text(result.deflection.mean, editor.units()),
                match result.runs {
                    1 => "1 run".into(),
                    n if result.breaks.len() > 1 => format!("{n} runs, mean force to {part} %"),
                    n => format!("{n} runs"),
                }
            )
        } else {
            format!("{name}: no wire broke, peak {}", force_text(result.peak.force, editor.units()))
        };
        let before = editor.layouts()[index].check.as_ref();
        let former = editor.case(index).and_then(|case| Former::of(before, case));
        editor.keep_check(index, result.clone());
        if let Some(former) = former {
            self.formers.retain(|(other, _)| *other != uid);
            self.formers.push((uid, former));
        }
        self.shapes.retain(|(other, _)| *other != uid);
        self.shapes.push((uid, made));
        Some(Status::info(text))
    }
}

impl RunningCheck {
    fn refuse(&mut self, editor: &Editor, uid: u64, problems: &[Problem]) -> Status {
        let layout = editor.layouts().iter().find(|layout| layout.uid == uid);
        let name = layout.map_or("a deleted layout", |layout| layout.name.as_str());
        self.refused.push(name.to_string());
        Status::error(format!("{name} cannot be checked: {}", problem::summary(problems)))
    }

    /// What to say when it ends.
    ///
    /// `formers`: of how many layouts the check was another program's before.
    fn ended(self, cancelled: bool, formers: usize) -> Option<Status> {
        if cancelled {
            return Some(Status::info("check ended early; what was done is kept"));
        }
        if self.targets == 1 {
            return None;
        }
        let good = self.targets - self.refused.len();
        let again = if formers > 0 { "; i: what the new solver changed" } else { "" };
        let text = format!("{good} of {} layouts checked{again}", self.targets);
        Some(match self.refused.as_slice() {
            [] => Status::info(text),
            refused => Status::error(format!("{text}; not possible: {}", refused.join(", "))),
        })
    }
}

fn one(index: usize) -> std::ops::Range<usize> {
    index..index + 1
}

fn target(editor: &Editor, index: usize) -> Option<CheckTarget> {
    let uid = editor.layouts().get(index)?.uid;
    Some(CheckTarget { uid, case: editor.case(index)?.clone() })
}
