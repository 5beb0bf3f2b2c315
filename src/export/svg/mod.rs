//! Pictures for paper: SVG that prints in black and white, names no file, font or identifier outside
//! itself, and is the same to the byte for the same inputs, so that several can stand in one page.
//!
//! - [`chart()`]: force over deflection; [`plan()`]: the cell from above.
//! - [`drawing`]: the few shapes they are made of; [`marks`]: line styles and signs;
//!   [`labels`]: words that find a free place.

pub mod chart;
pub(crate) mod drawing;
mod frame;
mod labels;
mod legend;
mod marks;
mod plan;

pub use chart::{Series, chart};
pub use plan::plan;
