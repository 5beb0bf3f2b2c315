//! The sample projects and the collection of good files: each opens, and is saved as it was.

use meshcast::layout::{Layout, REFERENCE};
use meshcast::project::{self, MeshUse, Opened};
use std::fs;
use std::path::{Path, PathBuf};

/// The `.ron` files of a directory of the source tree, in the order of their names.
pub(crate) fn files(dir: &str) -> Vec<PathBuf> {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join(dir);
    let mut list: Vec<PathBuf> =
        fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().path()).collect();
    list.retain(|path| path.extension().is_some_and(|e| e == "ron"));
    list.sort();
    list
}

pub(crate) fn sample(name: &str) -> Opened {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("projects").join(name);
    project::load(&path).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_good_file_opens_and_comes_back_byte_for_byte() {
    let all: Vec<PathBuf> =
        files("projects").into_iter().chain(files("tests/files/valid")).collect();
    assert!(all.len() > 10);
    for path in all {
        let opened = project::load(&path).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(opened.project.check(), Ok(()), "{}", path.display());
        let text = fs::read_to_string(&path).unwrap();
        if opened.document.migrated_from().is_none() {
            assert_eq!(
                opened.document.render(&opened.project).unwrap().text,
                text,
                "{}",
                path.display()
            );
        }
        // The clean form holds the same project.
        let clean = project::write::project(&opened.project).unwrap();
        let again = project::parse(&clean, "clean").unwrap_or_else(|e| panic!("{e}\n{clean}"));
        assert_eq!(again.project, opened.project, "{}", path.display());
    }
}

/// All that a version 1 file has means the same in version 2.
#[test]
fn a_version_1_file_holds_the_same_project_as_its_version_2_twin() {
    let mut twins = 0;
    for path in files("tests/files/valid") {
        let text = fs::read_to_string(&path).unwrap();
        let one = project::parse(&text, "one").unwrap_or_else(|e| panic!("{e}"));
        if one.document.migrated_from() != Some(1) {
            continue;
        }
        twins += 1;
        // No other field ends so.
        let at = text.find("version").unwrap();
        let number = if text[at..].contains("0x1") { "0x1" } else { "1" };
        let twin = format!("{}{}", &text[..at], text[at..].replacen(number, "2", 1));
        let two = project::parse(&twin, "two").unwrap_or_else(|e| panic!("{e}\n{twin}"));
        assert_eq!(two.document.migrated_from(), None, "{}", path.display());
        assert_eq!(one.project, two.project, "{}", path.display());
        // And that twin is what a save makes of the file.
        assert_eq!(one.document.render(&one.project).unwrap().text, twin, "{}", path.display());
        assert_eq!(two.document.render(&two.project).unwrap().text, twin, "{}", path.display());
    }
    assert!(twins > 10, "only {twins}");
}

#[test]
fn the_reference_panel_is_the_published_reference_point() {
    let opened = sample("reference-panel.ron");
    assert_eq!(opened.project.layouts.len(), 1);
    let layout = &opened.project.layouts[0];
    assert_eq!(layout.layout, meshcast::layout::REFERENCE);
    assert!(opened.project.mesh(layout).unwrap().reference);
}

#[test]
fn the_road_cut_is_table_1_row_by_row() {
    let opened = sample("road-cut.ron");
    // Pol & Gabrieli (2021), Table 1: d, L, D, ex, ey in m.
    let rows = [
        (0.25, 2.5, 0.60, 0.00, 0.00),
        (0.32, 2.5, 0.20, 0.00, 0.00),
        (0.40, 3.0, 1.25, 0.00, 0.00),
        (0.40, 4.0, 1.20, 2.00, 0.20),
        (0.25, 3.5, 0.80, 0.55, 1.15),
    ];
    let have: Vec<Layout> = opened.project.layouts.iter().map(|l| l.layout).collect();
    let want: Vec<Layout> = rows
        .into_iter()
        .map(|(plate, spacing, punch, ex, ey)| Layout {
            plate,
            spacing,
            punch,
            ex,
            ey,
            ..REFERENCE
        })
        .collect();
    assert_eq!(have, want);
    assert_eq!(opened.project.layouts[2].question.force, Some(20_000.0));
}

#[test]
fn the_spacing_study_varies_the_spacing_alone() {
    let opened = sample("spacing-study.ron");
    let layouts = &opened.project.layouts;
    let spacings: Vec<f64> = layouts.iter().map(|l| l.layout.spacing).collect();
    assert_eq!(spacings, [2.0, 2.5, 3.0, 3.5, 4.0, 4.5]);
    assert!(layouts.iter().all(
        |l| (l.layout.plate, l.layout.punch, l.layout.ex, l.layout.ey) == (0.32, 1.0, 0.0, 0.0)
    ));
}

#[test]
fn a_mesh_written_out_is_an_example_and_is_used() {
    let opened = sample("own-mesh.ron");
    let MeshUse::Inline(mesh) = &opened.project.meshes[0] else { panic!("not written out") };
    assert!(mesh.example);
    assert_eq!(mesh.laboratory.force, 120_000.0);
    let used = opened.project.mesh(&opened.project.layouts[0]).unwrap();
    assert_eq!(used.id, "example-mesh");
    assert_eq!(opened.project.layouts[0].layout.plate, 0.32);
}
