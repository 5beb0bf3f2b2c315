//! Edits come back into the text and leave the rest of it alone.

use super::samples::sample;
use meshcast::project::{self, MeshUse, NamedLayout, Opened, Project};
use meshcast::units::{ForceUnit, LengthUnit, Units};

pub(crate) fn open(text: &str) -> Opened {
    project::parse(text, "test").unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// The text after an edit; checks that it holds the edited project.
pub(crate) fn after(text: &str, edit: impl FnOnce(&mut Project)) -> String {
    let opened = open(text);
    let mut edited = opened.project.clone();
    edit(&mut edited);
    let rendered = opened.document.render(&edited).unwrap();
    assert!(rendered.comments_kept, "fell back to the clean form:\n{}", rendered.text);
    assert_eq!(open(&rendered.text).project, edited);
    rendered.text
}

const SMALL: &str = include_str!("valid/mixed_styles_2.ron");

#[test]
fn one_changed_value_changes_nothing_else() {
    let text = after(SMALL, |p| p.layouts[0].layout.plate = 0.25);
    assert_eq!(text, SMALL.replace("d: 0.3, /*", "d: 0.25, /*"));
    let text = after(SMALL, |p| p.layouts[0].layout.punch = 1.2345);
    assert_eq!(text, SMALL.replace("\"1000 mm\"", "\"1234.5 mm\""));
    let text = after(SMALL, |p| p.layouts[2].question.force = Some(25_500.0));
    assert_eq!(text, SMALL.replace("Some(20)", "Some(25.5)"));
    let text = after(SMALL, |p| p.name = "a \"b\"".into());
    assert_eq!(text, SMALL.replace("name: \"p\"", r#"name: "a \"b\"""#));
}

#[test]
fn a_value_that_is_needed_comes_behind_its_neighbour() {
    let text = after(SMALL, |p| {
        p.layouts[0].layout.ex = 0.2;
        p.layouts[0].overlay = true;
    });
    assert_eq!(
        text,
        SMALL.replace(
            "D: \"1000 mm\" // punch\n",
            "D: \"1000 mm\", // punch\n            ex: 0.2,\n            overlay: true,\n"
        )
    );
    let both = |p: &mut Project| {
        p.layouts[2].question.force = None;
        p.layouts[2].question.deflection = None;
        p.layouts[2].question.gamma_load = 1.2;
    };
    let text = after(SMALL, both);
    assert!(text.contains("None, // from the survey\n            gamma_load: 1.2,\n"), "{text}");
    let text = after(SMALL, |p| p.layouts[1].question.gamma_load = 1.3);
    assert_eq!(text, SMALL.replace("ex: 0.1)", "ex: 0.1, gamma_load: 1.3)"));
    let text = after(SMALL, |p| p.display.units = Units::MILLIMETRES);
    assert_eq!(text, SMALL.replace("    ],\n)", "    ],\n    display: (length_unit: mm),\n)"));
    // Kilonewtons are not written: an older program would not know their name.
    let feet = Units { length: LengthUnit::Foot, force: ForceUnit::Kip };
    let both = after(SMALL, |p| p.display.units = feet);
    let written = "    ],\n    display: (length_unit: ft, force_unit: kip),\n)";
    assert_eq!(both, SMALL.replace("    ],\n)", written));
    let metric = SMALL.replace("    ],\n)", "    ],\n    display: (length_unit: mm), // mine\n)");
    let text = after(&metric, |p| p.display.units.force = ForceUnit::Tonne);
    assert_eq!(text, metric.replace("unit: mm)", "unit: mm, force_unit: t)"));
}

#[test]
fn a_value_that_is_not_needed_goes_unless_a_comment_speaks_of_it() {
    let text = after(SMALL, |p| {
        p.layouts[2].question.force = None;
        p.layouts[2].question.deflection = None;
        p.layouts[2].note.clear();
    });
    let want = SMALL
        .replace("Some(20)", "None")
        .replace("            allowable_deflection: 0.6,\n", "")
        .replace("note: \"x\"", "note: \"\"");
    assert_eq!(text, want);
}

#[test]
fn layouts_move_with_their_comments() {
    let text = after(SMALL, |p| p.layouts.swap(1, 2));
    let (b, c) = (text.find("about b").unwrap(), text.find("about c").unwrap());
    assert!(c < b);
    let tail = text.find("at the end").unwrap();
    assert!(text.find("behind b").unwrap() > b && tail > text.find("behind b").unwrap());
    assert!(text.find("behind c").unwrap() < b);
    for comment in ["// head", "/* one */", "// the list", "---- set apart ----", "// tail"] {
        assert_eq!(text.matches(comment).count(), 1, "{comment} in\n{text}");
    }
}

#[test]
fn a_layout_goes_with_its_own_comments_and_no_others() {
    let text = after(SMALL, |p| {
        p.layouts.remove(2);
    });
    assert!(!text.contains("about c") && !text.contains("behind c"));
    assert!(text.contains("---- set apart ----") && text.contains("at the end"), "{text}");
    let text = after(SMALL, |p| p.layouts.clear());
    assert!(text.contains("---- set apart ----") && text.contains("the list"), "{text}");
    assert!(!text.contains("about"));
}

#[test]
fn a_copy_and_a_new_layout_are_put_in_where_they_stand() {
    let text = after(SMALL, |p| {
        let copy = p.layouts[0].duplicate("a (2)");
        p.layouts.insert(1, copy);
    });
    let copy = "        (\n            name: \"a (2)\",\n            d: 0.3,\n            L: 3.0,\n            D: 1.0,\n        ),\n        // about b";
    assert!(text.contains(copy), "{text}");
    let text = after("(version: 2, name: \"p\", layouts: [])", |p| {
        p.layouts.push(NamedLayout::new("n", meshcast::layout::REFERENCE, "dt-8x10-2.7"));
    });
    assert!(
        text.starts_with("(version: 2, name: \"p\", layouts: [\n    (\n        name"),
        "{text}"
    );
}

#[test]
fn lists_on_one_line_stay_on_one_line() {
    let line = r#"(version: 2, name: "p", layouts: [(name: "a", d: 0.3, L: 3, D: 1), /* b */ (name: "b", d: 0.3, L: 3, D: 1)])"#;
    let text = after(line, |p| p.layouts.reverse());
    assert_eq!(
        text,
        r#"(version: 2, name: "p", layouts: [/* b */ (name: "b", d: 0.3, L: 3, D: 1), (name: "a", d: 0.3, L: 3, D: 1)])"#
    );
    let text = after(line, |p| {
        let copy = p.layouts[0].duplicate("c");
        p.layouts.push(copy);
    });
    assert!(text.ends_with(r#", (name: "c", d: 0.3, L: 3.0, D: 1.0)])"#), "{text}");
    assert!(!text.contains('\n'));
}

#[test]
fn windows_line_ends_stay() {
    let crlf = SMALL.replace('\n', "\r\n");
    let text = after(&crlf, |p| {
        p.layouts[0].layout.ex = 0.2;
        let copy = p.layouts[1].duplicate("n");
        p.layouts.push(copy);
        p.meshes.push(MeshUse::Catalogue("dt-8x10-2.7".into()));
    });
    assert_eq!(text.matches('\n').count(), text.matches("\r\n").count(), "{text:?}");
}

#[test]
fn the_first_mesh_can_change_without_moving_layouts_to_it() {
    let opened = sample("own-mesh.ron");
    let mut edited = opened.project.clone();
    edited.meshes.reverse();
    let plain = edited.layouts[0].duplicate("no mesh named");
    edited.layouts.push(plain);
    let rendered = opened.document.render(&edited).unwrap();
    assert!(rendered.comments_kept);
    assert_eq!(open(&rendered.text).project, edited);

    // A layout that names no mesh keeps the one it had.
    let text = after(SMALL, |p| {
        let MeshUse::Inline(mesh) = &sample("own-mesh.ron").project.meshes[0] else { panic!() };
        p.meshes.insert(0, MeshUse::Inline(mesh.clone()));
    });
    assert!(text.contains("mesh: \"dt-8x10-2.7\""), "{text}");
}

#[test]
fn a_changed_mesh_is_written_in_its_place() {
    let opened = sample("own-mesh.ron");
    let mut edited = opened.project.clone();
    let MeshUse::Inline(mesh) = &edited.meshes[0] else { panic!() };
    let mut mesh = (**mesh).clone();
    mesh.laboratory.force = 121_300.0;
    edited.meshes[0] = MeshUse::Inline(mesh.into());
    let rendered = opened.document.render(&edited).unwrap();
    // The comments inside the changed mesh are lost, and that is said; those around it stay.
    assert!(!rendered.comments_kept);
    assert!(rendered.text.contains("121.3"));
    assert!(rendered.text.contains("// The same panel with the reference mesh"));
    assert_eq!(open(&rendered.text).project, edited);
}
