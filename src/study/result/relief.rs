//! The shape of the deformed net on a grid of cells, for contours.

use crate::dem::outcome::Net;
use crate::layout::Layout;

/// Cells along each side of the grid.
pub const CELLS: usize = 48;

/// How far the net is pushed out, over the panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Relief {
    /// Sides of the panel in x and y, m.
    pub sides: [f64; 2],
    /// Heights, m, row by row from the bottom left corner, [`CELLS`] in a row.
    pub heights: Vec<f64>,
    /// Largest height, m.
    pub highest: f64,
    /// Punch displacement at which the net was taken, m.
    pub deflection: f64,
}

impl Relief {
    /// The shape of `net` on the first cell of a layout's field: each cell of the grid takes the mean height
    /// of the nodes in it; where there are none, of the cells around that have some.
    pub(crate) fn from_net(net: &Net, layout: &Layout) -> Relief {
        let sides = layout.sides();
        let mut sum = vec![0.0; CELLS * CELLS];
        let mut count = vec![0.0; CELLS * CELLS];
        let cell = |v: f64, side: f64| {
            // Nodes of a periodic net may stand a little outside; out of range is clamped.
            ((v / side * CELLS as f64).floor().max(0.0) as usize).min(CELLS - 1)
        };
        // Of a field of several cells the first one, whose block stands where the layout's does.
        let in_cell = |v: f64, side: f64| v <= side * (1.0 + 0.5 / CELLS as f64);
        // The net's axes may be the other way round.
        let nodes = net.nodes.iter().map(|[x, y, z]| (layout.turned([*x, *y]), *z));
        for ([x, y], z) in
            nodes.filter(|([x, y], _)| in_cell(*x, sides[0]) && in_cell(*y, sides[1]))
        {
            let k = cell(y, sides[1]) * CELLS + cell(x, sides[0]);
            sum[k] += z;
            count[k] += 1.0;
        }
        // Coarse nets leave cells empty: they are filled from their neighbours, ring by ring.
        for _ in 0..CELLS {
            if count.iter().all(|n| *n > 0.0) {
                break;
            }
            let (old_sum, old_count) = (sum.clone(), count.clone());
            for row in 0..CELLS {
                for column in 0..CELLS {
                    let k = row * CELLS + column;
                    if old_count[k] > 0.0 {
                        continue;
                    }
                    for (r, c) in around(row, column) {
                        let other = r * CELLS + c;
                        if old_count[other] > 0.0 {
                            sum[k] += old_sum[other] / old_count[other];
                            count[k] += 1.0;
                        }
                    }
                }
            }
        }
        let heights: Vec<f64> =
            sum.iter().zip(&count).map(|(s, n)| if *n > 0.0 { s / n } else { 0.0 }).collect();
        let highest = heights.iter().copied().fold(0.0, f64::max);
        Relief { sides, heights, highest, deflection: net.deflection }
    }

    /// Height at a place from the panel's centre, m, linear between the cells' middles.
    pub(crate) fn at(&self, x: f64, y: f64) -> f64 {
        let place = |v: f64, side: f64| {
            ((v / side + 0.5) * CELLS as f64 - 0.5).clamp(0.0, (CELLS - 1) as f64)
        };
        let (px, py) = (place(x, self.sides[0]), place(y, self.sides[1]));
        let (c, r) = ((px as usize).min(CELLS - 2), (py as usize).min(CELLS - 2));
        let (fx, fy) = (px - c as f64, py - r as f64);
        let h = |r: usize, c: usize| self.heights[r * CELLS + c];
        let low = h(r, c) + (h(r, c + 1) - h(r, c)) * fx;
        let high = h(r + 1, c) + (h(r + 1, c + 1) - h(r + 1, c)) * fx;
        low + (high - low) * fy
    }
}

/// The cells around one, inside the grid.
fn around(row: usize, column: usize) -> impl Iterator<Item = (usize, usize)> {
    let near = |v: usize| v.saturating_sub(1)..=(v + 1).min(CELLS - 1);
    near(row).flat_map(move |r| near(column).map(move |c| (r, c)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    #[test]
    fn a_tilted_plane_is_found_again_between_sparse_nodes() {
        // Nodes 0.1 m apart on a 3 m panel: fewer than there are cells of 0.0625 m.
        let mut nodes = Vec::new();
        for i in 0..30 {
            for j in 0..30 {
                let (x, y) = (0.05 + 0.1 * f64::from(i), 0.05 + 0.1 * f64::from(j));
                nodes.push([x, y, 0.1 * x + 0.02 * y]);
            }
        }
        let relief =
            Relief::from_net(&Net { nodes, bonds: Vec::new(), deflection: 0.3 }, &REFERENCE);
        for (x, y) in [(0.0, 0.0), (-1.0, 0.7), (1.2, -1.2)] {
            let plane = 0.1 * (x + 1.5) + 0.02 * (y + 1.5);
            // A node is up to a cell (0.0625 m) from where its height is taken to be.
            assert!((relief.at(x, y) - plane).abs() < 0.1 * 0.0625 + 0.02 * 0.0625, "{x} {y}");
        }
        assert_eq!(relief.deflection, 0.3);
    }
}
