//! Where the answer depends on a millimetre.
//!
//! Under a small dome near a symmetric position the net may stay on top or slip off to a side. Which
//! of the two happens is decided by rounding, so neither is an answer. Where that can be, the centre
//! and a place 5 mm and 3 mm beside it are both run; when their first breaks differ by more than 5 %,
//! only an ensemble over alignments means something.

use super::fidelity::Controls;
use super::run::{Flow, RunProgress, check};
use super::scene::{SceneSpec, Test};
use crate::problem::Problem;

/// Largest diameter of a dome that a net slips off, m.
pub(crate) const SMALL_PUNCH: f64 = 0.4;
/// Offset of the second run, m.
pub(crate) const OFFSET: [f64; 2] = [0.005, 0.003];
/// Difference of the forces at the first break that tells a bifurcation, over the larger.
pub(crate) const DIFFERENCE: f64 = 0.05;
/// Distance from a symmetric position that counts as near, m.
const NEAR: f64 = 0.01;

/// Whether a scene must be looked at: a small dome near the panel's centre or (in a periodic cell)
/// the middle of an edge.
pub(crate) fn suspect(spec: &SceneSpec) -> bool {
    let (ex, ey) = spec.layout.folded();
    let symmetric = |e: f64, side: f64| {
        e.abs() < NEAR || (spec.test == Test::Anchored && side / 2.0 - e.abs() < NEAR)
    };
    let [x, y] = spec.layout.sides();
    spec.layout.punch < SMALL_PUNCH && symmetric(ex, x) && symmetric(ey, y)
}

/// Forces at the first break (or the peak of a run that slipped), N, at the given place and beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Probe {
    /// At the place asked for.
    pub(crate) here: f64,
    /// 5 mm and 3 mm beside it.
    pub(crate) beside: f64,
}

impl Probe {
    /// Whether the two differ by more than [`DIFFERENCE`].
    pub(crate) fn bifurcation(&self) -> bool {
        (self.here - self.beside).abs() > DIFFERENCE * self.here.max(self.beside)
    }
}

/// Runs the two places. Nothing where the caller cancels.
///
/// # Errors
/// What is wrong with the scene or the controls.
pub(crate) fn probe(
    spec: &SceneSpec,
    controls: &Controls,
    progress: &mut dyn FnMut(RunProgress) -> Flow,
) -> Result<Option<Probe>, Vec<Problem>> {
    let mut forces = [0.0; 2];
    for (k, force) in forces.iter_mut().enumerate() {
        let mut spec = spec.clone();
        spec.layout.ex += OFFSET[0] * k as f64;
        spec.layout.ey += OFFSET[1] * k as f64;
        let mut cancelled = false;
        let controls = Controls { after_break: 0.0, keep_net: false, ..controls.clone() };
        let outcome = check(&spec, &controls, &mut |now| {
            let flow = progress(now);
            cancelled |= flow == Flow::Cancel;
            flow
        })?;
        if cancelled {
            return Ok(None);
        }
        *force = outcome.first_break.unwrap_or(outcome.peak).force;
    }
    Ok(Some(Probe { here: forces[0], beside: forces[1] }))
}
