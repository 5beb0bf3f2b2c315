//! Files are read and written by a thread of their own, so that the loop never waits for a disk.
//!
//! One queue: what was asked for first is done first, and its answer comes as a message. The recovery
//! file is not part of it: it is small, and must be written also while a disk keeps this thread waiting.

use super::events::Mail;
use super::exports::ExportWanted;
use super::program::Host;
use crate::app::message::{Command, Message, OpenFailure, SaveFailure};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::thread;

/// What is said of work that ended by a fault of the program.
const BROKE: &str = "a fault of the program: nothing is known of the file";

/// The thread and the way to it.
pub(super) struct Filing {
    host: Arc<dyn Host>,
    /// None where the system gave no thread: then all is done on the spot.
    queue: Option<Sender<Command>>,
}

impl Filing {
    /// Starts the thread; its answers go to `mail`. It ends when this is dropped and all is done.
    pub(super) fn open(host: Arc<dyn Host>, mail: Mail) -> Filing {
        let (queue, orders) = channel();
        let theirs = Arc::clone(&host);
        let work = move || {
            for order in orders {
                if let Some(message) = carry_out(theirs.as_ref(), order) {
                    mail.send(message);
                }
            }
        };
        let thread = thread::Builder::new().name("files".to_owned()).spawn(work);
        Filing { host, queue: thread.is_ok().then_some(queue) }
    }

    /// No thread.
    #[cfg(test)]
    pub(super) fn on_the_spot(host: Arc<dyn Host>) -> Filing {
        Filing { host, queue: None }
    }

    /// Hands in an order; its answer, where there is no thread to do it.
    pub(super) fn order(&self, order: Command) -> Option<Message> {
        let refused = match &self.queue {
            // A thread that is gone gives the order back.
            Some(queue) => queue.send(order).err()?.0,
            None => order,
        };
        carry_out(self.host.as_ref(), refused)
    }
}

/// Does what was asked for. A panic ends this order alone, and is told as its failure.
fn carry_out(host: &dyn Host, order: Command) -> Option<Message> {
    // The order is only read; whatever was left half done is a file that does not yet have its name.
    match catch_unwind(AssertUnwindSafe(|| answer(host, &order))) {
        Ok(message) => message,
        Err(_) => failed(&order),
    }
}

/// The answer to an order; none to one that has nothing to do with files.
fn answer(host: &dyn Host, order: &Command) -> Option<Message> {
    Some(match order {
        Command::Save { project, path, overwrite } => {
            Message::Saved(host.save(project, path.as_deref(), *overwrite))
        }
        Command::Export { kind, project, edited, layout, unit, path, overwrite } => {
            Message::Exported(host.export(ExportWanted {
                kind: *kind,
                project,
                edited: *edited,
                layout: *layout,
                unit: *unit,
                path: path.as_deref(),
                overwrite: *overwrite,
            }))
        }
        Command::TakeFile { path } => Message::Held(host.take_file(path.as_deref())),
        Command::ListProjects => Message::Projects(host.list()),
        Command::OpenProject { path } => Message::Opened(host.open(path)),
        Command::KeepSettings { changed, settings } => {
            Message::SettingsKept(host.keep_settings(*changed, settings))
        }
        _ => return None,
    })
}

/// The answer to an order that ended by a panic.
fn failed(order: &Command) -> Option<Message> {
    let message = BROKE.to_owned();
    Some(match order {
        Command::Save { path, .. } => Message::Saved(Err(SaveFailure {
            message,
            overwrite_helps: false,
            holder: None,
            path: path.clone(),
        })),
        Command::Export { .. } => Message::Exported(Err(message)),
        Command::ListProjects => Message::Projects(Vec::new()),
        Command::OpenProject { .. } => Message::Opened(Err(OpenFailure { message })),
        Command::KeepSettings { .. } => Message::SettingsKept(Err(message)),
        _ => return None,
    })
}
