//! Fictitious inertia: the masses that make the largest stable step as useful as possible.
//!
//! The test is quasi-static, so masses are free. Time is counted in steps; an inertia is then mass
//! over step squared, N/m, a velocity is a displacement per step, m, and an explicit step is stable
//! while the largest eigenvalue of M^-1 K is below 4.
//!
//! The two nodes of a pair are moved by their sum (the pair as a whole) and their difference (the
//! twist stretching). With `s` the mean over the two nodes of the summed stiffness of their single
//! wires (at least twice that of the stiffest), `kt` the twist's stiffness and `kn` the contact's,
//!
//! - sum mode: inertia of a node (s + kn) / (2 c^2),
//! - difference mode: (s + kt + kn) / (2 cd^2),
//!
//! so that the stiff twist costs no inertia against translation. Sharing each node's mass among its
//! bonds by their stiffness (the element bound of Irons & Treharne 1971) gives eigenvalues of at
//! most 4 c^2 if all wires of a node pull the same way; they never do, so c up to about 1.2 is
//! stable. Out of the plane wires are stiff only by the sine of their slope, and the inertia is halved.
//! Where a pair's node is fixed the other one has the inertia of the difference mode alone.

use super::dome::CONTACT_STIFFNESS;
use super::lattice::{Lattice, Role, bond_number};

/// Step factors: 1 is the bound that holds whatever the wires' directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepFactors {
    /// c, of the pair's translation; 0 to about 1.2.
    pub translation: f64,
    /// cd, of the twist's stretching; 0 to about 0.9.
    pub stretching: f64,
}

/// Least `s` over the stiffness of the stiffest wire. Between alike wires `s` is twice a wire's
/// stiffness and this changes nothing. With random slack a wire can be many times stiffer than its
/// neighbours; then no direction is left over which its stiffness could be shared.
pub(crate) const LONE_WIRE: f64 = 2.0;

/// Factor on the inertia against motion out of the net's plane.
pub const OUT_OF_PLANE: f64 = 0.5;

/// Inverse inertia of a pair in the plane, m/N: velocity changes are
/// `own[0] f_bottom + cross f_top` and `own[1] f_top + cross f_bottom`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PairInertia {
    /// Own terms of bottom and top; 0 where fixed.
    pub own: [f64; 2],
    /// Cross term; 0 where a node is fixed.
    pub cross: f64,
}

/// The same as inertia, N/m, of the sum and the difference of the velocities; of the one free node
/// alone where the other is fixed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PairModes {
    sum: f64,
    difference: f64,
    alone: [f64; 2],
}

impl PairModes {
    /// The modes of a pair.
    pub(crate) fn new(pair: &PairInertia) -> PairModes {
        match pair.own.map(|own| own > 0.0) {
            [true, true] => PairModes {
                sum: 0.25 / (pair.own[0] + pair.cross),
                difference: 0.25 / (pair.own[0] - pair.cross),
                alone: [0.0; 2],
            },
            [true, false] => PairModes { alone: [0.5 / pair.own[0], 0.0], ..Self::default() },
            [false, true] => PairModes { alone: [0.0, 0.5 / pair.own[1]], ..Self::default() },
            [false, false] => Self::default(),
        }
    }

    /// Kinetic energy, J, at the velocities (m per step) of the bottom and the top node.
    pub(crate) fn kinetic(&self, bottom: [f64; 3], top: [f64; 3]) -> f64 {
        let mut energy = 0.0;
        for axis in 0..3 {
            let factor = if axis == 2 { OUT_OF_PLANE } else { 1.0 };
            let (b, t) = (bottom[axis], top[axis]);
            let (sum, difference) = (b + t, b - t);
            energy += factor
                * (self.sum * sum * sum
                    + self.difference * difference * difference
                    + self.alone[0] * b * b
                    + self.alone[1] * t * t);
        }
        energy
    }
}

/// Inertia of every pair of `lattice`, with `stiffness(number)` the largest tangent stiffness of a
/// bond, N/m.
pub fn pairs(
    lattice: &Lattice,
    fixed: &[[bool; 2]],
    stiffness: &dyn Fn(usize) -> f64,
    factors: StepFactors,
) -> Vec<PairInertia> {
    let wires = wire_sums(lattice, stiffness);
    (0..lattice.pairs())
        .map(|pair| {
            let mean = 0.5 * (wires[pair].sum[0] + wires[pair].sum[1]);
            let s = mean.max(LONE_WIRE * wires[pair].most);
            let kt = stiffness(bond_number(pair, Role::Twist));
            let c2 = 2.0 * factors.translation * factors.translation;
            let cd2 = 2.0 * factors.stretching * factors.stretching;
            let sum = (s + CONTACT_STIFFNESS) / c2;
            let difference = (s + kt + CONTACT_STIFFNESS) / cd2;
            match fixed[pair] {
                [true, true] => PairInertia::default(),
                [true, false] => PairInertia { own: [0.0, 1.0 / difference], cross: 0.0 },
                [false, true] => PairInertia { own: [1.0 / difference, 0.0], cross: 0.0 },
                [false, false] => {
                    let own = 0.5 * (1.0 / sum + 1.0 / difference);
                    PairInertia { own: [own, own], cross: 0.5 * (1.0 / sum - 1.0 / difference) }
                }
            }
        })
        .collect()
}

/// Stiffness of the single wires at a pair, N/m.
#[derive(Debug, Clone, Copy, Default)]
struct Wires {
    /// Summed, at the bottom and at the top node.
    sum: [f64; 2],
    /// Of the stiffest.
    most: f64,
}

fn wire_sums(lattice: &Lattice, stiffness: &dyn Fn(usize) -> f64) -> Vec<Wires> {
    let mut wires = vec![Wires::default(); lattice.pairs()];
    for row in 0..lattice.rows {
        for column in 0..lattice.columns {
            let pair = row * lattice.columns + column;
            for role in [Role::Left, Role::Right] {
                if let Some((up, side)) = lattice.upper(row, column, role) {
                    let k = stiffness(bond_number(pair, role));
                    for (pair, end) in [(pair, 1), (up * lattice.columns + side, 0)] {
                        wires[pair].sum[end] += k;
                        wires[pair].most = wires[pair].most.max(k);
                    }
                }
            }
        }
    }
    wires
}
