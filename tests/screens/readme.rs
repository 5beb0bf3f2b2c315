//! The picture in the README is the program's own screen.

use crate::harness::*;
use std::path::Path;

#[test]
fn the_readme_shows_the_real_screen() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let project = meshcast::project::load(&root.join("projects/road-cut.ron")).unwrap().project;
    let mut app = start(project, (80, 24), COLOR);
    press(&mut app, "<Tab><Tab><Down>");
    let picture = text(&app);
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    assert!(readme.contains(&picture), "put this into README.md:\n{picture}");
}
