//! The README shows the program's own screen, names every key of the main screen and no file that is not
//! there. What it says of the command line is held by `tests/cli/readme.rs`.

use crate::harness::*;
use meshcast::app::keymap::{Action, Context, of};
use std::path::Path;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn readme() -> String {
    std::fs::read_to_string(root().join("README.md")).unwrap()
}

#[test]
fn the_readme_shows_the_real_screen() {
    let project = meshcast::project::load(&root().join("projects/road-cut.ron")).unwrap().project;
    let mut app = start(project, (80, 24), COLOR);
    press(&mut app, "<Tab><Tab><Down>");
    let picture = text(&app);
    assert!(readme().contains(&picture), "put this into README.md:\n{picture}");
}

#[test]
fn the_readme_is_for_users_and_short() {
    assert!(readme().lines().count() <= 200, "{} lines", readme().lines().count());
}

#[test]
fn every_key_of_the_main_screen_is_in_the_table() {
    let readme = readme();
    let table = readme.split("## Keys").nth(1).unwrap().split("\n## ").next().unwrap();
    // What a terminal user expects, and nobody looks up.
    let plain = [Action::Redraw, Action::Suspend];
    let missing: Vec<String> = of(Context::Main)
        .filter(|b| !plain.contains(&b.action))
        .filter(|b| {
            !table.contains(&format!("`{}`", b.keys[0].to_string().replace("Delete", "Del")))
        })
        .map(|b| format!("{}: {}", b.keys[0], b.help))
        .collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn every_file_that_is_named_is_there() {
    let readme = readme();
    let links = readme.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let quoted = readme.split('`').skip(1).step_by(2);
    let named: Vec<&str> = links
        .chain(quoted)
        .filter(|path| {
            ["projects/", "assets/", "src/", "tests/", ".ci/"].iter().any(|r| path.starts_with(r))
        })
        .collect();
    assert!(named.len() > 5, "{named:?}");
    for path in named {
        assert!(root().join(path).exists(), "{path}");
    }
}
