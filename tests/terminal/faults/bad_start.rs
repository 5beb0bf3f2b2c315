//! Seen: a start ended for good where a file that it opens unasked was damaged: the sample in the data
//! directory. A damaged list of recent projects was passed over without a word.
//!
//! Cause: the error of a file that nobody named was treated like that of a file that was asked for.

use crate::pty::Launch;
use std::fs;

/// A bare start with such files in the data directory says this and can be worked with.
fn starts(files: &[(&str, &[u8])], said: &str) {
    let data = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        fs::write(data.path().join(name), bytes).unwrap();
    }
    let mut pty = Launch::meshcast().env("MESHCAST_DATA_DIR", data.path()).size(160, 30).start();
    pty.wait_for(said);
    pty.wait_for("bench 1");
    pty.send(":q!\r");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
}

#[test]
fn no_file_that_is_read_unasked_makes_a_start_impossible() {
    let deep = "{".repeat(20_000).into_bytes();
    starts(&[("road-cut.ron", b"(version: 1")], "kept nowhere until you save it");
    starts(&[("road-cut.ron", &deep)], "kept nowhere until you save it");
    starts(&[("state.ron", b"(recent: 3")], "state.ron cannot be read");
    starts(&[("state.ron", &deep)], "state.ron cannot be read");
    starts(&[("state.ron", b"\xff\0")], "state.ron");
    starts(&[("settings.ron", &deep)], "settings.ron");
    starts(
        &[("state.ron", b"(recent: [\"/none/at/all.ron\"])")],
        "The last project, /none/at/all.ron",
    );
}

#[test]
fn kept_edits_that_cannot_be_read_are_told() {
    let launch = Launch::meshcast();
    let path = launch.home().join("p.ron");
    fs::write(
        &path,
        "(version: 1, name: \"P\", layouts: [(name: \"one\", d: 0.25, L: 2.5, D: 0.6)])",
    )
    .unwrap();
    let kept = launch.home().join(".p.ron.recovery");
    let deep = "{".repeat(20_000);
    fs::write(&kept, &deep).unwrap();
    let mut pty = launch.arg(&path).start();
    pty.wait_for("edits kept from a lost session cannot be read");
    pty.send("q");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
}
