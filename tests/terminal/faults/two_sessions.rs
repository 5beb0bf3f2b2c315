//! Seen: of two sessions of one file the second was offered the living edits of the first as lost ones,
//! and dropping them, or a plain save, deleted them for good; two saves within milliseconds both said
//! that they had saved; and a change of a setting in one session reverted the other's.
//!
//! Cause: nobody knew who held a file; both wrote the same recovery file; a save compared first and
//! replaced later; settings were written all of them, as the session had found them.

use crate::pty::{Launch, Pty};
use rustix::process::Signal;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::TempDir;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");
const SAVE: &str = "\x13";
/// Selects L and types another value; D.
const EDIT_L: &str = "\x1b[B2.61\r";
const EDIT_D: &str = "\x1b[B\x1b[B0.7\r";

/// A directory with a project, and the program about to open it as somebody.
fn site() -> (TempDir, PathBuf) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    (dir, path)
}

fn launch(path: &Path, user: &str) -> Launch {
    let data = path.parent().unwrap().join("data");
    let launch = Launch::meshcast().env("MESHCAST_DATA_DIR", data).env("USER", user);
    launch.size(100, 30).arg(path)
}

fn start(path: &Path, user: &str) -> Pty {
    let pty = launch(path, user).start();
    pty.wait_for("bench 1");
    pty
}

fn quit(mut pty: Pty) {
    pty.send(":q!\r");
    assert!(pty.wait_exit().success(), "{}", pty.dump());
}

/// The end that no program sees coming.
fn kill(mut pty: Pty) {
    pty.signal(Signal::KILL);
    pty.wait_exit();
}

/// Waits until a file is as wanted.
fn await_file(path: &Path, wanted: impl Fn(Option<String>) -> bool) {
    let start = Instant::now();
    while !wanted(fs::read_to_string(path).ok()) {
        assert!(start.elapsed() < Duration::from_secs(20), "{}", path.display());
        sleep(Duration::from_millis(10));
    }
}

fn recovery(path: &Path, name: &str) -> PathBuf {
    path.with_file_name(name)
}

#[test]
fn the_second_session_reads_only_until_it_takes_the_file_over() {
    let (dir, path) = site();
    let anna = start(&path, "anna");
    let bert = start(&path, "bert");
    bert.wait_for("held by anna on ");
    bert.wait_for("read only");
    bert.send(EDIT_D);
    bert.wait_for("site.ron *");
    bert.send(SAVE);
    bert.wait_for("File held by another session");
    assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
    bert.send("\x1b");
    bert.wait_for("block        0.70");
    bert.send(SAVE);
    bert.wait_for("t       take the file over");
    bert.send("t");
    bert.wait_for("saved ");
    assert!(fs::read_to_string(&path).unwrap().contains("D: 0.7,"));
    bert.wait_until("no word of reading only", |screen| !screen.contents().contains("read only"));
    // The first one is told both, and its own save is refused until it takes the file back.
    anna.wait_for("read only");
    anna.wait_for("changed on disk");
    anna.send(EDIT_L);
    anna.send(SAVE);
    anna.wait_for("held by bert on ");
    anna.send("t");
    anna.wait_for("was changed by something else");
    anna.send("o");
    anna.wait_for("saved ");
    quit(bert);
    quit(anna);
    // What was held is given back, and nothing is left.
    let mut left: Vec<_> =
        fs::read_dir(dir.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    left.sort();
    assert_eq!(left, ["data", "site.ron"]);
}

#[test]
fn the_second_session_holds_the_file_when_the_first_one_ends() {
    let (_dir, path) = site();
    let anna = start(&path, "anna");
    let bert = start(&path, "bert");
    bert.wait_for("read only");
    quit(anna);
    bert.wait_for("this session's now");
    bert.send(EDIT_D);
    bert.send(SAVE);
    bert.wait_for("saved ");
    quit(bert);
}

#[test]
fn living_edits_are_never_offered_nor_deleted_by_another_session() {
    let (_dir, path) = site();
    let anna = start(&path, "anna");
    anna.send(EDIT_L);
    let kept = recovery(&path, ".site.ron.recovery");
    await_file(&kept, |text| text.is_some_and(|text| text.contains("L: 2.61")));
    // A start, edits of its own, a save that takes over: all of it leaves the first one's alone.
    let bert = start(&path, "bert");
    assert!(!bert.dump().contains("cut off"), "{}", bert.dump());
    bert.send(EDIT_D);
    let second = recovery(&path, ".site.ron.2.recovery");
    await_file(&second, |text| text.is_some_and(|text| text.contains("D: 0.7,")));
    bert.send(SAVE);
    bert.wait_for("take the file over");
    bert.send("t");
    bert.wait_for("saved ");
    await_file(&second, |text| text.is_none());
    assert!(fs::read_to_string(&kept).unwrap().contains("L: 2.61"));
    quit(bert);
    assert!(fs::read_to_string(&kept).unwrap().contains("L: 2.61"));
    // It is written again when it has gone.
    fs::remove_file(&kept).unwrap();
    await_file(&kept, |text| text.is_some_and(|text| text.contains("L: 2.61")));
    kill(anna);
    let again = launch(&path, "carl").start();
    again.wait_for("was cut off");
    again.send("r");
    again.wait_for("spacing      2.61");
    quit(again);
}

#[test]
fn two_saves_at_one_moment_never_both_say_saved() {
    for round in 0..5 {
        let (_dir, path) = site();
        let anna = start(&path, "anna");
        let bert = start(&path, "bert");
        anna.send(EDIT_L);
        anna.wait_for("site.ron *");
        // Bert has taken over and both believe for a moment that they may save.
        bert.send(":own\r");
        bert.send(EDIT_D);
        bert.wait_for("site.ron *");
        bert.send(SAVE);
        sleep(Duration::from_millis(round));
        anna.send(SAVE);
        let done = |pty: &Pty| {
            pty.wait_until("the end of a save", |screen| {
                let text = screen.contents();
                ["saved ", "not saved", "changed by something else", "held by"]
                    .iter()
                    .any(|word| text.contains(word))
            });
            pty.dump().contains(" saved /")
        };
        let both = done(&anna) && done(&bert);
        let text = fs::read_to_string(&path).unwrap();
        assert!(!both || (text.contains("L: 2.61") && text.contains("D: 0.7")), "{text}");
    }
}

#[test]
fn a_setting_of_one_session_does_not_revert_that_of_another() {
    let (dir, path) = site();
    let anna = start(&path, "anna");
    let bert = start(&path, "bert");
    let file = dir.path().join("data/settings.ron");
    anna.send(":set fidelity fine\r");
    await_file(&file, |text| text.is_some_and(|text| text.contains("fidelity: fine")));
    bert.send(":set runs 12\r");
    await_file(&file, |text| text.is_some_and(|text| text.contains("runs: 12")));
    assert!(fs::read_to_string(&file).unwrap().contains("fidelity: fine"));
    quit(anna);
    quit(bert);
}

#[test]
fn the_claim_of_a_killed_session_holds_nobody_up() {
    let (_dir, path) = site();
    kill(start(&path, "anna"));
    assert!(path.with_file_name(".site.ron.lock").exists());
    let bert = start(&path, "bert");
    assert!(!bert.dump().contains("held by"), "{}", bert.dump());
    bert.send(EDIT_D);
    bert.send(SAVE);
    bert.wait_for("saved ");
    quit(bert);
}
