//! Least squares of relations that are known by their logarithm.
//!
//! What is fitted is the mean: the sum over runs of (run/value - 1) times the gradient of the value's logarithm
//! comes to nothing. Fits of logarithms would find the median, which lies below the mean by half the square of
//! the scatter (5 % where small blocks scatter by 30 %).

use crate::forecast::eccentricity::solve;

/// Steps at most.
const STEPS: usize = 80;
/// Size of a step that is none, over the parameters.
const SETTLED: f64 = 1.0e-9;
/// Largest misfit of one run that pulls in full: a run that is far off says no more than that.
const PULL: f64 = 1.0;
/// Damping of the steps; where they settle does not depend on it.
const DAMPING: f64 = 1.0e-3;

/// Where a fit starts, and how strongly it is drawn there where the runs say nothing.
pub(super) struct Start {
    pub(super) at: Vec<f64>,
    pub(super) pull: f64,
}

/// A relation: logarithm and its gradient for run i at some parameters.
pub(super) type Relation<'a> = dyn Fn(&[f64], usize) -> (f64, Vec<f64>) + 'a;

/// Fits a relation to the runs `of`, whose values are `y`. Where the fit goes astray the start is given.
pub(super) fn fit(start: Start, of: &[usize], y: &[f64], relation: &Relation) -> Vec<f64> {
    let n = start.at.len();
    let mut at = start.at.clone();
    for _ in 0..STEPS {
        let mut matrix = vec![vec![0.0; n]; n];
        let mut right = vec![0.0; n];
        for &i in of {
            let (logarithm, gradient) = relation(&at, i);
            let off = (y[i] / libm::exp(logarithm) - 1.0).clamp(-PULL, PULL);
            for j in 0..n {
                right[j] += gradient[j] * off;
                for (entry, with) in matrix[j].iter_mut().zip(&gradient) {
                    *entry += gradient[j] * with;
                }
            }
        }
        for j in 0..n {
            matrix[j][j] += start.pull + DAMPING;
            right[j] -= start.pull * (at[j] - start.at[j]);
        }
        let Some(step) = solve(matrix, right) else { return start.at };
        for (value, by) in at.iter_mut().zip(&step) {
            *value += by;
        }
        if at.iter().any(|value| !value.is_finite()) {
            return start.at;
        }
        let size = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
        if size(&step) <= SETTLED * SETTLED * size(&at) {
            break;
        }
    }
    at
}

/// The plain least squares fit of `y` by columns; nothing where they do not determine it.
pub(super) fn linear(
    rows: impl Iterator<Item = (Vec<f64>, f64)>,
    columns: usize,
) -> Option<Vec<f64>> {
    let mut matrix = vec![vec![0.0; columns]; columns];
    let mut right = vec![0.0; columns];
    for (row, y) in rows {
        for j in 0..columns {
            right[j] += row[j] * y;
            for k in 0..columns {
                matrix[j][k] += row[j] * row[k];
            }
        }
    }
    solve(matrix, right)
}

/// Parts of a cross-validation.
pub(super) const PARTS: usize = 10;

/// What a fit says of any run: force and deflection.
pub(super) type Say = Box<dyn Fn(usize) -> [f64; 2]>;

/// Each of the runs 0 to n by a fit that did not see it: `fitted` gets the runs that a fit may see and gives
/// what it says. Forces and deflections.
pub(super) fn crossed(n: usize, fitted: impl Fn(&[usize]) -> Say) -> [Vec<f64>; 2] {
    let mut said = [vec![0.0; n], vec![0.0; n]];
    for part in 0..PARTS {
        let seen: Vec<usize> = (0..n).filter(|i| i % PARTS != part).collect();
        let say = fitted(&seen);
        for i in (part..n).step_by(PARTS) {
            [said[0][i], said[1][i]] = say(i);
        }
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_scattered_values_is_found_and_not_their_median() {
        // One parameter, ln f: half of the values 0.5 and half 1.5.
        let y: Vec<f64> = (0..10).map(|i| if i % 2 == 0 { 0.5 } else { 1.5 }).collect();
        let of: Vec<usize> = (0..10).collect();
        let start = Start { at: vec![0.3], pull: 0.0 };
        let found = fit(start, &of, &y, &|at, _| (at[0], vec![1.0]));
        assert!(found[0].abs() < 1e-8, "{found:?}");
    }

    #[test]
    fn a_power_law_comes_back() {
        let x: Vec<f64> = (1..20).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| 2.0 * x.powf(0.7)).collect();
        let of: Vec<usize> = (0..x.len()).collect();
        let start = Start { at: vec![0.0, 0.0], pull: 0.0 };
        let relation = |at: &[f64], i: usize| (at[0] + at[1] * x[i].ln(), vec![1.0, x[i].ln()]);
        let found = fit(start, &of, &y, &relation);
        assert!((found[0] - 2.0_f64.ln()).abs() < 1e-6 && (found[1] - 0.7).abs() < 1e-6);
        // Without runs it stays where it starts.
        let start = Start { at: vec![1.0, 2.0], pull: 0.1 };
        assert_eq!(fit(start, &[], &y, &relation), [1.0, 2.0]);
    }

    #[test]
    fn no_run_is_said_by_a_fit_that_saw_it() {
        let said = crossed(25, |seen| {
            let seen = seen.to_vec();
            Box::new(move |i| if seen.contains(&i) { [1.0; 2] } else { [0.0; 2] })
        });
        assert_eq!(said, [vec![0.0; 25], vec![0.0; 25]]);
    }
}
