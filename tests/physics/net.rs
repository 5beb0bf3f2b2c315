//! The net that a scene is made of: counts of the published scenes, alignment, stretch.

use crate::published;
use meshcast::dem::fast::{Fast, FastOptions, Path};
use meshcast::dem::inertia::StepFactors;
use meshcast::dem::lattice::{Lattice, Role, bond_of};
use meshcast::dem::stepper::{StepBlock, Stepper};
use meshcast::dem::{Scene, Test};
use meshcast::mesh::laws;
use serde_json::Value;

fn scenes() -> [(Test, Value); 2] {
    let read = |text: &str| serde_json::from_str(text).unwrap();
    [
        (Test::Anchored, read(include_str!("../data/anchored_v02.json"))),
        (Test::Laboratory, read(include_str!("../data/lab_v1_facets72x30.json"))),
    ]
}

/// End nodes of a bond, 2 pair for the bottom and 2 pair + 1 for the top.
fn ends(lattice: &Lattice, number: usize) -> [usize; 2] {
    let (pair, role) = bond_of(number);
    if role == Role::Twist {
        return [2 * pair, 2 * pair + 1];
    }
    let (up, side) = lattice.upper(pair / lattice.columns, pair % lattice.columns, role).unwrap();
    [2 * pair + 1, 2 * (up * lattice.columns + side)]
}

#[test]
fn nodes_bonds_and_lengths_are_those_of_the_published_scenes() {
    for (test, file) in scenes() {
        let scene = Scene::new(&published(test, laws::yade())).unwrap();
        let count = |key: &str| file[key].as_u64().unwrap() as usize;
        let bonds: Vec<usize> = scene.bond_numbers().collect();
        let twists = bonds.iter().filter(|n| bond_of(**n).1 == Role::Twist).count();
        let fixed: Vec<bool> = scene.fixed.iter().flatten().copied().collect();
        assert_eq!(scene.lattice.nodes(), count("n_nodes"), "{test:?}");
        assert_eq!(bonds.len(), count("n_bonds"), "{test:?}");
        assert_eq!(scene.lattice.bonds(), count("n_bonds"), "{test:?}");
        assert_eq!(twists, count("n_double"), "{test:?}");
        assert_eq!(bonds.len() - twists, count("n_single"), "{test:?}");
        assert_eq!(fixed.iter().filter(|f| **f).count(), count("n_fixed"), "{test:?}");
        let mut degree = vec![0; fixed.len()];
        let mut with_a_free_end = 0;
        for &number in &bonds {
            let [a, b] = ends(&scene.lattice, number);
            degree[a] += 1;
            degree[b] += 1;
            with_a_free_end += usize::from(!(fixed[a] && fixed[b]));
        }
        assert_eq!(with_a_free_end, count("n_bonds_with_a_free_end"), "{test:?}");
        // Every free node has three bonds, as many nodes as published.
        let three = degree.iter().zip(&fixed).filter(|(d, f)| **d == 3 && !**f).count();
        assert_eq!(three as u64, file["free_node_degree"]["3"].as_u64().unwrap(), "{test:?}");
        assert_eq!(three, fixed.iter().filter(|f| !**f).count(), "{test:?}");
        // Lengths to the rounding of the published ones, which were measured from positions.
        for (key, ours) in [
            ("len_double", scene.lattice.twist_length()),
            ("len_single", scene.lattice.wire_length()),
        ] {
            let published = file[key][0].as_f64().unwrap();
            assert!((ours / published - 1.0).abs() < 1e-12, "{test:?} {key}: {ours} {published}");
        }
    }
}

/// Nodes of a periodic net as (x, y, top or bottom, fixed), taken into the cell and sorted, in
/// micrometres: differences of rounding vanish, of the net do not.
fn inside(scene: &Scene) -> Vec<(i64, i64, bool, bool)> {
    let lattice = &scene.lattice;
    let micro = |x: f64| (x / lattice.size[0]).rem_euclid(1.0) * lattice.size[0] * 1e6;
    let cell = (lattice.size[0] * 1e6).round() as i64;
    let mut nodes = Vec::new();
    for row in 0..lattice.rows {
        for column in 0..lattice.columns {
            let held = scene.fixed[row * lattice.columns + column];
            for (end, p) in
                [lattice.bottom(row, column), lattice.top(row, column)].into_iter().enumerate()
            {
                let [x, y] = p.map(|x| (micro(x).round() as i64).rem_euclid(cell));
                nodes.push((x, y, end == 1, held[end]));
            }
        }
    }
    nodes.sort_unstable();
    nodes
}

fn aligned(phase: [f64; 2]) -> Scene {
    let mut spec = published(Test::Anchored, laws::yade());
    // Off the centre, so that no symmetric position amplifies rounding.
    (spec.layout.ex, spec.layout.ey) = (0.05, -0.03);
    spec.phase = phase;
    Scene::new(&spec).unwrap()
}

#[test]
fn alignment_is_periodic_and_half_a_period_in_both_directions_is_the_same_net() {
    let net = inside(&aligned([0.125, 0.25]));
    // Rows alternate by half an opening, so half a period in x and y together changes nothing...
    assert_eq!(net, inside(&aligned([0.625, 0.75])));
    // ...and in one of them alone it does.
    assert_ne!(net, inside(&aligned([0.625, 0.25])));
    assert_ne!(net, inside(&aligned([0.125, 0.75])));
    // Just below a whole period is nearly none: 1e-10 of a period is far below a micrometre.
    assert_eq!(inside(&aligned([0.0, 0.125])), inside(&aligned([1.0 - 1e-10, 0.125])));
    assert_eq!(inside(&aligned([0.125, 0.0])), inside(&aligned([0.125, 1.0 - 1e-10])));
}

#[test]
fn the_same_net_under_another_alignment_gives_the_same_forces() {
    let forces = |phase: [f64; 2]| {
        let options = FastOptions {
            factors: StepFactors { translation: 1.0, stretching: 0.8 },
            damping: 0.002,
            true_unloading: true,
            fitted: false,
            path: Path::best(),
        };
        let mut fast = Fast::<f64>::new(&aligned(phase), options);
        (0..50).map(|_| fast.advance(20, 1.0e-4)).collect::<Vec<_>>()
    };
    let (one, other) = (forces([0.125, 0.25]), forces([0.625, 0.75]));
    let another = forces([0.625, 0.25]);
    let largest = |of: &[StepBlock], to: &[StepBlock]| {
        let gap = |(a, b): (&StepBlock, &StepBlock)| {
            (a.punch - b.punch).abs().max((a.support - b.support).abs())
        };
        of.iter().zip(to).map(gap).fold(0.0, f64::max)
    };
    let most = one.iter().map(|b| b.punch).fold(0.0, f64::max);
    let (same, different) = (largest(&one, &other), largest(&one, &another));
    println!(
        "forces up to {most:.0} N; same net {same:.1e} N apart, another net {different:.1e} N"
    );
    assert!(most > 100.0, "the punch must have met the net: {most} N");
    // Another order of rows and sums: rounding of 1e-16 m against a contact of 6.5e5 N/m, grown
    // over 1000 steps; a net that is not the same differs by newtons.
    assert!(same < 1e-6 * most, "the same net gives forces {same} N apart");
    assert!(different > 1e-3 * most, "another net gives forces only {different} N apart");
}

#[test]
fn stretch_meets_the_panel_with_a_whole_number_of_meshes() {
    let net = laws::yade().net;
    // Worked by hand: openings of 80 mm; periods of 160 mm along the twists; a panel of n columns
    // and m rows is 80 (n - 1/2) wide and 80 (m - 1) + 40 high.
    for (size, columns, rows, stretch) in [
        (3.04, 38, 38, [1.0, 1.0]),
        (3.0, 38, 38, [3.0 / 3.04, 3.0 / 3.04]), // 37.5 openings: up; 18.75 periods: 19
        (1.3, 16, 16, [1.3 / 1.28, 1.3 / 1.28]),
        (1.34, 17, 16, [1.34 / 1.36, 1.34 / 1.28]),
        (2.0, 25, 26, [1.0, 2.0 / 2.08]),
    ] {
        let lattice = Lattice::periodic(&net, size, [0.0, 0.0]);
        assert_eq!((lattice.columns, lattice.rows), (columns, rows), "cell of {size} m");
        for (ours, by_hand) in lattice.stretch.iter().zip(stretch) {
            assert!((ours - by_hand).abs() < 1e-12, "cell of {size} m: {:?}", lattice.stretch);
        }
        let width = lattice.columns as f64 * lattice.opening;
        let height = lattice.rows as f64 * lattice.pitch();
        assert!((width - size).abs() < 1e-12 && (height - size).abs() < 1e-12);
    }
    for (size, columns, rows, stretch) in
        [(3.0, 38, 38, [1.0, 1.0]), (2.5, 32, 32, [2.5 / 2.52, 2.5 / 2.52])]
    {
        let lattice = Lattice::panel(&net, size);
        assert_eq!((lattice.columns, lattice.rows), (columns, rows), "panel of {size} m");
        for (ours, by_hand) in lattice.stretch.iter().zip(stretch) {
            assert!((ours - by_hand).abs() < 1e-12, "panel of {size} m: {:?}", lattice.stretch);
        }
    }
}
