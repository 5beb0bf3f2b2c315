//! Members as cheap as they may be: quick runs, as slow as their own estimate asks for, and what is still not
//! known of their bias in the standard error.
//!
//! A quick run and a standard one of the same alignment and slack differ by a part that hardly depends on
//! either. What it is differs from scene to scene, by as much as a quick run's own error estimate is large
//! ([`Prior`]). So the first two members ([`PILOTS`]) set the speed of the others: as much slower as it takes for
//! an estimate that leaves [`KNOWN`] of the bias unknown. Where the target cannot be met so, some members are
//! made again at standard fidelity, and what these give over the quick ones multiplies all. Standard ones are all
//! members where quick ones tell nothing of them: where one does not break, or the estimates of the first two are
//! too high, as of small blocks. So are one or two runs, and runs of a given alignment, speed, damping or to their
//! aim.

use super::bias::{Bias, MOST_ESTIMATE, Prior};
use super::ensemble::{self, Ensemble, EnsembleProgress, Plan, Run, counts, members, summary};
use super::remark::CheckFlag;
use super::sampling::plan::TARGET;
use super::sampling::{Kind, Sample};
use crate::dem::{Controls, ESTIMATE_ORDER, Fidelity, Flow, RunOutcome, Scene, SceneSpec, Test};
use crate::problem::Problem;

/// Bias of the force of quick runs, that is of standard over quick ones less 1, by their error estimate e
/// (MEASUREMENTS.md says of which drawn scenes): its mean, its scatter about that from scene to scene, and from pair
/// to pair of one scene. Of a block on a line of symmetry each times e.
const ON_LINE: [f64; 3] = [0.0, 0.065, 0.05];
/// Of a block off all lines: the first two times e^2, the last times e. The mean so of estimates far above
/// [`NO_MEAN`], by the quick fidelity's own; there is none below it.
const OFF_LINES: [f64; 3] = [1.2, 0.95, 0.12];
const NO_MEAN: f64 = 0.082;
/// Least scatter from scene to scene there, however slow the runs are.
const LEAST_SCATTER: f64 = 0.0045;
/// In the laboratory: each times e.
const LABORATORY: [f64; 3] = [-0.2, 0.2, 0.14];
/// Mean bias of the deflection over that of the force, and the same of its scatter.
const OF_DEFLECTION: [f64; 2] = [0.3, 0.5];
/// Runs asked for up to which all are standard ones.
const FEW: usize = 2;
/// Members that set the speed of the others.
const PILOTS: usize = 2;
/// What may stay unknown of the bias, over the target: a slower punch costs less than more runs do.
const KNOWN: f64 = 0.55;

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
    // Standard ones are placed as those of an ensemble that does not choose.
    let fixed = Plan { auto: false, ..plan.clone() };
    if run_fidelity(controls, plan).is_some() {
        return ensemble::run_watched(spec, controls, &fixed, progress, finished);
    }
    let quick = Controls { fidelity: Fidelity::Quick, ..controls.clone() };
    let place = Place::of(spec);
    let sample = Sample::of(&Scene::new(spec)?, plan);
    let tell = |run: usize, inner| {
        let planned = sample.goal(0);
        progress(EnsembleProgress { done: run, planned, run, inner })
    };
    let list: Vec<usize> = (0..PILOTS).collect();
    let pilots = members(spec, &quick, &sample, &list, plan.threads, &tell, &|_, _| {})?;
    if pilots.cancelled {
        let mut cut = summary(pilots.runs.into_iter().map(|(_, run)| run).collect(), sample);
        cut.flags.push(CheckFlag::Cancelled);
        return Ok(cut);
    }
    let runs: Vec<Run> = pilots.runs.into_iter().map(|(_, run)| run).collect();
    if untold(&runs) {
        return ensemble::run_watched(spec, controls, &fixed, progress, finished);
    }
    runs.iter().enumerate().for_each(|(k, run)| finished(k, run));
    let quick = slowed(spec, quick, controls, (place, &sample, &runs))?;
    let found = ensemble::grown(spec, &quick, plan, (sample, runs), progress, finished)?;
    let n = found.runs.len();
    if found.partial() {
        return Ok(found);
    }
    if !found.runs.iter().all(broke) {
        // Each number is told once.
        let late = |k: usize, run: &Run| {
            if k >= n {
                finished(k, run);
            }
        };
        return ensemble::run_watched(spec, controls, &fixed, progress, &late);
    }
    // Of a pair only the first breaks are compared.
    let controls = Controls { after_break: 0.0, keep_net: false, ..controls.clone() };
    let prior = prior(place, &estimates(&found.runs));
    // What the scatter of the members leaves of the target, and not less than a third of it.
    let own = found.force.uncertainty() / TARGET;
    let goal = TARGET * (1.0 - own * own).max(1.0 / 9.0).sqrt();
    // With more than half of them standard all might be.
    let most = n / 2;
    let mut pairs: Vec<(usize, Run)> = Vec::new();
    loop {
        let bias = prior.bias(&ratios(&found, &pairs));
        let more = bias.more(goal).min(most - pairs.len());
        if more == 0 {
            return Ok(corrected(&found, bias));
        }
        let goal = pairs.len() + more;
        let list: Vec<usize> = order(n).into_iter().skip(pairs.len()).take(more).collect();
        let already = pairs.len();
        let tell = |k: usize, inner| {
            let place = list.iter().position(|other| *other == k).unwrap_or(0);
            let (done, planned) = (n + already + place, n + goal);
            progress(EnsembleProgress { done, planned, run: done, inner })
        };
        let made = members(spec, &controls, &found.sample, &list, plan.threads, &tell, &|_, _| {})?;
        if made.cancelled {
            // Without its pairs the ensemble is not whole.
            let mut cut = found;
            cut.flags.push(CheckFlag::Cancelled);
            return Ok(cut);
        }
        pairs.extend(made.runs);
    }
}

/// The fidelity of each run of an ensemble under these controls, which are those of a standard one where it might
/// choose; nothing where it does choose.
pub(crate) fn run_fidelity(controls: &Controls, plan: &Plan) -> Option<Fidelity> {
    let few = plan.runs.is_some_and(|n| n <= FEW);
    // What is known of the bias is that of the quick fidelity's own speed and damping.
    let by_hand = controls.speed.is_some() || controls.damping.is_some() || controls.to_aim;
    let fixed = !plan.auto || few || by_hand || plan.phase.is_some();
    fixed.then_some(controls.fidelity)
}

/// The controls of the members after the pilots: slower where these say so, but not below the standard speed.
fn slowed(
    spec: &SceneSpec,
    quick: Controls,
    standard: &Controls,
    (place, sample, pilots): (Place, &Sample, &[Run]),
) -> Result<Controls, Vec<Problem>> {
    // On a lattice there are many members, and few pairs beside them cost less.
    if sample.kind != Kind::Patterns {
        return Ok(quick);
    }
    let scene = Scene::new(spec)?;
    let [own, least] = [quick.scheme(&scene)?.travel, standard.scheme(&scene)?.travel];
    let factor = slowness(place, &estimates(pilots));
    Ok(Controls { speed: Some((own * factor).max(least.min(own))), ..quick })
}

/// Whether quick runs tell nothing of standard ones: some do not break, or their estimates are so high that the
/// bias also differs from run to run by more than half of them made again would take out.
fn untold(runs: &[Run]) -> bool {
    let mean = estimates(runs).iter().sum::<f64>() / runs.len().max(1) as f64;
    mean > MOST_ESTIMATE || !runs.iter().all(broke)
}

fn broke(run: &Run) -> bool {
    counts(run) && run.outcome.first_break.is_some()
}

/// Speed over the quick one at which no more than [`KNOWN`] of the bias stays unknown.
fn slowness(place: Place, estimates: &[f64]) -> f64 {
    let (bias, order) = match place {
        // The least scatter stays.
        Place::OffLines => {
            (OFF_LINES[1] * mean(estimates.iter(), &|e| e * e), 2.0 * ESTIMATE_ORDER)
        }
        _ => (prior(place, estimates).scenes[0], ESTIMATE_ORDER),
    };
    (KNOWN * TARGET / bias.max(f64::MIN_POSITIVE)).powf(1.0 / order).min(1.0)
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

/// Standard over quick first breaks of the pairs that have both.
fn ratios(found: &Ensemble, pairs: &[(usize, Run)]) -> Vec<[f64; 2]> {
    let ratio = |(k, run): &(usize, Run)| {
        let quick = found.runs.get(*k).filter(|run| counts(run))?.outcome.first_break?;
        let own = Some(run).filter(|run| counts(run))?.outcome.first_break?;
        Some([own.force / quick.force, own.deflection / quick.deflection])
    };
    pairs.iter().filter_map(ratio).collect()
}

/// Some runs' own error estimates.
fn estimates(runs: &[Run]) -> Vec<f64> {
    let counted = runs.iter().filter(|run| counts(run));
    counted.map(|run| run.outcome.quality.error_estimate).collect()
}

/// Where a block stands: quick runs are off by much the same where the scene is its own mirror image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    OnLine,
    OffLines,
    Laboratory,
}

impl Place {
    fn of(spec: &SceneSpec) -> Place {
        let (ex, ey) = spec.layout.folded();
        let on_line = |k: usize, e: f64| e == 0.0 || spec.layout.on_line(k, e);
        match spec.test {
            Test::Laboratory => Place::Laboratory,
            Test::Anchored if on_line(0, ex) || on_line(1, ey) => Place::OnLine,
            Test::Anchored => Place::OffLines,
        }
    }
}

/// What is known of the bias of members with these estimates, the pilots' first.
fn prior(place: Place, estimates: &[f64]) -> Prior {
    let own = mean(estimates.iter().take(PILOTS), &|e| e);
    let (one, two) = (mean(estimates.iter(), &|e| e), mean(estimates.iter(), &|e| e * e));
    let [off, scenes, pairs] = match place {
        Place::OnLine => ON_LINE.map(|v| v * one),
        Place::OffLines => {
            let part = 1.0 - (NO_MEAN / own.max(NO_MEAN)).powi(2);
            let scatter = (OFF_LINES[1] * two).hypot(LEAST_SCATTER);
            [OFF_LINES[0] * part * two, scatter, OFF_LINES[2] * one]
        }
        Place::Laboratory => LABORATORY.map(|v| v * one),
    };
    let [of_mean, of_scatter] = OF_DEFLECTION;
    Prior {
        mean: [off, of_mean * off],
        scenes: [scenes, of_scatter * scenes],
        pairs: [pairs, of_scatter * pairs],
    }
}

/// Mean of a figure of estimates, none counted above [`MOST_ESTIMATE`].
fn mean<'a>(estimates: impl ExactSizeIterator<Item = &'a f64>, of: &dyn Fn(f64) -> f64) -> f64 {
    let n = estimates.len().max(1) as f64;
    estimates.map(|e| of(e.min(MOST_ESTIMATE))).sum::<f64>() / n
}

/// The ensemble with its bias taken out, and what is not known of it in the standard errors.
fn corrected(found: &Ensemble, bias: Bias) -> Ensemble {
    let mut runs = found.runs.clone();
    for run in &mut runs {
        scale(&mut run.outcome, bias.factors);
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
    use crate::dem::check;
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::laws;
    use crate::study::sampling::Member;

    #[test]
    fn what_is_known_of_the_bias_is_that_of_the_scene_at_hand() {
        let known = |place, estimates: &[f64]| prior(place, estimates).scenes[0];
        // 0.065 of it on a line of symmetry, 0.95 times its square off all of them beside 0.45 %; of 20 % at most.
        assert!((known(Place::OnLine, &[0.08, 0.12]) - 0.0065).abs() < 1e-12);
        let due = (0.95_f64 * 0.0068).hypot(0.0045);
        assert!((known(Place::OffLines, &[0.06, 0.1]) - due).abs() < 1e-12);
        assert!((known(Place::OnLine, &[0.6]) - 0.013).abs() < 1e-12);
        // Quick runs off all lines break too early, in the laboratory too late.
        let mean = |place, estimates: &[f64]| prior(place, estimates).mean;
        // The first two are the quick fidelity's own: 1 - 0.5^2 of 1.2 times the mean square.
        let off = 1.2 * 0.75 * (2.0 * 0.164 * 0.164 + 0.08 * 0.08) / 3.0;
        let known = mean(Place::OffLines, &[0.164, 0.164, 0.08]);
        assert!((known[0] - off).abs() < 1e-12 && (known[1] - 0.3 * off).abs() < 1e-12);
        assert_eq!(mean(Place::OffLines, &[0.06, 0.1, 0.05]), [0.0; 2]);
        assert!((mean(Place::Laboratory, &[0.06, 0.1])[0] + 0.016).abs() < 1e-12);
        assert_eq!(mean(Place::OnLine, &[0.06, 0.1]), [0.0; 2]);
    }

    #[test]
    fn members_go_as_slow_as_their_bias_has_to_be_known() {
        // 0.55 % where 0.65 % would be: the 1.7th root of 0.846; where it is less, nothing is slowed down.
        let factor = slowness(Place::OnLine, &[0.1]);
        assert!((factor - (0.55_f64 / 0.65).powf(1.0 / 1.7)).abs() < 1e-12);
        assert_eq!(slowness(Place::OnLine, &[0.05]), 1.0);
        // Off all lines the bias goes with the square of the estimate: 0.55 % of 0.95 %.
        let factor = slowness(Place::OffLines, &[0.1]);
        assert!((factor - (0.55_f64 / 0.95).powf(1.0 / 3.4)).abs() < 1e-12);
        // After it the estimate is 10 % times factor^1.7, and 0.95 times its square what may be unknown.
        let left = 0.95 * (0.1 * factor.powf(1.7)).powi(2);
        assert!((left - 0.0055).abs() < 1e-12, "{left}");
    }

    #[test]
    fn runs_that_nothing_is_known_of_are_standard_ones() {
        let own = Controls::default();
        let auto = Plan { auto: true, ..Plan::default() };
        let standard = Some(Fidelity::Standard);
        assert_eq!(run_fidelity(&own, &auto), None);
        assert_eq!(run_fidelity(&own, &Plan::default()), standard);
        assert_eq!(run_fidelity(&own, &Plan { runs: Some(3), ..auto.clone() }), None);
        for plan in
            [Plan { runs: Some(2), ..auto.clone() }, Plan { phase: Some([0.0; 2]), ..auto.clone() }]
        {
            assert_eq!(run_fidelity(&own, &plan), standard, "{plan:?}");
        }
        for controls in [
            Controls { speed: Some(1e-4), ..own.clone() },
            Controls { damping: Some(0.01), ..own.clone() },
            Controls { to_aim: true, ..own.clone() },
        ] {
            assert_eq!(run_fidelity(&controls, &auto), standard, "{controls:?}");
        }
    }

    #[test]
    fn members_of_a_small_block_whose_estimates_tell_nothing_are_standard_ones() {
        let layout =
            Layout { plate: 0.21, spacing: 1.75, punch: 0.1, ex: 0.59, ey: 0.52, ..REFERENCE };
        let spec = SceneSpec::plain(layout, Test::Anchored, laws::reference());
        let controls = Controls { after_break: 0.0, ..Controls::default() };
        let told = std::sync::Mutex::new(Vec::new());
        let make = |auto| {
            let plan = Plan { runs: Some(3), auto, ..Plan::default() };
            let finished = |k, _: &Run| told.lock().unwrap().push(k);
            run_watched(&spec, &controls, &plan, &|_| Flow::Continue, &finished).unwrap()
        };
        let (auto, standard) = (make(true), make(false));
        assert_eq!((auto.force, auto.bias), (standard.force, None));
        // The two that set the speed are not told of as runs.
        assert_eq!(told.into_inner().unwrap(), [0, 1, 2, 0, 1, 2]);
    }

    #[test]
    fn members_are_standard_ones_where_quick_ones_do_not_break() {
        // A flat block is thrown off by the net in a quick run.
        let layout = Layout {
            plate: 0.39,
            spacing: 2.99,
            punch: 1.272,
            shape: crate::layout::PunchShape::Flat,
            ..REFERENCE
        };
        let spec = SceneSpec::plain(layout, Test::Anchored, laws::reference());
        let controls = Controls { after_break: 0.0, ..Controls::default() };
        let make = |auto| {
            let plan = Plan { auto, ..Plan::default() };
            run_watched(&spec, &controls, &plan, &|_| Flow::Continue, &|_, _| {}).unwrap()
        };
        // As many, too, as an ensemble makes that does not choose.
        let (auto, standard) = (make(true), make(false));
        assert!(standard.runs.iter().any(broke));
        assert_eq!((auto.force, auto.sample), (standard.force, standard.sample));
    }

    #[test]
    fn members_made_again_are_spread_over_all() {
        for n in [3, 7, 12] {
            let mut list = order(n);
            list.sort_unstable();
            assert!(list.into_iter().eq(0..n));
        }
    }

    #[test]
    fn members_are_quick_runs_times_their_bias_and_threads_change_nothing() {
        let layout = Layout { plate: 0.25, spacing: 1.3, punch: 0.45, ..REFERENCE };
        let spec = SceneSpec::plain(layout, Test::Anchored, laws::reference());
        let controls = Controls { after_break: 0.0, ..Controls::default() };
        let make = |auto, runs, fidelity, threads| {
            let plan = Plan { runs: Some(runs), auto, threads, ..Plan::default() };
            let controls = Controls { fidelity, ..controls.clone() };
            run_watched(&spec, &controls, &plan, &|_| Flow::Continue, &|_, _| {}).unwrap()
        };
        let auto = make(true, 5, Fidelity::Standard, 1);
        let [quick, standard] =
            [Fidelity::Quick, Fidelity::Standard].map(|fidelity| make(false, 5, fidelity, 1));
        let bias = auto.bias.unwrap();
        assert!(quick.bias.is_none() && bias.pairs <= 2);
        let force = |e: &Ensemble, k: usize| e.runs[k].outcome.first_break.unwrap().force;
        // The first two are quick runs, the others as slow as these say.
        let own = Controls { fidelity: Fidelity::Quick, ..controls.clone() };
        let pilots = (Place::of(&spec), &quick.sample, &quick.runs[..PILOTS]);
        let slower = slowed(&spec, own, &controls, pilots).unwrap();
        for k in 0..5 {
            let Member { seed, phase, .. } = quick.sample.member(k);
            let member = SceneSpec { phase, seed, ..spec.clone() };
            let alone = check(&member, &slower, &mut |_| Flow::Continue).unwrap();
            let due = if k < PILOTS { force(&quick, k) } else { alone.first_break.unwrap().force };
            assert!((force(&auto, k) / (bias.factors[0] * due) - 1.0).abs() < 1e-12);
        }
        // What is not known of the bias is in the error.
        assert!(auto.force.error > bias.errors[0] * auto.force.mean);
        assert!((auto.force.mean / standard.force.mean - 1.0).abs() < 0.01);
        let two = make(true, 5, Fidelity::Standard, 2);
        assert_eq!(two.force, auto.force);
        assert_eq!(two.bias, auto.bias);
        // One run is a standard one.
        let one = [true, false].map(|auto| make(auto, 1, Fidelity::Standard, 1).force);
        assert_eq!(one[0], one[1]);
    }
}
