//! The same bits whatever the instruction set and the build profile; and the fast solver beside the
//! plain one, bit for bit but for rounding.

use crate::{published, small};
use meshcast::dem::fast::{Fast, FastOptions, Kernel, Path};
use meshcast::dem::inertia::StepFactors;
use meshcast::dem::plain::{Damping, Inertia, Plain};
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{Arrangement, Scene, SceneSpec, Test};
use meshcast::mesh::laws;

const FACTORS: StepFactors = StepFactors { translation: 1.1, stretching: 0.8 };

fn solver<R: Kernel>(spec: &SceneSpec, true_unloading: bool, fitted: bool, path: Path) -> Fast<R> {
    let scene = Scene::new(spec).unwrap();
    Fast::new(
        &scene,
        FastOptions { factors: FACTORS, damping: 0.002, true_unloading, fitted, path },
    )
}

/// What a run leaves behind, to the bit: forces of every block, all positions, broken bonds.
#[derive(PartialEq)]
struct Bits {
    numbers: Vec<u64>,
    broken: Vec<usize>,
}

impl Bits {
    fn of<R: Kernel>(
        spec: &SceneSpec,
        fitted: bool,
        path: Path,
        blocks: usize,
        travel: f64,
    ) -> Bits {
        let mut fast = solver::<R>(spec, false, fitted, path);
        assert_eq!(fast.path(), path);
        let (mut numbers, mut broken) = (Vec::new(), Vec::new());
        for _ in 0..blocks {
            let added = fast.follow();
            if fitted {
                numbers.push(added.to_bits());
            }
            let block = fast.advance(12, travel);
            numbers.extend([block.punch.to_bits(), block.support.to_bits()]);
            fast.broken(&mut broken);
        }
        assert!(fast.kinetic().is_finite());
        numbers.push(fast.kinetic().to_bits());
        numbers.extend(fast.positions().iter().flatten().map(|x| x.to_bits()));
        Bits { numbers, broken }
    }

    /// FNV-1a over the numbers.
    fn digest(&self) -> u64 {
        let broken = self.broken.iter().map(|b| *b as u64);
        self.numbers
            .iter()
            .copied()
            .chain(broken)
            .fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ b).wrapping_mul(0x0000_0100_0000_01b3))
    }
}

/// The same bits on all paths; tells how many bonds broke.
fn same_on_all_paths<R: Kernel>(spec: &SceneSpec, blocks: usize, travel: f64) -> usize {
    let mut broken = 0;
    for fitted in [false, true] {
        let portable = Bits::of::<R>(spec, fitted, Path::portable(), blocks, travel);
        for path in Path::available() {
            let other = Bits::of::<R>(spec, fitted, path, blocks, travel);
            let pairs = portable.numbers.iter().zip(&other.numbers);
            let differ = pairs.filter(|(a, b)| a != b).count();
            let what = (spec.test, spec.layout.spacing, spec.wire.distortion.slack, fitted);
            assert!(
                portable == other,
                "{path:?}: {differ} of {} numbers differ from portable on {what:?}",
                portable.numbers.len()
            );
        }
        broken += portable.broken.len();
    }
    broken
}

#[test]
fn every_instruction_set_gives_the_same_bits_through_to_broken_bonds() {
    let mut broken = [0, 0];
    for test in [Test::Anchored, Test::Laboratory] {
        // 15, 16 and 21 columns: rows that end within, at and behind a vector.
        for spacing in [1.2, 1.28, 1.7] {
            for wire in [laws::bench(), laws::reference()] {
                let mut spec = small(test, wire);
                spec.layout.spacing = spacing;
                broken[0] += same_on_all_paths::<f32>(&spec, 130, 3.0e-4);
                broken[1] += same_on_all_paths::<f64>(&spec, 130, 3.0e-4);
            }
        }
    }
    println!("broken bonds in single and double precision: {broken:?}");
    assert!(broken[0] > 0 && broken[1] > 0, "no bond broke: the test would not see breaking");
}

#[test]
fn every_instruction_set_gives_the_same_bits_on_fields_of_several_cells() {
    let mut broken = 0;
    for arrangement in [Arrangement::Mirrored, Arrangement::Single(3)] {
        for wire in [laws::bench(), laws::reference()] {
            let spec = SceneSpec { arrangement, ..small(Test::Anchored, wire) };
            broken += same_on_all_paths::<f32>(&spec, 130, 3.0e-4);
            same_on_all_paths::<f64>(&spec, 40, 3.0e-4);
        }
    }
    assert!(broken > 0, "no bond broke: the test would not see breaking");
}

#[test]
fn every_instruction_set_gives_the_same_bits_on_the_published_scenes() {
    for test in [Test::Anchored, Test::Laboratory] {
        for wire in [laws::yade(), laws::reference()] {
            let spec = published(test, wire);
            same_on_all_paths::<f32>(&spec, 25, 8.0e-4);
            same_on_all_paths::<f64>(&spec, 25, 8.0e-4);
        }
    }
}

/// A regression test: digests of an earlier run of our own, taken in the test profile and equal in
/// the release profile. They change with every change of the kernel's arithmetic or of the scene;
/// then both profiles must give the new ones (`cargo test --release --test physics determinism`).
#[test]
fn the_bits_are_those_of_an_earlier_run_in_both_build_profiles() {
    let digests = [Test::Anchored, Test::Laboratory].map(|test| {
        let spec = small(test, laws::reference());
        [
            Bits::of::<f32>(&spec, false, Path::best(), 100, 3.0e-4).digest(),
            Bits::of::<f64>(&spec, false, Path::best(), 100, 3.0e-4).digest(),
            Bits::of::<f32>(&spec, true, Path::best(), 100, 3.0e-4).digest(),
        ]
    });
    let earlier: [[u64; 3]; 2] = [
        [0xc0f7_cb9a_40b4_66dd, 0xacad_18fd_a8ff_31bf, 0x943b_1a5e_751d_ad69],
        [0xbda9_5acc_5c5a_d811, 0xea2e_1e01_ccd4_0fce, 0xbef7_3966_1434_7580],
    ];
    assert_eq!(digests, earlier, "{digests:#x?}");
}

#[test]
fn the_fast_solver_in_full_is_the_plain_one_but_for_rounding() {
    for test in [Test::Anchored, Test::Laboratory] {
        for wire in [laws::bench(), laws::yade(), laws::reference()] {
            let spec = small(test, wire);
            let scene = Scene::new(&spec).unwrap();
            let mut plain =
                Plain::of_scene(&scene, Inertia::Pairs(FACTORS), Damping::Viscous(0.002));
            let mut fast = solver::<f64>(&spec, true, false, Path::best());
            let (mut most, mut apart, mut force) = (0.0_f64, 0.0_f64, 0.0_f64);
            for _ in 0..50 {
                let (a, b) = (plain.advance(12, 2.0e-4), fast.advance(12, 2.0e-4));
                most = most.max(a.punch);
                force = force.max((a.punch - b.punch).abs()).max((a.support - b.support).abs());
            }
            let mut reach = 0.0_f64;
            for (a, b) in plain.positions().iter().zip(fast.positions()) {
                reach = reach.max(a[2].abs());
                for k in 0..3 {
                    // Either may tell a node's place in a neighbouring cell.
                    let periods = if k < 2 { scene.lattice.size[k] } else { f64::INFINITY };
                    let d = a[k] - b[k];
                    let image = if scene.lattice.periodic { (d / periods).round() } else { 0.0 };
                    apart = apart.max(if image == 0.0 { d } else { d - image * periods }.abs());
                }
            }
            println!(
                "{test:?}, {:?}: nodes apart {apart:.1e} m of {reach:.3} m, forces {force:.1e} N of \
                 {most:.0} N",
                scene.law.distortion
            );
            assert!(most > 300.0 && reach > 0.05, "the punch must have met the net: {most} N");
            // Rounding of 1e-16 m a step, grown over 600 steps by contact and by corners of the law, is up to
            // 2e-12 m here, and times the contact stiffness up to 1e-6 N;
            // a wrong term anywhere is worth micrometres and newtons at once.
            assert!(apart < 1.0e-10, "nodes {apart} m apart");
            assert!(force < 1.0e-7 * most, "forces {force} N apart");
        }
    }
}
