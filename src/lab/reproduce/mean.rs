//! Mean curves of a campaign's runs of one scene.

use super::MeanCurve;
use crate::curve::{Curve, Point};
use crate::lab::campaign::row::{Kind, Row};
use crate::study::ensemble::Spread;

/// Mean of the runs of a kind at equal parts of each one's way to its first break, as a check has it.
pub(super) fn curve(rows: &[Row], kind: Kind) -> MeanCurve {
    let runs: Vec<([f64; 2], &Vec<f64>)> = rows
        .iter()
        .filter(|row| row.kind == kind)
        .filter_map(|row| Some((row.values()?, &row.curve)))
        .collect();
    let points = runs.iter().map(|(_, curve)| curve.len()).min().unwrap_or_default();
    let mut mean = MeanCurve::default();
    for k in 0..points {
        let forces: Vec<f64> = runs.iter().map(|([force, _], curve)| force * curve[k]).collect();
        let way = runs.iter().map(|([_, deflection], _)| deflection).sum::<f64>();
        let force = Spread::of(&forces, &forces);
        mean.curve.deflection.push(way / runs.len() as f64 * k as f64 / (points - 1) as f64);
        mean.curve.force.push(force.mean);
        mean.band[0].push(force.band[0]);
        mean.band[1].push(force.band[1]);
    }
    mean.curve.failure = last(&mean.curve);
    mean
}

fn last(curve: &Curve) -> Option<Point> {
    curve.points().last()
}
