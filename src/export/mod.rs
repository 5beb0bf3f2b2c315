//! What leaves the program for a desk: CSV of curves and tables, SVG pictures, and a report that a
//! reviewer can repeat. Texts in, texts out; the same inputs give the same bytes, and no file or
//! clock is touched.
//!
//! - [`mod@exported`]: a layout of a project with all that follows from it; [`check`]: a discrete element
//!   check as the pictures show it.
//! - [`csv`]: tables; [`svg`]: chart and plan; [`report`]: the report as HTML and as Markdown.
//! - [`kind`]: what the program writes at a key press, and under which name; [`form`]: the forms in which
//!   something can be written, with the endings of their files.
//! - [`command`]: the command lines that give the same numbers; [`escape`]: safe text for all these.

pub(crate) mod check;
pub(crate) mod command;
pub mod csv;
pub(crate) mod escape;
pub(crate) mod exported;
pub(crate) mod form;
pub(crate) mod kind;
pub(crate) mod report;
pub mod svg;

pub use check::{Band, Check};
pub use exported::{ExportedLayout, exported};
pub use kind::ExportKind;
pub use report::{Report, ReportSource};
