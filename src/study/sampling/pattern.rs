//! Which nodes the plates catch, over all alignments of the net: the patterns and their exact areas.
//!
//! A node comes under a plate where one of the plate's edges passes over a column or a row of nodes. So
//! these edges, drawn in the square of alignments (each part of a period from 0 to 1), cut it into
//! rectangles, and in each of them the plates catch the same nodes. Rectangles whose nodes differ by a
//! translation of the net only are one pattern; where the scene is its own mirror image, those that differ
//! by the reflection are one too.

use crate::dem::{Arrangement, Scene};
use std::collections::BTreeMap;

/// Alignments, as parts of the net's period, that lie between two cuts in each direction; the upper end
/// may be beyond 1 and then is that of the next period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rectangle {
    x: [f64; 2],
    y: [f64; 2],
}

impl Rectangle {
    #[cfg(test)]
    pub(super) fn new(x: [f64; 2], y: [f64; 2]) -> Rectangle {
        Rectangle { x, y }
    }

    /// Its part of all alignments.
    pub(crate) fn area(&self) -> f64 {
        (self.x[1] - self.x[0]) * (self.y[1] - self.y[0])
    }

    /// The alignment at these parts of its sides, each in [0, 1).
    pub(crate) fn at(&self, parts: [f64; 2]) -> [f64; 2] {
        let [x, y] = parts;
        [self.x[0] + (self.x[1] - self.x[0]) * x, self.y[0] + (self.y[1] - self.y[0]) * y]
            .map(within_period)
    }
}

/// A pattern of caught nodes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pattern {
    /// Nodes that a plate catches; the mean of the plates where they catch different ones.
    pub(crate) nodes: f64,
    /// Part of all alignments that it takes up.
    pub(crate) area: f64,
    /// These alignments.
    pub(crate) rectangles: Vec<Rectangle>,
}

/// A node of the net by numbers: half openings to the right, rows up, and whether it is a pair's top.
type Node = (i64, i64, bool);

/// The net and the plates, as far as they decide which nodes are caught.
struct Net {
    /// Period of the net in x and y, m.
    period: [f64; 2],
    /// Bottom and top node of an even and of an odd row, from the net's origin, m.
    nodes: [[[f64; 2]; 2]; 2],
    /// Centres of the plates that catch nodes of their own, in periods from 0 to 1; the others are a whole
    /// number of periods away from one of these.
    plates: Vec<[f64; 2]>,
    /// Half of a plate's side, m.
    half: f64,
}

impl Net {
    fn of(scene: &Scene) -> Net {
        let lattice = &scene.lattice;
        let from_origin = |[x, y]: [f64; 2]| [x - lattice.origin[0], y - lattice.origin[1]];
        let row = |i| [lattice.bottom(i, 0), lattice.top(i, 0)].map(from_origin);
        let period = [lattice.opening, 2.0 * lattice.pitch()];
        Net {
            period,
            nodes: [row(0), row(1)],
            plates: plates(scene, period),
            half: scene.spec.layout.plate / 2.0,
        }
    }

    /// The alignments at which an edge of a plate passes over nodes, rising, in one direction.
    fn cuts(&self, axis: usize) -> Vec<f64> {
        let mut cuts = Vec::new();
        for plate in &self.plates {
            for node in self.nodes.iter().flatten() {
                for side in [-self.half, self.half] {
                    let at = plate[axis] + (side - node[axis]) / self.period[axis];
                    cuts.push(within_period(at));
                }
            }
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|b, a| *b - *a < SAME);
        // The last and the first may be one across the period's end.
        if cuts.len() > 1 && cuts[0] + 1.0 - cuts[cuts.len() - 1] < SAME {
            cuts.pop();
        }
        cuts
    }

    /// The nodes that each plate catches at an alignment.
    fn caught(&self, phase: [f64; 2]) -> Vec<Vec<Node>> {
        self.plates.iter().map(|plate| self.caught_by(*plate, phase)).collect()
    }

    fn caught_by(&self, plate: [f64; 2], phase: [f64; 2]) -> Vec<Node> {
        let mut list = Vec::new();
        for (odd, row) in self.nodes.iter().enumerate() {
            for (top, node) in row.iter().enumerate() {
                // Whole periods by which the node may be moved and still lie on the plate.
                let [columns, rows] = [0, 1].map(|axis| {
                    let from_edge = |edge: f64| {
                        plate[axis] + (edge - node[axis]) / self.period[axis] - phase[axis]
                    };
                    from_edge(-self.half).ceil() as i64..=from_edge(self.half).floor() as i64
                });
                let odd = odd as i64;
                list.extend(rows.flat_map(|i| {
                    columns.clone().map(move |j| (2 * j + odd, 2 * i + odd, top == 1))
                }));
            }
        }
        list
    }
}

/// Centres of the plates that catch nodes of their own, in periods. Each cell is a whole number of them, so
/// on a square grid one plate tells what all catch, on a staggered one two.
fn plates(scene: &Scene, period: [f64; 2]) -> Vec<[f64; 2]> {
    let field = &scene.field;
    let mut found: Vec<[f64; 2]> = Vec::new();
    for number in 0..field.anchors() {
        let place = field.turned(field.anchor(number));
        // A little is added, so that whole periods are not taken for nearly one.
        let at = [0, 1].map(|k| (within_period(place[k] / period[k] + NEAR) - NEAR).max(0.0));
        let same = |p: &[f64; 2]| (0..2).all(|k| (p[k] - at[k]).abs() < NEAR);
        if !found.iter().any(same) {
            found.push(at);
        }
    }
    found
}

/// Plates nearer than this to a whole number of periods are there, in periods.
const NEAR: f64 = 1.0e-6;

/// Two alignments nearer than this are one, as parts of a period.
const SAME: f64 = 1.0e-12;

fn within_period(at: f64) -> f64 {
    let part = at - at.floor();
    // What rounds up to a whole period is the next one's beginning.
    if part >= 1.0 { 0.0 } else { part }
}

/// In which of the net's directions a scene is its own mirror image but for the net: where the block is
/// centred, and where blocks face each other across the anchor lines.
fn mirrors(scene: &Scene) -> [bool; 2] {
    let layout = &scene.spec.layout;
    let (ex, ey) = layout.folded();
    match scene.spec.arrangement {
        Arrangement::Mirrored => [true; 2],
        // The zero of a staggered grid is not halfway between its rows.
        Arrangement::Repeated(_) | Arrangement::Single(_) => {
            scene.field.turned([ex == 0.0, ey == 0.0 && !layout.grid.stagger])
        }
    }
}

/// What the plates catch, the same for all alignments that differ by a translation of the net.
type Key = Vec<Vec<Node>>;

/// The key of some nodes: the net is its own image under two rows up, two half openings to the right, and
/// one of each.
fn key(caught: &[Vec<Node>]) -> Key {
    let all = || caught.iter().flatten();
    let row = all().map(|n| n.1).min().unwrap_or(0);
    let column = all().map(|n| n.0 - row).min().unwrap_or(0);
    let aside = row + column - column.rem_euclid(2);
    let moved = |plate: &Vec<Node>| {
        let mut moved: Vec<Node> = plate.iter().map(|n| (n.0 - aside, n.1 - row, n.2)).collect();
        moved.sort_unstable();
        moved
    };
    caught.iter().map(moved).collect()
}

impl Net {
    /// The nodes seen in a mirror: left for right, or up for down, where bottom and top change places. A
    /// plate half a period off is brought back to where it was by a whole one.
    fn reflected(&self, caught: &[Vec<Node>], axis: usize) -> Vec<Vec<Node>> {
        let image = |(nodes, plate): (&Vec<Node>, &[f64; 2])| {
            let back = 2 * (2.0 * plate[axis]).round() as i64;
            let turn = |n: &Node| match axis {
                0 => (back - n.0, n.1, n.2),
                _ => (n.0, back - n.1, !n.2),
            };
            nodes.iter().map(turn).collect()
        };
        caught.iter().zip(&self.plates).map(image).collect()
    }

    /// The key of all mirror images together.
    fn joined_key(&self, caught: &[Vec<Node>], mirrors: [bool; 2]) -> Key {
        let mut images = vec![caught.to_vec()];
        for axis in (0..2).filter(|axis| mirrors[*axis]) {
            // Plates that are not their own images tell nothing of each other.
            let halves = |p: &[f64; 2]| 2.0 * p[axis];
            if self.plates.iter().map(halves).any(|h| (h - h.round()).abs() > NEAR) {
                continue;
            }
            let more: Vec<_> = images.iter().map(|image| self.reflected(image, axis)).collect();
            images.extend(more);
        }
        images.iter().map(|image| key(image)).min().unwrap_or_default()
    }
}

/// The patterns of an anchored scene, whose own alignment does not count: fewest nodes first. Their areas
/// are 1 together.
pub(crate) fn patterns(scene: &Scene) -> Vec<Pattern> {
    let net = Net::of(scene);
    let mirrors = mirrors(scene);
    let spans = [0, 1].map(|axis| spans(&net.cuts(axis)));
    let mut found: BTreeMap<(usize, Key), Vec<Rectangle>> = BTreeMap::new();
    for x in &spans[0] {
        for y in &spans[1] {
            let rectangle = Rectangle { x: *x, y: *y };
            let caught = net.caught(rectangle.at([0.5, 0.5]));
            let nodes = caught.iter().map(Vec::len).sum();
            found.entry((nodes, net.joined_key(&caught, mirrors))).or_default().push(rectangle);
        }
    }
    let plates = net.plates.len() as f64;
    let pattern = |((nodes, _), rectangles): ((usize, Key), Vec<Rectangle>)| Pattern {
        nodes: nodes as f64 / plates,
        area: rectangles.iter().map(Rectangle::area).sum(),
        rectangles,
    };
    found.into_iter().map(pattern).collect()
}

/// From each cut to the next, round to the first one again.
fn spans(cuts: &[f64]) -> Vec<[f64; 2]> {
    let next = cuts.iter().skip(1).copied().chain(cuts.first().map(|first| first + 1.0));
    cuts.iter().copied().zip(next).map(|(from, to)| [from, to]).collect()
}

/// What the plates catch at an alignment, the same for all that differ by a symmetry of the scene.
#[cfg(test)]
pub(super) fn caught_nodes(scene: &Scene, phase: [f64; 2]) -> Vec<Vec<(i64, i64, bool)>> {
    let net = Net::of(scene);
    net.joined_key(&net.caught(phase), mirrors(scene))
}
