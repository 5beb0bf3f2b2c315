//! The wires of the reference mesh, decided by a rule: the rows and weights of `assets/reference_fit.ron`,
//! a search from each of its starts, and the law with the lowest score.
//!
//! The rows are the paper's laboratory test with Eqs. 1-2 and its stiffness, the field reference, Eqs.
//! A.1-A.2 with one size changed at a time, and Eq. 3. Table 1 is not among them: it is what the law is
//! judged by afterwards.

use super::family::LawParameters;
use super::rows::{Ended, FitQuestion, FitRow, FitScene, FitTell, Measure, SceneKind};
use super::{FittedLaw, Held};
use crate::dem::{Fidelity, Flow, Test};
use crate::forecast::field::{self, Branch};
use crate::forecast::{laboratory, master};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::catalogue;
use crate::units::from_kn;
use serde::Deserialize;
use std::sync::OnceLock;

const TEXT: &str = include_str!("../../../assets/reference_fit.ron");
const RECORD: &str = include_str!("../../../assets/reference_law.ron");

/// Simulations of all rows at most in a search.
const MOST: usize = 50;

/// A force, kN, and a deflection, m.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct FitPair {
    force: f64,
    deflection: f64,
}

/// Standard deviations by kind of row.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sigmas {
    force: f64,
    deflection: f64,
    stiffness: f64,
    trend_force: f64,
    trend_deflection: f64,
    shape: f64,
}

/// Runs by test.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct RunCounts {
    laboratory: usize,
    anchored: usize,
}

/// A law to start from.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FitStart {
    /// By which the record of the fit names it.
    pub name: String,
    /// What it is.
    pub words: String,
    /// Its parameters.
    pub law: LawParameters,
}

/// The rows and weights as they stand in the file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Weights {
    source: String,
    laboratory: FitPair,
    panels: Vec<f64>,
    stiffness: Vec<(f64, f64)>,
    anchored: FitPair,
    plates: Vec<f64>,
    spacings: Vec<f64>,
    punches: Vec<f64>,
    shape: Vec<f64>,
    sigma: Sigmas,
    hold: f64,
    runs: RunCounts,
    seed: u64,
    starts: Vec<FitStart>,
}

fn weights() -> &'static Weights {
    static WEIGHTS: OnceLock<Weights> = OnceLock::new();
    WEIGHTS.get_or_init(|| {
        // The text is part of the program; a test loads it, so a broken one is never shipped.
        ron::from_str(TEXT).unwrap_or_else(|e| panic!("assets/reference_fit.ron: {e}"))
    })
}

/// Where the figures of the rows were published.
pub(crate) fn source() -> &'static str {
    &weights().source
}

/// The laws that searches start from.
pub fn starts() -> &'static [FitStart] {
    &weights().starts
}

/// The question that the weights ask.
pub(crate) fn question(fidelity: Fidelity, threads: usize) -> FitQuestion {
    let w = weights();
    let net = catalogue::reference().wire.as_ref().map(|wire| wire.net);
    let (mut scenes, mut rows) = (Vec::new(), Vec::new());
    laboratory_rows(w, &mut scenes, &mut rows);
    anchored_rows(w, &mut scenes, &mut rows);
    FitQuestion {
        // The catalogue's reference mesh has wire data; a test holds it.
        net: net.unwrap_or(crate::mesh::laws::bench().net),
        scenes,
        rows,
        seed: w.seed,
        fidelity,
        threads,
    }
}

fn row(label: String, scene: usize, measure: Measure, target: f64, sigma: f64) -> FitRow {
    FitRow { label, scene, measure, over: None, target, sigma }
}

/// Force and deflection of each panel by Eqs. 1-2, and stiffness where it is printed.
fn laboratory_rows(w: &Weights, scenes: &mut Vec<FitScene>, rows: &mut Vec<FitRow>) {
    for panel in &w.panels {
        let scene = scenes.len();
        let words = format!("laboratory, L = {panel}");
        let force = from_kn(w.laboratory.force) * laboratory::force_ratio(*panel);
        let deflection = w.laboratory.deflection * laboratory::deflection_ratio(*panel);
        rows.push(row(format!("{words}: F"), scene, Measure::Force, force, w.sigma.force));
        let measure = Measure::Deflection;
        rows.push(row(format!("{words}: delta"), scene, measure, deflection, w.sigma.deflection));
        if let Some((_, k75)) = w.stiffness.iter().find(|(at, _)| at == panel) {
            let label = format!("{words}: k75, tangent");
            rows.push(row(label, scene, Measure::Stiffness, from_kn(*k75), w.sigma.stiffness));
        }
        let layout = Layout { spacing: *panel, ..REFERENCE };
        let kind = SceneKind::Punch(Test::Laboratory, layout);
        scenes.push(FitScene { words, kind, runs: w.runs.laboratory });
    }
}

/// The reference, its curve, and the ratios of scenes with one size changed.
fn anchored_rows(w: &Weights, scenes: &mut Vec<FitScene>, rows: &mut Vec<FitRow>) {
    let base = scenes.len();
    let anchored = |words: String, layout| FitScene {
        words,
        kind: SceneKind::Punch(Test::Anchored, layout),
        runs: w.runs.anchored,
    };
    scenes.push(anchored("anchored reference".into(), REFERENCE));
    let force = from_kn(w.anchored.force);
    rows.push(row("anchored reference: F".into(), base, Measure::Force, force, w.sigma.force));
    let (label, delta) = ("anchored reference: delta".to_string(), w.anchored.deflection);
    rows.push(row(label, base, Measure::Deflection, delta, w.sigma.deflection));
    for part in &w.shape {
        let label = format!("master curve at {part}");
        rows.push(row(label, base, Measure::Shape(*part), master::force(*part), w.sigma.shape));
    }
    let plates = w.plates.iter().map(|d| (format!("d = {d}"), Layout { plate: *d, ..REFERENCE }));
    let spacings =
        w.spacings.iter().map(|l| (format!("L = {l}"), Layout { spacing: *l, ..REFERENCE }));
    let punches = w.punches.iter().map(|p| (format!("D = {p}"), Layout { punch: *p, ..REFERENCE }));
    for (words, layout) in plates.chain(spacings).chain(punches) {
        let scene = scenes.len();
        let ratio = |of: fn(&Layout, Branch) -> f64| {
            of(&layout, Branch::published(&layout)) / of(&REFERENCE, Branch::published(&REFERENCE))
        };
        let trends = [
            ("F", Measure::Force, ratio(field::force_ratio), w.sigma.trend_force),
            (
                "delta",
                Measure::Deflection,
                ratio(field::deflection_ratio),
                w.sigma.trend_deflection,
            ),
        ];
        for (symbol, measure, target, sigma) in trends {
            let label = format!("{words}: {symbol} over reference");
            rows.push(FitRow { over: Some(base), ..row(label, scene, measure, target, sigma) });
        }
        scenes.push(anchored(format!("anchored, {words}"), layout));
    }
}

/// What the fit gave when the catalogue's wires were made.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordedFit {
    /// The command that made it.
    pub command: String,
    /// Revisions of solver and sampling that it was made with.
    pub revisions: (u32, u32),
    /// What was known of Table 1 when the fit was made.
    pub in_view: String,
    /// Name of the start whose law was kept.
    pub kept: String,
    /// The law found from each start.
    pub found: Vec<RecordedLaw>,
}

/// A law as the file of the record holds it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordedLaw {
    /// Name of the start.
    pub start: String,
    /// Where the search from there ended.
    pub law: LawParameters,
    /// Sum of squares at the start and at the end.
    pub scores: (f64, f64),
    /// How often all rows were simulated.
    pub simulations: usize,
    /// Value of every row, SI.
    pub rows: Vec<(String, f64)>,
}

/// The record behind the catalogue's wires.
pub fn record() -> &'static RecordedFit {
    static RECORDED: OnceLock<RecordedFit> = OnceLock::new();
    RECORDED.get_or_init(|| {
        // As above.
        ron::from_str(RECORD).unwrap_or_else(|e| panic!("assets/reference_law.ron: {e}"))
    })
}

impl RecordedLaw {
    /// Sum of squares of the recorded values; nothing where a row is missing or is not asked for.
    pub fn score(&self) -> Option<f64> {
        let question = question(Fidelity::Standard, 1);
        let asked = question.rows.iter().map(|row| &row.label);
        let same = asked.eq(self.rows.iter().map(|(label, _)| label));
        let values: Vec<f64> = self.rows.iter().map(|(_, value)| *value).collect();
        same.then(|| question.score(&values))
    }

    /// Rows of the first scenes whose words are these, simulated again: label, recorded value, value now.
    pub fn again(&self, scenes: &[&str], threads: usize) -> Vec<(String, f64, f64)> {
        let mut question = question(Fidelity::Standard, threads);
        let wanted: Vec<usize> = (0..question.scenes.len())
            .filter(|k| scenes.contains(&question.scenes[*k].words.as_str()))
            .collect();
        question.rows.retain(|row| row.over.is_none() && wanted.contains(&row.scene));
        for row in &mut question.rows {
            row.scene = wanted.iter().position(|k| *k == row.scene).unwrap_or(0);
        }
        question.scenes = wanted.iter().map(|k| question.scenes[*k].clone()).collect();
        let made = question.values(&self.law, &|_, _| Flow::Continue);
        let values = made.ok().flatten().unwrap_or_default();
        let recorded = |label: &str| self.rows.iter().find(|(at, _)| at == label).map(|r| r.1);
        let rows = question.rows.iter().zip(values);
        rows.filter_map(|(row, now)| Some((row.label.clone(), recorded(&row.label)?, now)))
            .collect()
    }
}

/// A search from one of [`starts`].
///
/// # Errors
/// Why it was ended.
pub(crate) fn search(
    question: &FitQuestion,
    start: &FitStart,
    tell: &FitTell,
) -> Result<Option<FittedLaw>, Ended> {
    let held = Held::near(&start.law, weights().hold);
    question.fit(&start.law, &held, MOST, &mut |law| question.values(law, tell))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::published::published;

    #[test]
    fn no_scene_of_the_fit_is_one_of_table_1_and_no_target_either() {
        let q = question(Fidelity::Quick, 1);
        let layouts = q.scenes.iter().map(|scene| match scene.kind {
            SceneKind::Punch(_, layout) => layout,
            SceneKind::Tensile(..) => panic!("{} is no punch test", scene.words),
        });
        for test in &published().tests {
            let layout = test.layout();
            assert!(layouts.clone().all(|scene| scene != layout), "test {}", test.test);
            let force = from_kn(test.dem.force.value());
            assert!(q.rows.iter().all(|row| row.target != force), "test {}", test.test);
        }
        // Nor does a scene differ from the reference in more than one size, or stand off the centre.
        for l in layouts {
            let changed = [
                l.plate != REFERENCE.plate,
                l.spacing != REFERENCE.spacing,
                l.punch != REFERENCE.punch,
            ];
            assert!(changed.into_iter().filter(|c| *c).count() <= 1 && l.ex == 0.0 && l.ey == 0.0);
        }
    }

    #[test]
    fn the_rows_are_the_papers_figures() {
        let q = question(Fidelity::Quick, 1);
        // Six panels and three stiffnesses; reference, three points of the curve, seven trends.
        assert_eq!((q.scenes.len(), q.rows.len()), (6 + 1 + 7, 15 + 5 + 14));
        let target = |label: &str| q.rows.iter().find(|row| row.label == label).unwrap().target;
        assert_eq!(target("laboratory, L = 3: F"), 73_300.0);
        // By hand: (0.48 x 1.5 + 0.45)/(0.48 + 0.45); (0.03 x 4 - 0.32 + 1.13)/(0.03 - 0.16 + 1.13).
        assert!((target("d = 0.48: F over reference") - 1.17 / 0.93).abs() < 1e-12);
        assert!((target("D = 2: delta over reference") - 0.93).abs() < 1e-12);
        assert_eq!(starts().len(), 3);
        for start in starts() {
            assert_eq!(start.law.wire(q.net, "test".into()).check(), Ok(()), "{}", start.name);
        }
    }

    #[test]
    fn a_row_counts_how_far_a_value_is_off_in_its_own_standard_deviations() {
        let force = row(String::new(), 0, Measure::Force, 100.0, 0.03);
        // By hand: ln 1.03 / 0.03 and (0.5 - 0.46)/0.02.
        assert!((force.residual(103.0) - 0.985_293).abs() < 1e-5);
        let shape = row(String::new(), 0, Measure::Shape(0.5), 0.46, 0.02);
        assert!((shape.residual(0.5) - 2.0).abs() < 1e-12);
    }
}
