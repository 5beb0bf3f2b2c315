//! Where the pairs of a net stand in a plane.
//!
//! Even rows come first, one behind the other, and then odd rows, so that the bonds of all even rows reach
//! their other ends at the same distances in the plane, as do those of all odd rows: vectors need not end
//! where a row does. Each row has one place more than columns, a *ghost*, which in a periodic net repeats the
//! other end of a row: behind an even row its own first column, behind an odd row the last column of the next
//! odd row, which is to the left of that row. So the place before the first odd row is a ghost too. One ghost
//! row behind the last even row repeats the first one's bottoms. What is no pair is fixed and its bonds are
//! missing, so that it adds nothing; of a ghost the one wire that leads into the net is there, and its force
//! is that of the wire that it repeats.

/// Pairs are dealt with in blocks of this many: the widest vector.
pub(super) const BLOCK: usize = 16;

/// Blocks whose forces are buffered at once, at least: their 18 buffers have room in 32 kB.
const PANEL: usize = 16;

/// Rows of buffered forces, at least, so that little is carried from panel to panel.
const ROWS: usize = 3;

/// The places of a net's pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Places {
    /// Columns of pairs.
    pub(super) columns: usize,
    /// Rows of pairs.
    pub(super) rows: usize,
    /// Distance from a row to the next of its kind.
    pub(super) stride: usize,
    /// Blocks of even rows; of odd ones as many.
    pub(super) blocks: usize,
    /// Where even and odd rows begin: at a block.
    pub(super) first: [usize; 2],
    /// Places in all.
    pub(super) len: usize,
    /// Blocks whose forces are buffered at once.
    pub(super) panel: usize,
    /// Places of buffered forces before those: a block and before it a row and a ghost.
    pub(super) carried: usize,
}

impl Places {
    /// Those of a net of so many columns and rows.
    pub(super) fn new(columns: usize, rows: usize) -> Places {
        let stride = columns + 1;
        let blocks = (rows.div_ceil(2) * stride).div_ceil(BLOCK);
        // The last block of odd rows looks a row and a place ahead into the even ones; a block before each
        // kind of rows holds what stands before it.
        let even = (blocks * BLOCK + stride + 1).next_multiple_of(BLOCK) + BLOCK;
        let first = [BLOCK, BLOCK + even];
        let carried = (stride + 1).next_multiple_of(BLOCK) + BLOCK;
        let panel = PANEL.max(ROWS * carried / BLOCK);
        Places {
            columns,
            rows,
            stride,
            blocks,
            first,
            len: first[1] + (blocks + 1) * BLOCK,
            panel,
            carried,
        }
    }

    /// Places of buffered forces: a block behind the panel looks ahead.
    pub(super) fn buffered(&self) -> usize {
        self.carried + (self.panel + 1) * BLOCK
    }

    /// Place of a pair.
    pub(super) fn at(&self, row: usize, column: usize) -> usize {
        self.first[row % 2] + row / 2 * self.stride + column
    }

    /// Places in a row of sums by column: a block more than columns, as a block may begin at the last one.
    pub(super) fn sums(&self) -> usize {
        (self.columns + BLOCK).next_multiple_of(BLOCK)
    }

    /// Ghosts that repeat another pair, with it; in a periodic net, of an even number of rows.
    pub(super) fn ghosts(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let places = *self;
        (0..places.rows / 2).flat_map(move |half| {
            let [even, odd] = places.first.map(|first| first + half * places.stride);
            [(even + places.columns, even), (odd - 1, odd + places.columns - 1)]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pair_has_a_place_and_its_wires_reach_the_right_ones() {
        for (columns, rows) in [(2, 2), (15, 4), (16, 6), (38, 38), (31, 7)] {
            let places = Places::new(columns, rows);
            let mut taken = vec![false; places.len];
            for row in 0..rows {
                for column in 0..columns {
                    let at = places.at(row, column);
                    assert!(!std::mem::replace(&mut taken[at], true));
                    assert!(at - places.first[row % 2] < places.blocks * BLOCK);
                }
            }
            let ghosts: Vec<_> = if rows % 2 == 0 { places.ghosts().collect() } else { Vec::new() };
            for (ghost, pair) in &ghosts {
                assert!(!taken[*ghost] && taken[*pair]);
            }
            // By hand: from an even row the left wire leads half an opening to the left.
            let left_of = |at: usize| {
                let found = ghosts.iter().find(|(ghost, _)| *ghost == at);
                found.map_or(at, |(_, pair)| *pair)
            };
            if rows % 2 == 0 {
                let up = places.first[1] + places.at(0, 0) - places.first[0];
                assert_eq!(left_of(up - 1), places.at(1, columns - 1));
                assert_eq!(up, places.at(1, 0));
            }
        }
    }
}
