//! Seen: edits kept from a lost session that were older than the file were taken back without a word of
//! that, and the save after it replaced the newer file unasked.
//!
//! Cause: the question did not compare times; and to the save the file was as it had been opened.

use crate::pty::Launch;
use std::fs;
use std::time::{Duration, SystemTime};

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

#[test]
fn kept_edits_that_the_file_has_overtaken_are_told_as_such_and_the_save_asks() {
    let launch = Launch::meshcast();
    let path = launch.home().join("site.ron");
    let kept = launch.home().join(".site.ron.recovery");
    fs::write(&path, SAMPLE.replacen("D: 0.6,", "D: 0.7,", 1)).unwrap();
    fs::write(&kept, SAMPLE.replacen("L: 2.5,", "L: 2.61,", 1)).unwrap();
    let at = |seconds| SystemTime::UNIX_EPOCH + Duration::from_secs(seconds);
    fs::File::options().write(true).open(&kept).unwrap().set_modified(at(1_795_766_400)).unwrap();
    fs::File::options().write(true).open(&path).unwrap().set_modified(at(1_795_770_000)).unwrap();
    let mut pty = launch.arg(&path).start();
    pty.wait_for("was cut off");
    let text = pty.dump();
    for word in ["2026-11-27 08:00 UTC, OLDER", "09:00 UTC", "L 2.50 to 2.61 m", "D 0.70 to 0.60 m"]
    {
        let flat: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(flat.contains(word), "{word}: {text}");
    }
    pty.send("r");
    pty.wait_for("the kept edits are back");
    pty.send("\x13");
    pty.wait_for("was changed by something else");
    pty.send("o");
    pty.wait_for("saved ");
    assert!(fs::read_to_string(&path).unwrap().contains("L: 2.61"));
    pty.send("q");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
    assert!(!kept.exists());
}
