//! Sweep: one input over a range, or two inputs over a grid, by the forecast.
//!
//! - [`dem`]: the same by checks.

pub(crate) mod dem;

use crate::case::{Case, CaseValue, Input};
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::problem::Problem;
use crate::units::without_noise;

/// Most values of one axis.
pub(crate) const MOST_VALUES: usize = 100_000;
/// Most points of a sweep.
pub(crate) const MOST_POINTS: usize = 1_000_000;

/// A range of one input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepAxis {
    pub input: Input,
    /// First value, m or N.
    pub from: f64,
    /// Last value, m or N; it may be below the first.
    pub to: f64,
    /// Number of values at equal distances, both ends included; at least 2.
    pub steps: usize,
}

impl SweepAxis {
    /// The values in order, m or N, without the noise of the division, so that a value on which
    /// something hangs (D = d) is met where it is meant. The ends are exact.
    pub(crate) fn values(&self) -> Vec<f64> {
        let last = self.steps.saturating_sub(1).max(1);
        (0..self.steps)
            .map(|i| match i {
                0 => self.from,
                i if i == last => self.to,
                i => {
                    let part = i as f64 / last as f64;
                    without_noise(self.from + (self.to - self.from) * part)
                }
            })
            .collect()
    }

    /// Checks the range by itself. What makes no sense only beside the other inputs (a spacing below
    /// the punch) is no error: the point has no value.
    ///
    /// # Errors
    /// What is wrong, by the fields `from`, `to` and `steps`.
    pub(crate) fn check(&self) -> Result<(), Vec<Problem>> {
        let end = |name: &str, value| {
            let found = self.input.problem(value);
            found.map(|p| Problem { field: name.to_string(), ..p })
        };
        let mut problems: Vec<Problem> =
            [end("from", self.from), end("to", self.to)].into_iter().flatten().collect();
        if problems.is_empty() && self.from == self.to {
            problems.push(
                Problem::new("to", "the range is empty: it ends where it begins")
                    .value(self.input.text(self.to))
                    .advice("for one value use the forecast"),
            );
        }
        if !(2..=MOST_VALUES).contains(&self.steps) {
            problems.push(
                Problem::new("steps", "this number of values makes no range")
                    .value(self.steps.to_string())
                    .allowed(format!("2 to {MOST_VALUES}, both ends included")),
            );
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }
}

/// A sweep that can be made: its axes are sound and fit each other.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepGrid {
    /// The first input, along a row.
    pub(crate) first: SweepAxis,
    /// The second input, from row to row, where there is one.
    pub(crate) second: Option<SweepAxis>,
    /// Values of the first, m or N.
    pub(crate) columns: Vec<f64>,
    /// Values of the second, m or N; empty where there is none.
    pub(crate) rows: Vec<f64>,
}

impl SweepGrid {
    /// Makes a grid of one axis or two.
    ///
    /// # Errors
    /// What is wrong with the axes, by `first.from` and so on.
    pub fn new(first: SweepAxis, second: Option<SweepAxis>) -> Result<SweepGrid, Vec<Problem>> {
        let mut problems = Vec::new();
        for (axis, name) in [(Some(&first), "first"), (second.as_ref(), "second")] {
            if let Some(Err(found)) = axis.map(SweepAxis::check) {
                problems.extend(found.into_iter().map(|p| p.under(name)));
            }
        }
        if let Some(second) = &second {
            if second.input == first.input {
                problems.push(
                    Problem::new("second", "both ranges are of the same input")
                        .value(first.input.word())
                        .advice("vary two different inputs"),
                );
            }
            let points = first.steps.saturating_mul(second.steps);
            if problems.is_empty() && points > MOST_POINTS {
                problems.push(
                    Problem::new("second.steps", "the map has too many points")
                        .value(format!("{points} points"))
                        .allowed(format!("up to {MOST_POINTS}")),
                );
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let rows = second.map_or(Vec::new(), |axis| axis.values());
        Ok(SweepGrid { columns: first.values(), rows, first, second })
    }

    /// Number of points.
    pub(crate) fn len(&self) -> usize {
        self.columns.len() * self.rows.len().max(1)
    }

    /// The values of point `index`: of the first input, and of the second where there is one. Points
    /// run along the first input, row after row.
    pub(crate) fn at(&self, index: usize) -> (f64, Option<f64>) {
        let column = self.columns.len().max(1);
        (self.columns[index % column], self.rows.get(index / column).copied())
    }

    /// The case of a point.
    pub fn case(&self, base: &Case, index: usize) -> Case {
        let mut case = base.clone();
        self.set(&mut case, index);
        case
    }

    fn set(&self, case: &mut Case, index: usize) {
        let (first, second) = self.at(index);
        case.set(self.first.input, first);
        if let (Some(axis), Some(value)) = (&self.second, second) {
            case.set(axis.input, value);
        }
    }

    /// Fingerprint of the sweep of a case: of the case's inputs and of the axes.
    pub(crate) fn fingerprint(&self, base: &Case) -> Fingerprint {
        let mut of = Fingerprinter::new("sweep")
            .text(&base.question_fingerprint().to_string())
            .flag(self.second.is_some());
        for axis in std::iter::once(&self.first).chain(&self.second) {
            of = of
                .text(axis.input.word())
                .number(axis.from)
                .number(axis.to)
                .text(&axis.steps.to_string());
        }
        of.finish()
    }
}

/// A sweep's results.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// Where its points are.
    pub grid: SweepGrid,
    /// What each point gives, in the order of [`SweepGrid::at`].
    pub points: Vec<CaseValue>,
}

/// Sweeps a case over a grid by the forecast.
pub fn sweep(base: &Case, grid: SweepGrid) -> Sweep {
    // One working case: a mesh is copied once and not for every point.
    let mut case = base.clone();
    let points = (0..grid.len())
        .map(|index| {
            grid.set(&mut case, index);
            case.outcome()
        })
        .collect();
    Sweep { grid, points }
}

/// Smallest and largest of what is read from the points that have values; nothing where none has.
pub(crate) fn extent(
    points: &[CaseValue],
    read: impl Fn(&crate::case::CasePoint) -> Option<f64>,
) -> Option<(f64, f64)> {
    points.iter().flatten().filter_map(read).fold(None, |extent, value| {
        let (least, most) = extent.unwrap_or((value, value));
        Some((least.min(value), most.max(value)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{NoValue, example as case};
    use crate::layout::REFERENCE;

    fn axis(input: Input, from: f64, to: f64, steps: usize) -> SweepAxis {
        SweepAxis { input, from, to, steps }
    }

    #[test]
    fn values_are_those_that_are_meant() {
        let values = axis(Input::Spacing, 2.0, 4.5, 6).values();
        assert_eq!(values, [2.0, 2.5, 3.0, 3.5, 4.0, 4.5]);
        // 0.1 + 0.22 is 0.32 here, and D = d is the small punch.
        let values = axis(Input::Punch, 0.1, 0.54, 3).values();
        assert_eq!(values, [0.1, 0.32, 0.54]);
        assert_eq!(axis(Input::Spacing, 4.0, 2.0, 3).values(), [4.0, 3.0, 2.0]);
    }

    #[test]
    fn a_line_worked_by_hand() {
        let grid = SweepGrid::new(axis(Input::Spacing, 1.5, 4.5, 3), None).unwrap();
        let s = sweep(&case(REFERENCE, Some(10_000.0)), grid);
        let forces: Vec<f64> =
            s.points.iter().map(|p| p.as_ref().unwrap().values().force).collect();
        // 27.063 x (0.16 L/3 + 0.84): factors 0.92, 1.00, 1.08.
        for (force, factor) in forces.iter().zip([0.92, 1.0, 1.08]) {
            assert!((force - 27_063.0 * factor).abs() < 1e-6);
        }
        let use_at_3 = s.points[1].as_ref().unwrap().utilisation().unwrap();
        assert!((use_at_3 - 10.0 / 27.063).abs() < 1e-12);
        let (least, most) = extent(&s.points, |p| p.values().deflection).unwrap();
        assert!((least - 0.317_52).abs() < 1e-9 && (most - 0.952_56).abs() < 1e-9);
    }

    #[test]
    fn a_grid_runs_along_the_first_input() {
        let grid = SweepGrid::new(
            axis(Input::Spacing, 1.25, 3.25, 3),
            Some(axis(Input::Punch, 0.5, 1.5, 3)),
        )
        .unwrap();
        assert_eq!((grid.len(), grid.at(1), grid.at(3)), (9, (2.25, Some(0.5)), (1.25, Some(1.0))));
        let base = case(REFERENCE, None);
        let s = sweep(&base, grid.clone());
        for (index, point) in s.points.iter().enumerate() {
            assert_eq!(*point, grid.case(&base, index).outcome());
        }
        // L = 1.25 with D = 1.5 makes no sense; with D = 1.0 it is beside the plates.
        assert!(matches!(s.points[6], Err(NoValue::Senseless(_))));
        assert!(s.points[3].is_ok());
        let moved = SweepGrid { first: axis(Input::Spacing, 1.25, 3.0, 3), ..grid.clone() };
        assert_ne!(moved.fingerprint(&base), grid.fingerprint(&base));
    }

    #[test]
    fn ranges_that_make_no_sense_are_said_by_field() {
        let said = |first, second| -> Vec<String> {
            SweepGrid::new(first, second)
                .unwrap_err()
                .iter()
                .map(std::string::ToString::to_string)
                .collect()
        };
        let good = axis(Input::Spacing, 2.0, 3.0, 2);
        assert_eq!(
            said(axis(Input::Spacing, -1.0, 3.0, 1), None),
            [
                "first.from = -1.0 m: the value is outside what makes sense; allowed: above 0, below 100 m",
                "first.steps = 1: this number of values makes no range; allowed: 2 to 100000, both ends included",
            ]
        );
        assert!(said(good, Some(good))[0].starts_with("second = L: both ranges are of the same"));
        assert!(said(axis(Input::LabForce, 5e4, 5e4, 2), None)[0].contains("first.to = 50.0 kN"));
        let many = axis(Input::Punch, 0.5, 1.0, MOST_VALUES);
        assert!(said(SweepAxis { steps: 11, ..good }, Some(many))[0].contains("1100000 points"));
    }

    /// Laboratory values scale the forecast whatever the order of points.
    #[test]
    fn the_laboratory_force_scales_the_force() {
        let grid = SweepGrid::new(axis(Input::LabForce, 36_650.0, 146_600.0, 3), None).unwrap();
        let s = sweep(&case(REFERENCE, None), grid);
        let first = s.points[0].as_ref().unwrap().values();
        assert!((first.force - 27_063.0 / 2.0).abs() < 1e-6);
        assert!((first.deflection.unwrap() - 0.635_04).abs() < 1e-12);
    }
}
