//! The result of a check as a project keeps it: one line of a layout, in kN, m and J like the rest of
//! the file. Written by the program for the program; whoever takes the line out loses nothing but the
//! result.

use super::error::Found;
use super::write::{self, Unwritable};
use crate::curve::{Curve, Point};
use crate::dem::outcome::Quality;
use crate::fingerprint::Fingerprint;
use crate::problem::Problem;
use crate::study::ensemble::{MOST, Spread};
use crate::study::exactness::Exactness;
use crate::study::remark::CheckFlag;
use crate::study::result::{
    CheckResult, FieldFigures, FirstBreak, Revisions, Sampled, Wanted, mean, rounded,
};
use crate::units::{from_kn, to_kn};
use serde::{Deserialize, Serialize};

/// Most runs whose first breaks a file may hold.
const MOST_BREAKS: usize = 10_000;

/// What always helps with a kept check that is wrong.
const WAY_OUT: &str = "take this field out of the file; c in the program makes the check again";

/// The line's fields.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Check", deny_unknown_fields)]
pub(super) struct Kept {
    /// Revisions of solver and sampling, and fingerprint of all inputs.
    by: String,
    inputs: String,
    fidelity: Exactness,
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
    /// How the blocks stood; left out where the same block stands in every cell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    arrangement: Option<String>,
    /// The worst anchor of each run with a break, kN out of the plane and in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    anchors: Vec<[f64; 2]>,
    /// Where the runs stood and points of the distribution, see [`Sampled`]; left out where there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    strata: Option<Vec<Vec<f64>>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    fractiles: Option<Vec<Vec<f64>>>,
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

/// The result of a layout's check as RON on one line.
///
/// # Errors
/// One that could not be read back is not written; `layout` is the layout's name.
pub(super) fn write(v: &CheckResult, layout: &str) -> Result<String, Unwritable> {
    let kept = Kept::new(v);
    let why = match kept.sound() {
        Ok(()) => match write::compact(&kept) {
            Ok(text) => return Ok(text),
            Err(error) => error.to_string(),
        },
        Err(why) => why.to_string(),
    };
    Err(Unwritable { what: format!("the check of layout {layout:?}"), why })
}

/// A problem inside a kept check with what always helps; any other as it is.
pub(super) fn with_a_way_out(mut found: Found) -> Found {
    let inside = |field: &str| {
        let rest = field.strip_prefix("layouts[")?.split_once("].check")?.1;
        Some(rest.is_empty() || rest.starts_with(['.', '[']))
    };
    if inside(&found.problem.field) == Some(true) {
        found.problem.message =
            format!("this kept check cannot be read: {}", found.problem.message);
        found.problem.advice = WAY_OUT.to_string();
    }
    found
}

impl Kept {
    fn new(v: &CheckResult) -> Kept {
        let q = &v.quality;
        Kept {
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
            warnings: v.flags.iter().map(|flag| flag.code().to_string()).collect(),
            arrangement: v.field.arrangement.clone(),
            anchors: v.field.anchors.iter().map(|parts| parts.map(kn)).collect(),
            strata: v.sampled.strata.clone(),
            fractiles: v.sampled.fractiles.clone(),
        }
    }

    /// Whether the figures make sense together.
    fn sound(&self) -> Result<(), &'static str> {
        let lists = [&self.curve_delta, &self.curve_force, &self.low, &self.high];
        let numbers = lists.iter().flat_map(|list| list.iter());
        let later = self.strata.iter().chain(&self.fractiles).flatten().flatten();
        let figures = self.force.iter().chain(&self.delta).chain(&self.peak).chain(&self.quality);
        let breaks = self.breaks.iter().flatten().chain(self.anchors.iter().flatten());
        let all =
            numbers.chain(later).chain(figures).chain(breaks).chain(self.end.iter().flatten());
        if !all.chain([&self.k75, &self.energy]).all(|v| v.is_finite()) {
            return Err("a value is no number");
        }
        if self.curve_delta.len() > mean::POINTS {
            return Err("the curve has more than 60 points");
        }
        if self.curve_force.len() != self.curve_delta.len() {
            return Err("curve_delta and curve_F have different lengths");
        }
        let fits = |l: &Vec<f64>| l.is_empty() || l.len() == self.curve_delta.len();
        if !fits(&self.low) || !fits(&self.high) {
            return Err("low or high does not fit the curve");
        }
        if !self.curve_delta.windows(2).all(|w| w[0] < w[1]) {
            return Err("curve_delta must rise");
        }
        if self.breaks.len().max(self.anchors.len()) > MOST_BREAKS
            || self.asked > MOST_BREAKS.max(MOST)
        {
            return Err("it has too many runs");
        }
        Ok(())
    }

    /// The result.
    ///
    /// # Errors
    /// Why it makes no sense.
    pub(super) fn result(self) -> Result<CheckResult, Problem> {
        let wrong = |why: &str| {
            Problem::new("", format!("this kept check makes no sense: {why}")).advice(WAY_OUT)
        };
        self.sound().map_err(wrong)?;
        let inputs =
            u64::from_str_radix(&self.inputs, 16).map_err(|_| wrong("inputs is no fingerprint"))?;
        Ok(self.into_result(Fingerprint(inputs)))
    }

    fn into_result(self, inputs: Fingerprint) -> CheckResult {
        let k = self;
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
        CheckResult {
            wanted: Wanted {
                fidelity: k.fidelity,
                runs: (k.asked > 0).then_some(k.asked),
                seed: k.seed,
            },
            inputs,
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
            flags: k.warnings.iter().map(|code| CheckFlag::from_code(code)).collect(),
            field: FieldFigures {
                arrangement: k.arrangement,
                anchors: k.anchors.into_iter().map(|parts| parts.map(from_kn)).collect(),
            },
            sampled: Sampled { strata: k.strata, fractiles: k.fractiles },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::Flow;
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::catalogue;
    use crate::project::read;
    use crate::project::text::parser::parse;
    use crate::study::result::make::make;

    fn read_back(text: &str) -> Result<CheckResult, Vec<Problem>> {
        let tree = parse(text).unwrap();
        let kept = read::values::<Kept>(text, &tree.root, "layouts[0].check").map_err(|found| {
            found.into_iter().map(|f| *with_a_way_out(f).problem).collect::<Vec<_>>()
        })?;
        kept.result().map_err(|problem| vec![problem.under("layouts[0].check")])
    }

    #[test]
    fn a_result_comes_back_to_the_last_bit_and_is_small() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(2), seed: 3 };
        let made = make(&layout, &catalogue::reference(), &wanted, 1, &|_| Flow::Continue).unwrap();
        let text = write(&made.result, "a").unwrap();
        assert!(!text.contains('\n') && text.len() < 3_000, "{} bytes: {text}", text.len());
        assert_eq!(read_back(&text).unwrap(), made.result);
    }

    #[test]
    fn a_damaged_one_is_refused_with_the_way_out() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(1), seed: 3 };
        let mesh = catalogue::reference();
        let made = make(&layout, &mesh, &wanted, 1, &|_| Flow::Continue).unwrap();
        let text = write(&made.result, "a").unwrap();
        for (from, to) in [
            ("curve_delta:[", "curve_delta:[9.0,"),
            ("seed:3", "seed:-3"),
            ("inputs:\"", "inputs:\"x"),
            ("runs:1", "laps:1"),
        ] {
            let bad = text.replacen(from, to, 1);
            assert_ne!(bad, text, "{from}");
            for problem in read_back(&bad).unwrap_err() {
                let said = problem.to_string();
                assert!(said.contains("take this field out"), "{said}");
                assert!(said.contains("layouts[0].check"), "{said}");
            }
        }
    }

    #[test]
    fn what_may_be_left_out_is_kept_as_it_is() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(1), seed: u64::MAX };
        let mesh = catalogue::reference();
        let mut made = make(&layout, &mesh, &wanted, 1, &|_| Flow::Continue).unwrap();
        made.result.sampled = Sampled::default();
        let text = write(&made.result, "a").unwrap();
        assert!(!text.contains("arrangement"), "{text}");
        let later = "arrangement: \"mirrored\", strata: [[0.25, 31.5], [0.75, 33.0]], \
                     fractiles: [[0.05, 28.1, 0.61]])";
        let text = format!("{},{later}", text.strip_suffix(')').unwrap());
        let result = read_back(&text).unwrap();
        assert_eq!(result.field.arrangement.as_deref(), Some("mirrored"));
        assert_eq!(result.sampled.strata, Some(vec![vec![0.25, 31.5], vec![0.75, 33.0]]));
        let again = write(&result, "a").unwrap();
        assert_eq!(read_back(&again).unwrap(), result);
        assert!(again.ends_with("fractiles:[[0.05,28.1,0.61]])"), "{again}");
    }

    #[test]
    fn a_result_that_could_not_be_read_back_is_not_written() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(1), seed: 3 };
        let mesh = catalogue::reference();
        let mut result = make(&layout, &mesh, &wanted, 1, &|_| Flow::Continue).unwrap().result;
        result.curve.deflection[1] = result.curve.deflection[0];
        let error = write(&result, "bench 1").unwrap_err().to_string();
        let due = "the check of layout \"bench 1\" cannot be written: curve_delta must rise";
        assert_eq!(error, due);
    }
}
