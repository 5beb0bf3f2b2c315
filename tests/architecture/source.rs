//! Source files as the rules see them: without comments and without their tests.

use std::fs;
use std::path::Path;

/// A file of `src/`.
pub(crate) struct SourceFile {
    /// Path from the package's top, for messages.
    pub path: String,
    /// The room: first part of the path below `src/`, without an ending.
    pub room: String,
    /// The whole text.
    pub text: String,
    /// The text without comments, and without the tests at its end.
    code: String,
}

/// All files of `src/`.
pub(crate) fn files() -> Vec<SourceFile> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    gather(&top.join("src"), top, &mut found);
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

fn gather(directory: &Path, top: &Path, found: &mut Vec<SourceFile>) {
    for entry in fs::read_dir(directory).expect("src/ can be read") {
        let path = entry.expect("src/ can be read").path();
        if path.is_dir() {
            gather(&path, top, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).expect("a source file is text");
            let name = path.strip_prefix(top).unwrap_or(&path).to_string_lossy().replace('\\', "/");
            found.push(SourceFile::new(name, text));
        }
    }
}

impl SourceFile {
    pub(crate) fn new(path: String, text: String) -> SourceFile {
        let room = path.split('/').nth(1).unwrap_or("").trim_end_matches(".rs").to_string();
        let code = code(&text);
        SourceFile { path, room, text, code }
    }

    /// The text without comments, and without the tests at its end.
    pub(crate) fn code(&self) -> &str {
        &self.code
    }

    /// Lines of code that hold one of the words, as messages.
    pub(crate) fn lines_with_a_word(&self, words: &[&str]) -> Vec<String> {
        let mut found = Vec::new();
        for (index, line) in self.code.lines().enumerate() {
            for word in words {
                if has_word(line, word) {
                    found.push(format!("{}:{}: {word}", self.path, index + 1));
                }
            }
        }
        found
    }

    /// Whether the code names a module of the standard library, alone or in a group.
    pub(crate) fn uses_std(&self, module: &str) -> bool {
        children_of(&self.code, "std").iter().any(|name| name == module)
    }

    /// Names right below `crate` in the code.
    pub(crate) fn rooms_used(&self) -> Vec<String> {
        let mut used = children_of(&self.code, "crate");
        used.sort();
        used.dedup();
        used
    }
}

/// The text without comments up to the tests at the end. Lines keep their numbers.
fn code(text: &str) -> String {
    let mut out = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let tests_follow = lines.peek().is_some_and(|next| next.starts_with("mod tests {"));
        if line == "#[cfg(test)]" && tests_follow {
            break;
        }
        // A comment begins at the first `//` outside quotes.
        let mut starts = line.match_indices("//").map(|(at, _)| at);
        let comment = starts.find(|at| line[..*at].matches('"').count() % 2 == 0);
        out.push_str(&line[..comment.unwrap_or(line.len())]);
        out.push('\n');
    }
    out
}

pub(crate) fn is_letter(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn has_word(line: &str, word: &str) -> bool {
    line.match_indices(word).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        let after = line[at + word.len()..].chars().next();
        !before.is_some_and(is_letter) && !after.is_some_and(is_letter)
    })
}

/// The names after `parent::`, and the first name of each entry of `parent::{...}`.
fn children_of(code: &str, parent: &str) -> Vec<String> {
    let path = format!("{parent}::");
    let mut children = Vec::new();
    for (at, _) in code.match_indices(&path) {
        if code[..at].chars().next_back().is_some_and(is_letter) {
            continue;
        }
        let rest = &code[at + path.len()..];
        match rest.strip_prefix('{') {
            Some(group) => children.extend(first_names(group)),
            None => children.extend(leading_name(rest)),
        }
    }
    children
}

/// First names of the entries of a group, up to its closing bracket.
fn first_names(group: &str) -> Vec<String> {
    let (mut depth, mut start, mut names) = (0, 0, Vec::new());
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' | '}' if depth == 0 => {
                names.extend(leading_name(group[start..at].trim()));
                start = at + 1;
                if c == '}' {
                    break;
                }
            }
            _ => {}
        }
    }
    names
}

fn leading_name(text: &str) -> Option<String> {
    let name: String = text.chars().take_while(|c| is_letter(*c)).collect();
    (!name.is_empty()).then_some(name)
}

#[test]
fn the_reader_sees_what_it_should() {
    let text = "\
use crate::{layout, mesh::{self, MeshType},
    units::parse};
use std::{fmt, fs};
// use std::thread; a comment about ratatui
let a = \"http://x\"; let my_println = 1; // println!
crate::forecast::run();
println!(\"x\");
#[cfg(test)]
fn helper() { dbg!(1); }
#[cfg(test)]
mod tests { use std::time::Instant; }
";
    let file = SourceFile::new("src/dem/x.rs".into(), text.into());
    assert_eq!(file.room, "dem");
    assert_eq!(file.rooms_used(), ["forecast", "layout", "mesh", "units"]);
    assert!(file.uses_std("fs") && file.uses_std("fmt"));
    assert!(!file.uses_std("thread") && !file.uses_std("time"));
    assert_eq!(file.lines_with_a_word(&["println!"]), ["src/dem/x.rs:7: println!"]);
    assert_eq!(file.lines_with_a_word(&["dbg!"]), ["src/dem/x.rs:9: dbg!"]);
    assert!(file.lines_with_a_word(&["ratatui", "Instant"]).is_empty());
    assert_eq!(SourceFile::new("src/units.rs".into(), String::new()).room, "units");
}
