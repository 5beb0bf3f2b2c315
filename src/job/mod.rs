//! Work behind the screen: one worker, one waiting slot, the newest order wins; progress, cancelling,
//! a stated end.
//!
//! - [`desk`]: the worker and its slot, whatever the work is.
//! - [`order`]: what can be ordered; [`news`]: what is told of it.
//! - [`checks`]: checks of one layout or of many; [`campaign`]: the cases of a study; [`method`]: hundreds of
//!   runs and the method derived from them, as steps; [`adoption`]: a mesh adopted from its own tests, likewise;
//!   [`pace`]: how much is done and how long it takes yet.
//!
//! Whoever owns the desk gives it a function that takes the news, from the worker's threads.

pub(crate) mod adoption;
pub(crate) mod campaign;
pub(crate) mod checks;
pub(crate) mod desk;
pub(crate) mod method;
pub mod news;
pub mod order;
pub(crate) mod pace;

pub(crate) use desk::Desk;
pub use desk::Ticket;
pub use news::News;
pub use order::Order;
