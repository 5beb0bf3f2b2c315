//! Meshcast forecasts the force-deflection response of anchored wire mesh panels, after Pol &
//! Gabrieli (2021), and checks the forecast with a discrete element simulation.
//!
//! The rooms, from the ground up; a room uses only those above it in this list:
//!
//! - [`units`], [`problem`], [`fingerprint`]: quantities as people write them; a bad input as a
//!   value; whether two results have the same inputs.
//! - [`remark`]: how much something that a result says of itself weighs.
//! - [`words`]: words of choices; mistyped words and the known one that was meant.
//! - [`axis`]: round ticks for the axes of a chart, on the screen and on paper.
//! - [`layout`], [`curve`]: the one input and the one output that forecast and check share.
//! - [`mesh`]: mesh types, their laboratory values and wires, and the catalogue.
//! - [`method`]: what a campaign of simulations says in place of the paper's relations.
//! - [`forecast`]: the closed form: laboratory, ratios, field values, eccentricity, master curve.
//! - [`dem`]: the check: the punch test of a net of nodes and wires, step by step.
//! - [`case`]: a layout with its mesh and its question, its inputs defined once, and what follows from
//!   it.
//! - [`study`]: many forecasts or checks at once: sensitivity, sweep, comparison, design; ensembles of checks.
//! - [`lab`]: the makers' instruments: run time against error, convergence, calibration, the paper's
//!   own results.
//! - [`job`]: work behind the screen: one worker, one waiting slot, progress, cancelling.
//! - [`project`]: the file a user keeps: read, checked, changed and saved.
//! - [`show`]: what results look like before they have a form: drawings for screen and text alike.
//! - [`export`]: CSV, SVG and reports as texts; writing them to files is left to others.
//! - [`app`]: the state of the interactive program; no input or output.
//! - [`ui`]: one panel a file, each a pure function of the state.
//! - [`term`]: the terminal: what it can show, input, painting, the loop that carries out effects.
//! - [`cli`]: the command line, one subcommand a file.
//!
//! [`guide`]: how to change it, what each test proves, and the words of the house.

pub mod app;
pub mod axis;
pub mod case;
pub mod cli;
pub mod curve;
pub mod dem;
pub mod export;
pub mod fingerprint;
pub mod forecast;
pub mod job;
pub mod lab;
pub mod layout;
pub mod mesh;
mod method;
pub mod problem;
pub mod project;
pub mod remark;
mod show;
pub mod study;
pub mod term;
pub mod ui;
pub mod units;
pub mod words;

#[doc = include_str!("GUIDE.md")]
pub mod guide {}

/// Version and commit of the program, as reports and machine-readable results name them:
/// `0.1.0 (abcdef123456)`. A check that a project keeps carries revisions instead, see
/// [`study::result::Revisions`].
pub const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("MESHCAST_COMMIT"), ")");
