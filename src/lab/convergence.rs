//! Error against each numerical knob, with the observed order; the error estimate that a run gives
//! against its true error; and cost against size.
//!
//! Errors are against the reference fidelity at half its speed. An order p says that the curve's error
//! goes with the p-th power of the knob; it is left out where an error is near what is known of the
//! reference.

use super::bench::{Listener, errors, scene};
use crate::dem::fast::{Fast, FastOptions, Path};
use crate::dem::hash::{hash, uniform};
use crate::dem::run::drive;
use crate::dem::{Controls, Fidelity, RunOutcome, Scene, SceneSpec, Stop, Test};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::laws;
use crate::problem::Problem;
use serde::Serialize;

/// One row of a table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ConvergenceRow {
    pub scene: String,
    /// Which knob. `speed`: punch travel per step; `step`: step factor at the same punch speed, so with
    /// the travel per step in proportion; `damping`; `precision` and `unloading`: the shortcuts.
    pub knob: String,
    /// Its value: m per step; over the fidelity's own; part of velocity lost per step; for the
    /// shortcuts 1 with and 0 without.
    pub value: f64,
    /// Error of the force at the first break, %.
    #[serde(rename = "F_error_pct")]
    pub force: f64,
    /// Error of the deflection at the first break, %.
    #[serde(rename = "delta_error_pct")]
    pub deflection: f64,
    /// Error of the curve, %.
    #[serde(rename = "curve_error_pct")]
    pub curve: f64,
    /// Observed order of the curve's error from the row before, where there is one.
    pub order: Option<f64>,
    /// Error estimate of the run itself, %.
    #[serde(rename = "error_estimate_pct")]
    pub estimate: f64,
    /// Largest kinetic over internal energy.
    pub kinetic_over_internal: f64,
}

impl ConvergenceRow {
    /// The worst of the three errors, %.
    fn worst(&self) -> f64 {
        self.force.abs().max(self.deflection.abs()).max(self.curve)
    }
}

/// Error of the curve, %, below which no order is told.
const KNOWN: f64 = 0.08;

/// How well the error estimates of some runs tell their worst true error.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Relation {
    /// Of which runs.
    pub(crate) of: String,
    /// How many.
    pub(crate) runs: usize,
    /// How many have a worst error within their estimate.
    pub(crate) within: usize,
    /// Median of the worst error over the estimate.
    pub(crate) median: f64,
    /// 90 % point of it.
    pub(crate) most: f64,
    /// Rank correlation of estimates and worst errors (Spearman), -1 to 1.
    pub(crate) rank_correlation: f64,
}

impl Relation {
    /// Of pairs of estimate and worst error.
    pub(crate) fn of(of: &str, pairs: &[(f64, f64)]) -> Relation {
        let mut ratios: Vec<f64> = pairs.iter().map(|(e, w)| w / e).collect();
        ratios.sort_by(f64::total_cmp);
        let at = |part: f64| {
            ratios.get((part * (ratios.len().saturating_sub(1)) as f64) as usize).copied()
        };
        let ranks = |value: &dyn Fn(&(f64, f64)) -> f64| -> Vec<f64> {
            let below = |p: &(f64, f64)| {
                let less = pairs.iter().filter(|q| value(q) < value(p)).count();
                let same = pairs.iter().filter(|q| value(q) == value(p)).count();
                less as f64 + 0.5 * (same as f64 - 1.0)
            };
            pairs.iter().map(below).collect()
        };
        let (a, b) = (ranks(&|p| p.0), ranks(&|p| p.1));
        let middle = (pairs.len() as f64 - 1.0) / 2.0;
        let sum = |x: &[f64], y: &[f64]| -> f64 {
            x.iter().zip(y).map(|(x, y)| (x - middle) * (y - middle)).sum()
        };
        let spread = (sum(&a, &a) * sum(&b, &b)).sqrt();
        Relation {
            of: of.to_string(),
            runs: pairs.len(),
            within: pairs.iter().filter(|(e, w)| w <= e).count(),
            median: at(0.5).unwrap_or(0.0),
            most: at(0.9).unwrap_or(0.0),
            rank_correlation: if spread > 0.0 { sum(&a, &b) / spread } else { 0.0 },
        }
    }
}

#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Tables {
    /// Rows, scene by scene and knob by knob.
    pub(crate) rows: Vec<ConvergenceRow>,
    /// Estimates against errors: of the rows of `speed`, and of scenes that nothing was tuned on.
    pub(crate) relations: Vec<Relation>,
    /// Whether it was ended early, so that something is missing.
    pub(crate) part: bool,
}

fn base(fidelity: Fidelity) -> Controls {
    Controls { fidelity, after_break: 0.0, ..Controls::default() }
}

/// The tables of the scenes named; what is done by then where `listener` ends it early.
///
/// # Errors
/// What is wrong with a scene.
pub(crate) fn tables(names: &[&str], listener: Listener) -> Result<Tables, Vec<Problem>> {
    let mut tables = Tables::default();
    for name in names {
        let Some(spec) = scene(name) else { continue };
        tables.part = tables.scene(name, &spec, listener)?.is_none();
        if tables.part {
            return Ok(tables);
        }
    }
    let speeds: Vec<(f64, f64)> =
        tables.rows.iter().filter(|r| r.knob == "speed").map(|r| (r.estimate, r.worst())).collect();
    tables.relations.push(Relation::of("speed rows", &speeds));
    for (test, word) in [(Test::Anchored, "anchored"), (Test::Laboratory, "laboratory")] {
        (listener.tell)(&format!("other {word} scenes"));
        let Some(pairs) = others(test, listener)? else {
            tables.part = true;
            return Ok(tables);
        };
        tables.relations.push(Relation::of(&format!("other {word} scenes"), &pairs));
    }
    Ok(tables)
}

impl Tables {
    fn scene(
        &mut self,
        name: &str,
        spec: &SceneSpec,
        listener: Listener,
    ) -> Result<Option<()>, Vec<Problem>> {
        let tell = |what: &str| (listener.tell)(&format!("scene {name}: {what}"));
        tell("reference");
        let travel = base(Fidelity::Reference).scheme(&Scene::new(spec)?)?.travel;
        let exact = Controls { speed: Some(travel / 2.0), ..base(Fidelity::Reference) };
        let Some(reference) = listener.check(spec, &exact)? else { return Ok(None) };
        let mut push = |knob: &str, value: f64, outcome: &RunOutcome, orders: bool| {
            let Some(e) = errors(outcome, &reference) else { return };
            let curve = 100.0 * e.curve;
            let before = self.rows.last().filter(|r| orders && r.knob == knob && r.scene == name);
            let known = before.filter(|r| r.curve > KNOWN && curve > KNOWN);
            let order = known.map(|r| (r.curve / curve).ln() / (r.value / value).ln());
            self.rows.push(ConvergenceRow {
                scene: name.to_string(),
                knob: knob.to_string(),
                value,
                force: 100.0 * e.force,
                deflection: 100.0 * e.deflection,
                curve,
                order,
                estimate: 100.0 * outcome.quality.error_estimate,
                kinetic_over_internal: outcome.quality.kinetic_over_internal,
            });
        };
        tell("speed, step, damping");
        let own = base(Fidelity::Standard);
        for speed in [4.0e-4, 2.0e-4, 1.0e-4, 5.0e-5, 2.5e-5] {
            let c = Controls { speed: Some(speed), ..own.clone() };
            let Some(outcome) = listener.check(spec, &c)? else { return Ok(None) };
            push("speed", speed, &outcome, true);
        }
        for step in [1.0, 0.8, 0.6, 0.4] {
            let speed = Some(2.0e-4 * step);
            // The same decay in the same time.
            let damping = Some(0.002 * step);
            let c = Controls { step_factor: step, speed, damping, ..own.clone() };
            let Some(outcome) = listener.check(spec, &c)? else { return Ok(None) };
            push("step", step, &outcome, true);
        }
        for damping in [0.016, 0.008, 0.004, 0.002, 0.001] {
            let c = Controls { damping: Some(damping), speed: Some(1.0e-4), ..own.clone() };
            let Some(outcome) = listener.check(spec, &c)? else { return Ok(None) };
            push("damping", damping, &outcome, true);
        }
        tell("precision and unloading");
        for (knob, value, double, true_unloading, travel) in [
            ("precision", 1.0, false, false, 2.5e-5),
            ("precision", 0.0, true, false, 2.5e-5),
            ("unloading", 1.0, true, false, 2.5e-5),
            ("unloading", 0.0, true, true, 1.0e-5),
        ] {
            let run = with(spec, double, true_unloading, travel, listener)?;
            let Some(outcome) = run else { return Ok(None) };
            push(knob, value, &outcome, false);
        }
        Ok(Some(()))
    }
}

/// A run in this precision and with this unloading at this speed; nothing where it was ended early.
fn with(
    spec: &SceneSpec,
    double: bool,
    true_unloading: bool,
    travel: f64,
    listener: Listener,
) -> Result<Option<RunOutcome>, Vec<Problem>> {
    let scene = Scene::new(spec)?;
    let fidelity = if true_unloading { Fidelity::Reference } else { Fidelity::Standard };
    let controls = Controls { speed: Some(travel), ..base(fidelity) };
    let scheme = controls.scheme(&scene)?;
    let options = FastOptions {
        fitted: scheme.fitted,
        factors: scheme.factors,
        damping: scheme.damping,
        true_unloading,
        path: Path::best(),
    };
    let mut go = |_| (listener.ask)();
    let outcome = if double {
        drive(&scene, &mut Fast::<f64>::new(&scene, options), &scheme, &controls, &mut go)
    } else {
        drive(&scene, &mut Fast::<f32>::new(&scene, options), &scheme, &controls, &mut go)
    };
    Ok((outcome.stop != Stop::Cancelled).then_some(outcome))
}

/// Other scenes: how many of a test.
const OTHERS: usize = 16;

/// Estimate and worst error, %, of quick and standard runs of scenes that nothing was tuned on, against
/// fine ones: reference law, any alignment, panels of 1.8 to 4 m, punches of 0.5 to 1.2 m.
fn others(test: Test, listener: Listener) -> Result<Option<Vec<(f64, f64)>>, Vec<Problem>> {
    let mut pairs = Vec::new();
    for k in 0..OTHERS {
        let seed = hash(77, k as u64);
        let part = |n: u64, low: f64, high: f64| low + (high - low) * uniform(seed, u64::MAX - n);
        let phase = [part(0, 0.0, 1.0), part(1, 0.0, 1.0)];
        let spacing = part(2, 1.8, 4.0);
        let punch = part(3, 0.5, (0.6 * spacing - 0.4).min(1.2));
        let (ex, ey) = (part(4, -0.1, 0.1) * spacing, part(5, -0.1, 0.1) * spacing);
        let layout = Layout { plate: part(6, 0.2, 0.45), spacing, punch, ex, ey, ..REFERENCE };
        let spec = SceneSpec { phase, seed, ..SceneSpec::plain(layout, test, laws::reference()) };
        let Some(fine) = listener.check(&spec, &base(Fidelity::Fine))? else { return Ok(None) };
        for fidelity in [Fidelity::Quick, Fidelity::Standard] {
            let Some(run) = listener.check(&spec, &base(fidelity))? else { return Ok(None) };
            if let Some(e) = errors(&run, &fine) {
                let worst = e.force.abs().max(e.deflection.abs()).max(e.curve);
                pairs.push((100.0 * run.quality.error_estimate, 100.0 * worst));
            }
        }
    }
    Ok(Some(pairs))
}

/// Cost of one size.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SizeRow {
    /// `fixed`: punch of 1 m and plates of 0.32 m whatever the panel; `in proportion`: L/3 and 0.107 L.
    pub(crate) punch: String,
    /// Side of the panel, m.
    #[serde(rename = "L")]
    pub(crate) spacing: f64,
    pub(crate) nodes: usize,
    /// Steps to the first break.
    pub(crate) steps: usize,
    /// Processor time to the first break, set-up included, best of three, ms.
    pub(crate) wall_ms: f64,
    /// Time of a node's step, ns.
    pub(crate) ns_per_node_step: f64,
}

/// Cost against size.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Sizes {
    pub(crate) rows: Vec<SizeRow>,
    /// Fitted exponents of nodes of the processor time, punch fixed and in proportion.
    pub(crate) exponents: Vec<f64>,
    /// Whether it was ended early, so that something is missing.
    pub(crate) part: bool,
}

/// Panels of the comparison, m.
pub(crate) const SIZES: [f64; 6] = [2.0, 3.0, 4.0, 6.0, 8.0, 12.0];

/// Cost of anchored scenes of the bench law against their size, at the standard fidelity.
///
/// # Errors
/// What is wrong with a scene.
pub(crate) fn sizes(listener: Listener) -> Result<Sizes, Vec<Problem>> {
    let mut sizes = Sizes::default();
    for fixed in [true, false] {
        let punch = if fixed { "fixed" } else { "in proportion" };
        let mut points = Vec::new();
        for spacing in SIZES {
            (listener.tell)(&format!("L = {spacing} m, punch {punch}"));
            let factor = if fixed { 1.0 } else { spacing / REFERENCE.spacing };
            let layout = Layout {
                spacing,
                punch: REFERENCE.punch * factor,
                plate: REFERENCE.plate * factor,
                ..REFERENCE
            };
            let (test, wire) = (Test::Anchored, laws::bench());
            let spec = SceneSpec { seed: 1, ..SceneSpec::plain(layout, test, wire) };
            let Some((run, time)) = listener.timed(&spec, &base(Fidelity::Standard), 3)? else {
                sizes.part = true;
                return Ok(sizes);
            };
            let (nodes, steps) = (run.cost.nodes, run.cost.steps_to_break);
            points.push(((nodes as f64).ln(), time.ln()));
            sizes.rows.push(SizeRow {
                punch: punch.into(),
                spacing,
                nodes,
                steps,
                wall_ms: 1.0e3 * time,
                ns_per_node_step: 1.0e9 * time / (nodes * steps.max(1)) as f64,
            });
        }
        sizes.exponents.push(slope(&points));
    }
    Ok(sizes)
}

/// Least-squares slope.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let x = points.iter().map(|p| p.0).sum::<f64>() / n;
    let y = points.iter().map(|p| p.1).sum::<f64>() / n;
    let top: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let bottom: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    top / bottom
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relation_and_slope_of_known_numbers() {
        let r = Relation::of("x", &[(1.0, 0.5), (2.0, 1.0), (3.0, 4.0), (4.0, 3.0)]);
        // Ranks 0 1 2 3 and 0 1 3 2: 1 - 6 (1 + 1) / (4 (16 - 1)) = 0.8.
        assert!((r.rank_correlation - 0.8).abs() < 1e-12);
        assert_eq!((r.runs, r.within), (4, 3));
        assert_eq!((r.median, Relation::of("x", &[]).most), (0.5, 0.0));
        let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)];
        assert!((slope(&points) - 2.0).abs() < 1e-12);
    }
}
