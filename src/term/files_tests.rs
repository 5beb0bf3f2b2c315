//! Saving and keeping through the host, in a directory of its own.

use super::*;
use crate::project;
use std::fs;
use tempfile::TempDir;

/// A saved project, its files, and the directory that holds both it and the data directory.
fn open() -> (TempDir, PathBuf, FileHost, Project) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("road.ron");
    project::create(&path, &project::new_project("Road")).unwrap();
    let opened = project::load(&path).unwrap();
    let home = Home::at(Some(dir.path().join("data")));
    (dir, path, FileHost::new(opened.document, home), opened.project)
}

fn edited(project: &Project, name: &str) -> Arc<Project> {
    Arc::new(Project { name: name.to_owned(), ..project.clone() })
}

#[test]
fn a_save_goes_to_the_file_and_drops_the_recovery_file() {
    let (_dir, path, files, project) = open();
    let edited = edited(&project, "Road, north");
    let kept = files.recover(&edited).unwrap();
    assert!(kept.exists());
    let saved = files.save(&edited, None, false).unwrap();
    assert_eq!(saved.path, path);
    assert!(!kept.exists());
    assert_eq!(project::load(&path).unwrap().project, *edited);
    assert_eq!(files.home.recent(), [path]);
}

#[test]
fn another_name_is_the_projects_own_from_then_on() {
    let (dir, path, files, project) = open();
    let other = dir.path().join("other.ron");
    let first = edited(&project, "one");
    assert_eq!(files.save(&first, Some(&other), false).unwrap().path, other);
    let second = edited(&project, "two");
    assert_eq!(files.save(&second, None, false).unwrap().path, other);
    assert_eq!(project::load(&other).unwrap().project, *second);
    assert_eq!(project::load(&path).unwrap().project, project);
}

#[test]
fn a_file_changed_by_others_is_replaced_only_when_told_to() {
    let (dir, path, files, project) = open();
    fs::write(&path, project::new_project("somebody else's")).unwrap();
    let edited = edited(&project, "mine");
    let failure = files.save(&edited, None, false).unwrap_err();
    assert!(failure.overwrite_helps, "{}", failure.message);
    assert_eq!(failure.path, None);
    files.save(&edited, None, true).unwrap();
    let taken = dir.path().join("taken.ron");
    fs::write(&taken, "something").unwrap();
    let failure = files.save(&edited, Some(&taken), false).unwrap_err();
    assert!(failure.overwrite_helps);
    assert_eq!(failure.path, Some(taken));
    let nowhere = dir.path().join("no/such/place.ron");
    assert!(!files.save(&edited, Some(&nowhere), false).unwrap_err().overwrite_helps);
}

#[test]
fn a_file_that_was_deleted_is_made_again_and_said_so() {
    let (_dir, path, files, project) = open();
    fs::remove_file(&path).unwrap();
    let saved = files.save(&edited(&project, "again"), None, false).unwrap();
    assert!(saved.note.unwrap().contains("deleted"));
}

#[test]
fn forgetting_what_is_not_there_is_fine() {
    let (_dir, _path, files, project) = open();
    files.forget_recovery().unwrap();
    let kept = files.recover(&project).unwrap();
    files.forget_recovery().unwrap();
    assert!(!kept.exists());
}
