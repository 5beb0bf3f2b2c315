//! Alignments where there are no patterns to go by: points of a lattice, moved as a whole at random.
//!
//! The net is its own image half an opening and one row further, so half a period along y tells all, and
//! what leaves it above comes back below half an opening further. Of a number n of runs that is known,
//! point k stands at y = (k + U)/n of that half and x = c (k + U)/n + V, c the odd half that is nearest to n
//! times the golden ratio: a lattice without seam that is good for any n. Where the number grows as long as
//! the mean is too uncertain, the points are those of an embedded lattice: at 8, 16, 32 and 64 points it is
//! whole each time. U and V are uniform, so each point is, and the plain mean is unbiased for any n.
//!
//! A lattice integrates the slowest waves over the alignments exactly, so they do not count in the error
//! of the mean: what is left of the values when they are fitted does.

use std::f64::consts::TAU;

/// The golden ratio less one.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Generator c of the embedded lattice: of the odd halves below 64 that whose lattices have no near
/// neighbours at any of 8, 16, 32 and 64 points.
const EMBEDDED: f64 = 13.5;

/// Point `k` of `runs` points, or of the sequence where the number is open, moved by `shift`.
pub(super) fn point(k: usize, runs: Option<usize>, shift: [f64; 2]) -> [f64; 2] {
    let (part, generator) = match runs {
        Some(n) => (k as f64 / n.max(1) as f64, (n as f64 * GOLDEN).floor() + 0.5),
        None => (van_der_corput(k), EMBEDDED),
    };
    let up = part + shift[0];
    // Half an opening further for each half period further up.
    let x = part * generator + shift[1] + 0.5 * up.floor();
    [x - x.floor(), (up - up.floor()) / 2.0]
}

/// The digits of `k` to base 2 mirrored at the point: 0, 1/2, 1/4, 3/4, 1/8 ...
fn van_der_corput(k: usize) -> f64 {
    (k as u64).reverse_bits() as f64 / 2.0_f64.powi(64)
}

/// The slowest waves over the alignments that are the same half an opening and a row further, as numbers
/// of waves in x and y.
const WAVES: [(f64, f64); 4] = [(1.0, 1.0), (1.0, -1.0), (2.0, 0.0), (0.0, 2.0)];

/// Values per parameter of the fit below which nothing is fitted.
const LEAST_A_PARAMETER: usize = 2;

/// Variance of the mean of values at these alignments. Few values count as independent ones, which is too
/// much rather than too little.
pub(super) fn variance_of_mean(phases: &[[f64; 2]], values: &[f64]) -> f64 {
    let n = values.len();
    if n < 2 {
        return 0.0;
    }
    let mean = values.iter().sum::<f64>() / n as f64;
    let mut rest: Vec<f64> = values.iter().map(|v| v - mean).collect();
    let mut fitted: Vec<Vec<f64>> = Vec::new();
    for (a, b) in WAVES {
        for quarter in [0.0, TAU / 4.0] {
            if (fitted.len() + 2) * LEAST_A_PARAMETER > n {
                break;
            }
            let wave = |p: &[f64; 2]| (TAU * (a * p[0] + b * p[1]) + quarter).cos();
            let mut column: Vec<f64> = phases.iter().map(wave).collect();
            let average = column.iter().sum::<f64>() / n as f64;
            column.iter_mut().for_each(|v| *v -= average);
            // Gram and Schmidt: what the waves before have not.
            for before in &fitted {
                take_out(&mut column, before);
            }
            let length = dot(&column, &column).sqrt();
            if length < 1.0e-6 {
                continue;
            }
            column.iter_mut().for_each(|v| *v /= length);
            take_out(&mut rest, &column);
            fitted.push(column);
        }
    }
    let free = (n - 1 - fitted.len()) as f64;
    dot(&rest, &rest) / free / n as f64
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Takes the part along a vector of length 1 out.
fn take_out(from: &mut [f64], along: &[f64]) {
    let part = dot(from, along);
    from.iter_mut().zip(along).for_each(|(v, a)| *v -= part * a);
}
