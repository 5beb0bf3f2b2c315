//! Many forecasts or checks at once.
//!
//! Over forecasts, what engineers ask after the first answer; pure computations:
//!
//! - [`sensitivity`]: how the answer moves with each input; [`sweep`]: one input, or two, over a range.
//! - [`compare`]: the layouts of a project side by side, and which of them governs.
//! - [`verdict`]: whether a layout is enough, by force, deflection and anchor; [`mend`]: what would help.
//! - [`solve`]: the plate, spacing or punch that just meets what is asked.
//!
//! Over checks, with the clocks and threads that the `dem` room knows nothing of:
//!
//! - [`clock`]: processor time and time on the wall.
//! - [`ensemble`]: the same scene over alignments and seeds, for mean and band; [`sampling`]: where its
//!   runs stand, and what that makes of mean and error; [`inputs`]: the fingerprint of what one was made
//!   from.
//! - [`exactness`]: how exactly the runs of an ensemble compute.
//! - [`paired`]: quick runs with their [`bias`] taken out, for ensembles that choose their fidelity.
//! - [`blocks`]: the ensembles of the arrangements in which a layout's blocks may stand.
//! - [`remark`]: what a check has to say of itself.
//! - [`result`]: what a check leaves behind, and how one is made of a layout.
//! - [`checks`]: many cases checked with the same seeds, for [`sensitivity::dem`], [`sweep::dem`] and
//!   comparison.

pub(crate) mod bias;
pub(crate) mod blocks;
pub mod checks;
pub mod clock;
pub(crate) mod compare;
pub(crate) mod ensemble;
pub mod exactness;
pub(crate) mod inputs;
pub mod mend;
pub(crate) mod paired;
pub mod remark;
pub mod result;
pub(crate) mod sampling;
pub mod sensitivity;
pub mod solve;
pub mod sweep;
pub(crate) mod tolerance;
pub mod verdict;
