//! Seen: after a new size in the middle of a large paste no key arrived any more, in 6 to 12 of 100
//! tries; the terminal stayed with its window.
//!
//! Cause: the new size was told on the same watch as the input, and what woke for it passed over the
//! edge of the input. The input is now watched by level, and new sizes come as signals elsewhere.

use crate::toy::toy;

#[test]
fn a_new_size_with_a_large_paste_leaves_the_keyboard_alive() {
    let pty = toy().start();
    pty.wait_for("count 0");
    for round in 1..=40 {
        // Both while it waits, so that it hears of both at once; then again in the middle.
        pty.resize(if round % 2 == 0 { 100 } else { 60 }, 20 + round as u16 % 5);
        pty.send("\x1b[200~");
        pty.send(&"a".repeat(30_000));
        pty.resize(90, 25);
        pty.send(&"a".repeat(30_000));
        pty.send("\x1b[201~+");
        pty.wait_for(&format!("count {round}"));
    }
}
