//! Run time against error, measured now: the bench scenes at every fidelity against the reference
//! fidelity, and beside each time the one of a plain double-precision explicit run.

use crate::dem::inertia::StepFactors;
use crate::dem::plain::{Damping, Inertia, Plain};
use crate::dem::run::drive;
use crate::dem::{Controls, Fidelity, Flow, RunOutcome, Scene, SceneSpec, Stop, Test, check};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::laws;
use crate::problem::Problem;
use crate::study::clock::thread_seconds;
use crate::words::Choice;
use serde::Serialize;

/// The bench scenes by name.
pub(crate) const SCENES: [&str; 4] = ["A", "B", "C", "A'"];

/// A bench scene: A anchored L = 3 m, B laboratory L = 3 m, C anchored and eccentric L = 4 m, all with
/// the bench law; A' is A with the reference law and one seed.
pub fn scene(name: &str) -> Option<SceneSpec> {
    let c = Layout { plate: 0.40, spacing: 4.0, punch: 1.2, ex: 2.0, ey: 0.2, ..REFERENCE };
    let (layout, test, wire) = match name {
        "A" => (REFERENCE, Test::Anchored, laws::bench()),
        "B" => (REFERENCE, Test::Laboratory, laws::bench()),
        "C" => (c, Test::Anchored, laws::bench()),
        "A'" | "A2" => (REFERENCE, Test::Anchored, laws::reference()),
        _ => return None,
    };
    Some(SceneSpec { seed: 1, ..SceneSpec::plain(layout, test, wire) })
}

/// Errors of a run against a reference, as parts of 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Errors {
    /// Force at the first break.
    pub(crate) force: f64,
    /// Deflection at the first break.
    pub(crate) deflection: f64,
    /// Largest difference of the curves up to the first break, over the reference's force there.
    pub(crate) curve: f64,
}

impl Errors {
    /// The worst of the three.
    pub(crate) fn worst(&self) -> f64 {
        self.force.abs().max(self.deflection.abs()).max(self.curve)
    }
}

/// Errors of `outcome` against `reference`; nothing if one of them has no first break.
pub(crate) fn errors(outcome: &RunOutcome, reference: &RunOutcome) -> Option<Errors> {
    let (a, b) = (outcome.first_break?, reference.first_break?);
    // Two millimetres off both ends: the last points are means over a part of the break.
    let end = a.deflection.min(b.deflection) - 0.002;
    let curve = outcome
        .curve
        .points()
        .filter(|p| p.deflection < end)
        .map(|p| (p.force - reference.curve.force_at(p.deflection)).abs())
        .fold(0.0, f64::max);
    Some(Errors {
        force: a.force / b.force - 1.0,
        deflection: a.deflection / b.deflection - 1.0,
        curve: curve / b.force,
    })
}

/// One row of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BenchRow {
    pub scene: String,
    /// Fidelity, or `plain`.
    pub fidelity: String,
    /// Processor time to the first break, set-up included, best of several, ms.
    pub wall_ms: f64,
    /// Steps to the first break.
    pub steps: usize,
    /// Error of the force at the first break, %.
    #[serde(rename = "F_error_pct")]
    pub force_error: f64,
    /// Error of the deflection at the first break, %.
    #[serde(rename = "delta_error_pct")]
    pub deflection_error: f64,
    /// Largest difference of the curves up to the first break, over the force there, %.
    #[serde(rename = "curve_error_pct")]
    pub curve_error: f64,
    /// Error estimate that the run itself gives, %.
    #[serde(rename = "error_estimate_pct")]
    pub estimate: f64,
    /// Time of the plain double-precision run over this one.
    #[serde(rename = "times_faster_than_plain")]
    pub faster: f64,
    /// Force and deflection at the first break.
    #[serde(rename = "F_kN")]
    pub force: f64,
    /// Deflection at the first break, m.
    #[serde(rename = "delta_m")]
    pub deflection: f64,
}

/// How well the reference itself is known: the change of its three figures when its speed is halved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct KnownError {
    pub(crate) scene: String,
    /// Changes, %.
    #[serde(rename = "F_pct")]
    pub(crate) force: f64,
    /// Changes, %.
    #[serde(rename = "delta_pct")]
    pub(crate) deflection: f64,
    /// Changes, %.
    #[serde(rename = "curve_pct")]
    pub(crate) curve: f64,
}

fn controls(fidelity: Fidelity) -> Controls {
    Controls { fidelity, after_break: 0.0, ..Controls::default() }
}

/// Who listens to a study of solvers, and may end it early.
#[derive(Clone, Copy)]
pub(crate) struct Listener<'a> {
    /// Is told what is being run.
    pub(crate) tell: &'a dyn Fn(&str),
    /// Is asked whether to go on, many times in every run.
    pub(crate) ask: &'a dyn Fn() -> Flow,
}

impl Listener<'_> {
    /// Runs a check; nothing where it was ended early.
    ///
    /// # Errors
    /// What is wrong with the scene or the controls.
    pub(crate) fn check(
        &self,
        spec: &SceneSpec,
        controls: &Controls,
    ) -> Result<Option<RunOutcome>, Vec<Problem>> {
        let outcome = check(spec, controls, &mut |_| (self.ask)())?;
        Ok((outcome.stop != Stop::Cancelled).then_some(outcome))
    }

    /// Runs and times one check, s of processor time; the best of `times`.
    ///
    /// # Errors
    /// What is wrong with the scene or the controls.
    pub(crate) fn timed(
        &self,
        spec: &SceneSpec,
        controls: &Controls,
        times: usize,
    ) -> Result<Option<(RunOutcome, f64)>, Vec<Problem>> {
        let mut best: Option<(RunOutcome, f64)> = None;
        for _ in 0..times {
            let start = thread_seconds();
            let Some(outcome) = self.check(spec, controls)? else { return Ok(None) };
            let time = thread_seconds() - start;
            if best.as_ref().is_none_or(|b| time < b.1) {
                best = Some((outcome, time));
            }
        }
        Ok(best)
    }
}

/// Travel per step of the plain run, m: 1 m/s at 0.95 of the critical step of 3.9 g nodes.
const PLAIN_TRAVEL: f64 = 8.8e-6;
/// Step factor of the plain run over the bound of Gershgorin.
const PLAIN_STEP: f64 = 0.8;

/// The plain run: double precision, one loop over bonds and one over nodes, the same mass for all
/// nodes, local damping 0.5, force taken at the punch, 1 m/s; timed. Nothing where it was ended early.
///
/// # Errors
/// What is wrong with the scene.
pub(crate) fn plain(
    spec: &SceneSpec,
    listener: Listener,
) -> Result<Option<(RunOutcome, f64)>, Vec<Problem>> {
    let start = thread_seconds();
    let scene = Scene::new(spec)?;
    // Gershgorin: the sum over a node's bonds (two wires and a twist) of 2 k is at most 4 m.
    let wire = scene.law.single.unloading / scene.lattice.wire_length();
    let twist = scene.law.twist.unloading / scene.lattice.twist_length();
    let mass = (2.0 * wire + twist) / 2.0 / (PLAIN_STEP * PLAIN_STEP);
    let mut solver = Plain::of_scene(&scene, Inertia::Uniform(mass), Damping::Local(0.5));
    let controls = controls(Fidelity::Standard);
    let mut scheme = controls.scheme(&scene)?;
    scheme.travel = PLAIN_TRAVEL;
    scheme.factors = StepFactors { translation: PLAIN_STEP, stretching: PLAIN_STEP };
    let mut outcome = drive(&scene, &mut solver, &scheme, &controls, &mut |_| (listener.ask)());
    let time = thread_seconds() - start;
    outcome.curve.force.clone_from(&outcome.punch);
    Ok((outcome.stop != Stop::Cancelled).then_some((outcome, time)))
}

/// The table, how well each scene's reference is known, and whether it was ended early.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Table {
    /// Rows, scene by scene.
    pub(crate) rows: Vec<BenchRow>,
    /// References.
    pub(crate) known: Vec<KnownError>,
    /// Whether it was ended early, so that something is missing.
    pub(crate) part: bool,
}

/// The table of the scenes named; what is done by then where `listener` ends it early.
///
/// # Errors
/// A scene that is not known.
pub(crate) fn table(names: &[&str], listener: Listener) -> Result<Table, Vec<Problem>> {
    let mut table = Table::default();
    for name in names {
        let Some(spec) = scene(name) else {
            return Err(vec![
                Problem::new("scene", "there is no such bench scene")
                    .value(*name)
                    .allowed(SCENES.join(", ")),
            ]);
        };
        table.part = table.scene(name, &spec, listener)?.is_none();
        if table.part {
            break;
        }
    }
    Ok(table)
}

impl Table {
    /// Adds the rows of one scene; nothing where that was ended early.
    fn scene(
        &mut self,
        name: &str,
        spec: &SceneSpec,
        listener: Listener,
    ) -> Result<Option<()>, Vec<Problem>> {
        let tell = |what: &str| (listener.tell)(&format!("scene {name}: {what}"));
        tell("reference");
        let run = listener.timed(spec, &controls(Fidelity::Reference), 1)?;
        let Some((reference, reference_time)) = run else { return Ok(None) };
        tell("reference at half the speed");
        let travel = controls(Fidelity::Reference).scheme(&Scene::new(spec)?)?.travel;
        let half = Controls { speed: Some(travel / 2.0), ..controls(Fidelity::Reference) };
        let Some(better) = listener.check(spec, &half)? else { return Ok(None) };
        let gap = errors(&reference, &better).unwrap_or_default();
        self.known.push(KnownError {
            scene: name.to_string(),
            force: 100.0 * gap.force,
            deflection: 100.0 * gap.deflection,
            curve: 100.0 * gap.curve,
        });
        tell("plain double precision");
        let Some((slow, slow_time)) = plain(spec, listener)? else { return Ok(None) };
        let mut push = |fidelity: &str, outcome: &RunOutcome, time: f64| {
            let e = errors(outcome, &better).unwrap_or_default();
            let p = outcome.first_break.unwrap_or_default();
            self.rows.push(BenchRow {
                scene: name.to_string(),
                fidelity: fidelity.to_string(),
                wall_ms: 1.0e3 * time,
                steps: outcome.cost.steps_to_break,
                force_error: 100.0 * e.force,
                deflection_error: 100.0 * e.deflection,
                curve_error: 100.0 * e.curve,
                estimate: 100.0 * outcome.quality.error_estimate,
                faster: slow_time / time,
                force: p.force / 1.0e3,
                deflection: p.deflection,
            });
        };
        for fidelity in [Fidelity::Quick, Fidelity::Standard, Fidelity::Fine] {
            tell(fidelity.word());
            let run = listener.timed(spec, &controls(fidelity), 7)?;
            let Some((outcome, time)) = run else { return Ok(None) };
            push(fidelity.word(), &outcome, time);
        }
        push("reference", &reference, reference_time);
        push("plain", &slow, slow_time);
        Ok(Some(()))
    }
}
