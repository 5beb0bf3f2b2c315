//! Checks of layouts behind the screen.

use super::desk::Ticket;
use super::news::{Progress, What};
use super::pace::{Pace, QUIET};
use crate::case::Case;
use crate::curve::Point;
use crate::dem::Flow;
use crate::study::ensemble::{Ensemble, EnsembleProgress, Run, summary};
use crate::study::result::make::{Made, Told, fingerprint, make, samples, wires};
use crate::study::result::relief::Relief;
use crate::study::result::{CheckResult, Wanted};
use crate::study::sampling::Sample;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Punch displacement between two points of a growing curve, m.
const SPACING: f64 = 0.008;

/// Checks to be made, one after the other.
#[derive(Debug, Clone)]
pub struct Checks {
    /// What to check.
    pub targets: Vec<CheckTarget>,
    /// How.
    pub wanted: Wanted,
    /// Whether nobody asked for it: then what the runs so far say is told as they come.
    pub live: bool,
}

/// A layout to check.
#[derive(Debug, Clone)]
pub struct CheckTarget {
    /// Which layout it is.
    pub uid: u64,
    /// The layout.
    pub case: Case,
}

/// What is known of the runs of one layout.
struct Seen {
    pace: Pace,
    curves: Vec<Vec<Point>>,
    runs: Vec<(usize, Run)>,
    spoke: Option<Instant>,
    done: usize,
}

impl Checks {
    /// Makes them, until the ticket says to end.
    pub(super) fn carry_out(&self, threads: usize, ticket: &Ticket, say: &(dyn Fn(What) + Sync)) {
        let start = Instant::now();
        for (part, target) in self.targets.iter().enumerate() {
            if ticket.cancelled() {
                return;
            }
            let mut pace = Pace::default();
            let behind = self.wanted.controls().after_break;
            pace.begin(part, self.targets.len(), target.case.expected_break() + behind);
            let seen = Mutex::new(Seen {
                pace,
                curves: Vec::new(),
                runs: Vec::new(),
                // Not before a quarter of a second has passed is there anything worth a frame.
                spoke: Some(start),
                done: 0,
            });
            let listen = |told: Told| {
                // Nothing that holds the lock can panic halfway.
                let mut seen = seen.lock().unwrap_or_else(PoisonError::into_inner);
                match told {
                    Told::Progress(now) => {
                        seen.progress(&now);
                        if seen.due() {
                            let progress = seen.told(part, self.targets.len(), target, &now, start);
                            drop(seen);
                            say(What::Progress(progress));
                        }
                    }
                    Told::Finished(k, run) => {
                        let first = seen.done == 0;
                        seen.done += 1;
                        if self.live && !ticket.cancelled() {
                            seen.runs.push((k, run.clone()));
                            if first || seen.due() {
                                let made = self.so_far(&seen, target);
                                drop(seen);
                                if let Some(made) = made {
                                    say(What::Made {
                                        uid: target.uid,
                                        made: Arc::new(made),
                                        more: true,
                                        live: true,
                                    });
                                }
                            }
                        }
                    }
                }
                if ticket.cancelled() { Flow::Cancel } else { Flow::Continue }
            };
            let (layout, uid) = (&target.case.layout, target.uid);
            match make(layout, &target.case.mesh, &self.wanted, threads, &listen) {
                // A live check that was overtaken is of no use to anybody.
                Ok(_) if self.live && ticket.cancelled() => {}
                Ok(made) => {
                    say(What::Made { uid, made: Arc::new(made), more: false, live: self.live });
                }
                Err(problems) => say(What::Refused { uid, problems }),
            }
        }
    }

    /// What the runs so far say.
    fn so_far(&self, seen: &Seen, target: &CheckTarget) -> Option<Made> {
        let mut runs = seen.runs.clone();
        runs.sort_by_key(|(k, _)| *k);
        let wire = wires(&target.case.mesh).ok()?;
        let samples = samples(&target.case.layout, wire, &self.wanted).ok()?;
        let ensemble = lowest(runs, samples, self.wanted.runs)?;
        let net = ensemble.runs.first().and_then(|run| run.outcome.net.as_ref());
        let relief = net.map(|net| Relief::from_net(net, &target.case.layout));
        let inputs = fingerprint(&target.case.layout, wire, &self.wanted);
        let mut result = CheckResult::from_ensemble(&ensemble, &self.wanted, inputs);
        // A first run goes on behind its break; the mean of several does not, and the chart would jump.
        if let Some(end) = result.curve.failure {
            let before = result.curve.points().filter(|p| p.deflection <= end.deflection).count();
            result.curve.deflection.truncate(before);
            result.curve.force.truncate(before);
        }
        Some(Made { result, relief })
    }
}

/// The figures of the arrangement that takes the least so far, each weighed by its own sample; `each` is how many
/// runs an arrangement has, where that was asked for. Nothing of no runs.
fn lowest(runs: Vec<(usize, Run)>, samples: Vec<Sample>, each: Option<usize>) -> Option<Ensemble> {
    let last = samples.len().checked_sub(1)?;
    let part = |k: usize| each.map_or(0, |each| k / each.max(1)).min(last);
    let of = |(at, sample): (usize, Sample)| {
        let mine = runs.iter().filter(|(k, _)| part(*k) == at).map(|(_, run)| run.clone());
        let mine: Vec<Run> = mine.collect();
        (!mine.is_empty()).then(|| summary(mine, sample))
    };
    let force = |e: &Ensemble| if e.force.mean > 0.0 { e.force.mean } else { e.peak[0] };
    let made = samples.into_iter().enumerate().filter_map(of);
    made.min_by(|a, b| force(a).total_cmp(&force(b)))
}

impl Seen {
    fn progress(&mut self, now: &EnsembleProgress) {
        self.pace.take(now.run, now.planned, &now.inner);
        if self.curves.len() <= now.run {
            self.curves.resize(now.run + 1, Vec::new());
        }
        let curve = &mut self.curves[now.run];
        let point = Point { deflection: now.inner.deflection, force: now.inner.force };
        match curve.last() {
            // A run that is repeated begins anew.
            Some(last) if last.deflection > point.deflection => *curve = vec![point],
            Some(last) if point.deflection - last.deflection < SPACING => {}
            _ => curve.push(point),
        }
    }

    /// Whether it is time for another word; if so it counts as spoken.
    fn due(&mut self) -> bool {
        let due = self.spoke.is_none_or(|at| at.elapsed() >= QUIET);
        if due {
            self.spoke = Some(Instant::now());
        }
        due
    }

    fn told(
        &self,
        part: usize,
        parts: usize,
        target: &CheckTarget,
        now: &EnsembleProgress,
        start: Instant,
    ) -> Progress {
        Progress {
            uid: target.uid,
            part,
            parts,
            done: self.done,
            planned: now.planned,
            fraction: self.pace.fraction(),
            left: self.pace.left(start.elapsed().as_secs_f64()),
            curves: self.curves.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::{Order, Task};
    use super::*;
    use crate::case::example;
    use crate::layout::{Layout, REFERENCE};
    use crate::study::exactness::Exactness;

    fn order(live: bool, spacings: &[f64]) -> Order {
        let target = |(uid, spacing): (usize, &f64)| CheckTarget {
            uid: uid as u64,
            case: example(Layout { spacing: *spacing, punch: 0.5, ..REFERENCE }, None),
        };
        let targets = spacings.iter().enumerate().map(target).collect();
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(3), seed: 0 };
        Order { number: 7, task: Task::Checks(Checks { targets, wanted, live }) }
    }

    fn news(order: &Order, ticket: &Ticket) -> Vec<What> {
        let heard = Mutex::new(Vec::new());
        order.carry_out(2, ticket, &|news| {
            assert_eq!(news.number, 7);
            heard.lock().unwrap().push(news.what);
        });
        heard.into_inner().unwrap()
    }

    #[test]
    fn every_layout_gets_its_result_or_its_reason() {
        // The second cannot be: the punch is wider than the panel.
        let heard = news(&order(false, &[1.5, 0.4, 1.4]), &Ticket::default());
        let results: Vec<String> = heard
            .iter()
            .filter_map(|what| match what {
                What::Made { uid, made, more: false, .. } => {
                    Some(format!("{uid}: {} runs", made.result.runs))
                }
                What::Refused { uid, .. } => Some(format!("{uid}: refused")),
                What::Ended { cancelled } => Some(format!("ended {cancelled}")),
                _ => None,
            })
            .collect();
        assert_eq!(results, ["0: 3 runs", "1: refused", "2: 3 runs", "ended false"]);
    }

    #[test]
    fn a_live_check_tells_its_first_run_at_once() {
        let heard = news(&order(true, &[1.5]), &Ticket::default());
        let made: Vec<(usize, bool)> = heard
            .iter()
            .filter_map(|what| match what {
                What::Made { made, more, .. } => Some((made.result.runs, *more)),
                _ => None,
            })
            .collect();
        assert_eq!(made.first(), Some(&(1, true)));
        assert_eq!(made.last(), Some(&(3, false)));
    }

    #[test]
    fn a_cancelled_order_ends_and_says_so() {
        let ticket = Ticket::default();
        ticket.cancel();
        let heard = news(&order(false, &[1.5, 1.4]), &ticket);
        assert!(matches!(heard.as_slice(), [What::Ended { cancelled: true }]));
    }

    #[test]
    fn a_live_check_of_worst_blocks_tells_the_lower_arrangement_by_itself() {
        let layout = Layout { spacing: 1.8, punch: 0.5, ex: 0.25, ey: 0.35, ..REFERENCE };
        let layout = Layout { blocks: crate::layout::Blocks::Worst, ..layout };
        let wanted =
            Wanted { fidelity: crate::study::exactness::Exactness::Quick, runs: Some(2), seed: 0 };
        let case = example(layout, None);
        let runs = Mutex::new(Vec::new());
        let whole = make(&layout, &case.mesh, &wanted, 1, &|told| {
            if let Told::Finished(k, run) = told {
                runs.lock().unwrap().push((k, run.clone()));
            }
            Flow::Continue
        });
        let (runs, whole) = (runs.into_inner().unwrap(), whole.unwrap().result);
        assert_eq!(runs.len(), 4, "two of each arrangement");
        let wire = wires(&case.mesh).unwrap();
        let lowest_of = |runs: &[(usize, Run)]| {
            let samples = samples(&layout, wire, &wanted).unwrap();
            lowest(runs.to_vec(), samples, wanted.runs).unwrap()
        };
        // All of them say what the check says at its end; those of the first say what repeated blocks do.
        let all = lowest_of(&runs);
        assert!((all.force.mean / whole.force.mean - 1.0).abs() < 1e-4);
        assert_eq!(all.runs.len(), 2);
        let repeated = Layout { blocks: crate::layout::Blocks::Repeated, ..layout };
        let repeated = make(&repeated, &case.mesh, &wanted, 1, &|_| Flow::Continue).unwrap().result;
        assert!(whole.force.mean < 0.95 * repeated.force.mean, "mirrored ones take less here");
        let first = lowest_of(&runs[..2]);
        assert!((first.force.mean / repeated.force.mean - 1.0).abs() < 1e-4);
    }
}
