//! The scene: what the solvers run, made from a layout, a test, a wire law, an alignment and a seed.

use super::dome::Dome;
use super::hash;
use super::lattice::{Lattice, Role, bond_number, bond_of};
use super::law::Law;
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
    /// The punch.
    pub dome: Dome,
    /// The punch's axis, measured from the panel's corner, m.
    pub axis: [f64; 2],
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
        let size = layout.spacing;
        let lattice = match spec.test {
            Test::Anchored => Lattice::periodic(net, size, spec.phase),
            Test::Laboratory => Lattice::panel(net, size),
        };
        if lattice.columns < 4 || lattice.rows < 4 {
            return Err(vec![
                Problem::new("L", "the panel is too small for a net of this mesh")
                    .value(format!("{} m", shortest(size)))
                    .allowed("at least four openings and two periods along the twists"),
            ]);
        }
        let mut axis = [size / 2.0 + layout.ex, size / 2.0 + layout.ey];
        if spec.test == Test::Laboratory {
            let period = [lattice.opening, 2.0 * lattice.pitch()];
            for k in 0..2 {
                let shift = spec.phase[k] - PLAIN_PHASE[k];
                axis[k] += (shift - shift.round()) * period[k];
            }
        }
        let fixed = match spec.test {
            Test::Anchored => plates(&lattice, layout.plate),
            Test::Laboratory => edges(&lattice),
        };
        if !fixed.iter().any(|pair| pair[0] || pair[1]) {
            return Err(vec![
                Problem::new("d", "the anchor plates catch no node of the net")
                    .value(format!("{} m", shortest(layout.plate)))
                    .allowed("at least about one opening of the mesh"),
            ]);
        }
        let dome = Dome::new(layout.punch, net.node_radius);
        Ok(Scene { spec: spec.clone(), lattice, law: Law::new(&spec.wire), dome, axis, fixed })
    }

    /// Slack delta_l of a bond, m: lambda_u l0 T.
    pub fn slack(&self, number: usize) -> f64 {
        let distortion = &self.law.distortion;
        let t = match distortion.slack {
            Slack::Fixed(t) => t,
            Slack::Triangular => hash::triangular(self.spec.seed, number as u64),
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

    /// A place of the unloaded net seen from the punch's axis, m; in the anchored test the nearest
    /// periodic image.
    pub fn from_axis(&self, place: [f64; 2]) -> [f64; 2] {
        let mut seen = [place[0] - self.axis[0], place[1] - self.axis[1]];
        if self.lattice.periodic {
            for (x, size) in seen.iter_mut().zip(self.lattice.size) {
                *x -= size * (*x / size).round();
            }
        }
        seen
    }

    /// The same place measured from the panel's centre, m.
    pub(crate) fn seen_from_centre(&self, place: [f64; 2]) -> [f64; 2] {
        [place[0] - self.lattice.size[0] / 2.0, place[1] - self.lattice.size[1] / 2.0]
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
    }
    if let Err(found) = layout.check() {
        problems.extend(found);
    } else if layout.spacing > LARGEST_PANEL {
        problems.push(
            Problem::new("L", "the panel is too large to simulate")
                .value(format!("{} m", shortest(layout.spacing)))
                .allowed(format!("up to {LARGEST_PANEL} m")),
        );
    } else if spec.test == Test::Anchored && layout.punch_on_plate() {
        problems.push(
            Problem::new("D", "the punch stands on an anchor plate")
                .value(format!("{} m", shortest(layout.punch)))
                .advice("move the punch (ex, ey) or take a smaller one"),
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

/// A length below which two places are the same, m: far above rounding, far below a wire.
const SAME: f64 = 1.0e-9;

/// Nodes within the square plates at the cell's corners.
fn plates(lattice: &Lattice, side: f64) -> Vec<[bool; 2]> {
    each_pair(lattice, |p| {
        p.iter()
            .zip(lattice.size)
            .all(|(x, size)| (x - size * (x / size).round()).abs() <= side / 2.0 + SAME)
    })
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
        SceneSpec { layout, test, wire: laws::yade(), phase: PLAIN_PHASE, seed: 0 }
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
        assert!((scene.axis[0] - 1.5).abs() < 1e-12 && (scene.axis[1] - 1.5).abs() < 1e-12);
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
