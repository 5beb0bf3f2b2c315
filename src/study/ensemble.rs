//! An ensemble: the same scene over alignments and seeds.
//!
//! In the field the alignment of the net with the anchors is random: the mean and the band are what an
//! engineer should see. Where the runs stand among all alignments says [`super::sampling`]: run k has the
//! seed hash(seed, k) and a place of its own, so it is the same whatever the number of threads; and more
//! runs are made in whole rounds, so the answer is the same too.

use super::bias::Bias;
use super::clock;
use super::remark::{CheckFlag, CheckRemark, Facts};
pub(crate) use super::sampling::plan::{LEAST, MOST, Plan, TARGET};
pub(crate) use super::sampling::spread::{Spread, quantile};
use super::sampling::{self, Member, Placed, Sample};
use crate::dem::bifurcation;
use crate::dem::{
    Controls, Fidelity, Flow, RunOutcome, RunProgress, Scene, SceneSpec, Stop, check,
};
use crate::problem::Problem;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Revision of the sampling. Raise it with every change after which the same runs are drawn otherwise,
/// are not as many, or give other figures of the whole: seeds, alignments, the rule that ends an
/// ensemble, which runs count, means, bands, the mean curve, rounding. A kept check carries it and is
/// stale under another one; a test in [`super::result::revisions`] ties it to exact values.
pub(crate) const REVISION: u32 = 2;

/// One run of an ensemble.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    pub(crate) seed: u64,
    /// Its alignment.
    pub(crate) phase: [f64; 2],
    /// Number of its pattern of caught nodes in the sample, where there are patterns.
    pub(crate) pattern: Option<usize>,
    pub(crate) outcome: RunOutcome,
    /// Time on the wall from the start, set-up included, to the first break or the end, s.
    pub(crate) wall: f64,
    /// Processor time of its thread in the same span, s.
    pub(crate) processor: f64,
}

impl Ensemble {
    /// Whether it was ended before all its runs were made.
    pub(crate) fn partial(&self) -> bool {
        self.flags.contains(&CheckFlag::Cancelled)
    }
}

/// An ensemble and its figures.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    /// The runs in order of their number.
    pub(crate) runs: Vec<Run>,
    /// Where they stand among all alignments.
    pub(crate) sample: Sample,
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
    /// What was taken out of quick members, where they are.
    pub(crate) bias: Option<Bias>,
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
    let sample = Sample::of(&Scene::new(spec)?, plan);
    grown(spec, controls, plan, (sample, Vec::new()), progress, finished)
}

/// The same from the first runs of a sample on, where some are made.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(super) fn grown(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    (sample, mut runs): (Sample, Vec<Run>),
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    finished: &(dyn Fn(usize, &Run) + Sync),
) -> Result<Ensemble, Vec<Problem>> {
    let (mut whole, mut cancelled) = (0, false);
    loop {
        let goal = sample.goal(whole);
        if goal <= whole {
            break;
        }
        whole = goal;
        let list: Vec<usize> = (runs.len()..goal).collect();
        let tell =
            |run: usize, inner| progress(EnsembleProgress { done: run, planned: goal, run, inner });
        let made = members(spec, controls, &sample, &list, plan.threads, &tell, finished)?;
        runs.extend(made.runs.into_iter().map(|(_, run)| run));
        cancelled = made.cancelled;
        if cancelled || (plan.runs.is_none() && enough(&runs, &sample)) {
            break;
        }
    }
    let count = runs.len();
    let mut ensemble = summary(runs, sample);
    if !cancelled && bifurcation::suspect(spec) {
        let Member { seed, phase, .. } = ensemble.sample.member(0);
        let spec = SceneSpec { phase, seed, ..spec.clone() };
        let steps =
            &mut |inner| progress(EnsembleProgress { done: count, planned: count, run: 0, inner });
        ensemble.probe = bifurcation::probe(&spec, controls, steps)?;
        if ensemble.probe.is_some_and(|p| p.bifurcation()) {
            ensemble.flags.push(CheckFlag::Bifurcation);
        }
    }
    if cancelled {
        ensemble.flags.push(CheckFlag::Cancelled);
    }
    Ok(ensemble)
}

/// Members that were made, each with its number.
pub(super) struct Members {
    /// In the order of their list; those that the caller's end came before are missing.
    pub(super) runs: Vec<(usize, Run)>,
    /// Whether the caller ended it.
    pub(super) cancelled: bool,
}

/// Makes members of a sample, of these numbers, on so many threads. `tell` hears of a member's steps, and
/// `finished` of its end, from the thread that makes it.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(super) fn members(
    spec: &SceneSpec,
    controls: &Controls,
    sample: &Sample,
    list: &[usize],
    threads: usize,
    tell: &(dyn Fn(usize, RunProgress) -> Flow + Sync),
    finished: &(dyn Fn(usize, &Run) + Sync),
) -> Result<Members, Vec<Problem>> {
    let (next, cancelled) = (AtomicUsize::new(0), AtomicBool::new(false));
    let made: Mutex<Vec<Option<Run>>> = Mutex::new(vec![None; list.len()]);
    let failed: Mutex<Vec<Problem>> = Mutex::new(Vec::new());
    let worker = || {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(&k) = list.get(place).filter(|_| !cancelled.load(Ordering::Relaxed)) else {
                return;
            };
            let listen = |inner: RunProgress| {
                let stop = cancelled.load(Ordering::Relaxed) || tell(k, inner) == Flow::Cancel;
                if stop {
                    cancelled.store(true, Ordering::Relaxed);
                    return Flow::Cancel;
                }
                Flow::Continue
            };
            match single(spec, controls, sample.member(k), listen) {
                Ok(run) => {
                    finished(k, &run);
                    // A lock is only poisoned by a panic, and then what is in it is still whole.
                    made.lock().unwrap_or_else(PoisonError::into_inner)[place] = Some(run);
                }
                Err(problems) => {
                    cancelled.store(true, Ordering::Relaxed);
                    *failed.lock().unwrap_or_else(PoisonError::into_inner) = problems;
                }
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.clamp(1, list.len().max(1)) {
            scope.spawn(worker);
        }
        worker();
    });
    let problems = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    if !problems.is_empty() {
        return Err(problems);
    }
    let made = made.into_inner().unwrap_or_else(PoisonError::into_inner);
    let runs = list.iter().zip(made).filter_map(|(k, run)| Some((*k, run?))).collect();
    Ok(Members { runs, cancelled: cancelled.load(Ordering::Relaxed) })
}

/// One run, timed.
fn single(
    spec: &SceneSpec,
    controls: &Controls,
    Member { seed, phase, pattern }: Member,
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
    Ok(Run { seed, phase, pattern, outcome, wall: end.0 - start.0, processor: end.1 - start.1 })
}

/// Whether the runs pin the force down.
fn enough(runs: &[Run], sample: &Sample) -> bool {
    let broken = runs.iter().filter(|run| counts(run));
    let forces: Vec<Placed> =
        broken.filter_map(|run| Some(run.placed(run.outcome.first_break?.force))).collect();
    let force = sampling::figures(sample, &forces, &forces);
    forces.len() > 1 && force.error < TARGET * force.mean
}

/// The figures of some runs of a sample.
pub(crate) fn summary(runs: Vec<Run>, sample: Sample) -> Ensemble {
    let mut flags = Vec::new();
    if runs.iter().any(|run| run.outcome.stop == Stop::Diverged) {
        flags.push(CheckFlag::Diverged);
    }
    // A cancelled run's numbers are those of an unfinished test: kept, and not counted.
    let counted: Vec<&Run> = runs.iter().filter(|run| counts(run)).collect();
    let broken: Vec<&Run> =
        counted.iter().copied().filter(|run| run.outcome.first_break.is_some()).collect();
    let at_end = |run: &Run| run.outcome.first_break.unwrap_or(run.outcome.peak);
    let of = |runs: &[&Run], value: &dyn Fn(&Run) -> f64| -> Vec<Placed> {
        runs.iter().map(|run| run.placed(value(run))).collect()
    };
    let spread = |value: &dyn Fn(&Run) -> f64| {
        sampling::figures(&sample, &of(&broken, value), &of(&counted, value))
    };
    let mean = |value: &dyn Fn(&Run) -> f64| weighted_mean(&sample, &counted, value);
    let stiff: Vec<&Run> = counted.iter().copied().filter(|run| run.outcome.k75 > 0.0).collect();
    Ensemble {
        force: spread(&|run| at_end(run).force),
        deflection: spread(&|run| at_end(run).deflection),
        peak: [mean(&|run| run.outcome.peak.force), mean(&|run| run.outcome.peak.deflection)],
        k75: weighted_mean(&sample, &stiff, &|run| run.outcome.k75),
        slipped: counted.iter().filter(|run| run.outcome.stop == Stop::Slipped).count(),
        flags,
        bias: None,
        probe: None,
        runs,
        sample,
    }
}

/// Mean of a value over some runs of a sample; 0 of none.
pub(crate) fn weighted_mean(sample: &Sample, runs: &[&Run], value: &dyn Fn(&Run) -> f64) -> f64 {
    runs.iter().zip(weights(sample, runs)).map(|(run, weight)| weight * value(run)).sum()
}

/// What each of some runs of a sample weighs in their mean.
pub(crate) fn weights(sample: &Sample, runs: &[&Run]) -> Vec<f64> {
    let patterns: Vec<Option<usize>> = runs.iter().map(|run| run.pattern).collect();
    sampling::weights(sample, &patterns)
}

impl Run {
    /// A value of it where it stands.
    pub(crate) fn placed(&self, value: f64) -> Placed {
        Placed { pattern: self.pattern, phase: self.phase, value }
    }
}

/// Whether a run counts: it came to an end of its own, or at least to its first break.
pub(crate) fn counts(run: &Run) -> bool {
    let outcome = &run.outcome;
    outcome.stop != Stop::Diverged
        && !(outcome.stop == Stop::Cancelled && outcome.first_break.is_none())
}

impl Ensemble {
    /// The remarks on it; `aligned` says whether its runs were given one alignment, `fidelity`
    /// what each of them has, where that is not the ensemble's own choice.
    pub(crate) fn remarks(&self, fidelity: Option<Fidelity>, aligned: bool) -> Vec<CheckRemark> {
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
