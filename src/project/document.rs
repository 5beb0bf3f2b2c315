//! An open project file: its text, the project that the text holds, and what stands on disk.

use super::error::{Cause, LoadError};
use super::load::{Parsed, decode_utf8, parse_text, read_bytes};
use super::method_files;
use super::patch;
use super::patch::Rendered;
use super::schema::Project;
use super::text::Tree;
use super::write::{self, Unwritable};
use std::path::{Path, PathBuf};

/// A project just opened.
#[derive(Debug, Clone)]
pub struct Opened {
    /// The file.
    pub document: Document,
    /// The project it holds, to be edited.
    pub project: Project,
}

/// An open project file. Editing happens on a [`Project`]; the document knows how to bring the
/// edited project back into the text, and how to save it without harm.
#[derive(Debug, Clone)]
pub struct Document {
    /// Where it is saved; none for a project that stands in no file yet.
    pub(super) path: Option<PathBuf>,
    /// The text on disk when it was last read or written; none if it was not on disk.
    pub(super) on_disk: Option<String>,
    /// The text of [`Document::base`], in the current version.
    pub(super) text: String,
    /// The tree of [`Document::text`].
    pub(super) tree: Tree,
    /// The project as opened or last saved.
    pub(super) base: Project,
    /// The file's version, where it is an older one and was not saved since.
    pub(super) migrated_from: Option<u32>,
    /// Whether the file holds changes that what is edited does not know: a save asks first.
    pub(super) unseen: bool,
}

/// Opens a project file.
///
/// # Errors
/// All that is wrong, as a message that fits one screen.
pub fn load(path: &Path) -> Result<Opened, LoadError> {
    let shown = path.display().to_string();
    let bytes = read_bytes(path)?;
    let text = decode_utf8(bytes, &shown)?;
    let mut parsed = parse_text(&text, &shown)?;
    method_files::resolve(&mut parsed.project, path)?;
    Ok(Document::opened(Some(path.to_path_buf()), Some(text), parsed))
}

/// Reads a project that another program hands over; `shown` is its name for messages.
///
/// # Errors
/// All that is wrong, as a message that fits one screen.
pub(crate) fn load_stream(source: impl std::io::Read, shown: &str) -> Result<Opened, LoadError> {
    let bytes = super::load::read_stream(source, shown)?;
    parse(&decode_utf8(bytes, shown)?, shown)
}

/// Reads a project from a text that stands in no file yet; `file_name` is for messages.
///
/// # Errors
/// All that is wrong, as a message that fits one screen.
pub fn parse(text: &str, file_name: &str) -> Result<Opened, LoadError> {
    let parsed = parse_text(text, file_name)?;
    method_files::nowhere(&parsed.project, file_name)?;
    Ok(Document::opened(None, None, parsed))
}

impl Document {
    fn opened(path: Option<PathBuf>, on_disk: Option<String>, parsed: Parsed) -> Opened {
        let Parsed { project, text, tree, migrated_from } = parsed;
        let document = Document {
            path,
            on_disk,
            text,
            tree,
            base: project.clone(),
            migrated_from,
            unseen: false,
        };
        Opened { document, project }
    }

    /// Where the project is saved; none for one that stands in no file yet.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The file's name for people.
    pub(crate) fn title(&self) -> String {
        let name = self.path.as_ref().and_then(|p| p.file_name());
        name.map_or_else(|| "unnamed".to_string(), |n| n.to_string_lossy().into_owned())
    }

    /// The text of the file when it was last read or written, to the byte; none if it was not on disk.
    pub(crate) fn on_disk(&self) -> Option<&str> {
        self.on_disk.as_deref()
    }

    /// The project as opened or last saved.
    pub(crate) fn base(&self) -> &Project {
        &self.base
    }

    /// Whether a project differs from what was opened or last saved.
    pub fn is_edited(&self, project: &Project) -> bool {
        self.base != *project
    }

    /// What is edited from now on is older than the file, as edits of a lost session are: the next save
    /// asks before it replaces the file, as for any that changed on disk.
    pub(crate) fn falls_behind(&mut self) {
        self.unseen = true;
    }

    /// What the file holds now, where that is not what was last read or written.
    pub(crate) fn changed_on_disk(&self) -> bool {
        let Some(path) = &self.path else { return false };
        match (read_bytes(path), &self.on_disk) {
            (Ok(now), Some(known)) => now != known.as_bytes(),
            // Too large a file is another one too; one that has gone is made again by a save.
            (Err(error), Some(_)) => error.cause == Cause::BadInput,
            (_, None) => false,
        }
    }

    /// The version of the file on disk, where it is older than this program's and a save will
    /// bring it up to date. That alone does not make the project edited.
    pub fn migrated_from(&self) -> Option<u32> {
        self.migrated_from
    }

    /// The text of an edited project: the old one with nothing but the changes made, or the clean
    /// form where that is not possible. What was not edited comes back byte for byte.
    ///
    /// # Errors
    /// Names what cannot be written.
    pub fn render(&self, project: &Project) -> Result<Rendered, Unwritable> {
        if !self.is_edited(project) {
            return Ok(Rendered { text: self.text.clone(), comments_kept: true });
        }
        match patch::patch(&self.text, &self.tree, &self.base, project) {
            Some(rendered) if holds(&rendered.text, project) => Ok(rendered),
            _ => Ok(Rendered {
                text: write::project(project)?,
                comments_kept: self.tree.comments.is_empty(),
            }),
        }
    }
}

/// Whether a text is read as exactly this project.
pub(super) fn holds(text: &str, project: &Project) -> bool {
    parse_text(text, "").is_ok_and(|parsed| parsed.project == *project)
}
