//! One step of the fast solver, written once for every width of vector.
//!
//! Row by row: the forces of the single wires between row i and row i + 1 go into the row's buffer;
//! then the pairs of row i are moved, by the buffer of their own row (top nodes), the buffer of the
//! row below (bottom nodes) and their twists. The wires above row i are computed before any node of
//! row i moves, and those above row i - 1 were too, so all forces belong to the same instant, with one
//! pass over the net and no scattered writes.

use super::lanes::{Lanes, Real};
use super::state::{BLOCK, Kind, PAD, Shape, State};

/// Vectors of a kind's constants.
#[derive(Clone, Copy)]
struct KindLanes<'a, L: Lanes> {
    kind: &'a Kind<L::Real>,
    knee: L,
    knee_force: L,
    unloading: L,
    rupture: L,
    per_length: L,
    ramp: L,
}

impl<'a, L: Lanes> KindLanes<'a, L> {
    #[inline(always)]
    unsafe fn new(kind: &'a Kind<L::Real>) -> Self {
        // SAFETY: the caller's promise about the instruction set.
        unsafe {
            KindLanes {
                kind,
                knee: L::splat(kind.knee.0),
                knee_force: L::splat(kind.knee.1),
                unloading: L::splat(kind.unloading),
                rupture: L::splat(kind.rupture),
                per_length: L::splat(kind.per_length),
                ramp: L::splat(kind.ramp),
            }
        }
    }

    /// Loading curve behind the ramp at strain `e`.
    #[inline(always)]
    unsafe fn curve(&self, e: L) -> L {
        // SAFETY: the caller's promise about the instruction set.
        unsafe {
            match &self.kind.shape {
                Shape::Lines(lines) => {
                    let mut f = e.mul(L::splat(lines[0].0)).add(L::splat(lines[0].1));
                    for line in &lines[1..] {
                        f = f.min(e.mul(L::splat(line.0)).add(L::splat(line.1)));
                    }
                    f
                }
                Shape::Hinges(first, hinges) => {
                    let zero = L::splat(L::Real::default());
                    let mut f = L::splat(*first);
                    for hinge in hinges {
                        let beyond = e.sub(L::splat(hinge.0)).max(zero);
                        f = f.add(beyond.mul(L::splat(hinge.1)));
                    }
                    f
                }
            }
        }
    }

    /// Force over length of bonds whose ends are `d` apart, N/m; updates their largest strains.
    #[inline(always)]
    unsafe fn pull(&self, d: [L; 3], top: *mut L::Real, own: Option<[*const L::Real; 2]>) -> L {
        // SAFETY: the caller's promise about the instruction set and the addresses.
        unsafe {
            let (per_length, ramp, unloading) = match own {
                None => (self.per_length, self.ramp, self.unloading),
                Some([per_length, ramp]) => {
                    let ramp = L::load(ramp);
                    (L::load(per_length), ramp, self.unloading.max(ramp))
                }
            };
            let square = d[0].mul(d[0]).add(d[1].mul(d[1])).add(d[2].mul(d[2]));
            let inverse = square.rsqrt();
            let e = square.mul(inverse).mul(per_length).sub(L::splat(L::Real::new(1.0)));
            let most = L::load(top).max(e);
            most.store(top);
            let mut f = most.sub(self.knee).mul(ramp).add(self.knee_force);
            if most.any_gt(self.knee) {
                f = most.select_gt(self.knee, self.curve(most), f);
            }
            let zero = L::splat(L::Real::default());
            f = f.sub(unloading.mul(most.sub(e))).max(zero);
            most.select_gt(self.rupture, zero, f).mul(inverse)
        }
    }
}

/// Vectors of the dome's constants at an instant.
#[derive(Clone, Copy)]
struct DomeLanes<L> {
    cap_reach: L,
    rim_reach: L,
    ring: L,
    seam: L,
    stiffness: L,
    cap_height: L,
    ring_height: L,
}

impl<L: Lanes> DomeLanes<L> {
    /// Contact force on nodes at `p` (from the axis, and from the flat net), N.
    #[inline(always)]
    unsafe fn push(&self, p: [L; 3]) -> [L; 3] {
        // SAFETY: the caller's promise about the instruction set.
        unsafe {
            let zero = L::splat(L::Real::default());
            let square = p[0].mul(p[0]).add(p[1].mul(p[1]));
            let r_inverse = square.rsqrt();
            let r = square.mul(r_inverse);
            let over = p[2].sub(self.cap_height);
            let seam = self.seam.mul(over);
            let out = r.sub(seam.select_gt(r, zero, self.ring));
            let height = seam.select_gt(r, self.cap_height, self.ring_height);
            let reach = seam.select_gt(r, self.cap_reach, self.rim_reach);
            let up = p[2].sub(height).max(zero);
            let square = out.mul(out).add(up.mul(up));
            let inverse = square.rsqrt();
            let depth = reach.sub(square.mul(inverse)).max(zero);
            let force = self.stiffness.mul(depth).mul(inverse);
            let flat = force.mul(out).mul(r_inverse);
            [flat.mul(p[0]), flat.mul(p[1]), force.mul(up)]
        }
    }
}

/// Heights of the dome's two centres at an instant, m.
#[derive(Debug, Clone, Copy)]
pub struct DomeHeights {
    /// Of the cap's sphere.
    pub cap: f64,
    /// Of the rim's circle.
    pub ring: f64,
}

/// Takes one step of `state` with the dome at `heights`.
///
/// # Safety
/// The processor has the instruction set of `L`.
#[inline(always)]
pub unsafe fn step<L: Lanes, const UNIFORM: bool>(
    state: &mut State<L::Real>,
    heights: DomeHeights,
) {
    // SAFETY: every row asked for exists, and planes have a pad behind the last place touched.
    unsafe {
        let last = state.rows - 1;
        if state.periodic {
            // The first row's bottoms, as they are before they move, are those above the last row.
            let (first, ghost) = (state.at(0, 0) - 1, state.at(state.rows, 0) - 1);
            let width = state.columns + 2;
            for plane in &mut state.moved[0] {
                plane.copy_within(first..first + width, ghost);
            }
            wires::<L, UNIFORM>(state, last, LAST);
        }
        let mut below = LAST;
        for row in 0..last {
            let own = row % 2;
            wires::<L, UNIFORM>(state, row, own);
            nodes::<L, UNIFORM>(state, row, own, below, heights);
            below = own;
        }
        nodes::<L, UNIFORM>(state, last, LAST, below, heights);
    }
}

/// Buffer of the last row's wires, which both the first and the last row need; zeros for ever where
/// the net ends there. The others belong to even and odd rows.
const LAST: usize = 2;

/// Forces of the single wires above `row` on their top nodes, into a buffer.
#[inline(always)]
unsafe fn wires<L: Lanes, const UNIFORM: bool>(state: &mut State<L::Real>, row: usize, own: usize) {
    // Whole vectors, then what is left of the row in steps of the shorter ones.
    let columns = state.columns.div_ceil(8) * 8;
    let mut column = 0;
    // SAFETY: the caller's promise about the instruction set.
    unsafe {
        while column + L::N <= columns {
            wires_at::<L, UNIFORM>(state, row, column, own);
            column += L::N;
        }
        while column < columns {
            wires_at::<L::Tail, UNIFORM>(state, row, column, own);
            column += L::Tail::N;
        }
    }
    if state.periodic {
        let (first, end) = (PAD, PAD + state.columns);
        let [left, right] = &mut state.wires[own];
        for (left, right) in left.iter_mut().zip(right) {
            left[end] = left[first];
            right[first - 1] = right[end - 1];
        }
    }
}

#[inline(always)]
unsafe fn wires_at<L: Lanes, const UNIFORM: bool>(
    state: &mut State<L::Real>,
    row: usize,
    column: usize,
    own: usize,
) {
    let here = state.at(row, column);
    let there = state.at(row + 1, column);
    // Odd rows stand half an opening to the right (see `lattice`).
    let ends = if row % 2 == 0 { [there - 1, there] } else { [there, there + 1] };
    // SAFETY: `here`, `there` and their neighbours are within the planes, which are padded by more
    // than a vector on both sides; so is `column` in the row buffers.
    unsafe {
        let kind = KindLanes::<L>::new(&state.kinds[1]);
        let from =
            std::array::from_fn::<L, 3, _>(|k| L::load(state.moved[1][k].as_ptr().add(here)));
        let half = L::splat(state.rest.1[0]);
        let rise = L::splat(state.rest.1[1]);
        for side in 0..2 {
            let bonds = side + 1;
            let to = std::array::from_fn::<L, 3, _>(|k| {
                L::load(state.moved[0][k].as_ptr().add(ends[side]))
            });
            let x = to[0].sub(from[0]);
            let d = [
                if side == 0 { x.sub(half) } else { x.add(half) },
                to[1].sub(from[1]).add(rise),
                to[2].sub(from[2]),
            ];
            let values = if UNIFORM {
                None
            } else {
                Some([0, 1].map(|k| state.own[bonds][k].as_ptr().add(here)))
            };
            let pull = kind.pull(d, state.top[bonds].as_mut_ptr().add(here), values);
            for k in 0..3 {
                pull.mul(d[k]).store(state.wires[own][side][k].as_mut_ptr().add(PAD + column));
            }
        }
    }
}

/// Moves the pairs of `row`, by the wires above it (buffer `own`) and below it (buffer `below`).
#[inline(always)]
unsafe fn nodes<L: Lanes, const UNIFORM: bool>(
    state: &mut State<L::Real>,
    row: usize,
    own: usize,
    below: usize,
    heights: DomeHeights,
) {
    let columns = state.columns.div_ceil(8) * 8;
    let mut column = 0;
    // SAFETY: the caller's promise about the instruction set.
    unsafe {
        while column + L::N <= columns {
            nodes_at::<L, UNIFORM>(state, row, column, own, below, heights);
            column += L::N;
        }
        while column < columns {
            nodes_at::<L::Tail, UNIFORM>(state, row, column, own, below, heights);
            column += L::Tail::N;
        }
    }
    if state.periodic {
        let (first, end) = (state.at(row, 0), state.at(row, state.columns));
        for plane in &mut state.moved[0] {
            plane[first - 1] = plane[end - 1];
            plane[end] = plane[first];
        }
    }
}

#[inline(always)]
unsafe fn nodes_at<L: Lanes, const UNIFORM: bool>(
    state: &mut State<L::Real>,
    row: usize,
    column: usize,
    own: usize,
    below: usize,
    heights: DomeHeights,
) {
    let at = state.at(row, column);
    let place = PAD + column;
    let block = (row * state.stride + column) / BLOCK;
    // Which wires from below end at this bottom node: see `lattice`.
    let (from_left, from_right) =
        if row % 2 == 1 { (place + 1, place) } else { (place, place - 1) };
    // SAFETY: as in `wires_at`.
    unsafe {
        let moved: [[L; 3]; 2] = std::array::from_fn(|end| {
            std::array::from_fn(|k| L::load(state.moved[end][k].as_ptr().add(at)))
        });
        // Twist, from bottom to top.
        let [b, t] = moved;
        let d = [t[0].sub(b[0]), t[1].sub(b[1]).add(L::splat(state.rest.0)), t[2].sub(b[2])];
        let values =
            if UNIFORM { None } else { Some([0, 1].map(|k| state.own[0][k].as_ptr().add(at))) };
        let kind = KindLanes::<L>::new(&state.kinds[0]);
        let pull = kind.pull(d, state.top[0].as_mut_ptr().add(at), values);
        let mut force: [[L; 3]; 2] = [[pull; 3]; 2];
        for k in 0..3 {
            let twist = pull.mul(d[k]);
            let load = |buffer: usize, side: usize, from: usize| {
                L::load(state.wires[buffer][side][k].as_ptr().add(from))
            };
            force[0][k] = twist.sub(load(below, 0, from_left).add(load(below, 1, from_right)));
            force[1][k] = load(own, 0, place).add(load(own, 1, place)).sub(twist);
        }
        if state.near[block] {
            contact(state, row, column, &moved, &mut force, heights);
        }
        if state.holds[block] {
            let sum = state.sums[1].as_mut_ptr().add(place);
            let held = [0, 1].map(|end| L::load(state.held[end].as_ptr().add(at)));
            let support = held[0].mul(force[0][2]).add(held[1].mul(force[1][2]));
            L::load(sum).add(support).store(sum);
        }
        let keep = L::splat(state.keep);
        let grain = L::splat(state.grain);
        let mut mobility = [0, 1, 2].map(|k| L::load(state.inertia[k].as_ptr().add(at)));
        for k in 0..3 {
            if k == 2 {
                let factor = L::splat(state.out_of_plane);
                mobility = mobility.map(|m| m.mul(factor));
            }
            for end in 0..2 {
                let velocity = state.velocity[end][k].as_mut_ptr().add(at);
                let gain = mobility[end].mul(force[end][k]).add(mobility[2].mul(force[1 - end][k]));
                let v = L::load(velocity).mul(keep).add(gain).add(grain).sub(grain);
                v.store(velocity);
                moved[end][k].add(v).store(state.moved[end][k].as_mut_ptr().add(at));
            }
        }
    }
}

/// Adds the dome's push on the nodes of a block and sums it up.
#[inline(always)]
unsafe fn contact<L: Lanes>(
    state: &mut State<L::Real>,
    row: usize,
    column: usize,
    moved: &[[L; 3]; 2],
    force: &mut [[L; 3]; 2],
    heights: DomeHeights,
) {
    // SAFETY: as in `wires_at`.
    unsafe {
        let place = PAD + column;
        let values = &state.dome;
        let dome = DomeLanes::<L> {
            cap_reach: L::splat(values.cap_reach),
            rim_reach: L::splat(values.rim_reach),
            ring: L::splat(values.ring),
            seam: L::splat(values.seam),
            stiffness: L::splat(values.stiffness),
            cap_height: L::splat(L::Real::new(heights.cap)),
            ring_height: L::splat(L::Real::new(heights.ring)),
        };
        let across = L::load(state.across[row % 2].as_ptr().add(place));
        let sum = state.sums[0].as_mut_ptr().add(place);
        let mut total = L::load(sum);
        for end in 0..2 {
            let u = moved[end];
            let p = [u[0].add(across), u[1].add(L::splat(state.along[row][end])), u[2]];
            let push = dome.push(p);
            for k in 0..3 {
                force[end][k] = force[end][k].add(push[k]);
            }
            total = total.add(push[2]);
        }
        total.store(sum);
    }
}
