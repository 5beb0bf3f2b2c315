//! Proofs of the discrete element check: its law, its solvers, the published scenes, its shortcuts
//! and its stability. Expectations come from closed forms, from published runs of another program,
//! or from the plain solver; where a test compares with an earlier run of our own it says so.

mod attacked;
mod calibrated;
mod determinism;
mod field;
mod memory;
mod net;
mod revisions;
mod single_bond;
mod small_systems;
mod solvers;
mod stability;
mod stops;
mod tensile;
mod yade;

use meshcast::dem::{Arrangement, PLAIN_PHASE, SceneSpec, Test};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::wire::WireData;

/// A scene of the reference layout with a panel of side `spacing`.
fn spec(test: Test, spacing: f64, wire: WireData) -> SceneSpec {
    SceneSpec {
        layout: Layout { spacing, ..REFERENCE },
        test,
        wire,
        phase: PLAIN_PHASE,
        seed: 1,
        arrangement: Arrangement::default(),
    }
}

/// The scenes of the published runs: anchored on a cell of 3.04 m, laboratory on a panel of 3 m.
fn published(test: Test, wire: WireData) -> SceneSpec {
    let spacing = if test == Test::Anchored { 3.04 } else { 3.0 };
    SceneSpec { seed: 0, ..spec(test, spacing, wire) }
}

/// A small scene in no symmetric position: panel of 1.2 m, punch of 0.5 m, plates of 0.25 m.
fn small(test: Test, wire: WireData) -> SceneSpec {
    let layout = Layout { spacing: 1.2, punch: 0.5, plate: 0.25, ex: 0.05, ey: -0.03, ..REFERENCE };
    SceneSpec {
        layout,
        test,
        wire,
        phase: [0.6, 0.35],
        seed: 5,
        arrangement: Arrangement::default(),
    }
}

/// Numbers of a table with a header line; what is empty is not a number.
fn table(text: &str) -> Vec<Vec<f64>> {
    let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    text.lines().skip(1).map(|line| line.split(',').map(number).collect()).collect()
}
