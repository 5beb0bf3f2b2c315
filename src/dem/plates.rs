//! Which nodes the anchor plates hold, as it depends on the alignment of the net.

use super::field::Field;
use super::lattice::Lattice;
use crate::layout::Layout;
use crate::mesh::wire::NetGeometry;

/// Where the plates of an anchored test stand against its net, whatever the alignment: nodes at most half
/// a side from a centre in x and y are held. Here x runs across the twists, y along them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlateGrid {
    /// Centres, from the corner from which the alignment is counted ([`super::SceneSpec::phase`]), m. One, or two in
    /// a staggered grid: all others are whole periods of the net away from these, images included, so that
    /// what these catch is all that is caught.
    pub(crate) centres: Vec<[f64; 2]>,
    /// Side of a plate, m.
    pub(crate) side: f64,
    /// The net's periods after the stretch, across and along the twists, m.
    pub(crate) period: [f64; 2],
    /// A node's place in a period is (alignment x period) plus one of these, m: bottom and top node of an
    /// even row and of an odd one.
    pub(crate) nodes: [[f64; 2]; 4],
}

#[cfg_attr(not(test), expect(dead_code, reason = "for strata of alignments, which follow"))]
impl PlateGrid {
    /// Of the anchored test of this layout and net.
    pub(crate) fn new(layout: &Layout, net: &NetGeometry) -> PlateGrid {
        let cell = Field::one(layout).cell;
        let lattice = Lattice::cells(net, cell, [1, 1], [0.0, 0.0]);
        let mut centres = vec![[0.0, 0.0]];
        if layout.grid.stagger {
            let [x, y] = layout.sides();
            centres.push(layout.turned([x / 2.0, y]));
        }
        PlateGrid {
            centres,
            side: layout.plate,
            period: [lattice.opening, 2.0 * lattice.pitch()],
            nodes: [
                lattice.bottom(0, 0),
                lattice.top(0, 0),
                lattice.bottom(1, 0),
                lattice.top(1, 0),
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::{Arrangement, Scene, SceneSpec, Test};
    use crate::layout::{Grid, REFERENCE, Twists};
    use crate::mesh::laws;

    /// Nodes held by a scene's plates in one period of its anchors, and those that the grid of plates says.
    fn held(layout: Layout, phase: [f64; 2]) -> (usize, usize) {
        let spec = SceneSpec {
            layout,
            test: Test::Anchored,
            wire: laws::reference(),
            phase,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        let scene = Scene::new(&spec).unwrap();
        let in_scene = scene.fixed.iter().flatten().filter(|held| **held).count();
        let grid = PlateGrid::new(&layout, &spec.wire.net);
        let mut in_grid = 0;
        for centre in &grid.centres {
            for node in &grid.nodes {
                // How many whole periods bring the node within half a side along each axis.
                let ways = [0, 1].map(|k| {
                    let from = node[k] + phase[k] * grid.period[k] - centre[k];
                    (-100..100)
                        .filter(|n| {
                            let off: f64 = from + f64::from(*n) * grid.period[k];
                            off.abs() <= grid.side / 2.0 + 1e-9
                        })
                        .count()
                });
                in_grid += ways[0] * ways[1];
            }
        }
        (in_scene, in_grid)
    }

    #[test]
    fn the_nodes_that_a_scene_holds_are_those_near_the_centres() {
        let mut seen = std::collections::BTreeSet::new();
        for up in [None, Some(2.4)] {
            for stagger in [false, true] {
                for twists in [Twists::Down, Twists::Across] {
                    for phase in [[0.25, 0.125], [0.6, 0.9], [0.05, 0.5]] {
                        let grid = Grid { up, stagger, twists };
                        let (scene, grid) = held(Layout { grid, ..REFERENCE }, phase);
                        assert_eq!(scene, grid, "{up:?} {stagger} {twists:?} {phase:?}");
                        seen.insert(scene);
                    }
                }
            }
        }
        assert!(seen.len() >= 4, "{seen:?}");
    }
}
