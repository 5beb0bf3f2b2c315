//! The published scenes of another program, rebuilt: YADE 2023.02a, anchored at 0.2 m/s and
//! laboratory with its finer dome of 72 x 30 facets. The scene files stand beside the curves.

use crate::{published, table};
use meshcast::dem::plain::{Damping, Inertia, Plain};
use meshcast::dem::run::drive;
use meshcast::dem::{Controls, Fidelity, Flow, RunOutcome, Scene, Stop, Test, check};
use meshcast::mesh::laws;
use serde_json::Value;

/// Punch travel per step, m, of the runs here: 35,000 steps. A quarter of it changes force and
/// deflection at the first break by less than 0.1 % (the last test).
const TRAVEL: f64 = 2.0e-5;

/// (displacement, mean force) of a published curve up to `end`, m and N. A row's mean is over the
/// time since the row before, so it stands half a row earlier.
fn curve(text: &str, end: f64) -> Vec<(f64, f64)> {
    let rows: Vec<(f64, f64)> = table(text).iter().map(|r| (r[0], r[2])).collect();
    let middles = rows.windows(2).map(|w| (0.5 * (w[0].0 + w[1].0), w[1].1));
    middles.filter(|p| p.0 > 0.1 && p.0 < end).collect()
}

/// Largest difference of two curves over the largest published force, and where it is.
fn gap(ours: &RunOutcome, published: &[(f64, f64)]) -> (f64, f64) {
    let (xs, ys) = (&ours.curve.deflection, &ours.curve.force);
    let most = published.iter().map(|p| p.1).fold(0.0, f64::max);
    let mut worst = (0.0, 0.0);
    for &(x, force) in published {
        let k = xs.partition_point(|&d| d < x);
        assert!(k > 0 && k < xs.len(), "our curve has no force at {x} m");
        let part = (x - xs[k - 1]) / (xs[k] - xs[k - 1]);
        let difference = (ys[k - 1] + part * (ys[k] - ys[k - 1]) - force).abs() / most;
        if difference > worst.0 {
            worst = (difference, x);
        }
    }
    worst
}

/// Figures of a run beside the published ones.
#[derive(Debug, Clone, Copy)]
struct Compared {
    /// Force at the first break, N, and over the published one, less 1.
    force: (f64, f64),
    /// Deflection there, m, and the same.
    deflection: (f64, f64),
    /// Largest difference of the curve from 0.1 m up to the earlier of both first breaks, over the
    /// largest force until there, and its deflection.
    gap: (f64, f64),
}

/// Curve and scene file of a published run.
fn texts(test: Test) -> (&'static str, &'static str) {
    match test {
        Test::Anchored => {
            (include_str!("../data/anchored_v02.csv"), include_str!("../data/anchored_v02.json"))
        }
        Test::Laboratory => (
            include_str!("../data/lab_v1_facets72x30.csv"),
            include_str!("../data/lab_v1_facets72x30.json"),
        ),
    }
}

fn compare(test: Test, ours: &RunOutcome) -> Compared {
    // First breaks as published, to three digits; the scene files have all of them.
    let (text, file) = texts(test);
    let (force, deflection) =
        if test == Test::Anchored { (30_200.0, 0.666) } else { (83_500.0, 0.691) };
    let file: Value = serde_json::from_str(file).unwrap();
    let recorded = [&file["first_break"]["F"], &file["first_break"]["delta"]];
    let recorded = recorded.map(|v| v.as_f64().unwrap());
    assert!(
        (recorded[0] / force - 1.0).abs() < 1e-3 && (recorded[1] / deflection - 1.0).abs() < 1e-3
    );
    let first = ours.first_break.unwrap();
    // Windows of ours are 2 mm wide, and the one with the break is left out: the comparison ends with
    // our last window, which must be no further than two of them from the break.
    let last = ours.curve.deflection[ours.curve.deflection.len() - 1];
    assert!(first.deflection - last < 0.004, "our curve ends at {last} m: {first:?}");
    let end = last.min(recorded[1]);
    let compared = Compared {
        force: (first.force, first.force / force - 1.0),
        deflection: (first.deflection, first.deflection / deflection - 1.0),
        gap: gap(ours, &curve(text, end)),
    };
    println!(
        "{test:?}: first break {:.3} kN ({:+.2} %) at {:.4} m ({:+.2} %), curve {:.2} % at {:.2} m, \
         {} steps",
        compared.force.0 / 1e3,
        100.0 * compared.force.1,
        compared.deflection.0,
        100.0 * compared.deflection.1,
        100.0 * compared.gap.0,
        compared.gap.1,
        ours.cost.steps
    );
    compared
}

/// The fast solver in double precision with the true unloading.
fn fast(test: Test, travel: f64) -> RunOutcome {
    let controls = Controls {
        fidelity: Fidelity::Reference,
        speed: Some(travel),
        after_break: 0.0,
        ..Controls::default()
    };
    check(&published(test, laws::yade()), &controls, &mut |_| Flow::Continue).unwrap()
}

/// Places of the broken bonds' middles, from the panel's corner, m.
fn places(test: Test, ours: &RunOutcome) -> Vec<[f64; 2]> {
    let scene = Scene::new(&published(test, laws::yade())).unwrap();
    ours.breaks.iter().map(|b| scene.lattice.middle(b.number)).collect()
}

/// The same for the published first break.
fn published_places(test: Test) -> Vec<[f64; 2]> {
    let file: Value = serde_json::from_str(texts(test).1).unwrap();
    let lost = file["first_break"]["lost"].as_array().unwrap();
    lost.iter().map(|b| [0, 1].map(|k| b["xy"][k].as_f64().unwrap())).collect()
}

/// Whether two places are one; bonds are centimetres apart.
fn same(a: [f64; 2], b: [f64; 2]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6)
}

#[test]
fn the_anchored_scene_follows_the_published_run() {
    let ours = fast(Test::Anchored, TRAVEL);
    let c = compare(Test::Anchored, &ours);
    // Bounds of 1.5 %, as asked for: the published run's dome has 48 x 16 flat facets (0.6 % against
    // finer ones) and its punch moves at 0.2 m/s with true masses, ours at rest in the limit.
    assert!(c.force.1.abs() < 0.015, "published 30.2 kN: {c:?}");
    assert!(c.deflection.1.abs() < 0.015, "published 0.666 m: {c:?}");
    assert!(c.gap.0 < 0.015, "curve: {c:?}");
    // The same wire goes first, at the corner of a plate; in exactly symmetric arithmetic its mirror
    // image about the cell's centre goes in the same block.
    let broken = published_places(Test::Anchored);
    assert_eq!(broken.len(), 1);
    let mirror = broken[0].map(|x| 3.04 - x);
    let ours = places(Test::Anchored, &ours);
    assert!(ours.iter().any(|p| same(*p, broken[0])), "broke at {ours:?}, published {broken:?}");
    assert!(ours.iter().all(|p| same(*p, broken[0]) || same(*p, mirror)), "broke at {ours:?}");
}

#[test]
fn the_laboratory_scene_follows_the_published_run() {
    let ours = fast(Test::Laboratory, TRAVEL);
    let c = compare(Test::Laboratory, &ours);
    // 2.5 % in force and 1.5 % in deflection and curve, as asked for: 1 to 2 % of facet error remains
    // in the published peak (a smooth dome, as ours, gives about 82.5 kN at 0.685 m there).
    assert!(c.force.1.abs() < 0.025, "published 83.5 kN: {c:?}");
    assert!(c.deflection.1.abs() < 0.015, "published 0.691 m: {c:?}");
    assert!(c.gap.0 < 0.015, "curve: {c:?}");
    // The same two wires go first, mirror images about the centre.
    let (broken, ours) = (published_places(Test::Laboratory), places(Test::Laboratory, &ours));
    assert_eq!((broken.len(), ours.len()), (2, 2), "broke at {ours:?}, published {broken:?}");
    for place in &broken {
        assert!(ours.iter().any(|p| same(*p, *place)), "broke at {ours:?}, published {broken:?}");
    }
}

/// A flat net without slack asks most of the step: all bonds have the elastic stiffness that sets the
/// inertia. With step factors of 1.15 and 0.8 together this diverged.
#[test]
fn the_fine_fidelity_follows_the_published_runs() {
    for test in [Test::Anchored, Test::Laboratory] {
        let controls =
            Controls { fidelity: Fidelity::Fine, after_break: 0.0, ..Controls::default() };
        let spec = published(test, laws::yade());
        let ours = check(&spec, &controls, &mut |_| Flow::Continue).unwrap();
        assert_eq!(ours.stop, Stop::AfterBreak, "{test:?}: {:?}", ours.quality);
        let c = compare(test, &ours);
        // The bounds of the runs in full, for the same reasons.
        let force = if test == Test::Anchored { 0.015 } else { 0.025 };
        assert!(c.force.1.abs() < force && c.deflection.1.abs() < 0.015, "{test:?}: {c:?}");
        assert!(c.gap.0 < 0.015, "{test:?}: {c:?}");
    }
}

/// The plain solver as the published runs were: one mass of 3.9 g for every node, a step of 6.222 us
/// (half the critical one), local damping of 0.5, 0.2 m/s; half a million steps a scene
/// (run control slows the punch down towards the break).
fn plain(test: Test) {
    let step = 6.221_773_894_580_2e-6;
    let spec = published(test, laws::yade());
    let scene = Scene::new(&spec).unwrap();
    let mass = Inertia::Uniform(spec.wire.net.node_mass / (step * step));
    let mut plain = Plain::of_scene(&scene, mass, Damping::Local(0.5));
    let controls = Controls { after_break: 0.0, ..Controls::default() };
    let mut scheme = controls.scheme(&scene).unwrap();
    scheme.travel = 0.2 * step;
    scheme.full = true;
    let ours = drive(&scene, &mut plain, &scheme, &controls, &mut |_| Flow::Continue);
    let c = compare(test, &ours);
    // The bounds of the fast runs, for the same reasons.
    let force = if test == Test::Anchored { 0.015 } else { 0.025 };
    assert!(c.force.1.abs() < force && c.deflection.1.abs() < 0.015, "{test:?}: {c:?}");
    assert!(c.gap.0 < 0.015, "{test:?}: {c:?}");
}

/// `cargo test --release --test physics -- --ignored --nocapture plain_solver_follows`
#[test]
#[ignore = "minutes: half a million steps of the plain solver"]
fn the_plain_solver_follows_the_published_anchored_run_at_its_own_speed() {
    plain(Test::Anchored);
}

/// `cargo test --release --test physics -- --ignored --nocapture plain_solver_follows`
#[test]
#[ignore = "minutes: half a million steps of the plain solver"]
fn the_plain_solver_follows_the_published_laboratory_run_at_its_own_speed() {
    plain(Test::Laboratory);
}

/// `cargo test --release --test physics -- --ignored --nocapture a_quarter_of_the_speed`
#[test]
#[ignore = "some 30 s: both scenes at a quarter of the speed, to show that the tests' own is converged"]
fn a_quarter_of_the_speed_changes_the_first_break_by_less_than_a_thousandth() {
    for test in [Test::Anchored, Test::Laboratory] {
        let (ours, slow) = (fast(test, TRAVEL), fast(test, TRAVEL / 4.0));
        compare(test, &ours);
        compare(test, &slow);
        let (a, b) = (ours.first_break.unwrap(), slow.first_break.unwrap());
        assert!((a.force / b.force - 1.0).abs() < 1e-3, "{test:?}: {a:?} {b:?}");
        assert!((a.deflection / b.deflection - 1.0).abs() < 1e-3, "{test:?}: {a:?} {b:?}");
    }
}
