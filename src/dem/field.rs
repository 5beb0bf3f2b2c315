//! The field: how many cells of the anchored test are simulated together, and where a block stands in
//! each of them.
//!
//! Here x runs across the twists and y along them, whatever the layout's axes do: where the twists run across
//! the slope the two are exchanged on the way in, and places and forces on the way out ([`BlockField::turned`]).
//!
//! Each cell is a whole number of the net's periods and has an anchor at its corner (half a cell to the left
//! of and below its centre), so that all plates catch the same pattern of nodes. In a staggered grid the
//! anchor of every other cell of a row or column, and its block with it, stands half a cell further; two such
//! cells repeat, and their two plates may catch two patterns. The field goes on beyond its edges.

use crate::layout::Layout;
use crate::problem::Problem;
use crate::units::shortest;

/// How the blocks stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// The same block at the same place in every cell; so many cells in x and y are simulated, and in a
    /// staggered grid twice as many. One cell tells all where the wires are alike; more are there to be
    /// compared with as many mirrored ones.
    Repeated([usize; 2]),
    /// The block of cell (i, j) stands at ((-1)^i ex, (-1)^j ey) from its centre: blocks of neighbours face
    /// each other across the line of anchors between them. Two cells in each direction in which the block
    /// has an offset. The net is not mirrored.
    Mirrored,
    /// One block in a field of n x n cells; of a staggered grid n x (n + 1), which its rows need to close.
    Single(usize),
}

impl Default for Arrangement {
    /// One cell, repeated.
    fn default() -> Self {
        Arrangement::Repeated([1, 1])
    }
}

/// Cells of a field in one direction at most; keeps what a run takes in bounds.
const MOST_CELLS: usize = 15;
/// Blocks of a field at most: the fast solver keeps a bit for each.
pub(super) const MOST_BLOCKS: usize = 8;
/// A block of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Column and row of its cell.
    pub cell: [usize; 2],
    /// Its axis, from that cell's corner, m; in a shifted cell of a staggered grid it may lie in the next one.
    pub axis: [f64; 2],
}

/// The anchors of a staggered field: rows of them, in each of which they stand the same distance apart, and
/// every other row shifted by half of that. Where columns of cells are shifted and not rows, these rows are
/// half a cell apart and have an anchor in every other cell.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Staggered {
    /// Along which axis cells are shifted.
    axis: usize,
    /// Distance of anchors in a row, and of rows, m.
    pitch: [f64; 2],
}

/// The cells of a field and its blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockField {
    /// Sides of a cell, m.
    pub cell: [f64; 2],
    /// Cells in x and y.
    pub cells: [usize; 2],
    /// Whether neighbours in x and y are mirror images.
    pub mirrored: [bool; 2],
    /// Its blocks; never none.
    pub blocks: Vec<Block>,
    /// Anchors in a row, and rows of them.
    pub(super) rows: [usize; 2],
    /// How the grid is staggered, if it is.
    staggered: Option<Staggered>,
    /// Whether the layout's axes are exchanged here, because its twists run across the slope.
    across: bool,
}

impl BlockField {
    /// One cell with one block, which is also the panel of the laboratory test.
    pub(super) fn one(layout: &Layout) -> BlockField {
        let cell = layout.turned(layout.sides());
        let (farthest, offset) =
            (layout.turned(layout.farthest()), layout.turned([layout.ex, layout.ey]));
        let axis = [0, 1].map(|k| farthest[k] + offset[k]);
        BlockField {
            cell,
            cells: [1, 1],
            mirrored: [false; 2],
            blocks: vec![Block { cell: [0, 0], axis }],
            rows: [1, 1],
            staggered: None,
            across: layout.turned([false, true])[0],
        }
    }

    /// The field of an anchored test.
    ///
    /// # Errors
    /// Cells that are too many or too few; mirrored blocks that would overlap.
    pub(super) fn anchored(
        layout: &Layout,
        arrangement: Arrangement,
    ) -> Result<BlockField, Vec<Problem>> {
        let mut field = BlockField::one(layout);
        match arrangement {
            Arrangement::Repeated(cells) => {
                allow(cells)?;
                field.stagger(layout, cells, |n| 2 * n);
                field.fill(layout);
                if field.blocks.len() > MOST_BLOCKS {
                    return Err(vec![
                        Problem::new("blocks", "too many cells with a block each")
                            .allowed(format!("up to {MOST_BLOCKS}")),
                    ]);
                }
            }
            Arrangement::Mirrored => {
                facing(layout)?;
                let (ex, ey) = layout.folded();
                field.mirrored = layout.turned([ex != 0.0, ey != 0.0]);
                field.cells = field.mirrored.map(|doubled| if doubled { 2 } else { 1 });
                field.rows = field.cells;
                field.fill(layout);
            }
            Arrangement::Single(n) => {
                allow([n, n])?;
                field.stagger(layout, [n, n], |n| n + 1);
            }
        }
        Ok(field)
    }

    /// Makes the field so many cells; of a staggered grid `even` of them from row to row.
    fn stagger(&mut self, layout: &Layout, cells: [usize; 2], even: impl Fn(usize) -> usize) {
        (self.cells, self.rows) = (cells, cells);
        if !layout.grid.stagger {
            return;
        }
        let [axis, other] = if self.across { [1, 0] } else { [0, 1] };
        self.cells[other] = even(cells[other]);
        let mut pitch = self.cell;
        self.rows = self.cells;
        if self.across {
            pitch = [2.0 * self.cell[0], self.cell[1] / 2.0];
            self.rows = [self.cells[0] / 2, 2 * self.cells[1]];
        }
        self.staggered = Some(Staggered { axis, pitch });
    }

    /// Puts the blocks into the cells; those of two cells at one place are one block.
    fn fill(&mut self, layout: &Layout) {
        let offset = layout.turned([layout.ex, layout.ey]);
        let on_line = layout.turned([layout.on_line(0, layout.ex), layout.on_line(1, layout.ey)]);
        let farthest = layout.turned(layout.farthest());
        let shared = [0, 1].map(|k| self.mirrored[k] && on_line[k]);
        self.blocks.clear();
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let cell = [i, j];
                if (0..2).any(|k| shared[k] && cell[k] > 0) {
                    continue;
                }
                let axis = [0, 1].map(|k| {
                    let turned = self.mirrored[k] && cell[k] % 2 == 1;
                    let place = farthest[k] + if turned { -offset[k] } else { offset[k] };
                    place + self.shift(k, cell)
                });
                self.blocks.push(Block { cell, axis });
            }
        }
    }

    /// How far a cell's anchor and block are shifted along an axis, m.
    fn shift(&self, axis: usize, cell: [usize; 2]) -> f64 {
        match self.staggered {
            Some(grid) if grid.axis == axis && cell[1 - axis] % 2 == 1 => self.cell[axis] / 2.0,
            _ => 0.0,
        }
    }

    /// Sides of the whole field, m.
    pub fn size(&self) -> [f64; 2] {
        [0, 1].map(|k| self.cell[k] * self.cells[k] as f64)
    }

    /// Number of anchors, one for each cell.
    pub fn anchors(&self) -> usize {
        self.rows[0] * self.rows[1]
    }

    /// Cells after which the anchors repeat.
    pub(super) fn repeats(&self) -> [usize; 2] {
        match self.staggered {
            Some(Staggered { axis: 0, .. }) => [1, 2],
            Some(_) => [2, 1],
            None => [1, 1],
        }
    }

    /// Where an anchor stands, by its number (row by row), from the field's corner, m; in the layout's axes.
    pub(crate) fn anchor(&self, number: usize) -> [f64; 2] {
        let at = [number % self.rows[0], number / self.rows[0]].map(|n| n as f64);
        self.turned(match self.staggered {
            None => [0, 1].map(|k| self.cell[k] * at[k]),
            Some(Staggered { pitch, .. }) => {
                [pitch[0] * (at[0] + 0.5 * (at[1] % 2.0)), pitch[1] * at[1]]
            }
        })
    }

    /// A vector of the field's plane in the layout's axes.
    pub(crate) fn turned<T: Copy>(&self, [x, y]: [T; 2]) -> [T; 2] {
        if self.across { [y, x] } else { [x, y] }
    }

    /// A place, given from its cell's corner, seen from a block's axis, m; the nearest image of the block.
    ///
    /// Written with whole cells apart from what is within one, so that all cells see the same bits.
    pub(super) fn seen_from_block(
        &self,
        block: &Block,
        place: [f64; 2],
        cell: [usize; 2],
    ) -> [f64; 2] {
        [0, 1].map(|k| {
            let within = place[k] - block.axis[k];
            let apart = cell[k] as f64 - block.cell[k] as f64;
            let cells = self.cells[k] as f64;
            let images = ((within / self.cell[k] + apart) / cells).round();
            within + self.cell[k] * (apart - cells * images)
        })
    }

    /// The anchor nearest to a place, given from its cell's corner, by its number in a row and the row; and
    /// the place seen from it, m. In a staggered grid it is the nearest one of the nearest row, which is the
    /// one whose plate a held node is on.
    pub(super) fn nearest_anchor(
        &self,
        place: [f64; 2],
        cell: [usize; 2],
    ) -> ([usize; 2], [f64; 2]) {
        let Some(Staggered { pitch, .. }) = self.staggered else {
            let further = [0, 1].map(|k| (place[k] / self.cell[k]).round());
            let anchor = [0, 1].map(|k| wrapped(cell[k] as f64 + further[k], self.cells[k]));
            return (anchor, [0, 1].map(|k| place[k] - self.cell[k] * further[k]));
        };
        let from_corner = [0, 1].map(|k| place[k] + self.cell[k] * cell[k] as f64);
        let row = (from_corner[1] / pitch[1]).round();
        let (number, x) = self.nearest_in_row(from_corner[0], row);
        let seen = [x, from_corner[1] - pitch[1] * row];
        ([number, wrapped(row, self.rows[1])], seen)
    }

    /// Which anchor of a row is nearest to a place along it, given from the field's corner; and the place
    /// seen from it, m.
    pub(super) fn nearest_in_row(&self, x: f64, row: f64) -> (usize, f64) {
        let (pitch, shift) = match self.staggered {
            Some(Staggered { pitch, .. }) => (pitch[0], 0.5 * row.rem_euclid(2.0)),
            None => (self.cell[0], 0.0),
        };
        let number = (x / pitch - shift).round();
        (wrapped(number, self.rows[0]), x - pitch * (number + shift))
    }

    /// A place, given from the field's corner, as the block of its cell has it: from that cell's centre, m,
    /// and turned round where its cell is a mirror image. Of a field with one block, from the centre of the
    /// block's cell. In the layout's axes.
    pub(super) fn as_its_block(&self, place: [f64; 2]) -> [f64; 2] {
        let alone = self.blocks.len() == 1;
        let cell = [0, 1].map(|k| {
            (place[k] / self.cell[k]).floor().clamp(0.0, self.cells[k] as f64 - 1.0) as usize
        });
        self.turned([0, 1].map(|k| {
            let side = self.cell[k];
            let cells = self.cells[k] as f64;
            let from_centre = place[k] - side / 2.0;
            if self.cells[k] == 1 && self.staggered.is_none() {
                return from_centre;
            }
            if alone && !self.mirrored[k] {
                let size = side * cells;
                return from_centre - size * (from_centre / size).round();
            }
            let within = from_centre - side * cell[k] as f64;
            match self.shift(k, cell) {
                0.0 if self.mirrored[k] && cell[k] % 2 == 1 => -within,
                0.0 => within,
                shift => within - shift - side * ((within - shift) / side).round(),
            }
        }))
    }
}

/// A number of a ring of so many.
fn wrapped(number: f64, of: usize) -> usize {
    (number as i64).rem_euclid(of as i64) as usize
}

fn allow(cells: [usize; 2]) -> Result<(), Vec<Problem>> {
    if cells.iter().all(|n| (1..=MOST_CELLS).contains(n)) {
        return Ok(());
    }
    Err(vec![
        Problem::new("blocks", "so many cells are not simulated")
            .value(format!("{} x {}", cells[0], cells[1]))
            .allowed(format!("1 to {MOST_CELLS} in a direction")),
    ])
}

/// What is said of mirrored blocks that would overlap.
pub(crate) const OVERLAP: &str = "mirrored blocks of neighbouring cells would overlap";

/// What is said of mirrored blocks on a staggered grid.
pub(crate) const NO_MIRROR: &str =
    "blocks of a staggered grid have no anchor line to face each other across";

/// Whether blocks can face each other.
fn facing(layout: &Layout) -> Result<(), Vec<Problem>> {
    if layout.grid.stagger {
        return Err(vec![
            Problem::new("blocks", NO_MIRROR).value("mirrored").allowed("repeated, single, worst"),
        ]);
    }
    let Some(field) = layout.blocks_overlap() else { return Ok(()) };
    let (axis, value) = if field == "ex" { (0, layout.ex) } else { (1, layout.ey) };
    let (side, word) = (layout.sides()[axis], layout.words()[axis]);
    Err(vec![Problem::new(field, OVERLAP).value(format!("{} m", shortest(value))).allowed(
        format!(
            "within ({word} - D)/2 = {} m, or half the spacing exactly: one block on the line",
            shortest((side - layout.punch) / 2.0)
        ),
    )])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    fn field(ex: f64, ey: f64, arrangement: Arrangement) -> BlockField {
        BlockField::anchored(&Layout { ex, ey, ..REFERENCE }, arrangement).unwrap()
    }

    #[test]
    fn mirrored_blocks_stand_where_worked_by_hand() {
        let f = field(0.5, -0.2, Arrangement::Mirrored);
        assert_eq!((f.cells, f.size(), f.anchors()), ([2, 2], [6.0, 6.0], 4));
        let places: Vec<[f64; 2]> =
            f.blocks.iter().map(|b| [0, 1].map(|k| b.axis[k] + 3.0 * b.cell[k] as f64)).collect();
        // Centres at 1.5 and 4.5 m; +0.5 then -0.5 along x, -0.2 then +0.2 along y.
        assert_eq!(places, [[2.0, 1.3], [4.0, 1.3], [2.0, 4.7], [4.0, 4.7]]);
        // Only where there is an offset; a centred block is the repeated one.
        assert_eq!(field(0.5, 0.0, Arrangement::Mirrored).cells, [2, 1]);
        assert_eq!(field(0.0, 0.5, Arrangement::Mirrored).cells, [1, 2]);
        let centred = field(0.0, 0.0, Arrangement::Mirrored);
        assert_eq!(centred, field(0.0, 0.0, Arrangement::default()));
    }

    #[test]
    fn blocks_half_the_spacing_off_are_one_on_the_line_and_nearer_ones_overlap() {
        let f = field(1.5, 0.3, Arrangement::Mirrored);
        // One for two cells along x.
        assert_eq!((f.blocks.len(), f.anchors()), (2, 4));
        assert_eq!(field(-1.5, 1.5, Arrangement::Mirrored).blocks.len(), 1);
        // L 3, D 1: up to 1 m.
        let refused = |ex: f64| {
            let layout = Layout { ex, ..REFERENCE };
            BlockField::anchored(&layout, Arrangement::Mirrored).unwrap_err()[0].field.clone()
        };
        assert_eq!(refused(1.001), "ex");
        assert_eq!(refused(1.499), "ex");
        assert_eq!(field(1.0, 0.0, Arrangement::Mirrored).blocks.len(), 2);
        assert_eq!(Layout { ey: -1.2, ..REFERENCE }.blocks_overlap(), Some("ey"));
    }

    #[test]
    fn every_cell_of_a_repeated_field_sees_its_block_and_anchor_in_the_same_bits() {
        let (one, four) = (field(0.4, -0.7, Arrangement::default()), {
            field(0.4, -0.7, Arrangement::Repeated([2, 2]))
        });
        for place in [[0.1, 2.9], [1.7, 0.3], [2.999, 1.234]] {
            let [x, y] = one.seen_from_block(&one.blocks[0], place, [0, 0]);
            let ([..], at) = one.nearest_anchor(place, [0, 0]);
            for cell in [[0, 0], [1, 0], [0, 1], [1, 1]] {
                let seen = four.blocks.iter().map(|b| four.seen_from_block(b, place, cell));
                let near =
                    seen.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1]))).unwrap();
                assert_eq!(near.map(f64::to_bits), [x.to_bits(), y.to_bits()]);
                assert_eq!(four.nearest_anchor(place, cell).1, at);
            }
        }
        // From the right half of the last cell the nearest anchor is the first one again.
        assert_eq!(four.nearest_anchor([2.9, 0.1], [1, 0]).0, [0, 0]);
        assert_eq!(four.nearest_anchor([2.9, 2.9], [0, 0]).0, [1, 1]);
    }

    #[test]
    fn places_are_told_as_the_block_of_their_cell_has_them() {
        let close = |a: [f64; 2], b: [f64; 2]| assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12);
        let mirrored = field(0.5, 0.2, Arrangement::Mirrored);
        // 0.3 m beyond the block, seen from the line between the two, in each of the cells.
        close(mirrored.as_its_block([1.7, 1.5]), [0.2, 0.0]);
        close(mirrored.as_its_block([4.3, 1.5]), [0.2, 0.0]);
        close(mirrored.as_its_block([4.3, 4.4]), [0.2, 0.1]);
        // One block in nine cells: as far away as it is.
        let single = field(0.5, 0.2, Arrangement::Single(3));
        close(single.as_its_block([4.0, 8.9]), [2.5, -1.6]);
        close(field(0.5, 0.2, Arrangement::default()).as_its_block([2.9, 0.1]), [1.4, -1.4]);
    }
}
