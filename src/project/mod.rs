//! The file a user keeps: what stands in it, how it is read, checked, changed and saved.
//!
//! - [`schema`]: a project in memory; [`check`]: whether it makes sense.
//! - [`document`]: an open file; `load`: its text to a project; [`error`]: what is said when that
//!   fails; [`save`]: back to disk.
//! - [`mod@write`]: the clean form of a file; [`patch`]: changes that keep the rest of a text.
//! - [`mod@difference`]: what differs between two projects.
//! - `kept`: the result of a check as the file holds it.
//! - [`wire_file`]: net and wires in a file of their own.
//! - [`recovery`]: unsaved work kept beside the file; [`home`]: the user's own place;
//!   [`settings`]: what the user decided for all projects.
//! - [`mod@claim`]: who holds a file; [`hold`]: a file about to be replaced; [`draft`]: what replaces it,
//!   [`disk`]: what the system knows of both; `in_time`: a disk that may not answer.
//! - [`migrate`]: older formats. `read`: from a tree to values; [`text`]: from a text to a tree.

mod check;
mod claim;
mod decode;
mod difference;
mod disk;
mod document;
mod draft;
mod error;
mod hold;
pub(crate) mod home;
mod in_time;
mod kept;
mod load;
pub(crate) mod method_files;
mod migrate;
mod own_meshes;
mod patch;
mod read;
mod recovery;
mod save;
pub mod schema;
pub(crate) mod settings;
pub mod text;
mod time;
mod wire_file;
mod words;
pub mod write;

pub(crate) use claim::claim_in_time;
pub use claim::{Claimed, Holder, claim};
pub use difference::difference;
pub(crate) use disk::FileStamp;
#[cfg(test)]
pub(crate) use disk::silent;
pub(crate) use document::{Document, load_stream};
pub use document::{Opened, load, parse};
pub use error::Cause;
pub(crate) use error::LoadError;
pub use home::Home;
pub(crate) use in_time::{MOMENT, in_time, put_away};
pub(crate) use load::{LARGEST_FILE, load_table};
pub use recovery::{OwnRecovery, Recovery};
pub use save::{Overwrite, SaveError, create};
pub(crate) use save::{SaveReport, same_file, sweep_beside, write_file};
pub use schema::{MeshUse, NamedLayout, Project};
pub(crate) use time::time_text;
pub(crate) use wire_file::load_wire;
pub use write::new_project;
pub(crate) use write::{commented, method_text};
