//! Error estimates held against true errors, on scenes drawn by a seed: how many are beaten, how far
//! above the error they stand, how many say that a snap decides, and whether the aims are kept.
//!
//! The truth of a scene is a run at 0.36 of the fine speed, and what that one is worth is its change
//! with 0.7 of the step. An estimate is *beaten* where the true error is above it and this change together.

use super::bench::{Errors, Listener, errors};
use crate::dem::hash::{hash, uniform};
use crate::dem::{
    Arrangement, Controls, Fidelity, PLAIN_PHASE, RunOutcome, Scene, SceneSpec, Test,
};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::laws;
use crate::problem::Problem;
use crate::study::clock::thread_seconds;
use crate::words::Choice;
use serde::Serialize;

/// Speed of a scene's true run, over that of the fine fidelity.
const SLOW: f64 = 0.36;
/// Step of the run that tells how well the true one is known, over its own.
const SHORT: f64 = 0.7;
/// Diameter from which on blocks are told apart from small ones, m.
pub(crate) const SMALL_BLOCK: f64 = 0.65;
/// Draws after which no scene is looked for any more.
const DRAWS: u64 = 1000;

/// What is surveyed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EstimatePlan<'a> {
    /// Scenes that are given.
    pub(crate) given: &'a [SceneSpec],
    /// How many are drawn, where none are given.
    pub(crate) scenes: usize,
    /// Seed that draws them.
    pub(crate) seed: u64,
    /// Which fidelities.
    pub(crate) fidelities: &'a [Fidelity],
    /// Whether runs are made again where they say that they may miss their aim.
    pub(crate) to_aim: bool,
}

/// One run of a scene against its truth.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct EstimateRow {
    /// Number of the scene.
    pub(crate) scene: usize,
    /// The scene as flags of a check.
    pub(crate) flags: String,
    /// Diameter of the block, m.
    #[serde(rename = "D_m")]
    pub(crate) punch: f64,
    pub(crate) fidelity: &'static str,
    /// Error of the force at the first break, %.
    #[serde(rename = "F_error_pct")]
    pub(crate) force: f64,
    /// Error of the deflection there, %.
    #[serde(rename = "delta_error_pct")]
    pub(crate) deflection: f64,
    /// Error of the curve, %.
    #[serde(rename = "curve_error_pct")]
    pub(crate) curve: f64,
    /// The worst of the three, %.
    #[serde(rename = "worst_pct")]
    pub(crate) worst: f64,
    /// The run's own estimate, %.
    #[serde(rename = "error_estimate_pct")]
    pub(crate) estimate: f64,
    /// How well the truth is known, %.
    #[serde(rename = "known_pct")]
    pub(crate) known: f64,
    /// Whether the run says that a snap decides.
    pub(crate) snap: bool,
    /// Its largest utilisation at the last look before the first break.
    pub(crate) utilisation: f64,
    /// Whether it was repeated with a shorter step.
    pub(crate) repeated: bool,
    /// Steps to the first break.
    pub(crate) steps: usize,
    /// Processor time, ms.
    pub(crate) wall_ms: f64,
}

impl EstimateRow {
    /// Whether the true error is above the estimate by more than the truth is known to.
    pub(crate) fn beaten(&self) -> bool {
        self.worst > self.estimate + self.known
    }

    /// Whether it misses an aim, %.
    fn misses(&self, aim: f64) -> bool {
        self.worst > aim + self.known
    }
}

/// A fidelity over all scenes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct EstimateCount {
    pub(crate) fidelity: &'static str,
    pub(crate) aim_pct: f64,
    pub(crate) runs: usize,
    /// Whose estimate is beaten.
    pub(crate) beaten: usize,
    /// Median of estimate over error.
    pub(crate) median_ratio: f64,
    /// Runs that say that a snap decides.
    pub(crate) snaps: usize,
    /// Of these with a block of [`SMALL_BLOCK`] and more, and how many runs have one.
    pub(crate) snaps_of_large: [usize; 2],
    /// Runs that miss the aim.
    pub(crate) misses: usize,
    /// Runs that say that they may miss it, or that a snap decides.
    pub(crate) flagged: usize,
    /// Runs that miss it without saying so.
    pub(crate) unflagged: usize,
    /// Root mean square and largest of the worst errors of those without a snap, %.
    pub(crate) rms_pct: f64,
    /// The largest of them, %.
    pub(crate) largest_pct: f64,
    /// Steps in the mean.
    pub(crate) steps: usize,
    /// Processor time of all, s.
    pub(crate) seconds: f64,
}

impl EstimateCount {
    fn of(fidelity: Fidelity, rows: &[EstimateRow]) -> EstimateCount {
        let rows: Vec<&EstimateRow> =
            rows.iter().filter(|r| r.fidelity == fidelity.word()).collect();
        let count = |is: &dyn Fn(&EstimateRow) -> bool| rows.iter().filter(|r| is(r)).count();
        let mut ratios: Vec<f64> = rows.iter().map(|r| r.estimate / r.worst.max(1e-9)).collect();
        ratios.sort_by(f64::total_cmp);
        let sound: Vec<f64> = rows.iter().filter(|r| !r.snap).map(|r| r.worst).collect();
        let squares: f64 = sound.iter().map(|w| w * w).sum();
        let aim_pct = 100.0 * fidelity.aim();
        let large = |r: &EstimateRow| r.punch >= SMALL_BLOCK;
        let flagged = |r: &EstimateRow| r.snap || !fidelity.keeps(r.estimate / 100.0);
        EstimateCount {
            fidelity: fidelity.word(),
            aim_pct,
            runs: rows.len(),
            beaten: count(&EstimateRow::beaten),
            median_ratio: ratios.get(ratios.len() / 2).copied().unwrap_or(0.0),
            snaps: count(&|r| r.snap),
            snaps_of_large: [count(&|r| r.snap && large(r)), count(&large)],
            misses: count(&|r| r.misses(aim_pct)),
            flagged: count(&flagged),
            unflagged: count(&|r| r.misses(aim_pct) && !flagged(r)),
            rms_pct: (squares / sound.len().max(1) as f64).sqrt(),
            largest_pct: sound.iter().copied().fold(0.0, f64::max),
            steps: rows.iter().map(|r| r.steps).sum::<usize>() / rows.len().max(1),
            seconds: rows.iter().map(|r| r.wall_ms).sum::<f64>() / 1.0e3,
        }
    }
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct EstimateSurvey {
    /// Seed that drew the scenes.
    pub(crate) seed: u64,
    /// Scenes surveyed.
    pub(crate) scenes: usize,
    /// Of these, without a first break to compare, by number.
    pub(crate) unbroken: Vec<usize>,
    /// One for each fidelity.
    pub(crate) counts: Vec<EstimateCount>,
    /// Scene by scene.
    pub(crate) rows: Vec<EstimateRow>,
    /// Whether it was ended early, so that scenes are missing.
    pub(crate) part: bool,
}

fn base(fidelity: Fidelity) -> Controls {
    Controls { fidelity, after_break: 0.0, ..Controls::default() }
}

/// The survey; what is done by then where `listener` ends it early.
///
/// # Errors
/// What is wrong with a scene or the controls.
pub(crate) fn survey(
    plan: &EstimatePlan,
    listener: Listener,
) -> Result<EstimateSurvey, Vec<Problem>> {
    let mut survey = EstimateSurvey { seed: plan.seed, ..EstimateSurvey::default() };
    let scenes = if plan.given.is_empty() { plan.scenes } else { plan.given.len() };
    for k in 0..scenes {
        (listener.tell)(&format!("scene {} of {scenes}", k + 1));
        if survey.scene(k, plan, listener)?.is_none() {
            survey.part = true;
            break;
        }
        survey.scenes += 1;
    }
    survey.counts = plan.fidelities.iter().map(|f| EstimateCount::of(*f, &survey.rows)).collect();
    Ok(survey)
}

impl EstimateSurvey {
    /// Adds the rows of one scene; nothing where that was ended early.
    fn scene(
        &mut self,
        k: usize,
        plan: &EstimatePlan,
        listener: Listener,
    ) -> Result<Option<()>, Vec<Problem>> {
        let given = plan.given.get(k).cloned();
        let told = given.unwrap_or_else(|| drawn_scene(plan.seed, k as u64));
        // What `meshcast check` of these flags makes as its first run.
        let spec = SceneSpec { seed: hash(told.seed, 0), ..told.clone() };
        let own = base(Fidelity::Fine);
        let travel = own.scheme(&Scene::new(&spec)?)?.travel;
        let slow = Controls { speed: Some(SLOW * travel), ..own };
        let short = Controls { step_factor: SHORT, ..slow.clone() };
        let Some(truth) = listener.check(&spec, &slow)? else { return Ok(None) };
        let Some(other) = listener.check(&spec, &short)? else { return Ok(None) };
        let Some(known) = errors(&other, &truth) else {
            self.unbroken.push(k);
            return Ok(Some(()));
        };
        for fidelity in plan.fidelities {
            let start = thread_seconds();
            let controls = Controls { to_aim: plan.to_aim, ..base(*fidelity) };
            let Some(run) = listener.check(&spec, &controls)? else { return Ok(None) };
            let wall_ms = 1.0e3 * (thread_seconds() - start);
            // A run that does not break where the truth does is wrong altogether.
            let e = errors(&run, &truth).unwrap_or(ALL_WRONG);
            self.rows.push(row((k, &told), *fidelity, (&run, &e, &known), wall_ms));
        }
        Ok(Some(()))
    }
}

/// Errors of a run that breaks nowhere.
const ALL_WRONG: Errors = Errors { force: 1.0, deflection: 1.0, curve: 1.0 };

fn row(
    (scene, spec): (usize, &SceneSpec),
    fidelity: Fidelity,
    (run, e, known): (&RunOutcome, &Errors, &Errors),
    wall_ms: f64,
) -> EstimateRow {
    EstimateRow {
        scene,
        flags: flags(spec),
        punch: spec.layout.punch,
        fidelity: fidelity.word(),
        force: 100.0 * e.force,
        deflection: 100.0 * e.deflection,
        curve: 100.0 * e.curve,
        worst: 100.0 * e.worst(),
        estimate: 100.0 * run.quality.error_estimate,
        known: 100.0 * known.worst(),
        snap: run.snaps(),
        utilisation: run.quality.last_utilisation,
        repeated: run.repeated,
        steps: run.cost.steps_to_break,
        wall_ms,
    }
}

/// A scene as flags of `meshcast check`.
fn flags(spec: &SceneSpec) -> String {
    let Layout { plate, spacing, punch, ex, ey, .. } = spec.layout;
    let test = if spec.test == Test::Laboratory { " --test laboratory" } else { "" };
    let [x, y] = spec.phase;
    let seed = spec.seed;
    format!(
        "-d {plate} -L {spacing} -D {punch} --ex {ex} --ey {ey}{test} --seed {seed} --phase {x},{y}"
    )
}

/// Scene number `k` of an endless row under a seed: a quarter in the laboratory, a third of the others
/// centred, the rest with the block anywhere; a sixth with blocks below 0.4 m. The reference law, any
/// slack and alignment. Numbers are rounded, so that the flags tell the scene to the last bit.
pub(crate) fn drawn_scene(seed: u64, k: u64) -> SceneSpec {
    let own = hash(seed, k);
    let mut draws = 0;
    loop {
        let mut draw = |low: f64, high: f64| {
            draws += 1;
            let x = low + (high - low) * uniform(own, u64::MAX - draws);
            (x * 1.0e4).round() / 1.0e4
        };
        let laboratory = draw(0.0, 1.0) < 0.25;
        let centred = draw(0.0, 1.0) < 1.0 / 3.0;
        let small = draw(0.0, 1.0) < 1.0 / 6.0;
        let spacing = draw(1.6, 4.0);
        let plate = draw(0.16, 0.48);
        let punch = if small { draw(0.15, 0.4) } else { draw(0.4, 1.6) };
        // In the laboratory the block keeps half a metre from the edges.
        let reach = if laboratory { (spacing - punch) / 2.0 - 0.5 } else { spacing / 2.0 };
        let [ex, ey] = [draw(-1.0, 1.0), draw(-1.0, 1.0)]
            .map(|part| if centred { 0.0 } else { (part * reach * 1.0e4).round() / 1.0e4 });
        let phase = [draw(0.0, 0.9999), draw(0.0, 0.9999)];
        let layout = Layout { plate, spacing, punch, ex, ey, ..REFERENCE };
        let test = if laboratory { Test::Laboratory } else { Test::Anchored };
        let wire = laws::reference();
        let seed = own % 1_000_000;
        let arrangement = Arrangement::default();
        let spec = SceneSpec { layout, test, wire, phase, seed, arrangement };
        if reach > 0.0 && punch < 0.6 * spacing && Scene::new(&spec).is_ok() {
            return spec;
        }
        if draws > 11 * DRAWS {
            return SceneSpec { layout: REFERENCE, phase: PLAIN_PHASE, ..spec };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(worst: f64, estimate: f64, known: f64, snap: bool) -> EstimateRow {
        EstimateRow {
            scene: 0,
            flags: String::new(),
            punch: 1.0,
            fidelity: "standard",
            force: worst,
            deflection: 0.0,
            curve: 0.0,
            worst,
            estimate,
            known,
            snap,
            utilisation: 1.0,
            repeated: false,
            steps: 100,
            wall_ms: 10.0,
        }
    }

    #[test]
    fn what_is_counted_is_what_a_hand_counts() {
        let rows = [
            row(0.5, 1.0, 0.0, false),
            row(1.5, 1.0, 0.2, false), // Beaten, and misses its 1 %.
            row(1.1, 1.0, 0.2, false), // Within what is known of the truth.
            row(6.0, 9.0, 0.0, true),
        ];
        let count = EstimateCount::of(Fidelity::Standard, &rows);
        assert_eq!((count.runs, count.beaten, count.misses, count.snaps), (4, 1, 2, 1));
        // Up to 1.75 times the aim of 1 % a run says nothing.
        assert_eq!((count.flagged, count.unflagged), (1, 1));
        assert_eq!(count.snaps_of_large, [1, 4]);
        // Estimates over errors: 0.67, 0.91, 1.5, 2.
        assert!((count.median_ratio - 1.5).abs() < 1e-12);
        let rms = ((0.25 + 2.25 + 1.21) / 3.0_f64).sqrt();
        assert!((count.rms_pct - rms).abs() < 1e-12 && count.largest_pct == 1.5);
        assert_eq!(EstimateCount::of(Fidelity::Fine, &rows).runs, 0);
    }

    #[test]
    fn a_seed_draws_the_same_scenes_and_all_kinds_of_them() {
        let all: Vec<SceneSpec> = (0..60).map(|k| drawn_scene(3, k)).collect();
        assert_eq!(all[7], drawn_scene(3, 7));
        assert_ne!(all[7], drawn_scene(4, 7));
        let count = |is: &dyn Fn(&SceneSpec) -> bool| all.iter().filter(|s| is(s)).count();
        let laboratory = count(&|s| s.test == Test::Laboratory);
        let eccentric = count(&|s| s.layout.ex != 0.0 && s.test == Test::Anchored);
        let small = count(&|s| s.layout.punch < 0.4);
        assert!(laboratory > 5 && eccentric > 20 && small > 2, "{laboratory} {eccentric} {small}");
        assert!(all.iter().all(|s| Scene::new(s).is_ok()));
    }
}
