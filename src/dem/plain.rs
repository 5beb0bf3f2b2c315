//! The plain solver: double precision, any set of nodes and bonds, one loop over bonds and one over
//! nodes, nothing left out. The reference that every faster one is compared with.

use super::dome::Dome;
use super::inertia::{self, PairInertia, StepFactors};
use super::lattice::{Role, bond_number, bond_of};
use super::law::{BondCurve, Ramp};
use super::scene::Scene;
use super::stepper::{Energies, StepBlock, Stepper};

/// A bond of a plain net.
#[derive(Debug, Clone, PartialEq)]
pub struct PlainBond {
    /// First node.
    pub a: usize,
    /// Second node.
    pub b: usize,
    /// Vector from the first to the second node in the unloaded net, m (over the edge of a periodic cell).
    pub rest: [f64; 3],
    /// Taut length l1 = l0 + delta_l, m.
    pub taut: f64,
    /// Ramp and unloading.
    pub ramp: Ramp,
    /// Which of the net's curves.
    pub curve: usize,
    /// The bond's number in the lattice, or any number of the caller's.
    pub number: usize,
}

/// Nodes and bonds, of any shape.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlainNet {
    /// Unloaded places of the nodes, m: from the punch's axis in x and y, from the flat net in z.
    pub places: Vec<[f64; 3]>,
    /// Whether a node is fixed.
    pub fixed: Vec<bool>,
    /// Nodes 2k and 2k + 1 are a pair with this inertia.
    pub inertia: Vec<PairInertia>,
    /// All that there are, broken ones among them.
    pub bonds: Vec<PlainBond>,
    /// Loading curves.
    pub curves: Vec<BondCurve>,
}

/// How the plain solver damps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// Velocities lose this part of themselves in every step, 0 to 1.
    Viscous(f64),
    /// Forces lose this part of themselves where they speed a node up and gain it where they slow it
    /// down (local damping, Cundall 1987), 0 to 1.
    Local(f64),
}

/// The inertia of a plain solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Inertia {
    /// The same mass over step squared for every node and direction, N/m.
    Uniform(f64),
    /// The pair inertia of [`inertia`], for the stiffnesses of the bonds' true unloading.
    Pairs(StepFactors),
}

/// The plain solver and its state.
#[derive(Debug, Clone)]
pub struct Plain {
    /// Nodes and bonds.
    pub net: PlainNet,
    /// Displacements, m.
    pub moved: Vec<[f64; 3]>,
    /// Displacements in the last step, m.
    pub velocity: Vec<[f64; 3]>,
    /// Largest strain of each bond so far.
    pub top: Vec<f64>,
    /// Constant forces on the nodes, N (none in a punch test).
    pub load: Vec<[f64; 3]>,
    force: Vec<[f64; 3]>,
    dome: Option<Dome>,
    /// Unloaded places of the nodes from the axis of each further block, m.
    others: Vec<Vec<[f64; 2]>>,
    /// The anchor of each node, and how many there are; none but in an anchored test.
    anchor: Vec<usize>,
    anchors: usize,
    /// Sums of the last block of steps, by anchor, N, and the steps.
    pulled: (Vec<[f64; 3]>, usize),
    damping: Damping,
    /// Factor on the inertia out of the plane.
    out_of_plane: f64,
    deflection: f64,
    /// Places of the nodes from the panel's corner, m, for drawing.
    corner: Vec<[f64; 2]>,
    contact_energy: f64,
}

impl Plain {
    /// A solver of any net, without a punch; inertia out of the plane as in it.
    pub fn new(net: PlainNet, damping: Damping) -> Plain {
        let nodes = net.places.len();
        let top = net.bonds.iter().map(|b| b.ramp.start).collect();
        Plain {
            moved: vec![[0.0; 3]; nodes],
            velocity: vec![[0.0; 3]; nodes],
            load: vec![[0.0; 3]; nodes],
            force: vec![[0.0; 3]; nodes],
            top,
            dome: None,
            others: Vec::new(),
            anchor: Vec::new(),
            anchors: 0,
            pulled: (Vec::new(), 1),
            damping,
            out_of_plane: 1.0,
            deflection: 0.0,
            corner: net.places.iter().map(|p| [p[0], p[1]]).collect(),
            contact_energy: 0.0,
            net,
        }
    }

    /// A solver of a punch test.
    pub fn of_scene(scene: &Scene, inertia: Inertia, damping: Damping) -> Plain {
        let lattice = &scene.lattice;
        let mut net = PlainNet {
            curves: vec![scene.law.single.clone(), scene.law.twist.clone()],
            ..PlainNet::default()
        };
        let field = &scene.field;
        let mut corner = Vec::new();
        let mut others = vec![Vec::new(); field.blocks.len() - 1];
        let mut anchor = Vec::new();
        for row in 0..lattice.rows {
            for column in 0..lattice.columns {
                let pair = row * lattice.columns + column;
                corner.extend([lattice.bottom(row, column), lattice.top(row, column)]);
                net.fixed.extend(scene.fixed[pair]);
                let seen = scene.pair_from(&field.blocks[0], row, column);
                net.places.extend(seen.map(|[x, y]| [x, y, 0.0]));
                for (block, others) in field.blocks[1..].iter().zip(&mut others) {
                    others.extend(scene.pair_from(block, row, column));
                }
                let (places, cell) = scene.in_its_cell(row, column);
                anchor.extend(places.map(|place| {
                    let ([column, row], _) = field.nearest_anchor(place, cell);
                    row * field.rows[0] + column
                }));
            }
        }
        for number in scene.bond_numbers() {
            net.bonds.push(bond(scene, number));
        }
        let factors = match inertia {
            Inertia::Uniform(mass) => {
                net.inertia = scene
                    .fixed
                    .iter()
                    .map(|f| {
                        let own = |held: bool| if held { 0.0 } else { 1.0 / mass };
                        PairInertia { own: [own(f[0]), own(f[1])], cross: 0.0 }
                    })
                    .collect();
                None
            }
            Inertia::Pairs(factors) => Some(factors),
        };
        if let Some(factors) = factors {
            let stiffness = |number: usize| stiffness(scene, number);
            net.inertia = inertia::pairs(lattice, &scene.fixed, &stiffness, factors);
        }
        let mut plain = Plain::new(net, damping);
        plain.out_of_plane = if factors.is_some() { inertia::OUT_OF_PLANE } else { 1.0 };
        plain.dome = Some(scene.dome);
        plain.corner = corner;
        plain.others = others;
        if lattice.periodic {
            (plain.anchor, plain.anchors) = (anchor, field.anchors());
        }
        plain
    }

    /// Takes the punch away.
    pub(super) fn without_punch(&mut self) {
        self.dome = None;
        self.others = Vec::new();
    }

    /// Forces on all nodes at the present state, N; updates the bonds' largest strains. Returns the
    /// force on the punch and the energy in the contacts.
    fn forces(&mut self) -> (f64, f64) {
        self.force.copy_from_slice(&self.load);
        for (bond, top) in self.net.bonds.iter().zip(&mut self.top) {
            let curve = &self.net.curves[bond.curve];
            if *top > curve.rupture() {
                continue;
            }
            let (a, b) = (self.moved[bond.a], self.moved[bond.b]);
            let d = [0, 1, 2].map(|k| bond.rest[k] + b[k] - a[k]);
            let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            let e = length / bond.taut - 1.0;
            *top = top.max(e);
            let f = curve.force(&bond.ramp, *top, e);
            if f > 0.0 {
                let pull = f / length;
                for (k, along) in d.iter().enumerate() {
                    self.force[bond.a][k] += pull * along;
                    self.force[bond.b][k] -= pull * along;
                }
            }
        }
        let Some(dome) = self.dome else { return (0.0, 0.0) };
        let reach = dome.reach();
        let (mut punch, mut energy) = (0.0, 0.0);
        for block in 0..=self.others.len() {
            for node in 0..self.net.places.len() {
                let [x, y, z] = self.net.places[node];
                let place = block.checked_sub(1).map_or([x, y, z], |k| {
                    let [x, y] = self.others[k][node];
                    [x, y, z]
                });
                let p = [0, 1, 2].map(|k| place[k] + self.moved[node][k]);
                if p[0] * p[0] + p[1] * p[1] >= reach * reach {
                    continue;
                }
                let (depth, normal) = dome.depth(p, self.deflection);
                if depth > 0.0 {
                    for (force, along) in self.force[node].iter_mut().zip(normal) {
                        *force += dome.stiffness * depth * along;
                    }
                    punch += dome.stiffness * depth * normal[2];
                    energy += 0.5 * dome.stiffness * depth * depth;
                }
            }
        }
        (punch, energy)
    }

    /// How many blocks push.
    fn blocks(&self) -> f64 {
        1.0 + self.others.len() as f64
    }

    /// One step with the punch moving `travel` metres: forces on punch and support, N, of all blocks.
    pub fn step(&mut self, travel: f64) -> (f64, f64) {
        let (punch, energy) = self.forces();
        self.contact_energy = energy;
        let mut support = 0.0;
        for (node, held) in self.net.fixed.iter().enumerate() {
            if *held {
                support += self.force[node][2];
                if let Some(pulled) = self.anchor.get(node).and_then(|a| self.pulled.0.get_mut(*a))
                {
                    for (sum, force) in pulled.iter_mut().zip(self.force[node]) {
                        *sum += force;
                    }
                }
            }
        }
        for (pair, inertia) in self.net.inertia.iter().enumerate() {
            let (bottom, top) = (2 * pair, 2 * pair + 1);
            let (mut fb, mut ft) = (self.force[bottom], self.force[top]);
            let mut keep = 1.0;
            match self.damping {
                Damping::Viscous(loss) => keep = 1.0 - loss,
                Damping::Local(part) => {
                    for k in 0..3 {
                        fb[k] -= part * fb[k].abs() * sign(self.velocity[bottom][k]);
                        ft[k] -= part * ft[k].abs() * sign(self.velocity[top][k]);
                    }
                }
            }
            for k in 0..3 {
                let factor = if k == 2 { 1.0 / self.out_of_plane } else { 1.0 };
                let vb = &mut self.velocity[bottom][k];
                *vb = keep * *vb + factor * (inertia.own[0] * fb[k] + inertia.cross * ft[k]);
                self.moved[bottom][k] += *vb;
                let vt = &mut self.velocity[top][k];
                *vt = keep * *vt + factor * (inertia.own[1] * ft[k] + inertia.cross * fb[k]);
                self.moved[top][k] += *vt;
            }
        }
        self.deflection += travel;
        (punch, support)
    }
}

fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        0.0
    }
}

/// The largest tangent stiffness of a bond under the full law, N/m.
fn stiffness(scene: &Scene, number: usize) -> f64 {
    let bond = bond(scene, number);
    bond.ramp.unloading / bond.taut
}

/// A bond of a scene; its end nodes are 2 pair for the bottom and 2 pair + 1 for the top.
fn bond(scene: &Scene, number: usize) -> PlainBond {
    let (pair, role) = bond_of(number);
    let lattice = &scene.lattice;
    let (row, column) = (pair / lattice.columns, pair % lattice.columns);
    let (a, b) = match role {
        Role::Twist => (2 * pair, 2 * pair + 1),
        _ => match lattice.upper(row, column, role) {
            Some((up, side)) => (2 * pair + 1, 2 * (up * lattice.columns + side)),
            None => (2 * pair + 1, 2 * pair + 1), // Not reached: only bonds that exist are asked for.
        },
    };
    let rest = lattice.rest(role);
    let slack = scene.slack(bond_number(pair, role));
    let taut = scene.length(role) + slack;
    let curve = usize::from(role == Role::Twist);
    let ramp = [&scene.law.single, &scene.law.twist][curve].full(-slack / taut);
    PlainBond { a, b, rest: [rest[0], rest[1], 0.0], taut, ramp, curve, number }
}

impl Stepper for Plain {
    fn advance(&mut self, steps: usize, travel: f64) -> StepBlock {
        let mut mean = StepBlock {
            deflection: self.deflection + travel * (steps - 1) as f64 / 2.0,
            ..StepBlock::default()
        };
        self.pulled = (vec![[0.0; 3]; self.anchors], steps);
        let share = self.blocks() * steps as f64;
        for _ in 0..steps {
            let (punch, support) = self.step(travel);
            mean.punch += punch / share;
            mean.support += support / share;
        }
        mean
    }

    fn anchors(&self) -> Vec<[f64; 3]> {
        self.pulled.0.iter().map(|sum| sum.map(|force| force / self.pulled.1 as f64)).collect()
    }

    fn deflection(&self) -> f64 {
        self.deflection
    }

    fn broken(&self, known: &mut Vec<usize>) -> usize {
        let before = known.len();
        for (bond, top) in self.net.bonds.iter().zip(&self.top) {
            if *top > self.net.curves[bond.curve].rupture()
                && !known[..before].contains(&bond.number)
            {
                known.push(bond.number);
            }
        }
        known.len() - before
    }

    fn kinetic(&self) -> f64 {
        self.net
            .inertia
            .iter()
            .enumerate()
            .map(|(pair, m)| {
                let (bottom, top) = (self.velocity[2 * pair], self.velocity[2 * pair + 1]);
                inertia::PairModes::new(m).kinetic(bottom, top, self.out_of_plane)
            })
            .sum::<f64>()
            / self.blocks()
    }

    fn energies(&self) -> Energies {
        let mut bonds = 0.0;
        for (bond, top) in self.net.bonds.iter().zip(&self.top) {
            let curve = &self.net.curves[bond.curve];
            let (a, b) = (self.moved[bond.a], self.moved[bond.b]);
            let d = [0, 1, 2].map(|k| bond.rest[k] + b[k] - a[k]);
            let e = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt() / bond.taut - 1.0;
            let top = top.max(e);
            bonds += bond.taut * curve.work(&bond.ramp, top, e);
        }
        let blocks = self.blocks();
        let contact = self.contact_energy / blocks;
        Energies { kinetic: self.kinetic(), bonds: bonds / blocks, contact }
    }

    fn utilisation(&self) -> f64 {
        self.net
            .bonds
            .iter()
            .zip(&self.top)
            .map(|(bond, top)| top / self.net.curves[bond.curve].rupture())
            .filter(|u| *u <= 1.0)
            .fold(0.0, f64::max)
    }

    fn shaking(&self) -> f64 {
        let mut most = 0.0_f64;
        for (bond, top) in self.net.bonds.iter().zip(&self.top).filter(|(bond, _)| bond.curve == 1)
        {
            let rupture = self.net.curves[bond.curve].rupture();
            if *top <= rupture {
                let rate = (self.velocity[bond.b][1] - self.velocity[bond.a][1]).abs();
                most = most.max(rate / bond.taut / rupture);
            }
        }
        most
    }

    fn damping_loss(&self) -> Option<f64> {
        match self.damping {
            Damping::Viscous(loss) => Some(1.0 - (1.0 - loss) * (1.0 - loss)),
            Damping::Local(_) => None,
        }
    }

    fn positions(&self) -> Vec<[f64; 3]> {
        self.corner.iter().zip(&self.moved).map(|(p, u)| [p[0] + u[0], p[1] + u[1], u[2]]).collect()
    }
}
