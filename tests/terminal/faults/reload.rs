//! Seen: a colleague's save was only noticed by one's own, and then the choice was to overwrite it or
//! not; reading it meant to quit and to start again.
//!
//! Cause: nobody looked at the file, and the question had no such answer.

use crate::program::with_sample;
use std::fs;

#[test]
fn a_file_that_changed_on_disk_is_noticed_and_can_be_read_anew() {
    let (launch, path) = with_sample();
    let mut pty = launch.size(100, 30).start();
    pty.wait_for("bench 1");
    let text = fs::read_to_string(&path).unwrap();
    // Saved as by an editor: another file takes the place.
    let theirs = text.replacen("D: 0.6,", "D: 0.7,", 1);
    fs::write(path.with_extension("new"), &theirs).unwrap();
    fs::rename(path.with_extension("new"), &path).unwrap();
    pty.wait_for("changed on disk");
    pty.send(":reload\r");
    pty.wait_for("block        0.70");
    pty.wait_until("no word of a change", |s| !s.contents().contains("changed on disk"));
    // With edits of one's own the save asks, and reading anew is one of the answers.
    fs::write(&path, &text).unwrap();
    pty.send("0.31\r");
    pty.wait_for("site.ron *");
    pty.send("\x13");
    pty.wait_for("r       read the file on disk anew");
    pty.send("r");
    pty.wait_for("block        0.60");
    assert!(!pty.dump().contains("site.ron *"), "{}", pty.dump());
    pty.send("q");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
}
