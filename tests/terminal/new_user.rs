//! One who never ran the program and has the README's tour alone, on a plain xterm of 80x24: from the
//! first start to the report.

use crate::pty::Launch;
use meshcast::project;
use std::fs;

#[test]
fn from_the_first_start_to_the_report() {
    let launch = Launch::new_user().env("TERM", "xterm").arg("--fidelity").arg("quick");
    let home = launch.home();
    let mut pty = launch.start();
    pty.wait_for("1 of 5");
    for _ in 0..5 {
        pty.send("\r");
    }
    // The sample is open: a copy, in the user's own folder.
    pty.wait_until("the main screen", |s| {
        s.contents().contains("> bench 1") && !s.contents().contains(" of 5 ")
    });
    // A check of the first layout.
    pty.send("c");
    pty.wait_for("bench 1: ");
    pty.wait_for("DEM ");
    // All side by side; the governing one is the third.
    pty.send("v");
    pty.wait_for("governing portal");
    pty.send("\x1b[B\x1b[B\r");
    pty.wait_for("> portal");
    pty.wait_for("FAILS");
    // The spacing that just meets the design force, taken into the layout.
    pty.send("g");
    pty.wait_for("design of portal");
    pty.wait_for("L NONE of the range");
    // Both together cannot be met by L; the force alone can.
    pty.send("\x1b[D\x1b[D");
    pty.wait_for("what just meets the force");
    pty.send("\r");
    pty.wait_until("enough", |s| !s.contents().contains("FAILS"));
    pty.send("q");
    pty.wait_for("> portal");
    // Saved, and the report beside the project.
    pty.send(":w\r");
    pty.wait_for("saved");
    pty.send("e\r");
    pty.wait_for("written: ");
    pty.send("q");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
    pty.assert_restored();

    let found = |ending: &str| {
        let mut folders = vec![home.clone()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
                let path = entry.path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.to_string_lossy().ends_with(ending) {
                    return path;
                }
            }
        }
        panic!("no file ends with {ending}");
    };
    let project = project::load(&found("road-cut.ron")).unwrap().project;
    assert!(project.layouts[0].check.is_some(), "the check is kept");
    let portal = project.find_layout("portal").unwrap();
    let sample = project::parse(include_str!("../../projects/road-cut.ron"), "sample").unwrap();
    let before = sample.project.find_layout("portal").unwrap().layout.plate;
    assert!(portal.layout.plate > before + 0.02, "{}", portal.layout.plate);
    let report = fs::read_to_string(found("road-cut-report.html")).unwrap();
    assert!(report.contains("check by simulation") && report.contains("portal"));
}
