//! The reference mesh as if nobody had seen it in the field: adopted from its laboratory test alone, with its
//! stiffness, and with a whole curve; and whether what follows for the field contains what the paper found there.
//!
//! The paper's values are single simulations, ours are over laws and alignments. Two ranges are given: of the mean
//! over alignments, which is what a forecast gives, and of one run, which is what the paper has. No curve of the
//! test is published: the third one is made up, simulated with the catalogue's law, which has seen the field.

use super::{ANCHORED, K75, LABORATORY};
use crate::curve::Point;
use crate::dem::{Flow, Test};
use crate::forecast::published::published;
use crate::lab::fit::curve::LabCurve;
use crate::lab::fit::data::{MeshData, PunchData};
use crate::lab::fit::posterior::{
    ANCHORED_RUNS, Identified, IdentifyOptions, SOLVERS, blurred, identify, widened,
};
use crate::lab::fit::rows::{Ended, FitQuestion, FitScene, Made, SceneKind};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::{STANDARD_PANEL, STANDARD_PUNCH, catalogue};
use crate::study::ensemble::EnsembleProgress;
use crate::study::sampling::spread::Spread;

/// Tests of Table 1 that are looked at: the fifth needs blocks that face each other.
const TESTS: usize = 4;
/// Points of the made-up curve.
const POINTS: usize = 60;
/// Standard deviations from the middle of a normal distribution to its 5 % point.
const FIVE_PER_CENT: f64 = 1.645;
/// Laws of less weight are left out of what is simulated again.
const LEAST: f64 = 1.0e-3;

/// What was told of the mesh, and what follows.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AdoptedFrom {
    /// What was told, in words.
    pub(crate) words: &'static str,
    /// How many laws fit.
    pub(crate) laws: usize,
    /// The paper's reference and tests.
    pub(crate) rows: Vec<FieldRange>,
}

/// A value of the paper beside the ranges that follow for it. SI.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FieldRange {
    /// The case in words.
    pub(crate) case: String,
    /// Whether it is the deflection, or else the force.
    pub(crate) deflection: bool,
    /// The paper's value.
    pub(crate) paper: f64,
    /// 5, 50 and 95 % of the mean over alignments.
    pub(crate) mean: [f64; 3],
    /// The same of a single run.
    pub(crate) one: [f64; 3],
}

impl FieldRange {
    /// Whether a range contains the paper's value.
    pub(crate) fn within(&self, [low, _, high]: [f64; 3]) -> bool {
        low <= self.paper && self.paper <= high
    }
}

/// What is told on the way: what is made in words, a part of how many, where its runs end, and their progress.
pub(crate) type AdoptedTell<'a> =
    dyn Fn(&str, usize, usize, f64, EnsembleProgress) -> Flow + Sync + 'a;

/// Makes the table. Nothing where no law fits.
///
/// # Errors
/// Why it was ended.
pub(crate) fn adopted(
    options: &IdentifyOptions,
    tell: &AdoptedTell,
) -> Result<Option<Vec<AdoptedFrom>>, Ended> {
    let stiffness = K75.iter().find(|(panel, _)| *panel == STANDARD_PANEL).map(|(_, k)| *k);
    let curve = made_up(options)?;
    let told = [
        ("punch test", None, None),
        ("punch test and k75", stiffness, None),
        ("punch test and a made-up curve", None, curve.clone()),
        ("punch test, k75 and a made-up curve", stiffness, curve),
    ];
    let parts = 2 * told.len();
    let mut all = Vec::new();
    for (k, (words, stiffness, curve)) in told.into_iter().enumerate() {
        let punch = PunchData { stiffness, curve, ..laboratory() };
        let data = MeshData { punches: vec![punch], ..of_reference() };
        let found = identify(&data, options, &|scene, now| {
            tell(&format!("{words}: laws"), 2 * k, parts, scene.end(), now)
        })?;
        let Some(found) = found else { return Ok(None) };
        let rows = rows(&found, &|scene, now| {
            tell(&format!("{words}: {}", scene.words), 2 * k + 1, parts, scene.end(), now)
        })?;
        all.push(AdoptedFrom { words, laws: found.laws.len(), rows });
    }
    Ok(Some(all))
}

fn laboratory() -> PunchData {
    PunchData {
        panel: STANDARD_PANEL,
        punch: STANDARD_PUNCH,
        force: LABORATORY[0],
        deflection: Some(LABORATORY[1]),
        stiffness: None,
        curve: None,
    }
}

fn of_reference() -> MeshData {
    let mesh = catalogue::reference();
    // A test of the catalogue holds that the reference mesh has wires.
    let net =
        mesh.wire.as_ref().map_or_else(|| crate::mesh::laws::reference().net, |wire| wire.net);
    MeshData {
        net,
        punches: vec![laboratory()],
        tensile: Vec::new(),
        wire_strength: None,
        wire_elongation: None,
        first: None,
    }
}

/// A curve of the laboratory test: one run with the catalogue's law, drawn to the paper's end.
fn made_up(options: &IdentifyOptions) -> Result<Option<LabCurve>, Ended> {
    let mesh = catalogue::reference();
    let Some(wire) = &mesh.wire else { return Ok(None) };
    let question = of_reference().question(options.seed, options.fidelity, options.threads);
    let made = question.made_of(wire, &|_, _| Flow::Continue)?;
    let Some(Made::Punched(test)) = made.first() else { return Ok(None) };
    let Some(run) = test.runs.first() else { return Ok(None) };
    let Some(end) = run.outcome.first_break else { return Ok(None) };
    let points = (1..=POINTS).map(|k| {
        let part = k as f64 / POINTS as f64;
        let force = run.outcome.curve.force_at(part * end.deflection) / end.force;
        Point { deflection: part * LABORATORY[1], force: force * LABORATORY[0] }
    });
    Ok(Some(LabCurve { points: points.collect(), gaps: 0, behind: 0 }))
}

/// The ranges of the reference panel and of the tests, over the laws that fit.
fn rows(
    found: &Identified,
    tell: &(dyn Fn(&FitScene, EnsembleProgress) -> Flow + Sync),
) -> Result<Vec<FieldRange>, Ended> {
    let mut cases = vec![("anchored reference".to_string(), REFERENCE, ANCHORED)];
    cases.extend(published().tests.iter().take(TESTS).map(|test| {
        let paper = [1000.0 * test.dem.force.value(), test.dem.deflection.value()];
        (format!("Table 1, test {}", test.test), test.layout(), paper)
    }));
    let scene = |words: &str, layout: Layout| FitScene {
        words: words.into(),
        kind: SceneKind::Punch(Test::Anchored, layout),
        runs: ANCHORED_RUNS,
    };
    let question = FitQuestion {
        scenes: cases.iter().map(|(words, layout, _)| scene(words, *layout)).collect(),
        rows: Vec::new(),
        ..found.question.clone()
    };
    let mut made = Vec::new();
    for law in found.laws.iter().filter(|law| law.weight >= LEAST) {
        if let Some(all) = question.made(&law.law, tell)? {
            made.push((law.weight, all));
        }
    }
    let mut rows = Vec::new();
    for (k, (case, _, paper)) in cases.iter().enumerate() {
        let spreads: Vec<(f64, [Spread; 2])> = made
            .iter()
            .filter_map(|(weight, all)| match all.get(k)? {
                Made::Punched(e) if e.force.mean > 0.0 => Some((*weight, [e.force, e.deflection])),
                _ => None,
            })
            .collect();
        for deflection in [false, true] {
            let of = usize::from(deflection);
            let (mean, one) = ranges(spreads.iter().map(|(weight, of_law)| (*weight, of_law[of])));
            let case = case.clone();
            rows.push(FieldRange { case, deflection, paper: paper[of], mean, one });
        }
    }
    Ok(rows)
}

/// The range of the mean and that of a single run, over laws with their weights.
fn ranges(laws: impl Iterator<Item = (f64, Spread)>) -> ([f64; 3], [f64; 3]) {
    let laws: Vec<(f64, Spread)> = laws.collect();
    let sum: f64 = laws.iter().map(|(weight, _)| weight).sum();
    let squares = |of: &dyn Fn(&Spread) -> f64| -> f64 {
        laws.iter().map(|(weight, s)| weight / sum * (of(s) / s.mean).powi(2)).sum()
    };
    let values: Vec<_> = laws.iter().map(|(weight, s)| (s.mean, weight / sum)).collect();
    let error = squares(&|s| s.error).sqrt().hypot(SOLVERS);
    let scatter = squares(&|s| s.deviation).sqrt();
    let mean = widened(blurred(&values, error));
    // A run's own scatter comes to what is not known of the mean, each side for itself.
    let further = |end: f64| libm::log(end / mean[1]).abs().hypot(FIVE_PER_CENT * scatter);
    let one =
        [mean[1] * libm::exp(-further(mean[0])), mean[1], mean[1] * libm::exp(further(mean[2]))];
    (mean, one)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_run_scatters_more_than_the_mean_by_its_own_deviation() {
        let spread = Spread { mean: 20_000.0, deviation: 1600.0, error: 400.0, band: [0.0; 2] };
        let (mean, one) = ranges([(2.0, spread)].into_iter());
        // By hand: 1.42 x hypot(0.02, 0.015) = 0.0355 and hypot(0.0355, 0.08) = 0.087523; 1.645 of each.
        let by_hand = |sigma: f64| [-1.0, 0.0, 1.0].map(|k| 20_000.0 * (k * 1.645 * sigma).exp());
        for (made, wanted) in mean.iter().zip(by_hand(0.0355)) {
            assert!((made / wanted - 1.0).abs() < 1e-5, "{mean:?}");
        }
        for (made, wanted) in one.iter().zip(by_hand(0.087_523)) {
            assert!((made / wanted - 1.0).abs() < 1e-5, "{one:?}");
        }
    }
}
