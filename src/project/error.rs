//! What is said when a file cannot be opened: one screen, whatever is wrong with the file.

use super::text::parser::SyntaxError;
use super::text::{Node, Tree, line_column};
use crate::problem::Problem;
use crate::words::shown;
use std::fmt;
use std::path::Path;
use unicode_width::UnicodeWidthChar;

/// Widest line of a message, in columns.
const WIDEST: usize = 78;
/// Most lines of a message; the screen has 24 and the shell wants some.
const MOST_LINES: usize = 15;

/// Why a file cannot be opened, in kinds that a caller treats differently.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// There is no such file.
    NotFound,
    /// The file cannot be read: permission or a failing disk.
    Unreadable,
    /// The file was written by a newer version of the program.
    Newer,
    /// The file's content is wrong.
    BadInput,
}

/// A problem and the byte where it stands.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Found {
    /// The byte where it stands, if it has a place.
    pub at: Option<usize>,
    /// What is wrong, by its path in the file.
    pub problem: Box<Problem>,
}

impl Found {
    /// A problem at a place.
    pub(crate) fn new(at: usize, problem: Problem) -> Self {
        Found { at: Some(at), problem: Box::new(problem) }
    }

    /// A problem at the place that its field leads to.
    pub(crate) fn located(root: &Node, problem: Problem) -> Self {
        Found::new(root.locate(&problem.field).start, problem)
    }
}

impl From<SyntaxError> for Found {
    fn from(error: SyntaxError) -> Self {
        Found { at: Some(error.at), problem: error.problem }
    }
}

/// One thing wrong with a file, at its place.
#[derive(Debug, Clone, PartialEq)]
pub struct FileFault {
    /// Line, from 1, where there is one.
    pub(crate) line: Option<usize>,
    /// Column, from 1, in characters.
    pub(crate) column: Option<usize>,
    /// Name of the layout it is in.
    pub(crate) layout: Option<String>,
    /// What is wrong, by its path in the file.
    pub(crate) problem: Problem,
}

impl FileFault {
    /// Something wrong with the file as a whole.
    pub(super) fn whole(said: &str, advice: String) -> Self {
        let problem = Problem::new("", said).advice(advice);
        FileFault { line: None, column: None, layout: None, problem }
    }

    /// A problem at its place in a text.
    pub(super) fn placed(text: &str, tree: Option<&Tree>, found: Found) -> Self {
        let place = found.at.map(|at| line_column(text, at));
        let layout = tree.and_then(|tree| {
            let index = found.problem.field.strip_prefix("layouts[")?.split_once(']')?.0;
            let item = tree.root.field("layouts")?.value.unwrapped();
            let item = item.items()?.get(index.parse::<usize>().ok()?)?;
            match &item.value.unwrapped().field("name")?.value.kind {
                super::text::NodeKind::Text(name) => Some(super::words::shorten(name)),
                _ => None,
            }
        });
        FileFault {
            line: place.map(|p| p.0),
            column: place.map(|p| p.1),
            layout: layout.filter(|name| !name.is_empty()),
            problem: *found.problem,
        }
    }
}

/// Why a file cannot be opened. `Display` fits one screen of 80 by 24.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadError {
    /// The file, as it was named.
    pub file: String,
    /// The kind of trouble.
    pub cause: Cause,
    /// What is wrong, in the order of the file; never empty.
    pub faults: Vec<FileFault>,
    /// How many more faults there are.
    pub more: usize,
}

impl LoadError {
    pub(super) fn new(file: &str, cause: Cause, mut faults: Vec<FileFault>) -> Self {
        faults.sort_by_key(|f| (f.line, f.column));
        LoadError { file: file.to_string(), cause, faults, more: 0 }
    }

    /// Whether the trouble lies in what the user gave and not in the machine: exit code 2, not 1.
    pub fn is_bad_input(&self) -> bool {
        self.cause != Cause::Unreadable
    }

    /// The lines of one fault.
    fn lines(fault: &FileFault) -> Vec<String> {
        let p = &fault.problem;
        let mut lines = Vec::new();
        let mut head = match (fault.line, fault.column) {
            (Some(line), Some(column)) => format!("line {line}, column {column}"),
            (Some(line), None) => format!("line {line}"),
            _ => String::new(),
        };
        if !p.field.is_empty() {
            head.push_str(if head.is_empty() { "" } else { ": " });
            head.push_str(&p.field);
        }
        if !p.value.is_empty() {
            head.push_str(if p.field.is_empty() { ": " } else { " = " });
            head.push_str(&p.value);
        }
        if let Some(layout) = &fault.layout {
            head.push_str(&format!(" (layout {layout:?})"));
        }
        let mut indent = "  ";
        if !head.is_empty() {
            wrap(&head, indent, &mut lines);
            indent = "    ";
        }
        wrap(&p.message, indent, &mut lines);
        if !p.allowed.is_empty() {
            wrap(&format!("allowed: {}", p.allowed), indent, &mut lines);
        }
        if !p.advice.is_empty() {
            wrap(&p.advice, indent, &mut lines);
        }
        lines
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut head = Vec::new();
        let count = match self.faults.len() + self.more {
            0 | 1 => String::new(),
            n => format!(": {n} problems"),
        };
        wrap(&format!("{} cannot be opened{count}", middle_cut(&self.file)), "", &mut head);
        let mut lines = head;
        let mut told = 0;
        for fault in &self.faults {
            let mut more = LoadError::lines(fault);
            // Room for the closing line, unless this is the last fault.
            let spare = usize::from(told + 1 < self.faults.len() || self.more > 0);
            if lines.len() + more.len() + spare > MOST_LINES {
                if told > 0 {
                    break;
                }
                more.truncate(MOST_LINES - lines.len() - spare);
            }
            lines.extend(more);
            told += 1;
        }
        let left = self.faults.len() - told + self.more;
        if left > 0 {
            let s = if left == 1 { "" } else { "s" };
            lines.push(format!("  and {left} more problem{s} further down"));
        }
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for LoadError {}

/// A path as a shell takes it.
pub(super) fn quoted_for_shell(path: &Path) -> String {
    let text = path.display().to_string();
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '/' | '.' | '-' | '_' | '+' | '~');
    if !text.is_empty() && text.chars().all(plain) {
        text
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}

/// A long path without its middle.
fn middle_cut(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() <= 120 {
        return text.to_string();
    }
    let start: String = letters[..40].iter().collect();
    let end: String = letters[letters.len() - 75..].iter().collect();
    format!("{start}...{end}")
}

/// Breaks a text into lines of at most [`WIDEST`] columns, without characters that cannot be shown.
fn wrap(text: &str, indent: &str, lines: &mut Vec<String>) {
    let clean: String = text.chars().map(|c| if shown(c) { c } else { ' ' }).collect();
    let mut line = indent.to_string();
    let mut width = indent.len();
    let wide = |c: char| c.width().unwrap_or(0);
    for word in clean.split(' ').filter(|w| !w.is_empty()) {
        let size: usize = word.chars().map(wide).sum();
        let gap = usize::from(width > indent.len());
        if width + gap + size > WIDEST && width > indent.len() {
            lines.push(std::mem::replace(&mut line, indent.to_string()));
            width = indent.len();
        } else if gap == 1 {
            line.push(' ');
            width += 1;
        }
        for c in word.chars() {
            if width + wide(c) > WIDEST {
                lines.push(std::mem::replace(&mut line, indent.to_string()));
                width = indent.len();
            }
            line.push(c);
            width += wide(c);
        }
    }
    lines.push(line);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_fits_the_screen_whatever_is_in_it() {
        let long = "x".repeat(500);
        for count in [1, 2, 5, 400] {
            for words in [&long[..], "石石石石 \u{1b}[2J bell \u{7}", "short"] {
                let problem = Problem::new(words, words).value(words).allowed(words).advice(words);
                let fault = FileFault {
                    line: Some(1),
                    column: Some(2),
                    layout: Some(words.into()),
                    problem,
                };
                let error = LoadError::new(words, Cause::BadInput, vec![fault; count]);
                let said = error.to_string();
                assert!(said.lines().count() <= MOST_LINES, "{said}");
                let wide = |l: &str| l.chars().map(|c| c.width().unwrap_or(0)).sum::<usize>();
                assert!(said.lines().all(|l| wide(l) <= WIDEST), "{said}");
                assert!(!said.contains(['\u{1b}', '\u{7}']));
                if count == 400 {
                    assert!(said.contains("more problems"), "{said}");
                }
            }
        }
    }

    #[test]
    fn paths_are_quoted_only_where_a_shell_needs_it() {
        assert_eq!(quoted_for_shell(Path::new("a/b-c.ron")), "a/b-c.ron");
        assert_eq!(quoted_for_shell(Path::new("my site's.ron")), "'my site'\\''s.ron'");
    }
}
