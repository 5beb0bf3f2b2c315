//! The hang-up thread: sleeps until the terminal is gone.
//!
//! SIGHUP says the same, but only to the session's leader and its foreground group; a program in a
//! wrapper that stays behind would never hear of it. Asking for no event at all, `poll` still reports a
//! hang-up, and costs nothing until then.

use super::events::Mail;
use std::io;

/// Starts the thread.
#[cfg(unix)]
pub(super) fn start(mail: Mail) -> io::Result<()> {
    use crate::app::message::Message;
    use rustix::event::{PollFd, PollFlags, poll};
    use rustix::io::Errno;

    std::thread::Builder::new().name("hangup".to_owned()).spawn(move || {
        let terminal = rustix::stdio::stdin();
        loop {
            let mut ends = [PollFd::new(&terminal, PollFlags::empty())];
            match poll(&mut ends, None) {
                Ok(_) => {}
                Err(Errno::INTR) => continue,
                Err(_) => return,
            }
            let seen = ends[0].revents();
            if seen.intersects(PollFlags::HUP | PollFlags::ERR) {
                mail.send(Message::HangUp);
            }
            // Anything else is a system that cannot watch terminals this way.
            return;
        }
    })?;
    Ok(())
}

/// Not watched here.
#[cfg(not(unix))]
pub(super) fn start(_mail: Mail) -> io::Result<()> {
    Ok(())
}
