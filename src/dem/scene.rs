//! The scene: what the solvers run, made from a layout, a test, a wire law, an alignment and a seed.

use super::dome::Dome;
use super::field::{Arrangement, Block, BlockField};
use super::hash;
use super::lattice::{Lattice, Role, bond_number, bond_of};
use super::law::Law;
use super::limits;
use crate::layout::Layout;
use crate::mesh::wire::{Slack, WireData};
use crate::problem::Problem;
use crate::units::shortest;
use crate::words::Choice;

/// Which punch test is simulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Test {
    /// Panel held along its four edges (ISO 17745, ISO 17746, UNI 11437).
    Laboratory,
    /// Periodic cell held by anchor plates at its corners.
    Anchored,
}

impl Choice for Test {
    const ALL: &'static [Test] = &[Test::Anchored, Test::Laboratory];

    fn word(self) -> &'static str {
        match self {
            Test::Anchored => "anchored",
            Test::Laboratory => "laboratory",
        }
    }
}

/// Alignment at which the standard laboratory panel has the punch at its centre, and the anchored
/// cell of the published curves its corner in the middle of a single wire.
pub const PLAIN_PHASE: [f64; 2] = [0.25, 0.125];

/// Largest panel that is simulated, m.
pub(crate) const LARGEST_PANEL: f64 = 30.0;

/// All that says what a scene is.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSpec {
    /// Panel, plates and punch; the plates are not there in the laboratory test.
    pub layout: Layout,
    /// Which test.
    pub test: Test,
    /// Net and wires.
    pub wire: WireData,
    /// Alignment of the net, each in [0, 1). Anchored: place of the bottom node of an even row from a
    /// plate's centre, in periods of the net. Laboratory: the panel's edges run through nodes, so the
    /// alignment moves the punch instead, by (phase - [`PLAIN_PHASE`]) periods, taken within half a
    /// period, from the panel's centre.
    pub phase: [f64; 2],
    /// Seed of the random slack.
    pub seed: u64,
    /// How the blocks stand in the cells; nothing to the laboratory test.
    pub arrangement: Arrangement,
}

impl SceneSpec {
    /// A scene at the plain alignment, seed 0, with a block in every cell.
    pub(crate) fn plain(layout: Layout, test: Test, wire: WireData) -> SceneSpec {
        let arrangement = Arrangement::default();
        SceneSpec { layout, test, wire, phase: PLAIN_PHASE, seed: 0, arrangement }
    }
}

/// A scene ready to run.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What it was made from.
    pub spec: SceneSpec,
    /// The net.
    pub lattice: Lattice,
    /// The law of its bonds.
    pub law: Law,
    /// The punch, which is every block's shape.
    pub dome: Dome,
    /// The cells and where the blocks stand.
    pub field: BlockField,
    /// Whether the bottom and the top node of each pair are fixed.
    pub fixed: Vec<[bool; 2]>,
}

impl Scene {
    /// Builds the scene.
    ///
    /// # Errors
    /// Every field that is wrong: sizes that make no sense, a plate that catches no node, a punch on
    /// a plate, wire data outside their ranges.
    pub fn new(spec: &SceneSpec) -> Result<Scene, Vec<Problem>> {
        check(spec)?;
        let (layout, net) = (&spec.layout, &spec.wire.net);
        let mut field = match spec.test {
            Test::Anchored => BlockField::anchored(layout, spec.arrangement)?,
            Test::Laboratory => BlockField::one(layout),
        };
        let lattice = match spec.test {
            Test::Anchored => Lattice::cells(net, field.cell, field.cells, spec.phase),
            Test::Laboratory => Lattice::panel(net, layout.spacing),
        };
        if let Some(problem) = limits::of_net(&lattice, layout.least()) {
            return Err(vec![problem]);
        }
        if lattice.columns < 4 * field.cells[0] || lattice.rows < 4 * field.cells[1] {
            return Err(vec![
                Problem::new(layout.words()[0], "the panel is too small for a net of this mesh")
                    .value(format!("{} m", shortest(layout.least())))
                    .allowed("at least four openings and two periods along the twists"),
            ]);
        }
        if spec.test == Test::Laboratory {
            let period = [lattice.opening, 2.0 * lattice.pitch()];
            for k in 0..2 {
                let shift = spec.phase[k] - PLAIN_PHASE[k];
                field.blocks[0].axis[k] += (shift - shift.round()) * period[k];
            }
        }
        let fixed = match spec.test {
            Test::Anchored => plates(&lattice, &field, layout.plate),
            Test::Laboratory => edges(&lattice),
        };
        if !fixed.iter().any(|pair| pair[0] || pair[1]) {
            return Err(vec![
                Problem::new("d", "the anchor plates catch no node of the net")
                    .value(format!("{} m", shortest(layout.plate)))
                    .allowed("at least about one opening of the mesh"),
            ]);
        }
        let dome = Dome::new(layout.shape, layout.punch, net.node_radius);
        Ok(Scene { spec: spec.clone(), lattice, law: Law::new(&spec.wire), dome, field, fixed })
    }

    /// Slack delta_l of a bond, m: lambda_u l0 T.
    pub fn slack(&self, number: usize) -> f64 {
        let distortion = &self.law.distortion;
        let t = match distortion.slack {
            Slack::Fixed(t) => t,
            Slack::Triangular => {
                let (seed, number) = self.draw(number);
                hash::triangular(seed, number)
            }
        };
        distortion.lambda_u * self.length(bond_of(number).1) * t
    }

    /// Unloaded length of a bond, m.
    pub fn length(&self, role: Role) -> f64 {
        match role {
            Role::Twist => self.lattice.twist_length(),
            _ => self.lattice.wire_length(),
        }
    }

    /// Whether every bond of a kind has the same slack.
    pub(crate) fn uniform(&self) -> bool {
        let d = &self.law.distortion;
        d.lambda_u == 0.0 || matches!(d.slack, Slack::Fixed(_))
    }

    /// Seed and counter of a bond's draw: those of its place in its cell, so that the cells of the first
    /// block have the same slack in every field, and the others one each of their own.
    fn draw(&self, number: usize) -> (u64, u64) {
        if self.field.cells == [1, 1] {
            return (self.spec.seed, number as u64);
        }
        let (pair, role) = bond_of(number);
        let (row, column) = (pair / self.lattice.columns, pair % self.lattice.columns);
        let (cell, [column, row]) = self.within_cell(row, column);
        let columns = self.lattice.columns / self.field.cells[0];
        let number = bond_number(row * columns + column, role) as u64;
        // How many cells to the right of and above the first block's; beyond half the field to the left
        // and below, so that a larger field adds cells and changes none.
        let [x, y] = [0, 1].map(|k| {
            let (cells, apart) = (self.field.cells[k], cell[k]);
            if 2 * apart > cells { (cells - apart) as u64 * 2 - 1 } else { apart as u64 * 2 }
        });
        if (x, y) == (0, 0) {
            return (self.spec.seed, number);
        }
        (hash::hash(self.spec.seed, CELL_COUNTERS + 1024 * y + x), number)
    }

    /// The cell of a pair, and the pair's column and row in it.
    pub(super) fn within_cell(&self, row: usize, column: usize) -> ([usize; 2], [usize; 2]) {
        let columns = self.lattice.columns / self.field.cells[0];
        let rows = self.lattice.rows / self.field.cells[1];
        ([column / columns, row / rows], [column % columns, row % rows])
    }

    /// Unloaded places of a pair's bottom and top node, from the corner of the pair's cell, m; and the cell.
    pub(super) fn in_its_cell(&self, row: usize, column: usize) -> ([[f64; 2]; 2], [usize; 2]) {
        let (cell, [column, row]) = self.within_cell(row, column);
        ([self.lattice.bottom(row, column), self.lattice.top(row, column)], cell)
    }

    /// Unloaded places of a pair's bottom and top node seen from a block's axis, m; in the anchored test the
    /// nearest image of the block.
    pub(super) fn pair_from(&self, block: &Block, row: usize, column: usize) -> [[f64; 2]; 2] {
        let (places, cell) = self.in_its_cell(row, column);
        places.map(|place| self.from(block, place, cell))
    }

    fn from(&self, block: &Block, place: [f64; 2], cell: [usize; 2]) -> [f64; 2] {
        if self.lattice.periodic {
            return self.field.seen_from_block(block, place, cell);
        }
        [place[0] - block.axis[0], place[1] - block.axis[1]]
    }

    /// A place seen from the axis of the nearest block, m; in the anchored test periodic images included.
    pub fn from_axis(&self, place: [f64; 2]) -> [f64; 2] {
        let seen = self.field.blocks.iter().map(|block| self.from(block, place, [0, 0]));
        seen.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1]))).unwrap_or(place)
    }

    /// Numbers of the bonds that exist, rising.
    pub fn bond_numbers(&self) -> impl Iterator<Item = usize> + '_ {
        let columns = self.lattice.columns;
        (0..self.lattice.pairs()).flat_map(move |pair| {
            Role::ALL
                .into_iter()
                .filter(move |&role| self.lattice.has(pair / columns, pair % columns, role))
                .map(move |role| bond_number(pair, role))
        })
    }
}

/// Checks what can be wrong before anything is built.
fn check(spec: &SceneSpec) -> Result<(), Vec<Problem>> {
    let mut problems = Vec::new();
    let mut layout = spec.layout;
    if spec.test == Test::Laboratory {
        layout.plate = layout.spacing / 2.0; // There are no plates: their size is not judged.
        if !layout.is_square() {
            problems.push(
                Problem::new("Ly", "the laboratory's panel is square and has no anchors")
                    .allowed("one spacing L, its side, and no stagger"),
            );
        }
    }
    if let Err(found) = layout.check() {
        problems.extend(found);
    } else if let Some((word, side)) =
        layout.words().into_iter().zip(layout.sides()).find(|(_, side)| *side > LARGEST_PANEL)
    {
        problems.push(
            Problem::new(word, "the panel is too large to simulate")
                .value(format!("{} m", shortest(side)))
                .allowed(format!("up to {LARGEST_PANEL} m")),
        );
    } else if spec.test == Test::Anchored && layout.punch_on_plate() {
        problems.push(
            Problem::new("D", "the block stands on an anchor plate")
                .value(format!("{} m", shortest(layout.punch)))
                .advice("move the block (ex, ey) or take a smaller one"),
        );
    } else if spec.test == Test::Laboratory {
        let reach = layout.ex.abs().max(layout.ey.abs()) + layout.punch / 2.0;
        let margin = spec.wire.net.opening.max(spec.wire.net.twist + spec.wire.net.projection);
        if reach + margin > layout.spacing / 2.0 {
            problems.push(
                Problem::new("D", "the punch reaches the edge of the laboratory panel")
                    .value(format!("{} m", shortest(layout.punch)))
                    .allowed("a mesh inside the panel's edge, offset included"),
            );
        }
    }
    for (name, p) in [("phase.x", spec.phase[0]), ("phase.y", spec.phase[1])] {
        if !(0.0..1.0).contains(&p) {
            problems.push(
                Problem::new(name, "an alignment is a part of a period")
                    .value(shortest(p))
                    .allowed("from 0, below 1"),
            );
        }
    }
    if let Err(found) = spec.wire.check() {
        problems.extend(found.into_iter().map(|p| p.under("wire")));
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// Counters from which on the seeds of further cells are drawn: far beyond any bond's number.
const CELL_COUNTERS: u64 = 1 << 40;

/// A length below which two places are the same, m: far above rounding, far below a wire.
const SAME: f64 = 1.0e-9;

/// Nodes within the square plates at the anchors.
fn plates(lattice: &Lattice, field: &BlockField, side: f64) -> Vec<[bool; 2]> {
    let [right, up] = field.repeats();
    let (columns, rows) =
        (right * lattice.columns / field.cells[0], up * lattice.rows / field.cells[1]);
    let on_plate = |place: [f64; 2]| {
        let (_, seen) = field.nearest_anchor(place, [0, 0]);
        seen.iter().all(|x| x.abs() <= side / 2.0 + SAME)
    };
    // As in the first cells, so that all plates catch the same pattern to the last node.
    (0..lattice.rows)
        .flat_map(|i| (0..lattice.columns).map(move |j| (i % rows, j % columns)))
        .map(|(i, j)| [on_plate(lattice.bottom(i, j)), on_plate(lattice.top(i, j))])
        .collect()
}

/// Nodes on the panel's four edges.
fn edges(lattice: &Lattice) -> Vec<[bool; 2]> {
    each_pair(lattice, |p| {
        p.iter().zip(lattice.size).any(|(x, size)| *x < SAME || *x > size - SAME)
    })
}

fn each_pair(lattice: &Lattice, inside: impl Fn([f64; 2]) -> bool) -> Vec<[bool; 2]> {
    (0..lattice.rows)
        .flat_map(|i| (0..lattice.columns).map(move |j| (i, j)))
        .map(|(i, j)| [inside(lattice.bottom(i, j)), inside(lattice.top(i, j))])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::laws;

    fn spec(test: Test) -> SceneSpec {
        let layout =
            Layout { spacing: if test == Test::Anchored { 3.04 } else { 3.0 }, ..REFERENCE };
        SceneSpec {
            layout,
            test,
            wire: laws::yade(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        }
    }

    #[test]
    fn the_published_scenes_hold_the_published_number_of_nodes() {
        for (test, held) in [(Test::Anchored, 32), (Test::Laboratory, 150)] {
            let scene = Scene::new(&spec(test)).unwrap();
            let count: usize =
                scene.fixed.iter().map(|p| usize::from(p[0]) + usize::from(p[1])).sum();
            assert_eq!(count, held, "{test:?}");
        }
    }

    #[test]
    fn the_plain_alignment_puts_the_laboratory_punch_over_the_middle_of_a_wire() {
        let scene = Scene::new(&spec(Test::Laboratory)).unwrap();
        let axis = scene.field.blocks[0].axis;
        assert!((axis[0] - 1.5).abs() < 1e-12 && (axis[1] - 1.5).abs() < 1e-12);
        let nearest = scene
            .bond_numbers()
            .map(|n| scene.from_axis(scene.lattice.middle(n)))
            .map(|p| (p[0] * p[0] + p[1] * p[1]).sqrt())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-9, "{nearest}");
    }

    #[test]
    fn senseless_scenes_are_refused_with_the_field() {
        let refused = |change: &dyn Fn(&mut SceneSpec), field: &str| {
            let mut s = spec(Test::Anchored);
            change(&mut s);
            let found = Scene::new(&s).unwrap_err();
            assert!(found.iter().any(|p| p.field == field), "{field}: {found:?}");
        };
        refused(&|s| s.layout.plate = 0.01, "d");
        refused(&|s| (s.layout.ex, s.layout.ey) = (1.5, 1.5), "D");
        refused(&|s| s.layout.spacing = 50.0, "L");
        refused(&|s| s.phase[1] = 1.0, "phase.y");
        refused(&|s| s.wire.single[0].0 = f64::NAN, "wire.single[0]");
        refused(&|s| (s.layout.spacing, s.layout.punch, s.layout.plate) = (0.2, 0.05, 0.1), "L");
    }

    #[test]
    fn slack_depends_on_seed_and_bond_alone_and_stays_in_its_range() {
        let mut s = spec(Test::Anchored);
        s.wire = laws::reference();
        let (a, again) = (Scene::new(&s).unwrap(), Scene::new(&s).unwrap());
        s.seed = 1;
        let other = Scene::new(&s).unwrap();
        let (mut same, mut n) = (0, 0);
        for bond in a.bond_numbers() {
            let limit = 0.03 * a.length(bond_of(bond).1);
            assert_eq!(a.slack(bond).to_bits(), again.slack(bond).to_bits());
            assert!((0.0..=limit).contains(&a.slack(bond)));
            same += usize::from(a.slack(bond) == other.slack(bond));
            n += 1;
        }
        assert!(same < n / 100, "{same} of {n}");
    }
}
