//! The recovery file is written by a thread of its own, for a disk may keep whoever writes to it waiting.
//! What is wanted is done in its order; what cannot be kept is told by a message.
//!
//! The end that nobody asked for writes it on the spot, see [`Rescue::keep`].

use super::errands::Errands;
use super::events::Mail;
use super::program::Host;
use super::rescue::Rescue;
use crate::app::message::Message;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is to be done about the recovery file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Errand {
    /// Write what is unsaved, if that is not what stands there, or if its file has gone.
    Keep,
    /// Write what is unsaved in any case.
    KeepAnew,
    /// Remove it.
    Forget,
    /// Remove it, and tell where that failed.
    ForgetAloud,
}

/// The thread and the way to it.
#[derive(Debug)]
pub(super) struct Keeping {
    keeper: Arc<Keeper>,
    errands: Errands<Errand>,
}

struct Keeper {
    host: Arc<dyn Host>,
    rescue: Arc<Rescue>,
    /// An errand waits that will write whatever is unsaved by then: another one would do the same.
    waits: AtomicBool,
}

impl std::fmt::Debug for Keeper {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Keeper")
    }
}

impl Keeping {
    /// Starts the thread; what it has to tell goes to `mail`.
    pub(super) fn open(host: Arc<dyn Host>, rescue: Arc<Rescue>, mail: Mail) -> Keeping {
        let keeper = Arc::new(Keeper { host, rescue, waits: AtomicBool::new(false) });
        let theirs = Arc::clone(&keeper);
        let errands = Errands::open("recovery", move |errand| {
            if let Some(message) = theirs.carry_out(errand) {
                mail.send(message);
            }
        });
        Keeping { keeper, errands }
    }

    /// No thread.
    #[cfg(test)]
    pub(super) fn on_the_spot(host: Arc<dyn Host>, rescue: Arc<Rescue>) -> Keeping {
        let keeper = Arc::new(Keeper { host, rescue, waits: AtomicBool::new(false) });
        Keeping { keeper, errands: Errands::on_the_spot() }
    }

    /// Has what is unsaved written, where that is not done; what to tell, where there is no thread.
    pub(super) fn keep(&self) -> Option<Message> {
        if self.keeper.waits.swap(true, Ordering::SeqCst) {
            return None;
        }
        self.order(Errand::Keep)
    }

    /// The same in any case: the place of the recovery file may be another one.
    pub(super) fn keep_anew(&self) -> Option<Message> {
        self.order(Errand::KeepAnew)
    }

    /// Has the recovery file removed. One that stays would be offered at the next start, and refused or
    /// taken there.
    pub(super) fn forget(&self) {
        self.order(Errand::Forget);
    }

    /// The same, as the user has asked for it; what to tell, where there is no thread.
    pub(super) fn forget_aloud(&self) -> Option<Message> {
        self.order(Errand::ForgetAloud)
    }

    fn order(&self, errand: Errand) -> Option<Message> {
        self.keeper.carry_out(self.errands.order(errand)?)
    }
}

impl Keeper {
    fn carry_out(&self, errand: Errand) -> Option<Message> {
        match errand {
            Errand::Keep => {
                self.waits.store(false, Ordering::SeqCst);
                let done = !self.rescue.pending() && self.host.recovery_stands();
                if done { None } else { self.keep() }
            }
            Errand::KeepAnew => self.keep(),
            Errand::Forget => {
                let _ = self.host.forget_recovery();
                None
            }
            Errand::ForgetAloud => {
                let why = self.host.forget_recovery().err()?;
                Some(Message::Trouble(format!("the recovery file could not be removed: {why}")))
            }
        }
    }

    fn keep(&self) -> Option<Message> {
        let kept = self.rescue.keep()?;
        // Saved or undone while it was written: nobody will ask for its removal any more.
        if self.rescue.is_clean() {
            let _ = self.host.forget_recovery();
        }
        let why = kept.err()?;
        let said = "unsaved edits could not be kept in the recovery file";
        Some(Message::Trouble(format!("{said}: {why}")))
    }
}
