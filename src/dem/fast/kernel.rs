//! One step of the fast solver, written once for every width of vector.
//!
//! Block by block of each kind of rows (see [`super::places`]): the forces of the bonds of an even and an odd
//! block go into buffers; then the pairs of the blocks before them are moved. A wire of an even row ends in the
//! odd row of the same number, half an opening to the left or right, so the even bonds are one block ahead; one
//! of an odd row ends a row further on, in nodes that have not moved yet. So all forces belong to the same
//! instant, with one pass over the net and no scattered writes. The first even row needs the forces of the last
//! odd one, which are computed beforehand. What the domes and the anchors feel is summed up row by row at the
//! end.
//!
//! The buffers of forces hold a panel of some blocks and what is still needed of those before it, so that they
//! stay in the processor's nearest cache.

#![expect(
    clippy::inline_always,
    reason = "what uses an instruction set has to be compiled where that is enabled"
)]

use super::super::field::MOST_BLOCKS;
use super::force::{DomeLanes, KindLanes, pulls};
use super::lanes::{Lanes, Real};
use super::places::{BLOCK, Places};
use super::state::{BondKind, DomeValues, NetState};
use super::sums::Window;

/// Where the planes are. Copied out of the state, so that a store into a plane cannot be taken for a
/// change of the state itself and everything here can stay in registers.
#[derive(Clone, Copy)]
struct Planes<R> {
    moved: [[*mut R; 3]; 2],
    velocity: [[*mut R; 3]; 2],
    inertia: [*const R; 3],
    rise: *const R,
    top: [*mut R; 3],
    own: [[*const R; 2]; 3],
    /// At the first block of the panel.
    forces: [[[*mut R; 3]; 3]; 2],
    held: [*const R; 2],
    from_axis: [[*const R; 3]; MOST_BLOCKS],
    pushes: [[*mut R; 2]; MOST_BLOCKS],
    supports: [*mut R; 3],
    sums: *mut R,
    near: *const u8,
    holds: *const bool,
    places: Places,
}

impl<R: Real> Planes<R> {
    fn new(state: &mut NetState<R>) -> Planes<R> {
        let carried = state.places.carried;
        let mut from_axis = [[std::ptr::null(); 3]; MOST_BLOCKS];
        for (to, planes) in from_axis.iter_mut().zip(&state.from_axis) {
            *to = planes.each_ref().map(|p| p.as_ptr());
        }
        let mut pushes = [[std::ptr::null_mut(); 2]; MOST_BLOCKS];
        for (to, planes) in pushes.iter_mut().zip(&mut state.pushes) {
            *to = planes.each_mut().map(|p| p.as_mut_ptr());
        }
        Planes {
            moved: state.moved.each_mut().map(|end| end.each_mut().map(|p| p.as_mut_ptr())),
            velocity: state.velocity.each_mut().map(|end| end.each_mut().map(|p| p.as_mut_ptr())),
            inertia: state.inertia.each_ref().map(|p| p.as_ptr()),
            rise: state.rise.as_ptr(),
            top: state.top.each_mut().map(|p| p.as_mut_ptr()),
            own: state.own.each_ref().map(|role| role.each_ref().map(|p| p.as_ptr())),
            forces: state.forces.each_mut().map(|kind| {
                kind.each_mut()
                    .map(|role| role.each_mut().map(|p| p.as_mut_ptr().wrapping_add(carried)))
            }),
            held: state.held.each_ref().map(|p| p.as_ptr()),
            from_axis,
            pushes,
            supports: state.supports.each_mut().map(|p| p.as_mut_ptr()),
            sums: state.sums.all.as_mut_ptr(),
            near: state.near.as_ptr(),
            holds: state.holds.as_ptr(),
            places: state.places,
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

/// What stays the same during a step.
#[derive(Clone, Copy)]
struct Step<'a, L: Lanes> {
    planes: Planes<L::Real>,
    kinds: &'a [BondKind<L::Real>; 2],
    rest: (L::Real, [L::Real; 2]),
    dome: DomeValues<L::Real>,
    heights: [L::Real; 2],
    keep: L::Real,
    grain: L::Real,
}

/// Even and odd rows.
const EVEN: usize = 0;
const ODD: usize = 1;

/// Takes some steps of `state`, with the dome at `heights` of each.
///
/// # Safety
/// The processor has the instruction set of `L`.
#[inline(always)]
pub(crate) unsafe fn run<L: Lanes, const UNIFORM: bool>(
    state: &mut NetState<L::Real>,
    steps: usize,
    heights: &dyn Fn(usize) -> DomeHeights,
) {
    let mut step = Step::<L> {
        planes: Planes::new(state),
        kinds: &state.kinds,
        rest: state.rest,
        dome: state.dome,
        heights: [L::Real::default(); 2],
        keep: state.keep,
        grain: state.grain,
    };
    for number in 0..steps {
        let heights = heights(number);
        step.heights = [L::Real::new(heights.cap), L::Real::new(heights.ring)];
        // SAFETY: the caller promises the instruction set; the planes are those of a `NetState`, which sizes
        // them (see there), and nothing else looks at them meanwhile.
        unsafe {
            one::<L, UNIFORM>(&step, state.periodic);
            gather::<L>(&step.planes, &state.sums.pushed, &state.sums.held);
        }
        if state.sums.settle() {
            step.planes.sums = state.sums.all.as_mut_ptr();
        }
    }
}

/// Moves the net by one step.
#[inline(always)]
unsafe fn one<L: Lanes, const UNIFORM: bool>(step: &Step<'_, L>, periodic: bool) {
    let planes = &step.planes;
    let Places { blocks, panel, .. } = planes.places;
    // SAFETY: the caller promises the instruction set and planes of a `NetState`; every block asked for is
    // below `blocks` and within the panel, one before it or one behind it.
    unsafe {
        if periodic {
            move_ghosts(planes);
            repeat_first_row(planes);
        }
        beforehand::<L, UNIFORM>(step);
        let mut from = 0;
        while from < blocks {
            let to = (from + panel).min(blocks);
            for block in from..to {
                if block + 1 < blocks {
                    bonds::<L, UNIFORM, EVEN>(step, block + 1, from);
                }
                bonds::<L, UNIFORM, ODD>(step, block, from);
                // A block behind, so that what is read across has left the processor's store queue.
                if let Some(block) = block.checked_sub(1) {
                    nodes::<L, EVEN>(step, block, from);
                    nodes::<L, ODD>(step, block, from);
                }
            }
            if to < blocks {
                carry(planes);
            } else {
                nodes::<L, EVEN>(step, blocks - 1, from);
                nodes::<L, ODD>(step, blocks - 1, from);
            }
            from = to;
        }
    }
}

/// The first row's bottoms, as they are before they move, are those above the last row.
#[inline(always)]
unsafe fn repeat_first_row<R: Real>(planes: &Planes<R>) {
    let Places { stride, rows, first, .. } = planes.places;
    // SAFETY: both rows are in the planes, the second behind the last even one.
    unsafe {
        for plane in planes.moved[0] {
            let from = plane.add(first[EVEN]);
            from.copy_to_nonoverlapping(from.add(rows / 2 * stride), stride);
        }
    }
}

/// Forces that are needed before their turn: of the last odd row with its ghost, as those of a row before the
/// first one, of the ghost before the first odd row, and of the first even block. They come again in their turn,
/// with the same bits, as nothing that they are made of moves before.
#[inline(always)]
unsafe fn beforehand<L: Lanes, const UNIFORM: bool>(step: &Step<'_, L>) {
    let Places { stride, rows, .. } = step.planes.places;
    let last = ((rows.div_ceil(2) - 1) * stride) as isize - 1;
    let stride = stride as isize;
    // SAFETY: the caller promises the instruction set. The vectors are within the planes, whose first place is
    // a block before the first odd row, and before the panel is room for a row and a ghost.
    unsafe {
        let mut k = 0;
        while k < stride {
            bonds_at::<L, UNIFORM, ODD>(step, last + k, k - stride - 1);
            k += L::N as isize;
        }
        bonds_at::<L, UNIFORM, ODD>(step, -1, -1);
        bonds::<L, UNIFORM, EVEN>(step, 0, 0);
    }
}

/// Brings the forces that the next panel needs of this one to where it looks for them.
#[inline(always)]
unsafe fn carry<R: Real>(planes: &Planes<R>) {
    let Places { carried, panel, .. } = planes.places;
    let way = panel * BLOCK;
    // SAFETY: a buffer has what is carried, a panel and a block, and a panel is at least as long as the rest.
    unsafe {
        for plane in planes.forces[EVEN].iter().flatten() {
            plane.add(way).sub(BLOCK).copy_to_nonoverlapping(plane.sub(BLOCK), 2 * BLOCK);
        }
        let [twist, wires @ ..] = planes.forces[ODD];
        for plane in twist {
            plane.add(way).sub(BLOCK).copy_to_nonoverlapping(plane.sub(BLOCK), BLOCK);
        }
        for plane in wires.iter().flatten() {
            plane.add(way).sub(carried).copy_to_nonoverlapping(plane.sub(carried), carried);
        }
    }
}

/// Lets the ghosts of a periodic net stand where the pairs do that they repeat. As [`Places::ghosts`] lists them, but
/// in a loop without iterators, as it is done in each step.
#[inline(always)]
unsafe fn move_ghosts<R: Real>(planes: &Planes<R>) {
    let Places { stride, columns, rows, first, .. } = planes.places;
    for end in 0..2 {
        for axis in 0..3 {
            let plane = planes.moved[end][axis];
            let mut row = 0;
            while row < rows / 2 * stride {
                // SAFETY: these are ghosts and pairs of the planes, see `Places::ghosts`.
                unsafe {
                    let (even, odd) = (plane.add(first[EVEN] + row), plane.add(first[ODD] + row));
                    *even.add(columns) = *even;
                    *odd.sub(1) = *odd.add(columns - 1);
                }
                row += stride;
            }
        }
    }
}

/// Adds what the domes and the anchors felt in a step to the sums, row by row.
#[inline(always)]
unsafe fn gather<L: Lanes>(planes: &Planes<L::Real>, pushed: &[Window], held: &[Window]) {
    let width = planes.places.sums();
    // SAFETY: the caller promises the instruction set; a window is a block of places within the planes and of
    // sums within theirs.
    unsafe {
        for window in pushed {
            let [bottom, top] = planes.pushes[window.dome];
            for k in (0..BLOCK).step_by(L::N) {
                let sum = planes.sums.add(window.sum + k);
                let at = window.at + k;
                L::load(sum).add(L::load(bottom.add(at))).add(L::load(top.add(at))).store(sum);
            }
        }
        for window in held {
            for (axis, plane) in planes.supports.into_iter().enumerate() {
                for k in (0..BLOCK).step_by(L::N) {
                    let sum = planes.sums.add(window.sum + axis * width + k);
                    L::load(sum).add(L::load(plane.add(window.at + k))).store(sum);
                }
            }
        }
    }
}

/// Forces of a block's twists and of the single wires above it, in the panel that begins with block `panel`.
#[inline(always)]
unsafe fn bonds<L: Lanes, const UNIFORM: bool, const KIND: usize>(
    step: &Step<'_, L>,
    block: usize,
    panel: usize,
) {
    for k in (0..BLOCK).step_by(L::N) {
        let (place, to) = (block * BLOCK + k, (block - panel) * BLOCK + k);
        // SAFETY: the caller promises the instruction set and a block that exists.
        unsafe { bonds_at::<L, UNIFORM, KIND>(step, place as isize, to as isize) };
    }
}

/// The vectors of three planes at a place.
///
/// A function and not a closure: closures do not take part in forced inlining, without which the
/// vectors would go through memory.
#[inline(always)]
unsafe fn three<L: Lanes>(planes: [*mut L::Real; 3], at: isize) -> [L; 3] {
    let [x, y, z] = planes;
    // SAFETY: the caller promises the instruction set, and that a vector at `at` is within the planes.
    unsafe { [L::load(x.offset(at)), L::load(y.offset(at)), L::load(z.offset(at))] }
}

/// Those of a vector, `place` places behind the first one of its kind of rows, `to` places behind the panel's
/// first one.
#[inline(always)]
unsafe fn bonds_at<L: Lanes, const UNIFORM: bool, const KIND: usize>(
    step: &Step<'_, L>,
    place: isize,
    to: isize,
) {
    let Step { planes, kinds, rest, .. } = step;
    let Places { first, stride, .. } = planes.places;
    let [even, odd] = first.map(|first| first as isize + place);
    // Odd rows stand half an opening to the right (see `lattice`).
    let (here, right) = if KIND == EVEN { (even, odd) } else { (odd, even + stride as isize + 1) };
    let ends = [right - 1, right];
    // SAFETY: the caller promises the instruction set and a vector in a block. Behind the last block of odd rows
    // the even ones have a row and a place more, and before each kind of rows there is a block. `own` has the
    // size of a plane where `UNIFORM` is false.
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
                [a[0].offset(here), a[1].offset(here)],
                [b[0].offset(here), b[1].offset(here)],
                [c[0].offset(here), c[1].offset(here)],
            ])
        };
        let [a, b, c] = planes.top;
        let most = [a.offset(here), b.offset(here), c.offset(here)];
        let pull = pulls([&twist, &single, &single], d, most, values);
        for bond in 0..3 {
            for (along, plane) in d[bond].iter().zip(planes.forces[KIND][bond]) {
                pull[bond].mul(*along).store(plane.offset(to));
            }
        }
    }
}

/// Moves the pairs of a block, by the forces of their own bonds and of the wires from below, which are in the
/// panel that begins with block `panel`.
#[inline(always)]
unsafe fn nodes<L: Lanes, const KIND: usize>(step: &Step<'_, L>, block: usize, panel: usize) {
    let first = step.planes.places.first[KIND];
    for k in (0..BLOCK).step_by(L::N) {
        let at = first + block * BLOCK + k;
        let from = (block * BLOCK + k) as isize - (panel * BLOCK) as isize;
        // SAFETY: the caller promises the instruction set and a block that exists.
        unsafe { nodes_at::<L, KIND>(step, at, from) };
    }
}

/// Those of a vector at a place of the planes, whose forces are `from` places behind the panel's first one.
#[inline(always)]
unsafe fn nodes_at<L: Lanes, const KIND: usize>(step: &Step<'_, L>, at: usize, from: isize) {
    let planes = &step.planes;
    let block = at / BLOCK;
    // SAFETY: the caller promises the instruction set and a vector in a block of the panel or in the one
    // before it, the forces of which are carried, as are those of a row and a place before them; behind the
    // last one there is another. `near` and `holds` have a place for each block of a plane.
    unsafe {
        let here = at as isize;
        let moved = [three::<L>(planes.moved[0], here), three::<L>(planes.moved[1], here)];
        let own = &planes.forces[KIND];
        let twist = three::<L>(own[0], from);
        let up = [three::<L>(own[1], from), three::<L>(own[2], from)];
        // Which wires from below end at this bottom node (see `lattice`): a left one, a right one.
        let below = &planes.forces[1 - KIND];
        let right = if KIND == ODD { from } else { from - planes.places.stride as isize - 1 };
        let down = [three::<L>(below[1], right + 1), three::<L>(below[2], right)];
        let mut force = moved;
        for k in 0..3 {
            force[0][k] = twist[k].sub(down[0][k].add(down[1][k]));
            force[1][k] = up[0][k].add(up[1][k]).sub(twist[k]);
        }
        let mut domes = *planes.near.add(block);
        while domes != 0 {
            let dome = domes.trailing_zeros() as usize;
            contact::<L>(step, at, dome, &moved, &mut force);
            domes &= domes - 1;
        }
        if *planes.holds.add(block) {
            let held = [L::load(planes.held[0].add(at)), L::load(planes.held[1].add(at))];
            for (k, (bottom, top)) in force[0].iter().zip(&force[1]).enumerate() {
                let support = held[0].mul(*bottom).add(held[1].mul(*top));
                support.store(planes.supports[k].add(at));
            }
        }
        let keep = L::splat(step.keep);
        let grain = L::splat(step.grain);
        let [a, b, c] = planes.inertia;
        let mut mobility = [L::load(a.add(at)), L::load(b.add(at)), L::load(c.add(at))];
        for k in 0..3 {
            if k == 2 {
                let factor = L::load(planes.rise.add(at));
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

/// Adds a dome's push on the nodes of a vector, and keeps it.
#[inline(always)]
unsafe fn contact<L: Lanes>(
    step: &Step<'_, L>,
    at: usize,
    dome: usize,
    moved: &[[L; 3]; 2],
    force: &mut [[L; 3]; 2],
) {
    // SAFETY: as in `nodes_at`, which hands on its own place, and a dome that exists.
    unsafe {
        let shape = DomeLanes::<L>::new(&step.dome, step.heights);
        let [across, along @ ..] = step.planes.from_axis[dome];
        let across = L::load(across.add(at));
        for end in 0..2 {
            let u = moved[end];
            let p = [u[0].add(across), u[1].add(L::load(along[end].add(at))), u[2]];
            let push = shape.push(p);
            for k in 0..3 {
                force[end][k] = force[end][k].add(push[k]);
            }
            push[2].store(step.planes.pushes[dome][end].add(at));
        }
    }
}
