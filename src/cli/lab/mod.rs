//! Commands of the makers, see [`crate::lab`]: [`adopt`], [`mod@bench`], [`calibrate`], [`campaign`], [`mod@derive`], [`held_out`], [`reproduce`], [`validate`].

pub(crate) mod adopt;
pub(crate) mod bench;
pub(crate) mod calibrate;
pub(crate) mod campaign;
pub(crate) mod derive;
mod draw;
mod estimates;
pub(crate) mod held_out;
mod questions;
pub(crate) mod reproduce;
pub(crate) mod validate;
