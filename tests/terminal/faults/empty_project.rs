//! Seen: a project with `layouts: []` ended the program at its start with an index out of bounds; and as
//! it had become the last project, every bare start after it.
//!
//! Cause: the program took for granted that a layout is selected.

use crate::pty::Launch;
use std::fs;

const EMPTY: &str = "(version: 1, name: \"Quarry\", layouts: [])\n";

#[test]
fn an_empty_project_is_opened_and_offers_to_add_a_layout() {
    let launch = Launch::meshcast();
    let path = launch.home().join("empty.ron");
    fs::write(&path, EMPTY).unwrap();
    let data = tempfile::tempdir().unwrap();
    let mut pty = launch.env("MESHCAST_DATA_DIR", data.path()).arg(&path).start();
    pty.wait_for("no layouts yet: a adds one");
    pty.send("a");
    pty.wait_for("added layout;");
    pty.send("u");
    pty.wait_for("no layouts yet");
    pty.send("q");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
    // It is the last project now.
    let mut bare = Launch::meshcast().env("MESHCAST_DATA_DIR", data.path()).start();
    bare.wait_for("no layouts yet");
    bare.send("q");
    assert!(bare.wait_exit().success(), "{}", bare.dump());
}
