//! What a fit compares: rows, each a figure of a scene beside its target, and the simulation that gives
//! all of them for one law.

use super::family::LawParameters;
use crate::dem::{Arrangement, Controls, Fidelity, Flow, PLAIN_PHASE, SceneSpec, Test};
use crate::layout::Layout;
use crate::mesh::wire::{NetGeometry, WireData};
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, EnsembleProgress, Plan, Run};

/// A scene whose ensemble rows read.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitScene {
    /// The scene in words.
    pub(crate) words: String,
    /// Which test.
    pub(crate) test: Test,
    /// Panel, plates and punch.
    pub(crate) layout: Layout,
    /// Runs of its ensemble: fixed draws, the same for every law.
    pub(crate) runs: usize,
}

/// What a row reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Measure {
    /// Force at the first break, N.
    Force,
    /// Deflection at the first break, m.
    Deflection,
    /// Tangent stiffness at 75 % of that force, N/m.
    Stiffness,
    /// Force at this part of the deflection at the first break, over the force there.
    Shape(f64),
}

/// A row.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitRow {
    /// In words.
    pub(crate) label: String,
    /// Number of the scene.
    pub(crate) scene: usize,
    /// What is read.
    pub(crate) measure: Measure,
    /// Number of the scene whose figure it is divided by.
    pub(crate) over: Option<usize>,
    /// What it should be, in the unit of the measure.
    pub(crate) target: f64,
    /// Standard deviation that is granted: a part of the target; of 1 for a shape.
    pub(crate) sigma: f64,
}

impl FitRow {
    /// The residual of a value, in standard deviations.
    pub(crate) fn residual(&self, value: f64) -> f64 {
        match self.measure {
            Measure::Shape(_) => (value - self.target) / self.sigma,
            _ => (value / self.target).ln() / self.sigma,
        }
    }

    /// The row's value in these ensembles; nothing where none of its runs has one.
    fn value(&self, ensembles: &[Ensemble]) -> Option<f64> {
        let of = |scene: usize| mean(&ensembles[scene].runs, self.measure);
        let value = of(self.scene)?;
        let base = self.over.map_or(Some(1.0), of)?;
        Some(value / base).filter(|v| v.is_finite() && *v > 0.0)
    }
}

/// Mean of a figure over the runs that have it.
fn mean(runs: &[Run], measure: Measure) -> Option<f64> {
    let figure = |run: &Run| {
        let end = run.outcome.first_break?;
        match measure {
            Measure::Force => Some(end.force),
            Measure::Deflection => Some(end.deflection),
            Measure::Stiffness => Some(run.outcome.k75).filter(|k| *k > 0.0),
            Measure::Shape(part) => {
                Some(run.outcome.curve.force_at(part * end.deflection) / end.force)
            }
        }
    };
    let values: Vec<f64> = runs.iter().filter_map(figure).collect();
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// All that a fit compares with, and how it simulates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitQuestion {
    /// The net.
    pub(crate) net: NetGeometry,
    /// The scenes.
    pub(crate) scenes: Vec<FitScene>,
    /// The rows.
    pub(crate) rows: Vec<FitRow>,
    /// Seed of alignments and slack.
    pub(crate) seed: u64,
    /// How exactly each run is computed.
    pub(crate) fidelity: Fidelity,
    /// Threads, at least 1; the result does not depend on them.
    pub(crate) threads: usize,
}

/// Why a simulation gave no rows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Ended {
    /// The caller wanted no more.
    Cancelled,
    /// A scene cannot be built with any law.
    Bad(Vec<Problem>),
}

/// What is told on the way: the scene, and its ensemble's progress.
pub(crate) type FitTell<'a> = dyn Fn(&FitScene, EnsembleProgress) -> Flow + Sync + 'a;

impl FitQuestion {
    /// The value of every row under a law; nothing where the law cannot be run or a row has no value.
    ///
    /// # Errors
    /// Why it was ended.
    pub(crate) fn values(
        &self,
        law: &LawParameters,
        tell: &FitTell,
    ) -> Result<Option<Vec<f64>>, Ended> {
        let wire = law.wire(self.net, String::new());
        if wire.check().is_err() {
            return Ok(None);
        }
        let mut made = Vec::with_capacity(self.scenes.len());
        for scene in &self.scenes {
            made.push(self.ensemble(scene, &wire, tell)?);
        }
        Ok(self.rows.iter().map(|row| row.value(&made)).collect())
    }

    fn ensemble(
        &self,
        scene: &FitScene,
        wire: &WireData,
        tell: &FitTell,
    ) -> Result<Ensemble, Ended> {
        let spec = SceneSpec {
            layout: scene.layout,
            test: scene.test,
            wire: wire.clone(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        let controls =
            Controls { fidelity: self.fidelity, after_break: 0.0, ..Controls::default() };
        let plan =
            Plan { runs: Some(scene.runs), seed: self.seed, phase: None, threads: self.threads };
        let made =
            ensemble::run(&spec, &controls, &plan, &|now| tell(scene, now)).map_err(Ended::Bad)?;
        if made.partial() { Err(Ended::Cancelled) } else { Ok(made) }
    }
}
