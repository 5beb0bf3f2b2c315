//! The makers' instruments: how good the check is, and where its wires come from. Nothing that an
//! engineer's answer needs.
//!
//! - [`adopt`]: a mesh from its own tests to a method of forecasts of its own.
//! - [`mod@bench`]: run time against error on the bench scenes; [`convergence`]: error against each knob,
//!   and cost against size.
//! - [`estimates`]: a run's own error estimate against its true error, on scenes drawn by a seed.
//! - [`arrangements`]: how the answer depends on how the blocks stand.
//! - [`campaign`]: many single runs of random layouts, from which a method is derived.
//! - [`mod@derive`]: a method of forecasts made of such runs.
//! - [`calibrate`]: a wire law that reproduces a mesh's punch test.
//! - [`held_out`]: forecasts against checks of layouts that no fit has seen.
//! - [`fit`]: a wire law fitted to many figures at once; the wires of the reference mesh.
//! - [`questions`]: time and error of whole checks, and what quick runs leave out.
//! - [`statements`]: what others say of single blocks.
//! - [`reproduce`]: the paper's figures and tables from our simulations.
//! - [`paper`]: the paper's own results beside ensembles of ours.

pub(crate) mod adopt;
pub(crate) mod arrangements;
pub mod bench;
pub mod calibrate;
pub(crate) mod campaign;
pub(crate) mod convergence;
pub(crate) mod derive;
pub(crate) mod estimates;
pub mod fit;
pub(crate) mod held_out;
pub(crate) mod paper;
pub(crate) mod questions;
pub(crate) mod reproduce;
pub(crate) mod statements;
