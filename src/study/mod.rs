//! Many checks at once, with clocks and threads: what the `dem` room knows nothing of.
//!
//! - [`clock`]: processor time and time on the wall.
//! - [`ensemble`]: the same scene over random alignments and seeds, for mean and band; [`inputs`]:
//!   the fingerprint of what one was made from; [`record`]: one as JSON.
//! - [`bench`]: run time against error on the bench scenes; [`convergence`]: error against each knob.
//! - [`calibrate`]: a wire law that reproduces a mesh's punch test.
//! - [`paper`]: the paper's own results beside ensembles of ours, and [`published`].

pub mod bench;
pub mod calibrate;
pub mod clock;
pub mod convergence;
pub mod ensemble;
pub mod inputs;
pub mod paper;
pub mod published;
pub mod record;
