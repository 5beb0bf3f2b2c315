//! The largest stable step, computed for the scene at hand.
//!
//! One step is v' = (1 - g) v + M^-1 f, u' = u + v' (see [`super::inertia`]). For a linear net with
//! f = -K u it is stable exactly while the largest eigenvalue of M^-1 K is below 2 (2 - g); without
//! damping that is the well-known omega dt < 2. All inertia falls with the square of the step
//! factors, so the largest factor follows from that eigenvalue at any other.
//!
//! Which K? The stiffest that the net may have, which is more than it has at any one time:
//!
//! - *All bonds at their stiffest tangent at once*: unloading, or the ramp where that is steeper.
//!   The largest eigenvalue `flat` of the flat net with these, its plates, edges and scatter, is found by
//!   a Lanczos iteration from a fixed start.
//! - *Any slope*: out of the plane the inertia is [`OUT_OF_PLANE`] of that in it. A part of the net
//!   tilted by the angle a has the stiffness along its slope met by 1 + sin^2 a times the inverse
//!   inertia, and the contact, across the slope, by 1 + cos^2 a times. With `contact` the eigenvalue
//!   of a pair held by the dome's contact alone, the two together have the sum of eigenvalues
//!   flat (1 + sin^2 a) + contact (1 + cos^2 a) and the product 2 flat contact; the larger of the two
//!   is largest at a = 0 or 90 degrees and there 2 `flat` or 2 `contact`. So the bound is
//!   2 max(`flat`, `contact`).
//! - *Any slope, fitted*: where the inertia out of the plane follows the slopes, stiffnesses of bonds and contacts
//!   are split into their parts in the plane and out of it. The matrix is the sum of two, and its largest eigenvalue
//!   at most the sum of theirs. In the plane a sloping net is no stiffer than the flat one, but for the contact:
//!   `flat` + `contact` (1 - n^2), with n the vertical part of its normal. Out of the plane all wires pull the same
//!   way, so each node's stiffness counts twice (the element bound of [`super::inertia`], 4 c^2), but by the square
//!   of its sine alone, over the inertia there, which is [`SLOPE`] times that square and `contact` / [`CONTACT`]
//!   under a dome: at most the larger of `slope` = 4 c^2 / [`SLOPE`] and [`CONTACT`] n^2. So the bound is
//!   flat + max([`CONTACT`], slope + contact).
//!
//! What is assumed: that slopes change little between two fits of the inertia, that the openings keep about their shape in their own plane (a net drawn out
//! until its wires lie along one another is up to twice as stiff that way), and that the tension of
//! the wires (force over length, a twentieth of the stiffness) does not matter. Tests hold the bound
//! against the eigenvalue of the deformed nets of the bench scenes at the first break, and against
//! runs beyond it.

use super::dome::CONTACT_STIFFNESS;
use super::fast::state::bond_values;
use super::fast::{stiffest, unloading};
use super::hash::uniform;
use super::inertia::{CONTACT, OUT_OF_PLANE, PairInertia, SLOPE, StepFactors, pairs};
use super::lattice::{Lattice, Role, bond_number, bond_of};
use super::scene::Scene;

/// Lanczos steps. Their largest eigenvalue comes from below: 1 % short at most on the bench scenes, 2.1 %
/// on nets whose bonds differ twentyfold in stiffness.
const ITERATIONS: usize = 16;
/// What the iteration may miss, as a part, added to its answer.
const MARGIN: f64 = 0.03;

/// Largest eigenvalues of M^-1 K at some step factors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eigenvalues {
    /// Of the flat net with all bonds at their stiffest.
    pub flat: f64,
    /// Of a pair held by the dome's contact alone.
    pub contact: f64,
    /// Of wires that all pull out of the plane, where the inertia there is fitted.
    pub slope: f64,
}

/// Columns and rows of the piece of net that stands for one whose bonds of a kind are all alike: such
/// a net's stiffest motion repeats after two pairs, and plates and edges only hold it back.
const PIECE: usize = 8;

impl Eigenvalues {
    /// Of a scene under these step factors; `full` with the true unloading.
    pub fn of_scene(scene: &Scene, full: bool, factors: StepFactors) -> Eigenvalues {
        let unloading = unloading(&scene.law, full);
        if scene.uniform() {
            let lattice =
                Lattice { columns: PIECE, rows: PIECE, periodic: true, ..scene.lattice.clone() };
            let kinds = Role::ALL.map(|role| {
                let bond = bond_values(scene, bond_number(0, role), role, unloading);
                bond.ramp.unloading / bond.taut
            });
            let stiffness = |number: usize| kinds[bond_of(number).1 as usize];
            let inertia = pairs(&lattice, &[[false; 2]; PIECE * PIECE], &stiffness, factors);
            return Eigenvalues::from_parts(&lattice, &inertia, &stiffness, factors);
        }
        let stiffness = stiffest(scene, unloading);
        let inertia = pairs(&scene.lattice, &scene.fixed, &|k| stiffness[k], factors);
        Eigenvalues::from_parts(&scene.lattice, &inertia, &|k| stiffness[k], factors)
    }

    /// Of a net with this inertia and these stiffnesses of bonds, N/m.
    fn from_parts(
        lattice: &Lattice,
        inertia: &[PairInertia],
        stiffness: &dyn Fn(usize) -> f64,
        factors: StepFactors,
    ) -> Eigenvalues {
        Eigenvalues {
            flat: Flat::new(lattice, inertia, stiffness).largest(ITERATIONS) * (1.0 + MARGIN),
            contact: CONTACT_STIFFNESS
                * inertia.iter().map(PairInertia::softest).fold(0.0, f64::max),
            slope: 4.0 * factors.translation * factors.translation / SLOPE,
        }
    }

    /// The bound on the eigenvalue of the net in any slope, with the inertia out of the plane fitted or not.
    pub fn any_slope(&self, fitted: bool) -> f64 {
        if fitted {
            self.flat + CONTACT.max(self.slope + self.contact)
        } else {
            self.flat.max(self.contact) / OUT_OF_PLANE
        }
    }

    /// Largest factor on the step factors that is stable when velocities lose the part `damping` in a
    /// step. All parts of the bound grow with its square, but for [`CONTACT`].
    pub fn largest_factor(&self, damping: f64, fitted: bool) -> f64 {
        let largest = 2.0 * (2.0 - damping);
        if fitted {
            let beside = (largest - CONTACT) / self.flat;
            beside.min(largest / (self.flat + self.slope + self.contact)).sqrt()
        } else {
            (largest / self.any_slope(false)).sqrt()
        }
    }
}

/// The flat net's stiffness and inertia, in the plane, as planes of numbers with a ghost column on
/// either side of a row and a ghost row behind the last. Single precision is plenty.
pub(crate) struct Flat {
    rows: usize,
    columns: usize,
    width: usize,
    /// Stiffness of twists, left and right wires, N/m; 0 where there is none.
    stiffness: [Vec<f32>; 3],
    /// Square root of a pair's inverse inertia: bottom, top, across.
    root: [Vec<f32>; 3],
    /// Direction of a right wire.
    along: [f32; 2],
}

/// Components of the two nodes of the pairs: bottom x and y, top x and y.
type Vector = [Vec<f32>; 4];

/// Numbers summed side by side: the same order, and so the same sum, whatever the processor.
const SIDE: usize = 8;

impl Flat {
    /// The net of these pairs and bonds.
    pub(crate) fn new(
        lattice: &Lattice,
        inertia: &[PairInertia],
        stiffness: &dyn Fn(usize) -> f64,
    ) -> Flat {
        let (rows, columns) = (lattice.rows, lattice.columns);
        let width = columns + 2;
        let size = ((rows + 1) * width).div_ceil(SIDE) * SIDE;
        let zeros = || vec![0.0_f32; size];
        let mut flat = Flat {
            rows,
            columns,
            width,
            stiffness: [zeros(), zeros(), zeros()],
            root: [zeros(), zeros(), zeros()],
            along: [
                (lattice.opening / 2.0 / lattice.wire_length()) as f32,
                (lattice.projection / lattice.wire_length()) as f32,
            ],
        };
        for row in 0..rows {
            for column in 0..columns {
                let (pair, at) = (row * columns + column, row * width + 1 + column);
                for (k, role) in Role::ALL.into_iter().enumerate() {
                    if lattice.has(row, column, role) {
                        flat.stiffness[k][at] = stiffness(bond_number(pair, role)) as f32;
                    }
                }
                let PairInertia { own, cross } = inertia[pair];
                // Own terms are alike or one of them is 0, and then the cross term is too.
                let (sum, difference) = ((own[0] + cross).sqrt(), (own[0] - cross).sqrt());
                let both = own[0] > 0.0 && own[1] > 0.0;
                let across = if both { 0.5 * (sum - difference) } else { 0.0 };
                let one = |own: f64| if both { 0.5 * (sum + difference) } else { own.sqrt() };
                for (k, value) in [one(own[0]), one(own[1]), across].into_iter().enumerate() {
                    flat.root[k][at] = value as f32;
                }
            }
        }
        flat
    }

    /// Largest eigenvalue after this many Lanczos steps from a start that is always the same.
    pub(crate) fn largest(&self, steps: usize) -> f64 {
        let size = self.root[0].len();
        let zero = || -> Vector { std::array::from_fn(|_| vec![0.0; size]) };
        let (mut before, mut now, mut next, mut work) = (zero(), zero(), zero(), zero());
        for (k, plane) in now.iter_mut().enumerate() {
            for row in 0..self.rows {
                for column in 0..self.columns {
                    let at = row * self.width + 1 + column;
                    if self.root[k / 2][at] > 0.0 {
                        plane[at] = uniform(k as u64, at as u64) as f32 - 0.5;
                    }
                }
            }
        }
        let norm = dot(&now, &now).sqrt();
        if norm <= 0.0 {
            return 0.0; // All nodes are fixed.
        }
        scale(&mut now, 1.0 / norm);
        let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
        let mut last = 0.0;
        for _ in 0..steps {
            self.apply(&now, &mut work, &mut next);
            let alpha = dot(&now, &next);
            let (alpha32, last32) = (alpha as f32, last as f32);
            for k in 0..4 {
                for ((n, a), b) in next[k].iter_mut().zip(&now[k]).zip(&before[k]) {
                    *n -= alpha32 * a + last32 * b;
                }
            }
            diagonal.push(alpha);
            last = dot(&next, &next).sqrt();
            if last <= 1.0e-5 * alpha.abs() {
                break; // The start lay in a space that is now known whole.
            }
            beside.push(last);
            scale(&mut next, 1.0 / last);
            std::mem::swap(&mut before, &mut now);
            std::mem::swap(&mut now, &mut next);
        }
        largest_of(&diagonal, &beside)
    }

    /// `out` = R K R `x` with R the square root of the inverse inertia; `moved` is for its own use.
    fn apply(&self, x: &Vector, moved: &mut Vector, out: &mut Vector) {
        let width = self.width;
        self.weigh(x, moved);
        for plane in &mut moved[..2] {
            for row in 0..self.rows {
                let first = row * width + 1;
                let end = first + self.columns;
                (plane[first - 1], plane[end]) = (plane[end - 1], plane[first]);
            }
            plane.copy_within(0..width, self.rows * width);
        }
        // Forces: twists set them, wires add to them.
        for k in [0, 2] {
            out[k].fill(0.0);
        }
        for at in 0..self.root[0].len() {
            let pull = self.stiffness[0][at] * (moved[3][at] - moved[1][at]);
            out[1][at] = -pull;
            out[3][at] = pull;
        }
        let [c, s] = self.along;
        for row in 0..self.rows {
            let first = row * width + 1;
            for (role, c) in [(1, -c), (2, c)] {
                // Odd rows stand half an opening to the right (see `lattice`).
                let there = first + width + role + row % 2 - 2;
                let n = self.columns;
                let stiffness = &self.stiffness[role][first..first + n];
                let [bx, by, tx, ty] = moved.each_ref();
                let (bx, by) = (&bx[there..there + n], &by[there..there + n]);
                let (tx, ty) = (&tx[first..first + n], &ty[first..first + n]);
                let [fbx, fby, ftx, fty] = out.each_mut();
                let (fbx, fby) = (&mut fbx[there..there + n], &mut fby[there..there + n]);
                let (ftx, fty) = (&mut ftx[first..first + n], &mut fty[first..first + n]);
                for j in 0..n {
                    let pull = stiffness[j] * (c * (bx[j] - tx[j]) + s * (by[j] - ty[j]));
                    fbx[j] += c * pull;
                    fby[j] += s * pull;
                    ftx[j] -= c * pull;
                    fty[j] -= s * pull;
                }
            }
        }
        for plane in &mut out[..2] {
            for column in 0..width {
                plane[column] += plane[self.rows * width + column];
            }
            for row in 0..self.rows {
                let first = row * width + 1;
                let end = first + self.columns;
                plane[first] += plane[end];
                plane[end - 1] += plane[first - 1];
            }
        }
        std::mem::swap(moved, out);
        self.weigh(moved, out);
    }

    /// `out` = R `x`.
    fn weigh(&self, x: &Vector, out: &mut Vector) {
        for k in 0..2 {
            for at in 0..self.root[0].len() {
                let (b, t, across) = (self.root[0][at], self.root[1][at], self.root[2][at]);
                out[k][at] = b * x[k][at] + across * x[k + 2][at];
                out[k + 2][at] = t * x[k + 2][at] + across * x[k][at];
            }
        }
    }
}

fn scale(a: &mut Vector, factor: f64) {
    for x in a.iter_mut().flatten() {
        *x *= factor as f32;
    }
}

fn dot(a: &Vector, b: &Vector) -> f64 {
    let mut sums = [0.0_f32; SIDE];
    for (a, b) in a.iter().zip(b) {
        for (a, b) in a.chunks_exact(SIDE).zip(b.chunks_exact(SIDE)) {
            for k in 0..SIDE {
                sums[k] += a[k] * b[k];
            }
        }
    }
    sums.iter().map(|x| f64::from(*x)).sum()
}

/// Largest eigenvalue of a symmetric tridiagonal matrix, by bisection on the signs of its minors.
fn largest_of(diagonal: &[f64], beside: &[f64]) -> f64 {
    let n = diagonal.len();
    let off = |k: usize| if k < n.saturating_sub(1) { beside[k].abs() } else { 0.0 };
    let reach = |k: usize| off(k) + if k > 0 { off(k - 1) } else { 0.0 };
    let mut high = (0..n).map(|k| diagonal[k] + reach(k)).fold(0.0, f64::max);
    let mut low = diagonal.iter().copied().fold(0.0, f64::max);
    // Halved until it stands to a part in a million.
    while high - low > 1.0e-6 * high {
        let middle = 0.5 * (low + high);
        let (mut above, mut minor) = (0, 1.0_f64);
        for (k, own) in diagonal.iter().enumerate() {
            let side = if k > 0 { off(k - 1) * off(k - 1) / minor } else { 0.0 };
            minor = own - middle - side;
            if minor == 0.0 {
                minor = 1.0e-300;
            }
            above += usize::from(minor > 0.0);
        }
        if above > 0 { low = middle } else { high = middle }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::super::lattice::tests::NET;
    use super::*;
    use crate::dem::inertia::{StepFactors, pairs};

    #[test]
    fn the_eigenvalue_of_a_tridiagonal_matrix_is_the_closed_form() {
        // 2 on the diagonal, -1 beside it, n = 9: 2 - 2 cos(9 pi/10).
        let exact = 2.0 + 2.0 * (std::f64::consts::PI / 10.0).cos();
        assert!((largest_of(&[2.0; 9], &[-1.0; 8]) / exact - 1.0).abs() < 2.0e-6);
        assert!((largest_of(&[3.0], &[]) - 3.0).abs() < 1.0e-5);
    }

    #[test]
    fn a_net_of_soft_twists_has_the_eigenvalue_worked_by_hand() {
        // Without twists and with nodes of inertia 1 each node has its two wires alone: along x each
        // wire counts k/2, and neighbours against each other give k/2 (2 + 2) = 2 k; along y the same.
        let lattice = Lattice::periodic(&NET, 0.8, [0.3, 0.3]);
        let alone = PairInertia { own: [1.0, 1.0], cross: 0.0 };
        let inertia = vec![alone; lattice.pairs()];
        let k = 5.0;
        let stiffness = |n: usize| if n.is_multiple_of(3) { 0.0 } else { k };
        let found = Flat::new(&lattice, &inertia, &stiffness).largest(60);
        assert!((found / (2.0 * k) - 1.0).abs() < 1.0e-4, "{found}");
        // Twists alone: two nodes against each other, 2 k.
        let stiffness = |n: usize| if n.is_multiple_of(3) { k } else { 0.0 };
        let found = Flat::new(&lattice, &inertia, &stiffness).largest(60);
        assert!((found / (2.0 * k) - 1.0).abs() < 1.0e-4, "{found}");
    }

    #[test]
    fn the_few_steps_that_are_taken_miss_less_than_the_margin() {
        for lattice in [Lattice::periodic(&NET, 3.0, [0.3, 0.1]), Lattice::panel(&NET, 2.0)] {
            let fixed = vec![[false; 2]; lattice.pairs()];
            for scatter in [0.0, 1.0, 20.0] {
                let stiffness = |n: usize| {
                    let twist = if n.is_multiple_of(3) { 6.0 } else { 1.0 };
                    1.0e6 * twist * (1.0 + scatter * uniform(3, n as u64).powi(8))
                };
                let factors = StepFactors { translation: 1.1, stretching: 0.65 };
                let inertia = pairs(&lattice, &fixed, &stiffness, factors);
                let flat = Flat::new(&lattice, &inertia, &stiffness);
                let (few, many) = (flat.largest(ITERATIONS), flat.largest(300));
                println!("scatter {scatter}: {few} after {ITERATIONS}, {many} after 300");
                assert!(few <= many * (1.0 + 1.0e-5) && few * (1.0 + MARGIN) > many);
            }
        }
    }
}
