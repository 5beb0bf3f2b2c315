//! A sweep by checks: each point of the grid an ensemble with the same seeds.

use super::SweepGrid;
use crate::case::Case;
use crate::study::checks::{CheckAnswer, NoCheck};

/// The cases of a grid, in the order of [`SweepGrid::at`].
///
/// # Errors
/// A laboratory value is varied, which a check does not know.
pub(crate) fn cases(base: &Case, grid: &SweepGrid) -> Result<Vec<Case>, NoCheck> {
    let mut axes = std::iter::once(&grid.first).chain(&grid.second);
    if axes.any(|axis| axis.input.is_laboratory()) {
        return Err(NoCheck::Laboratory);
    }
    Ok((0..grid.len()).map(|index| grid.case(base, index)).collect())
}

/// Smallest and largest of the bands of the force at the points that have one, N: what a chart of them
/// must show; nothing where none has.
pub(crate) fn extent(answers: &[CheckAnswer]) -> Option<(f64, f64)> {
    answers.iter().flatten().filter(|v| v.runs > 0).fold(None, |extent, result| {
        let [low, high] = result.force.band;
        let (least, most) = extent.unwrap_or((low, high));
        Some((least.min(low), most.max(high)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Input, example};
    use crate::dem::Flow;
    use crate::study::checks::checks;
    use crate::study::checks::tests::{SMALL, two};
    use crate::study::sweep::SweepAxis;

    #[test]
    fn points_are_the_grids_cases_and_laboratory_values_have_none() {
        let axis = |input, from, to| SweepAxis { input, from, to, steps: 2 };
        let base = example(SMALL, None);
        let grid =
            SweepGrid::new(axis(Input::Plate, 0.3, 0.35), Some(axis(Input::Punch, 0.4, 1.35)))
                .unwrap();
        let cases = cases(&base, &grid).unwrap();
        assert!(cases.iter().enumerate().all(|(i, c)| *c == grid.case(&base, i)));
        let answers = checks(&cases, &two(), 1, &|_| Flow::Continue);
        assert!(answers[..2].iter().all(Result::is_ok));
        assert!(answers[2..].iter().all(|a| matches!(a, Err(NoCheck::Impossible(_)))));
        let (least, most) = extent(&answers).unwrap();
        let bands = answers.iter().flatten().map(|v| v.force.band);
        assert!(bands.into_iter().all(|[low, high]| least <= low && high <= most));
        assert_eq!(extent(&answers[2..]), None);
        let grid = SweepGrid::new(axis(Input::LabForce, 5.0e4, 6.0e4), None).unwrap();
        assert_eq!(super::cases(&base, &grid), Err(NoCheck::Laboratory));
    }
}
