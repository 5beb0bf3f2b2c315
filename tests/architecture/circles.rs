//! Files that need each other.

use crate::source::{SourceFile, files, is_letter};
use std::collections::{BTreeMap, BTreeSet};

/// Circles that are still to be opened, by the rooms or folders that they lie in. To be emptied.
const STILL: &[&str] = &["src/dem/", "src/project/"];

/// A path of names: `["crate", "app", "keymap"]`.
type Names = Vec<String>;

/// Files by the module that they are, and what each gives on from others.
struct House {
    /// Index of the file of a module.
    modules: BTreeMap<Names, usize>,
    files: Vec<SourceFile>,
    /// Of each file, by name: the paths of what it gives on (`pub use`).
    given_on: Vec<BTreeMap<String, Names>>,
}

impl House {
    fn new(files: Vec<SourceFile>) -> House {
        let all = files.iter().map(|f| module(&f.path)).zip(0..);
        let mut house = House { modules: all.collect(), given_on: Vec::new(), files };
        house.given_on = (house.files.iter())
            .map(|file| {
                let given = uses(file.code()).into_iter().filter(|u| u.given_on);
                given.map(|u| (u.name, House::absolute(&module(&file.path), &u.path))).collect()
            })
            .collect();
        house
    }

    /// A path from the top; one that begins with neither `crate`, `super` nor `self` begins in the
    /// module itself, or in another crate, which no module answers to.
    fn absolute(here: &[String], path: &[String]) -> Names {
        let mut at: Names = here.to_vec();
        for (place, name) in path.iter().enumerate() {
            match name.as_str() {
                "crate" if place == 0 => at = vec![name.clone()],
                "self" => {}
                "super" => {
                    at.pop();
                }
                _ => at.push(name.clone()),
            }
        }
        at
    }

    /// The file that a path leads to: the one that defines its name, where others only give it on.
    fn file_of(&self, path: &[String]) -> Option<usize> {
        let longest = (1..=path.len()).rev().find(|n| self.modules.contains_key(&path[..*n]))?;
        let file = self.modules[&path[..longest]];
        let next = path.get(longest).and_then(|name| self.given_on[file].get(name));
        match next.filter(|next| next.as_slice() != path) {
            Some(next) => self.file_of(next),
            // A name that ends at the top is of another crate, or of a macro.
            None => (longest > 1).then_some(file),
        }
    }

    /// Of each file, the files it takes something from, those above and below it left out.
    fn arrows(&self) -> Vec<BTreeSet<usize>> {
        let taken = |(from, file): (usize, &SourceFile)| {
            let here = module(&file.path);
            let paths = uses(file.code()).into_iter().map(|u| u.path).chain(paths(file.code()));
            let to = paths.filter_map(|path| self.file_of(&House::absolute(&here, &path)));
            to.filter(|to| {
                let there = module(&self.files[*to].path);
                *to != from && !here.starts_with(&there) && !there.starts_with(&here)
            })
            .collect()
        };
        self.files.iter().enumerate().map(taken).collect()
    }
}

/// The module that a file is.
fn module(path: &str) -> Names {
    let inside = path.trim_start_matches("src/").trim_end_matches(".rs").trim_end_matches("/mod");
    let names = inside.split('/').filter(|name| *name != "lib").map(String::from);
    std::iter::once("crate".to_string()).chain(names).collect()
}

/// What a `use` names.
#[derive(Debug, PartialEq)]
struct Use {
    /// The name it has here.
    name: String,
    /// Where it comes from.
    path: Names,
    /// Whether others may take it from here.
    given_on: bool,
}

/// All names of all `use` lines.
fn uses(code: &str) -> Vec<Use> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("use ") {
        let line = code[..at].rsplit('\n').next().unwrap_or("").trim();
        if !(line.is_empty() || line == "pub" || line.starts_with("pub(") && line.ends_with(')')) {
            continue;
        }
        let Some(end) = code[at..].find(';') else { continue };
        let tree: String = code[at + 4..at + end].split_whitespace().collect::<Vec<_>>().join(" ");
        branches(&tree, &[], &mut |name, path| {
            found.push(Use { name, path, given_on: !line.is_empty() });
        });
    }
    found
}

/// Every name of a tree of names: `a::{b, c::{self, d as e}}`.
fn branches(tree: &str, above: &[String], found: &mut dyn FnMut(String, Names)) {
    let tree = tree.trim();
    if let Some(at) = tree.find('{') {
        let stem = tree[..at].trim_end_matches("::").split("::").filter(|s| !s.is_empty());
        let above: Names = above.iter().cloned().chain(stem.map(|s| s.trim().into())).collect();
        let inside = &tree[at + 1..tree.rfind('}').unwrap_or(tree.len())];
        let (mut depth, mut start) = (0, 0);
        for (i, c) in inside.char_indices().chain([(inside.len(), ',')]) {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    if !inside[start..i].trim().is_empty() {
                        branches(&inside[start..i], &above, found);
                    }
                    start = i + 1;
                }
                _ => {}
            }
        }
        return;
    }
    let (path, alias) = tree.split_once(" as ").map_or((tree, None), |(p, a)| (p, Some(a.trim())));
    let names =
        path.split("::").map(|s| s.trim().to_string()).filter(|s| s != "self" || above.is_empty());
    let path: Names = above.iter().cloned().chain(names).collect();
    let name = alias.map(String::from).or(path.last().cloned()).unwrap_or_default();
    found(name, path);
}

/// Paths from `crate` or `super` in the midst of the code.
fn paths(code: &str) -> Vec<Names> {
    let starts = ["crate::", "super::"].into_iter().flat_map(|word| code.match_indices(word));
    let whole = starts.filter(|(at, _)| {
        let before = code[..*at].chars().next_back();
        !before.is_some_and(|c| is_letter(c) || c == ':')
    });
    let name = |c: char| is_letter(c) || c == ':';
    whole
        .map(|(at, _)| {
            let path: String = code[at..].chars().take_while(|c| name(*c)).collect();
            path.split("::").filter(|s| !s.is_empty()).map(String::from).collect()
        })
        .collect()
}

/// Groups of files of which each can be reached from each other.
fn circles(arrows: &[BTreeSet<usize>]) -> Vec<Vec<usize>> {
    let reach: Vec<BTreeSet<usize>> = (0..arrows.len())
        .map(|from| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
            while let Some(at) = open.pop() {
                open.extend(arrows[at].iter().filter(|to| seen.insert(**to)));
            }
            seen
        })
        .collect();
    let tied = |a: usize, b: usize| reach[a].contains(&b) && reach[b].contains(&a);
    let mut found: Vec<Vec<usize>> = Vec::new();
    for file in (0..arrows.len()).filter(|file| reach[*file].contains(file)) {
        match found.iter_mut().find(|circle| tied(circle[0], file)) {
            Some(circle) => circle.push(file),
            None => found.push(vec![file]),
        }
    }
    found
}

/// No file needs a file that needs it, however long the way round: such files can only be read, tested
/// and moved together.
///
/// What counts is what a file takes by `use` or by a path that begins with `crate` or `super`; a name
/// that a `mod.rs` only gives on counts for the file that defines it. A file and the files in the
/// folder of its own name are one thing: between those that lie above each other nothing counts.
#[test]
fn no_files_need_each_other() {
    let sources = files().into_iter().filter(|f| !f.path.ends_with("_tests.rs"));
    let house = House::new(sources.filter(|f| f.room != "build" && f.room != "main").collect());
    let arrows = house.arrows();
    let mut found = Vec::new();
    for circle in circles(&arrows) {
        let path = &house.files[circle[0]].path;
        if STILL.iter().any(|place| path.starts_with(place)) {
            continue;
        }
        found.push(format!("{} files in a circle:", circle.len()));
        for from in &circle {
            for to in arrows[*from].iter().filter(|to| circle.contains(to)) {
                let (from, to) = (&house.files[*from].path, &house.files[*to].path);
                found.push(format!("    {from} -> {to}"));
            }
        }
    }
    assert!(found.is_empty(), "\n{}\n", found.join("\n"));
}

#[test]
fn the_reader_of_imports_sees_what_it_should() {
    let file = |path: &str, text: &str| SourceFile::new(path.into(), text.into());
    let house = House::new(vec![
        file("src/lib.rs", ""),
        file("src/a/mod.rs", "mod x;\npub(crate) use x::{Thing, deep::Other as Name};\n"),
        file("src/a/x.rs", "use super::super::b;\nuse super::Anything;\nuse std::fmt;\n"),
        file("src/a/x/deep.rs", ""),
        file(
            "src/b.rs",
            "use crate::{c::{self, D}, a::Thing};\nfn f() { crate::a::Name::new(); }\n",
        ),
        file("src/c.rs", "// use crate::b;\nuse crate::VERSION;\n"),
    ]);
    let arrows = house.arrows();
    let names = |from: usize| arrows[from].iter().map(|to| house.files[*to].path.as_str());
    assert_eq!(names(2).collect::<Vec<_>>(), ["src/b.rs"]);
    assert_eq!(names(4).collect::<Vec<_>>(), ["src/a/x.rs", "src/a/x/deep.rs", "src/c.rs"]);
    assert!([0, 1, 3, 5].into_iter().all(|from| arrows[from].is_empty()), "{arrows:?}");
    assert_eq!(circles(&arrows), [vec![2, 4]]);
}
