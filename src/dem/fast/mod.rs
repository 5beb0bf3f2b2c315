//! The fast solver: the same net as [`super::plain`], regular, in vectors.
//!
//! What it does otherwise than the plain solver, and why that is allowed:
//!
//! - *Soft unloading*: bonds unload with the steepest slope of their loading curve behind the ramp
//!   instead of the elastic one, which allows a step 2.5 times longer. In reference runs the true slope stays.
//! - *Single precision* of displacements (not positions); reference runs use double precision.
//! - *An inverse square root* good to 1e-6 in single precision (see [`lanes`]).
//! - *Contact under the dome alone*, in blocks of places found anew every few steps with a margin.
//!   The search comes earlier where a node is fast enough to cross the margin by then (see [`reach`]);
//!   one that crossed it all the same was pushed by nothing, and the run counts as diverged.
//! - *Inertia out of the plane fitted* to the net's slopes, where the scheme asks for it (see [`rise`]).
//! - *No periodic images* where the net ends, *no values of single bonds* where all are alike.
//!
//! Files: [`state`] the planes, [`places`] where the pairs stand in them, [`force`] what acts on them, [`reach`] the
//! search, [`kernel`] one step, [`rise`] the fits of the inertia, [`lanes`] the vectors, [`path`] which of them the
//! processor has, this one the driver.
//!
//! Nothing outside can make it read past a plane or run an instruction that the processor lacks:
//! [`NetState`] has private fields and one constructor, which sizes every plane, and a [`Path`] is had
//! by detection alone.

mod force;
mod kernel;
pub(crate) mod lanes;
mod path;
mod places;
mod plane;
mod reach;
mod rise;
pub(crate) mod state;
mod sums;

use super::inertia::{self, PairModes, StepFactors};
use super::lattice::{Role, bond_number, bond_of};
use super::law::{Law, Ramp};
use super::scene::Scene;
use super::stepper::{Energies, StepBlock, Stepper};
pub use kernel::DomeHeights;
use lanes::{Portable, Real};
pub use path::Path;
use path::Set;
use places::{BLOCK, Places};
pub use state::NetState;
use state::{BondValues, bond_values, curve};

/// The fast solver.
#[derive(Debug, Clone)]
pub struct Fast<R: Kernel> {
    scene: Scene,
    /// Inertia of the pairs' sums and differences, N/m, so that kinetic energy needs no division.
    modes: Vec<PairModes>,
    /// How their inertia out of the plane is fitted; nothing where it stays.
    rise: Option<rise::Rise<R>>,
    unloading: [f64; 2],
    state: NetState<R>,
    path: Path,
    deflection: f64,
    until_search: usize,
    /// Whether a node came under the dome where contact is not looked for.
    missed: bool,
    /// Steps of the last block, of which the sums are.
    block: usize,
}

/// How a fast solver is set up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastOptions {
    /// Step factors.
    pub factors: StepFactors,
    /// Part of the velocity lost in a step, 0 to 1.
    pub damping: f64,
    /// Whether bonds unload with their true elastic slope.
    pub true_unloading: bool,
    /// Whether the inertia out of the plane is fitted to the net's slopes.
    pub fitted: bool,
    /// Instruction set.
    pub path: Path,
}

/// Slopes at which single wires and twists unload, N per unit of strain: the elastic ones, or the
/// steepest behind the ramp.
pub fn unloading(law: &Law, true_unloading: bool) -> [f64; 2] {
    [&law.single, &law.twist].map(|curve| {
        // A curve of one point has no slope behind its ramp; the elastic one serves.
        let soft = curve.steepest();
        if true_unloading || soft <= 0.0 { curve.unloading } else { soft }
    })
}

/// The largest tangent stiffness of every bond, N/m, in order of their numbers; 0 where there is none.
pub fn stiffest(scene: &Scene, unloading: [f64; 2]) -> Vec<f64> {
    let mut all = vec![0.0; 3 * scene.lattice.pairs()];
    for number in scene.bond_numbers() {
        let bond = bond_values(scene, number, bond_of(number).1, unloading);
        all[number] = bond.ramp.unloading / bond.taut;
    }
    all
}

impl<R: Kernel> Fast<R> {
    /// The solver of `scene` at rest.
    pub fn new(scene: &Scene, options: FastOptions) -> Fast<R> {
        let unloading = unloading(&scene.law, options.true_unloading);
        let stiffness = stiffest(scene, unloading);
        let inertia =
            inertia::pairs(&scene.lattice, &scene.fixed, &|k| stiffness[k], options.factors);
        let modes = inertia.iter().map(PairModes::new).collect();
        let mut state = NetState::new(scene, &inertia, unloading, 1.0 - options.damping);
        let lengths = [scene.lattice.twist_length(), scene.lattice.wire_length()];
        let wire = &scene.law.single;
        let tension = wire.force.last().copied().unwrap_or(0.0) / unloading[0];
        let rise = options.fitted.then(|| rise::Rise::new(&state, &inertia, lengths, tension));
        // Nothing was marked before, and nothing can have been missed.
        let first = reach::search(&mut state, scene.dome.reach());
        Fast {
            scene: scene.clone(),
            modes,
            rise,
            unloading,
            state,
            path: options.path,
            deflection: 0.0,
            until_search: first.steps,
            missed: false,
            block: 0,
        }
    }

    /// The instruction set in use.
    pub fn path(&self) -> Path {
        self.path
    }

    /// Visits every bond that exists: number, place in its plane, role.
    fn each_bond(&self, mut visit: impl FnMut(usize, usize, Role)) {
        for pair in 0..self.scene.lattice.pairs() {
            let (row, column) =
                (pair / self.scene.lattice.columns, pair % self.scene.lattice.columns);
            for role in Role::ALL {
                if self.scene.lattice.has(row, column, role) {
                    visit(bond_number(pair, role), self.state.at(row, column), role);
                }
            }
        }
    }

    /// Inertia of each pair out of the plane over that in it, row by row.
    pub fn rise(&self) -> Vec<f64> {
        let Places { rows, columns, .. } = self.state.places;
        let pairs = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        pairs.map(|(row, column)| self.rise_at(self.state.at(row, column))).collect()
    }

    fn rise_at(&self, place: usize) -> f64 {
        self.rise.as_ref().map_or(inertia::OUT_OF_PLANE, |rise| rise.at(place))
    }

    fn node(&self, end: usize, at: usize) -> [f64; 3] {
        std::array::from_fn(|k| self.state.moved[end][k][at].wide())
    }
}

impl<R: Kernel> Stepper for Fast<R> {
    fn advance(&mut self, steps: usize, travel: f64) -> StepBlock {
        let mean = self.deflection + travel * (steps as f64 - 1.0) / 2.0;
        self.state.sums.clear();
        self.block = steps;
        // Counted from here, so that the punch stands at the same bits whenever searches come.
        let start = self.deflection;
        let mut done = 0;
        while done < steps {
            if self.until_search == 0 {
                let found = reach::search(&mut self.state, self.scene.dome.reach());
                self.missed |= found.missed;
                self.until_search = found.steps;
            }
            let now = (steps - done).min(self.until_search);
            let dome = &self.scene.dome;
            let heights = |step: usize| {
                let apex = dome.apex(start + travel * (done + step) as f64);
                DomeHeights { cap: apex - dome.cap_depth, ring: apex - dome.ring_depth }
            };
            R::run(&mut self.state, self.path, now, &heights);
            self.until_search -= now;
            done += now;
        }
        self.deflection += travel * steps as f64;
        if self.missed {
            // No number, so that nobody takes the run for a sound one.
            return StepBlock { deflection: mean, punch: f64::NAN, support: f64::NAN };
        }
        let sums = &self.state.sums;
        StepBlock { deflection: mean, punch: sums.punch(steps), support: sums.support(steps) }
    }

    fn anchors(&self) -> Vec<[f64; 3]> {
        self.state.sums.anchors(self.block.max(1))
    }

    fn deflection(&self) -> f64 {
        self.deflection
    }

    fn broken(&self, known: &mut Vec<usize>) -> usize {
        let mut count = 0;
        for (k, plane) in self.state.top.iter().enumerate() {
            let rupture = self.state.kinds[usize::from(k > 0)].rupture;
            // Whole planes, as what is missing is no number, less what ghosts repeat.
            count += beyond(plane, rupture);
            if self.state.periodic {
                let ghosts = self.state.places.ghosts();
                count -= ghosts.filter(|(ghost, _)| plane[*ghost] > rupture).count() as u32;
            }
        }
        if count as usize <= known.len() {
            return 0;
        }
        let before = known.len();
        self.each_bond(|number, at, role| {
            let rupture = self.state.kinds[usize::from(role != Role::Twist)].rupture;
            if self.state.top[role as usize][at] > rupture && !known[..before].contains(&number) {
                known.push(number);
            }
        });
        known.len() - before
    }

    fn kinetic(&self) -> f64 {
        let state = &self.state;
        let mut energy = 0.0;
        let Places { rows, columns, .. } = state.places;
        for row in 0..rows {
            let first = state.at(row, 0);
            let planes = |end: usize| {
                state.velocity[end].each_ref().map(|plane| &plane[first..first + columns])
            };
            let (bottom, top) = (planes(0), planes(1));
            let modes = &self.modes[row * columns..(row + 1) * columns];
            for (column, modes) in modes.iter().enumerate() {
                let at = |planes: &[&[R]; 3]| planes.map(|plane| plane[column].wide());
                let rise = self.rise_at(first + column);
                energy += modes.kinetic(at(&bottom), at(&top), rise);
            }
        }
        energy / state.domes() as f64
    }

    fn energies(&self) -> Energies {
        let (state, lattice) = (&self.state, &self.scene.lattice);
        let alike = Role::ALL
            .map(|role| bond_values(&self.scene, bond_number(0, role), role, self.unloading));
        let Places { rows, columns, .. } = state.places;
        let mut bonds = 0.0;
        for row in 0..rows {
            for column in 0..columns {
                let at = state.at(row, column);
                let (bottom, top) = (self.node(0, at), self.node(1, at));
                for role in Role::ALL {
                    let (from, to) = if role == Role::Twist {
                        (bottom, top)
                    } else if let Some((up, side)) = lattice.upper(row, column, role) {
                        (top, self.node(0, state.at(up, side)))
                    } else {
                        continue;
                    };
                    let curve = curve(&self.scene, role);
                    let bond = if state.uniform {
                        alike[role as usize]
                    } else {
                        // As the planes have it: a millionth from the scene's own values.
                        let [per_length, slope] = &state.own[role as usize];
                        let slope = slope[at].wide();
                        let start = curve.strain[0] - curve.force[0] / slope;
                        let unloading = self.unloading[usize::from(role == Role::Twist)].max(slope);
                        let ramp = Ramp { start, slope, unloading };
                        BondValues { taut: 1.0 / per_length[at].wide(), ramp }
                    };
                    let rest = lattice.rest(role);
                    let d = [rest[0] + to[0] - from[0], rest[1] + to[1] - from[1], to[2] - from[2]];
                    let e = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt() / bond.taut - 1.0;
                    let most = state.top[role as usize][at].wide().max(e);
                    bonds += bond.taut * curve.work(&bond.ramp, most, e);
                }
            }
        }
        let mut contact = 0.0;
        for row in 0..rows {
            for column in 0..columns {
                let at = state.at(row, column);
                let near = state.near[at / BLOCK];
                for dome in (0..state.domes()).filter(|dome| near >> dome & 1 == 1) {
                    for end in 0..2 {
                        let u = self.node(end, at);
                        let [across, along @ ..] = &state.from_axis[dome];
                        let p = [u[0] + across[at].wide(), u[1] + along[end][at].wide(), u[2]];
                        let depth = self.scene.dome.depth(p, self.deflection).0.max(0.0);
                        contact += 0.5 * self.scene.dome.stiffness * depth * depth;
                    }
                }
            }
        }
        let domes = state.domes() as f64;
        Energies { kinetic: self.kinetic(), bonds: bonds / domes, contact: contact / domes }
    }

    fn utilisation(&self) -> f64 {
        let mut most = 0.0_f64;
        for (k, plane) in self.state.top.iter().enumerate() {
            let rupture = self.state.kinds[usize::from(k > 0)].rupture;
            // Missing bonds are no numbers, and larger than none. In eight lanes.
            let mut top = [R::default(); 8];
            for eight in plane.chunks_exact(8) {
                for (top, t) in top.iter_mut().zip(eight) {
                    let t = if *t > rupture { R::default() } else { *t };
                    *top = if t > *top { t } else { *top };
                }
            }
            let top = top.into_iter().fold(0.0, |most, t| t.wide().max(most));
            most = most.max(top / rupture.wide());
        }
        most
    }

    fn shaking(&self) -> f64 {
        let state = &self.state;
        let rupture = state.kinds[0].rupture;
        let (bottom, top) = (&state.velocity[0][1], &state.velocity[1][1]);
        // In eight lanes. Planes are a multiple of that, and what is missing is below no rupture.
        let mut most = [0.0_f64; 8];
        let eights = bottom.chunks_exact(8).zip(top.chunks_exact(8));
        for ((bottom, top), reached) in eights.zip(state.top[0].chunks_exact(8)) {
            for k in 0..8 {
                let apart = (top[k].wide() - bottom[k].wide()).abs();
                let rate = if reached[k] <= rupture { apart } else { 0.0 };
                most[k] = if rate > most[k] { rate } else { most[k] };
            }
        }
        let most = most.into_iter().fold(0.0, f64::max);
        most / self.scene.lattice.twist_length() / rupture.wide()
    }

    fn follow(&mut self) -> f64 {
        let near = self.scene.dome.reach() + reach::MARGIN;
        let utilisation = self.utilisation();
        let Some(rise) = &mut self.rise else { return 0.0 };
        rise.follow(&mut self.state, &self.modes, utilisation, near) / self.state.domes() as f64
    }

    fn damping_loss(&self) -> Option<f64> {
        let keep = self.state.keep.wide();
        Some(1.0 - keep * keep)
    }

    fn positions(&self) -> Vec<[f64; 3]> {
        let lattice = &self.scene.lattice;
        let mut all = Vec::with_capacity(lattice.nodes());
        for row in 0..lattice.rows {
            for column in 0..lattice.columns {
                let at = self.state.at(row, column);
                for (end, place) in
                    [lattice.bottom(row, column), lattice.top(row, column)].into_iter().enumerate()
                {
                    let u = self.node(end, at);
                    all.push([place[0] + u[0], place[1] + u[1], u[2]]);
                }
            }
        }
        all
    }
}

/// How many numbers are above a limit. In eight lanes; planes are a multiple of that.
fn beyond<R: Real>(plane: &[R], limit: R) -> u32 {
    let mut count = [0_u32; 8];
    for eight in plane.chunks_exact(8) {
        for (count, x) in count.iter_mut().zip(eight) {
            *count += u32::from(*x > limit);
        }
    }
    count.into_iter().sum()
}

/// A number with a kernel for every path.
pub trait Kernel: Real {
    /// Takes `steps` steps of `state`; `heights` gives the dome's heights at each.
    fn run(
        state: &mut NetState<Self>,
        path: Path,
        steps: usize,
        heights: &dyn Fn(usize) -> DomeHeights,
    );
}

/// Steps with lanes `L`.
///
/// # Safety
/// The processor has the instruction set of `L`.
#[expect(clippy::inline_always, reason = "as in the kernel")]
#[inline(always)]
unsafe fn steps<L: lanes::Lanes>(
    state: &mut NetState<L::Real>,
    steps: usize,
    heights: &dyn Fn(usize) -> DomeHeights,
) {
    // SAFETY: the caller promises the instruction set of `L`.
    unsafe {
        if state.uniform {
            kernel::run::<L, true>(state, steps, heights);
        } else {
            kernel::run::<L, false>(state, steps, heights);
        }
    }
}

macro_rules! kernel {
    ($real:ty, $avx512:ident, $avx2:ident, $sse2:ident, $portable:ty) => {
        impl Kernel for $real {
            fn run(
                state: &mut NetState<$real>,
                path: Path,
                n: usize,
                heights: &dyn Fn(usize) -> DomeHeights,
            ) {
                #[cfg(target_arch = "x86_64")]
                {
                    #[target_feature(enable = "avx512f")]
                    unsafe fn avx512(
                        state: &mut NetState<$real>,
                        n: usize,
                        heights: &dyn Fn(usize) -> DomeHeights,
                    ) {
                        // SAFETY: this function has AVX-512F, which is all that these lanes use
                        // (their tail has AVX2, which AVX-512F implies).
                        unsafe { steps::<lanes::$avx512>(state, n, heights) }
                    }
                    #[target_feature(enable = "avx2")]
                    unsafe fn avx2(
                        state: &mut NetState<$real>,
                        n: usize,
                        heights: &dyn Fn(usize) -> DomeHeights,
                    ) {
                        // SAFETY: this function has AVX2, which is all that these lanes use.
                        unsafe { steps::<lanes::$avx2>(state, n, heights) }
                    }
                    match path.set() {
                        // SAFETY: a path has this set only where AVX-512F was detected.
                        Set::Avx512 => return unsafe { avx512(state, n, heights) },
                        // SAFETY: a path has this set only where AVX2 was detected.
                        Set::Avx2 => return unsafe { avx2(state, n, heights) },
                        // SAFETY: SSE2 is part of x86-64.
                        Set::Sse2 => return unsafe { steps::<lanes::$sse2>(state, n, heights) },
                        Set::Portable => {}
                    }
                }
                let _ = path;
                // SAFETY: portable lanes are arrays and need no instruction set.
                unsafe { steps::<$portable>(state, n, heights) }
            }
        }
    };
}

kernel!(f32, F32x16, F32x8, F32x4, Portable<f32, 8>);
kernel!(f64, F64x8, F64x4, F64x2, Portable<f64, 4>);
