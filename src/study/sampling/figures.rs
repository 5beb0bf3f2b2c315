//! Mean, standard error, points of 5 and 95 % of placed runs.
//!
//! With patterns the mean is the sum over the groups of A times the group's own mean, A the exact area. Its
//! variance is the sum of A^2 (w^2 + b^2 m) / k, m the chance that two draws from the group are of different
//! patterns. The scatter w within patterns is pooled over all that were run twice or more, with the assumed
//! one as if it had been seen [`PRIOR`] times; so is b, between the means of patterns.
//!
//! The distribution is a mixture of normal ones: for each pattern that has runs N(its mean, w) with its
//! area, for each run of a group of several N(its value, w) with its part of the group's area; w is taken
//! as 1 % of the mean at least. Its points of 5 and 95 % are the band, and the lower one is the
//! characteristic value: it knows of alignment and slack, not of how a mesh's production scatters.

use super::groups::{BETWEEN, Group, WITHIN};
use super::spread::Spread;
use super::{Kind, Sample, lattice};

/// Draws that the assumed scatter counts for.
const PRIOR: f64 = 3.0;
/// Least scatter within a pattern, over the mean, that the distribution has.
const LEAST_WITHIN: f64 = 0.01;
/// Standard deviations from the mean to the 5 % point of a normal distribution.
const FIVE_PER_CENT: f64 = 1.645;

/// A value of a run, and where the run stands in the sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Placed {
    /// Number of its pattern, where there are patterns.
    pub(crate) pattern: Option<usize>,
    /// Its alignment.
    pub(crate) phase: [f64; 2],
    pub(crate) value: f64,
}

/// Figures of `values`; the band of `banded`, which may hold more.
pub(crate) fn figures(sample: &Sample, values: &[Placed], banded: &[Placed]) -> Spread {
    let numbers = |list: &[Placed]| list.iter().map(|p| p.value).collect::<Vec<f64>>();
    let (plain, plain_banded) = (numbers(values), numbers(banded));
    let independent = Spread::of(&plain, &plain_banded);
    if banded.len() < 2 {
        return independent;
    }
    match sample.kind {
        Kind::Pinned => independent,
        Kind::Lattice => {
            let phases: Vec<[f64; 2]> = values.iter().map(|p| p.phase).collect();
            let error = lattice::variance_of_mean(&phases, &plain).sqrt();
            let whole = values.len() == banded.len();
            let (mean, half) = (independent.mean, FIVE_PER_CENT * independent.deviation);
            let band = if whole { [mean - half, mean + half] } else { independent.band };
            Spread { error, band, ..independent }
        }
        Kind::Patterns => {
            let (seen, all) = (Seen::of(sample, values), Seen::of(sample, banded));
            Spread {
                mean: seen.mean,
                deviation: if values.len() > 1 { seen.deviation() } else { 0.0 },
                error: if values.len() > 1 { seen.error() } else { 0.0 },
                band: [all.point(0.05), all.point(0.95)],
            }
        }
    }
}

/// What each of some values weighs in the mean; 1 together.
pub(crate) fn weights(sample: &Sample, patterns: &[Option<usize>]) -> Vec<f64> {
    let n = patterns.len().max(1) as f64;
    if sample.kind != Kind::Patterns {
        return vec![1.0 / n; patterns.len()];
    }
    let group = |pattern: &Option<usize>| pattern.and_then(|p| sample.group_of(p));
    let mut counts = vec![0usize; sample.groups.len()];
    patterns.iter().filter_map(group).for_each(|g| counts[g] += 1);
    let there = sample.groups.iter().zip(&counts).filter(|(_, n)| **n > 0);
    let area: f64 = there.map(|(g, _)| g.area).sum();
    let weight = |p| group(p).map_or(0.0, |g| sample.groups[g].area / area / counts[g] as f64);
    patterns.iter().map(weight).collect()
}

/// What some values say.
struct Seen<'a> {
    sample: &'a Sample,
    mean: f64,
    /// Values of each pattern.
    patterns: Vec<Vec<f64>>,
    /// Variances within and between patterns.
    within: f64,
    between: f64,
}

impl Seen<'_> {
    fn of<'a>(sample: &'a Sample, values: &[Placed]) -> Seen<'a> {
        let mut patterns = vec![Vec::new(); sample.patterns.len()];
        for placed in values {
            if let Some(p) = placed.pattern.filter(|p| *p < patterns.len()) {
                patterns[p].push(placed.value);
            }
        }
        let places: Vec<Option<usize>> = values.iter().map(|p| p.pattern).collect();
        let weights = weights(sample, &places);
        let mean = values.iter().zip(&weights).map(|(p, w)| p.value * w).sum();
        let assumed = |scatter: f64| PRIOR * (scatter * mean) * (scatter * mean);
        let (mut squares, mut free) = (0.0, 0.0);
        let runs = patterns.iter().filter(|runs| !runs.is_empty());
        let means: Vec<f64> = runs.clone().map(|runs| average(runs)).collect();
        for (runs, mean) in runs.zip(&means) {
            squares += squares_about(runs, *mean);
            free += runs.len() as f64 - 1.0;
        }
        let within = (assumed(WITHIN) + squares) / (PRIOR + free);
        let apart = squares_about(&means, average(&means));
        let between = (assumed(BETWEEN) + apart) / (PRIOR + means.len() as f64 - 1.0);
        Seen { sample, mean, patterns, within, between }
    }

    fn runs_of(&self, group: &Group) -> usize {
        group.patterns.iter().map(|p| self.patterns[*p].len()).sum()
    }

    /// Standard error of the mean.
    fn error(&self) -> f64 {
        let areas = self.sample.areas();
        let share = |g: &Group| {
            let scatter = match self.runs_of(g) {
                // Nothing is known of it but what all are like.
                0 => self.within + self.between,
                runs => (self.within + self.between * g.mixed(&areas)) / runs as f64,
            };
            g.area * g.area * scatter
        };
        self.sample.groups.iter().map(share).sum::<f64>().sqrt()
    }

    /// Standard deviation of a single run.
    fn deviation(&self) -> f64 {
        let parts = self.mixture();
        let whole: f64 = parts.iter().map(|p| p.0).sum();
        let apart: f64 = parts.iter().map(|(a, v)| a * (v - self.mean) * (v - self.mean)).sum();
        (apart / whole + self.within).sqrt()
    }

    /// Areas and middles of the parts of the distribution.
    fn mixture(&self) -> Vec<(f64, f64)> {
        let mut parts = Vec::new();
        for group in &self.sample.groups {
            if let [pattern] = group.patterns.as_slice() {
                let runs = &self.patterns[*pattern];
                if !runs.is_empty() {
                    parts.push((group.area, average(runs)));
                }
                continue;
            }
            let n = self.runs_of(group) as f64;
            let runs = group.patterns.iter().flat_map(|p| &self.patterns[*p]);
            parts.extend(runs.map(|v| (group.area / n, *v)));
        }
        parts
    }

    /// The value that this part of all alignments and slacks falls below.
    fn point(&self, part: f64) -> f64 {
        let parts = self.mixture();
        let whole: f64 = parts.iter().map(|p| p.0).sum();
        let width = self.within.sqrt().max(LEAST_WITHIN * self.mean.abs());
        if width <= 0.0 || parts.is_empty() {
            return self.mean;
        }
        let below = |x: f64| {
            parts.iter().map(|(a, m)| a * normal((x - m) / width)).sum::<f64>() / whole - part
        };
        let low = parts.iter().map(|p| p.1).fold(f64::INFINITY, f64::min) - 6.0 * width;
        let high = parts.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max) + 6.0 * width;
        let (mut low, mut high) = (low, high);
        // Halved until two neighbouring numbers are left, or nearly.
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if below(middle) < 0.0 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

fn average(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

fn squares_about(values: &[f64], mean: f64) -> f64 {
    values.iter().map(|v| (v - mean) * (v - mean)).sum()
}

/// Part of the standard normal distribution below `x`, to 1e-7 (Abramowitz & Stegun 1964, Eq. 26.2.17).
fn normal(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.231_641_9 * x.abs());
    let series = [1.330_274_429, -1.821_255_978, 1.781_477_937, -0.356_563_782, 0.319_381_530];
    let tail = series.iter().fold(0.0, |sum, c| (sum + c) * t);
    let tail = tail * (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
    if x < 0.0 { tail } else { 1.0 - tail }
}
