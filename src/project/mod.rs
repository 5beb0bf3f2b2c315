//! The file a user keeps: what stands in it, how it is read, checked, changed and saved.
//!
//! - [`schema`]: a project in memory; [`check`]: whether it makes sense.
//! - [`document`]: an open file; `load`: its text to a project; [`error`]: what is said when that
//!   fails; [`save`]: back to disk.
//! - [`mod@write`]: the clean form of a file; [`patch`]: changes that keep the rest of a text.
//! - `kept`: the result of a check as the file holds it.
//! - [`wire_file`]: net and wires in a file of their own.
//! - [`recovery`]: unsaved work kept beside the file; [`home`]: the user's own place;
//!   [`settings`]: what the user decided for all projects.
//! - [`migrate`]: older formats. `read`: from a tree to values; [`text`]: from a text to a tree.

mod check;
mod decode;
mod document;
mod error;
pub(crate) mod home;
mod kept;
mod load;
mod migrate;
mod patch;
mod read;
mod recovery;
mod save;
pub mod schema;
pub(crate) mod settings;
pub mod text;
mod wire_file;
mod words;
pub mod write;

pub(crate) use document::Document;
pub use document::{Opened, load, parse};
pub use error::Cause;
pub(crate) use error::LoadError;
pub use home::Home;
pub use save::{Overwrite, SaveError, create};
pub(crate) use save::{SaveReport, same_file, write_file};
pub use schema::{MeshUse, NamedLayout, Project};
pub(crate) use wire_file::{load_wire, wire_text};
pub use write::new_project;
