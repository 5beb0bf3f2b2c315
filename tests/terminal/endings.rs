//! However the program ends, the terminal is a shell's again and unsaved edits are kept.

use crate::pty::Pty;
use crate::toy::{recovery_file, toy, toy_with_autosave};
use rustix::process::Signal;
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// A program that spins or waits is found out by this.
const PROMPT: Duration = Duration::from_secs(4);

/// The toy with two edits that are not saved, and its recovery file.
fn edited() -> (Pty, PathBuf) {
    let launch = toy();
    let recovery = recovery_file(&launch);
    let pty = launch.start();
    pty.wait_for("count 0");
    pty.send("++");
    pty.wait_for("count 2");
    assert!(!recovery.exists());
    (pty, recovery)
}

#[test]
fn quit() {
    let mut pty = toy().start();
    pty.wait_for("count 0");
    pty.send("q");
    assert_eq!(pty.wait_exit().exit_code(), 0);
    pty.wait_for("the toy has ended: Quit");
    pty.assert_restored();
}

#[test]
fn signals_keep_the_edits_and_end_the_program() {
    for signal in [Signal::TERM, Signal::HUP, Signal::INT, Signal::QUIT] {
        let (mut pty, recovery) = edited();
        pty.signal(signal);
        assert!(pty.ends_within(PROMPT), "{signal:?}");
        assert_eq!(pty.wait_exit().exit_code(), 3);
        assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 2");
        pty.wait_for("the toy has ended: HungUp");
        pty.assert_restored();
    }
}

#[test]
fn a_signal_without_edits_leaves_no_recovery_file() {
    let launch = toy();
    let recovery = recovery_file(&launch);
    let mut pty = launch.start();
    pty.wait_for("count 0");
    pty.signal(Signal::TERM);
    assert!(pty.ends_within(PROMPT));
    assert!(!recovery.exists());
}

#[test]
fn a_dropped_line_keeps_the_edits_and_ends_the_program() {
    let (mut pty, recovery) = edited();
    pty.hang_up();
    assert!(pty.ends_within(PROMPT));
    assert_eq!(pty.wait_exit().exit_code(), 3);
    assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 2");
}

/// A wrapper that does not die with its terminal: the program is in no group that hears of the end.
#[test]
fn a_dropped_line_is_noticed_without_a_signal() {
    let launch = toy();
    let recovery = recovery_file(&launch);
    let exe = std::env::current_exe().unwrap();
    let script = format!(
        "trap '' HUP; '{}' --exact toy::child --ignored --nocapture; echo $? > \"$HOME/status\"",
        exe.display()
    );
    let status = launch.home().join("status");
    let mut wrapper = launch.wrapped_in_shell(&script).start();
    wrapper.wait_for("count 0");
    wrapper.send("+");
    wrapper.wait_for("count 1");
    wrapper.hang_up();
    assert!(wrapper.ends_within(PROMPT));
    assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 1");
    assert_eq!(fs::read_to_string(&status).unwrap().trim(), "3");
}

#[test]
fn a_fault_restores_the_terminal_and_says_where_the_edits_are() {
    let (mut pty, recovery) = edited();
    pty.send("p");
    assert_eq!(pty.wait_exit().exit_code(), 101);
    pty.assert_restored();
    pty.wait_for("the toy broke");
    pty.wait_for("Unsaved edits are kept in");
    assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 2");
}

#[test]
fn a_fault_in_a_worker_is_told_and_the_program_goes_on() {
    let mut pty = toy().start();
    pty.wait_for("count 0");
    pty.send("w");
    pty.wait_for("the worker broke");
    pty.send("+");
    pty.wait_for("count 1");
    assert!(pty.screen(vt100::Screen::alternate_screen));
    pty.send("q");
    assert_eq!(pty.wait_exit().exit_code(), 0);
}

#[test]
fn a_stuck_line_does_not_keep_a_signal_waiting_for_ever() {
    let (mut pty, recovery) = edited();
    pty.go_deaf();
    // Each of these draws a whole screen; the line is full long before the last.
    for _ in 0..60 {
        pty.send("r");
        std::thread::sleep(Duration::from_millis(5));
    }
    pty.signal(Signal::TERM);
    assert!(pty.ends_within(Duration::from_secs(9)));
    assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 2");
}

#[test]
fn edits_are_kept_by_themselves_and_forgotten_when_saved() {
    let launch = toy_with_autosave();
    let recovery = recovery_file(&launch);
    let mut pty = launch.start();
    pty.wait_for("count 0");
    pty.send("+");
    let start = Instant::now();
    while !fs::read_to_string(&recovery).is_ok_and(|text| text == "edit 1") {
        assert!(start.elapsed() < PROMPT);
        std::thread::sleep(Duration::from_millis(10));
    }
    pty.send("s");
    pty.wait_for("saved edit 1");
    pty.send("q");
    assert!(pty.wait_exit().success());
    assert!(!recovery.exists());
}
