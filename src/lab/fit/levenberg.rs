//! Least squares by Levenberg's method: the sum of squares of some residuals made as small as it gets.

/// Step of the differences that make the Jacobian, in the parameters' own (logarithmic) unit: far above
/// the roughness of a simulated first break, which jumps by a part in a thousand from bond to bond.
const DIFFERENCE: f64 = 0.04;
/// Largest change of a parameter in one step.
const STRIDE: f64 = 0.35;
/// Damping at the start, as a part of the squares' own curvature, and what it is changed by.
const DAMPING: (f64, f64) = (1.0e-2, 5.0);
/// Steps that may fail one after the other.
const FAILURES: usize = 3;
/// Decrease of the sum, as a part, below which the search is at its end.
const FLAT: f64 = 2.0e-3;

/// What the residuals of a place are: none where there is no answer there.
pub(crate) type Residuals = Option<Vec<f64>>;

/// The end of a search.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Minimum {
    /// The place.
    pub(crate) at: Vec<f64>,
    /// Residuals there.
    pub(crate) residuals: Vec<f64>,
    /// Change of each residual (first index) with each parameter, at the place or near it.
    pub(crate) jacobian: Vec<Vec<f64>>,
    /// How often residuals were asked for.
    pub(crate) evaluations: usize,
}

/// Sum of squares.
pub(crate) fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

/// Searches from `start`, asking for residuals about `most` times at most. Nothing where the start has no
/// answer.
///
/// The Jacobian is made by differences, learns from every step (Broyden), and is made anew where it leads
/// no further.
///
/// # Errors
/// What `residuals` ends with: the search is over then.
pub(crate) fn search<E>(
    start: &[f64],
    most: usize,
    residuals: &mut dyn FnMut(&[f64]) -> Result<Residuals, E>,
) -> Result<Option<Minimum>, E> {
    let Some(first) = residuals(start)? else { return Ok(None) };
    let mut best =
        Minimum { at: start.to_vec(), residuals: first, jacobian: vec![], evaluations: 1 };
    best.jacobian = jacobian(&mut best, residuals)?;
    // Steps that led on since the Jacobian was made, and steps that failed since the last of them.
    let (mut damping, mut since, mut failed) = (DAMPING.0, 0, 0);
    while best.evaluations < most {
        let before = squares(&best.residuals);
        let Some(step) = step(&best, damping) else { break };
        let at: Vec<f64> = best.at.iter().zip(&step).map(|(a, s)| a + s).collect();
        best.evaluations += 1;
        let made = residuals(&at)?;
        if let Some(made) = &made {
            learn(&mut best.jacobian, &best.residuals, &step, made);
        }
        let after = made.as_deref().map_or(f64::INFINITY, squares);
        if after < before {
            damping /= DAMPING.1;
            (best.at, best.residuals) = (at, made.unwrap_or_default());
            (since, failed) = (since + 1, 0);
        } else {
            damping *= DAMPING.1;
            failed += 1;
        }
        let flat = after < before && before - after <= FLAT * before;
        if !flat && failed < FAILURES {
            continue;
        }
        if since == 0 || flat && since == 1 {
            break;
        }
        best.jacobian = jacobian(&mut best, residuals)?;
        (damping, since, failed) = (DAMPING.0, 0, 0);
    }
    Ok(Some(best))
}

/// Puts into the Jacobian what a step from residuals `here` to `made` has shown.
pub(crate) fn learn(jacobian: &mut [Vec<f64>], here: &[f64], step: &[f64], made: &[f64]) {
    let length: f64 = step.iter().map(|s| s * s).sum();
    for (row, (made, here)) in jacobian.iter_mut().zip(made.iter().zip(here)) {
        let expected: f64 = row.iter().zip(step).map(|(j, s)| j * s).sum();
        let miss = (made - here - expected) / length.max(1.0e-12);
        row.iter_mut().zip(step).for_each(|(j, s)| *j += miss * s);
    }
}

/// Forward differences, backward where there is no answer ahead, none where there is none at all.
fn jacobian<E>(
    best: &mut Minimum,
    residuals: &mut dyn FnMut(&[f64]) -> Result<Residuals, E>,
) -> Result<Vec<Vec<f64>>, E> {
    let mut rows = vec![vec![0.0; best.at.len()]; best.residuals.len()];
    for column in 0..best.at.len() {
        for difference in [DIFFERENCE, -DIFFERENCE] {
            let mut at = best.at.clone();
            at[column] += difference;
            best.evaluations += 1;
            if let Some(there) = residuals(&at)? {
                for (row, (there, here)) in rows.iter_mut().zip(there.iter().zip(&best.residuals)) {
                    row[column] = (there - here) / difference;
                }
                break;
            }
        }
    }
    Ok(rows)
}

/// The damped step: (J'J + damping diag J'J) step = -J'r, no longer than [`STRIDE`] in any parameter.
fn step(best: &Minimum, damping: f64) -> Option<Vec<f64>> {
    let mut matrix = normal(&best.jacobian, best.at.len());
    for (k, row) in matrix.iter_mut().enumerate() {
        row[k] += damping * row[k].max(1.0e-9);
    }
    let slope: Vec<f64> = (0..best.at.len())
        .map(|k| -best.jacobian.iter().zip(&best.residuals).map(|(j, r)| j[k] * r).sum::<f64>())
        .collect();
    let step = solve(matrix, slope)?;
    let longest = step.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
    let part = if longest > STRIDE { STRIDE / longest } else { 1.0 };
    Some(step.into_iter().map(|s| s * part).collect())
}

/// J'J: the precision of the parameters where residuals have a standard deviation of 1.
pub(crate) fn normal(jacobian: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let entry = |a: usize, b: usize| jacobian.iter().map(|row| row[a] * row[b]).sum::<f64>();
    (0..count).map(|a| (0..count).map(|b| entry(a, b)).collect()).collect()
}

/// Solves a small system by elimination with pivots; nothing where it has no one solution.
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| matrix[*a][k].abs().total_cmp(&matrix[*b][k].abs()))?;
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let pivot = matrix[k].clone();
        if pivot[k] == 0.0 || !pivot[k].is_finite() {
            return None;
        }
        for row in k + 1..n {
            let factor = matrix[row][k] / pivot[k];
            matrix[row].iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= factor * above);
            right[row] -= factor * right[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|c| matrix[k][c] * right[c]).sum();
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right.iter().all(|v| v.is_finite()).then_some(right)
}

/// The inverse of a small matrix, if it has one.
pub(crate) fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let columns: Option<Vec<Vec<f64>>> = (0..n)
        .map(|k| solve(matrix.to_vec(), (0..n).map(|i| f64::from(u8::from(i == k))).collect()))
        .collect();
    let columns = columns?;
    Some((0..n).map(|i| (0..n).map(|k| columns[k][i]).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_three_points_is_found_and_its_precision_too() {
        // y = a + b x through (0, 1), (1, 2), (2, 4): normal equations by hand give a = 5/6, b = 3/2.
        let residuals = |p: &[f64]| {
            [(0.0, 1.0), (1.0, 2.0), (2.0, 4.0)].map(|(x, y)| p[0] + p[1] * x - y).to_vec()
        };
        let found =
            search::<()>(&[0.0, 0.0], 99, &mut |p| Ok(Some(residuals(p)))).unwrap().unwrap();
        assert!((found.at[0] - 5.0 / 6.0).abs() < 1e-2 && (found.at[1] - 1.5).abs() < 1e-2);
        let precision = normal(&found.jacobian, 2);
        for (k, row) in [[3.0, 3.0], [3.0, 5.0]].iter().enumerate() {
            for (c, entry) in row.iter().enumerate() {
                assert!((precision[k][c] - entry).abs() < 1e-9);
            }
        }
        // Its inverse by hand: determinant 6, [[5, -3], [-3, 3]]/6.
        let inverse = inverse(&precision).unwrap();
        assert!((inverse[0][1] + 0.5).abs() < 1e-9 && (inverse[1][1] - 0.5).abs() < 1e-9);
        assert_eq!(solve(vec![vec![1.0, 2.0], vec![2.0, 4.0]], vec![1.0, 1.0]), None);
    }

    #[test]
    fn a_curved_valley_is_followed_and_a_place_without_an_answer_avoided() {
        // Rosenbrock's valley; nothing is known beyond x = 1.2. Its bottom is at (1, 1).
        let mut residuals =
            |p: &[f64]| Ok((p[0] <= 1.2).then(|| vec![10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]]));
        let found = search::<()>(&[0.2, 0.5], 300, &mut residuals).unwrap().unwrap();
        assert!((found.at[0] - 1.0).abs() < 0.1, "{found:?}");
        assert_eq!(search(&[2.0, 0.0], 9, &mut residuals).unwrap(), None);
        assert_eq!(search(&[0.0, 0.0], 9, &mut |_| Err("ended")), Err("ended"));
    }
}
