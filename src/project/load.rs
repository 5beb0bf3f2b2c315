//! File to project: reads, migrates and checks, and reports all that is wrong at its place.

use super::decode;
use super::disk;
use super::error::{Cause, FileFault, Found, LoadError};
use super::in_time::in_time;
use super::migrate;
use super::schema::{CURRENT_VERSION, Project};
use super::text::{self, Tree, parser};
use crate::problem::Problem;
use std::fs;
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::time::Duration;

/// Largest project file, in bytes. It bounds the time as well: the worst of this size takes some seconds.
pub(crate) const LARGEST_FILE: u64 = 4 * 1024 * 1024;
/// Largest file of the program's own, such as the settings: it is read at every start.
pub(super) const LARGEST_OWN_FILE: u64 = 64 * 1024;

/// How long a file may take to come from its disk. One that does not answer, such as a network drive that has
/// gone, would keep whoever reads it waiting without end.
const READING_TIME: Duration = Duration::from_secs(10);

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

/// Reads a project file, or another one that a user keeps, whole and within the limit.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, LoadError> {
    read_within(path, LARGEST_FILE)
}

/// The one door through which files come in, whatever they are: an ordinary file of no more than a
/// size, which its disk gives within [`READING_TIME`]. What is read as RON behind it has the limits of [`text::parser`], whoever reads it.
pub(super) fn read_within(path: &Path, largest: u64) -> Result<Vec<u8>, LoadError> {
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
    let from = path.to_path_buf();
    let Some(read) = in_time(READING_TIME, move || content(&from, largest)) else {
        return Err(fail(
            Cause::Unreadable,
            &format!("the disk has not given the file within {} s", READING_TIME.as_secs()),
            "is it on a network drive that cannot be reached?".to_string(),
        ));
    };
    match read.map_err(io)? {
        Content::Bytes(bytes) => within(bytes, largest, &shown),
        Content::Directory => Err(fail(
            Cause::BadInput,
            "this is a directory, not a file",
            "name a file in it, such as project.ron".to_string(),
        )),
        Content::Other => Err(fail(Cause::BadInput, "this is no ordinary file", String::new())),
    }
}

/// The same of a project that another program hands over.
pub(super) fn read_stream(source: impl Read, shown: &str) -> Result<Vec<u8>, LoadError> {
    let mut bytes = Vec::new();
    source.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(|e| {
        let fault = FileFault::whole(&format!("it cannot be read: {e}"), String::new());
        LoadError::new(shown, Cause::Unreadable, vec![fault])
    })?;
    within(bytes, LARGEST_FILE, shown)
}

/// What was read, where it is no larger than a size.
fn within(bytes: Vec<u8>, largest: u64, shown: &str) -> Result<Vec<u8>, LoadError> {
    if bytes.len() as u64 <= largest {
        return Ok(bytes);
    }
    let size = match largest / 1024 {
        kib if kib < 1024 => format!("{kib} KiB"),
        kib => format!("{} MiB", kib / 1024),
    };
    let fault = FileFault::whole(
        &format!("the file is larger than {size}"),
        "a project is a text of some kilobytes; is this the right file?".to_string(),
    );
    Err(LoadError::new(shown, Cause::BadInput, vec![fault]))
}

/// What is at a path.
enum Content {
    Directory,
    Other,
    /// An ordinary file's bytes, one more than the limit at most.
    Bytes(Vec<u8>),
}

fn content(path: &Path, largest: u64) -> std::io::Result<Content> {
    let about = fs::metadata(path)?;
    if about.is_dir() {
        return Ok(Content::Directory);
    }
    if !about.is_file() {
        return Ok(Content::Other);
    }
    let mut bytes = Vec::new();
    // What was an ordinary file a moment ago may be a pipe by now, which must not be waited for.
    disk::open_to_read(path)?.take(largest + 1).read_to_end(&mut bytes)?;
    Ok(Content::Bytes(bytes))
}

/// Reads a table of the user's, such as a laboratory's curve or the runs of a campaign, whole and within a
/// size in bytes.
///
/// # Errors
/// Why it cannot be read.
pub(crate) fn load_table(path: &Path, largest: u64) -> Result<Vec<u8>, LoadError> {
    read_within(path, largest).map_err(|mut error| {
        // The advice of a project file leads nowhere here.
        for fault in &mut error.faults {
            fault.problem.advice.clear();
        }
        error
    })
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

#[cfg(test)]
mod tests {
    use super::super::home::Home;
    use super::super::settings::KnownSettings;
    use super::super::{Document, document, load_wire};
    use super::*;
    use std::path::PathBuf;
    use std::thread;

    /// Makes something that is no good file at a path.
    type Bad = (&'static str, fn(&Path));

    const BAD: &[Bad] = &[
        ("deep", |path| fs::write(path, "{".repeat(20_000)).unwrap()),
        ("large", |path| fs::write(path, vec![b' '; LARGEST_FILE as usize + 1]).unwrap()),
        ("no text", |path| fs::write(path, b"\xff\0(").unwrap()),
        ("a directory", |path| fs::create_dir(path).unwrap()),
        #[cfg(unix)]
        ("a pipe", |path| {
            use rustix::fs::{CWD, FileType, Mode, mknodat};
            mknodat(CWD, path, FileType::Fifo, Mode::RUSR | Mode::WUSR, 0).unwrap();
        }),
    ];

    fn good(dir: &Path) -> (PathBuf, Document) {
        let path = dir.join("p.ron");
        fs::write(&path, super::super::new_project("P")).unwrap();
        let document = document::load(&path).unwrap().document;
        (path, document)
    }

    /// The files that are read, and what must not come of a bad one. A pipe must not be waited for.
    #[test]
    fn every_file_comes_in_by_the_same_door() {
        for (what, make) in BAD {
            let dir = tempfile::tempdir().unwrap();
            let home = Home::at(Some(dir.path().join("data")));
            fs::create_dir(dir.path().join("data")).unwrap();
            let bad = |name: &str| {
                let path = dir.path().join(name);
                make(&path);
                path
            };
            assert!(document::load(&bad("project.ron")).is_err(), "{what}");
            assert!(load_wire(&bad("wire.ron")).is_err(), "{what}");
            let (path, document) = good(dir.path());
            bad(".p.ron.recovery");
            let kept = document.find_recovery(&home);
            assert!(kept.is_none_or(|kept| document.recover(&kept).is_err()), "{what}");
            bad(".p.ron.lock");
            assert!(super::super::claim(&path, &home, false).holder().is_none(), "{what}");
            bad("data/state.ron");
            assert!(home.recent().is_empty(), "{what}");
            assert!(home.start_project().unwrap().note.is_some(), "{what}");
            bad("data/settings.ron");
            let known: &[KnownSettings] = &[];
            assert!(home.settings(known).is_err(), "{what}");
        }
    }

    /// Seen: a start waited without end for a project on a network drive that had gone. A pipe that nobody
    /// writes to is such a disk, for whoever opens it as one opens a file.
    #[cfg(unix)]
    #[test]
    fn a_disk_that_does_not_answer_is_not_waited_for() {
        let dir = tempfile::tempdir().unwrap();
        let (_, pipe) = BAD.iter().find(|(what, _)| *what == "a pipe").unwrap();
        let path = dir.path().join("p.ron");
        pipe(&path);
        let theirs = path.clone();
        let short = Duration::from_millis(50);
        assert!(in_time(short, move || fs::read(&theirs).unwrap()).is_none());
        // One that answers is heard, be it late: its writer comes after a while. The thread that was left
        // still waits at the other pipe.
        let path = dir.path().join("late.ron");
        pipe(&path);
        let theirs = path.clone();
        thread::spawn(move || {
            thread::sleep(short);
            fs::write(theirs, "text").unwrap();
        });
        let long = Duration::from_secs(60);
        assert_eq!(in_time(long, move || fs::read(&path).unwrap()).as_deref(), Some(&b"text"[..]));
    }

    #[test]
    fn files_of_the_programs_own_are_small() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().to_path_buf()));
        let many = "\"/a/b.ron\", ".repeat(20_000);
        fs::write(dir.path().join("state.ron"), format!("(recent: [{many}])")).unwrap();
        let note = home.start_project().unwrap().note.unwrap();
        assert!(note.contains("larger than 64 KiB"), "{note}");
        // The next project that is opened makes it anew.
        assert!(home.remember(Path::new("/c/d.ron")).unwrap());
        assert_eq!(home.recent(), [PathBuf::from("/c/d.ron")]);
    }
}
