//! Many forecasts at once: what engineers ask after the first answer. Pure computations: no input or
//! output, no clock, no screen.
//!
//! - [`case`]: one layout with its mesh and its design question, its seven inputs, what it gives.
//! - [`sensitivity`]: how the answer moves with each input.
//! - [`sweep`]: one input, or two, over a range.
//! - [`compare`]: the layouts of a project side by side, and which of them governs.
//! - [`solve`]: the plate, spacing or punch that just meets what is asked.

pub mod case;
pub mod compare;
pub mod sensitivity;
pub mod solve;
pub mod sweep;
