//! Which laws fit what is told of a mesh: an ensemble of them, what the data hold and what the prior holds, and
//! the range of the anchored reference.
//!
//! From each start the best law is searched. Then laws are drawn from the prior about the start, each with an
//! error of its own on every row of the data, and each is led to its data by steps of Gauss and Newton that
//! stay as near to where it was drawn as the data let (randomised maximum likelihood): what no row feels keeps
//! the prior's spread, also where a valley is bent and no normal distribution about its bottom would follow it.
//! A law in which the other kind of bond breaks first follows the slopes of the start that breaks likewise. Laws
//! that do not come to their data are left out; the starts weigh by how well the best law of each fits the data
//! alone: how far it had to go from its start tells little, because nobody knows where meshes lie about one.
//!
//! What a law gives in the field is known no better than the few runs of the anchored reference tell
//! ([`EnsembleLaw::errors`]) and than one solver agrees with another ([`SOLVERS`]): each law stands in the
//! range as a normal distribution of that width, of the logarithm.

use super::data::{FirstBond, MeshData, prior};
use super::family::{COUNT, LawParameters};
use super::levenberg::{inverse, learn, normal, solve};
use super::memory::{LawMemory, TriedLaw};
use super::reference::starts;
use super::rows::{Ended, FitScene, FitTell, Made, SceneKind};
use super::{FitQuestion, FittedLaw, Held, HeldFigure};
use crate::dem::hash::{hash, uniform};
use crate::dem::{Fidelity, Flow, Test};
use crate::layout::REFERENCE;
use crate::study::sampling::spread::Spread;

/// The starts, by their names among those of the reference fit, and in a few words.
const STARTS: [&str; 2] = ["weak twist", "strong twist and wire"];
pub(crate) const START_WORDS: [&str; 2] = ["weak twist", "strong twist"];
/// Laws drawn from each start, the best one aside.
const DRAWS: usize = 16;
/// Simulations that each may take on its way.
const STEPS: usize = 5;
/// Largest change of a parameter, as a logarithm, below which a law has arrived.
const ARRIVED: f64 = 0.02;
/// Largest change of a parameter in one step.
const STRIDE: f64 = 0.5;
/// Simulations of the search from a start: with so few rows its end need not be sharp.
const SEARCH: usize = 24;
/// Simulations of all rows from one start, about.
pub(crate) const SIMULATIONS: usize = SEARCH + DRAWS * 3;
/// Runs of the anchored reference under each law.
pub(in crate::lab) const ANCHORED_RUNS: usize = 4;
/// By what part two solvers of the same scene differ (this one from the one that made the published results).
pub(in crate::lab) const SOLVERS: f64 = 0.015;

/// Factor on the logarithmic width of the range. A few dozen laws led by slopes miss some of what fits: of 40 laws drawn
/// from the prior the range held the field's force of 32, and had held 36 if it had been wider by this; of the next 60
/// it then held 53 (`meshcast calibrate --coverage 100`; no measurement and nothing published was looked at).
const WIDENED: f64 = 1.42;

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
    /// Standard errors of these two, as parts.
    pub(crate) errors: [f64; 2],
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
    let mut forget = |_: &TriedLaw| Flow::Continue;
    identify_on(data, options, &mut LawMemory::new(Vec::new(), &mut forget), tell)
}

/// The same, from what was tried before on.
///
/// # Errors
/// Why it was ended.
pub(crate) fn identify_on(
    data: &MeshData,
    options: &IdentifyOptions,
    memory: &mut LawMemory,
    tell: &FitTell,
) -> Result<Option<Identified>, Ended> {
    let question = data.question(options.seed, options.fidelity, options.threads);
    let mut with_field = question.clone();
    with_field.scenes.push(FitScene {
        words: "anchored reference".into(),
        kind: SceneKind::Punch(Test::Anchored, REFERENCE),
        runs: ANCHORED_RUNS,
    });
    let mut asked = Asked { question: &question, with_field: &with_field, memory, tell };
    let mut valleys = Vec::new();
    for (number, name) in STARTS.iter().enumerate() {
        let Some(start) = starts().iter().find(|s| s.name == *name).map(|s| &s.law) else {
            continue;
        };
        valleys.extend(Valley::find(number, start, &mut asked)?);
    }
    let mut drawn = Vec::new();
    for valley in &valleys {
        drawn.push(valley.laws(&valleys, &mut asked)?);
    }
    if let Some(first) = data.first {
        for laws in &mut drawn {
            laws.retain(|law| (law.twists_first > 0.5) == (first == FirstBond::Twist));
        }
    }
    let fits: Vec<(usize, FittedLaw)> = valleys.into_iter().map(|v| (v.number, v.fit)).collect();
    let laws = weighed(drawn, &fits);
    let Some(best) = laws.first() else { return Ok(None) };
    let Some((_, fit)) = fits.iter().find(|(number, _)| *number == best.start) else {
        return Ok(None);
    };
    let values = if fit.law == best.law {
        fit.values.clone()
    } else {
        asked.rows(&best.law)?.map(|rows| rows.values).unwrap_or_default()
    };
    let shares = shares(fit, question.rows.len());
    let ranges = std::array::from_fn(|k| quantiles(&laws, &|law| law.law.values()[k]));
    let anchored = [0, 1].map(|k| {
        // All laws see the same alignments: one error, and each law an estimate of it.
        let squares: f64 = laws.iter().map(|law| law.weight * law.errors[k].powi(2)).sum();
        let values: Vec<_> = laws.iter().map(|law| (law.anchored[k], law.weight)).collect();
        widened(blurred(&values, squares.sqrt().hypot(SOLVERS)))
    });
    Ok(Some(Identified { question, fits, laws, values, shares, ranges, anchored }))
}

/// Simulates laws, or remembers what they gave.
struct Asked<'a, 'm> {
    question: &'a FitQuestion,
    /// The same with the anchored reference behind its scenes.
    with_field: &'a FitQuestion,
    memory: &'a mut LawMemory<'m>,
    tell: &'a FitTell<'a>,
}

/// What a law gives in the laboratory.
struct RowsOfLaw {
    /// The value of every row.
    values: Vec<f64>,
    /// Whether a twist breaks first in the first scene.
    twists: bool,
}

/// What a law gives with the field.
struct WithField {
    values: Vec<f64>,
    twists_first: f64,
    anchored: [f64; 2],
    errors: [f64; 2],
}

impl Asked<'_, '_> {
    /// The value of every row, and which bond breaks first.
    fn rows(&mut self, law: &LawParameters) -> Result<Option<RowsOfLaw>, Ended> {
        let gave = self.memory.ask(law, false, || {
            let Some(made) = self.question.made(law, self.tell)? else { return Ok(None) };
            let Some(mut values) = self.question.read(law, &made) else { return Ok(None) };
            values.push(made.first().map_or(0.0, Made::twists_first));
            Ok(Some(values))
        })?;
        Ok(gave.and_then(|mut values| {
            let twists_first = values.pop()?;
            Some(RowsOfLaw { values, twists: twists_first > 0.5 })
        }))
    }

    /// The same with the anchored reference.
    fn with_field(&mut self, law: &LawParameters) -> Result<Option<WithField>, Ended> {
        let gave = self.memory.ask(law, true, || {
            let Some(made) = self.with_field.made(law, self.tell)? else { return Ok(None) };
            let (Some(mut values), Some(Made::Punched(field))) =
                (self.with_field.read(law, &made), made.last())
            else {
                return Ok(None);
            };
            let figures = [field.force, field.deflection];
            values.push(made.first().map_or(0.0, Made::twists_first));
            values.extend(figures.iter().map(|figure| figure.mean));
            values.extend(figures.iter().map(Spread::uncertainty));
            Ok(Some(values))
        })?;
        Ok(gave.and_then(|mut values| {
            let behind = values.split_off(self.question.rows.len().min(values.len()));
            let [twists_first, force, deflection, of_force, of_deflection] = behind[..] else {
                return None;
            };
            let (anchored, errors) = ([force, deflection], [of_force, of_deflection]);
            Some(WithField { values, twists_first, anchored, errors })
        }))
    }
}

/// A start with its best law.
struct Valley {
    number: usize,
    fit: FittedLaw,
    held: Vec<Held>,
    /// Rows of the data; those of the prior stand behind them in the Jacobian.
    rows: usize,
    /// Whether a twist breaks first under the best law.
    twists: bool,
}

impl Valley {
    /// The best law of a start; nothing where it cannot be run.
    fn find(
        number: usize,
        start: &LawParameters,
        asked: &mut Asked,
    ) -> Result<Option<Valley>, Ended> {
        let question = asked.question;
        let held = prior(start);
        let Some(first) = asked.rows(start)? else { return Ok(None) };
        // Both strengths by one factor move all forces by it: the search begins at the force of the first test.
        let factor = match (question.rows.first(), first.values.first()) {
            (Some(row), Some(value)) => (row.target / value).clamp(0.3, 3.0),
            _ => 1.0,
        };
        let begin = LawParameters {
            wire_stress: factor * start.wire_stress,
            twist_stress: factor * start.twist_stress,
            ..*start
        };
        let mut values = |law: &LawParameters| Ok(asked.rows(law)?.map(|rows| rows.values));
        let Some(fit) = question.fit(&begin, &held, SEARCH, &mut values)? else { return Ok(None) };
        let twists = asked.rows(&fit.law)?.is_some_and(|rows| rows.twists);
        Ok(Some(Valley { number, fit, held, rows: question.rows.len(), twists }))
    }

    /// The best law and the laws drawn.
    fn laws(&self, valleys: &[Valley], asked: &mut Asked) -> Result<Vec<EnsembleLaw>, Ended> {
        let Some(covariance) = inverse(&normal(&self.fit.jacobian[self.rows..], COUNT)) else {
            return Ok(Vec::new());
        };
        let mut all = Vec::new();
        for draw in 0..=DRAWS {
            let law = if draw == 0 {
                self.fit.law
            } else {
                let counter = self.number * 1000 + draw;
                let Some(law) = self.drawn(valleys, asked, &covariance, counter)? else { continue };
                law
            };
            let Some(gave) = asked.with_field(&law)? else { continue };
            let WithField { values, twists_first, anchored, errors } = gave;
            let score = asked.question.score(&values);
            // Errors of the data's own size add up to the number of rows; far above it is elsewhere.
            let arrived = score <= self.fit.score + 2.0 * self.rows as f64 + 4.0;
            if anchored[0] > 0.0 && anchored[1] > 0.0 && (arrived || draw == 0) {
                let (start, weight) = (self.number, 0.0);
                all.push(EnsembleLaw { start, law, score, weight, twists_first, anchored, errors });
            }
        }
        Ok(all)
    }

    /// A law of the prior, led to data with errors of its own. Nothing where it cannot be run.
    fn drawn(
        &self,
        valleys: &[Valley],
        asked: &mut Asked,
        covariance: &[Vec<f64>],
        counter: usize,
    ) -> Result<Option<LawParameters>, Ended> {
        let question = asked.question;
        let gauss = |k: usize| gauss(question.seed, counter * 100 + k);
        let before = prior_draw(&self.fit.start, &self.held, &gauss);
        let errors: Vec<f64> = (0..self.rows).map(|k| gauss(COUNT + k)).collect();
        let mut jacobian = self.fit.jacobian[..self.rows].to_vec();
        let mut twists = self.twists;
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
            let Some(made) = asked.rows(&law)? else { return Ok(None) };
            let there = with_errors(question, &made.values, &errors);
            let likewise = valleys.iter().find(|valley| valley.twists == made.twists);
            match likewise {
                Some(valley) if made.twists != twists => {
                    jacobian = valley.fit.jacobian[..self.rows].to_vec();
                }
                _ => learn(&mut jacobian, &residuals, &step, &there),
            }
            (twists, residuals) = (made.twists, there);
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

/// Weights that add up to 1, each start's by its best law whatever the number of its laws; the law that fits best
/// in front.
fn weighed(drawn: Vec<Vec<EnsembleLaw>>, fits: &[(usize, FittedLaw)]) -> Vec<EnsembleLaw> {
    let scores = || fits.iter().map(|(_, fit)| fit.score);
    let best = scores().fold(f64::INFINITY, f64::min);
    let mut laws = Vec::new();
    for (of_start, score) in drawn.into_iter().zip(scores()) {
        let weight = libm::exp(0.5 * (best - score)) / of_start.len().max(1) as f64;
        laws.extend(of_start.into_iter().map(|law| EnsembleLaw { weight, ..law }));
    }
    let sum: f64 = laws.iter().map(|law| law.weight).sum();
    laws.iter_mut().for_each(|law| law.weight /= sum);
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

/// 5, 50 and 95 % of a figure over laws, each with its value and weight, that know its logarithm to `sigma`.
pub(in crate::lab) fn blurred(laws: &[(f64, f64)], sigma: f64) -> [f64; 3] {
    let all: Vec<(f64, f64)> = laws.iter().map(|(value, w)| (libm::log(*value), *w)).collect();
    let below = |at: f64| -> f64 {
        let of_law = |(value, weight): &(f64, f64)| {
            weight * 0.5 * libm::erfc((value - at) / (sigma * std::f64::consts::SQRT_2))
        };
        all.iter().map(of_law).sum()
    };
    let least = all.iter().map(|(v, _)| *v).fold(f64::INFINITY, f64::min) - 6.0 * sigma;
    let most = all.iter().map(|(v, _)| *v).fold(f64::NEG_INFINITY, f64::max) + 6.0 * sigma;
    [0.05, 0.5, 0.95].map(|part| {
        let (mut low, mut high) = (least, most);
        // Halved to a part in 10^15 of what the laws span.
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if below(middle) < part {
                low = middle;
            } else {
                high = middle;
            }
        }
        libm::exp(high)
    })
}

/// A range as much wider as it has to be, see [`WIDENED`].
pub(in crate::lab) fn widened([low, middle, high]: [f64; 3]) -> [f64; 3] {
    let wider = |end: f64| middle * libm::pow(end / middle, WIDENED);
    [wider(low), middle, wider(high)]
}

/// A law drawn from the prior about a start by its number, and the seed of all that is drawn.
pub(super) fn law_of_prior(number: usize, seed: u64) -> Option<LawParameters> {
    let start = starts().iter().find(|s| s.name == STARTS[number % STARTS.len()])?;
    let at = prior_draw(&start.law, &prior(&start.law), &|k| gauss(seed, k));
    Some(LawParameters::of_logarithms(&at).rounded())
}

/// A standard normal number from a counter (Box and Muller).
pub(super) fn gauss(seed: u64, counter: usize) -> f64 {
    let key = hash(seed, 0x6c61_7773);
    let [a, b] = [0, 1].map(|k| uniform(key, 2 * counter as u64 + k));
    (-2.0 * (1.0 - a).max(f64::MIN_POSITIVE).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_widened_about_its_middle_by_its_logarithm() {
        let [low, middle, high] = widened([10.0, 20.0, 25.0]);
        // By hand: 20 x 0.5^1.42 = 7.4742, 20 x 1.25^1.42 = 27.4563.
        assert!((low - 7.4742).abs() < 1e-3 && middle == 20.0, "{low}");
        assert!((high - 27.4563).abs() < 1e-3, "{high}");
    }

    #[test]
    fn a_range_over_laws_is_as_wide_as_what_each_of_them_leaves_open() {
        // One law of 20 kN known to 2 %: 20 exp(-+1.645 x 0.02), by hand 19.3527 and 20.6689.
        let one = blurred(&[(20_000.0, 1.0)], 0.02);
        for (made, by_hand) in one.iter().zip([19_352.7, 20_000.0, 20_668.9]) {
            assert!((made - by_hand).abs() < 0.2, "{one:?}");
        }
        // Two that are far apart: a tenth of each is a half of 5 % and of 95 % of the whole, so that the
        // ends are the 10 and 90 % points of one, at 1.28155 standard deviations.
        let two = blurred(&[(20_000.0, 0.5), (30_000.0, 0.5)], 0.02);
        let by_hand = [20_000.0 * (-0.025_631_f64).exp(), 30_000.0 * 0.025_631_f64.exp()];
        assert!((two[0] - by_hand[0]).abs() < 0.2 && (two[2] - by_hand[1]).abs() < 0.2, "{two:?}");
    }
}
