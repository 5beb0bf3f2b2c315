//! File to project: reads, migrates and checks, and reports all that is wrong at its place.

use super::decode;
use super::error::{Cause, FileFault, Found, LoadError};
use super::migrate;
use super::schema::{CURRENT_VERSION, Project};
use super::text::{self, Tree, parser};
use crate::problem::Problem;
use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::Path;

/// Largest project file, in bytes.
pub(crate) const LARGEST_FILE: u64 = 4 * 1024 * 1024;

/// Most faults that an error holds; it shows fewer, and counts the rest.
const MOST_FAULTS: usize = 50;

/// A text read as a project.
#[derive(Debug, Clone)]
pub(crate) struct Parsed {
    /// What it holds.
    pub(crate) project: Project,
    /// The text in the current version: the text itself, or a migrated copy.
    pub(crate) text: String,
    /// The tree of [`Parsed::text`].
    pub(crate) tree: Tree,
    /// The version of the text, where it is an older one.
    pub(crate) migrated_from: Option<u32>,
}

/// Reads a file whole, within the limit.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, LoadError> {
    let shown = path.display().to_string();
    let fail = |cause: Cause, said: &str, advice: String| {
        LoadError::new(&shown, cause, vec![FileFault::whole(said, advice)])
    };
    let io = |e: std::io::Error| match e.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => fail(
            Cause::NotFound,
            "there is no such file",
            format!("meshcast new {} makes a project there", super::error::quoted_for_shell(path)),
        ),
        ErrorKind::PermissionDenied => fail(
            Cause::Unreadable,
            "you have no permission to read this file",
            "ask its owner, or look at its mode with ls -l".to_string(),
        ),
        _ => fail(Cause::Unreadable, &format!("the file cannot be read: {e}"), String::new()),
    };
    let about = fs::metadata(path).map_err(io)?;
    if about.is_dir() {
        return Err(fail(
            Cause::BadInput,
            "this is a directory, not a project file",
            "name a file in it, such as project.ron".to_string(),
        ));
    }
    if !about.is_file() {
        return Err(fail(Cause::BadInput, "this is no ordinary file", String::new()));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(io)?;
    file.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(io)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(fail(
            Cause::BadInput,
            &format!("the file is larger than {} MiB", LARGEST_FILE / 1024 / 1024),
            "a project is a text of some kilobytes; is this the right file?".to_string(),
        ));
    }
    Ok(bytes)
}

/// Bytes to text.
pub(super) fn decode_utf8(bytes: Vec<u8>, shown: &str) -> Result<String, LoadError> {
    String::from_utf8(bytes).map_err(|e| {
        let good = e.utf8_error().valid_up_to();
        let byte = e.as_bytes().get(good).copied().unwrap_or(0);
        let before = String::from_utf8_lossy(&e.as_bytes()[..good]).into_owned();
        let (line, column) = text::line_column(&before, before.len());
        let problem = Problem::new("", "the file is not UTF-8 text")
            .value(format!("byte {byte:#04x}"))
            .advice("save it as UTF-8 in your editor");
        let fault = FileFault { line: Some(line), column: Some(column), layout: None, problem };
        LoadError::new(shown, Cause::BadInput, vec![fault])
    })
}

/// Text to project.
pub(super) fn parse_text(text: &str, shown: &str) -> Result<Parsed, LoadError> {
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        let advice = format!(
            "a project starts with (version: {CURRENT_VERSION}, name: ...; meshcast new PATH makes one"
        );
        let fault = FileFault::whole("the file is empty", advice);
        return Err(LoadError::new(shown, Cause::BadInput, vec![fault]));
    }
    let mut reading = Reading { shown, text: text.to_string(), migrated_from: None };
    let mut tree = reading.tree()?;
    let version = decode::version(&reading.text, &tree.root)
        .map_err(|found| reading.refuse(vec![found], Some(&tree)))?;
    if version < CURRENT_VERSION {
        let newer = migrate::to_current(&reading.text, &tree, version)
            .map_err(|found| reading.refuse(found, Some(&tree)))?;
        reading.text = newer;
        reading.migrated_from = Some(version);
        tree = reading.tree()?;
    }
    let project = decode::project(&reading.text, &tree.root)
        .map_err(|found| reading.refuse(found, Some(&tree)))?;
    project.check().map_err(|problems| {
        let found = |p: Problem| Found::located(&tree.root, p);
        reading.refuse(problems.into_iter().map(found).collect(), Some(&tree))
    })?;
    let Reading { text, migrated_from, .. } = reading;
    Ok(Parsed { project, text, tree, migrated_from })
}

/// A text on its way to a project.
struct Reading<'s> {
    /// The file, for messages.
    shown: &'s str,
    text: String,
    migrated_from: Option<u32>,
}

impl Reading<'_> {
    fn tree(&self) -> Result<Tree, LoadError> {
        parser::parse(&self.text).map_err(|e| self.refuse(vec![e.into()], None))
    }

    fn refuse(&self, mut found: Vec<Found>, tree: Option<&Tree>) -> LoadError {
        let newer = found.iter().any(|f| f.problem.message == decode::NEWER);
        found.sort_by_key(|f| f.at);
        let more = found.len().saturating_sub(MOST_FAULTS);
        found.truncate(MOST_FAULTS);
        let faults = found.into_iter().map(|f| {
            let mut fault = FileFault::placed(&self.text, tree, f);
            if let Some(version) = self.migrated_from {
                fault.problem = migrate::in_old_words(fault.problem, version);
            }
            fault
        });
        let cause = if newer { Cause::Newer } else { Cause::BadInput };
        LoadError { more, ..LoadError::new(self.shown, cause, faults.collect()) }
    }
}
