//! Which laws fit what is told of a mesh: an ensemble of them, what the data hold and what the prior holds, and
//! the range of the anchored reference.
//!
//! From each start the best law is searched. Then laws are drawn from the prior about the start, each with an
//! error of its own on every row of the data, and each is led to its data by steps of Gauss and Newton that
//! stay as near to where it was drawn as the data let (randomised maximum likelihood): what no row feels keeps
//! the prior's spread, also where a valley is bent and no normal distribution about its bottom would follow it.
//! Laws that do not come to their data are left out; the starts weigh by how well the best law of each fits.

use super::data::{FirstBond, MeshData, prior};
use super::family::{COUNT, LawParameters};
use super::levenberg::{inverse, learn, normal, solve};
use super::reference::starts;
use super::rows::{Ended, FitScene, FitTell, Made, SceneKind};
use super::{FitQuestion, FittedLaw, Held, HeldFigure};
use crate::dem::hash::{hash, uniform};
use crate::dem::{Fidelity, Test};
use crate::layout::REFERENCE;

/// The starts, by their names among those of the reference fit, and in a few words.
const STARTS: [&str; 2] = ["weak twist", "strong twist and wire"];
pub(crate) const START_WORDS: [&str; 2] = ["weak twist", "strong twist"];
/// Laws drawn from each start, the best one aside.
const DRAWS: usize = 16;
/// Simulations that each may take on its way.
const STEPS: usize = 4;
/// Largest change of a parameter, as a logarithm, below which a law has arrived.
const ARRIVED: f64 = 0.02;
/// Largest change of a parameter in one step.
const STRIDE: f64 = 0.5;
/// Simulations of the search from a start: with so few rows its end need not be sharp.
const SEARCH: usize = 24;
/// Simulations of all rows from one start, about.
pub(crate) const SIMULATIONS: usize = SEARCH + DRAWS * 3;
/// Runs of the anchored reference under each law.
const ANCHORED_RUNS: usize = 4;

/// How the laws are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct IdentifyOptions {
    /// Seed of alignments, slack and draws.
    pub(crate) seed: u64,
    /// How exactly each run is computed.
    pub(crate) fidelity: Fidelity,
    /// Threads, at least 1; the result does not depend on them.
    pub(crate) threads: usize,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct EnsembleLaw {
    /// Number of the start whose valley it lies in.
    pub(crate) start: usize,
    pub(crate) law: LawParameters,
    /// Sum of squares of the data's rows.
    pub(crate) score: f64,
    /// Its weight; all add up to 1.
    pub(crate) weight: f64,
    /// Part of the runs of the first punch test in which a twist breaks first.
    pub(crate) twists_first: f64,
    /// Force, N, and deflection, m, of the anchored reference.
    pub(crate) anchored: [f64; 2],
}

/// What the data say of a mesh's law.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Identified {
    /// The question that the data asked.
    pub(crate) question: FitQuestion,
    /// The best law of each start that can be run, with the start's number.
    pub(crate) fits: Vec<(usize, FittedLaw)>,
    /// The ensemble; the best law first.
    pub(crate) laws: Vec<EnsembleLaw>,
    /// Value of every row under the best law.
    pub(crate) values: Vec<f64>,
    /// Part of each parameter's precision that comes from the data, 0 to 1; the prior holds the rest.
    pub(crate) shares: [f64; COUNT],
    /// 5, 50 and 95 % of each parameter.
    pub(crate) ranges: [[f64; 3]; COUNT],
    /// 5, 50 and 95 % of the anchored reference's force, N, and deflection, m.
    pub(crate) anchored: [[f64; 3]; 2],
}

impl Identified {
    /// Among the laws that fit about as well as the best one, that in the middle of the ensemble by the force of
    /// the anchored reference: the one to stand for all of them.
    pub(crate) fn middle(&self) -> &EnsembleLaw {
        let [_, middle, _] = self.anchored[0];
        let best = &self.laws[0];
        let off = |law: &EnsembleLaw| libm::log(law.anchored[0] / middle).abs();
        let near =
            self.laws.iter().filter(|law| law.score <= best.score + self.values.len() as f64);
        near.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(best)
    }
}

/// Finds the laws that fit. Nothing where no start can be run or none agrees with the bond that breaks first.
///
/// # Errors
/// Why it was ended.
pub(crate) fn identify(
    data: &MeshData,
    options: &IdentifyOptions,
    tell: &FitTell,
) -> Result<Option<Identified>, Ended> {
    let question = data.question(options.seed, options.fidelity, options.threads);
    let mut with_field = question.clone();
    with_field.scenes.push(FitScene {
        words: "anchored reference".into(),
        kind: SceneKind::Punch(Test::Anchored, REFERENCE),
        runs: ANCHORED_RUNS,
    });
    let (mut fits, mut drawn) = (Vec::new(), Vec::new());
    for (number, name) in STARTS.iter().enumerate() {
        let Some(start) = starts().iter().find(|s| s.name == *name).map(|s| &s.law) else {
            continue;
        };
        let held = prior(start);
        let Some(fit) = question.fit(start, &held, SEARCH, tell)? else { continue };
        let from = Valley { number, fit: &fit, held: &held, rows: question.rows.len() };
        drawn.extend(from.laws(&question, &with_field, tell)?);
        fits.push((number, fit));
    }
    if let Some(first) = data.first {
        drawn.retain(|(law, _)| (law.twists_first > 0.5) == (first == FirstBond::Twist));
    }
    let laws = weighed(drawn);
    let Some(best) = laws.first() else { return Ok(None) };
    let Some((_, fit)) = fits.iter().find(|(number, _)| *number == best.start) else {
        return Ok(None);
    };
    let values = if fit.law == best.law {
        fit.values.clone()
    } else {
        question.values(&best.law, tell)?.unwrap_or_default()
    };
    let shares = shares(fit, question.rows.len());
    let ranges = std::array::from_fn(|k| quantiles(&laws, &|law| law.law.values()[k]));
    let anchored = [0, 1].map(|k| quantiles(&laws, &|law| law.anchored[k]));
    Ok(Some(Identified { question, fits, laws, values, shares, ranges, anchored }))
}

/// A start with its best law.
struct Valley<'a> {
    number: usize,
    fit: &'a FittedLaw,
    held: &'a [Held],
    /// Rows of the data; those of the prior stand behind them in the Jacobian.
    rows: usize,
}

impl Valley<'_> {
    /// The best law and the laws drawn, each with the logarithm of its weight.
    fn laws(
        &self,
        question: &FitQuestion,
        with_field: &FitQuestion,
        tell: &FitTell,
    ) -> Result<Vec<(EnsembleLaw, f64)>, Ended> {
        let Some(covariance) = inverse(&normal(&self.fit.jacobian[self.rows..], COUNT)) else {
            return Ok(Vec::new());
        };
        // The starts are as likely as each other before any data; the score of the best law is what tells.
        let weight = -0.5 * (self.fit.score + self.fit.held);
        let mut all = Vec::new();
        for draw in 0..=DRAWS {
            let law = if draw == 0 {
                self.fit.law
            } else {
                let counter = self.number * 1000 + draw;
                let Some(law) = self.drawn(question, &covariance, counter, tell)? else { continue };
                law
            };
            let Some(made) = with_field.made(&law, tell)? else { continue };
            let Some(values) = with_field.read(&law, &made) else { continue };
            let score = question.score(&values);
            let anchored = match made.last() {
                Some(Made::Punched(e)) => [e.force.mean, e.deflection.mean],
                _ => [f64::NAN; 2],
            };
            // Errors of the data's own size add up to the number of rows; far above it is elsewhere.
            let arrived = score <= self.fit.score + 2.0 * self.rows as f64 + 4.0;
            if anchored[0] > 0.0 && anchored[1] > 0.0 && (arrived || draw == 0) {
                let twists_first = made.first().map_or(0.0, Made::twists_first);
                let start = self.number;
                let law = EnsembleLaw { start, law, score, weight: 0.0, twists_first, anchored };
                all.push((law, weight));
            }
        }
        Ok(all)
    }

    /// A law of the prior, led to data with errors of its own. Nothing where it cannot be run.
    fn drawn(
        &self,
        question: &FitQuestion,
        covariance: &[Vec<f64>],
        counter: usize,
        tell: &FitTell,
    ) -> Result<Option<LawParameters>, Ended> {
        let gauss = |k: usize| gauss(question.seed, counter * 100 + k);
        let before = prior_draw(&self.fit.start, self.held, &gauss);
        let errors: Vec<f64> = (0..self.rows).map(|k| gauss(COUNT + k)).collect();
        let mut jacobian = self.fit.jacobian[..self.rows].to_vec();
        let mut at = self.fit.law.logarithms();
        let mut residuals = with_errors(question, &self.fit.values, &errors);
        for _ in 0..STEPS {
            let Some(step) = towards(&before, &at, &residuals, &jacobian, covariance) else {
                return Ok(None);
            };
            at.iter_mut().zip(&step).for_each(|(at, step)| *at += step);
            if step.iter().all(|s| s.abs() < ARRIVED) {
                break;
            }
            let law = LawParameters::of_logarithms(&at);
            let Some(values) = question.values(&law, tell)? else { return Ok(None) };
            let made = with_errors(question, &values, &errors);
            learn(&mut jacobian, &residuals, &step, &made);
            residuals = made;
        }
        Ok(Some(LawParameters::of_logarithms(&at).rounded()))
    }
}

fn with_errors(question: &FitQuestion, values: &[f64], errors: &[f64]) -> Vec<f64> {
    question.residuals(values).iter().zip(errors).map(|(r, e)| r - e).collect()
}

/// A law of the prior, in logarithms. The strength of the wire decides its stress factor once the curve's
/// other factors are drawn.
fn prior_draw(start: &LawParameters, held: &[Held], gauss: &dyn Fn(usize) -> f64) -> Vec<f64> {
    let mut at = start.values();
    let mut strength = None;
    for (k, held) in held.iter().enumerate() {
        let value = held.at * (held.sigma * gauss(k)).exp();
        match held.what {
            HeldFigure::Parameter(k) => at[k] = value,
            HeldFigure::WireStrength => strength = Some(value),
        }
    }
    if let Some(strength) = strength {
        at[0] =
            strength / LawParameters::of([1.0, at[1], at[2], at[3], at[4], at[5]]).wire_strength();
    }
    at.map(f64::ln).to_vec()
}

/// The step from `at` to the place nearest to `before` that the rows want, both in their own measure:
/// before - at - C J' (J C J' + 1)^-1 (r + J (before - at)).
fn towards(
    before: &[f64],
    at: &[f64],
    residuals: &[f64],
    jacobian: &[Vec<f64>],
    covariance: &[Vec<f64>],
) -> Option<Vec<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let back: Vec<f64> = before.iter().zip(at).map(|(b, a)| b - a).collect();
    // C J', a column of it for each row.
    let columns: Vec<Vec<f64>> =
        jacobian.iter().map(|row| covariance.iter().map(|c| dot(c, row)).collect()).collect();
    let matrix: Vec<Vec<f64>> = jacobian
        .iter()
        .enumerate()
        .map(|(i, row)| {
            let entry =
                |(k, column): (usize, &Vec<f64>)| dot(row, column) + f64::from(u8::from(i == k));
            columns.iter().enumerate().map(entry).collect()
        })
        .collect();
    let want: Vec<f64> = jacobian.iter().zip(residuals).map(|(j, r)| r + dot(j, &back)).collect();
    let parts = solve(matrix, want)?;
    let step: Vec<f64> = (0..at.len())
        .map(|k| back[k] - columns.iter().zip(&parts).map(|(c, p)| c[k] * p).sum::<f64>())
        .collect();
    Some(step.into_iter().map(|s| s.clamp(-STRIDE, STRIDE)).collect())
}

/// Weights that add up to 1; the law that fits best in front.
fn weighed(mut drawn: Vec<(EnsembleLaw, f64)>) -> Vec<EnsembleLaw> {
    let most = drawn.iter().map(|(_, w)| *w).fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = drawn.iter().map(|(_, w)| (w - most).exp()).sum();
    for (law, weight) in &mut drawn {
        law.weight = (*weight - most).exp() / sum;
    }
    let mut laws: Vec<EnsembleLaw> = drawn.into_iter().map(|(law, _)| law).collect();
    if let Some(best) = (0..laws.len()).min_by(|a, b| laws[*a].score.total_cmp(&laws[*b].score)) {
        laws.swap(0, best);
    }
    laws
}

/// What part of the precision of each parameter the data rows give: 1 less its variance over the prior's.
fn shares(fit: &FittedLaw, rows: usize) -> [f64; COUNT] {
    let all = inverse(&normal(&fit.jacobian, COUNT));
    let before = inverse(&normal(&fit.jacobian[rows.min(fit.jacobian.len())..], COUNT));
    match (all, before) {
        (Some(all), Some(before)) => {
            std::array::from_fn(|k| (1.0 - all[k][k] / before[k][k]).clamp(0.0, 1.0))
        }
        _ => [0.0; COUNT],
    }
}

/// 5, 50 and 95 % of a figure over weighed laws.
fn quantiles(laws: &[EnsembleLaw], of: &dyn Fn(&EnsembleLaw) -> f64) -> [f64; 3] {
    let mut all: Vec<(f64, f64)> = laws.iter().map(|law| (of(law), law.weight)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    [0.05, 0.5, 0.95].map(|part| {
        let mut sum = 0.0;
        let found = all.iter().find(|(_, weight)| {
            sum += weight;
            sum >= part
        });
        found.or(all.last()).map_or(f64::NAN, |(value, _)| *value)
    })
}

/// A standard normal number from a counter (Box and Muller).
fn gauss(seed: u64, counter: usize) -> f64 {
    let key = hash(seed, 0x6c61_7773);
    let [a, b] = [0, 1].map(|k| uniform(key, 2 * counter as u64 + k));
    (-2.0 * (1.0 - a).max(f64::MIN_POSITIVE).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}
