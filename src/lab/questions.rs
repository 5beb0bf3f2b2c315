//! Whole questions: what a mean force costs and how far off it is, by random runs as they were drawn before
//! runs were placed, and by the fidelities of today; and by how much standard runs differ from quick ones.
//!
//! A question is asked with several seeds. Its error is the root mean square of the mean force about a
//! truth of [`TRUTH_RUNS`] placed standard runs of a seed that is not among them.

use super::bench::Listener;
use super::estimates::drawn_scene;
use crate::dem::hash::{hash, uniform};
use crate::dem::{Controls, Fidelity, Flow, REVISION, SceneSpec, Stop, Test};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::laws;
use crate::problem::Problem;
use crate::study::bias;
use crate::study::clock::thread_seconds;
use crate::study::ensemble::{Ensemble, Plan, Run, Spread, counts};
use crate::study::exactness::Exactness;
use crate::study::paired;
use crate::words::Choice;
use serde::Serialize;

/// Runs of the truth of the four layouts, and of one that is drawn.
const TRUTH_RUNS: [usize; 2] = [512, 128];
/// Seed of the runs of the truth.
const TRUTH_SEED: u64 = 77;
/// Mean force of the four layouts over 512 runs, N, by this revision of the solver; from
/// `meshcast check FLAGS --blocks repeated --fidelity standard --runs 512 --seed 77 --after-break 0`.
const TRUTHS: (u32, [f64; 4]) =
    (3, [27_639.928_080_1, 23_126.202_051_9, 31_678.454_798, 23_156.933_275_6]);
/// Names of the four layouts.
pub(crate) const LAYOUTS: [&str; 4] = ["A", "B", "C", "D"];
/// Name of the runs of before among the ways of asking.
pub(crate) const RANDOM: &str = "random";

/// What is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct QuestionPlan {
    /// Seeds that each question is asked with.
    pub(crate) times: usize,
    /// Layouts that are drawn, after the four.
    pub(crate) scenes: usize,
    /// Seed that draws them.
    pub(crate) seed: u64,
}

/// A layout by one way of asking.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct QuestionRow {
    /// Name of the layout: a letter, or the number of a drawn one.
    pub(crate) layout: String,
    /// The layout as flags of a check.
    pub(crate) flags: String,
    /// [`RANDOM`], else the fidelity.
    pub(crate) way: &'static str,
    /// Runs in the mean over the seeds, those made again for the bias among them.
    pub(crate) runs: f64,
    /// Processor time, ms.
    pub(crate) ms: f64,
    /// Root mean square error of the mean force, %.
    pub(crate) rms_pct: f64,
    /// Mean error over the seeds, %.
    pub(crate) mean_pct: f64,
    /// Standard error that the questions tell, root mean square, %.
    pub(crate) told_pct: f64,
    /// Questions whose error is above twice what they tell.
    pub(crate) beyond: usize,
    /// Time of random runs over this one.
    pub(crate) faster: f64,
}

/// What `bench --questions` prints.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct QuestionTable {
    /// Layout by layout.
    pub(crate) rows: Vec<QuestionRow>,
    /// Whether it was ended early.
    pub(crate) part: bool,
}

/// A scene's standard runs over its quick ones.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct PairRow {
    /// The scene as flags of a check.
    pub(crate) flags: String,
    /// `anchored` or `laboratory`.
    pub(crate) test: &'static str,
    /// Mean of the quick runs' own error estimates, %.
    pub(crate) estimate_pct: f64,
    /// Bias of force and deflection, %.
    pub(crate) bias_pct: [f64; 2],
    /// Their scatter from pair to pair, %.
    pub(crate) pair_pct: [f64; 2],
}

/// The pairs of drawn scenes.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct PairTable {
    /// Scene by scene.
    pub(crate) rows: Vec<PairRow>,
    /// Whether it was ended early.
    pub(crate) part: bool,
}

impl PairTable {
    /// Root mean square of what the rows of a test have, over their estimates.
    pub(crate) fn over_estimate(&self, test: &str, of: &dyn Fn(&PairRow) -> f64) -> f64 {
        let rows = self.rows.iter().filter(|r| r.test == test);
        let most = 100.0 * bias::MOST_ESTIMATE;
        let squares: Vec<f64> = rows.map(|r| (of(r) / r.estimate_pct.min(most)).powi(2)).collect();
        (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
    }
}

/// Pairs of a scene.
const PAIRS: usize = 8;

fn spec(layout: Layout) -> SceneSpec {
    SceneSpec::plain(layout, Test::Anchored, laws::reference())
}

/// The four layouts of the aims, two of them eccentric.
fn four() -> [Layout; 4] {
    let at = |plate, spacing, punch, ex, ey| Layout { plate, spacing, punch, ex, ey, ..REFERENCE };
    [
        at(0.32, 3.0, 1.0, 0.0, 0.0),
        at(0.25, 2.5, 0.6, 0.0, 0.0),
        at(0.4, 4.0, 1.2, 2.0, 0.2),
        at(0.25, 3.5, 0.8, 0.55, 1.15),
    ]
}

/// Layouts of drawn anchored scenes whose block is no small one.
fn drawn(seed: u64, count: usize) -> Vec<Layout> {
    let scenes = (0..).map(|k| drawn_scene(seed, k));
    let fits = |s: &SceneSpec| s.test == Test::Anchored && s.layout.punch >= 0.4;
    scenes.filter(fits).map(|s| s.layout).take(count).collect()
}

fn flags(layout: &Layout) -> String {
    let Layout { plate, spacing, punch, ex, ey, .. } = layout;
    let centred = *ex == 0.0 && *ey == 0.0;
    let aside = if centred { String::new() } else { format!(" --ex {ex} --ey {ey}") };
    format!("-d {plate} -L {spacing} -D {punch}{aside}")
}

/// Ways of asking: random runs first, against which the others' times are held.
const WAYS: [Option<Exactness>; 4] =
    [None, Some(Exactness::Standard), Some(Exactness::Auto), Some(Exactness::Quick)];

/// Every layout by every way; what is done by then where `listener` ends it early.
///
/// # Errors
/// What is wrong with a scene.
pub(crate) fn questions(
    plan: &QuestionPlan,
    listener: Listener,
) -> Result<QuestionTable, Vec<Problem>> {
    let kept = |k: usize| (TRUTHS.0 == REVISION).then_some(TRUTHS.1[k]);
    let named = four().into_iter().zip(LAYOUTS).enumerate();
    let named = named.map(|(k, (layout, name))| (layout, name.to_string(), kept(k), TRUTH_RUNS[0]));
    let others = drawn(plan.seed, plan.scenes).into_iter().enumerate();
    let others = others.map(|(k, layout)| (layout, (k + 1).to_string(), None, TRUTH_RUNS[1]));
    let mut table = QuestionTable { part: true, ..QuestionTable::default() };
    for (layout, name, kept, runs) in named.chain(others) {
        (listener.tell)(&format!("layout {name}: {}", flags(&layout)));
        let truth = match kept {
            Some(truth) => Some(truth),
            None => truth(layout, runs, listener)?,
        };
        let Some(truth) = truth else { return Ok(table) };
        let mut before = None;
        for way in WAYS {
            let Some(row) = asked(layout, way, truth, plan.times, listener)? else {
                return Ok(table);
            };
            let before: f64 = *before.get_or_insert(row.ms);
            let faster = before / row.ms;
            table.rows.push(QuestionRow { layout: name.clone(), faster, ..row });
        }
    }
    table.part = false;
    Ok(table)
}

fn truth(layout: Layout, runs: usize, listener: Listener) -> Result<Option<f64>, Vec<Problem>> {
    let plan = Plan { runs: Some(runs), seed: TRUTH_SEED, ..Plan::default() };
    let controls = Controls { after_break: 0.0, ..Controls::default() };
    let made = ensemble(&spec(layout), &controls, &plan, listener)?;
    Ok(made.map(|e| e.force.mean))
}

/// An ensemble on one thread; nothing where it was ended before.
fn ensemble(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    listener: Listener,
) -> Result<Option<Ensemble>, Vec<Problem>> {
    if (listener.ask)() == Flow::Cancel {
        return Ok(None);
    }
    paired::run_watched(spec, controls, plan, &|_| Flow::Continue, &|_, _| {}).map(Some)
}

/// A layout by one way, so many times.
fn asked(
    layout: Layout,
    way: Option<Exactness>,
    truth: f64,
    times: usize,
    listener: Listener,
) -> Result<Option<QuestionRow>, Vec<Problem>> {
    let mut answers = Vec::new();
    for seed in 0..times.max(1) as u64 {
        let start = thread_seconds();
        let answer = match way {
            None => random(layout, seed, listener)?,
            Some(way) => placed(layout, way, seed, listener)?,
        };
        let Some((force, runs)) = answer else { return Ok(None) };
        answers.push(Answer { force, runs, ms: 1.0e3 * (thread_seconds() - start) });
    }
    Ok(Some(row(layout, way.map_or(RANDOM, Exactness::word), truth, &answers)))
}

/// What a question gave.
struct Answer {
    force: Spread,
    runs: usize,
    ms: f64,
}

fn row(layout: Layout, way: &'static str, truth: f64, answers: &[Answer]) -> QuestionRow {
    let mean = |of: &dyn Fn(&Answer) -> f64| {
        answers.iter().map(of).sum::<f64>() / answers.len().max(1) as f64
    };
    let error = |a: &Answer| 100.0 * (a.force.mean / truth - 1.0);
    let told = |a: &Answer| 100.0 * a.force.uncertainty();
    QuestionRow {
        layout: String::new(),
        flags: flags(&layout),
        way,
        runs: mean(&|a| a.runs as f64),
        ms: mean(&|a| a.ms),
        rms_pct: mean(&|a| error(a).powi(2)).sqrt(),
        mean_pct: mean(&error),
        told_pct: mean(&|a| told(a).powi(2)).sqrt(),
        beyond: answers.iter().filter(|a| error(a).abs() > 2.0 * told(a)).count(),
        faster: 1.0,
    }
}

/// The mean force of an ensemble, and its runs.
fn placed(
    layout: Layout,
    way: Exactness,
    seed: u64,
    listener: Listener,
) -> Result<Option<(Spread, usize)>, Vec<Problem>> {
    let controls = Controls { fidelity: way.fidelity(), ..Controls::default() };
    let plan = Plan { seed, auto: way.auto(), ..Plan::default() };
    let made = ensemble(&spec(layout), &controls, &plan, listener)?;
    Ok(made.map(|e| (e.force, e.runs.len() + e.bias.map_or(0, |bias| bias.pairs))))
}

/// The rule of before: runs at least and at most, and the standard error at which no more were made.
const BEFORE: (usize, usize, f64) = (8, 64, 0.02);

/// The same of random standard runs.
fn random(
    layout: Layout,
    seed: u64,
    listener: Listener,
) -> Result<Option<(Spread, usize)>, Vec<Problem>> {
    let (least, most, target) = BEFORE;
    let mut forces = Vec::new();
    for run in 0..most {
        let own = hash(seed, run as u64);
        let phase = [1, 2].map(|k| uniform(own, u64::MAX - k));
        let spec = SceneSpec { phase, seed: own, ..spec(layout) };
        let Some(made) = listener.check(&spec, &Controls::default())? else { return Ok(None) };
        forces.extend(made.first_break.filter(|_| made.stop != Stop::Diverged).map(|p| p.force));
        let force = Spread::of(&forces, &forces);
        if run + 1 >= least && force.uncertainty() < target {
            return Ok(Some((force, run + 1)));
        }
    }
    Ok(Some((Spread::of(&forces, &forces), most)))
}

/// Standard runs over quick ones in scenes of all kinds drawn by a seed.
///
/// # Errors
/// What is wrong with a scene.
pub(crate) fn pairs(
    scenes: usize,
    seed: u64,
    listener: Listener,
) -> Result<PairTable, Vec<Problem>> {
    let mut table = PairTable::default();
    for k in 0..scenes as u64 {
        (listener.tell)(&format!("scene {} of {scenes}", k + 1));
        let scene = drawn_scene(seed, k);
        let plan = Plan { runs: Some(PAIRS), seed: k, ..Plan::default() };
        let made = |fidelity| {
            let controls = Controls { fidelity, after_break: 0.0, ..Controls::default() };
            ensemble(&scene, &controls, &plan, listener)
        };
        let (Some(quick), Some(standard)) = (made(Fidelity::Quick)?, made(Fidelity::Standard)?)
        else {
            table.part = true;
            break;
        };
        table.rows.extend(pair_row(&scene, &quick.runs, &standard.runs));
    }
    Ok(table)
}

/// The row of a scene; nothing where fewer than half of its pairs have two first breaks.
fn pair_row(scene: &SceneSpec, quick: &[Run], standard: &[Run]) -> Option<PairRow> {
    let broke = |run: &Run| Some(run).filter(|run| counts(run))?.outcome.first_break;
    let ratio = |(a, b): (&Run, &Run)| {
        let (a, b) = (broke(a)?, broke(b)?);
        Some([b.force / a.force - 1.0, b.deflection / a.deflection - 1.0])
    };
    let ratios: Vec<[f64; 2]> = quick.iter().zip(standard).filter_map(ratio).collect();
    if ratios.len() < PAIRS / 2 {
        return None;
    }
    let [force, deflection] = [0, 1].map(|k| {
        let all: Vec<f64> = ratios.iter().map(|r| 100.0 * r[k]).collect();
        Spread::of(&all, &all)
    });
    let estimates = quick.iter().map(|run| 100.0 * run.outcome.quality.error_estimate);
    Some(PairRow {
        flags: flags(&scene.layout),
        test: scene.test.word(),
        estimate_pct: estimates.sum::<f64>() / quick.len().max(1) as f64,
        bias_pct: [force.mean, deflection.mean],
        pair_pct: [force.deviation, deflection.deviation],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_worked_by_hand() {
        let force = |mean, error| Spread { mean, error, ..Spread::default() };
        let answers = [
            Answer { force: force(1.01e4, 1.01e2), runs: 8, ms: 10.0 },
            Answer { force: force(0.96e4, 0.96e2), runs: 10, ms: 30.0 },
        ];
        let row = row(REFERENCE, RANDOM, 1.0e4, &answers);
        // Errors of 1 and -4 %, both told as 1 %: only the second is beyond twice that.
        assert!((row.rms_pct - 8.5_f64.sqrt()).abs() < 1e-9 && (row.mean_pct + 1.5).abs() < 1e-9);
        assert!((row.told_pct - 1.0).abs() < 1e-9);
        assert_eq!((row.beyond, row.runs, row.ms), (1, 9.0, 20.0));
    }

    #[test]
    fn what_the_pairs_have_over_their_estimates_worked_by_hand() {
        let row = |test, bias, estimate_pct| PairRow {
            flags: String::new(),
            test,
            estimate_pct,
            bias_pct: [bias, 0.0],
            pair_pct: [1.0, 1.0],
        };
        let rows = vec![
            row("anchored", 1.0, 10.0),
            row("anchored", -7.0, 40.0),
            row("laboratory", 9.0, 3.0),
        ];
        let table = PairTable { rows, part: false };
        // 0.1, and 7 over no more than 20.
        let due = ((0.01 + 0.35 * 0.35) / 2.0_f64).sqrt();
        assert!((table.over_estimate("anchored", &|r| r.bias_pct[0]) - due).abs() < 1e-12);
        assert!((table.over_estimate("laboratory", &|r| r.bias_pct[0]) - 3.0).abs() < 1e-12);
    }

    #[test]
    fn layouts_are_drawn_by_the_seed_and_none_of_them_is_small() {
        let some = drawn(7, 20);
        assert_eq!(some, drawn(7, 20));
        assert!(some.len() == 20 && some != drawn(8, 20) && some.iter().all(|l| l.punch >= 0.4));
        assert!(some.iter().any(|l| l.ex != 0.0) && some.iter().any(|l| l.ex == 0.0));
    }
}
