//! One step of the fast solver, written once for every width of vector.
//!
//! Row by row: the forces of the twists of row i and of the single wires between rows i and i + 1 go
//! into the row's buffer; then the pairs of row i are moved, by the buffer of their own row and that
//! of the row below. The bonds of row i are computed before any node of row i moves, and those of
//! row i - 1 were too, so all forces belong to the same instant, with one pass over the net and no
//! scattered writes.

#![expect(
    clippy::inline_always,
    reason = "what uses an instruction set has to be compiled where that is enabled"
)]

use super::lanes::{Lanes, Real};
use super::state::{BLOCK, BondKind, DomeValues, NetShape, NetState, PAD};

/// Vectors of a kind's constants.
#[derive(Clone, Copy)]
struct KindLanes<'a, L: Lanes> {
    kind: &'a BondKind<L::Real>,
    knee: L,
    knee_force: L,
    unloading: L,
    rupture: L,
    per_length: L,
    ramp: L,
}

impl<'a, L: Lanes> KindLanes<'a, L> {
    #[inline(always)]
    unsafe fn new(kind: &'a BondKind<L::Real>) -> Self {
        // SAFETY: the caller promises the instruction set; registers alone are touched.
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
        // SAFETY: the caller promises the instruction set; registers alone are touched.
        unsafe {
            match &self.kind.shape {
                NetShape::Lines(lines) => {
                    let mut f = e.mul(L::splat(lines[0].0)).add(L::splat(lines[0].1));
                    for line in &lines[1..] {
                        f = f.min(e.mul(L::splat(line.0)).add(L::splat(line.1)));
                    }
                    f
                }
                NetShape::Hinges(first, hinges) => {
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
}

/// Forces over lengths, N/m, of three bonds whose ends are `d` apart; updates their largest strains
/// at `top`. `own` has 1/l1 and the ramp's slope of each where they differ from bond to bond.
///
/// Three bonds are dealt with together, step by step, because each step waits for the one before it
/// and the other bonds fill the wait.
#[inline(always)]
unsafe fn pulls<L: Lanes>(
    kinds: [&KindLanes<'_, L>; 3],
    d: [[L; 3]; 3],
    top: [*mut L::Real; 3],
    own: Option<[[*const L::Real; 2]; 3]>,
) -> [L; 3] {
    // SAFETY: the caller promises the instruction set, and a vector within a plane at each address.
    unsafe {
        let zero = L::splat(L::Real::default());
        let one = L::splat(L::Real::new(1.0));
        let mut square = [zero; 3];
        let mut inverse = [zero; 3];
        for b in 0..3 {
            let [x, y, z] = d[b];
            square[b] = x.mul(x).add(y.mul(y)).add(z.mul(z));
        }
        for b in 0..3 {
            inverse[b] = square[b].rsqrt();
        }
        let mut e = [zero; 3];
        let mut most = [zero; 3];
        let mut f = [zero; 3];
        let mut slope = [zero; 3];
        for b in 0..3 {
            let (per_length, ramp, unloading) = match own {
                None => (kinds[b].per_length, kinds[b].ramp, kinds[b].unloading.max(kinds[b].ramp)),
                Some(own) => {
                    let ramp = L::load(own[b][1]);
                    (L::load(own[b][0]), ramp, kinds[b].unloading.max(ramp))
                }
            };
            e[b] = square[b].mul(inverse[b]).mul(per_length).sub(one);
            most[b] = L::load(top[b]).max(e[b]);
            most[b].store(top[b]);
            slope[b] = unloading;
            f[b] = most[b].sub(kinds[b].knee).mul(ramp).add(kinds[b].knee_force);
        }
        let beyond = most[0].any_gt(kinds[0].knee)
            | most[1].any_gt(kinds[1].knee)
            | most[2].any_gt(kinds[2].knee);
        if beyond {
            for b in 0..3 {
                f[b] = most[b].select_gt(kinds[b].knee, kinds[b].curve(most[b]), f[b]);
            }
        }
        for b in 0..3 {
            f[b] = f[b].sub(slope[b].mul(most[b].sub(e[b]))).max(zero);
            f[b] = most[b].select_gt(kinds[b].rupture, zero, f[b]).mul(inverse[b]);
        }
        f
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
        // SAFETY: the caller promises the instruction set; registers alone are touched.
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

/// Where the planes are. Copied out of the state, so that a store into a plane cannot be taken for a
/// change of the state itself and everything here can stay in registers.
#[derive(Clone, Copy)]
struct Planes<R> {
    moved: [[*mut R; 3]; 2],
    velocity: [[*mut R; 3]; 2],
    inertia: [*const R; 3],
    top: [*mut R; 3],
    own: [[*const R; 2]; 3],
    forces: [[[*mut R; 3]; 3]; 3],
    held: [*const R; 2],
    across: *const R,
    sums: *mut R,
    target: *const usize,
    near: *const u8,
    holds: *const bool,
    stride: usize,
    places: usize,
    rows: usize,
    columns: usize,
}

impl<R: Real> Planes<R> {
    fn new(state: &mut NetState<R>) -> Planes<R> {
        Planes {
            moved: state.moved.each_mut().map(|end| end.each_mut().map(|p| p.as_mut_ptr())),
            velocity: state.velocity.each_mut().map(|end| end.each_mut().map(|p| p.as_mut_ptr())),
            inertia: state.inertia.each_ref().map(|p| p.as_ptr()),
            top: state.top.each_mut().map(|p| p.as_mut_ptr()),
            own: state.own.each_ref().map(|role| role.each_ref().map(|p| p.as_ptr())),
            forces: state
                .forces
                .each_mut()
                .map(|row| row.each_mut().map(|side| side.each_mut().map(|p| p.as_mut_ptr()))),
            held: state.held.each_ref().map(|p| p.as_ptr()),
            across: state.across.as_ptr(),
            sums: state.sums.all.as_mut_ptr(),
            target: state.sums.target.as_ptr(),
            near: state.near.as_ptr(),
            holds: state.holds.as_ptr(),
            stride: state.stride,
            places: state.sums.places,
            rows: state.rows,
            columns: state.columns,
        }
    }

    fn at(&self, row: usize, column: usize) -> usize {
        PAD + row * self.stride + column
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

/// What stays the same during a step.
#[derive(Clone, Copy)]
struct Step<'a, L: Lanes> {
    planes: Planes<L::Real>,
    kinds: &'a [BondKind<L::Real>; 2],
    rest: (L::Real, [L::Real; 2]),
    along: &'a [[L::Real; 2]],
    dome: DomeValues<L::Real>,
    heights: [L::Real; 2],
    out_of_plane: L::Real,
    keep: L::Real,
    grain: L::Real,
    periodic: bool,
}

/// Takes one step of `state` with the dome at `heights`.
///
/// # Safety
/// The processor has the instruction set of `L`.
#[inline(always)]
pub(crate) unsafe fn step<L: Lanes, const UNIFORM: bool>(
    state: &mut NetState<L::Real>,
    heights: DomeHeights,
) {
    let Some(last) = state.rows.checked_sub(1) else { return };
    if state.periodic {
        // The first row's bottoms, as they are before they move, are those above the last row.
        let (first, ghost) = (state.at(0, 0) - 1, state.at(state.rows, 0) - 1);
        let width = state.columns + 2;
        for plane in &mut state.moved[0] {
            plane.copy_within(first..first + width, ghost);
        }
    }
    let step = Step::<L> {
        planes: Planes::new(state),
        kinds: &state.kinds,
        rest: state.rest,
        along: &state.along,
        dome: state.dome,
        heights: [L::Real::new(heights.cap), L::Real::new(heights.ring)],
        out_of_plane: state.out_of_plane,
        keep: state.keep,
        grain: state.grain,
        periodic: state.periodic,
    };
    // SAFETY: the caller promises the instruction set; every row asked for is below `rows`, and the
    // planes are those of a `NetState`, which sizes them (see there).
    unsafe {
        bonds::<L, UNIFORM>(&step, last, LAST);
        let mut below = LAST;
        for row in 0..last {
            let own = row % 2;
            bonds::<L, UNIFORM>(&step, row, own);
            nodes::<L>(&step, row, own, below);
            below = own;
        }
        nodes::<L>(&step, last, LAST, below);
    }
}

/// Buffer of the last row's bonds: the first row needs their forces too. The other buffers belong to
/// even and odd rows.
const LAST: usize = 2;

/// Forces of a row's twists and of the single wires above it, into a buffer.
#[inline(always)]
unsafe fn bonds<L: Lanes, const UNIFORM: bool>(step: &Step<'_, L>, row: usize, own: usize) {
    let planes = &step.planes;
    // Whole vectors, then what is left of the row in steps of the shorter ones.
    let columns = planes.columns.div_ceil(8) * 8;
    let mut column = 0;
    // SAFETY: the caller promises the instruction set and a row that exists. `columns` is rounded up to
    // 8, which is at most the stride, so each vector starts and ends in the row; the ghosts are the
    // places before the first column and behind the last one, within the row buffer's pads.
    unsafe {
        while column + L::N <= columns {
            bonds_at::<L, UNIFORM>(planes, step.kinds, step.rest, row, column, own);
            column += L::N;
        }
        while column < columns {
            bonds_at::<L::Tail, UNIFORM>(planes, step.kinds, step.rest, row, column, own);
            column += L::Tail::N;
        }
        if step.periodic {
            let (first, end) = (PAD, PAD + planes.columns);
            let [_, left, right] = planes.forces[own];
            for k in 0..3 {
                *left[k].add(end) = *left[k].add(first);
                *right[k].add(first - 1) = *right[k].add(end - 1);
            }
        }
    }
}

/// The vectors of three planes at a place.
///
/// A function and not a closure: closures do not take part in forced inlining, without which the
/// vectors would go through memory.
#[inline(always)]
unsafe fn three<L: Lanes>(planes: [*mut L::Real; 3], at: usize) -> [L; 3] {
    // SAFETY: the caller promises the instruction set, and that a vector at `at` is within the planes.
    unsafe { [L::load(planes[0].add(at)), L::load(planes[1].add(at)), L::load(planes[2].add(at))] }
}

#[inline(always)]
unsafe fn bonds_at<L: Lanes, const UNIFORM: bool>(
    planes: &Planes<L::Real>,
    kinds: &[BondKind<L::Real>; 2],
    rest: (L::Real, [L::Real; 2]),
    row: usize,
    column: usize,
    own: usize,
) {
    let here = planes.at(row, column);
    let there = planes.at(row + 1, column);
    // Odd rows stand half an opening to the right (see `lattice`).
    let ends = if row.is_multiple_of(2) { [there - 1, there] } else { [there, there + 1] };
    // SAFETY: the caller promises the instruction set and a vector from `column` on within the row.
    // `here` is in a row of the planes and `there` in the next one, the last row's next being the ghost
    // row; a place to either side is still within the pads. Row buffers have a stride and two pads, and
    // `own` has the size of a plane where `UNIFORM` is false.
    unsafe {
        let twist = KindLanes::<L>::new(&kinds[0]);
        let single = KindLanes::<L>::new(&kinds[1]);
        let bottom = three::<L>(planes.moved[0], here);
        let top = three::<L>(planes.moved[1], here);
        let left = three::<L>(planes.moved[0], ends[0]);
        let right = three::<L>(planes.moved[0], ends[1]);
        let half = L::splat(rest.1[0]);
        let rise = L::splat(rest.1[1]);
        let length = L::splat(rest.0);
        let d = [
            [top[0].sub(bottom[0]), top[1].sub(bottom[1]).add(length), top[2].sub(bottom[2])],
            [left[0].sub(top[0]).sub(half), left[1].sub(top[1]).add(rise), left[2].sub(top[2])],
            [right[0].sub(top[0]).add(half), right[1].sub(top[1]).add(rise), right[2].sub(top[2])],
        ];
        let [a, b, c] = planes.own;
        let values = if UNIFORM {
            None
        } else {
            Some([
                [a[0].add(here), a[1].add(here)],
                [b[0].add(here), b[1].add(here)],
                [c[0].add(here), c[1].add(here)],
            ])
        };
        let [a, b, c] = planes.top;
        let most = [a.add(here), b.add(here), c.add(here)];
        let pull = pulls([&twist, &single, &single], d, most, values);
        for bond in 0..3 {
            for (along, plane) in d[bond].iter().zip(planes.forces[own][bond]) {
                pull[bond].mul(*along).store(plane.add(PAD + column));
            }
        }
    }
}

/// Moves the pairs of `row`, by its own bonds (buffer `own`) and those of the row below (`below`).
#[inline(always)]
unsafe fn nodes<L: Lanes>(step: &Step<'_, L>, row: usize, own: usize, below: usize) {
    let planes = &step.planes;
    let columns = planes.columns.div_ceil(8) * 8;
    let mut column = 0;
    // SAFETY: the caller promises the instruction set and a row that exists. `columns` is rounded up to
    // 8, which is at most the stride, so each vector starts and ends in the row; the ghosts are the
    // places before the first column and behind the last one, which every row of a plane has.
    unsafe {
        while column + L::N <= columns {
            nodes_at::<L, L>(step, row, column, own, below);
            column += L::N;
        }
        while column < columns {
            nodes_at::<L::Tail, L>(step, row, column, own, below);
            column += L::Tail::N;
        }
        if step.periodic {
            let (first, end) = (planes.at(row, 0), planes.at(row, planes.columns));
            for plane in planes.moved[0] {
                *plane.add(first - 1) = *plane.add(end - 1);
                *plane.add(end) = *plane.add(first);
            }
        }
    }
}

#[inline(always)]
unsafe fn nodes_at<L: Lanes<Real = W::Real>, W: Lanes>(
    step: &Step<'_, W>,
    row: usize,
    column: usize,
    own: usize,
    below: usize,
) {
    let planes = &step.planes;
    let at = planes.at(row, column);
    let place = PAD + column;
    let block = (row * planes.stride + column) / BLOCK;
    // Which wires from below end at this bottom node: see `lattice`.
    let (from_left, from_right) =
        if row % 2 == 1 { (place + 1, place) } else { (place, place - 1) };
    // SAFETY: the caller promises the instruction set and a vector from `column` on within a row that
    // exists: `at` is in the planes, `place` and a place to either side in the row buffers with their
    // pads, `block` in `near` and `holds`, which have a place for each block of each row, and each row's
    // target has three rows of sums behind it.
    unsafe {
        let moved = [three::<L>(planes.moved[0], at), three::<L>(planes.moved[1], at)];
        let twist = three::<L>(planes.forces[own][0], place);
        let up =
            [three::<L>(planes.forces[own][1], place), three::<L>(planes.forces[own][2], place)];
        let down = [
            three::<L>(planes.forces[below][1], from_left),
            three::<L>(planes.forces[below][2], from_right),
        ];
        let mut force = moved;
        for k in 0..3 {
            force[0][k] = twist[k].sub(down[0][k].add(down[1][k]));
            force[1][k] = up[0][k].add(up[1][k]).sub(twist[k]);
        }
        let mut domes = *planes.near.add(block);
        while domes != 0 {
            let dome = domes.trailing_zeros() as usize;
            contact::<L, W>(step, row, column, dome, &moved, &mut force);
            domes &= domes - 1;
        }
        if *planes.holds.add(block) {
            let held = [L::load(planes.held[0].add(at)), L::load(planes.held[1].add(at))];
            let first = *planes.target.add(row);
            for (k, (bottom, top)) in force[0].iter().zip(&force[1]).enumerate() {
                let sum = planes.sums.add((first + k) * planes.places + place);
                let support = held[0].mul(*bottom).add(held[1].mul(*top));
                L::load(sum).add(support).store(sum);
            }
        }
        let keep = L::splat(step.keep);
        let grain = L::splat(step.grain);
        let [a, b, c] = planes.inertia;
        let mut mobility = [L::load(a.add(at)), L::load(b.add(at)), L::load(c.add(at))];
        for k in 0..3 {
            if k == 2 {
                let factor = L::splat(step.out_of_plane);
                mobility =
                    [mobility[0].mul(factor), mobility[1].mul(factor), mobility[2].mul(factor)];
            }
            for end in 0..2 {
                let velocity = planes.velocity[end][k].add(at);
                let gain = mobility[end].mul(force[end][k]).add(mobility[2].mul(force[1 - end][k]));
                let v = L::load(velocity).mul(keep).add(gain).add(grain).sub(grain);
                v.store(velocity);
                moved[end][k].add(v).store(planes.moved[end][k].add(at));
            }
        }
    }
}

/// Adds a dome's push on the nodes of a block and sums it up.
#[inline(always)]
unsafe fn contact<L: Lanes<Real = W::Real>, W: Lanes>(
    step: &Step<'_, W>,
    row: usize,
    column: usize,
    dome: usize,
    moved: &[[L; 3]; 2],
    force: &mut [[L; 3]; 2],
) {
    // SAFETY: as in `nodes_at`, which hands on its own row and column, and a dome that exists: each has two
    // rows in `across` and one of sums.
    unsafe {
        let place = PAD + column;
        let (planes, along) = (&step.planes, &step.along[dome * step.planes.rows + row]);
        let values = &step.dome;
        let shape = DomeLanes::<L> {
            cap_reach: L::splat(values.cap_reach),
            rim_reach: L::splat(values.rim_reach),
            ring: L::splat(values.ring),
            seam: L::splat(values.seam),
            stiffness: L::splat(values.stiffness),
            cap_height: L::splat(step.heights[0]),
            ring_height: L::splat(step.heights[1]),
        };
        let across = L::load(planes.across.add((2 * dome + row % 2) * planes.places + place));
        let sum = planes.sums.add(dome * planes.places + place);
        let mut total = L::load(sum);
        for end in 0..2 {
            let u = moved[end];
            let p = [u[0].add(across), u[1].add(L::splat(along[end])), u[2]];
            let push = shape.push(p);
            for k in 0..3 {
                force[end][k] = force[end][k].add(push[k]);
            }
            total = total.add(push[2]);
        }
        total.store(sum);
    }
}
