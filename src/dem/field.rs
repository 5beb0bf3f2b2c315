//! The field: how many cells of the anchored test are simulated together, and where a block stands in
//! each of them.
//!
//! x runs across the twists, y along them. Each cell has an anchor at its corner (half a cell to the left
//! of and below its centre), and is a whole number of the net's periods, so that all plates catch the same
//! pattern of nodes. The field goes on beyond its edges.

use crate::layout::Layout;
use crate::problem::Problem;
use crate::units::shortest;

/// How the blocks stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// The same block at the same place in every cell; so many cells in x and y are simulated. One cell
    /// tells all where the wires are alike; more are there to be compared with as many mirrored ones.
    Repeated([usize; 2]),
    /// The block of cell (i, j) stands at ((-1)^i ex, (-1)^j ey) from its centre: blocks of neighbours face
    /// each other across the line of anchors between them. Two cells in each direction in which the block
    /// has an offset. The net is not mirrored.
    Mirrored,
    /// One block in a field of n x n cells.
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
    /// Its axis, from that cell's corner, m.
    pub axis: [f64; 2],
}

/// The cells of a field and its blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Sides of a cell, m.
    pub cell: [f64; 2],
    /// Cells in x and y.
    pub cells: [usize; 2],
    /// Whether neighbours in x and y are mirror images.
    pub mirrored: [bool; 2],
    /// Its blocks; never none.
    pub blocks: Vec<Block>,
}

impl Field {
    /// One cell with one block, which is also the panel of the laboratory test.
    pub(super) fn one(layout: &Layout) -> Field {
        let side = layout.spacing;
        let axis = [side / 2.0 + layout.ex, side / 2.0 + layout.ey];
        let blocks = vec![Block { cell: [0, 0], axis }];
        Field { cell: [side, side], cells: [1, 1], mirrored: [false; 2], blocks }
    }

    /// The field of an anchored test.
    ///
    /// # Errors
    /// Cells that are too many or too few; mirrored blocks that would overlap.
    pub(super) fn anchored(
        layout: &Layout,
        arrangement: Arrangement,
    ) -> Result<Field, Vec<Problem>> {
        let mut field = Field::one(layout);
        match arrangement {
            Arrangement::Repeated(cells) => {
                allow(cells)?;
                field.cells = cells;
                field.fill(layout);
                if field.blocks.len() > MOST_BLOCKS {
                    return Err(vec![
                        Problem::new("blocks", "too many cells with a block each")
                            .allowed(format!("up to {MOST_BLOCKS}")),
                    ]);
                }
            }
            Arrangement::Mirrored => {
                let (ex, ey) = layout.folded();
                field.mirrored = [ex != 0.0, ey != 0.0];
                field.cells = field.mirrored.map(|doubled| if doubled { 2 } else { 1 });
                overlap(layout)?;
                field.fill(layout);
            }
            Arrangement::Single(n) => {
                allow([n, n])?;
                field.cells = [n, n];
            }
        }
        Ok(field)
    }

    /// Puts the blocks into the cells; those of two cells at one place are one block.
    fn fill(&mut self, layout: &Layout) {
        let offset = [layout.ex, layout.ey];
        let side = self.cell;
        let shared = [0, 1].map(|k| self.mirrored[k] && layout.on_line(offset[k]));
        self.blocks.clear();
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let cell = [i, j];
                if (0..2).any(|k| shared[k] && cell[k] > 0) {
                    continue;
                }
                let axis = [0, 1].map(|k| {
                    let turned = self.mirrored[k] && cell[k] % 2 == 1;
                    side[k] / 2.0 + if turned { -offset[k] } else { offset[k] }
                });
                self.blocks.push(Block { cell, axis });
            }
        }
    }

    /// Sides of the whole field, m.
    pub fn size(&self) -> [f64; 2] {
        [0, 1].map(|k| self.cell[k] * self.cells[k] as f64)
    }

    /// Number of anchors, one for each cell.
    pub fn anchors(&self) -> usize {
        self.cells[0] * self.cells[1]
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

    /// The anchor nearest to a place, given from its cell's corner, by its column and row; and the place
    /// seen from it, m.
    pub(super) fn nearest_anchor(
        &self,
        place: [f64; 2],
        cell: [usize; 2],
    ) -> ([usize; 2], [f64; 2]) {
        let further = [0, 1].map(|k| (place[k] / self.cell[k]).round());
        let anchor = [0, 1].map(|k| {
            let cells = self.cells[k] as i64;
            (cell[k] as i64 + further[k] as i64).rem_euclid(cells) as usize
        });
        (anchor, [0, 1].map(|k| place[k] - self.cell[k] * further[k]))
    }

    /// A place, given from the field's corner, as the block of its cell has it: from that cell's centre, m,
    /// and turned round where its cell is a mirror image. Of a field with one block, from the centre of the
    /// block's cell.
    pub(super) fn as_its_block(&self, place: [f64; 2]) -> [f64; 2] {
        let alone = self.blocks.len() == 1;
        [0, 1].map(|k| {
            let side = self.cell[k];
            let cells = self.cells[k] as f64;
            let from_centre = place[k] - side / 2.0;
            if self.cells[k] == 1 {
                return from_centre;
            }
            if alone && !self.mirrored[k] {
                let size = side * cells;
                return from_centre - size * (from_centre / size).round();
            }
            let cell = (place[k] / side).floor().clamp(0.0, cells - 1.0);
            let within = from_centre - side * cell;
            if self.mirrored[k] && cell % 2.0 == 1.0 { -within } else { within }
        })
    }
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

fn overlap(layout: &Layout) -> Result<(), Vec<Problem>> {
    let Some(field) = layout.blocks_overlap() else { return Ok(()) };
    let value = if field == "ex" { layout.ex } else { layout.ey };
    Err(vec![Problem::new(field, OVERLAP).value(format!("{} m", shortest(value))).allowed(
        format!(
            "within (L - D)/2 = {} m, or half the spacing exactly: one block on the line",
            shortest((layout.spacing - layout.punch) / 2.0)
        ),
    )])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    fn field(ex: f64, ey: f64, arrangement: Arrangement) -> Field {
        Field::anchored(&Layout { ex, ey, ..REFERENCE }, arrangement).unwrap()
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
            Field::anchored(&layout, Arrangement::Mirrored).unwrap_err()[0].field.clone()
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
