//! The published scenes of another program, rebuilt: see the scene files beside the curves.

use crate::spec;
use meshcast::dem::{Controls, Fidelity, Flow, Outcome, Test, check};
use meshcast::mesh::laws;

/// (displacement, mean force) of a published curve, in m and N. A row's mean is over the time since
/// the row before, so it stands half a row earlier.
fn published(text: &str) -> Vec<(f64, f64)> {
    let rows: Vec<(f64, f64)> = text
        .lines()
        .skip(1)
        .map(|line| {
            let mut cells = line.split(',').map(|c| c.parse::<f64>().unwrap());
            (cells.next().unwrap(), cells.nth(1).unwrap())
        })
        .collect();
    rows.windows(2).map(|w| (0.5 * (w[0].0 + w[1].0), w[1].1)).collect()
}

fn at(outcome: &Outcome, x: f64) -> f64 {
    let (xs, ys) = (&outcome.curve.deflection, &outcome.curve.force);
    let k = xs.partition_point(|&d| d < x).clamp(1, xs.len() - 1);
    ys[k - 1] + (ys[k] - ys[k - 1]) * (x - xs[k - 1]) / (xs[k] - xs[k - 1])
}

/// Largest difference of the curves between 0.1 m and `end`, over the largest force before it.
fn curve_gap(outcome: &Outcome, text: &str, end: f64) -> f64 {
    let before: Vec<(f64, f64)> =
        published(text).into_iter().filter(|p| p.0 > 0.1 && p.0 < end).collect();
    let most = before.iter().map(|p| p.1).fold(0.0, f64::max);
    before.iter().map(|p| (at(outcome, p.0) - p.1).abs()).fold(0.0, f64::max) / most
}

fn outcome(test: Test, spacing: f64, fidelity: Fidelity) -> Outcome {
    let controls = Controls { fidelity, after_break: 0.0, ..Controls::default() };
    check(&spec(test, spacing, laws::yade()), &controls, &mut |_| Flow::Continue).unwrap()
}

fn anchored(fidelity: Fidelity) {
    let ours = outcome(Test::Anchored, 3.04, fidelity);
    let p = ours.first_break.unwrap();
    let gap = curve_gap(&ours, include_str!("../data/anchored_v02.csv"), 0.664);
    println!(
        "anchored {fidelity:?}: {:.3} kN at {:.4} m, curve {:.2} %",
        p.force / 1e3,
        p.deflection,
        100.0 * gap
    );
    // Published first break: 30.2 kN at 0.666 m. Bounds: 1.5 % each, as asked for; inertia of the
    // published run at 0.2 m/s and its facets are within that.
    assert!((p.force / 30_200.0 - 1.0).abs() < 0.015, "{p:?}");
    assert!((p.deflection / 0.666 - 1.0).abs() < 0.015, "{p:?}");
    assert!(gap < 0.015, "{gap}");
    // The wire at a plate's corner goes first.
    let place = ours.breaks[0].place;
    assert!(place.iter().all(|x| (x.abs() - 1.36).abs() < 0.05), "{place:?}");
}

fn laboratory(fidelity: Fidelity) {
    let ours = outcome(Test::Laboratory, 3.0, fidelity);
    let p = ours.first_break.unwrap();
    let gap = curve_gap(&ours, include_str!("../data/lab_v1_facets72x30.csv"), 0.68);
    println!(
        "laboratory {fidelity:?}: {:.3} kN at {:.4} m, curve {:.2} %",
        p.force / 1e3,
        p.deflection,
        100.0 * gap
    );
    // Published first break: 83.5 kN at 0.691 m, of which 1 to 2 % is error of its facets (a smooth
    // dome gives about 82.5 kN at 0.685 m). Bounds: 2.5 % and 1.5 %, as asked for.
    assert!((p.force / 83_500.0 - 1.0).abs() < 0.025, "{p:?}");
    assert!((p.deflection / 0.691 - 1.0).abs() < 0.015, "{p:?}");
    assert!(gap < 0.015, "{gap}");
}

#[test]
fn the_anchored_scene_follows_yades() {
    anchored(Fidelity::Fine);
}

#[test]
fn the_laboratory_scene_follows_yades() {
    laboratory(Fidelity::Fine);
}

/// `cargo test --release --test physics -- --ignored --nocapture yade`
#[test]
#[ignore = "some 30 s: the reference fidelity on both scenes"]
fn both_scenes_follow_yades_at_reference_fidelity() {
    anchored(Fidelity::Reference);
    laboratory(Fidelity::Reference);
}
