//! Seen: of 500 arrows that came at once 340 were taken; the rest waited for the next key.
//!
//! Cause: the terminal was watched for new input by edges and read 1,024 bytes at a time, so that what
//! was left over made no new edge.

use crate::toy::toy;

#[test]
fn a_burst_is_read_to_its_end_without_another_key() {
    for count in [1_023, 1_024, 1_025, 3_000, 9_000] {
        let pty = toy().start();
        pty.wait_for("count 0");
        pty.send(&"+".repeat(count));
        pty.wait_for(&format!("count {count}"));
    }
}
