//! The input thread: blocks on the terminal and sends what it reads.
//!
//! A terminal that is gone makes the library's `read` spin and never return; the loop therefore learns of
//! it from the threads `signals` and `hangup`, and ends the process with this thread in it.

use super::events::Mail;
use super::keys::key_from;
use crate::app::message::Message;
use crossterm::event::{Event as Input, read};
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
        while let Ok(input) = read() {
            if let Some(message) = message_from(input)
                && !last_word.0.send(message)
            {
                break;
            }
        }
    })?;
    Ok(())
}

fn message_from(input: Input) -> Option<Message> {
    match input {
        Input::Key(event) => key_from(event).map(Message::Key),
        Input::Paste(text) => Some(Message::Paste(text)),
        Input::Resize(width, height) if width > 0 && height > 0 => {
            Some(Message::Resize { width, height })
        }
        _ => None,
    }
}
