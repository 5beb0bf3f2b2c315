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
//! stable. Where a pair's node is fixed the other one has the inertia of the difference mode alone.
//!
//! Out of the plane wires are stiff only by the sine of their slope, so the inertia there is another one:
//! [`OUT_OF_PLANE`] of that in the plane, or, fitted every few millimetres of punch travel, with `s2` the largest
//! square of the sine among the bonds of a pair
//!
//! - [`SLOPE`] s2 + what a flat net needs ([`rise_under_tension`]), at most [`STEEPEST`],
//! - [`rise_under_contact`] more where a dome pushes or soon will.
//!
//! A slack or flat part of the net is then light and follows the punch at once; in a steep one the wires
//! need that inertia (see [`super::stability`]).

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

/// Factor on the inertia against motion out of the net's plane, where it is not fitted to slopes.
pub const OUT_OF_PLANE: f64 = 0.5;
/// Inertia out of the plane over that in it, per square of the sine of the steepest bond: below 2.5 some
/// runs of random scenes shake, and the bound of [`super::stability`] is at 3.4.
pub(crate) const SLOPE: f64 = 3.6;
/// The same of a flat and slack net, whose slopes may grow until the next fit.
pub(crate) const FLOOR: f64 = 0.03;
/// What is added to it at a utilisation of 1, over the force of a wire at rupture to its stiffness: tension holds a
/// flat net as wires with the stiffness of their force over their length would. With it the element bound, 4 c^2
/// of that part, is 2.
pub(crate) const TENSE: f64 = 2.4;
/// The largest: a bond that is broken may stand at any slope.
pub(crate) const STEEPEST: f64 = 1.5;
/// Eigenvalue against motion out of the plane of a pair held by a dome's contact alone; below 4.
pub(crate) const CONTACT: f64 = 2.0;

/// Inertia out of the plane over that in it of a flat net at a utilisation, whose wires break under the part
/// `tension` of their stiffness against unloading.
pub(super) fn rise_under_tension(utilisation: f64, tension: f64) -> f64 {
    FLOOR + TENSE * tension * utilisation
}

/// What a dome's contact adds to it.
pub(super) fn rise_under_contact(pair: &PairInertia) -> f64 {
    CONTACT_STIFFNESS * pair.softest() / CONTACT
}

/// Inverse inertia of a pair in the plane, m/N: velocity changes are
/// `own[0] f_bottom + cross f_top` and `own[1] f_top + cross f_bottom`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PairInertia {
    /// Own terms of bottom and top; 0 where fixed.
    pub own: [f64; 2],
    /// Cross term; 0 where a node is fixed.
    pub cross: f64,
}

impl PairInertia {
    /// Inverse inertia of the mode that a force moves most, m/N.
    pub(super) fn softest(&self) -> f64 {
        self.own[0].max(self.own[1]) + self.cross.abs()
    }
}

/// The same as inertia, N/m, of the sum and the difference of the velocities. Where one node is fixed, the
/// sum of both velocities is the other's.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PairModes {
    sum: f64,
    difference: f64,
}

impl PairModes {
    /// The modes of a pair.
    pub(crate) fn new(pair: &PairInertia) -> PairModes {
        match pair.own.map(|own| own > 0.0) {
            [true, true] => PairModes {
                sum: 0.25 / (pair.own[0] + pair.cross),
                difference: 0.25 / (pair.own[0] - pair.cross),
            },
            [true, false] => PairModes { sum: 0.5 / pair.own[0], difference: 0.0 },
            [false, true] => PairModes { sum: 0.5 / pair.own[1], difference: 0.0 },
            [false, false] => Self::default(),
        }
    }

    /// Kinetic energy, J, at the velocities (m per step) of the bottom and the top node, with `rise` times the
    /// inertia out of the plane.
    pub(crate) fn kinetic(&self, bottom: [f64; 3], top: [f64; 3], rise: f64) -> f64 {
        let mut energy = 0.0;
        for axis in 0..3 {
            let factor = if axis == 2 { rise } else { 1.0 };
            energy += factor * self.along(bottom[axis], top[axis]);
        }
        energy
    }

    /// That of one direction of the plane.
    pub(crate) fn along(&self, bottom: f64, top: f64) -> f64 {
        let (sum, difference) = (bottom + top, bottom - top);
        self.sum * sum * sum + self.difference * difference * difference
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
