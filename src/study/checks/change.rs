//! What two results say about the difference of their cases, with its standard error.
//!
//! Where every run of both broke, run k of one is held against run k of the other: they share
//! alignment and slack, and the error is that of the mean of the pairs' differences. Where a run
//! slipped, diverged or was cut short, nobody knows the pairs, and the error is that of two independent
//! means. The pairs' error is the honest one whether or not the runs really move together: where they
//! do not it is as large as the other.

use super::utilisation;
use crate::forecast::design::Question;
use crate::study::remark::CheckFlag;
use crate::study::result::CheckResult;

/// A change with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownValue {
    /// The change.
    pub(crate) value: f64,
    /// Its standard error; nothing where a single run says nothing of the scatter.
    pub(crate) error: Option<f64>,
}

impl KnownValue {
    /// Whether it is less than two standard errors from nothing, so that it may be chance; also where
    /// its error is not known.
    pub(crate) fn doubtful(&self) -> bool {
        self.error.is_none_or(|error| self.value.abs() < 2.0 * error)
    }
}

/// Change from one case's check to another's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CheckChange {
    /// Of the mean force at the first break, N.
    pub force: KnownValue,
    /// Of the mean deflection at the first break, m.
    pub deflection: KnownValue,
    /// Of the utilisation, where a design force is set; 0.01 is one per cent of the resistance.
    pub utilisation: Option<KnownValue>,
    /// Of the force, as a part of the first case's.
    pub force_part: f64,
    /// Of the deflection, as a part of the first case's.
    pub deflection_part: f64,
    /// Whether the errors are of pairs of runs.
    pub paired: bool,
}

/// The change from one result to another; nothing where no run of one of them broke.
pub(crate) fn change(
    from: &CheckResult,
    to: &CheckResult,
    question: &Question,
) -> Option<CheckChange> {
    if !from.broke() || !to.broke() {
        return None;
    }
    let paired = paired(from, to);
    let force = |v: &CheckResult| v.breaks.iter().map(|b| b.at.force).collect::<Vec<f64>>();
    let deflection =
        |v: &CheckResult| v.breaks.iter().map(|b| b.at.deflection).collect::<Vec<f64>>();
    let (forces, deflections) = ([force(from), force(to)], [deflection(from), deflection(to)]);
    let error = |values: &[Vec<f64>; 2], slopes| error_of(values, slopes, paired);
    let [before, after] = [from.force.mean, to.force.mean];
    let used = |force: f64| utilisation(question, force);
    Some(CheckChange {
        force: KnownValue { value: after - before, error: error(&forces, [1.0, 1.0]) },
        deflection: KnownValue {
            value: to.deflection.mean - from.deflection.mean,
            error: error(&deflections, [1.0, 1.0]),
        },
        // Utilisation is some load over the force: to the first order it moves by -u/F a newton.
        utilisation: used(before).zip(used(after)).map(|(u, v)| KnownValue {
            value: v - u,
            error: error(&forces, [u / before, v / after]),
        }),
        force_part: after / before - 1.0,
        deflection_part: to.deflection.mean / from.deflection.mean - 1.0,
        paired,
    })
}

/// Whether the first breaks of both are those of the same runs.
fn paired(a: &CheckResult, b: &CheckResult) -> bool {
    let whole = |v: &CheckResult| {
        let cut = [CheckFlag::Cancelled, CheckFlag::Diverged].iter().any(|f| v.flags.contains(f));
        !cut && v.slipped == 0 && v.breaks.len() == v.runs
    };
    whole(a) && whole(b) && a.runs == b.runs && a.wanted == b.wanted
}

/// Standard error of slope 1 times the second mean less slope 0 times the first.
fn error_of(values: &[Vec<f64>; 2], slopes: [f64; 2], paired: bool) -> Option<f64> {
    let [from, to] = values;
    if paired {
        let pairs: Vec<f64> =
            from.iter().zip(to).map(|(a, b)| slopes[1] * b - slopes[0] * a).collect();
        return error_of_mean(&pairs);
    }
    let (a, b) = (error_of_mean(from)?, error_of_mean(to)?);
    Some((slopes[0] * a).hypot(slopes[1] * b))
}

/// Standard error of the mean of some values; nothing for a single one.
fn error_of_mean(values: &[f64]) -> Option<f64> {
    let n = values.len() as f64;
    if values.len() < 2 {
        return None;
    }
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
    Some((squares / (n - 1.0) / n).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Input, example};
    use crate::dem::Flow;
    use crate::study::checks::checks;
    use crate::study::checks::tests::{SMALL, two};
    use crate::study::result::Wanted;

    #[test]
    fn errors_worked_by_hand() {
        // Differences 1, 2, 3: mean 2, variance 1, error 1/sqrt 3.
        let values = [vec![10.0, 20.0, 30.0], vec![11.0, 22.0, 33.0]];
        let close = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-12;
        assert!(close(error_of(&values, [1.0, 1.0], true), (1.0_f64 / 3.0).sqrt()));
        // Twice the first: -9, -18, -27 have the error 9/sqrt 3.
        assert!(close(error_of(&values, [2.0, 1.0], true), (81.0_f64 / 3.0).sqrt()));
        // Alone: errors 10/sqrt 3 and 11/sqrt 3.
        assert!(close(error_of(&values, [1.0, 1.0], false), (221.0_f64 / 3.0).sqrt()));
        assert_eq!(error_of(&[vec![1.0], vec![2.0]], [1.0, 1.0], true), None);
        let known = |value, error| KnownValue { value, error };
        assert!(known(1.0, Some(0.6)).doubtful() && !known(-1.3, Some(0.6)).doubtful());
        assert!(known(1.0, None).doubtful());
    }

    #[test]
    fn a_change_is_the_difference_of_two_verdicts() {
        let base = example(SMALL, Some(5_000.0));
        let cases = [base.clone(), base.with(Input::Spacing, 1.5)];
        let wanted = Wanted { runs: Some(3), ..two() };
        let both = checks(&cases, &wanted, 1, &|_| Flow::Continue);
        let [a, b] = [both[0].as_ref().unwrap(), both[1].as_ref().unwrap()];
        let c = change(a, b, &base.question).unwrap();
        assert!(c.paired);
        assert_eq!(c.force.value, b.force.mean - a.force.mean);
        assert_eq!(c.deflection.value, b.deflection.mean - a.deflection.mean);
        assert!((c.force_part - (b.force.mean / a.force.mean - 1.0)).abs() < 1e-15);
        // 5 kN over each mean.
        let used = 5_000.0 / b.force.mean - 5_000.0 / a.force.mean;
        assert!((c.utilisation.unwrap().value - used).abs() < 1e-12);
        assert!(c.force.error.unwrap() > 0.0 && c.utilisation.unwrap().error.unwrap() > 0.0);
        // The same against itself: nothing moves, and that is certain.
        let none = change(a, a, &base.question).unwrap();
        assert_eq!((none.force, none.paired), (KnownValue { value: 0.0, error: Some(0.0) }, true));
        // Where a run is cut off the pairs are not known, and the errors add up.
        let mut cut = b.clone();
        cut.flags.push(CheckFlag::Cancelled);
        let apart = change(a, &cut, &base.question).unwrap();
        assert!(!apart.paired);
        let sum = a.force.error.hypot(b.force.error);
        // Forces are rounded to five digits, and they spread over a thirtieth of themselves or more.
        assert!((apart.force.error.unwrap() / sum - 1.0).abs() < 3e-3);
        let mut slipped = b.clone();
        slipped.curve.failure = None;
        assert_eq!(change(a, &slipped, &base.question), None);
    }
}
