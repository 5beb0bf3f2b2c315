//! The tensile test of a net: a piece of it pulled along or across its twists until a bond breaks.
//!
//! The piece goes on beyond its edges (it is a periodic cell): grips hold no node, and sideways the net
//! neither widens nor narrows, as in a test whose sides are held. Length and width still count, because the
//! weakest of more bonds breaks earlier. The pull is an even stretch of the whole piece, in which the nodes
//! find their places; force is the mean over all cuts across the pull.
//!
//! With even slack all bonds of a kind carry the same, and statics gives the strength by hand. Along the
//! twists, with opening b and wires of taut length l, F = 2 F_w p/l' for each opening, where l' = l (1 +
//! strain) and p^2 = l'^2 - b^2/4, unless a twist breaks before; across them F = F_w (b'/2)/l' for each row.

use super::dome::Dome;
use super::field::{Arrangement, BlockField};
use super::inertia::StepFactors;
use super::lattice::{Lattice, Role, bond_of};
use super::law::Law;
use super::limits;
use super::plain::{Damping, Inertia, Plain};
use super::run::{Flow, RunProgress};
use super::scene::{PLAIN_PHASE, Scene, SceneSpec, Test};
use super::stability::Eigenvalues;
use super::stepper::Stepper;
use crate::curve::Curve;
use crate::layout::REFERENCE;
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use crate::units::shortest;
use crate::words::Choice;

/// Which way a net is pulled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pull {
    /// Along the twists.
    Along,
    /// Across them.
    Across,
}

impl Choice for Pull {
    const ALL: &'static [Pull] = &[Pull::Along, Pull::Across];

    fn word(self) -> &'static str {
        match self {
            Pull::Along => "along",
            Pull::Across => "across",
        }
    }
}

/// A tensile test.
#[derive(Debug, Clone, PartialEq)]
pub struct TensileSpec {
    /// Width of the piece, across the pull, m.
    pub width: f64,
    /// Length of the piece between the grips, m.
    pub length: f64,
    /// Which way it is pulled.
    pub pull: Pull,
    /// Net and wires.
    pub wire: WireData,
    /// Seed of the random slack.
    pub seed: u64,
}

/// What a tensile test gives.
#[derive(Debug, Clone, PartialEq)]
pub struct TensileOutcome {
    /// Force over width at the first break, N/m; the largest one where nothing broke.
    pub strength: f64,
    /// Elongation there, as a part of the length.
    pub elongation: f64,
    /// Which bond broke first; nothing if none did or the caller ended it.
    pub broke: Option<Role>,
    /// Elongation, as a length in m, and force, N, of the whole piece.
    pub curve: Curve,
    /// The net as it was stretched to whole periods, in x and y.
    pub stretch: [f64; 2],
}

/// Elongation at which a test ends that breaks nothing, as a part.
const LIMIT: f64 = 1.0;
/// Elongation in a step, as a part of the length.
const TRAVEL: f64 = 1.0e-5;
/// Steps between two looks.
const LOOK: usize = 50;
/// Velocity lost in a step: far from critical for the longest waves of a piece of metres.
const DAMPING: f64 = 0.01;
/// Sides that make sense, m.
const SIDES: (f64, f64) = (0.2, 10.0);

impl TensileSpec {
    /// How far a test is that has come to this elongation, as a part of the length, for who watches runs.
    pub(crate) fn progress(&self, elongation: f64) -> RunProgress {
        RunProgress {
            deflection: elongation * self.length,
            force: 0.0,
            utilisation: 0.0,
            limit: self.length,
            steps: 0,
            broken: false,
        }
    }

    /// Sides of the piece in x (across the twists) and y, m.
    fn sides(&self) -> [f64; 2] {
        match self.pull {
            Pull::Along => [self.width, self.length],
            Pull::Across => [self.length, self.width],
        }
    }

    /// Axis of the pull: 0 for x, 1 for y.
    fn axis(&self) -> usize {
        usize::from(self.pull == Pull::Along)
    }

    fn scene(&self) -> Result<Scene, Vec<Problem>> {
        let mut problems = Vec::new();
        for (field, side) in [("width", self.width), ("length", self.length)] {
            if !(SIDES.0..=SIDES.1).contains(&side) {
                problems.push(
                    Problem::new(field, "no tensile test has such a piece")
                        .value(format!("{} m", shortest(side)))
                        .allowed(format!("{} to {} m", SIDES.0, SIDES.1)),
                );
            }
        }
        if let Err(found) = self.wire.check() {
            problems.extend(found.into_iter().map(|p| p.under("wire")));
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let net = &self.wire.net;
        let lattice = Lattice::cells(net, self.sides(), [1, 1], PLAIN_PHASE);
        if let Some(problem) = limits::of_net(&lattice, self.width.max(self.length)) {
            return Err(vec![problem]);
        }
        let spec = SceneSpec {
            layout: REFERENCE,
            test: Test::Anchored,
            wire: self.wire.clone(),
            phase: PLAIN_PHASE,
            seed: self.seed,
            arrangement: Arrangement::default(),
        };
        let dome = Dome::new(REFERENCE.shape, REFERENCE.punch, net.node_radius);
        let fixed = vec![[false; 2]; lattice.pairs()];
        let field = BlockField::one(&REFERENCE);
        Ok(Scene { spec, law: Law::new(&self.wire), lattice, dome, field, fixed })
    }
}

/// Pulls a net until its first bond breaks. `progress` gets the elongation after every fifty steps and may
/// end the test.
///
/// # Errors
/// Sides or wires that make no sense.
pub fn tensile(
    spec: &TensileSpec,
    progress: &mut dyn FnMut(f64) -> Flow,
) -> Result<TensileOutcome, Vec<Problem>> {
    let scene = spec.scene()?;
    let own = StepFactors { translation: 1.0, stretching: 0.65 };
    let within = Eigenvalues::of_scene(&scene, true, own).largest_factor(DAMPING, false).min(1.0);
    let factors =
        StepFactors { translation: own.translation * within, stretching: own.stretching * within };
    let mut piece = Piece::new(&scene, factors, spec);
    let (mut known, mut role) = (Vec::new(), None);
    let mut curve = Curve::default();
    while piece.elongation < LIMIT {
        for _ in 0..LOOK {
            piece.step();
        }
        if piece.plain.broken(&mut known) > 0 {
            role = known.first().map(|number| bond_of(*number).1);
            break;
        }
        curve.deflection.push(piece.elongation * piece.side);
        curve.force.push(piece.force());
        if progress(piece.elongation) == Flow::Cancel {
            break;
        }
    }
    // The look before the break is at most five parts in ten thousand before it.
    let force = curve.force.last().copied().unwrap_or(0.0);
    Ok(TensileOutcome {
        strength: force / spec.width,
        elongation: curve.deflection.last().copied().unwrap_or(0.0) / piece.side,
        broke: role,
        curve,
        stretch: scene.lattice.stretch,
    })
}

/// The piece while it is pulled.
struct Piece {
    plain: Plain,
    /// Which bonds cross the edge where the net goes on, as numbers in the solver's list.
    over: Vec<usize>,
    axis: usize,
    /// Length along the pull, m.
    side: f64,
    elongation: f64,
}

impl Piece {
    fn new(scene: &Scene, factors: StepFactors, spec: &TensileSpec) -> Piece {
        let mut plain = Plain::of_scene(scene, Inertia::Pairs(factors), Damping::Viscous(DAMPING));
        plain.without_punch();
        let axis = spec.axis();
        let place = |node: usize| {
            let (row, column) =
                (node / 2 / scene.lattice.columns, node / 2 % scene.lattice.columns);
            let lattice = &scene.lattice;
            let all = [lattice.bottom(row, column), lattice.top(row, column)];
            all[node % 2][axis]
        };
        let nodes = plain.net.places.len();
        for node in 0..nodes {
            plain.net.places[node][axis] = place(node);
        }
        let side = scene.lattice.size[axis];
        let bonds = &plain.net.bonds;
        let crosses = |k: &usize| {
            let b = &bonds[*k];
            let apart = plain.net.places[b.b][axis] - plain.net.places[b.a][axis];
            (apart - b.rest[axis]).abs() > 0.5 * side
        };
        let over: Vec<usize> = (0..bonds.len()).filter(crosses).collect();
        Piece { plain, over, axis, side, elongation: 0.0 }
    }

    /// One step: an even stretch of all, then the nodes move as they are pulled.
    fn step(&mut self) {
        let axis = self.axis;
        for (moved, place) in self.plain.moved.iter_mut().zip(&self.plain.net.places) {
            moved[axis] += TRAVEL * place[axis];
        }
        for k in &self.over {
            let rest = &mut self.plain.net.bonds[*k].rest[axis];
            *rest += TRAVEL * self.side * rest.signum();
        }
        self.elongation += TRAVEL;
        self.plain.step(0.0);
    }

    /// Force of the whole piece along the pull, N: bond forces times their lengths along it, over the
    /// length of the piece, which is the mean over all cuts.
    fn force(&self) -> f64 {
        let plain = &self.plain;
        let pull: f64 = plain
            .net
            .bonds
            .iter()
            .zip(&plain.top)
            .map(|(bond, top)| {
                let (a, b) = (plain.moved[bond.a], plain.moved[bond.b]);
                let d = [0, 1, 2].map(|k| bond.rest[k] + b[k] - a[k]);
                let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
                let e = length / bond.taut - 1.0;
                let force = plain.net.curves[bond.curve].force(&bond.ramp, top.max(e), e);
                force * d[self.axis] * d[self.axis] / length
            })
            .sum();
        pull / (self.side * (1.0 + self.elongation))
    }
}
