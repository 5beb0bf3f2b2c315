//! The net's lattice: pairs of nodes joined by a double twist, and the single wires between rows.
//!
//! Row i, column j holds one pair. Its bottom node stands at
//! `origin + (opening (j + (i odd)/2), pitch i)`, with pitch = twist + projection; its top node one
//! twist length above (+y). From each top node two single wires run to the bottom nodes of row
//! i + 1 that stand half an opening to the left and to the right of it:
//!
//! ```text
//!    B(i+1)      B(i+1)        y, along the twists
//!        \        /            ^
//!   left  \      /  right      |
//!          T(i,j)              +--> x, across the twists
//!            |   double twist
//!          B(i,j)
//! ```
//!
//! The period is one opening in x and two pitches in y.

use crate::mesh::wire::NetGeometry;

/// Which of a pair's three bonds: its own twist, or one of the wires that leave its top node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Role {
    /// Bottom to top of the pair.
    Twist,
    /// Top node to the bottom node up and to the left (-x).
    Left,
    /// Top node to the bottom node up and to the right (+x).
    Right,
}

impl Role {
    /// The roles in the order in which a pair's bonds are numbered.
    pub(crate) const ALL: [Role; 3] = [Role::Twist, Role::Left, Role::Right];
}

/// Number of a bond, the same in every solver: three for each pair, whether they exist or not.
pub fn bond_number(pair: usize, role: Role) -> usize {
    3 * pair + role as usize
}

/// Pair and role of a bond's number.
pub fn bond_of(number: usize) -> (usize, Role) {
    (number / 3, Role::ALL[number % 3])
}

/// A regular net that fits its panel exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct Lattice {
    /// Pairs in a row.
    pub columns: usize,
    /// Rows of pairs; even where the net is periodic.
    pub rows: usize,
    /// Whether the net goes on beyond its edges (the anchored test) or ends there (the laboratory test).
    pub periodic: bool,
    /// Distance between twist axes after the stretch, m.
    pub opening: f64,
    /// Length of a double twist after the stretch, m.
    pub twist: f64,
    /// Projection of a single wire on y after the stretch, m.
    pub projection: f64,
    /// Position of the bottom node of row 0, column 0, measured from the panel's corner, m.
    pub origin: [f64; 2],
    /// Sides of the panel, m.
    pub size: [f64; 2],
    /// Factor by which the mesh was stretched in x and y to meet the panel's size exactly.
    pub stretch: [f64; 2],
}

impl Lattice {
    /// The net of the anchored test: a periodic cell of side `size`, of which the corner is the
    /// centre of an anchor plate. `phase` in [0, 1)^2 places the bottom node of row 0, column 0 at
    /// `phase` periods from that corner.
    pub fn periodic(net: &NetGeometry, size: f64, phase: [f64; 2]) -> Lattice {
        Lattice::cells(net, [size, size], [1, 1], phase)
    }

    /// The net of so many such cells in x and y, of these sides. Each cell is stretched to whole periods
    /// by itself, so that all are alike.
    pub(crate) fn cells(
        net: &NetGeometry,
        cell: [f64; 2],
        cells: [usize; 2],
        phase: [f64; 2],
    ) -> Lattice {
        let pitch = net.twist + net.projection;
        let columns = (cell[0] / net.opening).round().max(2.0);
        let periods = (cell[1] / (2.0 * pitch)).round().max(1.0);
        let stretch = [cell[0] / (columns * net.opening), cell[1] / (periods * 2.0 * pitch)];
        Lattice {
            columns: columns as usize * cells[0],
            rows: 2 * periods as usize * cells[1],
            periodic: true,
            opening: net.opening * stretch[0],
            twist: net.twist * stretch[1],
            projection: net.projection * stretch[1],
            origin: [phase[0] * net.opening * stretch[0], phase[1] * 2.0 * pitch * stretch[1]],
            size: [cell[0] * cells[0] as f64, cell[1] * cells[1] as f64],
            stretch,
        }
    }

    /// The net of the laboratory test: a panel of side `size` whose four edges run through nodes.
    pub fn panel(net: &NetGeometry, size: f64) -> Lattice {
        let pitch = net.twist + net.projection;
        // Odd rows reach half an opening further than even ones; the last row ends with its top node.
        let columns = (size / net.opening + 0.5).round().max(2.0);
        let rows = ((size - net.twist) / pitch + 1.0).round().max(2.0);
        let stretch =
            [size / ((columns - 0.5) * net.opening), size / ((rows - 1.0) * pitch + net.twist)];
        Lattice {
            columns: columns as usize,
            rows: rows as usize,
            periodic: false,
            opening: net.opening * stretch[0],
            twist: net.twist * stretch[1],
            projection: net.projection * stretch[1],
            origin: [0.0, 0.0],
            size: [size, size],
            stretch,
        }
    }

    /// Distance between rows, m.
    pub fn pitch(&self) -> f64 {
        self.twist + self.projection
    }

    /// Number of pairs; pair (row i, column j) has the number `i * columns + j`.
    pub fn pairs(&self) -> usize {
        self.columns * self.rows
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        2 * self.pairs()
    }

    /// Position of a pair's bottom node, measured from the panel's corner, m.
    pub fn bottom(&self, row: usize, column: usize) -> [f64; 2] {
        let shift = if row % 2 == 1 { 0.5 } else { 0.0 };
        [
            self.origin[0] + self.opening * (column as f64 + shift),
            self.origin[1] + self.pitch() * row as f64,
        ]
    }

    /// Position of a pair's top node, measured from the panel's corner, m.
    pub fn top(&self, row: usize, column: usize) -> [f64; 2] {
        let [x, y] = self.bottom(row, column);
        [x, y + self.twist]
    }

    /// Unloaded length of a double twist, m.
    pub fn twist_length(&self) -> f64 {
        self.twist
    }

    /// Unloaded length of a single wire, m.
    pub fn wire_length(&self) -> f64 {
        let half = self.opening / 2.0;
        (half * half + self.projection * self.projection).sqrt()
    }

    /// Row and column of the pair whose bottom node a single wire of (row, column) reaches, or
    /// nothing where the net ends.
    pub fn upper(&self, row: usize, column: usize, role: Role) -> Option<(usize, usize)> {
        // Odd rows stand half an opening to the right, so their left neighbour has the same number.
        let step = match (role, row % 2) {
            (Role::Left, 0) => -1,
            (Role::Right, 1) => 1,
            _ => 0,
        };
        let mut up = row + 1;
        let mut side = column as isize + step;
        let columns = self.columns as isize;
        if self.periodic {
            up %= self.rows;
            side = side.rem_euclid(columns);
        } else if up >= self.rows || side < 0 || side >= columns {
            return None;
        }
        Some((up, side as usize))
    }

    /// Whether this bond exists (it does not where a panel ends).
    pub(crate) fn has(&self, row: usize, column: usize, role: Role) -> bool {
        role == Role::Twist || self.upper(row, column, role).is_some()
    }

    /// Vector from the first to the second node of a bond in the unloaded net, m: bottom to top for
    /// a twist, top to the upper bottom node for a wire.
    pub fn rest(&self, role: Role) -> [f64; 2] {
        match role {
            Role::Twist => [0.0, self.twist],
            Role::Left => [-self.opening / 2.0, self.projection],
            Role::Right => [self.opening / 2.0, self.projection],
        }
    }

    /// Middle of a bond in the unloaded net, measured from the panel's corner, m.
    pub fn middle(&self, number: usize) -> [f64; 2] {
        let (pair, role) = bond_of(number);
        let (row, column) = (pair / self.columns, pair % self.columns);
        let start =
            if role == Role::Twist { self.bottom(row, column) } else { self.top(row, column) };
        let rest = self.rest(role);
        [start[0] + rest[0] / 2.0, start[1] + rest[1] / 2.0]
    }

    /// Number of bonds that exist.
    pub fn bonds(&self) -> usize {
        (0..self.rows)
            .flat_map(|i| (0..self.columns).map(move |j| (i, j)))
            .map(|(i, j)| Role::ALL.iter().filter(|&&r| self.has(i, j, r)).count())
            .sum()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The net of the reference mesh.
    pub(crate) const NET: NetGeometry = NetGeometry {
        opening: 0.08,
        twist: 0.04,
        projection: 0.04,
        diameter: 0.0027,
        node_mass: 0.0039,
        node_radius: 0.0108,
    };

    #[test]
    fn the_two_published_nets_have_the_published_numbers() {
        let lab = Lattice::panel(&NET, 3.0);
        assert_eq!((lab.columns, lab.rows, lab.nodes(), lab.bonds()), (38, 38, 2888, 4219));
        assert!(lab.stretch.iter().all(|s| (s - 1.0).abs() < 1e-12), "{:?}", lab.stretch);
        let cell = Lattice::periodic(&NET, 3.04, [0.25, 0.125]);
        assert_eq!((cell.columns, cell.rows, cell.nodes(), cell.bonds()), (38, 38, 2888, 4332));
        assert!(cell.stretch.iter().all(|s| (s - 1.0).abs() < 1e-12), "{:?}", cell.stretch);
        assert!((cell.origin[0] - 0.02).abs() < 1e-12 && (cell.origin[1] - 0.02).abs() < 1e-12);
    }

    #[test]
    fn every_wire_reaches_the_node_its_rest_vector_points_to() {
        for lattice in [Lattice::panel(&NET, 2.3), Lattice::periodic(&NET, 2.3, [0.7, 0.3])] {
            for i in 0..lattice.rows {
                for j in 0..lattice.columns {
                    for role in [Role::Left, Role::Right] {
                        let Some((up, side)) = lattice.upper(i, j, role) else { continue };
                        let (from, to) = (lattice.top(i, j), lattice.bottom(up, side));
                        for axis in 0..2 {
                            let mut gap = to[axis] - from[axis] - lattice.rest(role)[axis];
                            if lattice.periodic {
                                gap -= lattice.size[axis] * (gap / lattice.size[axis]).round();
                            }
                            assert!(gap.abs() < 1e-12, "{i} {j} {role:?} {gap}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_panel_ends_in_nodes_on_all_four_edges() {
        for size in [2.0, 2.25, 3.0, 4.5] {
            let p = Lattice::panel(&NET, size);
            let top = p.top(p.rows - 1, 0)[1];
            let right = (0..p.rows).map(|i| p.bottom(i, p.columns - 1)[0]).fold(0.0, f64::max);
            assert!((top - size).abs() < 1e-12 && (right - size).abs() < 1e-12);
            // Half an opening in 2 m, half a pitch in 2 m: the largest stretch of these panels.
            assert!(p.stretch.iter().all(|s| (s - 1.0).abs() < 0.021), "{:?}", p.stretch);
        }
    }

    #[test]
    fn stretch_stays_within_the_stated_bounds_near_1_3_m() {
        for k in 0..60 {
            let size = 1.25 + 0.005 * f64::from(k);
            let p = Lattice::periodic(&NET, size, [0.0, 0.0]);
            assert!((p.stretch[0] - 1.0).abs() < 0.033 && (p.stretch[1] - 1.0).abs() < 0.064);
        }
    }
}
