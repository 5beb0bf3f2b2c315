//! What a fit compares: rows, each a figure of a scene beside its target, and the simulation that gives
//! all of them for one law.

use super::family::LawParameters;
use crate::dem::hash::hash;
use crate::dem::lattice::Role;
use crate::dem::tensile::{Pull, TensileOutcome, TensileSpec, tensile};
use crate::dem::{Controls, Fidelity, Flow, SceneSpec, Test};
use crate::layout::Layout;
use crate::mesh::wire::{NetGeometry, WireData};
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, EnsembleProgress, Plan, Run};

/// A scene whose ensemble rows read.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitScene {
    /// The scene in words.
    pub(crate) words: String,
    /// What is done to the net.
    pub(crate) kind: SceneKind,
    /// Runs of its ensemble: fixed draws, the same for every law.
    pub(crate) runs: usize,
}

/// What is done to the net.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SceneKind {
    /// A punch test: which, and panel, plates and punch.
    Punch(Test, Layout),
    /// A tensile test: width, length, m, and which way.
    Tensile(f64, f64, Pull),
}

impl FitScene {
    /// About the deflection at which it ends, m.
    pub(crate) fn end(&self) -> f64 {
        match self.kind {
            SceneKind::Punch(_, layout) => 0.2 * layout.spacing,
            SceneKind::Tensile(_, length, _) => 0.1 * length,
        }
    }
}

/// The runs of a scene.
pub(crate) enum Made {
    /// Of a punch test.
    Punched(Box<Ensemble>),
    /// Of a tensile test.
    Pulled(Vec<TensileOutcome>),
}

impl Made {
    /// Part of the runs in which a double twist broke first.
    pub(crate) fn twists_first(&self) -> f64 {
        let first: Vec<Role> = match self {
            Made::Punched(e) => {
                e.runs.iter().filter_map(|r| Some(r.outcome.breaks.first()?.role)).collect()
            }
            Made::Pulled(all) => all.iter().filter_map(|outcome| outcome.broke).collect(),
        };
        let twists = first.iter().filter(|role| **role == Role::Twist).count();
        twists as f64 / first.len().max(1) as f64
    }
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
    /// Force at this deflection, m, over the runs that reach it, N.
    ForceAt(f64),
    /// Strength of the net in a tensile test, N/m.
    Strength,
    /// Strength of the wire, MPa; reads the law and no scene.
    WireStrength,
    /// Elongation of the wire at its rupture; reads the law and no scene.
    WireElongation,
}

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

    /// The row's value under a law whose scenes are made; nothing where none of its runs has one.
    fn value(&self, law: &LawParameters, made: &[Made]) -> Option<f64> {
        let of = |scene: usize| match self.measure {
            Measure::WireStrength => Some(law.wire_strength()),
            Measure::WireElongation => Some(law.rupture),
            measure => mean(made.get(scene)?, measure),
        };
        let value = of(self.scene)?;
        let base = self.over.map_or(Some(1.0), of)?;
        Some(value / base).filter(|v| v.is_finite() && *v > 0.0)
    }
}

/// Mean of a figure over the runs that have it.
fn mean(made: &Made, measure: Measure) -> Option<f64> {
    let values: Vec<f64> = match made {
        Made::Punched(e) => e.runs.iter().filter_map(|run| figure(run, measure)).collect(),
        Made::Pulled(all) => all.iter().map(|outcome| outcome.strength).collect(),
    };
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// A figure of a run of a punch test.
fn figure(run: &Run, measure: Measure) -> Option<f64> {
    let end = run.outcome.first_break?;
    let curve = &run.outcome.curve;
    match measure {
        Measure::Force => Some(end.force),
        Measure::Deflection => Some(end.deflection),
        Measure::Stiffness => Some(run.outcome.k75).filter(|k| *k > 0.0),
        Measure::Shape(part) => Some(curve.force_at(part * end.deflection) / end.force),
        // A run that broke before goes on as its last points did: a row that loses runs would jump.
        Measure::ForceAt(at) => Some(curve.force_at(at)).filter(|f| *f > 0.0),
        Measure::Strength | Measure::WireStrength | Measure::WireElongation => None,
    }
}

/// All that a fit compares with, and how it simulates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FitQuestion {
    pub(crate) net: NetGeometry,
    pub(crate) scenes: Vec<FitScene>,
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
        Ok(self.made(law, tell)?.and_then(|made| self.read(law, &made)))
    }

    /// The value of every row where its scenes are made.
    pub(crate) fn read(&self, law: &LawParameters, made: &[Made]) -> Option<Vec<f64>> {
        self.rows.iter().map(|row| row.value(law, made)).collect()
    }

    /// The scenes under a law; nothing where the law cannot be run.
    ///
    /// # Errors
    /// Why it was ended.
    pub(crate) fn made(
        &self,
        law: &LawParameters,
        tell: &FitTell,
    ) -> Result<Option<Vec<Made>>, Ended> {
        let wire = law.wire(self.net, String::new());
        if wire.check().is_err() {
            return Ok(None);
        }
        self.made_of(&wire, tell).map(Some)
    }

    /// The scenes with these wires.
    ///
    /// # Errors
    /// Why it was ended.
    pub(crate) fn made_of(&self, wire: &WireData, tell: &FitTell) -> Result<Vec<Made>, Ended> {
        let mut made = Vec::with_capacity(self.scenes.len());
        for scene in &self.scenes {
            made.push(match scene.kind {
                SceneKind::Punch(test, layout) => {
                    Made::Punched(Box::new(self.punched(scene, (test, layout), wire, tell)?))
                }
                SceneKind::Tensile(width, length, pull) => {
                    Made::Pulled(self.pulled(scene, (width, length, pull), wire, tell)?)
                }
            });
        }
        Ok(made)
    }

    fn punched(
        &self,
        scene: &FitScene,
        (test, layout): (Test, Layout),
        wire: &WireData,
        tell: &FitTell,
    ) -> Result<Ensemble, Ended> {
        let spec = SceneSpec::plain(layout, test, wire.clone());
        let controls =
            Controls { fidelity: self.fidelity, after_break: 0.0, ..Controls::default() };
        let plan = Plan {
            runs: Some(scene.runs),
            seed: self.seed,
            threads: self.threads,
            ..Plan::default()
        };
        let made =
            ensemble::run(&spec, &controls, &plan, &|now| tell(scene, now)).map_err(Ended::Bad)?;
        if made.partial() { Err(Ended::Cancelled) } else { Ok(made) }
    }

    fn pulled(
        &self,
        scene: &FitScene,
        (width, length, pull): (f64, f64, Pull),
        wire: &WireData,
        tell: &FitTell,
    ) -> Result<Vec<TensileOutcome>, Ended> {
        let mut all = Vec::new();
        for run in 0..scene.runs {
            let seed = hash(self.seed, run as u64);
            let spec = TensileSpec { width, length, pull, wire: wire.clone(), seed };
            let mut cancelled = false;
            let outcome = tensile(&spec, &mut |elongation| {
                let inner = spec.progress(elongation);
                let now = EnsembleProgress { done: run, planned: scene.runs, run, inner };
                let flow = tell(scene, now);
                cancelled |= flow == Flow::Cancel;
                flow
            })
            .map_err(Ended::Bad)?;
            if cancelled {
                return Err(Ended::Cancelled);
            }
            all.push(outcome);
        }
        Ok(all)
    }
}

#[cfg(test)]
mod tests {
    use super::super::sheet::Sheet;
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::laws;

    /// Wires of 3.9 mm have 2.09 times the area of 2.7 mm, and nets 10x12 have four of them where nets 8x10
    /// have five: 1.67 times the force in a test, more or less by where the punch stands.
    #[test]
    fn coarse_and_thick_nets_come_to_sensible_ends_in_laboratory_and_field() {
        let law = LawParameters::of([1.0, 0.44, 0.155, 0.67, 0.18, 0.03]);
        let ends = |opening, diameter| -> Vec<[f64; 2]> {
            let net = [Some(opening), None, Some(diameter)];
            let sheet =
                Sheet { force: Some(30_000.0), panel: 1.6, punch: 0.5, net, ..Sheet::default() };
            let data = sheet.data(&laws::reference().net).unwrap();
            let mut question = data.question(0, Fidelity::Quick, 2);
            let field = SceneKind::Punch(Test::Anchored, REFERENCE);
            question.scenes.push(FitScene { words: "field".into(), kind: field, runs: 2 });
            let made = question.made(&law, &|_, _| Flow::Continue).unwrap().unwrap();
            let ends = made.iter().map(|made| match made {
                Made::Punched(e) => [e.force.mean, e.deflection.mean],
                Made::Pulled(_) => panic!("no pull was asked for"),
            });
            ends.collect()
        };
        let usual = ends(0.08, 0.0027);
        for (opening, diameter) in [(0.1, 0.0027), (0.08, 0.0039), (0.1, 0.0039)] {
            let factor = (diameter / 0.0027_f64).powi(2) * 0.08 / opening;
            for (made, usual) in ends(opening, diameter).iter().zip(&usual) {
                let off = made[0] / usual[0] / factor;
                assert!((0.75..1.33).contains(&off), "{opening} {diameter}: {made:?} {usual:?}");
                assert!((0.8..1.25).contains(&(made[1] / usual[1])), "{made:?} {usual:?}");
            }
        }
    }
}
