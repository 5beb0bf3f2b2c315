//! Small systems with answers in closed form, by the plain solver.

use meshcast::dem::hash::uniform;
use meshcast::dem::inertia::PairInertia;
use meshcast::dem::law::BondCurve;
use meshcast::dem::plain::{Damping, Plain, PlainBond, PlainNet};
use meshcast::dem::stepper::Stepper;
use meshcast::mesh::wire::CurvePoint;

/// A straight bond law: 1000 N per unit of strain, to far beyond these tests.
fn elastic() -> BondCurve {
    BondCurve::new(&[CurvePoint(1.0, 1000.0)], 1.0e-6, 1.0)
}

/// A net of nodes at `places`, of which `fixed` do not move, with bonds between the given pairs and
/// the inertia `mass` (N/m) for each node.
fn net(places: &[[f64; 3]], fixed: &[usize], bonds: &[[usize; 2]], mass: f64) -> PlainNet {
    let curve = elastic();
    let mut places = places.to_vec();
    if places.len() % 2 == 1 {
        places.push([9.0, 9.0, 0.0]); // Nodes come in pairs: an idle one.
    }
    let held: Vec<bool> = (0..places.len()).map(|n| fixed.contains(&n)).collect();
    let own = |n: usize| if held[n] { 0.0 } else { 1.0 / mass };
    PlainNet {
        inertia: (0..places.len() / 2)
            .map(|p| PairInertia { own: [own(2 * p), own(2 * p + 1)], cross: 0.0 })
            .collect(),
        bonds: bonds
            .iter()
            .enumerate()
            .map(|(number, &[a, b])| {
                let rest = [0, 1, 2].map(|k| places[b][k] - places[a][k]);
                let taut = rest.iter().map(|x| x * x).sum::<f64>().sqrt();
                PlainBond { a, b, rest, taut, ramp: curve.full(0.0), curve: 0, number }
            })
            .collect(),
        curves: vec![curve],
        places,
        fixed: held,
    }
}

/// Sag of the middle of two straight ropes of length `length` under the part `load` of the force that
/// each carries across: k (l/length - 1) w/l = load, by bisection.
fn sag(length: f64, load: f64) -> f64 {
    let across = |w: f64| {
        let l = (length * length + w * w).sqrt();
        1000.0 * (l / length - 1.0) * w / l
    };
    let (mut low, mut high) = (0.0, 10.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if across(middle) < load { low = middle } else { high = middle }
    }
    low
}

#[test]
fn a_rope_of_bonds_under_a_point_load_sags_as_two_straight_ropes() {
    let places: Vec<[f64; 3]> = (0..9).map(|k| [0.1 * k as f64, 0.0, 0.0]).collect();
    let bonds: Vec<[usize; 2]> = (0..8).map(|k| [k, k + 1]).collect();
    // A bond of 0.1 m has 1e4 N/m; two at a node: inertia 2e4 is twice the stability bound.
    let mut rope = Plain::new(net(&places, &[0, 8], &bonds, 2.0e4), Damping::Viscous(0.02));
    rope.load[4] = [0.0, 0.0, 50.0];
    for _ in 0..20_000 {
        rope.step(0.0);
    }
    let expected = sag(0.4, 25.0);
    // Rounding of 1e-16 m per step is all that is left after the motion has died down.
    assert!((rope.moved[4][2] - expected).abs() < 1.0e-10, "{} {expected}", rope.moved[4][2]);
    assert!((rope.moved[2][2] - expected / 2.0).abs() < 1.0e-10);
}

#[test]
fn a_symmetric_cross_carries_a_load_by_a_quarter_each() {
    let places =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
    let bonds = [[0, 1], [0, 2], [0, 3], [0, 4]];
    let mut cross = Plain::new(net(&places, &[1, 2, 3, 4], &bonds, 4.0e3), Damping::Viscous(0.05));
    cross.load[0] = [0.0, 0.0, 120.0];
    let mut support = 0.0;
    for _ in 0..5_000 {
        support = cross.step(0.0).1;
    }
    assert!((cross.moved[0][2] - sag(1.0, 30.0)).abs() < 1.0e-11);
    assert!(cross.moved[0][0].abs() < 1.0e-15 && cross.moved[0][1].abs() < 1.0e-15);
    // The fixed nodes are pulled with the whole load.
    assert!((support - 120.0).abs() < 1.0e-8, "{support}");
}

#[test]
fn a_free_oscillation_keeps_its_energy_and_its_period() {
    // One node between two fixed ones: tension on one side at a time, 1000 N/m, inertia 1e5 N/m.
    let places = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
    let mut node =
        Plain::new(net(&places, &[1, 2], &[[0, 1], [0, 2]], 1.0e5), Damping::Viscous(0.0));
    node.velocity[0][0] = 0.001;
    let energy = |n: &Plain| n.energies().bonds + n.energies().kinetic;
    let (mut least, mut most, mut crossings, mut last) = (f64::INFINITY, 0.0_f64, 0, 0);
    for step in 1..=20_000 {
        let before = node.moved[0][0];
        node.step(0.0);
        let e = energy(&node);
        (least, most) = (least.min(e), most.max(e));
        if before < 0.0 && node.moved[0][0] >= 0.0 {
            (crossings, last) = (crossings + 1, step);
        }
    }
    // Velocities stand half a step behind, so the energy swings by omega/2 = 0.05 of itself about
    // its mean (omega = sqrt(k/m) = 0.1 per step), and does not drift.
    let middle = 0.5 * (least + most);
    assert!((most - least) / middle < 0.11, "{least} {most}");
    assert!((middle / (0.5 * 1.0e5 * 1.0e-6) - 1.0).abs() < 0.06, "{middle}");
    // The scheme's own frequency: sin(omega'/2) = omega/2; a crossing is known to one step of 20,000.
    let period = 2.0 * std::f64::consts::PI / (2.0 * (0.05_f64).asin());
    assert!((last as f64 / crossings as f64 / period - 1.0).abs() < 3.0e-4);
}

#[test]
fn a_free_net_keeps_its_momentum() {
    let places: Vec<[f64; 3]> =
        (0..6).map(|k| [(k % 3) as f64 * 0.2, (k / 3) as f64 * 0.2, 0.0]).collect();
    let bonds = [[0, 1], [1, 2], [3, 4], [4, 5], [0, 3], [1, 4], [2, 5], [0, 4]];
    let mut free = Plain::new(net(&places, &[], &bonds, 3.0e4), Damping::Viscous(0.0));
    for (n, v) in free.velocity.iter_mut().enumerate() {
        *v = [0, 1, 2].map(|k| 1.0e-3 * (uniform(3, (3 * n + k) as u64) - 0.3));
    }
    let momentum = |n: &Plain, k: usize| n.velocity.iter().map(|v| v[k]).sum::<f64>();
    let before = [0, 1, 2].map(|k| momentum(&free, k));
    for _ in 0..10_000 {
        free.step(0.0);
    }
    for (k, &p) in before.iter().enumerate() {
        // Rounding: 1e4 steps of 1e-19 each in numbers of 1e-3.
        assert!((momentum(&free, k) - p).abs() < 1.0e-15, "{k}");
        assert!(p.abs() > 1.0e-5);
    }
    assert!(free.energies().bonds > 0.0);
}
