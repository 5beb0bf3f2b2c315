//! The file a user keeps: what stands in it, how it is read, checked, changed and saved.
//!
//! - [`schema`]: a project in memory; [`check`]: whether it makes sense.
//! - [`load()`], [`parse`]: file to project; [`error`]: what is said when that fails.
//! - [`document`]: an open file; [`save`]: back to disk.
//! - [`write`]: the clean form of a file; [`patch`]: changes that keep the rest of a text.
//! - `kept`: the result of a check as the file holds it.
//! - [`wire_file`]: net and wires in a file of their own.
//! - [`recovery`]: unsaved work kept beside the file; [`home`]: the user's own place;
//!   [`settings`]: what the user decided for all projects.
//! - [`migrate`]: older formats. [`text`]: the reader below all this.

pub mod check;
pub mod decode;
pub mod document;
pub mod error;
pub mod home;
mod inline_mesh;
mod kept;
pub mod load;
pub mod migrate;
pub mod patch;
pub mod recovery;
pub mod save;
pub mod schema;
pub mod settings;
pub mod text;
pub mod wire_file;
mod words;
pub mod write;

pub use document::{Document, Opened, Rendered};
pub use error::{Cause, Fault, LoadError};
pub use home::{Home, Start};
pub use load::{load, parse};
pub use recovery::Recovery;
pub use save::{Overwrite, SaveError, SaveReport, create, same_file, write_file};
pub use schema::{CURRENT_VERSION, Display, MeshUse, NamedLayout, Project, fresh_uid};
pub use wire_file::{load_wire, wire_text};
pub use write::new_project;
