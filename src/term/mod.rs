//! The terminal: what it can show, its keys and signals, painting, and the loop that gives messages to
//! the program's state and carries out the effects it asks for.
//!
//! One channel, one receiver. The threads `input` and `signals` and any worker send to it; the main
//! thread waits on it and does nothing else, so neither a terminal that is gone nor a slow disk can hold
//! it up:
//!
//! ```text
//! bytes   -> decoder -> bursts -> input --+
//! signals, new size  -> signals ----------+--> channel --> update --> effects --> filing (Host: files)
//! answers            -> filing -----------+                  |           +------> keeping (recovery file)
//! troubles           -> keeping ----------+                  |           +------> workshop (checks)
//! news               -> workshop ---------+                draw --> Painter --> one write of what
//!                                                                                changed, cursor last
//! ```
//!
//! Drawing happens only when the state says it changed, and writes only the cells that differ: when
//! nothing differs, nothing is sent.

#[cfg(unix)]
mod abort;
mod bursts;
pub mod capabilities;
mod cells;
mod clipboard;
#[cfg(unix)]
mod decoder;
mod errands;
mod error;
mod events;
mod exports;
mod files;
mod filing;
mod found;
mod guard;
mod input;
mod keeping;
#[cfg(not(unix))]
mod keys;
mod painter;
mod panic;
mod pen;
mod preferences;
mod program;
mod rescue;
mod run;
mod saving;
mod session;
mod signals;
mod state;
mod travel;
mod tty;
mod waiting;
mod watch;
mod workshop;

pub use cells::Charset;
pub(crate) use error::TermError;
pub use events::Mail;
pub(crate) use files::Beginning;
pub use files::FileHost;
pub use painter::Painter;
pub(crate) use preferences::preferences;
pub use program::{Host, Program};
pub use run::Ending;
pub use session::{Session, SessionOptions};
pub(crate) use state::can_be_shown;
