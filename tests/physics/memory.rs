//! The kernel on nets so small that an interpreter can run it: `cargo +nightly miri test --test physics
//! memory` looks at every read and write, and with `RUSTFLAGS=-Zsanitizer=address cargo +nightly test
//! --target x86_64-unknown-linux-gnu --test physics` the machine does.

use crate::small;
use meshcast::dem::fast::{Fast, FastOptions, Path};
use meshcast::dem::inertia::StepFactors;
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{Scene, SceneSpec, Test};
use meshcast::mesh::laws;
use meshcast::mesh::wire::Slack;

/// What some steps leave behind, to the last bit, in single and in double precision.
fn left_behind(scene: &Scene, fitted: bool, path: Path) -> Vec<u64> {
    let options = FastOptions {
        factors: StepFactors { translation: 0.9, stretching: 0.8 },
        damping: 0.002,
        true_unloading: false,
        fitted,
        path,
    };
    let mut left = Vec::new();
    let mut look = |solver: &mut dyn Stepper| {
        // Deep at once, so that nodes are under the dome in the first steps.
        for _ in 0..2 {
            left.push(solver.follow().to_bits());
            let block = solver.advance(2, 0.02);
            left.extend([block.punch.to_bits(), block.support.to_bits()]);
        }
        let mut broken = Vec::new();
        solver.broken(&mut broken);
        left.push(broken.len() as u64);
        left.push(solver.energies().bonds.to_bits());
        left.extend(solver.positions().iter().flatten().map(|v| v.to_bits()));
    };
    look(&mut Fast::<f32>::new(scene, options));
    look(&mut Fast::<f64>::new(scene, options));
    left
}

#[test]
fn every_instruction_set_stays_in_its_buffers_and_gives_the_same_bits() {
    for test in [Test::Anchored, Test::Laboratory] {
        for slack in [Slack::Fixed(0.5), Slack::Triangular] {
            let mut wire = laws::reference();
            wire.distortion.slack = slack;
            let mut spec: SceneSpec = small(test, wire);
            // Rows of eight openings or so: one whole vector and a rest in each.
            (spec.layout.spacing, spec.layout.punch, spec.layout.plate) = (0.72, 0.3, 0.2);
            let scene = Scene::new(&spec).unwrap();
            for fitted in [false, true] {
                let first = left_behind(&scene, fitted, Path::portable());
                for path in Path::available() {
                    let left = left_behind(&scene, fitted, path);
                    assert_eq!(left, first, "{test:?} {slack:?} {fitted} {path:?}");
                }
            }
        }
    }
}
