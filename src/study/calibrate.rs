//! Calibration: the stress scale and the strain scale of a wire law that reproduce a mesh's laboratory
//! punch test.
//!
//! Both scales act on single wire and twist alike: stresses times q with the elastic modulus kept,
//! strains past the elastic point times s (the scalings of [`crate::mesh::laws::scaled`]). Force goes
//! about with q and deflection about with the root of the strain at rupture, so the fit is Broyden's
//! method in the logarithms of the four numbers, started from those exponents. Every iteration runs the same ensemble
//! (same seeds and alignments), so the scatter does not blur the differences.

use super::ensemble::{self, Ensemble, Plan};
use crate::dem::{Controls, Fidelity, Flow, SceneSpec, Test};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::laws::scaled;
use crate::mesh::wire::WireData;
use crate::problem::Problem;

/// What is fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// Laboratory force, N.
    pub force: f64,
    /// Laboratory deflection, m.
    pub deflection: f64,
    /// Side of the laboratory panel, m.
    pub panel: f64,
    /// Diameter of the punch, m.
    pub punch: f64,
}

/// A fitted law.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The law.
    pub wire: WireData,
    /// Scale of the stresses over the starting law.
    pub stress: f64,
    /// Scale of the strains past the elastic point over the starting law.
    pub strain: f64,
    /// The laboratory ensemble of the fitted law.
    pub laboratory: Ensemble,
    /// What the fitted law predicts for the anchored reference (d = 0.32, L = 3, D = 1 m).
    pub anchored: Ensemble,
    /// Residuals of force and deflection over the targets.
    pub residual: [f64; 2],
    /// Ensembles that were run for the fit.
    pub iterations: usize,
}

/// Residual at which the fit ends.
const CLOSE: f64 = 0.003;
/// Ensembles at most.
const ITERATIONS: usize = 8;
/// Runs of each.
const RUNS: usize = 8;

/// The starting law under the two scales.
pub fn scale(from: &WireData, stress: f64, strain: f64) -> WireData {
    WireData {
        single: scaled(&from.single, strain, stress),
        double_twist: scaled(&from.double_twist, strain, stress),
        ..from.clone()
    }
}

/// Fits the two scales. `tell` hears of every ensemble and may end the fit, which is then returned as
/// it stands.
///
/// # Errors
/// What is wrong with the law or the target; a mesh that slips through instead of breaking.
pub fn fit(
    from: &WireData,
    target: &Target,
    threads: usize,
    tell: &(dyn Fn(&str) -> Flow + Sync),
) -> Result<Fit, Vec<Problem>> {
    let controls =
        Controls { fidelity: Fidelity::Standard, after_break: 0.0, ..Controls::default() };
    let plan = Plan { runs: Some(RUNS), threads, ..Plan::default() };
    let layout = Layout { spacing: target.panel, punch: target.punch, ..REFERENCE };
    let go = |_| tell("");
    let run = |wire: &WireData, layout: Layout, test: Test| {
        let spec = SceneSpec { layout, test, wire: wire.clone(), phase: [0.0; 2], seed: 0 };
        ensemble::run(&spec, &controls, &plan, &go)
    };
    // Logarithms: x of the scales (stress, strain), r of the residuals (force, deflection).
    let mut x = [0.0_f64; 2];
    // Inverse of the matrix dr/dx; force ~ q s^0.3, deflection ~ s^0.45 roughly.
    let mut inverse = [[1.0, -0.67], [0.0, 2.2]];
    let mut best: Option<([f64; 2], [f64; 2], Ensemble)> = None;
    let mut last: Option<([f64; 2], [f64; 2])> = None;
    let mut iterations = 0;
    while iterations < ITERATIONS {
        let wire = scale(from, libm::exp(x[0]), libm::exp(x[1]));
        let laboratory = run(&wire, layout, Test::Laboratory)?;
        iterations += 1;
        if laboratory.force.mean <= 0.0 || laboratory.deflection.mean <= 0.0 {
            return Err(vec![
                Problem::new(
                    "force",
                    "the laboratory test of this law breaks no wire: nothing to fit",
                )
                .advice("look at the starting law and the punch's size"),
            ]);
        }
        let r = [
            libm::log(laboratory.force.mean / target.force),
            libm::log(laboratory.deflection.mean / target.deflection),
        ];
        let size = |r: &[f64; 2]| r[0].abs().max(r[1].abs());
        let stop = tell(&format!(
            "fit {iterations}: stress x {:.4}, strain x {:.4}: {:.2} kN, {:.4} m",
            libm::exp(x[0]),
            libm::exp(x[1]),
            laboratory.force.mean / 1.0e3,
            laboratory.deflection.mean
        ));
        if best.as_ref().is_none_or(|b| size(&r) < size(&b.1)) {
            best = Some((x, r, laboratory));
        }
        if size(&r) < CLOSE || stop == Flow::Cancel {
            break;
        }
        if let Some((x0, r0)) = last {
            inverse = broyden(inverse, [x[0] - x0[0], x[1] - x0[1]], [r[0] - r0[0], r[1] - r0[1]]);
        }
        last = Some((x, r));
        for k in 0..2 {
            let step = -(inverse[k][0] * r[0] + inverse[k][1] * r[1]);
            // At most a factor 1.65 at a time: the law is far from straight.
            x[k] = (x[k] + step.clamp(-0.5, 0.5)).clamp(-2.5, 2.5);
        }
    }
    // The loop ran at least once, and every pass either returns or leaves a best.
    let Some((x, r, laboratory)) = best else { return Err(Vec::new()) };
    let (stress, strain) = (libm::exp(x[0]), libm::exp(x[1]));
    let wire = scale(from, stress, strain);
    let anchored = run(&wire, REFERENCE, Test::Anchored)?;
    Ok(Fit {
        wire,
        stress,
        strain,
        laboratory,
        anchored,
        residual: [libm::exp(r[0]) - 1.0, libm::exp(r[1]) - 1.0],
        iterations,
    })
}

/// Broyden's good update of an inverse matrix (Broyden 1965) after the step `dx` changed the
/// residuals by `dr`.
fn broyden(inverse: [[f64; 2]; 2], dx: [f64; 2], dr: [f64; 2]) -> [[f64; 2]; 2] {
    let moved = [0, 1].map(|k| inverse[k][0] * dr[0] + inverse[k][1] * dr[1]);
    let bottom = dx[0] * moved[0] + dx[1] * moved[1];
    if bottom.abs() < 1.0e-12 {
        return inverse;
    }
    let row = [0, 1].map(|j| dx[0] * inverse[0][j] + dx[1] * inverse[1][j]);
    [0, 1].map(|k| [0, 1].map(|j| inverse[k][j] + (dx[k] - moved[k]) * row[j] / bottom))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broydens_update_meets_the_last_step() {
        let b = broyden([[1.0, -0.6], [0.0, 2.0]], [0.1, 0.2], [0.05, 0.07]);
        let back = [0, 1].map(|k| b[k][0] * 0.05 + b[k][1] * 0.07);
        // The secant condition, exact but for rounding.
        assert!((back[0] - 0.1).abs() < 1e-14 && (back[1] - 0.2).abs() < 1e-14);
    }
}
