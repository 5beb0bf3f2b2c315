//! Which blocks of places may touch the dome until the next search.
//!
//! A block is marked where one of its nodes is within the dome's reach and a [`MARGIN`] of its axis. It
//! is looked at anew after [`SEARCH`] steps, in which nodes move a few millimetres sideways in a
//! quasi-static test. Where wires snap they move faster: then every unmarked node is asked how many steps
//! it needs to the dome, at [`GAIN`] times its present speed, and the search comes by then. Nothing
//! bounds how a node gains speed; so a search also tells of a node that is within reach and was not
//! marked before.

use super::lanes::Real;
use super::places::{BLOCK, Places};
use super::state::NetState;

/// Steps between two searches at most.
const SEARCH: usize = 32;
/// Margin of the search, m.
pub(super) const MARGIN: f64 = 0.04;
/// Speed that a node may gain until the next search, over its present one.
const GAIN: f64 = 2.0;

/// What a search found beside the marks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Found {
    /// Steps until the next search, at least 1.
    pub(super) steps: usize,
    /// Whether a node within reach was not marked.
    pub(super) missed: bool,
}

/// Marks the blocks whose nodes may come within `reach` (m) of a punch's axis until the next search, with a
/// bit for each punch.
pub(super) fn search<R: Real>(state: &mut NetState<R>, reach: f64) -> Found {
    let outer = (reach + MARGIN) * (reach + MARGIN);
    let before = state.near.clone();
    let mut missed = false;
    let Places { columns, rows, .. } = state.places;
    state.near.fill(0);
    for dome in 0..state.domes() {
        let bit = 1 << dome;
        for row in 0..rows {
            for end in 0..2 {
                if far(state, dome, row, end, reach + MARGIN) {
                    continue;
                }
                for column in 0..columns {
                    let square = square_distance(state, dome, row, end, column);
                    if square < outer {
                        let block = state.at(row, column) / BLOCK;
                        state.near[block] |= bit;
                        missed |= square < reach * reach && before[block] & bit == 0;
                    }
                }
            }
        }
    }
    state.sums.find_pushed(&state.places, &state.near);
    forget(state, &before);
    Found { steps: steps_to(state, reach), missed }
}

/// Where a dome is near no longer it pushes nothing.
fn forget<R: Real>(state: &mut NetState<R>, before: &[u8]) {
    for (dome, pushes) in state.pushes.iter_mut().enumerate() {
        for (block, (before, now)) in before.iter().zip(&state.near).enumerate() {
            if before & !now & 1 << dome != 0 {
                for plane in &mut *pushes {
                    plane[block * BLOCK..][..BLOCK].fill(R::default());
                }
            }
        }
    }
}

/// Whether no node of a row's bottoms or tops can be this near to a punch's axis, however it moved along x.
fn far<R: Real>(state: &NetState<R>, dome: usize, row: usize, end: usize, near: f64) -> bool {
    let along = state.from_axis[dome][1 + end][state.at(row, 0)].wide().abs();
    // Rows at the punch need no look at how far their nodes have moved.
    along > near && along - most(row_of(state, &state.moved[end][1], row)) > near
}

/// The columns of a row in a plane.
fn row_of<'a, R: Real>(state: &NetState<R>, plane: &'a [R], row: usize) -> &'a [R] {
    let first = state.at(row, 0);
    &plane[first..first + state.places.columns]
}

/// Largest size of some numbers, in eight lanes.
fn most<R: Real>(numbers: &[R]) -> f64 {
    let larger = |most: f64, x: R| if x.wide().abs() > most { x.wide().abs() } else { most };
    let mut most = [0.0_f64; 8];
    let (eights, rest) = numbers.as_chunks::<8>();
    for eight in eights {
        for (most, x) in most.iter_mut().zip(eight) {
            *most = larger(*most, *x);
        }
    }
    let most = most.into_iter().fold(0.0, f64::max);
    rest.iter().fold(most, |most, x| larger(most, *x))
}

/// Steps until the first unmarked node may be within reach, 1 to [`SEARCH`].
fn steps_to<R: Real>(state: &NetState<R>, reach: f64) -> usize {
    // No node is quicker than this, m per step.
    let [x, y] = [0, 1].map(|k| most(&state.velocity[0][k]).max(most(&state.velocity[1][k])));
    let way = GAIN * (x * x + y * y).sqrt() * SEARCH as f64;
    if way <= MARGIN {
        return SEARCH;
    }
    let Places { columns, rows, .. } = state.places;
    let mut steps = SEARCH as f64;
    for dome in 0..state.domes() {
        for row in 0..rows {
            let far = [0, 1].map(|end| far(state, dome, row, end, reach + way));
            if far == [true; 2] {
                continue;
            }
            for column in 0..columns {
                let at = state.at(row, column);
                if state.near[at / BLOCK] >> dome & 1 == 1 {
                    continue;
                }
                for end in 0..2 {
                    let square = square_distance(state, dome, row, end, column);
                    if square > (reach + way) * (reach + way) {
                        continue;
                    }
                    let [x, y] = [0, 1].map(|k| state.velocity[end][k][at].wide());
                    let speed = GAIN * (x * x + y * y).sqrt();
                    let gap = square.sqrt() - reach;
                    if speed * steps > gap {
                        steps = gap / speed;
                    }
                }
            }
        }
    }
    (steps as usize).max(1)
}

/// Square of a node's distance from a punch's axis, m^2.
fn square_distance<R: Real>(
    state: &NetState<R>,
    dome: usize,
    row: usize,
    end: usize,
    column: usize,
) -> f64 {
    let at = state.at(row, column);
    let [across, along @ ..] = &state.from_axis[dome];
    let x = across[at].wide() + state.moved[end][0][at].wide();
    let y = along[end][at].wide() + state.moved[end][1][at].wide();
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::super::{Fast, FastOptions, Path};
    use super::*;
    use crate::dem::run::drive;
    use crate::dem::stepper::Stepper;
    use crate::dem::{Arrangement, Controls, Flow, PLAIN_PHASE, Scene, SceneSpec, Stop, Test};
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::laws;

    fn scene() -> Scene {
        let layout =
            Layout { plate: 0.25, spacing: 1.6, punch: 0.5, ex: 0.0, ey: 0.0, ..REFERENCE };
        let spec = SceneSpec {
            layout,
            test: Test::Anchored,
            wire: laws::bench(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        Scene::new(&spec).unwrap()
    }

    fn fast(scene: &Scene) -> Fast<f64> {
        let factors = Controls::default().scheme(scene).unwrap().factors;
        let options = FastOptions {
            factors,
            damping: 0.002,
            true_unloading: false,
            fitted: false,
            path: Path::best(),
        };
        Fast::new(scene, options)
    }

    /// The unmarked bottom node that is nearest to the axis: row, column, distance.
    fn nearest_unmarked(state: &NetState<f64>) -> (usize, usize, f64) {
        let places =
            (0..state.places.rows).flat_map(|r| (0..state.places.columns).map(move |c| (r, c)));
        places
            .filter(|(r, c)| state.near[state.at(*r, *c) / BLOCK] == 0)
            .map(|(r, c)| (r, c, square_distance(state, 0, r, 0, c).sqrt()))
            .min_by(|a, b| a.2.total_cmp(&b.2))
            .unwrap()
    }

    #[test]
    fn the_search_comes_before_a_fast_node_does() {
        let scene = scene();
        let mut fast = fast(&scene);
        let reach = scene.dome.reach();
        let state = &mut fast.state;
        assert_eq!(search(state, reach), Found { steps: SEARCH, missed: false });
        let (row, column, distance) = nearest_unmarked(state);
        let gap = distance - reach;
        assert!(gap >= MARGIN);
        // In a quasi-static test: half a millimetre a step is 16 mm until the next search.
        let at = state.at(row, column);
        state.velocity[0][0][at] = 0.000_5;
        assert_eq!(search(state, reach).steps, SEARCH);
        // A wire snaps: it is there in four steps, in two if it is twice as fast soon.
        state.velocity[0][0][at] = gap / 4.0;
        assert_eq!(search(state, reach).steps, 2);
        state.velocity[0][0][at] = 10.0 * gap;
        assert_eq!(search(state, reach).steps, 1);
        // Far from the punch the same speed takes no search forward.
        let corner = state.at(0, 0);
        let away = square_distance(state, 0, 0, 0, 0).sqrt() - reach;
        state.velocity[0][0][at] = 0.0;
        state.velocity[0][0][corner] = away / 70.0;
        assert_eq!(search(state, reach).steps, SEARCH);
    }

    #[test]
    fn a_node_that_came_under_the_dome_unseen_makes_the_run_diverge() {
        let scene = scene();
        let controls = Controls::default();
        let scheme = controls.scheme(&scene).unwrap();
        let mut fast = fast(&scene);
        fast.advance(8, 2.0e-4);
        let (row, column, _) = nearest_unmarked(&fast.state);
        let place = scene.from_axis(scene.lattice.bottom(row, column));
        // To the axis, below the dome's apex, where a push of newtons is missed.
        fast.state.put(0, row, column, [-place[0], -place[1], 0.0]);
        assert!(fast.advance(1, 2.0e-4).punch.is_finite(), "not looked for yet");
        assert!(fast.advance(SEARCH, 2.0e-4).punch.is_nan());
        let outcome = drive(&scene, &mut fast, &scheme, &controls, &mut |_| Flow::Continue);
        assert_eq!(outcome.stop, Stop::Diverged);
    }

    #[test]
    fn rows_from_afar_are_seen_where_they_really_are() {
        let scene = scene();
        let mut fast = fast(&scene);
        let (state, reach) = (&mut fast.state, scene.dome.reach());
        let y = scene.from_axis(scene.lattice.bottom(0, 3));
        state.put(0, 0, 3, [-y[0], -y[1], 0.0]);
        assert!(search(state, reach).missed && state.near[state.at(0, 3) / BLOCK] == 1);
        assert!(!search(state, reach).missed);
    }
}
