//! The mean curve of some runs and its band.
//!
//! Runs break at different deflections, so a mean force at a fixed deflection would be one of the runs
//! that still hold: it bends up where the weak ones leave. Instead each run is taken at the same parts
//! of its own way to its first break, and the means of deflection and force at each part are a point of
//! the curve. It ends exactly at the mean first break; the band, the 5 % and 95 % points of the force at
//! each part, ends at the band of the force.

use super::rounded;
use crate::curve::{Curve, Point};
use crate::dem::RunOutcome;
use crate::study::ensemble::{Run, weighted_mean};
use crate::study::sampling::{self, Placed, Sample};
use crate::units::{from_kn, to_kn};

/// Most points of a mean curve.
pub(crate) const POINTS: usize = 60;
/// Points on the way to the first break; a single run has the rest behind it.
const BEFORE: usize = 49;

/// Mean curve of the runs that broke, or where none did of all, each up to its peak; and its band,
/// empty where there is only one run.
pub(crate) fn curve(runs: &[&Run], sample: &Sample) -> (Curve, [Vec<f64>; 2]) {
    let broke: Vec<&Run> =
        runs.iter().copied().filter(|run| run.outcome.first_break.is_some()).collect();
    let slipped = broke.is_empty();
    let taken: Vec<&Run> = if slipped { runs.to_vec() } else { broke };
    let mut points = Vec::with_capacity(POINTS);
    let (mut low, mut high) = (Vec::new(), Vec::new());
    for k in 0..BEFORE {
        let part = k as f64 / (BEFORE - 1) as f64;
        let at = |run: &Run| on_its_way(&run.outcome, part);
        let forces: Vec<Placed> = taken.iter().map(|run| run.placed(at(run).force)).collect();
        let force = sampling::figures(sample, &forces, &forces);
        let deflection = weighted_mean(sample, &taken, &|run| at(run).deflection);
        points.push(Point { deflection, force: force.mean });
        low.push(force.band[0]);
        high.push(force.band[1]);
    }
    let end = points.last().copied();
    if let [one] = taken.as_slice()
        && let Some(first) = one.outcome.first_break
    {
        points.extend(behind(&one.outcome, first));
    }
    let newton = |v: f64| from_kn(rounded(to_kn(v)));
    let mut curve = Curve::default();
    for p in points {
        let deflection = rounded(p.deflection);
        // Two points that are rounded to the same deflection are one.
        if curve.deflection.last().is_none_or(|last| *last < deflection) {
            curve.deflection.push(deflection);
            curve.force.push(newton(p.force));
        }
    }
    if taken.is_empty() || curve.deflection.len() < 2 {
        return (Curve::default(), [Vec::new(), Vec::new()]);
    }
    curve.failure = end
        .filter(|_| !slipped)
        .map(|p| Point { deflection: rounded(p.deflection), force: newton(p.force) });
    let band = if taken.len() > 1 && low.len() == curve.deflection.len() {
        [low, high].map(|limit| limit.into_iter().map(newton).collect())
    } else {
        [Vec::new(), Vec::new()]
    };
    (curve, band)
}

/// A run at a part of its way to its first break, or to its peak where it has none.
fn on_its_way(outcome: &RunOutcome, part: f64) -> Point {
    let end = outcome.first_break.unwrap_or(outcome.peak);
    if part >= 1.0 {
        return end;
    }
    let deflection = part * end.deflection;
    let first = outcome.curve.points().next();
    // Before the first mean of two millimetres the force grows from nothing.
    let force = match first {
        Some(p) if deflection < p.deflection => p.force * deflection / p.deflection,
        _ => outcome.curve.force_at(deflection),
    };
    Point { deflection, force: force.max(0.0) }
}

/// The way of a run behind its first break, in as many points as are left.
fn behind(outcome: &RunOutcome, first: Point) -> Vec<Point> {
    let points: Vec<Point> =
        outcome.curve.points().filter(|p| p.deflection > first.deflection).collect();
    let every = points.len().div_ceil(POINTS - BEFORE).max(1);
    points.into_iter().step_by(every).collect()
}
