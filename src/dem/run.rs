//! Run control: drives a solver from the first touch to a stated end.
//!
//! A run is a sequence of *windows* of about 2 mm of punch travel, each of *blocks* of 4 steps. After
//! a block (far from a break, after a window) broken bonds are looked for; after a window the mean
//! forces become a point of the curve. Energies are kept in an [`Account`].
//!
//! - *Force*: 0.25 of the force on the punch and 0.75 of that on the support. Inertia enters the two
//!   with opposite signs and nearly cancels; the weight was found on the four bench scenes (0.3 at first, less with scatter). The
//!   forces themselves are kept beside it.
//! - *First break*: the line through the points from 22 to 2 mm before the break, read at the break;
//!   the last two millimetres are left out because the support already feels the failing bond.
//! - *Inertia*: out of the plane fitted to the net's slopes every few millimetres where the scheme says so; the
//!   kinetic energy that this adds goes into the account.
//! - *Speed*: the punch slows down as the break comes near ([`super::pace`]).
//! - *Silent failure*: an unstable step does not blow up, it shakes one bond until that breaks, early
//!   and with a plausible force. Strains grow slowly in a true run: a few millimetres before a break some
//!   bond is nearly there. Where none was, or a twist shook (see [`RunOutcome::sudden`]), the run is
//!   repeated with 0.7 of the step; if that breaks suddenly too, and elsewhere, and its energies do not
//!   balance to 1 %, it counts as diverged. In every run they must balance to 2 % and half the kinetic energy.
//! - *Error estimate*: see [`super::estimate`].

use super::account::{Account, IMBALANCE};
use super::estimate;
use super::fast::{Fast, FastOptions, Path};
use super::fidelity::{Controls, Scheme};
use super::lattice::{Role, bond_of};
use super::outcome::{AnchorForce, Break, Cost, Net, Quality, RunOutcome, Stop};
use super::pace;
use super::scene::{Scene, SceneSpec, Test};
use super::stepper::{StepBlock, Stepper};
use crate::curve::{Curve, Point};
use crate::problem::Problem;

/// Steps between two searches for broken bonds.
const BLOCK: usize = 4;
/// Utilisation, at the last look, above which every block is looked through for broken bonds.
const WATCHFUL: f64 = 0.4;
/// Utilisation, at the last look, above which the anchors' forces are kept: a break is not near before.
const LOADED: f64 = 0.2;
/// Punch travel of a point of the curve, m.
const WINDOW: f64 = 0.002;
/// Part of the force on the punch in the reported force; the rest is the force on the support.
pub(crate) const PUNCH_WEIGHT: f64 = 0.25;
/// Where the fit of the force at a break begins and ends, m before the break.
const FIT: (f64, f64) = (0.022, 0.002);
/// Punch travel without force after which the punch has slipped, m, and what counts as none.
const SLIP: (f64, f64) = (0.03, 0.2);
/// Utilisation below which the punch had no hold that it could have lost.
const HELD: f64 = 0.1;
/// Punch travel between two looks at the utilisation, m.
const LOOK: f64 = 0.006;
/// Largest imbalance (see [`super::account`]) of a run whose punch slipped through: the net snaps back
/// faster than the kinetic energy is sampled, and what damping takes then is known less well (2.0 % and
/// a little more in sound runs).
const SNAP_IMBALANCE: f64 = 0.05;

/// How far a run has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunProgress {
    /// Punch displacement, m.
    pub deflection: f64,
    /// Force, N.
    pub force: f64,
    /// Largest strain over the strain at rupture, 0 to 1.
    pub utilisation: f64,
    /// Displacement at which the run ends at the latest, m.
    pub limit: f64,
    /// Steps so far.
    pub steps: usize,
    /// Whether a bond has broken.
    pub broken: bool,
}

/// The caller's answer to progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow {
    /// Go on.
    Continue,
    /// End the run with what it has.
    Cancel,
}

/// Builds a scene and runs it; once more, slower, where the controls ask for a run that keeps its aim.
///
/// `progress` is called after every window and may end the run; time is the caller's to take.
///
/// # Errors
/// What is wrong with the scene or the controls; a step beyond the stability bound is refused here.
pub fn check(
    spec: &SceneSpec,
    controls: &Controls,
    progress: &mut dyn FnMut(RunProgress) -> Flow,
) -> Result<RunOutcome, Vec<Problem>> {
    let first = once(spec, controls, progress)?;
    let (fidelity, estimate) = (controls.fidelity, first.quality.error_estimate);
    // Where a snap decides a slower punch helps as little as a higher fidelity.
    let helps = first.first_break.is_some() && first.stop != Stop::Cancelled && !first.snaps();
    if !controls.to_aim || controls.speed.is_some() || fidelity.keeps(estimate) || !helps {
        return Ok(first);
    }
    let travel = controls.scheme(&Scene::new(spec)?)?.travel;
    let slower = Controls { speed: Some(travel * fidelity.slower(estimate)), ..controls.clone() };
    let mut again = once(spec, &slower, progress)?;
    again.cost.steps += first.cost.steps;
    again.cost.steps_to_break += first.cost.steps_to_break;
    Ok(again)
}

/// Builds a scene and runs it; with a shorter step where its break was sudden.
fn once(
    spec: &SceneSpec,
    controls: &Controls,
    progress: &mut dyn FnMut(RunProgress) -> Flow,
) -> Result<RunOutcome, Vec<Problem>> {
    let scene = Scene::new(spec)?;
    let scheme = controls.scheme(&scene)?;
    let options = FastOptions {
        factors: scheme.factors,
        damping: scheme.damping,
        true_unloading: scheme.full,
        fitted: scheme.fitted,
        path: controls.path.unwrap_or_else(Path::best),
    };
    let mut outcome = run_scheme(&scene, options, &scheme, controls, progress);
    outcome.skipped = skipped(&scene, &scheme, controls);
    // What ran away may have been stepped too far as well.
    if outcome.sudden() || outcome.stop == Stop::Diverged {
        let shorter = 0.7;
        let mut scheme = scheme;
        scheme.factors.translation *= shorter;
        scheme.factors.stretching *= shorter;
        let options = FastOptions { factors: scheme.factors, ..options };
        let mut again = run_scheme(&scene, options, &scheme, controls, progress);
        again.cost.steps += outcome.cost.steps;
        again.cost.steps_to_break += outcome.cost.steps_to_break;
        again.quality.error_estimate = estimate::repeated(&outcome, &again);
        again.skipped = outcome.skipped;
        again.repeated = true;
        let near = |a: Option<Point>, b: Option<Point>| match (a, b) {
            (Some(a), Some(b)) => (a.deflection / b.deflection - 1.0).abs() < 0.03,
            _ => false,
        };
        // A sudden break is the net's own where it comes again with a shorter step, or where all energy
        // is accounted for: a net may snap from one shape to another.
        let balanced = again.quality.energy_balance.abs() < 0.5 * IMBALANCE;
        if again.sudden() && !near(again.first_break, outcome.first_break) && !balanced {
            again.stop = Stop::Diverged;
        }
        outcome = again;
    }
    if outcome.snaps() {
        let estimate = &mut outcome.quality.error_estimate;
        *estimate = estimate.max(estimate::SNAP);
    }
    Ok(outcome)
}

fn run_scheme(
    scene: &Scene,
    options: FastOptions,
    scheme: &Scheme,
    controls: &Controls,
    progress: &mut dyn FnMut(RunProgress) -> Flow,
) -> RunOutcome {
    if scheme.full {
        drive(scene, &mut Fast::<f64>::new(scene, options), scheme, controls, progress)
    } else {
        drive(scene, &mut Fast::<f32>::new(scene, options), scheme, controls, progress)
    }
}

/// The same for a solver of the caller's, from wherever it stands.
pub fn drive(
    scene: &Scene,
    solver: &mut dyn Stepper,
    scheme: &Scheme,
    controls: &Controls,
    progress: &mut dyn FnMut(RunProgress) -> Flow,
) -> RunOutcome {
    Run::new(scene, scheme, controls).run(solver, progress)
}

/// What a run gathers.
struct Run<'a> {
    scene: &'a Scene,
    scheme: &'a Scheme,
    controls: &'a Controls,
    limit: f64,
    points: Vec<StepBlock>,
    /// Forces of the anchors, N, as means over the same windows as `points`; nothing in the early ones.
    pulled: Vec<Vec<[f64; 3]>>,
    anchors: Vec<AnchorForce>,
    known: Vec<usize>,
    breaks: Vec<Break>,
    first_break: Option<Point>,
    steps: usize,
    steps_to_break: usize,
    energy: Account,
    quality: Quality,
    net: Option<Net>,
}

impl<'a> Run<'a> {
    fn new(scene: &'a Scene, scheme: &'a Scheme, controls: &'a Controls) -> Run<'a> {
        Run {
            scene,
            scheme,
            controls,
            limit: controls.limit_of(scene),
            points: Vec::new(),
            pulled: Vec::new(),
            anchors: Vec::new(),
            known: Vec::new(),
            breaks: Vec::new(),
            first_break: None,
            steps: 0,
            steps_to_break: 0,
            energy: Account::new(scheme.damping),
            quality: Quality::default(),
            net: None,
        }
    }

    fn run(
        mut self,
        solver: &mut dyn Stepper,
        progress: &mut dyn FnMut(RunProgress) -> Flow,
    ) -> RunOutcome {
        let (mut utilisation, mut looked, mut followed) = (0.0, 0.0, -pace::FOLLOW);
        let stop = loop {
            let travelled = solver.deflection() - looked;
            if travelled > LOOK {
                (utilisation, looked) = (solver.utilisation(), solver.deflection());
                if self.first_break.is_none() {
                    self.quality.last_utilisation = utilisation;
                }
            }
            if self.scheme.fitted && solver.deflection() - followed >= pace::FOLLOW {
                followed = solver.deflection();
                self.energy.add(solver.follow());
            }
            let pace = match self.first_break {
                Some(_) => pace::behind_break(self.scheme.fitted),
                None => pace::before_break(utilisation, self.scheme.fitted),
            };
            let travel = self.scheme.travel * pace;
            if let Some(stop) = self.window(solver, travel, utilisation) {
                break stop;
            }
            if let Some(stop) = self.ended(solver.deflection()) {
                break stop;
            }
            let now = RunProgress {
                deflection: solver.deflection(),
                force: self.points.last().map_or(0.0, weighted),
                utilisation,
                limit: self.limit,
                steps: self.steps,
                broken: self.first_break.is_some(),
            };
            if progress(now) == Flow::Cancel {
                break Stop::Cancelled;
            }
        };
        self.finish(stop, solver)
    }

    /// One window; tells if the run must end in it.
    fn window(&mut self, solver: &mut dyn Stepper, travel: f64, utilisation: f64) -> Option<Stop> {
        let blocks = ((WINDOW / travel / BLOCK as f64).round() as usize).max(1);
        let mut mean = StepBlock::default();
        let mut pulled = Vec::new();
        let mut broke = false;
        // Far from a break it is enough to look once a window.
        let watchful = self.first_break.is_some() || utilisation > WATCHFUL;
        for number in 1..=blocks {
            let block = solver.advance(BLOCK, travel);
            self.steps += BLOCK;
            if self.first_break.is_none() {
                self.energy.push(block.punch, travel, BLOCK);
            }
            mean.deflection += block.deflection / blocks as f64;
            mean.punch += block.punch / blocks as f64;
            mean.support += block.support / blocks as f64;
            if self.first_break.is_none() && utilisation > LOADED {
                add(&mut pulled, solver.anchors(), blocks);
            }
            if !(watchful || number == blocks) {
                continue;
            }
            let before = self.known.len();
            if solver.broken(&mut self.known) > 0 {
                broke = true;
                let found: Vec<usize> = self.known[before..].to_vec();
                for number in found {
                    self.breaks.push(Break {
                        number,
                        role: bond_of(number).1,
                        deflection: solver.deflection(),
                        place: self.scene.field.as_its_block(self.scene.lattice.middle(number)),
                    });
                }
                if self.first_break.is_none() {
                    self.first_break(solver);
                    let force = self.first_break.map_or(f64::NAN, |at| at.force);
                    let balance = self.quality.energy_balance.abs();
                    // No net pulls a block: such a force is shaking, and no answer.
                    let pushed = force > 0.0 && force.is_finite();
                    if !pushed {
                        self.first_break = None;
                    }
                    if !pushed || balance > self.energy.unexplained() {
                        return Some(Stop::Diverged);
                    }
                    break;
                }
            }
        }
        if !(mean.punch.is_finite() && mean.support.is_finite()) {
            return Some(Stop::Diverged);
        }
        // The window of the first break is left out: it is partly before and partly after it.
        if !(broke && self.first_just_now(solver)) {
            self.points.push(mean);
            self.pulled.push(pulled);
        }
        self.account(solver, blocks * BLOCK, travel)
    }

    /// Whether the first break was found in the last block.
    fn first_just_now(&self, solver: &dyn Stepper) -> bool {
        self.first_break.is_some_and(|p| p.deflection >= solver.deflection())
    }

    /// Keeps the energy account; tells if energy comes out of nowhere.
    fn account(&mut self, solver: &dyn Stepper, steps: usize, travel: f64) -> Option<Stop> {
        if self.first_break.is_some() {
            return None;
        }
        if !self.energy.due(steps, travel) {
            return None;
        }
        self.energy.sample(solver.kinetic(), solver.damping_loss());
        // Early on the net is slack and its nodes hop about; nothing is near a break then.
        if self.quality.last_utilisation > 0.1 {
            let steps = 0.1 * solver.deflection() / travel;
            self.quality.shaking = self.quality.shaking.max(solver.shaking() * steps);
        }
        if self.energy.ran_away() {
            return Some(Stop::Diverged);
        }
        let out_of_balance = self.energy.balance_due()
            && self.energy.imbalance(&solver.energies()).is_some_and(|i| self.energy.unbalanced(i));
        out_of_balance.then_some(Stop::Diverged)
    }

    /// Takes all energies, as the last entry of the account. Where damping is not accounted nothing is
    /// said against the run.
    fn close_account(&mut self, solver: &dyn Stepper) {
        self.energy.sample(solver.kinetic(), solver.damping_loss());
        let imbalance = self.energy.imbalance(&solver.energies());
        self.quality.energy_balance = imbalance.unwrap_or(0.0);
    }

    /// Records the first break.
    fn first_break(&mut self, solver: &dyn Stepper) {
        self.steps_to_break = self.steps;
        let at = solver.deflection();
        self.first_break = Some(Point { deflection: at, force: self.force_at(at) });
        self.anchors = self.anchors_at(at);
        self.close_account(solver);
        if self.controls.keep_net {
            self.net = Some(self.drawn(solver));
        }
    }

    /// What the anchors carry at a break: each part by the line through the same points.
    fn anchors_at(&self, at: f64) -> Vec<AnchorForce> {
        let field = &self.scene.field;
        let inside = |p: &StepBlock| at - p.deflection < FIT.0 && at - p.deflection > FIT.1;
        let kept = |n: &usize| inside(&self.points[*n]) && !self.pulled[*n].is_empty();
        let lately: Vec<usize> = (0..self.points.len()).filter(kept).collect();
        let count = self.pulled.last().map_or(0, Vec::len);
        (0..count)
            .map(|anchor| {
                let force = [0, 1, 2].map(|k| {
                    let points: Vec<(f64, f64)> = lately
                        .iter()
                        .map(|n| (self.points[*n].deflection, self.pulled[*n][anchor][k]))
                        .collect();
                    if points.len() < 3 {
                        return self.pulled.last().map_or(0.0, |all| all[anchor][k]);
                    }
                    let (slope, mean, force) = line_of(&points);
                    force + slope * (at - mean)
                });
                let ([x, y], z) = (field.turned([force[0], force[1]]), force[2]);
                AnchorForce { place: field.anchor(anchor), force: [x, y, z] }
            })
            .collect()
    }

    /// Force at a break, by the line through the points before it.
    fn force_at(&self, at: f64) -> f64 {
        let inside = |p: &&StepBlock| at - p.deflection < FIT.0 && at - p.deflection > FIT.1;
        let points: Vec<&StepBlock> = self.points.iter().filter(inside).collect();
        if points.len() < 3 {
            return self.points.last().map_or(0.0, weighted);
        }
        let (slope, mean, force) = line(&points);
        force + slope * (at - mean)
    }

    /// Whether the run has come to one of its ends.
    fn ended(&self, deflection: f64) -> Option<Stop> {
        match self.first_break {
            Some(first) if deflection >= first.deflection + self.controls.after_break => {
                return Some(Stop::AfterBreak);
            }
            None if self.slipped() => return Some(Stop::Slipped),
            _ => {}
        }
        (deflection >= self.limit).then_some(Stop::DisplacementLimit)
    }

    fn slipped(&self) -> bool {
        let Some(last) = self.points.last() else { return false };
        let peak = self.peak().force;
        // Below a quarter of one wire's strength there was no hold yet that could have been lost.
        if peak < 0.25 * self.scene.law.single.force.last().copied().unwrap_or(0.0) {
            return false;
        }
        // Nor while all wires are slack: a flat block throws the net up, with a force of inertia alone.
        if self.quality.last_utilisation < HELD {
            return false;
        }
        let lately =
            self.points.iter().rev().take_while(|p| last.deflection - p.deflection < SLIP.0);
        let (mut count, mut low) = (0, 0);
        for p in lately {
            count += 1;
            low += usize::from(weighted(p) < SLIP.1 * peak);
        }
        count == low && self.points.len() > count
    }

    fn peak(&self) -> Point {
        let mut peak = self.first_break.unwrap_or_default();
        for p in &self.points {
            if weighted(p) > peak.force {
                peak = Point { deflection: p.deflection, force: weighted(p) };
            }
        }
        peak
    }

    fn drawn(&self, solver: &dyn Stepper) -> Net {
        let lattice = &self.scene.lattice;
        let mut bonds = Vec::new();
        for number in self.scene.bond_numbers() {
            if self.known.contains(&number) {
                continue;
            }
            let (pair, role) = bond_of(number);
            let (row, column) = (pair / lattice.columns, pair % lattice.columns);
            match lattice.upper(row, column, role) {
                _ if role == Role::Twist => bonds.push([2 * pair, 2 * pair + 1]),
                Some((up, side)) if up > row && side.abs_diff(column) <= 1 => {
                    bonds.push([2 * pair + 1, 2 * (up * lattice.columns + side)]);
                }
                _ => {}
            }
        }
        Net { nodes: solver.positions(), bonds, deflection: solver.deflection() }
    }

    fn finish(mut self, mut stop: Stop, solver: &dyn Stepper) -> RunOutcome {
        if self.first_break.is_none() {
            self.steps_to_break = self.steps;
            self.close_account(solver);
            let balance = self.quality.energy_balance;
            let snapped = stop == Stop::Slipped && balance.abs() < SNAP_IMBALANCE;
            if self.energy.unbalanced(balance) && !snapped {
                stop = Stop::Diverged;
            }
            if self.controls.keep_net {
                self.net = Some(self.drawn(solver));
            }
        }
        let peak = self.peak();
        let end = self.first_break.map_or(f64::INFINITY, |p| p.deflection);
        let before: Vec<&StepBlock> =
            self.points.iter().filter(|p| p.deflection < end - FIT.1).collect();
        let reached = before.last().map_or(0.0, |p| p.deflection);
        let most = before.iter().map(|p| weighted(p)).fold(1.0e-9, f64::max);
        let late = before.iter().filter(|p| p.deflection > 0.75 * reached);
        let (punch, support) = late.fold((0.0, 0.0), |s, p| (s.0 + p.punch, s.1 + p.support));
        self.quality.kinetic_over_internal = self.energy.kinetic_over_work();
        self.quality.support_over_punch = if punch > 0.0 { support / punch } else { 0.0 };
        let forces: Vec<f64> = before.iter().map(|p| weighted(p)).collect();
        let (fidelity, full) = (self.controls.fidelity, self.scheme.full);
        self.quality.error_estimate =
            estimate::of(self.scene, fidelity, full, &before, &forces, most);
        let curve = Curve {
            deflection: self.points.iter().map(|p| p.deflection).collect(),
            force: self.points.iter().map(weighted).collect(),
            failure: self.first_break,
        };
        RunOutcome {
            stop,
            first_break: self.first_break,
            k75: stiffness_at_75(&before, self.first_break.unwrap_or(peak).force),
            breaks: self.breaks,
            peak,
            energy: self.energy.work(),
            curve,
            punch: self.points.iter().map(|p| p.punch).collect(),
            support: self.points.iter().map(|p| p.support).collect(),
            quality: self.quality,
            cost: Cost {
                steps: self.steps,
                steps_to_break: self.steps_to_break,
                nodes: self.scene.lattice.nodes(),
                bonds: self.scene.lattice.bonds(),
            },
            skipped: Vec::new(),
            stretch: self.scene.field.turned(self.scene.lattice.stretch),
            net: self.net,
            anchors: self.anchors,
            repeated: false,
        }
    }
}

/// Adds forces of the anchors to their means over so many blocks.
fn add(mean: &mut Vec<[f64; 3]>, block: Vec<[f64; 3]>, blocks: usize) {
    mean.resize(block.len(), [0.0; 3]);
    for (mean, force) in mean.iter_mut().flatten().zip(block.iter().flatten()) {
        *mean += force / blocks as f64;
    }
}

/// The reported force of a point.
fn weighted(p: &StepBlock) -> f64 {
    PUNCH_WEIGHT * p.punch + (1.0 - PUNCH_WEIGHT) * p.support
}

/// Least-squares line through points: slope, mean displacement, mean force.
fn line(points: &[&StepBlock]) -> (f64, f64, f64) {
    line_of(&points.iter().map(|p| (p.deflection, weighted(p))).collect::<Vec<_>>())
}

/// The same through any points.
fn line_of(points: &[(f64, f64)]) -> (f64, f64, f64) {
    let n = points.len() as f64;
    let x = points.iter().map(|p| p.0).sum::<f64>() / n;
    let y = points.iter().map(|p| p.1).sum::<f64>() / n;
    let (mut top, mut bottom) = (0.0, 0.0);
    for p in points {
        top += (p.0 - x) * (p.1 - y);
        bottom += (p.0 - x) * (p.0 - x);
    }
    (if bottom > 0.0 { top / bottom } else { 0.0 }, x, y)
}

/// Tangent where the force is 75 % of `force`, fitted over +-5 % of it, N/m; 0 where there are fewer
/// than three points.
fn stiffness_at_75(points: &[&StepBlock], force: f64) -> f64 {
    let inside = |p: &&&StepBlock| (0.70..=0.80).contains(&(weighted(p) / force));
    let chosen: Vec<&StepBlock> = points.iter().filter(inside).copied().collect();
    if chosen.len() < 3 { 0.0 } else { line(&chosen).0 }
}

/// What this run left out, and what each may change.
fn skipped(scene: &Scene, scheme: &Scheme, controls: &Controls) -> Vec<String> {
    let mut list = vec!["contact outside the dome's reach: changes nothing".to_string()];
    if scene.spec.test == Test::Laboratory {
        list.push("periodic images: there are none in the laboratory test".into());
    }
    if scene.uniform() {
        list.push("values of single bonds: all are alike without scatter".into());
    }
    if !scheme.full {
        list.push(
            "elastic unloading, softened to the steepest slope of loading: below 0.1 %".into(),
        );
        list.push("double precision: below 0.1 %".into());
    }
    if !controls.keep_net {
        list.push("the deformed net: not asked for".into());
    }
    list
}
