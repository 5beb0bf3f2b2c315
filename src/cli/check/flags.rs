//! What may be asked of a check on the command line.

use crate::cli::case::Geometry;
use crate::cli::choice::one_of;
use crate::cli::input_flags::InputFlags;
use crate::cli::output::{Fault, TableFormat};
use crate::cli::quantity;
use crate::cli::verdict::VerdictFlags;
use crate::dem::fast::Path as Instructions;
use crate::dem::tensile::Pull;
use crate::dem::{Controls, Test};
use crate::study::ensemble::Plan;
use crate::study::exactness::Exactness;
use crate::words::Choice;
use clap::Args;
use std::num::NonZeroUsize;
use std::path::PathBuf;

const AFTER_HELP: &str = "\
Runs: each has its own alignment of the net with anchors and punch and its own slack of the wires,
because one alignment alone can be 25 % off. Alignments are not drawn at random but placed: so many runs
for each pattern of nodes that the plates can catch. Without --runs there are 4 to 64, as many as a
standard error of the force of 1 % takes. One plain run: --runs 1 --phase 0.25,0.125

Mesh file: net and wires of a mesh, RON, lengths in m, mass in kg, stresses in MPa:
  (
      net: (opening: 0.08, twist: 0.04, projection: 0.04, diameter: 0.0027,
            node_mass: 0.0039, node_radius: 0.0108),
      single: [(0.002, 250.0), (0.14, 566.0)],        // (strain, stress), (0, 0) is implied
      double_twist: [(0.0013, 168.0), (0.058, 379.0)],  // on twice the wire's area
      distortion: (lambda_u: 0.03, lambda_f: 1.0, slack: Triangular), // or Fixed(0.5); optional
      source: \"where the values come from\",
  )
projects/wire/dt-8x10-2.7.ron is one; `meshcast calibrate --out FILE.ron` makes one.

Ctrl+C ends with the runs made so far, exit code 130.";

/// Check a forecast by discrete elements: the punch test of the net, wire by wire.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct CheckArgs {
    /// Project file; without it, one layout from the flags below.
    #[arg(value_name = "PROJECT.ron")]
    pub(super) project: Option<PathBuf>,
    /// Only the layout of this name.
    #[arg(long, value_name = "NAME", requires = "project", allow_hyphen_values = true)]
    pub(super) layout: Option<String>,
    #[command(flatten)]
    pub(super) geometry: Geometry,
    #[command(flatten)]
    pub(super) question: InputFlags<true>,
    #[command(flatten)]
    pub(super) verdict: VerdictFlags,
    /// Which punch test: the periodic cell held by plates, or the panel held along its edges.
    #[arg(long, value_name = "TEST", default_value = "anchored", value_parser = one_of(Test::ALL), help_heading = "Test")]
    pub(super) test: Test,
    /// Pulls a piece of the net instead until it breaks, along or across its twists: strength and elongation.
    #[arg(long, value_name = "WAY", value_parser = one_of(Pull::ALL), conflicts_with_all = ["project", "test"], help_heading = "Test")]
    pub(super) pull: Option<Pull>,
    /// Width and length of the piece of --pull.
    #[arg(long, value_name = "WIDTH,LENGTH", value_parser = quantity::sides, default_value = "1,1", requires = "pull", help_heading = "Test")]
    pub(super) piece: quantity::Sides,
    /// Net and wires instead of the mesh's own, see below.
    #[arg(long, value_name = "FILE", help_heading = "Test")]
    pub(super) mesh_file: Option<PathBuf>,
    /// Tensile curves and slack on the mesh's net: bench, yade, reference or those of a mesh file.
    #[arg(long, value_name = "LAW", help_heading = "Test")]
    pub(super) law: Option<String>,
    /// Number of runs [default: 4 to 64, as many as needed].
    #[arg(long, value_name = "N", value_parser = runs, help_heading = "Runs")]
    runs: Option<usize>,
    /// Seed of alignments and slack.
    #[arg(long, value_name = "S", default_value_t = 0, help_heading = "Runs")]
    seed: u64,
    /// Alignment of all runs, each part from 0, below 1, or one of its own for each.
    #[arg(long, value_name = "X,Y|random", default_value = "random", value_parser = phase, help_heading = "Runs")]
    phase: Phase,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N", help_heading = "Runs")]
    threads: Option<NonZeroUsize>,
    /// Aim: errors of a run within 3 % (quick), 1 % (standard), 0.2 % (fine), or the reference itself; auto:
    /// quick runs, as slow as it takes for a mean known to 1 %; one or two runs, and runs of a given alignment,
    /// speed, damping or --to-aim, are standard ones.
    #[arg(long, value_name = "FIDELITY", default_value = Exactness::default().word(), value_parser = one_of(Exactness::ALL), help_heading = "Accuracy")]
    fidelity: Exactness,
    /// Factor on the time step; what is beyond the stability bound is refused.
    #[arg(long, value_name = "X", default_value_t = 1.0, value_parser = quantity::number, allow_hyphen_values = true, help_heading = "Accuracy")]
    step_factor: f64,
    /// Largest punch travel in a step, m [default: by the fidelity].
    #[arg(long, value_name = "X", value_parser = quantity::number, allow_hyphen_values = true, help_heading = "Accuracy")]
    speed: Option<f64>,
    /// Part of the velocities lost in a step, 0 to 0.5 [default: by the fidelity].
    #[arg(long, value_name = "X", value_parser = quantity::number, allow_hyphen_values = true, help_heading = "Accuracy")]
    damping: Option<f64>,
    /// A run whose own estimate says that it may miss its fidelity's aim is made again, slower.
    #[arg(long, help_heading = "Accuracy")]
    to_aim: bool,
    /// How far a run goes on after its first break.
    #[arg(long, value_name = "M", default_value = "0.05", value_parser = quantity::distance, allow_hyphen_values = true, help_heading = "Accuracy")]
    after_break: f64,
    /// Largest punch displacement [default: 0.6 L].
    #[arg(long, value_name = "M", value_parser = quantity::length, allow_hyphen_values = true, help_heading = "Accuracy")]
    limit: Option<f64>,
    /// Instruction set of the kernel, for tests: avx512, avx2, sse2 or portable.
    #[arg(long, value_name = "SET", hide = true, value_parser = Instructions::WORDS)]
    instructions: Option<String>,
    /// How the result is written: JSON in SI with kN; CSV holds the curves.
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
}

/// Alignment of the runs.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Phase {
    Random,
    Fixed([f64; 2]),
}

impl CheckArgs {
    /// How the runs are drawn.
    pub(super) fn plan(&self) -> Plan {
        Plan {
            runs: self.runs,
            seed: self.seed,
            phase: match self.phase {
                Phase::Random => None,
                Phase::Fixed(phase) => Some(phase),
            },
            auto: self.fidelity == Exactness::Auto,
            threads: threads(self.threads),
        }
    }

    /// How they are stepped.
    ///
    /// # Errors
    /// An instruction set that this processor does not have.
    pub(super) fn controls(&self) -> Result<Controls, Fault> {
        let path = self.instructions.as_deref().map(|word| {
            Instructions::from_word(word).ok_or_else(|| {
                Fault::input("--instructions: this processor does not have that set")
            })
        });
        Ok(Controls {
            fidelity: self.fidelity.fidelity(),
            step_factor: self.step_factor,
            speed: self.speed,
            damping: self.damping,
            to_aim: self.to_aim,
            after_break: self.after_break,
            limit: self.limit,
            path: path.transpose()?,
            keep_net: false,
        })
    }
}

/// The number of threads asked for, or that of the machine.
pub(in crate::cli) fn threads(asked: Option<NonZeroUsize>) -> usize {
    asked.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
}

/// The flags of what stands in a check's controls, by the names of their fields.
pub(super) const CONTROL_FLAGS: &[(&str, &str)] = &[
    ("step_factor", "--step-factor"),
    ("speed", "--speed"),
    ("damping", "--damping"),
    ("after_break", "--after-break"),
    ("limit", "--limit"),
    ("phase.x", "--phase"),
    ("phase.y", "--phase"),
];

/// A number of runs.
pub(in crate::cli) fn runs(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(n) if (1..=10_000).contains(&n) => Ok(n),
        _ => Err("this is no number of runs; allowed: 1 to 10000".into()),
    }
}

fn phase(text: &str) -> Result<Phase, String> {
    if text.trim() == "random" {
        return Ok(Phase::Random);
    }
    let parts: Vec<Option<f64>> = text.split(',').map(|p| p.trim().parse().ok()).collect();
    match parts.as_slice() {
        [Some(x), Some(y)] if [x, y].iter().all(|p| (0.0..1.0).contains(*p)) => {
            Ok(Phase::Fixed([*x, *y]))
        }
        _ => {
            Err("allowed: random, or two parts of a period from 0, below 1, such as 0.25,0.125"
                .into())
        }
    }
}
