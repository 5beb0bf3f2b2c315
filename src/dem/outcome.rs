//! What a run tells.

use super::lattice::Role;
use crate::curve::Point;

/// Utilisation, at the last look before a first break, below which the break was sudden.
const SUDDEN: f64 = 0.7;
/// Shaking (see [`Quality`]) above which a first break is not believed at once: runs of the bench scenes
/// stay below 3, unstable ones were at 12 and more. A net that snaps from one shape to another under a
/// small punch reaches 60; such a run is repeated, and then stands.
const SHAKING: f64 = 8.0;

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Stop {
    /// The chosen distance after the first break was reached.
    AfterBreak,
    /// The punch slipped through: the force stayed below 20 % of its peak for 30 mm without a break.
    Slipped,
    /// The largest punch displacement was reached.
    DisplacementLimit,
    /// The caller ended it.
    Cancelled,
    /// The state ran away or the energies do not balance: the numbers mean nothing.
    Diverged,
}

/// A broken bond.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Break {
    /// Number of the bond (see [`super::lattice::bond_of`]).
    pub number: usize,
    /// Which of its pair's bonds.
    pub role: Role,
    /// Punch displacement when it was found broken, m.
    pub deflection: f64,
    /// Place of its middle in the unloaded net, m: from the centre of its cell as the block of that cell has
    /// it (see [`super::field`]), which for one cell is the panel's centre.
    pub place: [f64; 2],
}

/// What an anchor carries.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AnchorForce {
    /// Its place from the field's corner, m.
    pub place: [f64; 2],
    /// Pull of the net on it along x and y and out of the plane, N.
    pub force: [f64; 3],
}

impl AnchorForce {
    /// Its size, N.
    pub fn size(&self) -> f64 {
        let [x, y, z] = self.force;
        (x * x + y * y + z * z).sqrt()
    }

    /// Its part out of the plane and its part in the plane, N.
    pub(crate) fn parts(&self) -> [f64; 2] {
        [self.force[2], self.force[0].hypot(self.force[1])]
    }
}

/// Figures that tell how far a run can be trusted; parts of 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Quality {
    /// Kinetic energy over the work of the punch, which in a slow test is nearly all in the bonds, at the
    /// first break (or the end).
    pub kinetic_over_internal: f64,
    /// Work of the punch that is found in no energy, over that work, up to the first break (or the end).
    pub energy_balance: f64,
    /// Force on the support over force on the punch, means over the last quarter of that way.
    pub support_over_punch: f64,
    /// Largest utilisation (strain over strain at rupture) at the last look, some 6 mm before the first
    /// break; see [`super::run`] on silent failures.
    pub last_utilisation: f64,
    /// Largest change of a twist's strain in a step over its strain at rupture, times the steps that the
    /// punch needs for a tenth of its way: above 1 the net shakes; see [`super::run`] on silent failures.
    pub shaking: f64,
    /// Estimated largest error of force and deflection at the first break, and of the curve over its largest
    /// force; see [`super::estimate`].
    pub error_estimate: f64,
}

/// What a run cost; the caller adds the time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cost {
    /// Steps from the first touch to the stop.
    pub steps: usize,
    /// Steps up to the first break, or in all where there was none.
    pub steps_to_break: usize,
    /// Nodes of the net, two a pair.
    pub nodes: usize,
    /// Bonds that there were at the start.
    pub bonds: usize,
}

/// The deformed net, for drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Net {
    /// Places of the nodes from the panel's corner, m; 2 k is the bottom and 2 k + 1 the top of pair k.
    pub nodes: Vec<[f64; 3]>,
    /// Bonds that hold: first and second node. Those that cross a periodic edge are left out.
    pub bonds: Vec<[usize; 2]>,
    /// Punch displacement, m.
    pub deflection: f64,
}

/// What one run of a scene gives.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOutcome {
    /// Why it ended.
    pub stop: Stop,
    /// Force (weighted mean of punch and support, see [`super::run`]) and punch displacement at the
    /// first break, N and m.
    pub first_break: Option<Point>,
    /// The broken bonds in order.
    pub breaks: Vec<Break>,
    /// Largest force up to the stop and its displacement.
    pub peak: Point,
    /// Work of the punch up to the first break (or to the end), J.
    pub energy: f64,
    /// Tangent stiffness at 75 % of the force at the first break (or the peak), N/m; 0 where the
    /// curve is too short for it.
    pub k75: f64,
    /// Means of the force over windows of about 2 mm.
    pub curve: crate::curve::Curve,
    /// The force on the punch alone, N, at the same displacements.
    pub punch: Vec<f64>,
    /// The force on the support alone, N.
    pub support: Vec<f64>,
    /// Quality figures.
    pub quality: Quality,
    /// Steps and sizes, from which the caller has the time of each.
    pub cost: Cost,
    /// What was skipped, and what it may change, one sentence each.
    pub skipped: Vec<String>,
    /// Stretch of the net in x and y that met the panel's size.
    pub stretch: [f64; 2],
    /// Whether the run was repeated with a shorter step, because its first break came suddenly.
    pub repeated: bool,
    /// The deformed net at the first break, where the caller asked for it.
    pub net: Option<Net>,
    /// What each anchor carries at the first break, row by row; nothing without a break and in the
    /// laboratory.
    pub anchors: Vec<AnchorForce>,
}

#[cfg(test)]
impl RunOutcome {
    /// For tests: a run with a curve, that broke where the curve has its failure.
    pub(crate) fn invented(curve: crate::curve::Curve) -> RunOutcome {
        RunOutcome {
            stop: Stop::AfterBreak,
            first_break: curve.failure,
            breaks: Vec::new(),
            peak: curve.failure.unwrap_or_default(),
            energy: 0.0,
            k75: 0.0,
            curve,
            punch: Vec::new(),
            support: Vec::new(),
            quality: Quality::default(),
            cost: Cost::default(),
            skipped: Vec::new(),
            stretch: [1.0; 2],
            repeated: false,
            net: None,
            anchors: Vec::new(),
        }
    }
}

impl RunOutcome {
    /// The anchor with the largest force at the first break.
    pub fn worst_anchor(&self) -> Option<AnchorForce> {
        self.anchors.iter().copied().max_by(|a, b| a.size().total_cmp(&b.size()))
    }

    /// How many anchors, the most loaded first, carry this part of the force out of the plane at the first
    /// break; 0 without a break.
    pub fn anchors_carrying(&self, part: f64) -> usize {
        let mut forces: Vec<f64> = self.anchors.iter().map(|a| a.force[2]).collect();
        forces.sort_by(|a, b| b.total_cmp(a));
        let goal = part * forces.iter().sum::<f64>();
        let mut carried = 0.0;
        let enough = forces.iter().position(|force| {
            carried += force;
            carried >= goal
        });
        enough.map_or(0, |at| at + 1)
    }

    /// Whether a snap of the net from one shape to another decides this run: it shook with a shorter step
    /// too. Where the snap comes, and so the answer, then hangs on millimetres at any speed.
    pub(crate) fn snaps(&self) -> bool {
        self.first_break.is_some() && self.quality.shaking > SHAKING
    }

    /// Whether the first break came out of nowhere, as those of an unstable step do.
    pub fn sudden(&self) -> bool {
        let q = &self.quality;
        self.first_break.is_some() && (q.last_utilisation < SUDDEN || q.shaking > SHAKING)
    }
}
