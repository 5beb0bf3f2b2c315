//! Whether the stated range is as wide as it should be: laws are drawn from the prior, each makes a noisy curve
//! of its own as a laboratory would, and it is counted how often the range that the curve gives contains what
//! the law does in the field.
//!
//! A curve is one run, of an alignment and slack of its own: a laboratory has one net. Its gauges are off by
//! [`GAUGES`], every point by [`NOISE`] of the largest force, and one point in [`GAP`] is missing. It goes the
//! whole way of a laboratory's table.

use super::curve::LabCurve;
use super::data::{MeshData, PunchData};
use super::family::LawParameters;
use super::posterior::{IdentifyOptions, gauss, identify, law_of_prior};
use super::rows::{Ended, FitQuestion, FitScene, FitTell, Made, SceneKind};
use crate::curve::Point;
use crate::dem::Test;
use crate::dem::hash::hash;
use crate::layout::{Layout, REFERENCE};
use crate::mesh::wire::NetGeometry;
use std::fmt::Write;

/// Standard deviation of the load cell's and the travel's factor.
const GAUGES: f64 = 0.01;
/// Standard deviation of a point's force, over the largest.
const NOISE: f64 = 0.01;
/// One point in so many is missing.
const GAP: usize = 20;
/// Points of a curve.
const POINTS: usize = 60;
/// Runs that tell what a law does in the field.
const TRUTH_RUNS: usize = 16;
/// Laws drawn for one that can be tested: some of the prior's slip through or are no wires.
const TRIES: usize = 20;

/// What is to be counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CoveragePlan {
    /// Net of all of them.
    pub(crate) net: NetGeometry,
    /// Side of the panel and diameter of the punch of the test, m.
    pub(crate) test: [f64; 2],
    /// How each is found.
    pub(crate) options: IdentifyOptions,
}

/// A law, its test, and the range found from that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CoverageDraw {
    /// Laws that were drawn before it and could not be tested.
    pub(crate) passed_over: usize,
    /// Drawn from the prior, and to be found again.
    pub(crate) law: LawParameters,
    /// The test's end, as it was measured.
    pub(crate) test: Point,
    /// What the law does in the field: force of the anchored reference, N.
    pub(crate) truth: f64,
    /// 5, 50 and 95 % of that by the laws that fit, N; nothing where none does.
    pub(crate) range: Option<[f64; 3]>,
    /// Number of the start about which it was drawn.
    pub(crate) start: usize,
    /// What the laws that fit give to this start.
    pub(crate) weight: f64,
}

impl CoverageDraw {
    /// Whether the range contains it.
    pub(crate) fn inside(&self) -> bool {
        self.range.is_some_and(|[low, _, high]| low <= self.truth && self.truth <= high)
    }
}

/// Makes draw number `k`. Nothing where no law can be tested.
///
/// # Errors
/// Why it was ended.
pub(crate) fn draw(
    plan: &CoveragePlan,
    k: usize,
    tell: &FitTell,
) -> Result<Option<CoverageDraw>, Ended> {
    for passed_over in 0..TRIES {
        let seed = hash(hash(plan.options.seed, 0x636f_7665), (k * TRIES + passed_over) as u64);
        let Some(law) = law_of_prior(k, seed) else { continue };
        let Some((curve, truth)) = tested(plan, &law, seed, tell)? else { continue };
        let test = curve.end();
        let punch = PunchData {
            panel: plan.test[0],
            punch: plan.test[1],
            force: test.force,
            deflection: Some(test.deflection),
            stiffness: None,
            curve: Some(curve),
        };
        let data = MeshData {
            net: plan.net,
            punches: vec![punch],
            tensile: Vec::new(),
            wire_strength: None,
            wire_elongation: None,
            first: None,
        };
        let found = identify(&data, &plan.options, tell)?;
        let start = k % 2;
        let mut weight = 0.0;
        if let Some(found) = &found {
            let laws = found.laws.iter().filter(|law| law.start == start);
            weight = laws.map(|law| law.weight).sum();
        }
        let range = found.map(|found| found.anchored[0]);
        return Ok(Some(CoverageDraw { passed_over, law, test, truth, range, start, weight }));
    }
    Ok(None)
}

/// A law's curve as a laboratory has it, and its force in the field; nothing where it has none.
fn tested(
    plan: &CoveragePlan,
    law: &LawParameters,
    seed: u64,
    tell: &FitTell,
) -> Result<Option<(LabCurve, f64)>, Ended> {
    let [panel, punch] = plan.test;
    let layout = Layout { plate: 0.1 * panel, spacing: panel, punch, ..REFERENCE };
    let scene = |words: &str, test, layout, runs| FitScene {
        words: words.into(),
        kind: SceneKind::Punch(test, layout),
        runs,
    };
    let question = FitQuestion {
        net: plan.net,
        scenes: vec![
            scene("a laboratory's test", Test::Laboratory, layout, 1),
            scene("the law in the field", Test::Anchored, REFERENCE, TRUTH_RUNS),
        ],
        rows: Vec::new(),
        seed: hash(seed, 1),
        fidelity: plan.options.fidelity,
        threads: plan.options.threads,
    };
    let made = question.made(law, tell)?.unwrap_or_default();
    let [Made::Punched(test), Made::Punched(field)] = &made[..] else { return Ok(None) };
    let Some(run) = test.runs.first() else { return Ok(None) };
    let Some(end) = run.outcome.first_break else { return Ok(None) };
    let points = (1..=POINTS).map(|k| {
        let deflection = end.deflection * k as f64 / POINTS as f64;
        Point { deflection, force: run.outcome.curve.force_at(deflection) }
    });
    let curve = LabCurve::read(&table(points, end, seed)).ok();
    let truth = field.force.mean;
    Ok(curve.filter(|_| field.slipped == 0 && truth > 0.0).map(|curve| (curve, truth)))
}

/// The table that a laboratory makes of a curve: millimetres and kilonewtons, with its errors.
fn table(points: impl Iterator<Item = Point>, end: Point, seed: u64) -> String {
    let [travel, cell] = [0, 1].map(|k| (GAUGES * gauss(hash(seed, 2), k)).exp());
    let mut text = "deflection_mm,force_kN\n".to_string();
    for (k, point) in points.enumerate() {
        let force = cell * point.force + NOISE * end.force * gauss(hash(seed, 3), k);
        let deflection = 1000.0 * travel * point.deflection;
        // Writing to a text cannot fail.
        let _ = if k % GAP == GAP / 2 {
            writeln!(text, "{deflection:.1},")
        } else {
            writeln!(text, "{deflection:.1},{:.3}", force / 1000.0)
        };
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_laboratorys_table_has_noise_gaps_and_the_curve_in_it() {
        let end = Point { deflection: 0.6, force: 72_000.0 };
        let points = || {
            (1..=POINTS).map(|k| {
                let deflection = 0.6 * k as f64 / POINTS as f64;
                Point { deflection, force: 200_000.0 * deflection * deflection }
            })
        };
        let read = |seed| LabCurve::read(&table(points(), end, seed)).unwrap();
        let curve = read(7);
        assert_eq!(curve.gaps, 3);
        // Gauges of 1 % and points of 1 %: four standard deviations of both.
        assert!((curve.end().force / 72_000.0 - 1.0).abs() < 0.06, "{:?}", curve.end());
        assert!((curve.end().deflection / 0.6 - 1.0).abs() < 0.08, "{:?}", curve.end());
        assert!(read(8) != curve && read(7) == curve);
    }
}
