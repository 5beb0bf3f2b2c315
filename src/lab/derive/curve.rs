//! The normalised curve: the paper's cubic fitted to the runs' curves, and their envelope.

use super::digits;
use super::fit::linear;
use crate::method::MasterCurve;
use crate::study::ensemble::quantile;

/// Least slope of the cubic: it has to rise everywhere to have an inverse. The paper's has 0.035.
const LEAST_SLOPE: f64 = 0.01;
/// Step of the search for its coefficients, which have three digits, as the paper's.
const STEP: f64 = 0.001;

/// The cubic of some normalised curves (0 at 0, 1 at 1, equal steps), and their envelope.
///
/// # Errors
/// There are none.
pub(super) fn master(curves: &[Vec<f64>]) -> Result<MasterCurve, String> {
    let points = curves.first().map_or(0, Vec::len);
    if points < 4 {
        return Err("no run of a centred block broke".into());
    }
    let x = |i: usize| i as f64 / (points - 1) as f64;
    let all = || curves.iter().flat_map(|curve| curve.iter().enumerate().map(|(i, y)| (x(i), *y)));
    let free = linear(all().map(|(x, y)| (vec![x * x * x, x * x, x], y)), 3);
    let free = free.ok_or("the curves determine no cubic")?;
    let envelope = (0..points)
        .map(|i| {
            let here: Vec<f64> = curves.iter().map(|curve| curve[i]).collect();
            [0.05, 0.5, 0.95].map(|part| digits(quantile(&here, part)))
        })
        .collect();
    Ok(MasterCurve {
        cubic: rising(all()),
        free: [free[0], free[1], free[2]].map(digits),
        envelope,
    })
}

/// The cubic that is 1 at 1, rises everywhere and fits best: y = x + b (x^2 - x^3) + c (x - x^3), as
/// a = 1 - b - c, less x^3.
fn rising(points: impl Iterator<Item = (f64, f64)>) -> [f64; 3] {
    // Sums of the squares: of (y - x^3), p = x^2 - x^3 and q = x - x^3.
    let (mut pp, mut pq, mut qq, mut py, mut qy) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (x, y) in points {
        let cube = x * x * x;
        let (p, q, r) = (x * x - cube, x - cube, y - cube);
        pp += p * p;
        pq += p * q;
        qq += q * q;
        py += p * r;
        qy += q * r;
    }
    let mut best = (f64::INFINITY, [1.0, 0.0, 0.0]);
    for i in -2000..=2000 {
        let b = f64::from(i) * STEP;
        for j in 0..=1000 {
            let c = f64::from(j) * STEP;
            let a = 1.0 - b - c;
            if !rises(a, b, c) {
                continue;
            }
            let off = b * b * pp + 2.0 * b * c * pq + c * c * qq - 2.0 * (b * py + c * qy);
            if off < best.0 {
                // As the shortest decimals, so that they are in the file what they are here.
                let three = |v: f64| (v * 1000.0).round() / 1000.0;
                best = (off, [three(a), three(b), three(c)]);
            }
        }
    }
    best.1
}

/// Whether a x^3 + b x^2 + c x rises by at least [`LEAST_SLOPE`] everywhere; a above 0.
fn rises(a: f64, b: f64, c: f64) -> bool {
    a > 0.0 && c - b * b / (3.0 * a) >= LEAST_SLOPE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_cubic_comes_back_from_its_own_points() {
        let [a, b, c] = [1.312, -0.385, 0.073];
        let curve: Vec<f64> =
            (0..=20).map(|i| f64::from(i) / 20.0).map(|x| ((a * x + b) * x + c) * x).collect();
        let low: Vec<f64> = curve.iter().map(|y| 0.9 * y).collect();
        let found = master(&[curve.clone(), curve.clone()]).unwrap();
        assert_eq!(found.cubic, [a, b, c]);
        for (one, due) in found.free.iter().zip([a, b, c]) {
            assert!((one - due).abs() < 1e-5, "{found:?}");
        }
        let spread = master(&[curve.clone(), low]).unwrap();
        // By hand: between 0.9 and 1 of the curve, 5 % of the way from one to the other.
        assert!((spread.envelope[10][0] - 0.905 * curve[10]).abs() < 1e-5);
        assert!((spread.envelope[10][1] - 0.95 * curve[10]).abs() < 1e-5);
        assert!(master(&[]).is_err());
    }

    #[test]
    fn a_curve_that_starts_flat_still_gets_a_cubic_with_an_inverse() {
        let flat: Vec<f64> = (0..=20).map(|i| (f64::from(i) / 20.0).powi(4)).collect();
        let [a, b, c] = master(&[flat]).unwrap().cubic;
        assert!((a + b + c - 1.0).abs() < 1e-12 && c - b * b / (3.0 * a) >= LEAST_SLOPE - 1e-12);
    }
}
