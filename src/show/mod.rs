//! What results look like before they have a form: drawings of plain data (axes, cells, signs), for the
//! screen and for texts alike. Both differ in size and in the set of signs, not in code.
//!
//! - [`glyphs`]: sets of signs; [`picture`]: characters at their places, each with its [`picture::Ink`];
//! - [`grid`]: dots finer than characters; [`plot`]: axes, curves and points;
//! - [`strip`]: one line of a plot that is turned on its side;
//! - [`tornado`]: bars of a sensitivity, with their texts; [`map`]: cells of two inputs, with their signs;
//! - [`effect`]: the value that a study shows: read, in its unit, in words;
//! - [`say`]: what a case gives, in a line; [`comparison`]: the table of a comparison for people;
//! - [`columns`]: the columns of results; [`table`]: tables of them; [`layouts`]: that of a
//!   project; [`value`], [`objects`]: JSON.
//!
//! Functions from a result to rows, blocks or a grid; nothing here knows a terminal or a page.

pub(crate) mod columns;
pub(crate) mod comparison;
pub(crate) mod effect;
pub(crate) mod glyphs;
pub(crate) mod grid;
pub(crate) mod layouts;
pub(crate) mod map;
pub(crate) mod names;
pub(crate) mod objects;
pub(crate) mod picture;
pub(crate) mod plot;
pub(crate) mod say;
pub(crate) mod strip;
pub(crate) mod table;
pub(crate) mod tolerance;
pub(crate) mod tornado;
pub(crate) mod value;
pub(crate) mod verdict;
