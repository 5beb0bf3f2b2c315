//! Seen: a stack overflow or an abort, as of an allocation that is too large, left the terminal raw and
//! lost the edits.
//!
//! Cause: these ends run no panic hook, and their signal was not heard.

use crate::toy::{recovery_file, toy};
use std::fs;

#[test]
fn an_abort_gives_the_terminal_back_and_keeps_the_edits() {
    // A stack overflow in a worker and in the loop, an abort in a worker.
    for key in ["o", "O", "a"] {
        let launch = toy();
        let recovery = recovery_file(&launch);
        let mut pty = launch.start();
        pty.wait_for("count 0");
        pty.send("++");
        pty.wait_for("count 2");
        pty.send(key);
        assert!(!pty.wait_exit().success(), "{key}");
        pty.wait_for("Unsaved edits are kept in");
        pty.assert_restored();
        assert_eq!(fs::read_to_string(&recovery).unwrap(), "edit 2", "{key}");
    }
}
