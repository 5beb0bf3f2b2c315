//! The project that a text is made from, with the results of its layouts.

use super::case::unknown_layout;
use super::opening::load_project;
use super::output::Fault;
use crate::export::{ExportedLayout, exported};
use crate::project::Opened;
use clap::Args;
use std::path::PathBuf;

/// A project file on the command line.
#[derive(Debug, Clone, Args)]
pub(crate) struct ProjectFile {
    /// Project file; - for standard input.
    #[arg(value_name = "PROJECT.ron")]
    pub(crate) path: PathBuf,
}

impl ProjectFile {
    /// Opens the project and forecasts its layouts, or the one of this name.
    ///
    /// # Errors
    /// What is wrong in the file or with the name.
    pub(crate) fn open(&self, only: Option<&str>) -> Result<(Opened, Vec<ExportedLayout>), Fault> {
        let opened = load_project(&self.path)?;
        let project = &opened.project;
        let found = match only {
            None => exported(project),
            Some(name) => match project.find_layout(name) {
                Some(layout) => ExportedLayout::new(project, layout).map(|case| vec![case]),
                None => return Err(Fault::input(unknown_layout(project, name))),
            },
        };
        let all = found.map_err(|all| {
            Fault::Input(all.iter().map(std::string::ToString::to_string).collect())
        })?;
        Ok((opened, all))
    }
}
