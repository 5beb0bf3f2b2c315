//! Saving to a real disk.

use meshcast::project::{self, Overwrite, SaveError};
use std::fs;

#[test]
fn a_new_project_opens_and_is_saved_unchanged() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("new.ron");
    let text = project::new_project("North face");
    project::create(&path, &text).unwrap();
    let mut opened = project::load(&path).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(opened.project.layouts.len(), 1);
    opened.document.save(&opened.project, Overwrite::No).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    assert!(matches!(project::create(&path, &text), Err(SaveError::Exists(_))));
}

#[test]
fn an_edit_is_saved_and_read_back() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("new.ron");
    project::create(&path, &project::new_project("p")).unwrap();
    let mut opened = project::load(&path).unwrap();
    let mut edited = opened.project.clone();
    edited.layouts[0].ey = 0.1 + 0.2;
    edited.layouts[0].design_force = Some(25_000.1);
    edited.layouts.push(edited.layouts[0].duplicate("copy"));
    opened.document.save(&edited, Overwrite::No).unwrap();
    assert_eq!(project::load(&path).unwrap().project, edited);
}
