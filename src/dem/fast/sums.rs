//! The fast solver's sums of forces: on each dome, and of each row of anchors along x, y and z.
//!
//! Each is a row of numbers by column, to which every row of the net adds what acts on it there. Which of
//! the anchors of a row a column belongs to is looked up when the sums are read.
//!
//! *Order.* Single precision sums depend on their order, and a field of several cells must give each of them
//! what one cell has. There the rows above an anchor's centre come first and those below it, which stand at the
//! cell's upper end, last. In a field the lower rows of all but the first row of anchors are met first: they
//! have sums of their own, which are added at the end of each step ([`Sums::settle`]).

use super::super::scene::Scene;
use super::lanes::Real;
use super::places::{BLOCK, Places};
use super::plane::Plane;

/// A block of neighbouring columns of a row, the first of which counts, and the sums that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Window {
    /// Place in the planes.
    pub(super) at: usize,
    /// Place in the sums.
    pub(super) sum: usize,
    /// Number of the dome; 0 of what is held.
    pub(super) dome: usize,
}

/// The sums; see the head of this file. `all` has a row's places for each dome, then three for each row of
/// anchors, then three for each late row.
#[derive(Debug, Clone)]
pub(super) struct Sums<R: Copy> {
    /// All rows of sums.
    pub(super) all: Plane<R>,
    /// Places of a row.
    places: usize,
    /// What is held, row by row: no two windows share a column, and what is between held nodes adds nothing.
    pub(super) held: Vec<Window>,
    /// What may touch a dome until the next search, row by row for each dome; else as above.
    pub(super) pushed: Vec<Window>,
    /// Which blocks of late sums are added to which, in the order of their rows.
    late: Vec<(usize, usize)>,
    /// Anchors in a row and rows of them; none in the laboratory.
    anchors: [usize; 2],
    /// Which anchor of a row each column of the net is nearest to, in even rows and in odd ones.
    nearest: [Vec<usize>; 2],
    domes: usize,
    /// Columns of a cell, and of the net.
    columns: [usize; 2],
}

impl<R: Real> Sums<R> {
    /// The sums of a scene whose pairs stand at these places.
    pub(super) fn new(scene: &Scene, net: &Places) -> Sums<R> {
        let places = net.sums();
        let lattice = &scene.lattice;
        let (field, domes) = (&scene.field, scene.field.blocks.len());
        let anchored = lattice.periodic;
        let anchor = |row: usize, column: usize, end: usize| {
            let (nodes, cell) = scene.in_its_cell(row, column);
            (field.nearest_anchor(nodes[end], cell).0, cell)
        };
        let mut late = Vec::new();
        let rows = if anchored { field.rows[1] } else { 1 };
        // Which sums a row of the net adds its held nodes' forces to.
        let mut target = Vec::with_capacity(lattice.rows);
        for row in 0..lattice.rows {
            // A plate is far smaller than a cell, so both nodes of a held pair have the same anchor.
            let ([_, above], [_, cell]) =
                if anchored { anchor(row, 0, 1) } else { ([0, 0], [0, 0]) };
            let sums = domes + 3 * above;
            // One cell is not staggered, so there is none to be compared with.
            if above > cell && field.repeats() == [1, 1] {
                target.push(domes + 3 * (rows + late.len()));
                late.push((domes + 3 * (rows + late.len()), sums));
            } else {
                target.push(sums);
            }
        }
        let in_row = |of: f64| {
            let column = |c| field.nearest_in_row(lattice.bottom(0, c)[0], of).0;
            (0..lattice.columns).map(|c| if anchored { column(c) } else { 0 }).collect()
        };
        let all = Plane::new(R::default(), places * (domes + 3 * (rows + late.len())));
        let mut held = Vec::new();
        for (row, target) in target.into_iter().enumerate() {
            let counts = |column: usize| {
                let fixed = scene.fixed[row * lattice.columns + column];
                if fixed[0] || fixed[1] { Ok(()) } else { Err(1) }
            };
            windows(&mut held, net, row, target * places, 0, counts);
        }
        let late = late
            .into_iter()
            .flat_map(|(late, to)| {
                let own = move |window: &&Window| window.sum / places == late;
                let held = held.iter().filter(own);
                held.map(move |window| (window.sum, window.sum % places + to * places))
            })
            .collect();
        Sums {
            all,
            places,
            held,
            pushed: Vec::new(),
            late,
            anchors: if anchored { field.rows } else { [0, 0] },
            nearest: [in_row(0.0), in_row(1.0)],
            domes,
            columns: [lattice.columns / field.cells[0], lattice.columns],
        }
    }

    /// Sets all to zero.
    pub(super) fn clear(&mut self) {
        self.all.fill(R::default());
    }

    /// Adds the late sums of a step to those that they belong to; tells if there are any.
    pub(super) fn settle(&mut self) -> bool {
        for &(late, to) in &self.late {
            for k in 0..3 {
                let [from, into] = [late, to].map(|first| first + k * self.places);
                let (front, back) = self.all.split_at_mut(from);
                let sums = &mut front[into..into + BLOCK];
                for (sum, late) in sums.iter_mut().zip(&mut back[..BLOCK]) {
                    *sum = R::new(sum.wide() + late.wide());
                    *late = R::default();
                }
            }
        }
        !self.late.is_empty()
    }

    /// Looks anew for what may touch a dome: the blocks of `near` that have its bit.
    pub(super) fn find_pushed(&mut self, net: &Places, near: &[u8]) {
        self.pushed.clear();
        for dome in 0..self.domes {
            for row in 0..net.rows {
                let counts = |column: usize| {
                    let at = net.at(row, column);
                    if near[at / BLOCK] >> dome & 1 == 1 { Ok(()) } else { Err(BLOCK - at % BLOCK) }
                };
                windows(&mut self.pushed, net, row, dome * self.places, dome, counts);
            }
        }
    }

    /// Mean force on the domes, N, over so many steps.
    pub(super) fn punch(&self, steps: usize) -> f64 {
        let total: f64 = (0..self.domes).map(|dome| self.total(dome, |_| true, steps)).sum();
        total / self.domes as f64
    }

    /// Mean force of the fixed nodes along z per dome, N.
    pub(super) fn support(&self, steps: usize) -> f64 {
        let [columns, rows] = self.anchors;
        if columns * rows <= 1 {
            return self.total(self.domes + 2, |_| true, steps);
        }
        let total: f64 = self.anchors(steps).iter().map(|force| force[2]).sum();
        total / self.domes as f64
    }

    /// Mean force of each anchor, N, row by row.
    pub(super) fn anchors(&self, steps: usize) -> Vec<[f64; 3]> {
        let [columns, rows] = self.anchors;
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        places
            .map(|(row, column)| {
                [0, 1, 2].map(|k| {
                    let own = |place: usize| self.nearest[row % 2][place] == column;
                    self.total(self.domes + 3 * row + k, own, steps)
                })
            })
            .collect()
    }

    /// Sum of a row over the columns that count: in one order, whatever the vectors' width, and in that of
    /// one cell, however many there are.
    fn total(&self, row: usize, counts: impl Fn(usize) -> bool, steps: usize) -> f64 {
        let sums = &self.all[row * self.places..][..self.columns[1]];
        let mut total = 0.0;
        if self.columns[0] == self.columns[1] {
            return sums.iter().map(|x| x.wide()).sum::<f64>() / steps as f64; // All are the only cell's.
        }
        for within in 0..self.columns[0] {
            for place in (within..self.columns[1]).step_by(self.columns[0]) {
                if counts(place) {
                    total += sums[place].wide();
                }
            }
        }
        total / steps as f64
    }
}

/// Adds windows of a row to `list`: each begins at a column that counts, behind the one before it. What does not
/// count says how many columns there are until one may.
fn windows(
    list: &mut Vec<Window>,
    net: &Places,
    row: usize,
    sum: usize,
    dome: usize,
    counts: impl Fn(usize) -> Result<(), usize>,
) {
    let mut column = 0;
    while column < net.columns {
        match counts(column) {
            Ok(()) => {
                list.push(Window { at: net.at(row, column), sum: sum + column, dome });
                column += BLOCK;
            }
            Err(more) => column += more,
        }
    }
}
