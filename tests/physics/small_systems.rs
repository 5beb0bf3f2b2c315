//! Small systems by the plain solver, against closed forms and conservation laws.

use crate::small;
use meshcast::dem::hash::uniform;
use meshcast::dem::inertia::{PairInertia, StepFactors};
use meshcast::dem::lattice::{Role, bond_of};
use meshcast::dem::law::BondCurve;
use meshcast::dem::plain::{Damping, Inertia, Plain, PlainBond, PlainNet};
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{Scene, Test};
use meshcast::mesh::laws;
use meshcast::mesh::wire::{CurvePoint, Slack, WireData};

/// Force per unit of strain of the elastic bonds here, N.
const STIFF: f64 = 1000.0;

/// A bond law that is straight to a strain of 1, far beyond these tests.
fn elastic() -> BondCurve {
    BondCurve::new(&[CurvePoint(1.0, STIFF)], 1.0e-6, 1.0)
}

/// Nodes at `places`, of which `fixed` stay, with elastic bonds between the given nodes, unloaded at
/// `unloaded` of the distance, and the inertia `mass` (N/m) of each node.
fn net(
    places: &[[f64; 3]],
    fixed: &[usize],
    bonds: &[[usize; 2]],
    unloaded: f64,
    mass: f64,
) -> PlainNet {
    let mut places = places.to_vec();
    if places.len() % 2 == 1 {
        places.push([9.0, 9.0, 0.0]); // Nodes come in pairs: an idle one.
    }
    let held: Vec<bool> = (0..places.len()).map(|n| fixed.contains(&n)).collect();
    let own = |n: usize| if held[n] { 0.0 } else { 1.0 / mass };
    let curve = elastic();
    PlainNet {
        inertia: (0..places.len() / 2)
            .map(|p| PairInertia { own: [own(2 * p), own(2 * p + 1)], cross: 0.0 })
            .collect(),
        bonds: bonds
            .iter()
            .enumerate()
            .map(|(number, &[a, b])| {
                let rest = [0, 1, 2].map(|k| places[b][k] - places[a][k]);
                let taut = unloaded * norm(rest);
                PlainBond { a, b, rest, taut, ramp: curve.full(0.0), curve: 0, number }
            })
            .collect(),
        curves: vec![curve],
        places,
        fixed: held,
    }
}

fn norm(x: [f64; 3]) -> f64 {
    (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt()
}

/// Where a rising function of the deflection is `target`, by bisection on 0 to `high`.
fn solve(target: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let mut low = 0.0;
    assert!(f(high) > target);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < target { low = middle } else { high = middle }
    }
    low
}

/// Vertical pull of a straight elastic rope of unloaded length `length` that spans `span` and sags `w`.
fn pull(span: f64, length: f64, w: f64) -> f64 {
    let l = (span * span + w * w).sqrt();
    (STIFF * (l / length - 1.0)).max(0.0) * w / l
}

/// Steps until nothing moves any more, under a constant load; returns the last support force.
fn settle(plain: &mut Plain, steps: usize) -> f64 {
    let mut support = 0.0;
    for _ in 0..steps {
        support = plain.step(0.0).1;
    }
    let fastest = plain.velocity.iter().map(|v| norm(*v)).fold(0.0, f64::max);
    assert!(fastest < 1e-13, "not at rest: {fastest} m a step");
    support
}

/// Relative error allowed at rest: motion below 1e-13 m a step leaves 1e-10 of sags of centimetres.
const AT_REST: f64 = 1.0e-9;

#[test]
fn a_rope_of_bonds_under_a_point_load_is_a_force_triangle() {
    // Taut when straight, and with 3 % of slack: below the sag that takes it up it carries nothing.
    for unloaded in [1.0, 1.03] {
        for half in [1, 4] {
            let n = 2 * half;
            let places: Vec<[f64; 3]> = (0..=n).map(|k| [k as f64 / n as f64, 0.0, 0.0]).collect();
            let bonds: Vec<[usize; 2]> = (0..n).map(|k| [k, k + 1]).collect();
            let mass = 4.0 * STIFF * n as f64;
            let net = net(&places, &[0, n], &bonds, unloaded, mass);
            let mut plain = Plain::new(net, Damping::Viscous(0.01));
            plain.load[half] = [0.0, 0.0, 20.0];
            let support = settle(&mut plain, 60_000);
            // Each half is straight, from the end to the middle: 2 F sin = load.
            let w = solve(20.0, 1.0, |w| 2.0 * pull(0.5, 0.5 * unloaded, w));
            let ours = plain.moved[half][2];
            println!("rope of {n} bonds, unloaded {unloaded}: {ours:.9} m, by hand {w:.9} m");
            assert!((ours / w - 1.0).abs() < AT_REST, "{n} bonds: {ours} m, by hand {w} m");
            assert!((support / 20.0 - 1.0).abs() < AT_REST, "{support} N carry 20 N");
            for (k, node) in plain.moved.iter().enumerate().take(half) {
                let line = w * k as f64 / half as f64;
                assert!((node[2] - line).abs() < AT_REST * w, "node {k}: {} {line}", node[2]);
            }
        }
    }
}

#[test]
fn a_symmetric_cross_of_bonds_shares_the_load_by_the_closed_form() {
    let (a, b) = (0.3, 0.5);
    let places = [[0.0; 3], [a, 0.0, 0.0], [-a, 0.0, 0.0], [0.0, b, 0.0], [0.0, -b, 0.0]];
    let bonds = [[0, 1], [2, 0], [0, 3], [4, 0]];
    let net = net(&places, &[1, 2, 3, 4], &bonds, 1.0, 4.0 * STIFF / a);
    let mut plain = Plain::new(net, Damping::Viscous(0.02));
    plain.load[0] = [0.0, 0.0, 50.0];
    let support = settle(&mut plain, 30_000);
    let w = solve(50.0, 1.0, |w| 2.0 * pull(a, a, w) + 2.0 * pull(b, b, w));
    let ours = plain.moved[0];
    println!("cross: {:.9} m, by hand {w:.9} m", ours[2]);
    assert!((ours[2] / w - 1.0).abs() < AT_REST, "{} m, by hand {w} m", ours[2]);
    assert!(ours[0].abs() < 1e-15 && ours[1].abs() < 1e-15, "leaves its axis: {ours:?}");
    assert!((support / 50.0 - 1.0).abs() < AT_REST, "{support} N carry 50 N");
}

/// Largest change of the energy of a swinging rope over its energy, with a step of `part` of the
/// longest one tried here.
///
/// Velocities belong to the middle between two positions, so the kinetic energy at a position is
/// the mean of those before and after it, which is right to the second order of the step.
fn drift(part: f64) -> f64 {
    let n = 6;
    let places: Vec<[f64; 3]> = (0..=n).map(|k| [k as f64 / n as f64, 0.0, 0.0]).collect();
    let bonds: Vec<[usize; 2]> = (0..n).map(|k| [k, k + 1]).collect();
    // Unloaded at 0.9 of the length: always in tension, so nothing here is lost in slack.
    let net = net(&places, &[0, n], &bonds, 0.9, 12.0 * STIFF * n as f64 / (part * part));
    let mut plain = Plain::new(net, Damping::Viscous(0.0));
    for k in 1..n {
        plain.moved[k] = [0.0, 0.0, 0.02 * (k as f64 * std::f64::consts::PI / n as f64).sin()];
    }
    plain.moved[2][1] = 0.01;
    let (mut first, mut worst) = (None, 0.0_f64);
    for _ in 0..(1000.0 / part) as usize {
        let before = plain.energies();
        plain.step(0.0);
        let energy = before.bonds + 0.5 * (before.kinetic + plain.energies().kinetic);
        // The state at rest at the start stands for a velocity half a step late; skip it.
        let first = *first.get_or_insert(energy);
        worst = worst.max((energy / first - 1.0).abs());
    }
    worst
}

#[test]
fn a_free_oscillation_keeps_its_energy_to_the_second_order_of_the_step() {
    let (one, half, quarter) = (drift(1.0), drift(0.5), drift(0.25));
    let orders = [(one / half).log2(), (half / quarter).log2()];
    println!("energy drift {one:.2e}, {half:.2e}, {quarter:.2e}: orders {orders:.3?}");
    // Central differences: order 2. A tenth for the next order, which is still seen at these steps.
    assert!(orders.iter().all(|o| (o - 2.0).abs() < 0.1), "{orders:?}");
    assert!(one < 1e-2 && one > 1e-6, "{one}");
}

#[test]
fn a_free_net_keeps_its_momentum_and_its_spin() {
    // Thirty nodes anywhere, bonds between many of them, pulled and slack, thrown about. Then the
    // same with coupled pairs, whose momentum has both nodes' velocities in each part.
    for cross in [0.0, 0.3] {
        let nodes = 30;
        let draw = |k: usize| uniform(11, k as u64) - 0.5;
        let places: Vec<[f64; 3]> =
            (0..nodes).map(|n| [0, 1, 2].map(|k| draw(3 * n + k))).collect();
        let bonds: Vec<[usize; 2]> =
            (0..nodes).flat_map(|a| [1, 4, 9].map(|s| [a, (a + s) % nodes])).collect();
        let mut net = net(&places, &[], &bonds, 0.9, 1.0);
        let mass = 3.0e5;
        for pair in &mut net.inertia {
            *pair = PairInertia { own: [1.0 / mass; 2], cross: cross / mass };
        }
        let inverse = 1.0 / (1.0 - cross * cross);
        let momentum = |plain: &Plain| {
            let mut sum = [0.0; 6];
            let mut size = 0.0;
            for pair in 0..nodes / 2 {
                for end in 0..2 {
                    let (own, other) =
                        (plain.velocity[2 * pair + end], plain.velocity[2 * pair + 1 - end]);
                    let p = [0, 1, 2].map(|k| mass * inverse * (own[k] - cross * other[k]));
                    let node = 2 * pair + end;
                    let x = [0, 1, 2].map(|k| plain.net.places[node][k] + plain.moved[node][k]);
                    for k in 0..3 {
                        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                        sum[k] += p[k];
                        sum[3 + k] += x[i] * p[j] - x[j] * p[i];
                    }
                    size += norm(p);
                }
            }
            (sum, size)
        };
        let mut plain = Plain::new(net, Damping::Viscous(0.0));
        for n in 0..nodes {
            plain.velocity[n] = [0, 1, 2].map(|k| 1.0e-3 * draw(1000 + 3 * n + k));
        }
        let (start, size) = momentum(&plain);
        let before = plain.velocity.clone();
        for _ in 0..5000 {
            plain.step(0.0);
        }
        let (end, _) = momentum(&plain);
        // 5000 steps, each rounding sixty momenta at 1e-16 of themselves: below 1e-12 of their sum.
        for k in 0..3 {
            let change = (end[k] - start[k]).abs() / size;
            assert!(change < 1e-12, "momentum {k} changes by {change:.1e}");
            // Bonds pull along themselves, so spin stays too; not with coupled pairs, which are a
            // numerical device and not bodies.
            let spin = (end[3 + k] - start[3 + k]).abs() / size;
            assert!(cross > 0.0 || spin < 1e-12, "spin {k} changes by {spin:.1e}");
        }
        let moved = plain.velocity.iter().zip(&before).map(|(a, b)| (a[0] - b[0]).abs());
        assert!(moved.fold(0.0, f64::max) > 1e-4, "nothing pulled: the test would see nothing");
    }
}

#[test]
fn at_rest_the_supports_carry_the_punch() {
    for test in [Test::Anchored, Test::Laboratory] {
        let scene = Scene::new(&small(test, laws::bench())).unwrap();
        let factors = StepFactors { translation: 1.0, stretching: 0.8 };
        let mut plain = Plain::of_scene(&scene, Inertia::Pairs(factors), Damping::Viscous(0.01));
        plain.advance(2000, 1.0e-4);
        let last = {
            plain.advance(20_000, 0.0);
            plain.advance(1, 0.0)
        };
        println!("{test:?}: punch {} N, supports {} N", last.punch, last.support);
        assert!(last.punch > 1000.0, "{test:?}: the net must carry something: {last:?}");
        // Held for 20,000 steps of 1 % damping; what still moves is below a millionth of the force.
        assert!((last.support / last.punch - 1.0).abs() < 1e-6, "{test:?}: {last:?}");
    }
}

/// A bond along z between two nodes that no force moves; `stretch` sets its elongation.
struct Rig(Plain);

impl Rig {
    fn new(bond: &PlainBond, curve: &BondCurve, length: f64) -> Rig {
        let rest = [0.0, 0.0, length];
        let bond = PlainBond { a: 0, b: 1, rest, curve: 0, ..bond.clone() };
        let net = PlainNet {
            places: vec![[0.0; 3], rest],
            fixed: vec![false, true],
            inertia: vec![PairInertia::default()],
            bonds: vec![bond],
            curves: vec![curve.clone()],
        };
        Rig(Plain::new(net, Damping::Viscous(0.0)))
    }

    /// Force of the bond at elongation `u`, N.
    fn stretch(&mut self, u: f64) -> f64 {
        self.0.moved[1][2] = u;
        -self.0.step(0.0).1
    }
}

/// A wire and a twist of a small scene of `wire`, with their curves and unloaded lengths.
fn bonds_of(wire: WireData) -> Vec<(PlainBond, BondCurve, f64, f64)> {
    let scene = Scene::new(&small(Test::Laboratory, wire)).unwrap();
    let plain = Plain::of_scene(&scene, Inertia::Uniform(1.0), Damping::Viscous(0.0));
    let of = |role: Role| {
        let bond = plain.net.bonds.iter().find(|b| bond_of(b.number).1 == role).unwrap();
        let slack = scene.slack(bond.number);
        (bond.clone(), plain.net.curves[bond.curve].clone(), scene.length(role), slack)
    };
    vec![of(Role::Right), of(Role::Left), of(Role::Twist)]
}

#[test]
fn a_bond_pulls_and_never_pushes() {
    for (bond, curve, length, slack) in bonds_of(laws::bench()) {
        assert!(slack > 0.0);
        let mut rig = Rig::new(&bond, &curve, length);
        for u in [-0.5 * length, -1e-3 * length, 0.0] {
            let force = rig.stretch(u);
            assert!(force.abs() <= 1e-9, "{force} N at {u} m"); // 1e-16 of strain at the ramp's slope
        }
        // Pulled beyond its elastic range, then shorter than its permanent elongation: nothing left.
        let high = rig.stretch(slack + 0.02 * length);
        assert!(high > 1000.0);
        let gone = high / (bond.ramp.unloading / bond.taut);
        assert!(rig.stretch(slack + 0.02 * length - 0.99 * gone) > 0.0);
        for u in [slack + 0.02 * length - 1.01 * gone, 0.0, -0.1 * length] {
            assert_eq!(rig.stretch(u), 0.0, "at {u} m");
        }
        assert!((rig.stretch(slack + 0.02 * length) / high - 1.0).abs() < 1e-12);
    }
}

#[test]
fn slack_and_the_first_point_shift_the_curve_as_defined() {
    for lambda_f in [1.0, 0.6] {
        for t in [0.0, 0.5, 1.0] {
            let mut wire = laws::bench();
            wire.distortion.lambda_f = lambda_f;
            wire.distortion.slack = Slack::Fixed(t);
            let area = std::f64::consts::PI * wire.net.diameter * wire.net.diameter / 4.0;
            let data = [wire.single.clone(), wire.single.clone(), wire.double_twist.clone()];
            let areas = [area, area, 2.0 * area];
            for (k, (bond, curve, length, slack)) in bonds_of(wire).into_iter().enumerate() {
                // The definition, worked anew: delta_l = lambda_u l0 T; points u_k = delta_l +
                // eps_k (l0 + delta_l) and F_k = sigma_k A; with lambda_F < 1 a first point at
                // delta_l + lambda_F eps_1 (l0 + delta_l) and lambda_F F_1.
                let delta = 0.03 * length * t;
                assert!((slack - delta).abs() < 1e-15, "{slack} {delta}");
                let mut points = vec![(0.0, 0.0)];
                let at = |strain: f64| delta + strain * (length + delta);
                if lambda_f < 1.0 {
                    let p = data[k][0];
                    points.push((at(lambda_f * p.0), lambda_f * p.1 * 1e6 * areas[k]));
                }
                points.extend(data[k].iter().map(|p| (at(p.0), p.1 * 1e6 * areas[k])));
                let most = points[points.len() - 1].1;
                let mut rig = Rig::new(&bond, &curve, length);
                for w in points.windows(2) {
                    for part in [0.001, 0.25, 0.5, 0.999_999] {
                        let u = w[0].0 + part * (w[1].0 - w[0].0);
                        let by_hand = w[0].1 + part * (w[1].1 - w[0].1);
                        let force = rig.stretch(u);
                        // Strains round at 2e-16, against the elastic slope and the peak: 1e-13.
                        assert!(
                            (force - by_hand).abs() < 1e-12 * most,
                            "lambda_F {lambda_f}, T {t}: {force} N at {u} m, by hand {by_hand} N"
                        );
                    }
                }
                let last = points[points.len() - 1].0;
                assert!((rig.stretch(last * (1.0 - 1e-9)) / most - 1.0).abs() < 1e-12);
                // Beyond the last point it breaks, for good.
                let mut known = Vec::new();
                assert_eq!(rig.0.broken(&mut known), 0);
                assert_eq!(rig.stretch(last * (1.0 + 1e-9)), 0.0);
                assert_eq!(rig.0.broken(&mut known), 1);
                assert_eq!(rig.stretch(0.5 * last), 0.0);
                assert_eq!(rig.0.broken(&mut known), 0, "told twice");
            }
        }
    }
}
