//! Checks in the program's state: what was ordered, how far it is, which results there are and whether
//! they still are the layout's.
//!
//! A result that the user asked for is kept in the project beside its layout. It is no step of undo:
//! undoing an edit brings back the inputs, and a result that was stale is current again. Live results
//! are kept here only.

use super::App;
use super::message::Command;
use super::settings::SettingItem;
use crate::curve::Point;
use crate::dem::Fidelity;
use crate::fingerprint::Fingerprint;
use crate::job::checks::{CheckTarget, Checks};
use crate::job::news::{News, Progress, What};
use crate::job::order::{Order, Task};
use crate::problem::summary;
use crate::project::Project;
use crate::study::result::CheckResult;
use crate::study::result::Wanted;
use crate::study::result::make::{Made, fingerprint};
use crate::study::result::relief::Relief;
use crate::units::{force_text, length_text, significant};
use std::sync::Arc;

/// Runs of a live check: few enough to be there while one turns a value, enough for a band.
pub(crate) const LIVE_RUNS: usize = 4;

/// What live checks are asked for.
pub(crate) fn live_wanted() -> Wanted {
    Wanted { fidelity: Fidelity::Quick, runs: Some(LIVE_RUNS), seed: 0 }
}

/// An order of the user's that runs.
#[derive(Debug, Clone, Default)]
pub struct RunningCheck {
    number: u64,
    /// How far it is; nothing in its first quarter of a second.
    pub(crate) progress: Option<Progress>,
    /// How many layouts it is for.
    pub(crate) targets: usize,
    /// Layouts that could not be checked.
    refused: Vec<String>,
}

/// All that the state knows of checks.
#[derive(Debug, Default)]
pub(crate) struct Work {
    /// Orders so far.
    orders: u64,
    running: Option<RunningCheck>,
    /// The live order that runs or waits.
    live_order: Option<u64>,
    /// What the last live order was for.
    live_key: Option<(u64, Fingerprint)>,
    live_result: Option<LiveResult>,
    /// Why the last live order gave nothing, and for which layout.
    live_refused: Option<(u64, String)>,
    /// The last results with their shape, which the project does not keep.
    shapes: Vec<(u64, Arc<Made>)>,
}

#[derive(Debug)]
struct LiveResult {
    uid: u64,
    made: Arc<Made>,
    more: bool,
}

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
    /// The result.
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

impl App {
    /// Fingerprint of a layout's check as the inputs are now; nothing where it cannot be checked.
    fn check_inputs(&self, index: usize, wanted: &Wanted) -> Option<Fingerprint> {
        let mesh = self.results.get(index)?.mesh()?;
        let wire = mesh.wire.as_ref()?;
        Some(fingerprint(&self.project.layouts.get(index)?.layout, wire, wanted))
    }

    /// The result of a layout that the project keeps, and whether it is current.
    pub fn kept_check(&self, index: usize) -> Option<ShownCheck<'_>> {
        let layout = self.project.layouts.get(index)?;
        let kept = layout.check.as_deref()?;
        let now = self.check_inputs(index, &kept.wanted);
        let current = now.is_some_and(|now| kept.current(now));
        let shape =
            self.work.shapes.iter().find(|(uid, made)| {
                *uid == layout.uid && made.result.inputs == kept.inputs && current
            });
        Some(ShownCheck {
            result: kept,
            relief: shape.and_then(|(_, made)| made.relief.as_ref()),
            standing: if current { Standing::Current } else { Standing::Stale },
        })
    }

    /// The result to show for the selected layout: a current one that was asked for, or else a live one
    /// of these inputs, or else a stale one.
    pub fn shown_check(&self) -> Option<ShownCheck<'_>> {
        let kept = self.kept_check(self.selected);
        if kept.is_some_and(|shown| !shown.stale()) || !self.live() {
            return kept;
        }
        let live = self.work.live_result.as_ref().filter(|l| l.uid == self.layout().uid);
        let Some(live) = live else { return kept };
        let now = self.check_inputs(self.selected, &live.made.result.wanted);
        let current = now.is_some_and(|now| live.made.result.current(now));
        if !current && kept.is_some() {
            return kept;
        }
        Some(ShownCheck {
            result: &live.made.result,
            relief: live.made.relief.as_ref().filter(|_| current),
            standing: if current { Standing::Live(live.more) } else { Standing::Stale },
        })
    }

    /// Why there is no live result for the selected layout.
    pub(crate) fn live_refusal(&self) -> Option<&str> {
        let (uid, why) = self.work.live_refused.as_ref()?;
        (self.live() && *uid == self.layout().uid).then_some(why.as_str())
    }

    /// The order of the user's that runs.
    pub fn running(&self) -> Option<&RunningCheck> {
        self.work.running.as_ref()
    }

    /// Whether a live check of the selected layout is under way.
    pub(crate) fn live_running(&self) -> bool {
        self.work.live_order.is_some()
    }

    /// The curves of the selected layout's runs as far as they have come.
    pub(crate) fn growing(&self) -> &[Vec<Point>] {
        let progress = self.work.running.as_ref().and_then(|r| r.progress.as_ref());
        match progress {
            Some(progress) if progress.uid == self.layout().uid => &progress.curves,
            _ => &[],
        }
    }

    /// Whether a quick check follows each edit.
    pub(crate) fn live(&self) -> bool {
        self.settings.live
    }

    /// What a check is asked for.
    pub(crate) fn wanted(&self) -> Wanted {
        Wanted { fidelity: self.settings.fidelity, runs: self.settings.runs, seed: 0 }
    }

    /// Takes the next fidelity.
    pub(super) fn next_fidelity(&mut self) -> Vec<Command> {
        let word = self.settings.neighbour(SettingItem::Fidelity, true);
        // The word is one of the list, so it is taken.
        let effects = self.set_setting(SettingItem::Fidelity, word).unwrap_or_default();
        let aim = 100.0 * self.settings.fidelity.aim();
        self.inform(format!("checks are {word}: errors within {} %", significant(aim, 1)));
        effects
    }

    fn target(&self, index: usize) -> Option<CheckTarget> {
        Some(CheckTarget { uid: self.project.layouts[index].uid, case: self.case(index)? })
    }

    pub(super) fn order(&mut self, task: Task) -> Order {
        self.work.orders += 1;
        Order { number: self.work.orders, task }
    }

    /// Orders the check of the selected layout, or of all.
    pub(super) fn start_check(&mut self, all: bool) -> Vec<Command> {
        let indices =
            if all { 0..self.project.layouts.len() } else { self.selected..self.selected + 1 };
        let targets: Vec<CheckTarget> = indices.filter_map(|i| self.target(i)).collect();
        if targets.is_empty() {
            self.complain("this layout's mesh is not known, so it cannot be checked");
            return Vec::new();
        }
        let running = RunningCheck { targets: targets.len(), ..RunningCheck::default() };
        let order =
            self.order(Task::Checks(Checks { targets, wanted: self.wanted(), live: false }));
        self.drop_campaign();
        self.work.running = Some(RunningCheck { number: order.number, ..running });
        // The worker ends a live check for it.
        self.work.live_order = None;
        vec![Command::Work(order)]
    }

    /// Forgets the orders that run or wait: one that was asked for takes their place.
    pub(super) fn give_way(&mut self) {
        self.work.running = None;
        self.work.live_order = None;
    }

    /// Ends what runs behind the screen.
    pub(super) fn stop_work(&mut self) -> Vec<Command> {
        if self.campaign().is_some() {
            return vec![Command::StopWork];
        }
        if self.work.running.is_none() && self.work.live_order.is_none() {
            self.inform("nothing is running; q quits, ? helps");
            return Vec::new();
        }
        if self.work.running.is_none() {
            self.inform("live check ended; l switches live mode off");
        }
        self.work.live_order = None;
        vec![Command::StopWork]
    }

    /// Switches live mode.
    pub(super) fn toggle_live(&mut self) -> Vec<Command> {
        let on = !self.live();
        // Both words are known.
        let effects =
            self.set_setting(SettingItem::Live, if on { "on" } else { "off" }).unwrap_or_default();
        if on {
            self.inform("live: a quick check follows each edit; l switches it off");
            return effects;
        }
        self.inform("live mode off");
        effects
    }

    /// Live mode was switched off: what it made goes, and what it runs ends.
    pub(super) fn end_live(&mut self) -> Option<Command> {
        self.work.live_key = None;
        self.work.live_result = None;
        let stop = self.work.live_order.take().is_some() && self.work.running.is_none();
        stop.then_some(Command::StopWork)
    }

    /// Another project takes the place of this one: what runs ends, and no result is left. Numbers of
    /// orders go on, so that late news of the former project find nobody.
    pub(super) fn forget_work(&mut self) -> Option<Command> {
        let campaign = self.campaign().is_some();
        let busy = campaign || self.work.running.is_some() || self.work.live_order.is_some();
        self.drop_campaign();
        self.work = Work { orders: self.work.orders, ..Work::default() };
        busy.then_some(Command::StopWork)
    }

    /// A live check, if the inputs are others than those of the last one.
    pub(super) fn follow_edit(&mut self) -> Option<Command> {
        if !self.live() {
            return None;
        }
        let wanted = live_wanted();
        let key = self.check_inputs(self.selected, &wanted).map(|now| (self.layout().uid, now));
        if key == self.work.live_key {
            return None;
        }
        self.work.live_key = key;
        self.work.live_refused = None;
        let known = self.kept_check(self.selected).is_some_and(|shown| !shown.stale());
        let target = self.target(self.selected).filter(|_| key.is_some() && !known);
        let Some(target) = target else {
            let stop = self.work.live_order.take().is_some() && self.work.running.is_none();
            return stop.then_some(Command::StopWork);
        };
        let order = self.order(Task::Checks(Checks { targets: vec![target], wanted, live: true }));
        self.work.live_order = Some(order.number);
        Some(Command::Work(order))
    }

    /// Takes news of work.
    pub(super) fn news(&mut self, news: News) {
        if self.campaign_news(&news) {
            return;
        }
        let asked = self.work.running.as_ref().is_some_and(|r| r.number == news.number);
        let live = self.work.live_order == Some(news.number);
        match news.what {
            What::Progress(progress) => {
                if let Some(running) = self.work.running.as_mut().filter(|_| asked) {
                    running.progress = Some(progress);
                }
            }
            What::Made { uid, made, more, live: true } => {
                if live {
                    self.work.live_result = Some(LiveResult { uid, made, more });
                }
            }
            What::Made { uid, made, .. } => self.keep_check(uid, made),
            What::Case { .. } => {}
            What::Refused { uid, problems } => {
                let why = summary(&problems);
                if live {
                    self.work.live_refused = Some((uid, why));
                    self.work.live_result = None;
                } else if asked {
                    let layout = self.project.layouts.iter().find(|l| l.uid == uid);
                    let name = layout.map_or(String::new(), |l| l.name.clone());
                    self.complain(format!("{name} cannot be checked: {why}"));
                    if let Some(running) = &mut self.work.running {
                        running.refused.push(name);
                    }
                }
            }
            What::Ended { cancelled } => {
                if live {
                    self.work.live_order = None;
                } else if asked {
                    self.ended(cancelled);
                }
            }
            What::Failed => {
                if live {
                    self.work.live_order = None;
                } else if asked {
                    self.work.running = None;
                }
            }
        }
    }

    fn ended(&mut self, cancelled: bool) {
        let Some(running) = self.work.running.take() else { return };
        if cancelled {
            self.inform("check ended early; what was done is kept");
        } else if running.targets > 1 {
            let good = running.targets - running.refused.len();
            let text = format!("{good} of {} layouts checked", running.targets);
            if running.refused.is_empty() {
                self.inform(text);
            } else {
                self.complain(format!("{text}; not possible: {}", running.refused.join(", ")));
            }
        }
    }

    /// Keeps a result in the project.
    fn keep_check(&mut self, uid: u64, made: Arc<Made>) {
        let Some(index) = self.project.layouts.iter().position(|l| l.uid == uid) else { return };
        let kept = &made.result;
        if kept.curve.deflection.is_empty() {
            return;
        }
        let have_better = self.kept_check(index).is_some_and(|old| {
            !old.stale() && !old.result.partial() && old.result.runs > kept.runs
        });
        if kept.partial() && have_better {
            return;
        }
        let name = &self.project.layouts[index].name;
        let text = if kept.broke() {
            format!(
                "{name}: {} at {}, {} {}",
                force_text(kept.force.mean),
                length_text(kept.deflection.mean, self.units()),
                kept.runs,
                if kept.runs == 1 { "run" } else { "runs" }
            )
        } else {
            format!("{name}: no wire broke, peak {}", force_text(kept.peak.force))
        };
        self.inform(text);
        let mut project = (*self.project).clone();
        project.layouts[index].check = Some(Arc::new(kept.clone()));
        self.project = Arc::new(project);
        self.work.shapes.retain(|(other, _)| *other != uid);
        self.work.shapes.push((uid, made));
    }

    /// Another state of the project with the results that there are now.
    pub(super) fn with_checks(&self, other: Arc<Project>) -> Arc<Project> {
        let newer = |uid: u64| self.project.layouts.iter().find(|l| l.uid == uid);
        let differs =
            |l: &crate::project::NamedLayout| newer(l.uid).is_some_and(|now| now.check != l.check);
        if !other.layouts.iter().any(differs) {
            return other;
        }
        let mut project = (*other).clone();
        for layout in &mut project.layouts {
            if let Some(now) = newer(layout.uid) {
                layout.check = now.check.clone();
            }
        }
        Arc::new(project)
    }
}
