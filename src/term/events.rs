//! The one channel of the loop.

use crate::app::message::Message;
use std::sync::mpsc::{Receiver, Sender, channel};

/// What travels on the channel.
#[derive(Debug)]
pub(super) enum Event {
    /// For the program's state.
    Message(Message),
    /// Told from outside to stop (SIGTSTP).
    Stop,
    /// Running again after a stop (SIGCONT).
    Continue,
}

/// A way to send messages to the loop, for worker threads; cheap to clone.
#[derive(Debug, Clone)]
pub struct Mail(Sender<Event>);

impl Mail {
    /// Sends a message; `false` when the loop has ended and nobody will read it.
    pub fn send(&self, message: Message) -> bool {
        self.event(Event::Message(message))
    }

    pub(super) fn event(&self, event: Event) -> bool {
        self.0.send(event).is_ok()
    }
}

pub(super) fn open() -> (Mail, Receiver<Event>) {
    let (sender, receiver) = channel();
    (Mail(sender), receiver)
}
