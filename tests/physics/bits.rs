//! The same bits whatever the instruction set and the caller's threads.

use crate::small_spec;
use meshcast::dem::fast::{Fast, FastOptions, Kernel, Path};
use meshcast::dem::inertia::StepFactors;
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{Controls, Fidelity, Flow, Scene, SceneSpec, Test};
use meshcast::mesh::laws;
use meshcast::study::ensemble::{Plan, run};

fn positions<R: Kernel>(spec: &SceneSpec, path: Path) -> (Vec<u64>, usize) {
    let scene = Scene::new(spec).unwrap();
    let factors = StepFactors { translation: 1.15, stretching: 0.8 };
    let options = FastOptions { factors, damping: 0.002, true_unloading: false, path };
    let mut fast = Fast::<R>::new(&scene, options);
    let mut bits = Vec::new();
    for _ in 0..150 {
        let block = fast.advance(12, 2.0e-4);
        bits.extend([block.punch.to_bits(), block.support.to_bits()]);
    }
    bits.extend(fast.positions().iter().flatten().map(|x| x.to_bits()));
    let mut broken = Vec::new();
    fast.broken(&mut broken);
    (bits, broken.len())
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let mut broken = 0;
    for test in [Test::Anchored, Test::Laboratory] {
        // 15, 16, 21 and 25 columns: rows that end within, at and behind a vector.
        for spacing in [1.2, 1.28, 1.7, 2.0] {
            for wire in [laws::bench(), laws::reference()] {
                let mut spec = small_spec(test, wire);
                spec.layout.spacing = spacing;
                let single = positions::<f32>(&spec, Path::Portable);
                let double = positions::<f64>(&spec, Path::Portable);
                broken += single.1;
                for path in Path::available() {
                    assert!(positions::<f32>(&spec, path) == single, "{path:?} {spacing} {test:?}");
                    assert!(positions::<f64>(&spec, path) == double, "{path:?} {spacing} {test:?}");
                }
            }
        }
    }
    assert!(broken > 0, "no run came to a break: the test would not see one");
}

#[test]
fn every_number_of_threads_gives_the_same_ensemble() {
    let spec = small_spec(Test::Anchored, laws::reference());
    let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
    let with = |threads: usize| {
        let plan = Plan { threads, seed: 9, ..Plan::default() };
        let mut e = run(&spec, &controls, &plan, &|_| Flow::Continue).unwrap();
        for run in &mut e.runs {
            (run.wall, run.processor) = (0.0, 0.0); // Times are no part of the answer.
        }
        e
    };
    let one = with(1);
    assert!(one.runs.len() >= 8);
    assert!(one == with(2) && one == with(5));
}

/// A regression test: bits of an earlier run of our own, to see a change of profile or compiler.
#[test]
fn the_bits_are_those_of_an_earlier_run() {
    let (bits, _) = positions::<f32>(&small_spec(Test::Anchored, laws::reference()), Path::best());
    let digest = bits
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ b).wrapping_mul(0x0000_0100_0000_01b3));
    assert_eq!(digest, 0, "{digest:#x}");
}
