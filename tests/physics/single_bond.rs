//! One bond on the published path: pulled to half its ultimate elongation, unloaded until slack,
//! pulled to rupture. By the law itself, by the plain solver, and by the fast solver's own kernel.

use crate::{published, table};
use meshcast::dem::fast::{DomeHeights, Kernel, NetState, Path};
use meshcast::dem::inertia::PairInertia;
use meshcast::dem::lattice::{Role, bond_number};
use meshcast::dem::law::{BondCurve, Law};
use meshcast::dem::plain::{Damping, Plain, PlainBond, PlainNet};
use meshcast::dem::{Scene, Test};
use meshcast::mesh::laws;
use meshcast::mesh::wire::WireData;

/// A published path of one bond.
struct Published {
    role: Role,
    /// Unloaded length, m.
    length: f64,
    /// Elongation, m; force, N; permanent elongation, m (nothing once broken); whether it holds.
    rows: Vec<[f64; 4]>,
    /// Largest force, N.
    peak: f64,
}

/// The two published paths.
///
/// The tables print nine digits, which is not enough next to rupture: the last elongation that held
/// and the one found broken are put in as the scene file of these runs has them.
fn paths() -> [Published; 2] {
    let load = |role, length, text: &str, held: f64, broken: f64| {
        let mut rows: Vec<[f64; 4]> =
            table(text).iter().map(|r| [r[0], r[1], r[3], r[4]]).collect();
        let first_broken = rows.iter().position(|r| r[3] == 0.0).unwrap();
        for (row, exact) in [(first_broken - 1, held), (first_broken, broken)] {
            assert!((rows[row][0] - exact).abs() < 1e-10, "row {row} is not the one meant");
            rows[row][0] = exact;
        }
        let peak = rows.iter().map(|r| r[1]).fold(0.0, f64::max);
        Published { role, length, rows, peak }
    };
    [
        load(
            Role::Right,
            0.04 * 2.0_f64.sqrt(),
            include_str!("../data/single_bond_sw.csv"),
            0.019_789_090_378_289_86,
            0.019_798_989_873_226_473,
        ),
        load(
            Role::Twist,
            0.04,
            include_str!("../data/single_bond_dt.csv"),
            0.005_599_999_999_994_498,
            0.005_602_799_999_994_493,
        ),
    ]
}

fn curve(law: &Law, role: Role) -> &BondCurve {
    if role == Role::Twist { &law.twist } else { &law.single }
}

/// Asked for: 1e-6 of the peak force. Nine printed digits allow about 4e-8.
const TOLERANCE: f64 = 1.0e-6;

/// Compares forces row by row; returns the largest difference over the peak force.
fn compare(path: &Published, forces: &[f64], tolerance: f64, who: &str) -> f64 {
    let mut worst = 0.0_f64;
    for (row, (expected, force)) in path.rows.iter().zip(forces).enumerate() {
        let error = (force - expected[1]).abs() / path.peak;
        assert!(
            error <= tolerance,
            "{who}, {:?}, row {row}, elongation {} m: {force} N, published {} N ({error:.1e} of \
             the peak, allowed {tolerance:.0e})",
            path.role,
            expected[0],
            expected[1]
        );
        worst = worst.max(error);
    }
    assert_eq!(forces.len(), path.rows.len());
    worst
}

#[test]
fn the_published_paths_load_unload_until_slack_reload_and_break() {
    for path in paths() {
        let slack = path.rows.iter().filter(|r| r[3] == 1.0 && r[0] > 0.0 && r[1] == 0.0).count();
        let back = path.rows.windows(2).filter(|w| w[1][0] < w[0][0]).count();
        assert!(slack > 20 && back > 100, "{slack} slack rows, {back} unloading rows");
        assert_eq!(path.rows.iter().filter(|r| r[3] == 0.0).count(), 1);
        assert!(path.rows.len() > 2200);
    }
}

#[test]
fn the_law_gives_the_published_forces_and_permanent_elongations() {
    let law = Law::new(&laws::yade());
    for path in paths() {
        let curve = curve(&law, path.role);
        let ramp = curve.full(0.0);
        let stiffness = ramp.unloading / path.length;
        let mut top = 0.0_f64;
        let mut forces = Vec::new();
        for row in &path.rows {
            let e = row[0] / path.length;
            top = top.max(e);
            forces.push(curve.force(&ramp, top, e));
            let broken = top > curve.rupture();
            assert_eq!(broken, row[3] == 0.0, "breaks at another row than published: {row:?}");
            if !broken {
                // Where the unloading line from the largest elongation meets zero. Tolerance: the
                // elongation that the tolerance of the force is, at the elastic stiffness.
                let permanent = (top - curve.envelope(&ramp, top) / ramp.unloading) * path.length;
                let allowed = TOLERANCE * path.peak / stiffness;
                assert!((permanent - row[2]).abs() <= allowed, "{permanent} m, row {row:?}");
            }
        }
        let worst = compare(&path, &forces, TOLERANCE, "law");
        println!("law, {:?}: {worst:.1e} of the peak force over {} rows", path.role, forces.len());
    }
}

#[test]
fn the_elastic_stiffnesses_are_the_published_ones() {
    let law = Law::new(&laws::yade());
    // As the scene files have them; the ninth digit of the area they were made with is the tolerance.
    for (path, published) in paths().iter().zip([13_157_875.659_434_14, 37_216_092.419_181_2]) {
        let ours = curve(&law, path.role).unloading / path.length;
        assert!((ours / published - 1.0).abs() < 1e-9, "{ours} N/m, published {published} N/m");
    }
}

#[test]
fn a_bond_in_the_plain_solver_gives_the_published_forces() {
    let law = Law::new(&laws::yade());
    for path in paths() {
        let curve = curve(&law, path.role).clone();
        // Two nodes that no force moves; only the upper one counts as a support. The rest length
        // points along z, so the support force is the bond's force, downwards.
        let bond = PlainBond {
            a: 0,
            b: 1,
            rest: [0.0, 0.0, path.length],
            taut: path.length,
            ramp: curve.full(0.0),
            curve: 0,
            number: 0,
        };
        let net = PlainNet {
            places: vec![[0.0; 3], [0.0, 0.0, path.length]],
            fixed: vec![false, true],
            inertia: vec![PairInertia::default()],
            bonds: vec![bond],
            curves: vec![curve],
        };
        let mut plain = Plain::new(net, Damping::Viscous(0.0));
        let mut forces = Vec::new();
        for row in &path.rows {
            plain.moved[1][2] = row[0];
            forces.push(-plain.step(0.0).1);
        }
        let worst = compare(&path, &forces, TOLERANCE, "plain solver");
        println!("plain solver, {:?}: {worst:.1e} of the peak force", path.role);
    }
}

/// How the fast kernel is told to unload.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Unloading {
    True,
    Soft,
}

/// Forces, N, of one bond in the fast kernel at these elongations, m.
///
/// A net of which no node has mobility: its nodes stand where they are put. A wire of the last row,
/// or that row's twist, is stretched along itself; its forces stay in a buffer of their own.
fn kernel<R: Kernel>(
    wire: WireData,
    role: Role,
    elongations: &[f64],
    how: Unloading,
    path: Path,
    single_values: bool,
) -> Vec<f64> {
    let scene = Scene::new(&published(Test::Anchored, wire)).unwrap();
    let (single, twist) = (&scene.law.single, &scene.law.twist);
    let unloading = match how {
        Unloading::True => [single.unloading, twist.unloading],
        Unloading::Soft => [single.steepest(), twist.steepest()],
    };
    let still = vec![PairInertia::default(); scene.lattice.pairs()];
    let mut state = NetState::<R>::new(&scene, &still, unloading, 1.0);
    let (row, column) = (scene.lattice.rows - 1, 5);
    if single_values {
        // The path for bonds that differ, with values that happen not to.
        state.take_bonds_one_by_one();
    }
    let rest = scene.lattice.rest(role);
    let length = scene.length(role);
    let along = [rest[0] / length, rest[1] / length];
    let far = DomeHeights { cap: -100.0, ring: -100.0 };
    elongations
        .iter()
        .map(|u| {
            // A twist: its top node goes up. A wire: its pair goes back as a whole, for the other
            // end is the neighbour's.
            let (ends, sign) = if role == Role::Twist { (1..2, 1.0) } else { (0..2, -1.0) };
            for end in ends {
                state.put(end, row, column, [sign * u * along[0], sign * u * along[1], 0.0]);
            }
            R::run(&mut state, path, 1, &|_| far);
            let force = state.force_in_last_row(role, column);
            (0..2).map(|k| force[k] * along[k]).sum()
        })
        .collect()
}

#[test]
fn the_fast_kernel_gives_the_published_forces_in_double_precision() {
    // The true slope, and the soft one too: a wire without slack has a ramp as steep as its elastic
    // line, and no bond unloads with less than its ramp, or it would give back more than it took.
    for published in paths() {
        let elongations: Vec<f64> = published.rows.iter().map(|r| r[0]).collect();
        for how in [Unloading::True, Unloading::Soft] {
            for path in Path::available() {
                for single_values in [false, true] {
                    let (law, role) = (laws::yade(), published.role);
                    let forces = kernel::<f64>(law, role, &elongations, how, path, single_values);
                    let who = format!("{path:?}, {how:?}, single values {single_values}");
                    let worst = compare(&published, &forces, TOLERANCE, &who);
                    println!("{who}, {role:?}: {worst:.1e} of the peak force");
                }
            }
        }
    }
}

#[test]
fn the_fast_kernel_stays_within_its_bound_in_single_precision() {
    // Strains are good to 2e-6 (inverse square root 7e-7, a few roundings of 6e-8 each); at the
    // elastic slope over the peak force that is 4.6e-4 for wire and twist.
    for published in paths() {
        let elongations: Vec<f64> = published.rows.iter().map(|r| r[0]).collect();
        let law = Law::new(&laws::yade());
        let bound = 2.0e-6 * curve(&law, published.role).unloading / published.peak;
        assert!(bound < 5.0e-4, "{bound}");
        let (law, role) = (laws::yade(), published.role);
        let forces = kernel::<f32>(law, role, &elongations, Unloading::True, Path::best(), false);
        // The row before rupture holds or not by a part in 1e12, which single precision cannot tell.
        let end = forces.len() - 2;
        let cut = Published { rows: published.rows[..end].to_vec(), ..published };
        let worst = compare(&cut, &forces[..end], bound, "single precision");
        assert_eq!(forces[forces.len() - 1], 0.0, "{role:?} must be broken in the last row");
        println!("single precision, {role:?}: {worst:.1e} of the peak force");
    }
}

/// Elongations: up to half of `last`, down to nothing, up to a little beyond `last`.
fn there_and_back(last: f64) -> Vec<f64> {
    let n = 1000;
    let part = |k: usize| last * k as f64 / n as f64;
    (0..=n / 2).chain((0..n / 2).rev()).chain(1..=n + 1).map(part).collect()
}

#[test]
fn soft_unloading_changes_nothing_on_loading_and_carries_more_within_its_bound_on_unloading() {
    // With slack (the bench law) the soft slope k_s, the steepest of the loading curve, takes effect.
    // Its own bound follows from the law: at the largest strain both carry F_top; going back the
    // true law is slack after F_top/k_0, where the soft one has lost k_s F_top/k_0. So the soft law
    // carries more, by (1 - k_s/k_0) F_top at most, and exactly that where the true law goes slack.
    let law = Law::new(&laws::bench());
    for role in [Role::Twist, Role::Right] {
        let curve = curve(&law, role);
        let scene = Scene::new(&published(Test::Anchored, laws::bench())).unwrap();
        let slack = scene.slack(bond_number(0, role));
        let (length, taut) = (scene.length(role), scene.length(role) + slack);
        let ramp = curve.full(-slack / taut);
        assert!(curve.steepest() > ramp.slope, "the soft slope has no effect on this bond");
        let elongations = there_and_back(curve.rupture() * taut + slack);
        let soft =
            kernel::<f64>(laws::bench(), role, &elongations, Unloading::Soft, Path::best(), false);
        let (mut top, mut most, mut same) = (ramp.start, 0.0_f64, 0);
        // Rounding of strains near 1e-16 at the elastic slope, with two digits to spare.
        let rounding = 1.0e-14 * curve.unloading;
        for (u, soft) in elongations.iter().zip(&soft) {
            let e = (length + u) / taut - 1.0;
            let loading = e >= top;
            top = top.max(e);
            let full = curve.force(&ramp, top, e);
            let more = soft - full;
            if loading {
                assert!(more.abs() <= rounding, "loading at {u} m: {soft} N, law {full} N");
                same += 1;
            } else {
                let high = curve.envelope(&ramp, top);
                let bound = (1.0 - curve.steepest() / curve.unloading) * high;
                assert!(more >= -rounding && more <= bound + rounding, "{u} m: {soft} {full}");
                most = most.max(more / bound);
            }
        }
        assert!(same > 900, "{same} rows of first loading");
        // Steps of 1/1000 of the path come within a tenth of the elastic range of the worst point.
        assert!(most > 0.9, "the bound is not reached: {most}");
        println!(
            "{role:?}: same on {same} rows of loading; on unloading up to {:.3} of the bound, which \
             is {:.3} of the force unloaded from",
            most,
            1.0 - curve.steepest() / curve.unloading
        );
    }
}
