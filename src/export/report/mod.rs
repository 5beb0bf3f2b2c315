//! The report: a project, how its numbers come about, and what to distrust, such that a reviewer can
//! repeat every number.
//!
//! - [`document`]: the report without a form; [`html`], [`markdown`]: its two forms.
//! - `front`: project, results, meshes, limits; `method`: the equations; `layout`: one layout.

pub(crate) mod document;
mod front;
pub(crate) mod html;
mod layout;
pub(crate) mod markdown;
mod method;

use super::{Check, ExportedLayout};
use crate::project::Project;
use crate::units::Units;
use document::{Block, ReportDocument};

/// Where a project comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReportSource<'a> {
    /// Name of the file without its directory; empty for a project that stands in no file.
    pub file_name: &'a str,
    /// The text of the file to the byte; nothing for a project that stands in no file.
    pub text: Option<&'a str>,
    /// Whether the project has edits that are not in that text.
    pub edited: bool,
}

/// All that a report is made from.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The project as it stands, with edits that are not saved.
    pub project: &'a Project,
    /// Its layouts with their results, see [`super::exported()`].
    pub cases: &'a [ExportedLayout],
    /// The checks of the layouts in the same order; shorter or empty where there are none.
    pub checks: &'a [Option<Check>],
    /// Where the project comes from.
    pub source: ReportSource<'a>,
    /// The unit of lengths.
    pub unit: Units,
    /// Whether it is the short form: the first page, then one page a layout.
    pub short: bool,
}

impl Report<'_> {
    /// The report as one HTML page with its pictures inside.
    pub fn html(&self) -> String {
        html::page(&self.document())
    }

    /// The report as one Markdown text; its pictures stand at its end as data.
    pub fn markdown(&self) -> String {
        markdown::text(&self.document())
    }

    /// The report without a form.
    pub(crate) fn document(&self) -> ReportDocument {
        let mut document = ReportDocument {
            title: format!("{}: anchored wire mesh, forecast", self.project.name),
            short: self.short,
            blocks: Vec::new(),
        };
        front::project(self, &mut document);
        front::verdicts(self, &mut document);
        if self.short {
            method::limits(&mut document);
            for (index, case) in self.cases.iter().enumerate() {
                document.blocks.push(Block::NewPage);
                layout::short(self, index, case, &mut document);
            }
            return document;
        }
        front::results(self, &mut document);
        method::limits(&mut document);
        front::inputs(self, &mut document);
        front::meshes(self, &mut document);
        method::equations(&mut document);
        method::derived(self.cases, &self.project.method_files, &mut document);
        if !self.cases.is_empty() {
            document.chapter("Layouts, step by step");
        }
        for (index, case) in self.cases.iter().enumerate() {
            layout::layout(self, index, case, &mut document);
        }
        front::repeat(self, &mut document);
        document
    }

    fn check(&self, index: usize) -> Option<&Check> {
        self.checks.get(index).and_then(Option::as_ref)
    }
}
