//! Ctrl+Z and back, in an interactive shell with job control.

use crate::pty::Pty;
use crate::toy::toy;
use rustix::process::Signal;

/// The toy's command line, for a shell.
fn command() -> String {
    let exe = std::env::current_exe().unwrap();
    format!("'{}' --exact toy::child --ignored --nocapture", exe.display())
}

/// An interactive shell with the toy's environment.
fn shell() -> Pty {
    let pty = toy().wrapped_in_shell("PS1='prompt'; PS1=\"$PS1> \" exec /bin/sh -i").start();
    pty.wait_for("prompt> ");
    pty
}

/// Waits until the shell has the terminal again.
fn wait_for_prompt(pty: &Pty) {
    pty.wait_until("the shell's screen", |screen| {
        !screen.alternate_screen()
            && !screen.hide_cursor()
            && screen.contents().trim_end().ends_with("prompt>")
    });
}

#[test]
fn ctrl_z_gives_the_terminal_to_the_shell_and_fg_takes_it_back() {
    let pty = shell();
    pty.send(&format!("{}\n", command()));
    pty.wait_for("count 0");
    for round in 1..=3 {
        pty.send("+");
        pty.wait_for(&format!("count {round}"));
        pty.send("\x1a");
        wait_for_prompt(&pty);
        pty.resize(80 + round, 24);
        pty.send("fg\n");
        pty.wait_for("back again");
        pty.wait_for(&format!("toy {}x24 ⣿ count {round}", 80 + round));
        assert!(!pty.is_cooked());
    }
    pty.send("q");
    pty.wait_for("the toy has ended: Quit");
    wait_for_prompt(&pty);
}

/// As under `cargo run`, where the shell waits for the program around this one.
#[test]
fn ctrl_z_stops_what_the_program_was_started_with() {
    let pty = shell();
    pty.send(&format!("sh -c \"{}; echo around it\"\n", command()));
    pty.wait_for("count 0");
    pty.send("\x1a");
    wait_for_prompt(&pty);
    pty.send("fg\n");
    pty.wait_for("back again");
    pty.send("+");
    pty.wait_for("count 1");
    pty.send("q");
    pty.wait_for("around it");
}

/// In a session of its own there is no shell to continue the program.
#[test]
fn ctrl_z_without_a_shell_does_nothing() {
    let pty = toy().start();
    pty.wait_for("count 0");
    assert_eq!(pty.cost_of("\x1a"), 0);
    pty.send("+");
    pty.wait_for("count 1");
}

#[test]
fn stopped_and_continued_from_outside_it_draws_anew() {
    let pty = toy().start();
    pty.wait_for("count 0");
    let before = pty.settle();
    pty.signal(Signal::STOP);
    pty.signal(Signal::CONT);
    pty.wait_for("back again");
    pty.settle();
    assert!(pty.received()[before..].starts_with(b"\x1b[0m\x1b[?1049h"));
    pty.wait_for("row 23");
    assert!(!pty.is_cooked());
}
