//! Project files that can be opened: those that were open before, then those near by.

use crate::app::message::FoundProject;
use crate::project::home::Home;
use std::collections::{HashSet, VecDeque};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders below the starting one that are looked into.
const DEEPEST: usize = 4;
/// Files and folders looked at, all together.
const MOST_ENTRIES: usize = 2_000;
/// Folders that hold what programs made.
const PASSED_OVER: &[&str] =
    &["target", "build", "dist", "node_modules", "__pycache__", "venv", "vendor"];

/// The recent projects, the last one first, and the `.ron` files below the folders `near`, the near
/// ones first. `current` is the one that is open.
pub(super) fn list(home: &Home, current: Option<&Path>, near: &[PathBuf]) -> Vec<FoundProject> {
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
    let current = current.map(whole);
    let base = near.first().map(|dir| whole(dir));
    let mut seen = HashSet::new();
    let mut found = Vec::new();
    let mut add = |path: PathBuf, recent: bool| {
        if seen.insert(path.clone()) {
            found.push(FoundProject {
                shown: shown(&path, base.as_deref()),
                recent,
                missing: recent && !path.is_file(),
                current: current.as_ref() == Some(&path),
                path,
            });
        }
    };
    for path in home.recent() {
        add(path, true);
    }
    let mut left = MOST_ENTRIES;
    for dir in near {
        for path in below(&whole(dir), &mut left) {
            if !home.keeps(&path) {
                add(path, false);
            }
        }
    }
    found
}

/// A path for the list: below the first folder without it, below the user's home with `~`.
fn shown(path: &Path, base: Option<&Path>) -> String {
    if let Some(rest) = base.and_then(|base| path.strip_prefix(base).ok()) {
        return rest.display().to_string();
    }
    let home = directories::BaseDirs::new();
    match home.as_ref().and_then(|h| path.strip_prefix(h.home_dir()).ok()) {
        Some(rest) => Path::new("~").join(rest).display().to_string(),
        None => path.display().to_string(),
    }
}

/// The `.ron` files below a folder, the near ones first. Links to folders are not followed, so there
/// is no going round; what cannot be read is passed over.
fn below(dir: &Path, left: &mut usize) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = VecDeque::from([(dir.to_path_buf(), 0)]);
    while let Some((folder, depth)) = folders.pop_front() {
        let Ok(entries) = fs::read_dir(&folder) else { continue };
        let (mut here, mut deeper) = (Vec::new(), Vec::new());
        for entry in entries.flatten() {
            if *left == 0 {
                break;
            }
            *left -= 1;
            let name = entry.file_name();
            let name = name.to_string_lossy();
            if name.starts_with('.') {
                continue;
            }
            let Ok(kind) = entry.file_type() else { continue };
            if kind.is_dir() {
                if depth < DEEPEST && !PASSED_OVER.contains(&name.as_ref()) {
                    deeper.push(entry.path());
                }
            } else if name.ends_with(".ron") && (kind.is_file() || entry.path().is_file()) {
                here.push(entry.path());
            }
        }
        here.sort();
        deeper.sort();
        files.extend(here);
        folders.extend(deeper.into_iter().map(|folder| (folder, depth + 1)));
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(path: &Path) {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "").unwrap();
    }

    #[test]
    fn recent_ones_first_then_near_ones_without_what_programs_made() {
        let dir = tempfile::tempdir().unwrap();
        let site = dir.path().join("site");
        let home = Home::at(Some(site.join("data")));
        for name in ["b.ron", "a.txt", "north/a.ron", "1/2/3/4/in.ron", "1/2/3/4/5/out.ron"] {
            touch(&site.join(name));
        }
        for name in ["target/no.ron", ".hidden/no.ron", ".no.ron", "node_modules/x/no.ron"] {
            touch(&site.join(name));
        }
        let elsewhere = dir.path().join("far.ron");
        touch(&elsewhere);
        home.remember(&site.join("gone.ron")).unwrap();
        home.remember(&elsewhere).unwrap();
        home.remember(&site.join("b.ron")).unwrap();
        let found = list(&home, Some(&site.join("b.ron")), &[site.clone(), dir.path().into()]);
        let names: Vec<&str> = found.iter().map(|f| f.shown.as_str()).collect();
        let far = elsewhere.display().to_string();
        assert_eq!(names, ["b.ron", &far, "gone.ron", "north/a.ron", "1/2/3/4/in.ron"]);
        assert!(found[0].current && found[0].recent && !found[0].missing);
        assert!(found[2].missing && !found[3].recent);
    }

    #[test]
    fn a_large_folder_ends_the_search() {
        let dir = tempfile::tempdir().unwrap();
        for i in 0..30 {
            touch(&dir.path().join(format!("{i}.ron")));
        }
        let mut left = 20;
        assert_eq!(below(dir.path(), &mut left).len(), 20);
        assert_eq!(left, 0);
    }
}
