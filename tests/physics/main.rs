//! Proofs of the discrete element check: the law of one bond, small systems with closed-form
//! answers, the net that a scene is made of, the published runs of another program, and the same
//! bits whatever the processor. Expectations come from closed forms, from `tests/data` (published
//! runs made with YADE 2023.02a) or from the plain solver; the one that compares with an earlier
//! run of our own says so.

mod determinism;
mod net;
mod single_bond;
mod small_systems;
mod yade;

use meshcast::dem::{PLAIN_PHASE, SceneSpec, Test};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::wire::WireData;

/// The scenes of the published runs: anchored on a cell of 3.04 m, laboratory on a panel of 3 m.
fn published(test: Test, wire: WireData) -> SceneSpec {
    let spacing = if test == Test::Anchored { 3.04 } else { 3.0 };
    let layout = Layout { spacing, ..REFERENCE };
    SceneSpec { layout, test, wire, phase: PLAIN_PHASE, seed: 0 }
}

/// A small scene in no symmetric position, so that nothing cancels by symmetry.
fn small(test: Test, wire: WireData) -> SceneSpec {
    let layout = Layout { spacing: 1.2, punch: 0.5, plate: 0.25, ex: 0.05, ey: -0.03 };
    SceneSpec { layout, test, wire, phase: [0.6, 0.35], seed: 5 }
}

/// Numbers of a table with a header line; what is empty is not a number.
fn table(text: &str) -> Vec<Vec<f64>> {
    let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    text.lines().skip(1).map(|line| line.split(',').map(number).collect()).collect()
}
