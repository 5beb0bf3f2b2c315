//! Commands of the makers, see [`crate::lab`]: [`mod@bench`], [`calibrate`], [`campaign`], [`validate`].

pub(crate) mod bench;
pub(crate) mod calibrate;
pub(crate) mod campaign;
pub(crate) mod validate;
