//! Fidelities: how fast the punch moves and how the net is stepped, and what the user may override.

use super::fast::Path;
use super::field::Arrangement;
use super::inertia::StepFactors;
use super::lattice::Role;
use super::limits;
use super::scene::{Scene, Test};
use super::stability::Eigenvalues;
use crate::problem::Problem;
use crate::units::shortest;
use crate::words::Choice;
use serde::{Deserialize, Serialize};

/// How exactly the check computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fidelity {
    /// Errors within 3 %.
    Quick,
    /// Errors within 1 %.
    #[default]
    Standard,
    /// Errors within 0.2 %.
    Fine,
    /// The full law in double precision, slow: what the others are compared with.
    Reference,
}

impl Choice for Fidelity {
    /// The quickest first.
    const ALL: &'static [Fidelity] =
        &[Fidelity::Quick, Fidelity::Standard, Fidelity::Fine, Fidelity::Reference];

    fn word(self) -> &'static str {
        match self {
            Fidelity::Quick => "quick",
            Fidelity::Standard => "standard",
            Fidelity::Fine => "fine",
            Fidelity::Reference => "reference",
        }
    }
}

impl Fidelity {
    /// Those that a person waits for; the reference is for comparing the others with it.
    pub(crate) const USUAL: [Fidelity; 3] = [Fidelity::Quick, Fidelity::Standard, Fidelity::Fine];

    /// The largest error it aims at, as a part: of force and deflection at the first break, and of
    /// the curve over its largest force.
    pub fn aim(self) -> f64 {
        match self {
            Fidelity::Quick => 0.03,
            Fidelity::Standard => 0.01,
            Fidelity::Fine => 0.002,
            Fidelity::Reference => 0.001,
        }
    }
}

/// Estimate over the aim above which a run says that it may miss it, and of a fine one, whose estimate is less of
/// the error: estimates are 3 to 4 times the true error in the median, and of 1800 runs (`meshcast bench --estimate`,
/// seeds 20261401 and 20261402) ten missed their aim below that.
const TRUSTED: [f64; 2] = [1.75, 1.5];
/// Power of the speed that an estimate goes with: 1.7 to 1.75 from 1.3 times the quick speed down to 0.65 of it.
pub(crate) const ESTIMATE_ORDER: f64 = 1.7;
/// Least part of its speed that a run is made again with.
const SLOWEST: f64 = 0.15;

impl Fidelity {
    /// Largest estimate of a run that keeps its aim, as far as it knows.
    fn trusted(self) -> f64 {
        TRUSTED[usize::from(self == Fidelity::Fine)] * self.aim()
    }

    /// Whether a run with this estimate keeps its aim, as far as it knows.
    pub(crate) fn keeps(self, estimate: f64) -> bool {
        estimate <= self.trusted()
    }

    /// The part of its speed at which a run with this estimate should keep its aim.
    pub(super) fn slower(self, estimate: f64) -> f64 {
        (self.trusted() / estimate).powf(1.0 / ESTIMATE_ORDER).clamp(SLOWEST, 1.0)
    }
}

/// What the caller of a check decides.
#[derive(Debug, Clone, PartialEq)]
pub struct Controls {
    /// How exactly.
    pub fidelity: Fidelity,
    /// Factor on the step over the fidelity's own; above 0. What is beyond the stability bound that
    /// [`super::stability`] computes for the scene is refused.
    pub step_factor: f64,
    /// Largest punch travel per step, m, instead of the fidelity's own; above 0.
    pub speed: Option<f64>,
    /// Part of the velocities lost in a step instead of the fidelity's own, 0 to 0.5.
    pub damping: Option<f64>,
    /// Whether a run that says that it may miss its fidelity's aim is made again, as slow as its estimate asks for.
    pub to_aim: bool,
    /// How far the run goes on after the first break, m; 0 or above.
    pub after_break: f64,
    /// Largest punch displacement, m; 0.6 L where nothing is said.
    pub limit: Option<f64>,
    /// Instruction set of the kernel, for tests; the widest the processor has where nothing is said.
    pub path: Option<Path>,
    /// Whether the outcome keeps the deformed net.
    pub keep_net: bool,
}

impl Default for Controls {
    fn default() -> Self {
        Controls {
            fidelity: Fidelity::Standard,
            step_factor: 1.0,
            speed: None,
            damping: None,
            to_aim: false,
            after_break: 0.05,
            limit: None,
            path: None,
            keep_net: false,
        }
    }
}

/// How a run is stepped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheme {
    /// Step factors.
    pub factors: StepFactors,
    /// Part of the velocities lost in a step.
    pub damping: f64,
    /// Punch travel per step, m; less near a break (see [`super::run`]).
    pub travel: f64,
    /// Whether in double precision and with the true unloading.
    pub full: bool,
    /// Whether the inertia out of the plane is fitted to the net's slopes.
    pub fitted: bool,
}

/// Step factor of the pairs' translation in single precision.
const TRANSLATION: f64 = 1.1;
/// Step factor of the twist's stretching: it costs next to nothing, so it stays well within its limit.
const STRETCHING: f64 = 0.65;

/// Largest punch displacement over the smaller side of a cell where the caller says nothing.
const LIMIT: f64 = 0.6;

impl Controls {
    /// Displacement at which a run ends at the latest, m.
    pub(super) fn limit_of(&self, scene: &Scene) -> f64 {
        self.limit.unwrap_or(LIMIT * scene.field.cell[0].min(scene.field.cell[1]))
    }

    /// How `scene` is stepped under these controls.
    ///
    /// # Errors
    /// Every control that is outside its range; a step beyond the stability bound.
    pub fn scheme(&self, scene: &Scene) -> Result<Scheme, Vec<Problem>> {
        let full = self.fidelity == Fidelity::Reference;
        let part = fitted(scene).filter(|_| !full);
        let fitted = part.is_some();
        let translation = if full { 1.0 } else { TRANSLATION };
        // Part of the velocity lost and punch travel in a step. Held all around, the laboratory's net swings less.
        let (damping, travel): (f64, f64) = match (self.fidelity, fitted, scene.spec.test) {
            (Fidelity::Quick, true, Test::Laboratory) => (0.006, 7.7e-4),
            (Fidelity::Quick, true, Test::Anchored) => (0.004, 6.0e-4),
            (Fidelity::Quick, false, _) => (0.003, 4.0e-4),
            (Fidelity::Standard, true, Test::Laboratory) => (0.005, 4.5e-4),
            (Fidelity::Standard, true, Test::Anchored) => (0.003, 3.6e-4),
            (Fidelity::Standard, false, _) => (0.002, 1.95e-4),
            (Fidelity::Fine, true, Test::Laboratory) => (0.004, 1.25e-4),
            (Fidelity::Fine, true, Test::Anchored) => (0.002, 1.0e-4),
            (Fidelity::Fine, false, _) => (0.002, 5.5e-5),
            (Fidelity::Reference, ..) => (0.000_6, 5.0e-6),
        };
        let damping = self.damping.unwrap_or(damping);
        let own = StepFactors { translation, stretching: STRETCHING };
        let bound = Eigenvalues::of_scene(scene, full, own);
        let lost = if (0.0..=0.5).contains(&damping) { damping } else { 0.0 };
        // A fidelity's own step gives way to the bound; a factor of the caller's does not.
        let bound = bound.largest_factor(lost, fitted);
        let within = bound.min(1.0);
        let scheme = Scheme {
            factors: StepFactors {
                translation: own.translation * within * self.step_factor,
                stretching: own.stretching * within * self.step_factor,
            },
            damping,
            travel: self.speed.unwrap_or(
                travel
                    * slowness(scene, full)
                    * smallness(scene, full, fitted)
                    * part.unwrap_or(1.0),
            ),
            full,
            fitted,
        };
        let mut problems = Vec::new();
        let mut range = |field: &str, value: f64, fits: bool, allowed: String| {
            if !fits {
                problems.push(
                    Problem::new(field, "the value is outside what can be run")
                        .value(shortest(value))
                        .allowed(allowed),
                );
            }
        };
        // Rounded down, so that the number that is named is one that is taken.
        let largest = (bound / within * 1e3).floor() / 1e3;
        range(
            "step_factor",
            self.step_factor,
            self.step_factor > 0.0 && self.step_factor <= largest.max(1.0),
            format!(
                "above 0, up to {} (the stability bound computed for this scene)",
                shortest(largest.max(1.0))
            ),
        );
        let v = scheme.travel;
        range("speed", v, v > 0.0 && v <= 0.002, "above 0, up to 0.002 m per step".into());
        let g = scheme.damping;
        range("damping", g, (0.0..=0.5).contains(&g), "from 0, up to 0.5 per step".into());
        let a = self.after_break;
        range("after_break", a, (0.0..=10.0).contains(&a), "from 0, up to 10 m".into());
        if let Some(l) = self.limit {
            range("limit", l, l > 0.0 && l <= 100.0, "above 0, up to 100 m".into());
        }
        if problems.is_empty() {
            let layout = &scene.spec.layout;
            let slow = match self.speed {
                Some(speed) => ("speed", speed),
                None if layout.punch < SMALL.1 => ("D", layout.punch),
                None => (layout.words()[0], layout.least()),
            };
            let steps = self.limit_of(scene) / scheme.travel;
            problems.extend(limits::of_run(&scene.lattice, steps, slow));
        }
        if problems.is_empty() { Ok(scheme) } else { Err(problems) }
    }
}

/// Distance of a block off the middle of its cell to the nearest plate, m, from which on its net is stepped as
/// that of a centred one, and the part of the speed that it then has: such nets lag behind in their own plane too.
const OFF_MIDDLE: (f64, f64) = (1.0, 0.85);

/// The part of the speed at which the inertia out of the plane is fitted to the net's slopes; nothing where it is
/// not. A net that rises from where it is flat then follows a punch that is nearly twice as fast. Where a plate is
/// near one side of a block only, the lag in the net's own plane counts, and nothing is gained, but in a field around
/// a single block: its net rises far and wide, and would hang on its own inertia.
fn fitted(scene: &Scene) -> Option<f64> {
    let layout = &scene.spec.layout;
    let field = matches!(scene.spec.arrangement, Arrangement::Single(n) if n > 1);
    let centred = layout.folded() == (0.0, 0.0) && !layout.grid.stagger;
    if scene.spec.test == Test::Laboratory || centred || field {
        return Some(1.0);
    }
    let gap = layout.distance_to_plate() - layout.punch / 2.0;
    (gap >= OFF_MIDDLE.0).then_some(OFF_MIDDLE.1)
}

/// Ratio of the stiffness that sets the inertia to the wire's mean one up to rupture, for the law and
/// the unloading of the benchmark, whose speeds the fidelities have.
const BENCH_RATIO: f64 = 2.7;
/// The same ratio under the true unloading.
const BENCH_RATIO_FULL: f64 = 34.0;

/// Factor on the punch's speed for laws that need more inertia than the benchmark's: waves are as
/// slow as the square root of that inertia, and the punch must wait for them.
fn slowness(scene: &Scene, full: bool) -> f64 {
    let curve = &scene.law.single;
    let soft = if full { curve.unloading } else { curve.steepest() };
    let (mut sum, mut count) = (0.0, 0.0);
    for number in scene.bond_numbers() {
        if super::lattice::bond_of(number).1 == Role::Twist {
            continue;
        }
        let slack = scene.slack(number);
        sum += soft.max(curve.ramp(-slack / (scene.length(Role::Left) + slack)));
        count += 1.0;
        if scene.uniform() {
            break;
        }
    }
    let strength = curve.force[curve.force.len() - 1] / curve.rupture();
    let ratio = sum / count / strength;
    (if full { BENCH_RATIO_FULL } else { BENCH_RATIO } / ratio).sqrt().min(1.0)
}

/// Side of the panel, m, and diameter of the punch, m, below which the punch is slowed down in
/// proportion: nets of small panels and under small punches break after a shorter way.
const SMALL: (f64, f64) = (2.2, 0.5);
/// Where the inertia is fitted: the diameter, and the power of that proportion.
const SMALL_FITTED: (f64, f64) = (0.65, 0.7);

/// Factor on the punch's speed for small scenes; the reference fidelity is slow enough for all.
fn smallness(scene: &Scene, full: bool, fitted: bool) -> f64 {
    let layout = &scene.spec.layout;
    let small =
        |diameter: f64| (layout.least() / SMALL.0).min(1.0) * (layout.punch / diameter).min(1.0);
    match (full, fitted) {
        (true, _) => 1.0,
        (_, true) => small(SMALL_FITTED.0).powf(SMALL_FITTED.1),
        _ => small(SMALL.1),
    }
}
