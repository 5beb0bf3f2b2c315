//! An ensemble: the same scene over random alignments and seeds.
//!
//! Run k has the seed hash(seed, k) and a phase of its own, so run k is the same whatever the number
//! of threads; and the number of runs is decided from the first runs in order, so the whole answer is
//! too. In the field the alignment of the net with the anchors is random: the mean and the band are
//! what an engineer should see.

use super::clock;
pub(crate) use super::remark::TARGET;
use super::remark::{CheckFlag, CheckRemark, Facts};
use crate::dem::bifurcation;
use crate::dem::hash::{hash, uniform};
use crate::dem::{Controls, Fidelity, Flow, RunOutcome, RunProgress, SceneSpec, Stop, check};
use crate::problem::Problem;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Revision of the sampling. Raise it with every change after which the same runs are drawn otherwise,
/// are not as many, or give other figures of the whole: seeds, alignments, the rule that ends an
/// ensemble, which runs count, means, bands, the mean curve, rounding. A kept check carries it and is
/// stale under another one; a test in [`super::result::revisions`] ties it to exact values.
pub(crate) const REVISION: u32 = 1;

/// Runs made at least, where the caller does not say how many.
pub(crate) const LEAST: usize = 8;
/// Runs made at most.
pub(crate) const MOST: usize = 64;

/// How an ensemble is made.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    /// Number of runs; nothing means at least [`LEAST`] and more until the standard error of the
    /// force is below [`TARGET`] or [`MOST`] are done.
    pub(crate) runs: Option<usize>,
    /// Seed of the ensemble.
    pub(crate) seed: u64,
    /// The same alignment for every run; nothing means a random one for each.
    pub(crate) phase: Option<[f64; 2]>,
    /// Threads, at least 1.
    pub(crate) threads: usize,
}

impl Default for Plan {
    fn default() -> Self {
        Plan { runs: None, seed: 0, phase: None, threads: 1 }
    }
}

/// One run of an ensemble.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Its seed.
    pub(crate) seed: u64,
    /// Its alignment.
    pub(crate) phase: [f64; 2],
    /// Its outcome.
    pub(crate) outcome: RunOutcome,
    /// Time on the wall from the start, set-up included, to the first break or the end, s.
    pub(crate) wall: f64,
    /// Processor time of its thread in the same span, s.
    pub(crate) processor: f64,
}

/// Mean, spread and extremes of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation of a single run.
    pub deviation: f64,
    /// Standard error of the mean.
    pub error: f64,
    /// 5 % and 95 % points.
    pub band: [f64; 2],
}

impl Ensemble {
    /// Whether it was ended before all its runs were made.
    pub(crate) fn partial(&self) -> bool {
        self.flags.contains(&CheckFlag::Cancelled)
    }
}

impl Spread {
    /// Standard error of the mean, over it.
    pub(crate) fn uncertainty(&self) -> f64 {
        self.error / self.mean.max(f64::MIN_POSITIVE)
    }

    /// Of `values`; the band of `banded`, which may hold more.
    pub(crate) fn of(values: &[f64], banded: &[f64]) -> Spread {
        let n = values.len() as f64;
        if values.is_empty() {
            return Spread {
                band: [quantile(banded, 0.05), quantile(banded, 0.95)],
                ..Spread::default()
            };
        }
        let mean = values.iter().sum::<f64>() / n;
        let squares = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>();
        let deviation = if n > 1.0 { (squares / (n - 1.0)).sqrt() } else { 0.0 };
        Spread {
            mean,
            deviation,
            error: deviation / n.sqrt(),
            band: [quantile(banded, 0.05), quantile(banded, 0.95)],
        }
    }
}

/// Quantile of unsorted values by linear interpolation; 0 without values.
pub(crate) fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
    let place = part * last as f64;
    let low = (place.floor() as usize).min(last);
    let high = (low + 1).min(last);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

/// An ensemble and its figures.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    /// The runs in order of their number.
    pub(crate) runs: Vec<Run>,
    /// Force at the first break, N; slipped runs stand in the band by their peak and not in the mean.
    pub(crate) force: Spread,
    /// Deflection at the first break, m; likewise.
    pub(crate) deflection: Spread,
    /// Means of the peaks' force, N, and deflection, m.
    pub(crate) peak: [f64; 2],
    /// Mean of k75, N/m.
    pub(crate) k75: f64,
    /// How many runs slipped.
    pub(crate) slipped: usize,
    /// What it tells of itself.
    pub(crate) flags: Vec<CheckFlag>,
    /// The two places of the bifurcation probe, N, where it was made.
    pub(crate) probe: Option<bifurcation::Probe>,
}

/// How far an ensemble has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnsembleProgress {
    /// Runs done.
    pub(crate) done: usize,
    /// Runs to be made as far as is known now.
    pub(crate) planned: usize,
    /// Number of the run that speaks.
    pub(crate) run: usize,
    /// How far that one has come.
    pub(crate) inner: RunProgress,
}

/// Seed and alignment of run `k`.
pub(crate) fn draw(plan: &Plan, k: usize) -> (u64, [f64; 2]) {
    let seed = hash(plan.seed, k as u64);
    // Counters far beyond any bond's number, so that slack and alignment are unrelated.
    let phase = plan.phase.unwrap_or([uniform(seed, u64::MAX), uniform(seed, u64::MAX - 1)]);
    (seed, phase)
}

/// Makes an ensemble of `spec`, whose own phase and seed are not used.
///
/// `progress` is called from every thread and may end the whole; what is done by then is kept.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(crate) fn run(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
) -> Result<Ensemble, Vec<Problem>> {
    run_watched(spec, controls, plan, progress, &|_, _| {})
}

/// The same; `finished` is told the number and the outcome of every run when it has ended, from the
/// thread that made it and in no particular order.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(crate) fn run_watched(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    finished: &(dyn Fn(usize, &Run) + Sync),
) -> Result<Ensemble, Vec<Problem>> {
    let cancelled = AtomicBool::new(false);
    let done: Mutex<Vec<Option<Run>>> = Mutex::new(Vec::new());
    let mut problems = Vec::new();
    let mut count = 0;
    loop {
        // The next batch: up to the least number at first, then as many as there are threads.
        let goal = match plan.runs {
            Some(n) => n.max(1),
            None if count < LEAST => LEAST,
            None => (count + plan.threads.max(1)).min(MOST),
        };
        if goal <= count || cancelled.load(Ordering::Relaxed) {
            break;
        }
        done.lock().unwrap_or_else(std::sync::PoisonError::into_inner).resize(goal, None);
        let next = AtomicUsize::new(count);
        let failed: Mutex<Vec<Problem>> = Mutex::new(Vec::new());
        let worker = || {
            loop {
                let k = next.fetch_add(1, Ordering::Relaxed);
                if k >= goal || cancelled.load(Ordering::Relaxed) {
                    return;
                }
                let tell = |inner: RunProgress| {
                    let told = EnsembleProgress { done: k.min(goal), planned: goal, run: k, inner };
                    let stop = cancelled.load(Ordering::Relaxed) || progress(told) == Flow::Cancel;
                    if stop {
                        cancelled.store(true, Ordering::Relaxed);
                        return Flow::Cancel;
                    }
                    Flow::Continue
                };
                match single(spec, controls, draw(plan, k), tell) {
                    Ok(run) => {
                        finished(k, &run);
                        // A lock is only poisoned by a panic, and then the runs in it are still whole.
                        done.lock().unwrap_or_else(std::sync::PoisonError::into_inner)[k] =
                            Some(run);
                    }
                    Err(found) => {
                        cancelled.store(true, Ordering::Relaxed);
                        *failed.lock().unwrap_or_else(std::sync::PoisonError::into_inner) = found;
                    }
                }
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..plan.threads.max(1).min(goal - count) {
                scope.spawn(worker);
            }
            worker();
        });
        problems = failed.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        if !problems.is_empty() {
            break;
        }
        count = goal;
        if plan.runs.is_none() {
            let runs = done.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            if enough(&runs).is_some() {
                break;
            }
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let mut runs = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    if plan.runs.is_none()
        && let Some(n) = enough(&runs)
    {
        runs.truncate(n);
    }
    let mut ensemble = summary(runs.into_iter().flatten().collect());
    if !cancelled.load(Ordering::Relaxed) && bifurcation::suspect(spec) {
        let mut spec = spec.clone();
        (spec.seed, spec.phase) = draw(plan, 0);
        let steps =
            &mut |inner| progress(EnsembleProgress { done: count, planned: count, run: 0, inner });
        ensemble.probe = bifurcation::probe(&spec, controls, steps)?;
        if ensemble.probe.is_some_and(|p| p.bifurcation()) {
            ensemble.flags.push(CheckFlag::Bifurcation);
        }
    }
    if cancelled.load(Ordering::Relaxed) {
        ensemble.flags.push(CheckFlag::Cancelled);
    }
    Ok(ensemble)
}

/// One run, timed.
fn single(
    spec: &SceneSpec,
    controls: &Controls,
    (seed, phase): (u64, [f64; 2]),
    mut tell: impl FnMut(RunProgress) -> Flow,
) -> Result<Run, Vec<Problem>> {
    let spec = SceneSpec { phase, seed, ..spec.clone() };
    let now = || (clock::wall_seconds(), clock::thread_seconds());
    let start = now();
    let mut at_break = None;
    let outcome = check(&spec, controls, &mut |inner| {
        if inner.broken && at_break.is_none() {
            at_break = Some(now());
        }
        tell(inner)
    })?;
    let end = at_break.unwrap_or_else(now);
    Ok(Run { seed, phase, outcome, wall: end.0 - start.0, processor: end.1 - start.1 })
}

/// The least number of first runs, at least [`LEAST`], that pin the force down; nothing if there are
/// not enough.
fn enough(runs: &[Option<Run>]) -> Option<usize> {
    (LEAST..=runs.len()).find(|&n| {
        let forces: Vec<f64> = runs[..n]
            .iter()
            .flatten()
            .filter_map(|run| run.outcome.first_break)
            .map(|p| p.force)
            .collect();
        let force = Spread::of(&forces, &[]);
        n >= MOST || (forces.len() > 1 && force.error < TARGET * force.mean)
    })
}

/// The figures of some runs.
pub(crate) fn summary(runs: Vec<Run>) -> Ensemble {
    let mut flags = Vec::new();
    // A cancelled run's numbers are those of an unfinished test: kept, and not counted.
    let counted: Vec<&RunOutcome> = runs
        .iter()
        .map(|run| &run.outcome)
        .filter(|o| !(o.stop == Stop::Cancelled && o.first_break.is_none()))
        .filter(|o| o.stop != Stop::Diverged)
        .collect();
    if runs.iter().any(|run| run.outcome.stop == Stop::Diverged) {
        flags.push(CheckFlag::Diverged);
    }
    let breaks: Vec<_> = counted.iter().filter_map(|o| o.first_break).collect();
    let banded: Vec<_> = counted.iter().map(|o| o.first_break.unwrap_or(o.peak)).collect();
    let force = |p: &[crate::curve::Point]| p.iter().map(|p| p.force).collect::<Vec<f64>>();
    let deflection =
        |p: &[crate::curve::Point]| p.iter().map(|p| p.deflection).collect::<Vec<f64>>();
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / (values.len().max(1)) as f64;
    Ensemble {
        force: Spread::of(&force(&breaks), &force(&banded)),
        deflection: Spread::of(&deflection(&breaks), &deflection(&banded)),
        peak: [
            mean(counted.iter().map(|o| o.peak.force).collect()),
            mean(counted.iter().map(|o| o.peak.deflection).collect()),
        ],
        k75: mean(counted.iter().map(|o| o.k75).filter(|k| *k > 0.0).collect()),
        slipped: counted.iter().filter(|o| o.stop == Stop::Slipped).count(),
        flags,
        probe: None,
        runs,
    }
}

/// Whether a run counts: it came to an end of its own, or at least to its first break.
pub(crate) fn counts(run: &Run) -> bool {
    let outcome = &run.outcome;
    outcome.stop != Stop::Diverged
        && !(outcome.stop == Stop::Cancelled && outcome.first_break.is_none())
}

impl Ensemble {
    /// The remarks on it; `aligned` says whether its runs were given one alignment.
    pub(crate) fn remarks(&self, fidelity: Fidelity, aligned: bool) -> Vec<CheckRemark> {
        let counted: Vec<_> = self.runs.iter().filter(|run| counts(run)).collect();
        let broken = counted.iter().filter(|run| run.outcome.first_break.is_some()).count();
        let diverged = self.runs.iter().filter(|r| r.outcome.stop == Stop::Diverged).count();
        let errors = self.runs.iter().map(|run| run.outcome.quality.error_estimate);
        let facts = Facts {
            flags: &self.flags,
            probe: self.probe,
            diverged: Some(diverged),
            runs: counted.len(),
            broken,
            slipped: self.slipped,
            aligned,
            force_error: self.force.uncertainty(),
            error_estimate: errors.fold(0.0, f64::max),
            fidelity,
        };
        facts.remarks()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_of_known_numbers() {
        let s = Spread::of(&[1.0, 2.0, 3.0, 4.0], &[0.0, 10.0]);
        // Mean 2.5; sum of squares 5, over 3; quantiles of two numbers by interpolation.
        assert!(
            (s.mean - 2.5).abs() < 1e-15 && (s.deviation - (5.0_f64 / 3.0).sqrt()).abs() < 1e-15
        );
        assert!((s.error - s.deviation / 2.0).abs() < 1e-15);
        assert!((s.band[0] - 0.5).abs() < 1e-12 && (s.band[1] - 9.5).abs() < 1e-12);
    }

    #[test]
    fn runs_have_phases_of_their_own_spread_over_the_period() {
        let plan = Plan::default();
        let phases: Vec<[f64; 2]> = (0..400).map(|k| draw(&plan, k).1).collect();
        for axis in 0..2 {
            let mean = phases.iter().map(|p| p[axis]).sum::<f64>() / 400.0;
            // Standard error of the mean of 400 uniforms: 0.0144; four of them.
            assert!((mean - 0.5).abs() < 0.058, "{mean}");
            assert!(phases.iter().all(|p| (0.0..1.0).contains(&p[axis])));
        }
    }
}
