//! The built program: a real project opened, edited, saved and reopened.

use crate::pty::{Launch, Pty};
use meshcast::project::{self, Project};
use rustix::process::Signal;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const SAMPLE: &str = include_str!("../../projects/road-cut.ron");

/// The program about to open a copy of a sample project, and the copy.
pub(crate) fn with_sample() -> (Launch, PathBuf) {
    let launch = Launch::meshcast();
    let path = launch.home().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    (launch.arg(&path), path)
}

fn load(path: &Path) -> Project {
    project::load(path).unwrap().project
}

fn first_layout(path: &Path) -> String {
    load(path).layouts[0].name.clone()
}

/// Starts the program and waits for its first screen.
fn open(launch: Launch, path: &Path) -> Pty {
    let pty = launch.start();
    pty.wait_for("site.ron");
    pty.wait_for(&first_layout(path));
    pty
}

/// Types a new plate size for the first layout.
fn edit(pty: &Pty, value: &str) {
    pty.send(value);
    pty.send("\r");
    pty.wait_for("site.ron *");
}

#[test]
fn start_edit_save_quit() {
    for save in ["\x13", ":w\r"] {
        let (launch, path) = with_sample();
        let mut pty = open(launch, &path);
        edit(&pty, "0.29");
        pty.send(save);
        pty.wait_for("saved");
        pty.send("q");
        assert!(pty.wait_exit().success(), "{}", pty.dump());
        pty.assert_restored();
        let mut wanted = project::parse(SAMPLE, "sample").unwrap().project;
        wanted.layouts[0].layout.plate = 0.29;
        assert_eq!(load(&path), wanted);
        // Only the one number changed, comments and all.
        let now = fs::read_to_string(&path).unwrap();
        let changed = SAMPLE.lines().zip(now.lines()).filter(|(before, after)| before != after);
        assert_eq!(changed.count(), 1);
        assert_eq!(SAMPLE.lines().count(), now.lines().count());
    }
}

#[test]
fn opened_and_left_the_file_is_the_same() {
    let (launch, path) = with_sample();
    let mut pty = open(launch, &path);
    pty.send("\t\x1b[B?");
    pty.settle();
    pty.send("qq");
    assert!(pty.wait_exit().success());
    assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
}

#[test]
fn what_a_dropped_line_left_is_offered_again() {
    let (launch, path) = with_sample();
    let home = launch.home();
    let mut pty = open(launch, &path);
    edit(&pty, "0.27");
    pty.hang_up();
    pty.wait_exit();
    assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);

    let again = Launch::meshcast().arg(&path).env("HOME", &home);
    let mut second = again.start();
    second.wait_until("the offer", |screen| screen.contents().to_lowercase().contains("kept"));
    second.send("r");
    second.wait_for("site.ron *");
    second.send("\x13");
    second.wait_for("saved");
    second.send("q");
    assert!(second.wait_exit().success());
    assert_eq!(load(&path).layouts[0].layout.plate, 0.27);

    // Saved and done with: nothing is offered any more.
    let mut third = Launch::meshcast().arg(&path).env("HOME", &home).start();
    third.wait_for("site.ron");
    third.send("q");
    assert!(third.wait_exit().success());
}

#[test]
fn a_signal_keeps_the_edits() {
    let (launch, path) = with_sample();
    let mut pty = open(launch, &path);
    edit(&pty, "0.27");
    pty.signal(Signal::TERM);
    assert!(!pty.wait_exit().success());
    pty.assert_restored();
    let kept = path.with_file_name(".site.ron.recovery");
    assert_eq!(load(&kept).layouts[0].layout.plate, 0.27);
}

#[test]
fn keys_cost_little_on_the_line() {
    let (launch, path) = with_sample();
    let pty = open(launch, &path);
    assert_eq!(pty.cost_of(""), 0);
    for (keys, budget) in [("\x1b[C", 1500), ("\x1b[D", 1500), ("\t", 4000), ("?", 4000)] {
        let cost = pty.cost_of(keys);
        assert!((1..budget).contains(&cost), "{keys:?}: {cost} bytes");
    }
}

#[test]
fn ctrl_l_repairs_a_spoilt_screen() {
    let (launch, path) = with_sample();
    let pty = open(launch, &path);
    pty.settle();
    let good = pty.dump();
    pty.spoil("\x1b[3;3Hwall: the system goes down\x1b[31m");
    assert_ne!(pty.dump(), good);
    pty.send("\x0c");
    pty.wait_until("the screen as it was", |screen| screen.contents() == good);
}

#[test]
fn it_starts_without_a_home_and_with_one_that_cannot_be_written() {
    let mut homeless = Launch::meshcast().without("HOME").start();
    homeless.wait_for("meshcast");
    homeless.settle();
    homeless.send("q");
    assert!(homeless.wait_exit().success(), "{}", homeless.dump());

    let mut locked = Launch::meshcast().env("MESHCAST_DATA_DIR", "/proc/no/such/place").start();
    locked.wait_for("meshcast");
    locked.settle();
    locked.send("q");
    assert!(locked.wait_exit().success(), "{}", locked.dump());
}

#[test]
fn without_a_terminal_it_helps_and_refuses() {
    let output =
        Command::new(env!("CARGO_BIN_EXE_meshcast")).stdin(Stdio::null()).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    assert!(!output.stderr.is_empty());
}
