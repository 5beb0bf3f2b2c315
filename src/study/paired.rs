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

/// Bias of the force of quick runs, that is of standard over quick ones less 1, as MEASUREMENTS.md has it of drawn
/// scenes: its mean, its scatter about that from scene to scene, and from pair to pair of one scene. Of a centred
/// block each times e, the quick runs' error estimate.
const CENTRED: [f64; 3] = [-0.015, 0.06, 0.12];
/// In the laboratory, where it is another one for other wires, and of a small block: only the last times e.
const LABORATORY: [f64; 3] = [-0.002, 0.006, 0.1];
const SMALL: [f64; 3] = [-0.002, 0.004, 0.16];
/// Of a block off the middle, far from all plates and near one: the first two times e^2, the last times e. The mean
/// so of estimates far above the fourth number, by the quick fidelity's own; there is none below it.
const FAR: [f64; 4] = [3.0, 3.2, 0.25, 0.04];
const NEAR: [f64; 4] = [1.25, 0.9, 0.15, 0.075];
/// Least scatter from scene to scene off the middle, however slow the runs are.
const LEAST_SCATTER: f64 = 0.0045;
/// Mean bias of the deflection over that of the force, and the same of its scatter.
const OF_DEFLECTION: [f64; 2] = [0.4, 0.5];
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
    let scene = Scene::new(spec)?;
    let sample = Sample::of(&scene, plan);
    let form = Form::of(&scene, sample.kind, quick.scheme(&scene)?.fitted);
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
    let quick = slowed(&scene, quick, controls, (form, &sample, &runs))?;
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
    let prior = prior(form, &estimates(&found.runs));
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
    scene: &Scene,
    quick: Controls,
    standard: &Controls,
    (form, sample, pilots): (Form, &Sample, &[Run]),
) -> Result<Controls, Vec<Problem>> {
    // On a lattice there are many members, and few pairs beside them cost less.
    if sample.kind != Kind::Patterns {
        return Ok(quick);
    }
    let [own, least] = [quick.scheme(scene)?.travel, standard.scheme(scene)?.travel];
    let factor = slowness(form, &estimates(pilots));
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
fn slowness(form: Form, estimates: &[f64]) -> f64 {
    let (bias, order) = match form {
        // No speed is known to change it.
        Form::Fixed(_) => return 1.0,
        Form::Linear(known) => (known[1] * mean(estimates.iter(), &|e| e), ESTIMATE_ORDER),
        // The least scatter stays.
        Form::Square(known) => {
            (known[1] * mean(estimates.iter(), &|e| e * e), 2.0 * ESTIMATE_ORDER)
        }
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

/// How the bias goes with the estimate, and with which numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    Fixed([f64; 3]),
    Linear([f64; 3]),
    Square([f64; 4]),
}

impl Form {
    /// That of a scene whose runs are placed so, and whose inertia is `fitted` to the net's slopes or not.
    fn of(scene: &Scene, placed: Kind, fitted: bool) -> Form {
        let spec = &scene.spec;
        match (spec.test, placed) {
            (Test::Laboratory, _) => Form::Fixed(LABORATORY),
            (Test::Anchored, Kind::Lattice) => Form::Fixed(SMALL),
            _ if !fitted => Form::Square(NEAR),
            _ if spec.layout.folded() == (0.0, 0.0) => Form::Linear(CENTRED),
            _ => Form::Square(FAR),
        }
    }
}

/// What is known of the bias of members with these estimates, the pilots' first.
fn prior(form: Form, estimates: &[f64]) -> Prior {
    let own = mean(estimates.iter().take(PILOTS), &|e| e);
    let (one, two) = (mean(estimates.iter(), &|e| e), mean(estimates.iter(), &|e| e * e));
    let [off, scenes, pairs] = match form {
        Form::Fixed([off, scenes, pairs]) => [off, scenes, pairs * one],
        Form::Linear(known) => known.map(|v| v * one),
        Form::Square([off, scenes, pairs, from]) => {
            let part = 1.0 - (from / own.max(from)).powi(2);
            [off * part * two, (scenes * two).hypot(LEAST_SCATTER), pairs * one]
        }
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
        let known = |form, estimates: &[f64]| prior(form, estimates).scenes[0];
        // 0.06 of it in the middle, 0.9 times its square near a plate beside 0.45 %; of 20 % at most.
        let (centred, near) = (Form::Linear(CENTRED), Form::Square(NEAR));
        assert!((known(centred, &[0.08, 0.12]) - 0.006).abs() < 1e-12);
        let due = (0.9_f64 * 0.0068).hypot(0.0045);
        assert!((known(near, &[0.06, 0.1]) - due).abs() < 1e-12);
        assert!((known(centred, &[0.6]) - 0.012).abs() < 1e-12);
        // In the laboratory it is the same for all.
        let laboratory = prior(Form::Fixed(LABORATORY), &[0.04, 0.06]);
        assert_eq!((laboratory.mean[0], laboratory.scenes[0]), (-0.002, 0.006));
        assert!((laboratory.pairs[0] - 0.005).abs() < 1e-12);
        // Quick runs near a plate break too early, in the middle a little too late.
        let mean = |form, estimates: &[f64]| prior(form, estimates).mean;
        // The first two are the quick fidelity's own: 1 - 0.5^2 of 1.25 times the mean square.
        let off = 1.25 * 0.75 * (2.0 * 0.15 * 0.15 + 0.08 * 0.08) / 3.0;
        let known = mean(near, &[0.15, 0.15, 0.08]);
        assert!((known[0] - off).abs() < 1e-12 && (known[1] - 0.4 * off).abs() < 1e-12);
        assert_eq!(mean(near, &[0.06, 0.08, 0.05]), [0.0; 2]);
        assert!((mean(centred, &[0.06, 0.1])[0] + 0.0012).abs() < 1e-12);
    }

    #[test]
    fn a_scene_is_known_by_where_its_block_stands() {
        let known = |layout: Layout, test| {
            let spec = SceneSpec::plain(layout, test, laws::reference());
            let scene = Scene::new(&spec).unwrap();
            let sample = Sample::of(&scene, &Plan { auto: true, ..Plan::default() });
            Form::of(&scene, sample.kind, Controls::default().scheme(&scene).unwrap().fitted)
        };
        let at = |ex, ey| known(Layout { ex, ey, ..REFERENCE }, Test::Anchored);
        assert_eq!(at(0.0, 0.0), Form::Linear(CENTRED));
        // Half a spacing aside is between two plates, as near as a block can be on a line of symmetry.
        assert_eq!(at(REFERENCE.spacing / 2.0, 0.0), Form::Square(NEAR));
        let wide = Layout { spacing: 4.0, punch: 0.8, ex: 0.4, ey: 0.1, ..REFERENCE };
        assert_eq!(known(wide, Test::Anchored), Form::Square(FAR));
        let small = Layout { punch: 0.3, ..REFERENCE };
        assert_eq!(known(small, Test::Anchored), Form::Fixed(SMALL));
        assert_eq!(known(small, Test::Laboratory), Form::Fixed(LABORATORY));
    }

    #[test]
    fn members_go_as_slow_as_their_bias_has_to_be_known() {
        // 0.55 % where 1.1 % would be: the 1.7th root of a half; where it is less, nothing is slowed down.
        let factor = slowness(Form::Linear([0.0, 0.055, 0.0]), &[0.2]);
        assert!((factor - 0.5_f64.powf(1.0 / 1.7)).abs() < 1e-12);
        assert_eq!(slowness(Form::Linear(CENTRED), &[0.09]), 1.0);
        assert_eq!(slowness(Form::Fixed(SMALL), &[0.2]), 1.0);
        // Near a plate the bias goes with the square of the estimate: 0.55 % of 0.9 %.
        let factor = slowness(Form::Square(NEAR), &[0.1]);
        assert!((factor - (0.55_f64 / 0.9).powf(1.0 / 3.4)).abs() < 1e-12);
        // After it the estimate is 10 % times factor^1.7, and 0.9 times its square what may be unknown.
        let left = 0.9 * (0.1 * factor.powf(1.7)).powi(2);
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
        let layout = Layout { plate: 0.25, spacing: 1.3, punch: 0.45, ..REFERENCE };
        let spec = SceneSpec::plain(layout, Test::Anchored, laws::reference());
        let make = |auto, limit| {
            let plan = Plan { auto, ..Plan::default() };
            let controls = Controls { after_break: 0.0, limit, ..Controls::default() };
            run_watched(&spec, &controls, &plan, &|_| Flow::Continue, &|_, _| {}).unwrap()
        };
        // Half of the runs end before they break.
        let whole = make(false, None);
        let of = |run: &Run| run.outcome.first_break.unwrap().deflection;
        let mut ways: Vec<f64> = whole.runs.iter().map(of).collect();
        ways.sort_by(f64::total_cmp);
        let limit = Some(ways[ways.len() / 2]);
        // As many, too, as an ensemble makes that does not choose.
        let (auto, standard) = (make(true, limit), make(false, limit));
        let broken = standard.runs.iter().filter(|run| broke(run)).count();
        assert!(broken > 0 && broken < standard.runs.len());
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
        let scene = Scene::new(&spec).unwrap();
        let form = Form::of(&scene, quick.sample.kind, own.scheme(&scene).unwrap().fitted);
        let pilots = (form, &quick.sample, &quick.runs[..PILOTS]);
        let slower = slowed(&scene, own, &controls, pilots).unwrap();
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
