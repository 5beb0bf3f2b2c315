//! A layout's blocks simulated as they may stand: repeated, mirrored, or both, and the lower one taken.

use super::ensemble::{self, Ensemble, EnsembleProgress, Plan, Run};
use super::paired;
use super::remark::CheckFlag;
use crate::dem::{Arrangement, Controls, Fidelity, Flow, SceneSpec, Test};
use crate::layout::{Blocks, Layout};
use crate::problem::Problem;

/// The arrangements that a layout's check simulates.
pub(crate) fn arrangements(layout: &Layout) -> Vec<Arrangement> {
    let repeated = Arrangement::default();
    match layout.blocks {
        Blocks::Paper | Blocks::Repeated => vec![repeated],
        Blocks::Mirrored => vec![Arrangement::Mirrored],
        // How many cells is found by running it.
        Blocks::Single => vec![Arrangement::Single(FIELDS[0])],
        // A centred block is its own mirror image.
        Blocks::Worst if layout.folded() == (0.0, 0.0) => vec![repeated],
        Blocks::Worst if !layout.can_face() => vec![repeated],
        Blocks::Worst => vec![repeated, Arrangement::Mirrored],
    }
}

/// An arrangement and its ensemble.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stood {
    /// How the blocks stood.
    pub(crate) arrangement: Arrangement,
    /// Of a single block whose field is still too small: by how much the last larger one changed force or
    /// deflection, as a part.
    pub(crate) unsettled: Option<f64>,
    /// Its runs.
    pub(crate) ensemble: Ensemble,
}

/// Cells in a direction around a single block, as they are tried.
const FIELDS: [usize; 3] = [3, 5, 7];
/// Quick runs of each, at the same alignments and slack.
const TRIALS: usize = 4;
/// Change of force and deflection below which more cells change nothing.
const SETTLED: f64 = 0.01;

impl Stood {
    /// How its blocks stood, in words.
    pub(crate) fn words(&self) -> String {
        let Arrangement::Single(n) = self.arrangement else { return word(self.arrangement).into() };
        let unsettled = self.unsettled.map_or(String::new(), |change| {
            format!(", not converged, last change {:.1} %", 100.0 * change)
        });
        format!("single in {n} x {n} cells{unsettled}")
    }

    /// What it is ranked by: the mean force at the first break, or of the peaks where no run broke, N.
    fn force(&self) -> f64 {
        let e = &self.ensemble;
        if e.force.mean > 0.0 { e.force.mean } else { e.peak[0] }
    }
}

/// The ensembles of the layout of `spec`, whose own arrangement is not used; the one with the lowest mean
/// force first. `progress` and `finished` are as those of [`ensemble::run_watched`], with the runs of all
/// arrangements counted through.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(crate) fn run(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    finished: &(dyn Fn(usize, &Run) + Sync),
) -> Result<Vec<Stood>, Vec<Problem>> {
    if spec.test == Test::Anchored && spec.layout.blocks == Blocks::Single {
        return single(spec, controls, plan, progress, finished).map(|stood| vec![stood]);
    }
    let list = match spec.test {
        Test::Anchored => arrangements(&spec.layout),
        Test::Laboratory => vec![Arrangement::default()],
    };
    let mut made: Vec<Stood> = Vec::new();
    for (part, arrangement) in list.iter().copied().enumerate() {
        let before: usize = made.iter().map(|stood| stood.ensemble.runs.len()).sum();
        let to_come = list.len() - part - 1;
        let spec = SceneSpec { arrangement, ..spec.clone() };
        let tell = |now: EnsembleProgress| {
            progress(EnsembleProgress {
                done: before + now.done,
                planned: before + now.planned * (1 + to_come),
                run: before + now.run,
                ..now
            })
        };
        let done = |k: usize, run: &Run| finished(before + k, run);
        let ensemble = paired::run_watched(&spec, controls, plan, &tell, &done)?;
        let short = ensemble.partial();
        made.push(Stood { arrangement, unsettled: None, ensemble });
        if short {
            break;
        }
    }
    // What was cut short is so as a whole: the rest might have been lower. One without a whole run is
    // no answer beside one that has some.
    let short = made.iter().any(|stood| stood.ensemble.partial());
    if short && made.len() > 1 {
        made.retain(|stood| stood.force() > 0.0);
    }
    made.sort_by(|a, b| a.force().total_cmp(&b.force()));
    if let Some(first) = made.first_mut().filter(|first| short && !first.ensemble.partial()) {
        first.ensemble.flags.push(CheckFlag::Cancelled);
    }
    Ok(made)
}

/// One block in the smallest field that a larger one confirms, or in the largest.
fn single(
    spec: &SceneSpec,
    controls: &Controls,
    plan: &Plan,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
    finished: &(dyn Fn(usize, &Run) + Sync),
) -> Result<Stood, Vec<Problem>> {
    let in_field = |n| SceneSpec { arrangement: Arrangement::Single(n), ..spec.clone() };
    let trials = Plan { runs: Some(TRIALS), ..plan.clone() };
    // Where the answer is asked for as the trials are made, those of its field are its runs.
    let own = controls.fidelity == Fidelity::Quick && !plan.auto && plan.runs == trials.runs;
    let after_break = if own { controls.after_break } else { 0.0 };
    let quick = Controls { fidelity: Fidelity::Quick, after_break, ..controls.clone() };
    let mut tried: Vec<(usize, Ensemble)> = Vec::new();
    let mut before: Option<(usize, [f64; 2])> = None;
    let (mut cells, mut unsettled) = (FIELDS[0], None);
    for n in FIELDS {
        let ensemble = ensemble::run(&in_field(n), &quick, &trials, progress)?;
        let now = [ensemble.force.mean, ensemble.deflection.mean];
        if ensemble.partial() {
            let ensemble = Ensemble { runs: Vec::new(), ..ensemble };
            return Ok(Stood { arrangement: Arrangement::Single(n), unsettled: None, ensemble });
        }
        tried.push((n, ensemble));
        if now[0] <= 0.0 {
            break; // The block slips through whatever is around it.
        }
        if let Some((smaller, was)) = before {
            let change = (0..2).map(|k| (now[k] / was[k] - 1.0).abs()).fold(0.0, f64::max);
            (cells, unsettled) = (n, Some(change));
            if change < SETTLED {
                (cells, unsettled) = (smaller, None);
                break;
            }
        }
        before = Some((n, now));
    }
    let mut ensemble = match tried.into_iter().find(|(n, _)| own && *n == cells) {
        Some((_, ensemble)) => {
            ensemble.runs.iter().enumerate().for_each(|(k, run)| finished(k, run));
            ensemble
        }
        None => paired::run_watched(&in_field(cells), controls, plan, progress, finished)?,
    };
    if unsettled.is_some() {
        ensemble.flags.push(CheckFlag::Unsettled);
    }
    Ok(Stood { arrangement: Arrangement::Single(cells), unsettled, ensemble })
}

/// The word for an arrangement.
pub(crate) fn word(arrangement: Arrangement) -> &'static str {
    match arrangement {
        Arrangement::Repeated(_) => "repeated",
        Arrangement::Mirrored => "mirrored",
        Arrangement::Single(_) => "single",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::laws;

    fn spec(blocks: Blocks) -> SceneSpec {
        let layout = Layout {
            plate: 0.25,
            spacing: 1.2,
            punch: 0.5,
            ex: 0.1,
            ey: -0.15,
            blocks,
            ..REFERENCE
        };
        SceneSpec::plain(layout, Test::Anchored, laws::reference())
    }

    fn quick(blocks: Blocks) -> Vec<Stood> {
        let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
        let plan = Plan { runs: Some(2), ..Plan::default() };
        run(&spec(blocks), &controls, &plan, &|_| Flow::Continue, &|_, _| {}).unwrap()
    }

    #[test]
    fn the_worst_is_the_lower_of_the_two_that_are_made_alone() {
        let (repeated, mirrored) = (quick(Blocks::Repeated), quick(Blocks::Mirrored));
        let worst = quick(Blocks::Worst);
        assert_eq!((repeated.len(), mirrored.len(), worst.len()), (1, 1, 2));
        let force = |s: &Stood| s.ensemble.force.mean;
        assert!(force(&mirrored[0]) < force(&repeated[0]));
        let forces: Vec<f64> = worst.iter().map(force).collect();
        assert_eq!(forces, [force(&mirrored[0]), force(&repeated[0])]);
        assert_eq!(worst[0].arrangement, Arrangement::Mirrored);
        let paper = quick(Blocks::Paper);
        assert_eq!(force(&paper[0]), force(&repeated[0]));
    }

    #[test]
    fn a_single_block_loads_few_anchors_and_has_as_many_cells_as_it_needs() {
        let found = quick(Blocks::Single).remove(0);
        let Arrangement::Single(n) = found.arrangement else { panic!("{:?}", found.arrangement) };
        let outcome = &found.ensemble.runs[0].outcome;
        assert!(FIELDS.contains(&n) && outcome.anchors.len() == n * n, "{}", found.words());
        assert_eq!(found.unsettled.is_some(), found.words().contains("not converged"));
        assert_eq!(found.unsettled.is_some(), found.ensemble.flags.contains(&CheckFlag::Unsettled));
        // Nearly all of a block's force goes to the anchors around its cell.
        let few = outcome.anchors_carrying(0.9);
        assert!((2..=n * n / 2).contains(&few), "{few} of {}", n * n);
        let carried: f64 = outcome.anchors.iter().map(|a| a.force[2]).sum();
        let force = outcome.first_break.unwrap().force;
        assert!((carried / force - 1.0).abs() < 0.05, "{carried} {force}");
        // By hand: of 5, 3 and 1 the first two are 8 of 9.
        let mut by_hand = outcome.clone();
        by_hand.anchors.truncate(3);
        for (anchor, force) in by_hand.anchors.iter_mut().zip([3.0, 5.0, 1.0]) {
            anchor.force = [7.0, 7.0, force];
        }
        assert_eq!([0.5, 0.85, 0.9].map(|part| by_hand.anchors_carrying(part)), [1, 2, 3]);
    }

    /// Four quick runs were made twice: to find the field, and for the answer.
    #[test]
    fn the_runs_that_found_the_field_are_the_answers_own_where_they_are_the_same() {
        let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
        let plan = Plan { runs: Some(TRIALS), ..Plan::default() };
        let told = std::sync::Mutex::new(Vec::new());
        // Where a run's number is lower than that of the one before, a field begins.
        let (last, fields) = (std::sync::Mutex::new(usize::MAX), std::sync::Mutex::new(0));
        let progress = |now: EnsembleProgress| {
            let before = std::mem::replace(&mut *last.lock().unwrap(), now.run);
            *fields.lock().unwrap() += usize::from(now.run < before);
            Flow::Continue
        };
        let finished = |k: usize, _: &Run| told.lock().unwrap().push(k);
        let found = run(&spec(Blocks::Single), &controls, &plan, &progress, &finished).unwrap();
        let spec = SceneSpec { arrangement: found[0].arrangement, ..spec(Blocks::Single) };
        let alone = ensemble::run(&spec, &controls, &plan, &|_| Flow::Continue).unwrap();
        let breaks = |ensemble: &Ensemble| -> Vec<_> {
            let of = |run: &Run| (run.seed, run.outcome.first_break, run.outcome.breaks.clone());
            ensemble.runs.iter().map(of).collect()
        };
        assert_eq!(breaks(&found[0].ensemble), breaks(&alone));
        assert_eq!(*told.lock().unwrap(), [0, 1, 2, 3]);
        assert!((2..=FIELDS.len()).contains(&*fields.lock().unwrap()), "{fields:?}");
    }

    #[test]
    fn the_worst_is_the_repeated_one_where_no_other_is() {
        let at = |ex: f64, ey: f64| Layout { ex, ey, blocks: Blocks::Worst, ..REFERENCE };
        assert_eq!(arrangements(&at(0.0, 0.0)), [Arrangement::default()]);
        // L 3, D 1: they overlap beyond 1 m.
        assert_eq!(arrangements(&at(1.2, 0.0)), [Arrangement::default()]);
        assert_eq!(arrangements(&at(0.0, 0.4)).len(), 2);
    }

    #[test]
    fn runs_of_both_are_counted_through_and_a_cut_one_is_partial() {
        let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
        let plan = Plan { runs: Some(2), ..Plan::default() };
        let seen = std::sync::Mutex::new(Vec::new());
        let finished = |k: usize, _: &Run| seen.lock().unwrap().push(k);
        let spec = spec(Blocks::Worst);
        // Ended in the second arrangement's first run.
        let made = run(
            &spec,
            &controls,
            &plan,
            &|now| if now.run >= 2 { Flow::Cancel } else { Flow::Continue },
            &finished,
        )
        .unwrap();
        assert_eq!(seen.lock().unwrap()[..2], [0, 1]);
        assert_eq!(made.len(), 1);
        assert_eq!(made[0].arrangement, Arrangement::default());
        assert!(made[0].ensemble.partial() && made[0].ensemble.runs.len() == 2);
    }
}
