//! Scenes that broke the check: found by random scenes, kept so that they stay mended.

use crate::spec;
use meshcast::dem::{Controls, Fidelity, Flow, RunOutcome, Scene, SceneSpec, Stop, Test, check};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::{catalogue, wire::WireData};

fn wire() -> WireData {
    catalogue::reference().wire.clone().expect("the reference mesh has wires")
}

fn run(spec: &SceneSpec, fidelity: Fidelity) -> RunOutcome {
    let controls = Controls { fidelity, ..Controls::default() };
    check(spec, &controls, &mut |_| Flow::Continue).unwrap()
}

/// Symptom: the reference fidelity called a sound run diverged. Cause: its step, in double precision with
/// the true unloading, is beyond the net's bound in this scene, and only runs that broke too early were
/// tried again with a shorter one.
#[test]
fn a_run_that_runs_away_is_tried_again_with_a_shorter_step() {
    let layout = Layout {
        plate: 0.31945,
        spacing: 2.6615,
        punch: 0.43049,
        ex: 0.81248,
        ey: 1.13082,
        ..REFERENCE
    };
    // Seeds of runs follow from that of the ensemble; this is its first.
    let seed = 9171199645645008479;
    let scene =
        SceneSpec { layout, seed, phase: [0.2143, 0.5376], ..spec(Test::Anchored, 3.0, wire()) };
    let best = run(&scene, Fidelity::Reference);
    assert!(best.repeated && best.stop == Stop::AfterBreak, "{:?}", best.stop);
    // Another fidelity, in single precision with other damping, speed and step: apart by less than the
    // 1 % that fine may be off.
    let (a, b) = (best.first_break.unwrap(), run(&scene, Fidelity::Fine).first_break.unwrap());
    assert!(
        (a.force / b.force - 1.0).abs() < 0.01 && (a.deflection / b.deflection - 1.0).abs() < 0.01
    );
}

/// Symptom: a net of an opening of a micrometre aborted on allocation, one of 0.1 mm ran for minutes.
#[test]
fn a_net_of_too_many_nodes_is_refused_before_it_is_built() {
    let mut wires = wire();
    wires.net.opening = 1.0e-6;
    let refused = |spec: &SceneSpec| Scene::new(spec).unwrap_err()[0].to_string();
    let said = refused(&spec(Test::Anchored, 3.0, wires.clone()));
    assert!(said.contains("opening") && said.contains("0.005 m"), "{said}");
    // In the ranges of each length, and too many together: 30 m over 10 mm, three thousand columns.
    let net = &mut wires.net;
    (net.opening, net.twist, net.projection) = (0.01, 0.005, 0.005);
    for test in [Test::Anchored, Test::Laboratory] {
        let said = refused(&spec(test, 30.0, wires.clone()));
        assert!(
            said.contains("nodes is too large") && said.contains("up to 300000 nodes"),
            "{said}"
        );
        assert!(said.contains("a run of this net would take about"), "{said}");
    }
    // A single block on a large mesh needs many, and has them.
    assert!(Scene::new(&spec(Test::Anchored, 29.0, wire())).is_ok());
}

/// Symptom: a block of a micrometre ran for hours, because the punch went as slowly as it was small.
#[test]
fn a_run_without_an_end_in_sight_is_refused_with_the_time_it_would_take() {
    let of = |punch: f64| {
        let mut tiny = spec(Test::Anchored, 3.0, wire());
        tiny.layout.punch = punch;
        // Near a plate, where the punch still does.
        (tiny.layout.ex, tiny.layout.ey) = (1.0, 1.0);
        let scene = Scene::new(&tiny).unwrap();
        Controls { fidelity: Fidelity::Quick, ..Controls::default() }.scheme(&scene)
    };
    let said = of(1.0e-6).unwrap_err()[0].to_string();
    assert!(said.starts_with("D = ") && said.contains(" h"), "{said}");
    assert!(of(0.02).is_ok());
}

/// A row of numbers that looks random.
struct Chance(u64);

impl Chance {
    fn part(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.part() * choices.len() as f64) as usize]
    }

    fn one_in(&mut self, count: u32) -> bool {
        self.part() * f64::from(count) < 1.0
    }
}

/// Wires of another geometry, or with one absurd value.
fn wild_wire(chance: &mut Chance) -> WireData {
    let mut wire = wire();
    let net = &mut wire.net;
    if chance.one_in(3) {
        net.opening = chance.between(0.05, 0.15);
        net.twist = chance.between(0.02, 0.06);
        net.projection = chance.between(0.02, 0.06);
        net.diameter = chance.between(0.002, 0.004);
        wire.distortion.lambda_u = chance.between(0.0, 0.3);
        wire.distortion.lambda_f = chance.between(0.05, 1.0);
    } else if chance.one_in(2) {
        let odd =
            chance.of(&[0.0, 1e-320, 1e-12, 1e-6, 0.01, 0.5, 5.0, 1e6, 1e300, -1.0, f64::NAN]);
        let place = chance.of(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
        match place {
            0 => net.opening = odd,
            1 => net.twist = odd,
            2 => net.projection = odd,
            3 => net.diameter = odd,
            4 => net.node_mass = odd,
            5 => net.node_radius = odd,
            6 => wire.distortion.lambda_u = odd,
            7 => wire.distortion.lambda_f = odd,
            8 => wire.single[0].1 = odd,
            _ => wire.double_twist[0].0 = odd,
        }
    }
    wire
}

/// A scene that somebody may ask for, sane or not; it is refused, or ends with numbers that are numbers.
fn wild(seed: u64) -> Option<RunOutcome> {
    let mut chance = Chance(seed);
    for _ in 0..8 {
        chance.part();
    }
    let spacing =
        if chance.one_in(5) { chance.of(&[0.3, 0.5, 3.0, 6.0]) } else { chance.between(1.0, 2.0) };
    let punch = match chance.one_in(4) {
        true => chance.of(&[0.05, 0.1, 0.95 * spacing, spacing, 5.0, 1e-9]),
        false => spacing * chance.between(0.2, 0.5),
    };
    let plate = match chance.one_in(4) {
        true => chance.of(&[0.01, 0.9 * spacing, spacing, 0.05, 1e-6]),
        false => spacing * chance.between(0.1, 0.3),
    };
    let (ex, ey) = match chance.one_in(3) {
        true => (spacing * chance.between(-0.5, 0.5), spacing * chance.between(-0.5, 0.5)),
        false => (0.0, 0.0),
    };
    let test = if chance.one_in(5) { Test::Laboratory } else { Test::Anchored };
    let wire = wild_wire(&mut chance);
    let phase = [chance.part(), chance.part()];
    let mut scene = SceneSpec { seed, phase, ..spec(test, spacing, wire) };
    scene.layout = Layout { plate, spacing, punch, ex, ey, ..REFERENCE };
    let mut controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
    if chance.one_in(6) {
        controls.step_factor = chance.of(&[0.5, 0.9, 1.1, 3.0, 0.0, f64::NAN]);
    }
    if chance.one_in(6) {
        controls.speed = Some(chance.of(&[0.001, 0.01, 1.0, 50.0, -1.0]));
    }
    if chance.one_in(6) {
        controls.damping = Some(chance.of(&[0.0, 0.01, 0.5, 1.0]));
    }
    if chance.one_in(6) {
        controls.limit = Some(chance.of(&[0.001, 0.1, 1e-9, 100.0]));
    }
    // What is right and slow is ended after so many windows; that is an end like another.
    let mut windows = 0;
    let told = &mut |_: &_| {
        windows += 1;
        if windows > 1_500 { Flow::Cancel } else { Flow::Continue }
    };
    check(&scene, &controls, &mut |now| told(&now)).ok()
}

fn attack(scenes: std::ops::Range<u64>) {
    let (mut refused, mut broke) = (0, 0);
    for seed in scenes.clone() {
        let Some(outcome) = wild(seed) else {
            refused += 1;
            continue;
        };
        let numbers = [outcome.peak.force, outcome.peak.deflection, outcome.energy];
        assert!(numbers.iter().all(|v| v.is_finite()), "scene {seed}: {:?}", outcome.peak);
        let curve = outcome.curve.force.iter().chain(&outcome.curve.deflection);
        assert!(outcome.stop == Stop::Diverged || curve.copied().all(f64::is_finite), "{seed}");
        if let Some(first) = outcome.first_break {
            broke += 1;
            assert!(first.force > 0.0 && first.deflection > 0.0, "scene {seed}: {first:?}");
            assert!(first.force.is_finite() && first.deflection.is_finite(), "scene {seed}");
        }
    }
    println!("{} scenes, {refused} refused, {broke} with a break", scenes.end - scenes.start);
    assert!(refused > 0 && broke > 0);
}

#[test]
fn wild_scenes_are_refused_or_end_with_numbers() {
    attack(0..40);
}

#[test]
#[ignore = "an attack of minutes: cargo test --test physics wild -- --ignored --nocapture"]
fn a_thousand_wild_scenes_are_refused_or_end_with_numbers() {
    attack(1_000..2_000);
}
