//! Stability: no silent early break in scenes of any kind, and none that goes unnoticed.

use crate::spec;
use meshcast::dem::dome::CONTACT_STIFFNESS;
use meshcast::dem::fast::{Fast, FastOptions, Path, stiffest, unloading};
use meshcast::dem::fidelity::Scheme;
use meshcast::dem::hash::uniform;
use meshcast::dem::inertia::{PairInertia, StepFactors, pairs};
use meshcast::dem::lattice::{Role, bond_of};
use meshcast::dem::run::drive;
use meshcast::dem::stability::Eigenvalues;
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{
    Arrangement, Controls, Fidelity, Flow, RunOutcome, Scene, SceneSpec, Stop, Test, check,
};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::laws;
use meshcast::words::Choice;

/// Scene number `k` of an endless row of random ones: layouts in and around the published ranges,
/// both tests, four laws, any alignment.
fn random_scene(k: u64) -> SceneSpec {
    let draw = |n: u64, low: f64, high: f64| low + (high - low) * uniform(1000 + k, n);
    let test = if draw(0, 0.0, 1.0) < 0.7 { Test::Anchored } else { Test::Laboratory };
    let spacing = draw(1, 1.25, 3.2);
    let plate = draw(2, 0.16, 0.48);
    let punch = draw(3, 0.1, 0.9).min(spacing - plate - 0.3);
    let reach = (spacing - plate - punch) / 2.0 - 0.1;
    let (ex, ey) = (draw(4, -1.0, 1.0) * reach.max(0.0), draw(5, -1.0, 1.0) * reach.max(0.0));
    let mut wire = match (draw(6, 0.0, 4.0)) as usize {
        0 => laws::bench(),
        1 => laws::yade(),
        _ => laws::reference(),
    };
    wire.distortion.lambda_f = if draw(7, 0.0, 1.0) < 0.2 { 0.6 } else { 1.0 };
    SceneSpec {
        layout: Layout { plate, spacing, punch, ex, ey, ..REFERENCE },
        test,
        wire,
        phase: [draw(8, 0.0, 1.0), draw(9, 0.0, 1.0)],
        seed: k,
        arrangement: Arrangement::default(),
    }
}

fn quick_controls(step_factor: f64) -> Controls {
    Controls { fidelity: Fidelity::Quick, step_factor, after_break: 0.0, ..Controls::default() }
}

fn quick(spec: &SceneSpec, step_factor: f64) -> RunOutcome {
    check(spec, &quick_controls(step_factor), &mut |_| Flow::Continue).unwrap()
}

/// Largest eigenvalue of M^-1 K of a net with its nodes at `nodes`, all bonds at the stiffness
/// `stiff`, and the dome's contact on the nodes within a millimetre of it: power iteration.
fn eigenvalue(
    scene: &Scene,
    nodes: &[[f64; 3]],
    deflection: f64,
    stiff: &[f64],
    inertia: &[PairInertia],
    rise: &[f64],
) -> f64 {
    let lattice = &scene.lattice;
    let mut springs = Vec::new();
    for number in scene.bond_numbers() {
        let (pair, role) = bond_of(number);
        let up = lattice.upper(pair / lattice.columns, pair % lattice.columns, role);
        let (a, b) = match up {
            Some((row, column)) if role != Role::Twist => {
                (2 * pair + 1, 2 * (row * lattice.columns + column))
            }
            _ => (2 * pair, 2 * pair + 1),
        };
        let mut d = [0, 1, 2].map(|k| nodes[b][k] - nodes[a][k]);
        for (along, size) in d.iter_mut().zip(lattice.size) {
            *along -= size * (*along / size).round();
        }
        let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
        springs.push((a, Some(b), d.map(|x| x / length), stiff[number]));
    }
    for (node, place) in nodes.iter().enumerate() {
        let [x, y] = scene.from_axis([place[0], place[1]]);
        let (depth, normal) = scene.dome.depth([x, y, place[2]], deflection);
        if depth > -0.001 && x.hypot(y) < scene.dome.diameter / 2.0 + scene.dome.node {
            springs.push((node, None, normal, CONTACT_STIFFNESS));
        }
    }
    let start = |node: u64| [0, 1, 2].map(|k| uniform(k, node) - 0.5);
    let mut x: Vec<[f64; 3]> = (0..nodes.len() as u64).map(start).collect();
    let mut value = 0.0;
    for _ in 0..400 {
        let mut force = vec![[0.0; 3]; x.len()];
        for (a, b, d, k) in &springs {
            let other = b.map_or([0.0; 3], |b| x[b]);
            let pull = k * (0..3).map(|c| d[c] * (x[*a][c] - other[c])).sum::<f64>();
            for c in 0..3 {
                force[*a][c] += pull * d[c];
                if let Some(b) = b {
                    force[*b][c] -= pull * d[c];
                }
            }
        }
        for (pair, m) in inertia.iter().enumerate() {
            for c in 0..3 {
                let factor = if c == 2 { 1.0 / rise[pair] } else { 1.0 };
                let [b, t] = [force[2 * pair][c], force[2 * pair + 1][c]];
                x[2 * pair][c] = factor * (m.own[0] * b + m.cross * t);
                x[2 * pair + 1][c] = factor * (m.own[1] * t + m.cross * b);
            }
        }
        value = x.iter().flatten().map(|v| v * v).sum::<f64>().sqrt();
        x.iter_mut().flatten().for_each(|v| *v /= value);
    }
    value
}

#[test]
fn the_computed_bound_stands_above_the_eigenvalue_of_deformed_nets() {
    let factors = StepFactors { translation: 1.1, stretching: 0.65 };
    for test in [Test::Anchored, Test::Laboratory] {
        for (wire, full, fitted) in [
            (laws::bench(), false, false),
            (laws::bench(), false, true),
            (laws::reference(), false, false),
            (laws::reference(), false, true),
            (laws::yade(), false, false),
            (laws::yade(), false, true),
            (laws::reference(), true, false),
        ] {
            let scene = Scene::new(&spec(test, 1.6, wire)).unwrap();
            let stiff = stiffest(&scene, unloading(&scene.law, full));
            let inertia = pairs(&scene.lattice, &scene.fixed, &|n| stiff[n], factors);
            let bound = Eigenvalues::of_scene(&scene, full, factors);
            // Stepped well within any bound, so that the states are true ones.
            let slow = StepFactors { translation: 0.7, stretching: 0.5 };
            let options = FastOptions {
                factors: slow,
                damping: 0.002,
                true_unloading: false,
                fitted,
                path: Path::best(),
            };
            let mut fast = Fast::<f32>::new(&scene, options);
            let at = |fast: &Fast<f32>| {
                let (nodes, rise) = (fast.positions(), fast.rise());
                eigenvalue(&scene, &nodes, fast.deflection(), &stiff, &inertia, &rise)
            };
            let flat = at(&fast);
            let mut most = flat;
            let (mut broken, mut next) = (Vec::new(), 0.1);
            while fast.broken(&mut broken) == 0 && fast.deflection() < 1.0 {
                fast.follow();
                fast.advance(16, 2.0e-4);
                if fast.deflection() > next {
                    next += 0.1;
                    most = most.max(at(&fast));
                }
            }
            most = most.max(at(&fast));
            println!(
                "{test:?}, full {full}, fitted {fitted}, {}: flat {flat:.3} ({:.3} by Lanczos), deformed up to {most:.3}, bound {:.3}",
                scene.spec.wire.source,
                bound.flat,
                bound.any_slope(fitted)
            );
            assert!(!broken.is_empty());
            assert!(most < bound.any_slope(fitted), "{most} {bound:?}");
            // The flat net's own eigenvalue: plates and edges may lower it, contact at the apex is small.
            assert!(flat < 1.01 * bound.flat, "{flat} {bound:?}");
            assert!(flat > 0.9 * bound.flat, "{flat} {bound:?}");
        }
    }
}

#[test]
fn a_step_beyond_the_bound_computed_for_the_scene_is_refused_with_that_bound() {
    for wire in [laws::bench(), laws::reference(), laws::yade()] {
        let scene = Scene::new(&spec(Test::Anchored, 1.6, wire)).unwrap();
        for fidelity in Fidelity::ALL {
            let with = |step_factor: f64| {
                let controls = Controls { fidelity: *fidelity, step_factor, ..Controls::default() };
                controls.scheme(&scene)
            };
            let own = with(1.0).unwrap();
            let bound = Eigenvalues::of_scene(&scene, own.full, own.factors);
            let largest = bound.largest_factor(own.damping, own.fitted);
            // A part in ten thousand for the rounding of the number that is named.
            assert!(largest > 0.9999, "{fidelity:?} runs beyond its bound: {largest}");
            assert!(with(largest - 0.002).is_ok());
            let problems = with(largest + 0.001).unwrap_err();
            assert_eq!(problems.len(), 1);
            assert_eq!(problems[0].field, "step_factor");
            let text = format!("{:?}", problems[0]);
            let named = format!("{:.2}", (largest - 0.005).max(1.0));
            assert!(text.contains("stability bound"), "{text}");
            assert!(text.contains(named.trim_end_matches('0')), "{text} {named}");
        }
    }
}

/// A run of the quick fidelity with its step `factor` times the scene's own stability bound.
fn beyond(scene: &Scene, own: &Scheme, factor: f64) -> RunOutcome {
    let bound =
        Eigenvalues::of_scene(scene, false, own.factors).largest_factor(own.damping, own.fitted);
    let mut scheme = *own;
    scheme.factors.translation *= factor * bound;
    scheme.factors.stretching *= factor * bound;
    let options = FastOptions {
        factors: scheme.factors,
        damping: scheme.damping,
        true_unloading: false,
        fitted: own.fitted,
        path: Path::best(),
    };
    let controls = quick_controls(1.0);
    let mut solver = Fast::<f32>::new(scene, options);
    drive(scene, &mut solver, &scheme, &controls, &mut |_| Flow::Continue)
}

/// Whether a run says of itself that it is not to be believed.
fn noticed(outcome: &RunOutcome) -> bool {
    outcome.stop == Stop::Diverged || outcome.sudden()
}

/// Runs at one step beyond the bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Beyond {
    /// Whose first break is off by 5 % in deflection or 10 % in force from that of a short step.
    wrong: usize,
    /// Of these, those that say so.
    noticed: usize,
    /// Right ones that are not believed.
    accused: usize,
    /// Steps of the longest of the noticed.
    steps: usize,
}

/// Runs of scenes at these factors of their bound, factor by factor.
fn survey_beyond(scenes: std::ops::Range<u64>, factors: &[f64]) -> Vec<Beyond> {
    let mut all = vec![Beyond::default(); factors.len()];
    for k in scenes {
        let scene = Scene::new(&random_scene(k)).unwrap();
        let own = quick_controls(1.0).scheme(&scene).unwrap();
        let sound = beyond(&scene, &own, 0.7);
        for (&factor, counts) in factors.iter().zip(&mut all) {
            let run = beyond(&scene, &own, factor);
            let wrong = match (run.first_break, sound.first_break) {
                (Some(a), Some(b)) => {
                    (a.deflection / b.deflection - 1.0).abs() > 0.05
                        || (a.force / b.force - 1.0).abs() > 0.1
                }
                (None, None) => run.stop != sound.stop,
                _ => true,
            };
            let noticed = noticed(&run);
            counts.wrong += usize::from(wrong);
            counts.noticed += usize::from(wrong && noticed);
            counts.accused += usize::from(!wrong && noticed);
            if wrong && noticed {
                counts.steps = counts.steps.max(run.cost.steps);
            }
            if wrong && !noticed {
                println!(
                    "not noticed: {k} at {factor}: {:?} {:?}, sound {:?}, {:?}",
                    run.stop, run.first_break, sound.first_break, run.quality
                );
            }
        }
    }
    all
}

#[test]
fn runs_far_beyond_the_bound_are_noticed() {
    let all = survey_beyond(0..12, &[1.5, 2.0]);
    println!("{all:?}");
    for counts in all {
        // At half again the bound's step nothing is right, and nothing may pass for it.
        assert_eq!((counts.wrong, counts.noticed, counts.accused), (12, 12, 0));
        // Growth is by a factor in every step; the account is looked at every 64 steps at most.
        assert!(counts.steps < 6_000, "{counts:?}");
    }
}

/// `cargo test --release --test physics -- --ignored --nocapture beyond_the_bound`
#[test]
#[ignore = "a minute: 100 scenes at seven steps in and beyond their bound"]
fn runs_beyond_the_bound_are_noticed_or_right() {
    let factors = [0.9, 1.0, 1.1, 1.2, 1.3, 1.5, 2.0];
    let all = survey_beyond(0..100, &factors);
    for (factor, counts) in factors.iter().zip(&all) {
        println!("{factor} of the bound, 100 runs: {counts:?}");
    }
    // From a fifth beyond the bound on, what is wrong is not passed off as right but for a scene or two
    // in a hundred whose break depends on a millimetre anyway.
    for counts in &all[3..] {
        assert!(counts.wrong - counts.noticed <= 2, "{counts:?}");
    }
}

/// Runs scenes at their own step and at 0.8 of it: an early break by instability would be gone there.
/// Tells how many differ by more than a quarter in deflection, and how many diverged; says how many
/// were repeated because their break came suddenly.
fn survey(scenes: std::ops::Range<u64>) -> (usize, usize) {
    let (mut early, mut diverged, mut repeated) = (0, 0, 0);
    for k in scenes {
        let spec = random_scene(k);
        let (own, short) = (quick(&spec, 1.0), quick(&spec, 0.8));
        diverged += usize::from(own.stop == Stop::Diverged);
        repeated += usize::from(own.repeated);
        if own.stop == Stop::Diverged {
            println!("{k} diverged: {:?} {:?} {:?}", own.first_break, own.quality, spec.layout);
        }
        if let (Some(a), Some(b)) = (own.first_break, short.first_break)
            && a.deflection < 0.75 * b.deflection
        {
            early += 1;
            println!("{k}: {a:?} {b:?} {:?}", spec.layout);
        }
    }
    println!("{early} early, {diverged} diverged, {repeated} repeated with a shorter step");
    (early, diverged)
}

#[test]
fn random_scenes_neither_diverge_nor_break_early() {
    assert_eq!(survey(0..25), (0, 0));
}

/// `cargo test --release --test physics -- --ignored --nocapture two_thousand`
#[test]
#[ignore = "minutes: two thousand scenes, two runs each"]
fn two_thousand_random_scenes_neither_diverge_nor_break_early() {
    assert_eq!(survey(0..2000), (0, 0));
}
