//! Meshcast forecasts the force-deflection response of anchored wire mesh panels, after Pol &
//! Gabrieli (2021), and checks the forecast with a discrete element simulation.
//!
//! The rooms, from the ground up; a room uses only those above it in this list:
//!
//! - [`units`], [`problem`]: quantities as people write them; a bad input as a value.
//! - [`layout`], [`curve`]: the one input and the one output that forecast and check share.
//! - [`mesh`]: mesh types, their laboratory values and wires, and the catalogue.

pub mod curve;
pub mod dem;
pub mod layout;
pub mod mesh;
pub mod problem;
pub mod study;
pub mod units;
