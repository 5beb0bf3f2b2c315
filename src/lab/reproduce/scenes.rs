//! The ensembles behind the figures.

use super::{MeanCurve, PARTS, ReproducePlan, SeriesPoint, SimulatedTest, Tell};
use crate::dem::{Arrangement, Controls, SceneSpec, Test};
use crate::forecast::published::published;
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::mesh::MeshType;
use crate::method::DerivedMethod;
use crate::method::offset::Factors;
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, Plan, Run, counts};
use crate::study::result::make::wires;
use crate::study::result::mean;

/// Runs of scenes.
pub(super) struct Scenes<'a> {
    pub(super) plan: &'a ReproducePlan,
    pub(super) mesh: &'a MeshType,
    pub(super) tell: &'a Tell<'a>,
}

impl Scenes<'_> {
    fn ensemble(
        &self,
        (words, part): (&str, usize),
        layout: Layout,
        test: Test,
        arrangement: Arrangement,
        runs: usize,
    ) -> Result<Option<Ensemble>, Vec<Problem>> {
        let plain = SceneSpec::plain(layout, test, wires(self.mesh)?.clone());
        let spec = SceneSpec { arrangement, ..plain };
        let controls =
            Controls { fidelity: self.plan.fidelity, after_break: 0.0, ..Controls::default() };
        let plan = Plan {
            runs: Some(runs),
            seed: self.plan.seed,
            threads: self.plan.threads,
            ..Plan::default()
        };
        let told = |now| (self.tell)(words, part, PARTS, now);
        let ensemble = ensemble::run(&spec, &controls, &plan, &told)?;
        Ok((!ensemble.partial()).then_some(ensemble))
    }

    /// Laboratory tests of some sizes.
    pub(super) fn series(
        &self,
        words: &str,
        part: usize,
        sizes: impl Iterator<Item = f64>,
        layout: impl Fn(f64) -> Layout,
    ) -> Result<Option<Vec<SeriesPoint>>, Vec<Problem>> {
        let mut points = Vec::new();
        for size in sizes.step_by(self.plan.every) {
            let of = (words, part);
            let (test, stand) = (Test::Laboratory, Arrangement::default());
            let runs = self.plan.beside[0];
            let Some(e) = self.ensemble(of, layout(size), test, stand, runs)? else {
                return Ok(None);
            };
            points.push(SeriesPoint {
                size,
                force: e.force.mean,
                deflection: e.deflection.mean,
                k75: e.k75,
                curve: drawn(&e).curve,
            });
        }
        Ok(Some(points))
    }

    /// Table 1, with repeated blocks, and the eccentric ones with mirrored too.
    pub(super) fn tests(&self) -> Result<Option<Vec<SimulatedTest>>, Vec<Problem>> {
        let mut tests = Vec::new();
        for test in &published().tests {
            let layout = Layout { blocks: Blocks::Repeated, ..test.layout() };
            let offset = (layout.ex, layout.ey) != (0.0, 0.0);
            let mut stands = vec![(REPEATED, Arrangement::default())];
            stands.extend(offset.then_some((MIRRORED, Arrangement::Mirrored)));
            let mut by = Vec::new();
            for (words, stand) in stands {
                let of = ("Table 1", 3);
                let runs = self.plan.beside[1];
                let e = self.ensemble(of, layout, Test::Anchored, stand, runs)?;
                let Some(e) = e else { return Ok(None) };
                by.push((words, drawn(&e)));
            }
            tests.push(SimulatedTest { test, by });
        }
        Ok(Some(tests))
    }

    /// Factors over the centred block at the points of Fig. A1 that the paper prints, where blocks face each
    /// other: no campaign here has such runs.
    pub(super) fn facing(
        &self,
        method: &DerivedMethod,
    ) -> Result<Option<Vec<Factors>>, Vec<Problem>> {
        let mut factors = Vec::new();
        for point in &POINTS {
            let of = ("Fig. A1", 4);
            let runs = self.plan.beside[1];
            let (layout, test) = (point.layout(), Test::Anchored);
            let e = self.ensemble(of, layout, test, Arrangement::Mirrored, runs)?;
            let Some(e) = e else { return Ok(None) };
            factors.push(Factors {
                force: e.force.mean / method.reference.force,
                deflection: e.deflection.mean / method.reference.deflection,
            });
        }
        Ok(Some(factors))
    }
}

/// Words of how blocks stand.
pub(super) const REPEATED: &str = "repeated";
pub(super) const MIRRORED: &str = "mirrored";

/// A point of the paper's Fig. A1 with factors that its Table 1 gives away: ex/L, ey/L, and what its forecasts
/// are over Eqs. A.1-A.2.
pub(crate) struct MapPoint {
    pub(crate) at: [f64; 2],
    pub(crate) factors: Factors,
}

/// Tests 5 and 4.
pub(crate) const POINTS: [MapPoint; 2] = [
    MapPoint { at: [0.157, 0.329], factors: Factors { force: 0.628, deflection: 0.85 } },
    MapPoint { at: [0.5, 0.05], factors: Factors { force: 1.139, deflection: 0.815 } },
];

impl MapPoint {
    /// The reference panel with a block there.
    pub(crate) fn layout(&self) -> Layout {
        let [ex, ey] = self.at.map(|part| part * REFERENCE.spacing);
        Layout { ex, ey, ..REFERENCE }
    }
}

/// Mean curve and band of an ensemble.
fn drawn(ensemble: &Ensemble) -> MeanCurve {
    let runs: Vec<&Run> = ensemble.runs.iter().filter(|run| counts(run)).collect();
    let (curve, band) = mean::curve(&runs, &ensemble.sample);
    MeanCurve { curve, band }
}
