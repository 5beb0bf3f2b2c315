//! A fault in the program: the terminal comes back, the edits are kept, and plain words say so.

use super::events::Mail;
use super::guard;
use super::rescue::Rescue;
use crate::app::message::Message;
use std::backtrace::{Backtrace, BacktraceStatus};
use std::io::Write;
use std::panic::{PanicHookInfo, set_hook, take_hook};
use std::sync::Arc;
use std::thread;

/// What the standard library calls on a panic.
type PanicHook = Box<dyn Fn(&PanicHookInfo<'_>) + Send + Sync + 'static>;

/// Puts the hook in place for as long as it lives.
pub(super) struct Hook {
    previous: Option<PanicHook>,
}

impl Hook {
    /// Call it on the thread of the loop: a fault there ends the program, one elsewhere is reported.
    pub(super) fn install(mail: Mail, rescue: Arc<Rescue>) -> Hook {
        let main = thread::current().id();
        let previous = take_hook();
        set_hook(Box::new(move |info| {
            if thread::current().id() == main {
                last_words(info, &rescue);
            } else {
                mail.send(Message::Trouble(format!(
                    "a part of the program failed and was stopped: {}",
                    describe(info)
                )));
            }
        }));
        Hook { previous: Some(previous) }
    }
}

impl Drop for Hook {
    fn drop(&mut self) {
        // A hook cannot be replaced by a thread that is panicking.
        if !thread::panicking()
            && let Some(previous) = self.previous.take()
        {
            set_hook(previous);
        }
    }
}

fn last_words(info: &PanicHookInfo<'_>, rescue: &Rescue) {
    guard::restore();
    let kept = rescue.keep();
    rescue.end();
    let mut text =
        format!("meshcast stopped because of a fault in the program: {}\n", describe(info));
    text.push_str(&match kept {
        None => "No edits were unsaved.\n".to_owned(),
        Some(Ok(path)) => format!(
            "Unsaved edits are kept in {} and offered when the project is opened again.\n",
            path.display()
        ),
        Some(Err(why)) => format!("Unsaved edits could not be kept: {why}\n"),
    });
    let trace = Backtrace::capture();
    if trace.status() == BacktraceStatus::Captured {
        text.push_str(&trace.to_string());
    }
    // Standard error may be closed; there is nobody else to tell.
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// The panic's message and place in one line.
fn describe(info: &PanicHookInfo<'_>) -> String {
    let payload = info.payload();
    let what = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message");
    match info.location() {
        Some(place) => format!("{what} ({}:{})", place.file(), place.line()),
        None => what.to_owned(),
    }
}
