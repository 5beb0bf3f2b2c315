//! Seen: lines pasted in a terminal that does not mark pastes ran as keys: layouts were deleted, the
//! program was left. A marked paste on the main screen did nothing and said nothing; one whose end was
//! lost swallowed all keys after it.
//!
//! Cause: keys have no time in them. What comes faster than anybody types is now taken as a paste.

use crate::program::with_sample;
use std::fs;

#[test]
fn an_unmarked_paste_on_the_main_screen_does_nothing_and_says_so() {
    let (launch, path) = with_sample();
    let before = fs::read_to_string(&path).unwrap();
    let mut pty = launch.start();
    pty.wait_for("bench 1");
    for paste in ["2.75\r3.1\rxxq\r", "reference\r", "a\tb\tc\td\r1\t2\t3\t4\r"] {
        pty.send(paste);
        pty.wait_for("as of a paste");
        pty.send("?");
        pty.wait_for("Main screen");
        pty.send("q");
        pty.wait_for("bench 1");
    }
    pty.send("q");
    // Nothing was edited, so nothing is asked.
    assert!(pty.wait_exit().success());
    assert_eq!(fs::read_to_string(&path).unwrap(), before);
}

#[test]
fn an_unmarked_paste_into_a_field_is_its_text() {
    let (launch, _) = with_sample();
    let pty = launch.start();
    pty.wait_for("bench 1");
    pty.send("n");
    pty.wait_for("note: ");
    pty.send("first line\rx second\rq third\r");
    pty.wait_for("first line x second q third");
    pty.send("\x1b");
    // A line that begins as a value or a command does is one, as if typed.
    pty.send("0.3000000\r");
    pty.wait_for("site.ron *");
    pty.send(":name Another name\r");
    pty.send(":set\r");
    pty.wait_for("settings, for all projects");
}

#[test]
fn a_marked_paste_on_the_main_screen_is_a_value_or_is_refused() {
    let (launch, _) = with_sample();
    let pty = launch.start();
    pty.wait_for("bench 1");
    pty.send("\x1b[200~xxq\r\x1b[201~");
    pty.wait_for("nothing was pasted");
    pty.send("\x1b[200~0.31\x1b[201~");
    pty.wait_for("side of the square anchor plate");
    pty.send("\r");
    pty.wait_for("0.31 m");
}

#[test]
fn a_paste_without_its_end_ends() {
    let (launch, _) = with_sample();
    let pty = launch.start();
    pty.wait_for("bench 1");
    pty.send("n");
    pty.wait_for("note: ");
    pty.send("\x1b[200~cut off");
    pty.wait_for("cut off");
    pty.send(" and on");
    pty.wait_for("cut off and on");
    pty.send("\x1b:set\r");
    pty.wait_for("settings, for all projects");
}
