//! Exports: tables, pictures and reports as texts. The pictures that the tests make are kept in
//! `target/tmp`, to be looked at.

mod checks;
mod pictures;
mod reports;
mod tables;

use meshcast::export::{ExportedLayout, exported};
use meshcast::project::{Project, load, parse};
use std::path::Path;

/// A sample of the source tree.
fn sample(name: &str) -> Project {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("projects").join(name);
    load(&path).expect("the sample opens").project
}

/// Everything that makes an export difficult: signs that mean something in XML, HTML, Markdown, CSV
/// and shells, a layout near the branch change, one on a plate, one outside the ranges, factors.
const ODD: &str = r##"(
    version: 1,
    name: "<b>&\"odd\"</b> | *x* `y`",
    site: "[link](http://x) <i>",
    notes: "1. one\n- two\n\n<script>alert(1)</script>",
    display: (length_unit: mm),
    layouts: [
        (name: "near <D>, it's \"here\"", d: 0.32, L: 3.0, D: 0.33, design_force: 25.0, gamma_load: 1.35, gamma_resistance: 1.25, allowable_deflection: 0.5),
        (name: "-on | a plate $HOME", d: 0.32, L: 3.0, D: 1.0, ex: 1.5, ey: 1.5, design_force: 10.0),
        (name: "外側 far outside, with as long a name as a project takes it", d: 0.5, L: 5.5, D: 2.9, ex: 0.4, ey: -0.2, allowable_deflection: 3.0, branch: conservative, note: "# note\n<of> lines"),
        (name: "=1+1", d: 0.3333333333333333, L: 2.0, D: 0.5, design_force: 500.0),
    ],
)"##;

fn odd() -> Project {
    parse(ODD, "odd.ron").expect("the odd project opens").project
}

fn good(project: &Project) -> Vec<ExportedLayout> {
    exported(project).expect("the project is sound")
}

/// Projects that every export is tried on.
fn projects() -> Vec<Project> {
    let names = ["own-mesh.ron", "reference-panel.ron", "road-cut.ron", "spacing-study.ron"];
    names.into_iter().map(sample).chain([odd()]).collect()
}

/// Keeps a text beside the built program, for eyes.
fn keep(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(path, text).expect("the build directory can be written");
}
