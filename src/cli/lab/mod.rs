//! Commands of the makers, see [`crate::lab`]: [`mod@bench`], [`calibrate`], [`validate`].

pub(crate) mod bench;
pub(crate) mod calibrate;
pub(crate) mod validate;
