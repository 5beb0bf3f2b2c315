//! Work behind the screen: one worker, one waiting slot, the newest order wins; progress, cancelling,
//! a stated end.
//!
//! - [`desk`]: the worker and its slot, whatever the work is.
//! - [`order`]: what can be ordered, and what is told of it.
//! - [`checks`]: checks of one layout or of many; [`campaign`]: the cases of a study; [`pace`]: how much
//!   is done and how long it takes yet.
//!
//! Whoever owns the desk gives it a function that takes the news, from the worker's threads.

pub mod campaign;
pub mod checks;
pub mod desk;
pub mod order;
pub mod pace;

pub use desk::{Desk, Ticket, Urgency};
pub use order::{News, Order};
