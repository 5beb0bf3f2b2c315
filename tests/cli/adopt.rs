//! A mesh adopted from its own test: in the project, with forecasts and verdicts of its own.

use super::{good, refused, run, shown};
use std::fs;

#[test]
fn an_example_mesh_is_adopted_into_a_project_that_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.ron");
    let project = "// my site\n(version: 2, name: \"site\", meshes: [\"dt-8x10-2.7\"], layouts: [\n    \
        (name: \"old\", d: 0.3, L: 3, D: 1), // stays\n])\n";
    fs::write(&path, project).unwrap();
    let file = shown(&path);
    // A made-up double-twist mesh 6x8 of 2.2 mm wire on a small panel, so that it is soon done.
    let arguments = [
        "adopt",
        file,
        "--name",
        "Example 6x8, 2.2",
        "--force",
        "20",
        "--deflection",
        "0.32",
        "--panel",
        "1.6",
        "--punch",
        "0.5",
        "--opening",
        "0.06",
        "--diameter",
        "0.0022",
        "--example",
        "--runs",
        "60",
        "--threads",
        "2",
    ];
    let ran = run(&arguments);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.contains("one test and prior") && ran.out.contains("alpha_F"), "{}", ran.out);
    assert!(ran.err.contains("laws ") && ran.err.contains("campaign and method "), "{}", ran.err);

    // What stood there stands there still; mesh, wires and method came to it.
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("// my site\n") && text.contains("// stays"), "{text}");
    for part in
        ["example-6x8-2.2", "opening: 0.06", "diameter: 0.0022", "adopted: (", "example: true"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    let again = refused(&arguments);
    assert!(again.contains("has a mesh \"example-6x8-2.2\" already"), "{again}");
    assert_eq!(fs::read_to_string(&path).unwrap(), text);

    // A layout takes it; a copy elsewhere, without any catalogue of its user, says the same.
    let layout = "(name: \"new\", d: 0.3, L: 3, D: 1, ex: 0.4, ey: 0.5, mesh: \"example-6x8-2.2\", \
        method: derived, blocks: mirrored, design_force: 2), (name: \"old\"";
    fs::write(&path, text.replacen("(name: \"old\"", layout, 1)).unwrap();
    let copy = folder.path().join("copy.ron");
    fs::copy(&path, &copy).unwrap();
    let forecast = |file: &str| run(&["forecast", file, "--layout", "new"]);
    let (here, there) = (forecast(file), forecast(shown(&copy)));
    assert!(here.code == 0 && here.out == there.out, "{}", here.err);
    // Its ratios are its own; what an offset of facing blocks does is another mesh's, said.
    let said = format!("{}{}", here.out, here.err);
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("(the mesh's own)"), "{said}");
    assert!(said.contains("simulations of repeated blocks"), "{said}");
    let told = run(&["forecast", file, "--layout", "new", "--format", "json"]).out;
    assert!(told.contains("borrowed_map") && !told.contains("default_ratios"), "{told}");
    assert!(good(&["mesh", "list"]).lines().all(|line| !line.contains("example-6x8")));
}

#[test]
fn what_cannot_be_adopted_is_said_before_anything_is_computed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new.ron");
    let with = |more: &[&str]| {
        refused(&[&["adopt", shown(&path), "--deflection", "0.5", "--force", "60"], more].concat())
    };
    assert!(with(&["--name", "dt 8x10 2.7"]).contains("has a mesh \"dt-8x10-2.7\" already"));
    assert!(with(&["--name", "..."]).contains("letters or digits"));
    let e = with(&["--name", "m", "--panel", "0.9"]);
    assert!(e.contains("--punch") && e.contains("below the panel"), "{e}");
    assert!(!path.exists());
}
