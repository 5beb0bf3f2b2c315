//! How a command comes by the project that it is named.

use crate::project::{LoadError, Opened, load, load_stream};
use std::path::Path;

/// Reads the project of a command: a file, or `-` for standard input.
///
/// # Errors
/// What is wrong in it.
pub(crate) fn load_project(path: &Path) -> Result<Opened, LoadError> {
    match path.as_os_str() == "-" {
        true => load_stream(std::io::stdin().lock(), "standard input"),
        false => load(path),
    }
}
