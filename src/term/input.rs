//! The input thread: waits for the terminal, decodes what it sends and mails it to the loop.
//!
//! It reads whatever is there each time it is told that something is there, so nothing is ever left
//! over; and it sees by itself when the terminal is gone. SIGHUP says the same, but only to the session's
//! leader and its foreground group: a program in a wrapper that stays behind would never hear of it.

use super::events::Mail;
use crate::app::message::Message;
use std::io;
use std::thread;

/// Tells the loop that no key will come any more, however the thread ends.
struct LastWord(Mail);

impl Drop for LastWord {
    fn drop(&mut self) {
        self.0.send(Message::HangUp);
    }
}

/// Starts the thread.
pub(super) fn start(mail: Mail) -> io::Result<()> {
    thread::Builder::new().name("input".to_owned()).spawn(move || {
        let last_word = LastWord(mail);
        listen(&last_word.0);
    })?;
    Ok(())
}

/// Reads until the terminal is gone or nobody takes the mail any more.
#[cfg(unix)]
fn listen(mail: &Mail) {
    use super::bursts::{Bursts, PAUSE};
    use super::decoder::Decoder;
    use std::time::Instant;

    let mut decoder = Decoder::new();
    let mut bursts = Bursts::default();
    let mut chunk = [0; 4096];
    let mut last = Instant::now();
    loop {
        let pause = bursts.waiting().then_some(PAUSE);
        let patience = decoder.patience();
        let wanted = pause.into_iter().chain(patience).min();
        let silence = wanted.map(|wanted| wanted.saturating_sub(last.elapsed()));
        let (mut typed, mut out) = (Vec::new(), Vec::new());
        match terminal::read(silence, &mut chunk) {
            Ok(Some(0)) | Err(_) => return,
            Ok(Some(count)) => {
                last = Instant::now();
                decoder.feed(&chunk[..count], &mut typed);
                bursts.take(typed, last, &mut out);
            }
            Ok(None) => {
                if pause.is_some() {
                    bursts.end_run(last, &mut out);
                } else {
                    decoder.idle(&mut typed);
                    // What follows waits for its own silence.
                    last = Instant::now();
                    bursts.take(typed, last, &mut out);
                }
            }
        }
        if !out.into_iter().all(|message| mail.send(message)) {
            return;
        }
    }
}

/// The terminal's end that is read.
#[cfg(unix)]
mod terminal {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::io::{Errno, read as read_bytes};
    use std::thread::sleep;
    use std::time::Duration;

    /// Empty reads that are believed to be a Ctrl+D, typed while another program had the line edited.
    const MOST_EMPTY: u32 = 20;
    /// Between two of them.
    const BREATH: Duration = Duration::from_millis(10);

    /// Bytes that are there or come within the time: how many, none when the terminal is gone. `None`
    /// when nothing came. Without a time it waits.
    pub(super) fn read(within: Option<Duration>, chunk: &mut [u8]) -> Result<Option<usize>, Errno> {
        let terminal = rustix::stdio::stdin();
        let within = within.and_then(|time| Timespec::try_from(time).ok());
        let mut empty = 0;
        loop {
            let mut ends = [PollFd::new(&terminal, PollFlags::IN)];
            match poll(&mut ends, within.as_ref()) {
                Ok(0) => return Ok(None),
                Ok(_) => {}
                Err(Errno::INTR) => continue,
                Err(error) => return Err(error),
            }
            let gone = ends[0].revents().intersects(PollFlags::HUP | PollFlags::ERR);
            match read_bytes(terminal, &mut *chunk) {
                Ok(0) if !gone && empty < MOST_EMPTY => {
                    empty += 1;
                    sleep(BREATH);
                }
                Ok(count) => return Ok(Some(count)),
                // Another program reads the same terminal, or has made it non-blocking.
                Err(Errno::INTR | Errno::AGAIN) => {}
                Err(error) => return Err(error),
            }
        }
    }
}

/// Reads until the terminal is gone or nobody takes the mail any more.
#[cfg(not(unix))]
fn listen(mail: &Mail) {
    use crossterm::event::{Event, read};

    while let Ok(input) = read() {
        let message = match input {
            Event::Key(event) => super::keys::key_from(event).map(Message::Key),
            Event::Paste(text) => Some(Message::Paste(text)),
            Event::Resize(width, height) if width > 0 && height > 0 => {
                Some(Message::Resize { width, height })
            }
            _ => None,
        };
        if message.is_some_and(|message| !mail.send(message)) {
            return;
        }
    }
}
