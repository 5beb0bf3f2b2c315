//! Pictures for paper: SVG that prints in black and white, names no file, font or identifier outside
//! itself, and is the same to the byte for the same inputs, so that several can stand in one page.
//!
//! - [`chart()`]: force over deflection; [`plan()`]: the cell from above.
//! - [`mod@plot`]: lines over any two axes; [`contour`]: lines of equal value.
//! - [`drawing`]: the few shapes they are made of; [`marks`]: line styles and signs;
//!   [`labels`]: words that find a free place.

pub mod chart;
pub(crate) mod contour;
pub(crate) mod drawing;
pub(crate) mod frame;
pub(crate) mod labels;
pub(crate) mod legend;
pub(crate) mod marks;
mod plan;
pub(crate) mod plot;

pub use chart::{Series, chart};
pub use plan::plan;
