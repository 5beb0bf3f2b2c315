//! The check: a discrete element simulation of the punch test of a node-wire net.
//!
//! A reader follows one step like this:
//!
//! 1. [`scene`]: a layout, a test, a wire law, an alignment and a seed become a [`scene::Scene`]:
//!    a [`lattice`] of node pairs and bonds, a [`law`] for them, fixed nodes, and a [`dome`] to punch with.
//!    [`hash`] draws the slack.
//! 2. [`inertia`]: fictitious masses, so that the net follows the punch with as few steps as possible.
//! 3. One step of the [`plain`] solver: `forces` (each bond: length, strain, largest strain, force by
//!    the law; each node under the dome: depth, push), then each pair's velocities and displacements,
//!    then the punch moves on. This is the definition of a step.
//! 4. The [`fast`] solver does the same in vectors, with the shortcuts that its documentation lists.
//! 5. [`run`]: drives either of them (as a [`stepper::Stepper`]) window by window to a stated end, and
//!    makes the [`outcome`]. [`fidelity`] says how fast. [`bifurcation`] tells when one run means nothing.
//!
//! Nothing here knows a file, a clock, a terminal or a thread; progress and cancelling are a callback.
//! The same inputs give the same bits whatever the processor, the build profile or the caller's threads:
//! no fused multiply-add, sums in one order, own hash, no change of the floating-point flags.

pub mod bifurcation;
pub mod dome;
pub mod fast;
pub mod fidelity;
pub mod hash;
pub mod inertia;
pub mod lattice;
pub mod law;
pub mod outcome;
pub mod plain;
pub mod run;
pub mod scene;
pub mod stability;
pub mod stepper;

pub use fidelity::{Controls, Fidelity};
pub use outcome::{Outcome, Stop};
pub use run::{Flow, Progress, check};
pub use scene::{PLAIN_PHASE, Scene, SceneSpec, Test};
