//! The fast solver's state: planes of numbers, one for each quantity, that the kernel walks block by block.
//!
//! A plane holds one number for each pair, where [`Places`] says.

use super::super::inertia::PairInertia;
use super::super::lattice::Role;
use super::super::law::{BondCurve, Ramp};
use super::super::scene::Scene;
use super::lanes::Real;
use super::places::{BLOCK, Places};
use super::plane::Plane;
use super::sums::Sums;

/// Largest strain of a bond that is not there: no number, which no strain replaces, which is beyond no limit
/// and gives no force.
pub(super) const MISSING: f64 = f64::NAN;
/// Place of what is no pair from a dome's axis, m: out of reach.
const AWAY: f64 = 1.0e3;

/// How the loading curve behind the ramp is evaluated.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum NetShape<R> {
    /// Slopes fall from corner to corner: the least of these lines (slope, value at 0).
    Lines([(R, R); LINES]),
    /// Any curve: value at the end of the ramp, then for each corner (strain, change of slope).
    Hinges(R, Vec<(R, R)>),
}

/// Lines of the fast shape: a curve of seven points. Shorter ones repeat their last line.
pub(super) const LINES: usize = 6;

/// A kind of bond as the kernel needs it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BondKind<R> {
    /// Strain and force at the end of the ramp.
    pub(super) knee: (R, R),
    /// Curve behind it.
    pub(super) shape: NetShape<R>,
    /// Slope of unloading, N per unit of strain, or less than the ramp's, which then counts.
    pub(super) unloading: R,
    /// Strain at rupture.
    pub(super) rupture: R,
    /// 1/l1 where all bonds of the kind are alike, 1/m.
    pub(super) per_length: R,
    /// Slope of the ramp where all are alike, N per unit of strain.
    pub(super) ramp: R,
}

impl<R: Real> BondKind<R> {
    /// The kind of bonds with this curve and these unloading slope and values.
    fn new(curve: &BondCurve, unloading: f64, sample: &BondValues) -> BondKind<R> {
        let n = curve.strain.len();
        let falling =
            n >= 2 && n - 1 <= LINES && (1..n).all(|k| curve.slope[k] <= curve.slope[k - 1]);
        let line = |k: usize| {
            let k = k.min(n.saturating_sub(2));
            (R::new(curve.slope[k]), R::new(curve.force[k] - curve.slope[k] * curve.strain[k]))
        };
        let shape = if falling {
            NetShape::Lines(std::array::from_fn(line))
        } else {
            let mut before = 0.0;
            let hinges = (0..n).map(|k| {
                let change = curve.slope[k] - before;
                before = curve.slope[k];
                (R::new(curve.strain[k]), R::new(change))
            });
            NetShape::Hinges(R::new(curve.force[0]), hinges.collect())
        };
        BondKind {
            knee: (R::new(curve.strain[0]), R::new(curve.force[0])),
            shape,
            unloading: R::new(unloading),
            rupture: R::new(curve.rupture()),
            per_length: R::new(1.0 / sample.taut),
            ramp: R::new(sample.ramp.slope),
        }
    }
}

/// What a bond of a scene has of its own, in double precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BondValues {
    /// Taut length, m.
    pub(crate) taut: f64,
    /// Ramp and unloading.
    pub(crate) ramp: Ramp,
}

/// Values of a bond under the unloading slopes `unloading` of single wire and twist.
pub(crate) fn bond_values(
    scene: &Scene,
    number: usize,
    role: Role,
    unloading: [f64; 2],
) -> BondValues {
    let curve = curve(scene, role);
    let slack = scene.slack(number);
    let taut = scene.length(role) + slack;
    let start = -slack / taut;
    let slope = curve.ramp(start);
    let unloading = unloading[usize::from(role == Role::Twist)].max(slope);
    BondValues { taut, ramp: Ramp { start, slope, unloading } }
}

/// The curve of a bond's kind.
pub(crate) fn curve(scene: &Scene, role: Role) -> &BondCurve {
    if role == Role::Twist { &scene.law.twist } else { &scene.law.single }
}

/// Three planes: x, y and z.
pub(super) type Three<R> = [Plane<R>; 3];

/// The state and all constants of a run.
///
/// The kernel walks the planes by addresses, and what keeps it inside them is made by the constructor and
/// never changed: the planes have `places.len` places, `own` as many unless `uniform`, `near` and `holds` one
/// for each [`BLOCK`] of them; those of `forces` are buffers of `places.buffered()`; `from_axis` and `pushes` are as many as the domes, of which `near` has no more bits.
/// Of the sums see there.
///
/// ```compile_fail,E0616
/// fn more(state: &mut meshcast::dem::fast::NetState<f32>) {
///     state.places.rows += 1;
/// }
/// ```
#[derive(Debug, Clone)]
pub struct NetState<R: Copy> {
    /// Where the pairs stand.
    pub(super) places: Places,
    /// Whether the net goes on beyond its edges.
    pub(super) periodic: bool,
    /// Displacements of the bottom and the top nodes, m.
    pub(super) moved: [Three<R>; 2],
    /// Displacements in the last step, m.
    pub(super) velocity: [Three<R>; 2],
    /// Inverse inertia, m/N: own terms of bottom and top, cross term.
    pub(super) inertia: [Plane<R>; 3],
    /// Inverse inertia out of the plane over that in it.
    pub(super) rise: Plane<R>,
    /// Largest strain so far of twists, left and right wires.
    pub(super) top: [Plane<R>; 3],
    /// 1/l1 and ramp slope of each bond, by role; empty where all bonds of a kind are alike.
    pub(super) own: [[Plane<R>; 2]; 3],
    /// Whether all bonds of a kind are alike.
    pub(super) uniform: bool,
    /// Twist, then single wire.
    pub(super) kinds: [BondKind<R>; 2],
    /// Rest vectors: twist (along y), and half the opening and the projection of a wire.
    pub(super) rest: (R, [R; 2]),
    /// Forces of the bonds of some blocks on their first nodes, N, by role; of even rows, then of odd ones.
    pub(super) forces: [[Three<R>; 3]; 2],
    /// 1 where the bottom or the top node is fixed, else 0.
    pub(super) held: [Plane<R>; 2],
    /// Whether a block holds a fixed node.
    pub(super) holds: Vec<bool>,
    /// Which domes a block may touch, a bit each.
    pub(super) near: Vec<u8>,
    /// Place of the nodes from each dome's axis in the flat net, m: x, then y of bottoms and of tops.
    pub(super) from_axis: Vec<Three<R>>,
    /// Push of each dome on bottoms and tops in the last step, N; 0 where it is not near.
    pub(super) pushes: Vec<[Plane<R>; 2]>,
    /// Force on fixed nodes in the last step, N; 0 where a block holds none.
    pub(super) supports: Three<R>,
    /// Sums over rows and steps of forces by column, N (see [`super::sums`]).
    pub(super) sums: Sums<R>,
    /// Part of the velocity that stays after a step.
    pub(super) keep: R,
    /// See [`Real::GRAIN`].
    pub(super) grain: R,
    /// The dome: what the kernel needs of it.
    pub(super) dome: DomeValues<R>,
}

/// The dome's numbers, m (see [`super::super::dome::Dome`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DomeValues<R> {
    /// Radius of cap and node together.
    pub(super) cap_reach: R,
    /// Radius of rim tube and node together.
    pub(super) rim_reach: R,
    /// Radius of the rim's centre circle.
    pub(super) ring: R,
    /// Radius over height at the seam.
    pub(super) seam: R,
    /// Contact stiffness, N/m.
    pub(super) stiffness: R,
}

impl<R: Real> NetState<R> {
    /// The state of `scene` at rest.
    pub fn new(
        scene: &Scene,
        inertia: &[PairInertia],
        unloading: [f64; 2],
        keep: f64,
    ) -> NetState<R> {
        let lattice = &scene.lattice;
        let places = Places::new(lattice.columns, lattice.rows);
        let size = places.len;
        let zeros = || Plane::new(R::default(), size);
        let three = || std::array::from_fn(|_| zeros());
        let of_forces = || Plane::new(R::default(), places.buffered());
        let domes = scene.field.blocks.len();
        let samples = [Role::Twist, Role::Left].map(|role| {
            bond_values(scene, super::super::lattice::bond_number(0, role), role, unloading)
        });
        let uniform = scene.uniform();
        // Where bonds differ, the kernel takes the larger of this and each bond's own ramp.
        let slope = |k: usize| if uniform { samples[k].ramp.unloading } else { unloading[1 - k] };
        let kinds = [
            BondKind::new(&scene.law.twist, slope(0), &samples[0]),
            BondKind::new(&scene.law.single, slope(1), &samples[1]),
        ];
        let plane_of_own = || Plane::new(R::new(1.0), if uniform { 0 } else { size });
        let dome = &scene.dome;
        let mut state = NetState {
            places,
            periodic: lattice.periodic,
            moved: [three(), three()],
            velocity: [three(), three()],
            inertia: three(),
            rise: Plane::new(R::new(1.0 / super::super::inertia::OUT_OF_PLANE), size),
            top: std::array::from_fn(|_| Plane::new(R::new(MISSING), size)),
            own: std::array::from_fn(|_| [plane_of_own(), plane_of_own()]),
            uniform,
            kinds,
            rest: (
                R::new(lattice.twist),
                [R::new(lattice.opening / 2.0), R::new(lattice.projection)],
            ),
            forces: std::array::from_fn(|_| {
                std::array::from_fn(|_| std::array::from_fn(|_| of_forces()))
            }),
            held: [zeros(), zeros()],
            holds: vec![false; size / BLOCK],
            near: vec![0; size / BLOCK],
            from_axis: (0..domes)
                .map(|_| std::array::from_fn(|_| Plane::new(R::new(AWAY), size)))
                .collect(),
            pushes: (0..domes).map(|_| [zeros(), zeros()]).collect(),
            supports: three(),
            sums: Sums::new(scene, &places),
            keep: R::new(keep),
            grain: R::new(R::GRAIN),
            dome: DomeValues {
                cap_reach: R::new(dome.cap + dome.node),
                rim_reach: R::new(dome.rim + dome.node),
                ring: R::new(dome.ring),
                seam: R::new(dome.seam),
                stiffness: R::new(dome.stiffness),
            },
        };
        state.fill(scene, inertia, unloading);
        state
    }

    /// Puts a node (bottom 0, top 1) of a pair where it stands moved by this, m, from its unloaded place.
    pub fn put(&mut self, end: usize, row: usize, column: usize, moved: [f64; 3]) {
        let at = self.at(row, column);
        for (plane, moved) in self.moved[end].iter_mut().zip(moved) {
            plane[at] = R::new(moved);
        }
    }

    /// Force of a bond of the last row on its first node in the last step, N.
    pub fn force_in_last_row(&self, role: Role, column: usize) -> [f64; 3] {
        let Places { rows, stride, blocks, panel, carried, .. } = self.places;
        let row = rows - 1;
        let panels = (blocks.max(1) - 1) / panel * panel * BLOCK; // What the last panel is behind.
        let at = carried + row / 2 * stride + column - panels;
        self.forces[row % 2][role as usize].each_ref().map(|plane| plane[at].wide())
    }

    /// From now on the kernel reads the values of each bond, as where they differ, also where all are
    /// alike.
    pub fn take_bonds_one_by_one(&mut self) {
        if !self.uniform {
            return;
        }
        let size = self.top[0].len();
        for (k, own) in self.own.iter_mut().enumerate() {
            let kind = &self.kinds[usize::from(k > 0)];
            *own = [Plane::new(kind.per_length, size), Plane::new(kind.ramp, size)];
        }
        self.uniform = false;
    }

    /// Place of a pair in a plane.
    pub(super) fn at(&self, row: usize, column: usize) -> usize {
        self.places.at(row, column)
    }

    /// How many domes there are.
    pub(super) fn domes(&self) -> usize {
        self.from_axis.len()
    }

    fn fill(&mut self, scene: &Scene, inertia: &[PairInertia], unloading: [f64; 2]) {
        let lattice = &scene.lattice;
        let Places { columns, rows, .. } = self.places;
        for (k, block) in scene.field.blocks.iter().enumerate() {
            for row in 0..rows {
                let along = scene.pair_from(block, row, 0).map(|p| R::new(p[1]));
                for column in 0..columns {
                    // The same bits in all rows of a kind, as their columns stand above each other.
                    let across = R::new(scene.pair_from(block, row % 2, column)[0][0]);
                    let at = self.at(row, column);
                    for (plane, place) in
                        self.from_axis[k].iter_mut().zip([across, along[0], along[1]])
                    {
                        plane[at] = place;
                    }
                }
            }
        }
        for row in 0..rows {
            for column in 0..columns {
                let (pair, at) = (row * columns + column, self.at(row, column));
                self.inertia[0][at] = R::new(inertia[pair].own[0]);
                self.inertia[1][at] = R::new(inertia[pair].own[1]);
                self.inertia[2][at] = R::new(inertia[pair].cross);
                for end in 0..2 {
                    if scene.fixed[pair][end] {
                        self.held[end][at] = R::new(1.0);
                        self.holds[at / BLOCK] = true;
                    }
                }
                for (k, role) in Role::ALL.into_iter().enumerate() {
                    if !lattice.has(row, column, role) {
                        continue;
                    }
                    let number = super::super::lattice::bond_number(pair, role);
                    let bond = bond_values(scene, number, role, unloading);
                    self.top[k][at] = R::new(bond.ramp.start);
                    if !self.uniform {
                        self.own[k][0][at] = R::new(1.0 / bond.taut);
                        self.own[k][1][at] = R::new(bond.ramp.slope);
                    }
                }
            }
        }
        if self.periodic {
            self.repeat_wires();
        }
    }

    /// Gives each ghost the wire that leads from it into the net: to the left behind an even row, to the right
    /// before an odd one.
    fn repeat_wires(&mut self) {
        for (ghost, pair) in self.places.ghosts() {
            let role = if ghost > pair { Role::Left } else { Role::Right } as usize;
            self.top[role][ghost] = self.top[role][pair];
            for plane in &mut self.own[role] {
                if let Some(value) = plane.get(pair).copied() {
                    plane[ghost] = value;
                }
            }
        }
    }
}
