//! What a check leaves behind: figures, a mean curve of few points with its band, where the first
//! wires broke, how far to trust it, and the fingerprint of what it was made from. Small enough to be
//! kept in a project, enough to draw and to report from.
//!
//! - [`make`]: a layout's ensemble, watched from outside, and its result.
//! - [`revisions`]: which solver and sampling made it.
//! - [`remade`]: what another solver or sampling had made.
//! - [`sampled`]: where its runs stood among all alignments, and what each weighs.
//! - [`mean`]: the mean curve and its band; [`places`]: where wires broke first; [`relief`]: the shape of the deformed net.
//!
//! The numbers are rounded to [`DIGITS`] significant digits when a result is made, in the units in
//! which a project holds them (kN, m, J), so that writing and reading one changes nothing.

pub mod make;
pub(crate) mod mean;
pub(crate) mod places;
pub mod relief;
pub(crate) mod remade;
pub(crate) mod revisions;
pub mod sampled;

use super::ensemble::{Ensemble, Plan, Run, Spread, counts, weighted_mean, weights};
use super::exactness::Exactness;
use super::paired;
use super::remark::{CheckFlag, CheckRemark, Facts};
use crate::curve::{Curve, Point};
use crate::dem::lattice::Role;
use crate::dem::outcome::Quality;
use crate::dem::{Controls, Fidelity};
use crate::fingerprint::Fingerprint;
use crate::units::{from_kn, to_kn};
use crate::words::Choice;
pub use revisions::Revisions;
use sampled::Catch;
pub use sampled::Sampled;

/// Significant digits of the numbers of a result; the method is good for three.
pub(crate) const DIGITS: usize = 5;

/// What is asked of a check.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// How exactly each run computes.
    pub fidelity: Exactness,
    /// Number of runs; nothing means as many as the mean needs, see [`Plan::runs`].
    pub runs: Option<usize>,
    /// Seed of alignments and slack.
    pub seed: u64,
}

impl Default for Wanted {
    /// By the ensemble's own choice, as many runs as needed, seed 0.
    fn default() -> Wanted {
        Wanted { fidelity: Exactness::default(), runs: None, seed: 0 }
    }
}

impl Wanted {
    /// Controls of the runs.
    pub(crate) fn controls(&self) -> Controls {
        Controls { fidelity: self.fidelity.fidelity(), keep_net: true, ..Controls::default() }
    }

    /// The fidelity of each run, where the ensemble does not choose it.
    pub(crate) fn run_fidelity(&self) -> Option<Fidelity> {
        paired::run_fidelity(&self.controls(), &self.plan(1))
    }

    /// How exactly the runs compute, with what that means where the ensemble may choose.
    pub(crate) fn fidelity_said(&self) -> String {
        let word = self.fidelity.word();
        match self.run_fidelity() {
            None => format!("{word} ({})", self.fidelity.about()),
            Some(own) if self.fidelity.auto() => format!("{word} ({} runs)", own.word()),
            Some(_) => word.into(),
        }
    }

    /// Plan of the ensemble, on this many threads.
    pub(crate) fn plan(&self, threads: usize) -> Plan {
        Plan {
            runs: self.runs,
            seed: self.seed,
            phase: None,
            auto: self.fidelity.auto(),
            threads: threads.max(1),
        }
    }
}

/// Where a run broke first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstBreak {
    /// Force (N) and deflection (m).
    pub at: Point,
    /// Middle of the broken bond in the unloaded net, from the panel's centre, m.
    pub place: [f64; 2],
    /// Whether it is a double twist; else a single wire.
    pub twist: bool,
}

/// How the blocks stood, and what that did to the anchors.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FieldFigures {
    /// How the blocks stood that gave the result; nothing said: the same block in every cell.
    pub arrangement: Option<String>,
    /// The force of the worst anchor of each run with a break, in the order of the runs, N: out of the
    /// plane of the net and in it. Empty in results of older programs.
    pub anchors: Vec<[f64; 2]>,
}

/// Force on an anchor, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorstAnchor {
    /// Mean over all alignments of the part out of the plane of the net.
    pub normal: f64,
    /// Mean of the part in the plane.
    pub in_plane: f64,
    /// Largest size of the whole force in any run.
    pub largest: f64,
}

impl WorstAnchor {
    /// Of the forces of some runs, as [`FieldFigures::anchors`] has them, and what each weighs; nothing of
    /// none.
    pub(crate) fn of(anchors: &[[f64; 2]], weights: &[f64]) -> Option<WorstAnchor> {
        let mean = |k: usize| anchors.iter().zip(weights).map(|(a, w)| w * a[k]).sum::<f64>();
        let largest = anchors.iter().map(|a| a[0].hypot(a[1])).fold(0.0, f64::max);
        (!anchors.is_empty()).then(|| WorstAnchor { normal: mean(0), in_plane: mean(1), largest })
    }

    /// Size of the mean force, N.
    pub(crate) fn size(&self) -> f64 {
        self.normal.hypot(self.in_plane)
    }
}

/// The result of a check in brief. Forces N, lengths m.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckResult {
    /// What was asked.
    pub wanted: Wanted,
    /// Fingerprint of all inputs, see [`super::inputs::of_ensemble`].
    pub inputs: Fingerprint,
    /// What made it.
    pub by: Revisions,
    /// Runs that count: those that came to an end of their own.
    pub runs: usize,
    /// How many of them slipped through without a break.
    pub slipped: usize,
    /// Force at the first break; without a break all zero but the band, which then is of the peaks.
    pub force: Spread,
    /// Deflection at the first break; likewise.
    pub deflection: Spread,
    /// Mean of the peaks.
    pub peak: Point,
    /// Mean tangent stiffness at 75 % of the force at the first break, N/m; 0 where there is none.
    pub k75: f64,
    /// Mean work of the punch up to the first break, J.
    pub energy: f64,
    /// Mean curve, at most [`mean::POINTS`] points; its failure point is the mean first break.
    pub curve: Curve,
    /// 5 % and 95 % limits of the force at the curve's points; empty for a single run.
    pub band: [Vec<f64>; 2],
    /// The first break of each run that has one, in the order of the runs.
    pub breaks: Vec<FirstBreak>,
    /// The worst of the runs' quality figures.
    pub quality: Quality,
    /// What the ensemble told of itself; see [`CheckResult::remarks`] for all there is to say.
    pub flags: Vec<CheckFlag>,
    /// How the blocks stood, and the anchors' forces.
    pub field: FieldFigures,
    /// Where its runs stood, and the points of the distribution.
    pub sampled: Sampled,
}

impl CheckResult {
    /// The result on an ensemble, or on what there is of one.
    pub(crate) fn from_ensemble(
        ensemble: &Ensemble,
        wanted: &Wanted,
        inputs: Fingerprint,
    ) -> CheckResult {
        let runs: Vec<&Run> = ensemble.runs.iter().filter(|run| counts(run)).collect();
        let (curve, band) = mean::curve(&runs, &ensemble.sample);
        let force = |v: f64| from_kn(rounded(to_kn(v)));
        let spread = |s: &Spread, round: &dyn Fn(f64) -> f64| Spread {
            mean: round(s.mean),
            deviation: round(s.deviation),
            error: round(s.error),
            band: s.band.map(round),
        };
        let breaks = runs.iter().filter_map(|run| {
            let (at, first) = (run.outcome.first_break?, run.outcome.breaks.first()?);
            Some(FirstBreak {
                at: Point { force: force(at.force), deflection: rounded(at.deflection) },
                place: first.place.map(rounded),
                twist: first.role == Role::Twist,
            })
        });
        let energy = weighted_mean(&ensemble.sample, &runs, &|run| run.outcome.energy);
        CheckResult {
            wanted: wanted.clone(),
            inputs,
            by: Revisions::CURRENT,
            runs: runs.len(),
            slipped: ensemble.slipped,
            force: spread(&ensemble.force, &force),
            deflection: spread(&ensemble.deflection, &rounded),
            peak: Point { force: force(ensemble.peak[0]), deflection: rounded(ensemble.peak[1]) },
            k75: force(ensemble.k75),
            energy: rounded(energy),
            breaks: breaks.collect(),
            curve,
            band,
            quality: worst(&runs),
            flags: ensemble.flags.clone(),
            field: FieldFigures {
                arrangement: None,
                anchors: anchors(&runs).into_iter().map(|parts| parts.map(&force)).collect(),
            },
            sampled: Sampled::of(ensemble, &runs),
        }
    }

    /// The worst anchor of its runs.
    pub fn anchor(&self) -> Option<WorstAnchor> {
        let anchors = &self.field.anchors;
        let weights = match anchors.len() == self.breaks.len() {
            true => self.sampled.weights(anchors.len()),
            false => Sampled::default().weights(anchors.len()),
        };
        WorstAnchor::of(anchors, &weights)
    }

    /// The force of the worst anchor over that on a block, at the first break.
    pub(crate) fn anchor_share(&self) -> Option<f64> {
        Some(self.anchor()?.size() / self.force.mean)
    }

    /// The force at the first break that 5 % of all alignments and slacks fall below, N; in results of
    /// older programs the lower end of the band. Nothing for a single run.
    pub(crate) fn characteristic(&self) -> Option<f64> {
        let band = || (self.broke() && self.runs > 1).then_some(self.force.band[0]);
        self.sampled.characteristic().or_else(band)
    }

    /// On how much of the slope a plate catches how many nodes.
    pub(crate) fn catches(&self) -> Vec<Catch> {
        let forces: Vec<f64> = self.breaks.iter().map(|b| b.at.force).collect();
        self.sampled.catches(&forces)
    }

    /// Whether the check was ended before all its runs were made.
    pub(crate) fn partial(&self) -> bool {
        self.flags.contains(&CheckFlag::Cancelled)
    }

    /// Whether there is a mean first break.
    pub(crate) fn broke(&self) -> bool {
        self.curve.failure.is_some()
    }

    /// The mean first break, N and m.
    pub(crate) fn mean_break(&self) -> Option<Point> {
        let (force, deflection) = (self.force.mean, self.deflection.mean);
        self.broke().then_some(Point { deflection, force })
    }

    /// Whether it still is what this program would find for inputs with the fingerprint `now`, as
    /// [`make::fingerprint`] makes it.
    pub(crate) fn current(&self, now: Fingerprint) -> bool {
        self.inputs == now && self.by == Revisions::CURRENT
    }
}

impl CheckResult {
    pub(crate) fn remarks(&self) -> Vec<CheckRemark> {
        let facts = Facts {
            flags: &self.flags,
            probe: None,
            diverged: None,
            runs: self.runs,
            broken: self.breaks.len(),
            slipped: self.slipped,
            aligned: false,
            force_error: self.force.uncertainty(),
            error_estimate: self.quality.error_estimate,
            fidelity: self.wanted.run_fidelity(),
        };
        facts.remarks()
    }
}

/// The worst anchor's force of each run that has one, out of the plane and in it, N.
fn anchors(runs: &[&Run]) -> Vec<[f64; 2]> {
    runs.iter().filter_map(|run| Some(run.outcome.worst_anchor()?.parts())).collect()
}

/// The worst anchor of the runs of an ensemble that count.
pub(crate) fn worst_anchor(ensemble: &Ensemble) -> Option<WorstAnchor> {
    let there = |run: &&Run| counts(run) && run.outcome.worst_anchor().is_some();
    let runs: Vec<&Run> = ensemble.runs.iter().filter(there).collect();
    WorstAnchor::of(&anchors(&runs), &weights(&ensemble.sample, &runs))
}

/// The worst of each figure.
fn worst(runs: &[&Run]) -> Quality {
    let most = |f: fn(&Quality) -> f64| {
        let far = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        rounded(runs.iter().map(|run| f(&run.outcome.quality)).fold(0.0, far))
    };
    let ratios = runs.iter().map(|run| run.outcome.quality.support_over_punch);
    let off = |a: f64, b: f64| if (b - 1.0).abs() > (a - 1.0).abs() { b } else { a };
    Quality {
        kinetic_over_internal: most(|q| q.kinetic_over_internal),
        energy_balance: most(|q| q.energy_balance),
        support_over_punch: rounded(ratios.fold(1.0, off)),
        last_utilisation: most(|q| q.last_utilisation),
        shaking: most(|q| q.shaking),
        error_estimate: most(|q| q.error_estimate),
    }
}

/// A number at [`DIGITS`] significant digits; 0 for what is no number.
pub(crate) fn rounded(value: f64) -> f64 {
    if !value.is_finite() || value == 0.0 {
        return 0.0;
    }
    // What was printed as a number is read as one.
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_keeps_five_digits_and_is_idempotent() {
        assert_eq!(rounded(30.174_56), 30.175);
        assert_eq!(rounded(-0.000_123_456), -0.000_123_46);
        assert_eq!(rounded(f64::NAN), 0.0);
        assert_eq!(rounded(-0.0).to_bits(), 0);
        for v in [1.0 / 3.0, 28_512.345, 1.0e-9, 9.999_96] {
            assert_eq!(rounded(rounded(v)), rounded(v));
            // The way through a file: N to kN, rounded, and back.
            let force = from_kn(rounded(to_kn(v)));
            assert_eq!(from_kn(rounded(to_kn(force))), force);
        }
    }
}
