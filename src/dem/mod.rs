//! The check: a discrete element simulation of the punch test of a node-wire net.
//!
//! A reader follows one step like this:
//!
//! 1. [`scene`]: a layout, a test, a wire law, an alignment and a seed become a [`scene::Scene`]:
//!    a [`lattice`] of node pairs and bonds, a [`law`] for them, fixed nodes, and a [`dome`] to punch with.
//!    [`hash`] draws the slack.
//! 2. [`inertia`]: fictitious masses, so that the net follows the punch with as few steps as possible;
//!    [`stability`]: the largest step that the scene at hand allows.
//! 3. One step of the [`plain`] solver: `forces` (each bond: length, strain, largest strain, force by
//!    the law; each node under the dome: depth, push), then each pair's velocities and displacements,
//!    then the punch moves on. This is the definition of a step.
//! 4. The [`fast`] solver does the same in vectors, with the shortcuts that its documentation lists.
//! 5. [`run`]: drives either of them (as a [`stepper::Stepper`]) window by window to a stated end, and
//!    makes the [`outcome`]; [`account`] keeps its energies. [`fidelity`] and [`pace`] say how fast.
//!    [`bifurcation`] tells when one run means nothing.
//! 6. [`tensile`]: the other test of a net, without a punch: pulled in its plane until a bond breaks.
//!
//! Nothing here knows a file, a clock, a terminal or a thread; progress and cancelling are a callback.
//! The same inputs give the same bits whatever the processor, the build profile or the caller's threads:
//! no fused multiply-add, sums in one order, own hash, no change of the floating-point flags.
//!
//! # What is not left out
//!
//! Half or quarter panels would be a large shortcut, and are not run. They need a symmetry of net, plates
//! and punch together. The periodic net has mirror lines through its twists alone, and at most
//! alignments none of them passes the cell's corner or centre; it has half turns, about the middles of
//! wires and of twists. A half turn about the punch is one of the whole scene where the punch is centred
//! (or half a panel off), the alignment is one of a few points, such as [`PLAIN_PHASE`], and no bond has
//! a slack of its own. A random alignment is no such point and random slack has no symmetry, so no run of an
//! ensemble, which is what a user gets, could use it; scatter-free runs at the plain alignment are there
//! to compare solvers. To move the net until it has a mirror is not exact: the plates then clamp other
//! nodes, which is another net with another strength.

/// Revision of the solver. Raise it with every change after which one run of some scene gives other
/// numbers: scene, law, inertia, step, kernel, run control, fidelities, bifurcation probe. A kept check
/// carries it and is stale under another one. `tests/physics/revisions` ties it to exact results; inputs
/// that are added and leave the old ones' results alone are no reason to raise it.
pub const REVISION: u32 = 3;

mod account;
pub(crate) mod bifurcation;
pub mod dome;
pub(crate) mod estimate;
pub mod fast;
pub mod fidelity;
pub mod field;
pub mod hash;
pub mod inertia;
pub mod lattice;
pub mod law;
mod limits;
pub(crate) mod outcome;
mod pace;
pub mod plain;
pub mod run;
pub(crate) mod scene;
pub mod stability;
pub mod stepper;
pub mod tensile;

pub(crate) use fidelity::ESTIMATE_ORDER;
pub use fidelity::{Controls, Fidelity};
pub use field::Arrangement;
pub use outcome::{RunOutcome, Stop};
pub(crate) use run::RunProgress;
pub use run::{Flow, check};
pub use scene::{PLAIN_PHASE, Scene, SceneSpec, Test};
