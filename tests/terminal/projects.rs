//! The whole program and its files: the sample, the last project, questions, recovery, broken files.

use crate::pty::{Launch, Pty};
use rustix::process::Signal;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

const PROJECT: &str = "\
// The north side, after the survey.
(
    version: 1,
    name: \"North side\",
    layouts: [
        (name: \"bench\", d: 0.25, L: 2.5, D: 0.6), // seen in spring
        (name: \"gully\", d: 0.4, L: 3.0, D: 1.25),
    ],
)
";

const CTRL_S: &str = "\x13";

/// The program about to be started, with its data directory inside its own home.
fn meshcast() -> Launch {
    let launch = Launch::meshcast();
    let data = launch.home().join("data");
    launch.env("MESHCAST_DATA_DIR", data)
}

/// The program on a project file of its own, and that file.
fn on_project() -> (Launch, PathBuf) {
    let launch = meshcast();
    let file = launch.home().join("north.ron");
    fs::write(&file, PROJECT).unwrap();
    (launch.arg("north.ron"), file)
}

fn quit(pty: &mut Pty) {
    pty.send("q");
    assert_eq!(pty.wait_exit().exit_code(), 0);
    pty.assert_restored();
}

#[test]
fn the_first_run_opens_a_copy_of_the_sample_and_the_next_the_last_project() {
    let launch = meshcast();
    let data = launch.home().join("data");
    let kept = tempfile::tempdir().unwrap();
    let mut pty = launch.start();
    pty.wait_for("road-cut.ron");
    let copied = fs::read(data.join("road-cut.ron")).unwrap();
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("projects/road-cut.ron");
    assert_eq!(copied, fs::read(sample).unwrap());
    let elsewhere = kept.path().join("mine.ron");
    pty.send(&format!(":w {}\r", elsewhere.display()));
    pty.wait_for("saved");
    // The data directory lives in this run's home: keep it for the next run.
    let moved = kept.path().join("data");
    fs::create_dir(&moved).unwrap();
    fs::copy(data.join("state.ron"), moved.join("state.ron")).unwrap();
    quit(&mut pty);
    let mut again = Launch::meshcast().env("MESHCAST_DATA_DIR", moved).start();
    again.wait_for("mine.ron");
    quit(&mut again);
}

#[test]
fn unsaved_edits_are_asked_about_and_can_be_discarded() {
    let (launch, file) = on_project();
    let mut pty = launch.start();
    pty.wait_for("bench");
    pty.send("\x1b[Cq");
    pty.wait_for("There are edits that are not saved");
    pty.send("d");
    assert_eq!(pty.wait_exit().exit_code(), 0);
    assert_eq!(fs::read_to_string(&file).unwrap(), PROJECT);
    assert!(!file.with_file_name(".north.ron.recovery").exists());
}

#[test]
fn a_lost_line_keeps_the_edits_and_the_next_start_offers_them() {
    let (launch, file) = on_project();
    let copy = tempfile::tempdir().unwrap();
    let mut pty = launch.start();
    pty.wait_for("bench");
    pty.send("0.31\r");
    pty.wait_for("north.ron *");
    pty.signal(Signal::HUP);
    assert!(pty.ends_within(Duration::from_secs(4)));
    let recovery = file.with_file_name(".north.ron.recovery");
    assert_eq!(fs::read_to_string(&file).unwrap(), PROJECT);
    assert!(fs::read_to_string(&recovery).unwrap().contains("d: 0.31"));
    for name in ["north.ron", ".north.ron.recovery"] {
        fs::copy(file.with_file_name(name), copy.path().join(name)).unwrap();
    }
    let mut again = meshcast().arg(copy.path().join("north.ron")).start();
    again.wait_for("was cut off");
    again.send("r");
    again.wait_for("0.31");
    again.send(CTRL_S);
    // The message of taking the edits back has the word too.
    again.wait_for("saved /");
    assert!(fs::read_to_string(copy.path().join("north.ron")).unwrap().contains("d: 0.31"));
    assert!(!copy.path().join(".north.ron.recovery").exists());
    quit(&mut again);
}

#[test]
fn a_file_changed_behind_our_back_is_not_overwritten_unasked() {
    let (launch, file) = on_project();
    let mut pty = launch.start();
    pty.wait_for("bench");
    pty.send("\x1b[C");
    pty.wait_for("north.ron *");
    let theirs = PROJECT.replace("North side", "South side");
    fs::write(&file, &theirs).unwrap();
    pty.send(CTRL_S);
    pty.wait_for("changed by something else");
    assert_eq!(fs::read_to_string(&file).unwrap(), theirs);
    pty.send("o");
    pty.wait_for("saved");
    assert!(fs::read_to_string(&file).unwrap().contains("d: 0.26"));
    quit(&mut pty);
}

#[test]
fn a_broken_file_is_an_error_on_one_screen_and_leaves_the_terminal_alone() {
    let launch = meshcast();
    fs::write(launch.home().join("bad.ron"), PROJECT.replacen("L: 2.5", "L: 2,5", 1)).unwrap();
    let mut pty = launch.arg("bad.ron").start();
    assert_eq!(pty.wait_exit().exit_code(), 2);
    pty.wait_for("bad.ron");
    pty.wait_for("line 6");
    pty.assert_restored();
}

#[test]
fn no_color_sends_no_colour_and_old_terminals_get_ascii() {
    let (launch, _file) = on_project();
    let mut pty = launch.env("NO_COLOR", "1").env("LANG", "C").env("TERM", "vt100").start();
    pty.wait_for("22.8 kN");
    pty.send("\t?q");
    pty.settle();
    let bytes = pty.received();
    quit(&mut pty);
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.is_ascii());
    for code in text.split("\x1b[").skip(1) {
        let end = code.find(|c: char| c.is_ascii_alphabetic()).unwrap();
        if &code[end..=end] == "m" {
            let coloured = code[..end].split(';').any(|n| {
                n.parse::<u32>()
                    .is_ok_and(|n| (30..=38).contains(&n) || (40..=48).contains(&n) || n >= 90)
            });
            assert!(!coloured, "{code:?}");
        }
    }
}

#[test]
fn a_small_terminal_says_so_and_comes_back() {
    let (launch, _file) = on_project();
    let mut pty = launch.start();
    pty.wait_for("22.8 kN");
    pty.resize(30, 8);
    pty.wait_for("too small: q quits");
    pty.resize(40, 12);
    pty.wait_for("22.8 kN");
    pty.resize(120, 40);
    pty.wait_for("along the curve");
    quit(&mut pty);
}
