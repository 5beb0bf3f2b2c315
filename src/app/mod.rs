//! The state of the interactive program: what it holds, what a key does to it, undo. No input or
//! output happens here; see [`message`].

pub mod key;
pub mod look;
pub mod message;
