//! Fits of what an offset does.

use super::Runs;
use super::fit::{Start, crossed, fit};
use crate::method::offset::{Offsets, count, limited, variables};
use crate::method::sizes::Sizes;

/// Harmonics and weights of smallness that are tried.
const HARMONICS: [usize; 2] = [2, 3];
const RIDGES: [f64; 3] = [1.0e-5, 1.0e-4, 1.0e-3];

/// The factors, and what they say of each run by fits that did not see it, force and deflection.
pub(super) fn offsets(runs: &Runs, sizes: &Sizes) -> (Offsets, [Vec<f64>; 2]) {
    let centred: Vec<_> = runs.layouts.iter().map(|layout| sizes.at(layout)).collect();
    // Over the centred block of the relations: runs with an offset have layouts of their own.
    let quotient = |values: &[f64], of: fn(&crate::method::sizes::Centred) -> f64| -> Vec<f64> {
        values.iter().zip(&centred).map(|(value, centred)| value / of(centred)).collect()
    };
    let factors =
        [quotient(&runs.force, |c| c.force), quotient(&runs.deflection, |c| c.deflection)];
    let mut best: Option<(f64, Offsets, [Vec<f64>; 2])> = None;
    for harmonics in HARMONICS {
        let x: Vec<Vec<f64>> = runs
            .layouts
            .iter()
            .zip(&centred)
            .map(|(layout, centred)| variables(layout, centred.through, harmonics))
            .collect();
        for ridge in RIDGES {
            let said = crossed(runs.len(), |seen| {
                let c = [0, 1].map(|q| coefficients(&x, &factors[q], seen, harmonics, ridge));
                let x = x.clone();
                Box::new(move |i| [0, 1].map(|q| libm::exp(limited(dot(&x[i], &c[q])))))
            });
            let error: f64 = (0..2).map(|q| super::error(&factors[q], &said[q], |_| true)).sum();
            if best.as_ref().is_some_and(|b| b.0 <= error) {
                continue;
            }
            let all: Vec<usize> = (0..runs.len()).collect();
            let [force, deflection] = [0, 1].map(|q| {
                let found = coefficients(&x, &factors[q], &all, harmonics, ridge);
                found.into_iter().map(super::digits).collect()
            });
            let deviation = [0.0; 2];
            let found =
                Offsets { harmonics, ridge, force, deflection, deviation, runs: runs.len() };
            let values = [0, 1].map(|q| {
                said[q].iter().zip(&centred).map(|(f, c)| f * [c.force, c.deflection][q]).collect()
            });
            best = Some((error, found, values));
        }
    }
    // There is always a first one.
    best.map_or_else(|| (none(), [Vec::new(), Vec::new()]), |b| (b.1, b.2))
}

/// No effect at all.
fn none() -> Offsets {
    let zeros = vec![0.0; count(HARMONICS[0])];
    Offsets {
        harmonics: HARMONICS[0],
        ridge: RIDGES[0],
        force: zeros.clone(),
        deflection: zeros,
        deviation: [0.0; 2],
        runs: 0,
    }
}

fn coefficients(
    x: &[Vec<f64>],
    factors: &[f64],
    seen: &[usize],
    harmonics: usize,
    ridge: f64,
) -> Vec<f64> {
    let start = Start { at: vec![0.0; count(harmonics)], pull: ridge * seen.len() as f64 };
    fit(start, seen, factors, &|at, i| (limited(dot(&x[i], at)), x[i].clone()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
