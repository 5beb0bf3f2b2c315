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
use crate::study::result::{CheckResult, FirstBreak};

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
    let values = |of: fn(&FirstBreak) -> f64| {
        [from, to].map(|v| v.breaks.iter().map(of).collect::<Vec<f64>>())
    };
    let weights = from.sampled.weights(from.breaks.len());
    let error = |values: [Vec<f64>; 2], apart: [f64; 2], slopes| match paired {
        true => error_of_pairs(&values, &weights, slopes),
        false => error_apart([from, to], apart, slopes),
    };
    let of_force =
        |slopes| error(values(|b| b.at.force), [from.force.error, to.force.error], slopes);
    let apart = [from.deflection.error, to.deflection.error];
    let [before, after] = [from.force.mean, to.force.mean];
    let used = |force: f64| utilisation(question, force);
    Some(CheckChange {
        force: KnownValue { value: after - before, error: of_force([1.0, 1.0]) },
        deflection: KnownValue {
            value: to.deflection.mean - from.deflection.mean,
            error: error(values(|b| b.at.deflection), apart, [1.0, 1.0]),
        },
        // Utilisation is some load over the force: to the first order it moves by -u/F a newton.
        utilisation: used(before)
            .zip(used(after))
            .map(|(u, v)| KnownValue { value: v - u, error: of_force([u / before, v / after]) }),
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
    let stand = |v: &CheckResult| v.sampled.weights(v.breaks.len());
    whole(a) && whole(b) && a.runs == b.runs && a.wanted == b.wanted && stand(a) == stand(b)
}

/// Standard error of slope 1 times the second mean less slope 0 times the first, from pairs of runs. The
/// pairs count as if they were drawn at random, which is rather too much than too little.
fn error_of_pairs(values: &[Vec<f64>; 2], weights: &[f64], slopes: [f64; 2]) -> Option<f64> {
    let [from, to] = values;
    let pairs: Vec<f64> = from.iter().zip(to).map(|(a, b)| slopes[1] * b - slopes[0] * a).collect();
    if pairs.len() < 2 {
        return None;
    }
    let n = pairs.len() as f64;
    let mean = pairs.iter().sum::<f64>() / n;
    let squares: f64 = pairs.iter().map(|v| (v - mean) * (v - mean)).sum();
    let shares: f64 = weights.iter().map(|w| w * w).sum();
    Some((squares / (n - 1.0) * shares).sqrt())
}

/// The same from two results that know nothing of each other, with these standard errors.
fn error_apart(both: [&CheckResult; 2], errors: [f64; 2], slopes: [f64; 2]) -> Option<f64> {
    let known = both.iter().all(|v| v.breaks.len() > 1);
    known.then(|| (slopes[0] * errors[0]).hypot(slopes[1] * errors[1]))
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
        let equal = [1.0 / 3.0; 3];
        assert!(close(error_of_pairs(&values, &equal, [1.0, 1.0]), (1.0_f64 / 3.0).sqrt()));
        // Twice the first: -9, -18, -27 have the error 9/sqrt 3.
        assert!(close(error_of_pairs(&values, &equal, [2.0, 1.0]), (81.0_f64 / 3.0).sqrt()));
        // Weights 1/2, 1/4, 1/4: squares of 3/8 together.
        let uneven = [0.5, 0.25, 0.25];
        assert!(close(error_of_pairs(&values, &uneven, [1.0, 1.0]), 0.375_f64.sqrt()));
        assert_eq!(error_of_pairs(&[vec![1.0], vec![2.0]], &[1.0], [1.0, 1.0]), None);
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
        // Another spacing, another net under the plates: the errors are those of two means.
        assert!(!c.paired);
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
        // The same plates in the same net: pairs of runs.
        let bigger = checks(&[base.with(Input::Punch, 0.45)], &wanted, 1, &|_| Flow::Continue);
        let pairs = change(a, bigger[0].as_ref().unwrap(), &base.question).unwrap();
        assert!(pairs.paired && pairs.force.error.unwrap() > 0.0);
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
