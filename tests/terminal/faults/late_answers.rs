//! Seen: a late answer to the question of another program for the colours opened an entry with
//! `e1e/1e1e` in it; on the question about kept edits its letters answered.
//!
//! Cause: only a few kinds of sequences were known, and the rest of an unknown one were keys.

use crate::toy::toy;

#[test]
fn what_the_terminal_says_of_itself_is_no_key() {
    let pty = toy().start();
    pty.wait_for("count 0");
    for answer in [
        "\x1b]11;rgb:1e1e/1e1e/1e1e\x1b\\",
        "\x1b]11;rgb:1e1e/1e1e/1e1e\x07",
        "\x1bP>|XTerm(370)\x1b\\",
        "\x1b_Gi=31;OK\x1b\\",
        "\x1b^quit\x1b\\",
        "\x1bXquit\x1b\\",
        "\x1b[?64;1;2;6;9;15;18;21;22c",
        "\x1b[24;80R",
        "\x1b[?2026;2$y",
        "\x1b[8;24;80t",
    ] {
        assert_eq!(pty.cost_of(answer), 0, "{answer:?}: {}", pty.dump());
    }
    pty.send("+");
    pty.wait_for("count 1");
}
