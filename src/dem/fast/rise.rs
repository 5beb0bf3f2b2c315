//! Inertia out of the plane, fitted to the net's slopes as it is punched (see
//! [`super::super::inertia`] for how much of it a slope needs).
//!
//! In one order of operations, so that the bits are the same on every processor.

use super::super::inertia::{self, PairInertia, PairModes};
use super::lanes::Real;
use super::places::{BLOCK, Places};
use super::state::NetState;

/// What a fit needs, in planes like the state's own.
#[derive(Debug, Clone)]
pub(super) struct Rise<R> {
    /// Inertia out of the plane over that in it which the dome's contact needs.
    contact: Vec<R>,
    /// Inertia out of the plane over that in it, now.
    now: Vec<R>,
    /// Largest squares of the sines of each pair's bonds, then the inertia that is to be.
    steep: Vec<R>,
    /// The same of a row's left and right wires.
    wires: [Vec<R>; 2],
    /// 1/l0^2 of twists and wires, 1/m^2.
    per_square: [R; 2],
    /// Force of a wire at rupture over its stiffness against unloading, both per unit of strain.
    tension: f64,
}

impl<R: Real> Rise<R> {
    /// Of a state with this inertia, pair by pair, these unloaded lengths of twists and wires, m, and this force of
    /// a wire at rupture over its stiffness.
    pub(super) fn new(
        state: &NetState<R>,
        pairs: &[PairInertia],
        lengths: [f64; 2],
        tension: f64,
    ) -> Rise<R> {
        let Places { columns, rows, len, .. } = state.places;
        let mut contact = vec![R::default(); len];
        for row in 0..rows {
            for column in 0..columns {
                contact[state.at(row, column)] =
                    R::new(inertia::rise_under_contact(&pairs[row * columns + column]));
            }
        }
        Rise {
            contact,
            now: vec![R::new(inertia::OUT_OF_PLANE); len],
            steep: vec![R::default(); len],
            wires: [vec![R::default(); columns], vec![R::default(); columns]],
            per_square: lengths.map(|l| R::new(1.0 / (l * l))),
            tension,
        }
    }

    /// Inertia out of the plane over that in it at a place, now.
    pub(super) fn at(&self, place: usize) -> f64 {
        self.now[place].wide()
    }

    /// Fits the inertia to the slopes of the net now, its tension at this utilisation and the contact within `near` (m)
    /// of a dome's axis; tells the kinetic energy that this adds to these modes of the pairs, J.
    pub(super) fn follow(
        &mut self,
        state: &mut NetState<R>,
        modes: &[PairModes],
        utilisation: f64,
        near: f64,
    ) -> f64 {
        if state.periodic {
            repeat_heights(state);
        }
        self.slopes(state);
        let floor = R::new(inertia::rise_under_tension(utilisation, self.tension));
        let [slope, most] = [inertia::SLOPE, inertia::STEEPEST].map(R::new);
        for steep in &mut self.steep {
            *steep = smaller(slope * *steep + floor, most);
        }
        self.under_domes(state, near);
        let Places { columns, rows, .. } = state.places;
        let mut added = 0.0;
        for row in 0..rows {
            let first = state.at(row, 0);
            let all = first..first + columns;
            let new = &self.steep[all.clone()];
            let ends = [0, 1].map(|end| &state.velocity[end][2][all.clone()]);
            let modes = &modes[row * columns..(row + 1) * columns];
            let planes = self.now[all.clone()].iter_mut().zip(&mut state.rise[all.clone()]);
            for (k, (now, rise)) in planes.enumerate() {
                let moving = modes[k].along(ends[0][k].wide(), ends[1][k].wide());
                added += (new[k].wide() - now.wide()) * moving;
                *now = new[k];
                *rise = R::new(1.0) / new[k];
            }
        }
        added
    }

    /// Adds what contact needs to pairs within `near` (m) of a dome's axis, in the blocks that it may touch.
    fn under_domes(&mut self, state: &NetState<R>, near: f64) {
        let square = R::new(near * near);
        for (block, domes) in state.near.iter().enumerate().filter(|(_, domes)| **domes != 0) {
            for (dome, [across, along @ ..]) in state.from_axis.iter().enumerate() {
                if domes >> dome & 1 == 0 {
                    continue;
                }
                for at in block * BLOCK..(block + 1) * BLOCK {
                    let within = |end: usize| {
                        let x = across[at] + state.moved[end][0][at];
                        let y = along[end][at] + state.moved[end][1][at];
                        x * x + y * y < square
                    };
                    if within(0) || within(1) {
                        self.steep[at] = self.steep[at] + self.contact[at];
                    }
                }
            }
        }
    }

    /// Squares of the sines of each pair's steepest bond, by its unloaded length.
    fn slopes(&mut self, state: &NetState<R>) {
        let (bottom, top) = (&state.moved[0][2], &state.moved[1][2]);
        let [twist, wire] = self.per_square;
        let Places { columns: n, rows, first, stride, .. } = state.places;
        self.steep.fill(R::default());
        for row in 0..rows {
            let here = state.at(row, 0);
            // As in the kernel: odd rows stand half an opening to the right.
            let left = match row % 2 {
                0 => here - first[0] + first[1] - 1,
                _ => here - first[1] + first[0] + stride,
            };
            let (b, t) = (&bottom[here..here + n], &top[here..here + n]);
            let (l, r) = (&bottom[left..left + n], &bottom[left + 1..left + 1 + n]);
            let [to_left, to_right] = &mut self.wires;
            let steep = &mut self.steep[here..here + n];
            for j in 0..n {
                let (b, t) = (b[j], t[j]);
                let (dl, dr, dt) = (l[j] - t, r[j] - t, t - b);
                to_left[j] = wire * dl * dl;
                to_right[j] = wire * dr * dr;
                let own = larger(twist * dt * dt, larger(to_left[j], to_right[j]));
                steep[j] = larger(steep[j], own);
            }
            for (first, wires) in [(left, &self.wires[0]), (left + 1, &self.wires[1])] {
                for (steep, wire) in self.steep[first..first + n].iter_mut().zip(wires) {
                    *steep = larger(*steep, *wire);
                }
            }
        }
        if state.periodic {
            // What went to the ghosts belongs to the pairs that they repeat.
            let above = first[0] + rows / 2 * stride;
            for k in 0..stride {
                let at = first[0] + k;
                self.steep[at] = larger(self.steep[at], self.steep[above + k]);
            }
            for (ghost, pair) in state.places.ghosts() {
                self.steep[pair] = larger(self.steep[pair], self.steep[ghost]);
            }
        }
    }
}

/// Lets the bottoms' ghosts of a periodic net stand as high as what they repeat does now.
fn repeat_heights<R: Real>(state: &mut NetState<R>) {
    let Places { rows, first, stride, .. } = state.places;
    let heights = &mut state.moved[0][2];
    for (ghost, pair) in state.places.ghosts() {
        heights[ghost] = heights[pair];
    }
    heights.copy_within(first[0]..first[0] + stride, first[0] + rows / 2 * stride);
}

/// The larger of two, the second where they cannot be compared; a comparison, which goes into vectors.
fn larger<R: Real>(a: R, b: R) -> R {
    if a > b { a } else { b }
}

/// The smaller of two, the second where they cannot be compared.
fn smaller<R: Real>(a: R, b: R) -> R {
    if a < b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::super::{Fast, FastOptions, Path};
    use super::*;
    use crate::dem::inertia::{CONTACT, FLOOR, SLOPE, StepFactors};
    use crate::dem::stepper::Stepper;
    use crate::dem::{Arrangement, PLAIN_PHASE, Scene, SceneSpec, Test};
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::laws;

    fn fast(fitted: bool) -> Fast<f32> {
        let spec = SceneSpec {
            layout: Layout { plate: 0.25, spacing: 1.6, punch: 0.5, ..REFERENCE },
            test: Test::Anchored,
            wire: laws::bench(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        let factors = StepFactors { translation: 1.1, stretching: 0.65 };
        let path = Path::best();
        let options = FastOptions { factors, damping: 0.002, true_unloading: false, fitted, path };
        Fast::new(&Scene::new(&spec).unwrap(), options)
    }

    /// The inertia of a pair, by its row and column.
    fn at(fast: &Fast<f32>, row: usize, column: usize) -> f64 {
        fast.rise()[row * fast.state.places.columns + column]
    }

    #[test]
    fn the_inertia_follows_the_steepest_bond_worked_by_hand() {
        let mut fast = fast(true);
        assert_eq!(at(&fast, 5, 0), inertia::OUT_OF_PLANE);
        assert_eq!(fast.follow(), 0.0, "a net at rest");
        assert!((at(&fast, 5, 0) - FLOOR).abs() < 1e-6);
        // Of a flat net under the dome: what contact needs as well.
        let Places { columns, rows, .. } = fast.state.places;
        let scene = fast.scene.clone();
        let middle = (0..rows * columns)
            .min_by(|a, b| {
                let apart = |k: &usize| {
                    let [x, y] = scene.from_axis(scene.lattice.bottom(k / columns, k % columns));
                    x.hypot(y)
                };
                apart(a).total_cmp(&apart(b))
            })
            .unwrap();
        assert!(fast.rise()[middle] > FLOOR + 0.5 / CONTACT);
        // A bottom of the first row 12 mm up: its twist and the two wires that reach it from the row below, which is
        // the last one, across the edge of the periodic net.
        let (twist, wire) = (scene.lattice.twist_length(), scene.lattice.wire_length());
        fast.state.put(0, 0, 0, [0.0, 0.0, 0.012]);
        fast.follow();
        let steep = |length: f64| SLOPE * (0.012 / length).powi(2) + FLOOR;
        assert!(twist < wire);
        assert!((at(&fast, 0, 0) - steep(twist)).abs() < 1e-6, "{}", at(&fast, 0, 0));
        // Odd rows stand half an opening to the right: the last column ends in the first one.
        for column in [0, columns - 1] {
            let found = at(&fast, rows - 1, column);
            assert!((found - steep(wire)).abs() < 1e-6, "{column}: {found}");
        }
        assert!((at(&fast, 1, 0) - FLOOR).abs() < 1e-6, "its tops are flat");
        assert!((at(&fast, rows - 1, 3) - FLOOR).abs() < 1e-6);
    }

    #[test]
    fn what_a_change_adds_is_the_kinetic_energy_that_comes() {
        let mut fast = fast(true);
        fast.follow();
        let place = fast.state.at(3, 4);
        fast.state.velocity[0][2][place] = 1.0e-3;
        fast.state.velocity[1][0][place] = 2.0e-3;
        let before = fast.kinetic();
        fast.state.put(0, 3, 4, [0.0, 0.0, 0.02]);
        let added = fast.follow();
        assert!(added > 0.0);
        assert!((fast.kinetic() - before - added).abs() < 1e-9 * before, "{added}");
    }

    #[test]
    fn an_inertia_that_is_not_fitted_stays() {
        let mut fast = fast(false);
        fast.state.put(0, 0, 0, [0.0, 0.0, 0.012]);
        assert_eq!(fast.follow(), 0.0);
        assert!(fast.rise().iter().all(|rise| *rise == inertia::OUT_OF_PLANE));
    }
}
