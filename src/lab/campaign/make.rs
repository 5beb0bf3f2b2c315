//! Making the runs of a campaign, on several threads, and handing them on in order of their number.

use super::row::Row;
use super::{CampaignPlan, Sample};
use crate::dem::{Controls, Flow, RunProgress, Stop, check};
use crate::mesh::wire::WireData;
use crate::study::clock::thread_seconds;
use crate::study::ensemble::EnsembleProgress;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// How a campaign ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CampaignEnd {
    /// Whether all its lines are made.
    pub(crate) whole: bool,
    /// Processor time within its runs, s.
    pub(crate) processor: f64,
}

/// What is handed on, and what waits for one before it.
struct Queue<'a> {
    next: usize,
    waiting: BTreeMap<usize, Row>,
    hand_on: &'a mut (dyn FnMut(Row) -> Flow + Send),
    processor: f64,
}

/// Makes the lines of a campaign from line `from` on. `hand_on` gets them in order of their number and
/// may end the whole, as may `progress`, which is called from every thread. Whatever the threads, the same
/// lines come in the same order.
pub(crate) fn make(
    plan: &CampaignPlan,
    wire: &WireData,
    from: usize,
    threads: usize,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    hand_on: &mut (dyn FnMut(Row) -> Flow + Send),
) -> CampaignEnd {
    let lines = plan.lines();
    let next = AtomicUsize::new(from);
    let cancelled = AtomicBool::new(false);
    let queue = Mutex::new(Queue { next: from, waiting: BTreeMap::new(), hand_on, processor: 0.0 });
    let worker = || {
        loop {
            let k = next.fetch_add(1, Ordering::Relaxed);
            if k >= lines || cancelled.load(Ordering::Relaxed) {
                return;
            }
            let tell = |inner: RunProgress| {
                // Counted from the first line that is made now, so that the time left is that of these.
                let (done, planned) = (k - from, lines - from);
                let told = EnsembleProgress { done, planned, run: done, inner };
                let stop = cancelled.load(Ordering::Relaxed) || progress(told) == Flow::Cancel;
                if stop { Flow::Cancel } else { Flow::Continue }
            };
            let start = thread_seconds();
            let row = one(&plan.sample(k), k, plan, wire, tell);
            let spent = thread_seconds() - start;
            let going = match row {
                Some(row) => lock(&queue).take(row, spent),
                None => Flow::Cancel,
            };
            if going == Flow::Cancel {
                cancelled.store(true, Ordering::Relaxed);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.clamp(1, lines.saturating_sub(from).max(1)) {
            scope.spawn(worker);
        }
        worker();
    });
    let queue = queue.into_inner().unwrap_or_else(PoisonError::into_inner);
    CampaignEnd { whole: queue.next >= lines, processor: queue.processor }
}

/// A lock is only poisoned by a panic, and what it holds is still whole then.
fn lock<'a, 'b>(queue: &'b Mutex<Queue<'a>>) -> MutexGuard<'b, Queue<'a>> {
    queue.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Queue<'_> {
    /// Takes a line, and hands on all that have none missing before them.
    fn take(&mut self, row: Row, spent: f64) -> Flow {
        self.processor += spent;
        self.waiting.insert(row.run, row);
        while let Some(row) = self.waiting.remove(&self.next) {
            if (self.hand_on)(row) == Flow::Cancel {
                return Flow::Cancel;
            }
            self.next += 1;
        }
        Flow::Continue
    }
}

/// Run k; nothing where it was ended early.
fn one(
    sample: &Sample,
    k: usize,
    plan: &CampaignPlan,
    wire: &WireData,
    mut tell: impl FnMut(RunProgress) -> Flow,
) -> Option<Row> {
    if let Some(row) = Row::refused(k, sample) {
        return Some(row);
    }
    // The first break is all that is asked.
    let controls = Controls { fidelity: plan.fidelity, after_break: 0.0, ..Controls::default() };
    match check(&sample.scene(wire), &controls, &mut tell) {
        Ok(outcome) if outcome.stop == Stop::Cancelled => None,
        Ok(outcome) => Some(Row::of(k, sample, &outcome)),
        Err(found) => Some(Row::impossible(k, sample, &found)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::row::{Kind, RowEnd};
    use super::*;
    use crate::layout::Blocks;
    use crate::mesh::laws;

    fn small(blocks: Blocks, runs: usize) -> CampaignPlan {
        // Small panels, so that a run takes milliseconds.
        let ranges = [[0.2, 0.3], [1.25, 1.7], [0.1, 1.5]];
        CampaignPlan { blocks, runs, ranges, seed: 5, ..CampaignPlan::default() }
    }

    fn made(plan: &CampaignPlan, from: usize, threads: usize) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut take = |row| {
            rows.push(row);
            Flow::Continue
        };
        let end = make(plan, &laws::reference(), from, threads, &|_| Flow::Continue, &mut take);
        assert!(end.whole && end.processor > 0.0);
        rows
    }

    #[test]
    fn the_lines_come_in_order_and_are_the_same_from_any_line_on_and_on_any_threads() {
        let plan = small(Blocks::Repeated, 16);
        let all = made(&plan, 0, 1);
        assert_eq!(all.len(), plan.lines());
        assert!(all.iter().enumerate().all(|(k, row)| row.run == k));
        assert_eq!(made(&plan, 0, 3), all);
        assert_eq!(made(&plan, 7, 2)[..], all[7..]);
        // What has no run stays, with its reason.
        assert!(all.iter().any(|row| row.end != RowEnd::Broke && row.force_kn.is_none()));
        let broke = all.iter().filter(|row| row.end == RowEnd::Broke);
        for row in broke {
            assert!(
                row.force_kn.is_some()
                    && row.delta_m.is_some()
                    && row.curve.len() == 21
                    && row.first.is_some()
            );
        }
    }

    #[test]
    fn mirrored_blocks_that_overlap_stay_in_the_table() {
        let all = made(&small(Blocks::Mirrored, 12), 0, 1);
        let ends: Vec<RowEnd> =
            all.iter().filter(|row| row.kind == Kind::Eccentric).map(|row| row.end).collect();
        assert!(ends.contains(&RowEnd::BlocksOverlap), "{ends:?}");
    }

    #[test]
    fn a_campaign_that_is_ended_keeps_the_lines_that_were_handed_on() {
        let plan = small(Blocks::Repeated, 16);
        let mut rows = Vec::new();
        let mut take = |row: Row| {
            rows.push(row);
            if rows.len() == 3 { Flow::Cancel } else { Flow::Continue }
        };
        let end = make(&plan, &laws::reference(), 0, 1, &|_| Flow::Continue, &mut take);
        assert!(!end.whole && rows.len() == 3);
        let end = make(&plan, &laws::reference(), 0, 1, &|_| Flow::Cancel, &mut |_| Flow::Continue);
        assert!(!end.whole);
    }
}
