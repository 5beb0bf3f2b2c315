//! Seen: on a slow line the right arrow ran a check of all layouts, and so did Alt with it on PuTTY;
//! Escape and the next key in one packet did nothing.
//!
//! Cause: what was there when the line was read counted as whole. ESC alone was Escape at once, and the
//! rest of the arrow two letters; ESC ESC was Escape and gave up the rest; ESC with a key was a key with
//! Alt that nothing is bound to.

use crate::toy::toy;
use std::thread::sleep;
use std::time::Duration;

#[test]
fn an_arrow_in_two_pieces_is_an_arrow() {
    let pty = toy().start();
    pty.wait_for("count 0");
    for (first, rest) in [("\x1b", "[C"), ("\x1b[", "C"), ("\x1b", "OC"), ("\x1bO", "C")] {
        for pause in [0, 5, 15, 300] {
            pty.send("_");
            pty.wait_for("key _");
            pty.send(first);
            // After so long a pause Escape has been given out, but the rest is no letters yet.
            sleep(Duration::from_millis(pause));
            pty.send(rest);
            pty.wait_for("key Right");
            assert_eq!(pty.cost_of("n"), 0, "{first:?} {rest:?}");
        }
    }
}

#[test]
fn alt_with_an_arrow_is_no_letter() {
    let pty = toy().start();
    pty.wait_for("count 0");
    for bytes in ["\x1b\x1b[C", "\x1b\x1bOC", "\x1b[1;3C"] {
        pty.send("_");
        pty.wait_for("key _");
        pty.send(bytes);
        pty.wait_for("key Alt+Right");
    }
}

#[test]
fn escape_and_a_key_in_one_packet_are_both() {
    let pty = toy().start();
    pty.wait_for("count 0");
    pty.send("\x1b+");
    pty.wait_for("key Esc");
    pty.wait_for("count 1");
    pty.send("\x1b:");
    pty.wait_for("key :");
    pty.send("\x1b\x1b");
    pty.wait_for("key Esc");
}
