//! Seen: after SIGSTOP and SIGCONT, and then the end, the shell's own text was bold or coloured.
//!
//! Cause: the terminal is taken a second time when the program goes on. Entering the alternate screen saves
//! the attributes of that moment, and leaving it brings them back.

use crate::program::with_sample;
use rustix::process::Signal;

#[test]
fn no_attributes_are_left_after_a_stop_from_outside() {
    for _ in 0..3 {
        let (launch, _) = with_sample();
        let mut pty = launch.start();
        pty.wait_for("bench 1");
        pty.settle();
        pty.signal(Signal::STOP);
        pty.signal(Signal::CONT);
        pty.settle();
        pty.signal(Signal::TERM);
        pty.wait_exit();
        pty.assert_restored();
    }
}
