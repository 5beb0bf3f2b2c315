//! Members as cheap as they may be: quick runs, with their bias taken out by a few standard ones.
//!
//! A quick run and a standard one of the same alignment and slack differ by a part that hardly depends on
//! either: 0.3 to 0.4 % of scatter about a bias of 0.3 to 0.6 % on three layouts of 240 pairs each. So
//! most members are quick; the others are made again at standard fidelity and stand for themselves, and
//! what they give over the quick ones multiplies the rest. The error of that factor counts in the standard
//! error. A block off all lines of symmetry makes quick runs differ by 1.6 % from pair to pair, small
//! blocks and the laboratory were not looked at: there all members are standard ones, as is a run of one
//! given alignment.

use super::bias::Bias;
use super::ensemble::{
    self, Ensemble, EnsembleProgress, Plan, Run, TARGET, counts, single, summary,
};
use super::remark::CheckFlag;
use super::sampling::{Kind, Sample};
use crate::dem::{Controls, Fidelity, Flow, RunOutcome, RunProgress, Scene, SceneSpec};
use crate::problem::Problem;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Standard deviation of standard over quick force, and deflection, from pair to pair, as long as pairs do
/// not say otherwise; for how many pairs it counts.
const ASSUMED: [f64; 2] = [0.004, 0.002];
const PRIOR: f64 = 2.0;
/// Pairs made at first, and then at a time.
const PAIRS: usize = 2;

/// Whether quick members pay: blocks of 0.4 m and more, centred or on an anchor line.
fn steady(spec: &SceneSpec, sample: &Sample) -> bool {
    let (ex, ey) = spec.layout.folded();
    let symmetric = |k: usize, e: f64| e == 0.0 || spec.layout.on_line(k, e);
    // Half a diameter is near nothing; the fifth test of the paper's table is as steady as a centred one.
    sample.kind == Kind::Patterns && (symmetric(0, ex) || symmetric(1, ey))
}

/// As [`ensemble::run_watched`], with members by the plan's own choice; `controls` are those of the
/// standard ones.
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
    let few = plan.runs.is_some_and(|n| n <= PAIRS);
    if few || !plan.auto || !steady(spec, &Sample::of(&Scene::new(spec)?, plan)) {
        return ensemble::run_watched(spec, controls, plan, progress, finished);
    }
    let quick = Controls { fidelity: Fidelity::Quick, ..controls.clone() };
    let found = ensemble::run_watched(spec, &quick, plan, progress, finished)?;
    let n = found.runs.len();
    if found.partial() || n <= PAIRS {
        return Ok(found);
    }
    let mut pairs: Vec<(usize, Run)> = Vec::new();
    loop {
        let goal = (pairs.len() + PAIRS).min(n);
        let list: Vec<usize> =
            order(n).into_iter().skip(pairs.len()).take(goal - pairs.len()).collect();
        let tell = |inner, done: usize| {
            let (done, planned) = (n + done, n + goal);
            progress(EnsembleProgress { done, planned, run: done, inner })
        };
        match again(spec, controls, &found, &list, plan.threads, &tell)? {
            Some(made) => pairs.extend(made),
            None => {
                // Without its pairs the ensemble is not whole.
                let mut cut = found;
                cut.flags.push(CheckFlag::Cancelled);
                return Ok(cut);
            }
        }
        let corrected = corrected(&found, &pairs);
        let error = corrected.force.uncertainty();
        if pairs.len() >= n || error <= TARGET.max(1.05 * found.force.uncertainty()) {
            return Ok(corrected);
        }
    }
}

/// In which order members are made again: spread over all of them, so over the patterns.
fn order(n: usize) -> Vec<usize> {
    let mut list: Vec<usize> = (0..n).collect();
    // Golden steps visit all numbers below n evenly.
    let key = |k: usize| {
        let part = (k as f64 + 0.5) * 0.618_033_988_749_894_9;
        part - part.floor()
    };
    list.sort_by(|a, b| key(*a).total_cmp(&key(*b)));
    list
}

/// Runs at standard fidelity, with the number of their member; nothing where the caller cancels.
fn again(
    spec: &SceneSpec,
    controls: &Controls,
    found: &Ensemble,
    list: &[usize],
    threads: usize,
    tell: &(dyn Fn(RunProgress, usize) -> Flow + Sync),
) -> Result<Option<Vec<(usize, Run)>>, Vec<Problem>> {
    let (next, cancelled) = (AtomicUsize::new(0), AtomicBool::new(false));
    let made: Mutex<Vec<Option<Run>>> = Mutex::new(vec![None; list.len()]);
    let failed: Mutex<Vec<Problem>> = Mutex::new(Vec::new());
    let worker = || {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(k) = list.get(place).filter(|_| !cancelled.load(Ordering::Relaxed)) else {
                return;
            };
            let listen = |inner| {
                let stop = cancelled.load(Ordering::Relaxed) || tell(inner, place) == Flow::Cancel;
                if stop {
                    cancelled.store(true, Ordering::Relaxed);
                    return Flow::Cancel;
                }
                Flow::Continue
            };
            match single(spec, controls, found.sample.member(*k), listen) {
                // A lock is only poisoned by a panic, and then what is in it is still whole.
                Ok(run) => {
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
    if cancelled.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let made = made.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(Some(list.iter().copied().zip(made.into_iter().flatten()).collect()))
}

/// The ensemble with the standard runs in the place of their quick ones, and the others brought to them.
fn corrected(found: &Ensemble, pairs: &[(usize, Run)]) -> Ensemble {
    let ratio = |(k, run): &(usize, Run)| {
        let quick = found.runs.get(*k).filter(|run| counts(run))?.outcome.first_break?;
        let own = Some(run).filter(|run| counts(run))?.outcome.first_break?;
        Some([own.force / quick.force, own.deflection / quick.deflection])
    };
    let ratios: Vec<[f64; 2]> = pairs.iter().filter_map(ratio).collect();
    let bias = bias(&ratios, found.runs.len());
    let mut runs = found.runs.clone();
    for run in &mut runs {
        scale(&mut run.outcome, bias.factors);
    }
    for (k, run) in pairs {
        if let Some(place) = runs.get_mut(*k) {
            *place = run.clone();
        }
    }
    let mut ensemble = summary(runs, found.sample.clone());
    (ensemble.probe, ensemble.bias) = (found.probe, Some(bias));
    let more = found.flags.iter().filter(|flag| **flag == CheckFlag::Bifurcation).cloned();
    ensemble.flags.extend(more);
    let [force, deflection] = bias.errors;
    let both = |error: f64, part: f64, mean: f64| error.hypot(part * mean);
    ensemble.force.error = both(ensemble.force.error, force, ensemble.force.mean);
    let spread = &mut ensemble.deflection;
    spread.error = both(spread.error, deflection, spread.mean);
    ensemble
}

/// Mean ratios and their errors, for an ensemble of `n` runs; those that are pairs have no bias.
fn bias(ratios: &[[f64; 2]], n: usize) -> Bias {
    let m = ratios.len();
    let of = |k: usize| {
        if m == 0 {
            return (1.0, ASSUMED[k]);
        }
        let mean = ratios.iter().map(|r| r[k]).sum::<f64>() / m as f64;
        let squares: f64 = ratios.iter().map(|r| (r[k] - mean) * (r[k] - mean)).sum();
        let variance = (PRIOR * ASSUMED[k] * ASSUMED[k] + squares) / (PRIOR + m as f64 - 1.0);
        let left = 1.0 - m as f64 / n.max(m) as f64;
        (mean, (variance / m as f64 * left).sqrt())
    };
    let [(force, a), (deflection, b)] = [of(0), of(1)];
    Bias { pairs: m, factors: [force, deflection], errors: [a, b] }
}

/// Multiplies forces and deflections of an outcome.
fn scale(outcome: &mut RunOutcome, [force, deflection]: [f64; 2]) {
    let points = [Some(&mut outcome.peak), outcome.first_break.as_mut()];
    for point in points.into_iter().flatten().chain(outcome.curve.failure.as_mut()) {
        point.force *= force;
        point.deflection *= deflection;
    }
    let forces = [&mut outcome.curve.force, &mut outcome.punch, &mut outcome.support];
    forces.into_iter().flatten().for_each(|v| *v *= force);
    outcome.curve.deflection.iter_mut().for_each(|v| *v *= deflection);
    outcome.breaks.iter_mut().for_each(|b| b.deflection *= deflection);
    outcome.anchors.iter_mut().for_each(|a| a.force = a.force.map(|v| v * force));
    outcome.energy *= force * deflection;
    outcome.k75 *= force / deflection;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::{Arrangement, PLAIN_PHASE, Test};
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::laws;

    #[test]
    fn the_error_of_a_bias_worked_by_hand() {
        // Ratios 1.01 and 1.03: mean 1.02, squares 2e-4; with two of 1.6e-5 each (2 x 1.6e-5 + 2e-4) / 3;
        // two of eight: over 2, times 6/8.
        let b = bias(&[[1.01, 1.0], [1.03, 1.0]], 8);
        let due = ((2.0 * 1.6e-5 + 2.0e-4) / 3.0 / 2.0 * 0.75_f64).sqrt();
        assert!((b.factors[0] - 1.02).abs() < 1e-12 && (b.errors[0] - due).abs() < 1e-12);
        assert_eq!(bias(&[[1.01, 1.0]; 3], 3).errors, [0.0; 2]);
        assert_eq!(bias(&[], 8).factors, [1.0; 2]);
        for n in [3, 7, 12] {
            let mut list = order(n);
            list.sort_unstable();
            assert!(list.into_iter().eq(0..n));
        }
    }

    #[test]
    fn paired_members_are_standard_ones_and_threads_change_nothing() {
        let layout = Layout { plate: 0.25, spacing: 1.3, punch: 0.45, ..REFERENCE };
        let spec = SceneSpec {
            layout,
            test: Test::Anchored,
            wire: laws::reference(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        let controls = Controls { after_break: 0.0, ..Controls::default() };
        let make = |auto, runs, threads| {
            let plan = Plan { runs: Some(runs), auto, threads, ..Plan::default() };
            run_watched(&spec, &controls, &plan, &|_| Flow::Continue, &|_, _| {}).unwrap()
        };
        let (auto, plain) = (make(true, 5, 1), make(false, 5, 1));
        let bias = auto.bias.unwrap();
        assert!(bias.pairs >= PAIRS && plain.bias.is_none());
        let same = |k: &usize| auto.runs[*k].outcome == plain.runs[*k].outcome;
        let list = order(5);
        assert!(list[..bias.pairs].iter().all(same));
        assert!(bias.pairs == 5 || !list[bias.pairs..].iter().any(same));
        assert!((auto.force.mean / plain.force.mean - 1.0).abs() < 0.01);
        let two = make(true, 5, 2);
        assert_eq!(two.force, auto.force);
        assert_eq!(two.bias, auto.bias);
        // One run is a standard one.
        assert_eq!(make(true, 1, 1).force, make(false, 1, 1).force);
    }
}
