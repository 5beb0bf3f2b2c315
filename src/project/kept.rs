//! The result of a check as a project keeps it: one line of a layout, in kN, m and J like the rest of
//! the file. Written by the program for the program; whoever takes the line out loses nothing but the
//! result.

use super::error::Found;
use super::inline_mesh::ron_options;
use super::text::Node;
use crate::curve::{Curve, Point};
use crate::dem::Fidelity;
use crate::dem::outcome::Quality;
use crate::fingerprint::Fingerprint;
use crate::problem::Problem;
use crate::study::ensemble::{MOST, Spread};
use crate::study::result::{CheckResult, FirstBreak, Revisions, Wanted, mean, rounded};
use crate::units::{from_kn, to_kn};
use serde::{Deserialize, Serialize};

/// Most runs whose first breaks a file may hold.
const MOST_BREAKS: usize = 10_000;

/// The line's fields.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename = "Check", deny_unknown_fields)]
struct Kept {
    /// Revisions of solver and sampling, and fingerprint of all inputs.
    by: String,
    inputs: String,
    fidelity: Fidelity,
    /// Runs asked for, 0 for as many as needed.
    asked: usize,
    seed: u64,
    runs: usize,
    slipped: usize,
    /// Mean, standard deviation, standard error, 5 % and 95 % points; kN.
    #[serde(rename = "F")]
    force: [f64; 5],
    /// The same in m.
    delta: [f64; 5],
    /// Mean peak, kN and m.
    peak: [f64; 2],
    /// kN/m.
    k75: f64,
    /// J.
    energy: f64,
    /// Mean first break, kN and m; nothing if no run broke.
    end: Option<[f64; 2]>,
    /// The mean curve, m and kN, and its band, kN.
    curve_delta: Vec<f64>,
    #[serde(rename = "curve_F")]
    curve_force: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
    /// First breaks: kN, m, place x and y in m, 1 for a double twist.
    breaks: Vec<[f64; 5]>,
    /// Kinetic over internal energy, energy balance, support over punch, utilisation at the last look,
    /// shaking, error estimate.
    quality: [f64; 6],
    warnings: Vec<String>,
}

/// A force as the file holds it.
fn kn(newton: f64) -> f64 {
    rounded(to_kn(newton))
}

fn spread(s: &Spread, unit: fn(f64) -> f64) -> [f64; 5] {
    [s.mean, s.deviation, s.error, s.band[0], s.band[1]].map(unit)
}

fn spread_back(v: [f64; 5], unit: fn(f64) -> f64) -> Spread {
    let [mean, deviation, error, low, high] = v.map(unit);
    Spread { mean, deviation, error, band: [low, high] }
}

/// A result as RON on one line.
pub(crate) fn write(v: &CheckResult) -> String {
    let q = &v.quality;
    let kept = Kept {
        by: v.by.to_string(),
        inputs: v.inputs.to_string(),
        fidelity: v.wanted.fidelity,
        asked: v.wanted.runs.unwrap_or(0),
        seed: v.wanted.seed,
        runs: v.runs,
        slipped: v.slipped,
        force: spread(&v.force, kn),
        delta: spread(&v.deflection, rounded),
        peak: [kn(v.peak.force), rounded(v.peak.deflection)],
        k75: kn(v.k75),
        energy: rounded(v.energy),
        end: v.curve.failure.map(|p| [kn(p.force), rounded(p.deflection)]),
        curve_delta: v.curve.deflection.iter().copied().map(rounded).collect(),
        curve_force: v.curve.force.iter().copied().map(kn).collect(),
        low: v.band[0].iter().copied().map(kn).collect(),
        high: v.band[1].iter().copied().map(kn).collect(),
        breaks: v
            .breaks
            .iter()
            .map(|b| {
                let twist = if b.twist { 1.0 } else { 0.0 };
                let [x, y] = b.place.map(rounded);
                [kn(b.at.force), rounded(b.at.deflection), x, y, twist]
            })
            .collect(),
        quality: [
            q.kinetic_over_internal,
            q.energy_balance,
            q.support_over_punch,
            q.last_utilisation,
            q.shaking,
            q.error_estimate,
        ]
        .map(rounded),
        warnings: v.warnings.clone(),
    };
    let text = ron_options().to_string(&kept).unwrap_or_default();
    // The writer names the extension that is on anyway.
    text.strip_prefix("#![enable(implicit_some)]").map_or(text.clone(), |t| t.trim().to_string())
}

/// Reads the result of a node.
///
/// # Errors
/// What is wrong with it; taking the whole field out of the file always helps.
pub(crate) fn read(text: &str, node: &Node, path: &str) -> Result<CheckResult, Found> {
    let wrong = |said: String| {
        let problem = Problem::new(path, said)
            .advice("take this field out of the file; c in the program makes the check again");
        Found::new(node.span.start, problem)
    };
    let kept: Kept = ron_options()
        .from_str(node.span.of(text))
        .map_err(|e| wrong(format!("this kept check cannot be read: {}", e.code)))?;
    back(kept).map_err(|said| wrong(format!("this kept check makes no sense: {said}")))
}

fn back(k: Kept) -> Result<CheckResult, &'static str> {
    let inputs = u64::from_str_radix(&k.inputs, 16).map_err(|_| "inputs is no fingerprint")?;
    let lists = [&k.curve_delta, &k.curve_force, &k.low, &k.high];
    let numbers = lists.iter().flat_map(|list| list.iter());
    let figures = k.force.iter().chain(&k.delta).chain(&k.peak).chain(&k.quality);
    let breaks = k.breaks.iter().flatten();
    let all = numbers.chain(figures).chain(breaks).chain(k.end.iter().flatten());
    if !all.chain([&k.k75, &k.energy]).all(|v| v.is_finite()) {
        return Err("a value is no number");
    }
    if k.curve_delta.len() > mean::POINTS {
        return Err("the curve has more than 60 points");
    }
    if k.curve_force.len() != k.curve_delta.len() {
        return Err("curve_delta and curve_F have different lengths");
    }
    if [&k.low, &k.high].iter().any(|l| !l.is_empty() && l.len() != k.curve_delta.len()) {
        return Err("low or high does not fit the curve");
    }
    if !k.curve_delta.windows(2).all(|w| w[0] < w[1]) {
        return Err("curve_delta must rise");
    }
    if k.breaks.len() > MOST_BREAKS || k.asked > MOST_BREAKS.max(MOST) {
        return Err("it has too many runs");
    }
    let newtons = |list: Vec<f64>| list.into_iter().map(from_kn).collect::<Vec<f64>>();
    let point = |[force, deflection]: [f64; 2]| Point { deflection, force: from_kn(force) };
    let [
        kinetic_over_internal,
        energy_balance,
        support_over_punch,
        last_utilisation,
        shaking,
        error,
    ] = k.quality;
    Ok(CheckResult {
        wanted: Wanted {
            fidelity: k.fidelity,
            runs: (k.asked > 0).then_some(k.asked),
            seed: k.seed,
        },
        inputs: Fingerprint(inputs),
        by: Revisions::from_text(&k.by),
        runs: k.runs,
        slipped: k.slipped,
        force: spread_back(k.force, from_kn),
        deflection: spread_back(k.delta, |v| v),
        peak: point(k.peak),
        k75: from_kn(k.k75),
        energy: k.energy,
        curve: Curve {
            deflection: k.curve_delta,
            force: newtons(k.curve_force),
            failure: k.end.map(point),
        },
        band: [newtons(k.low), newtons(k.high)],
        breaks: k
            .breaks
            .into_iter()
            .map(|[force, deflection, x, y, twist]| FirstBreak {
                at: point([force, deflection]),
                place: [x, y],
                twist: twist != 0.0,
            })
            .collect(),
        quality: Quality {
            kinetic_over_internal,
            energy_balance,
            support_over_punch,
            last_utilisation,
            shaking,
            error_estimate: error,
        },
        warnings: k.warnings,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::Flow;
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::catalogue;
    use crate::project::text::parser::parse;
    use crate::study::result::make::make;

    fn read_back(text: &str) -> Result<CheckResult, Found> {
        let tree = parse(text).unwrap();
        read(text, tree.root.unwrapped(), "layouts[0].check")
    }

    #[test]
    fn a_result_comes_back_to_the_last_bit_and_is_small() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Fidelity::Quick, runs: Some(2), seed: 3 };
        let made = make(&layout, &catalogue::reference(), &wanted, 1, &|_| Flow::Continue).unwrap();
        let text = write(&made.result);
        assert!(!text.contains('\n') && text.len() < 3_000, "{} bytes: {text}", text.len());
        assert_eq!(read_back(&text).unwrap(), made.result);
    }

    #[test]
    fn a_damaged_one_is_refused_with_the_way_out() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Fidelity::Quick, runs: Some(1), seed: 3 };
        let mesh = catalogue::reference();
        let made = make(&layout, &mesh, &wanted, 1, &|_| Flow::Continue).unwrap();
        let text = write(&made.result);
        for (from, to) in [
            ("curve_delta:[", "curve_delta:[9.0,"),
            ("seed:3", "seed:-3"),
            ("inputs:\"", "inputs:\"x"),
            ("runs:1", "laps:1"),
        ] {
            let bad = text.replacen(from, to, 1);
            assert_ne!(bad, text, "{from}");
            let found = read_back(&bad).unwrap_err();
            let said = found.problem.to_string();
            assert!(said.contains("take this field out"), "{said}");
            assert!(said.contains("layouts[0].check"), "{said}");
        }
    }
}
