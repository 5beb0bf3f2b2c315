//! Files are read and written by a thread of their own, so that the loop never waits for a disk.
//!
//! One queue: what was asked for first is done first, and its answer comes as a message. The end of the
//! session waits for it for a while, so that a save is not cut off and an export leaves no draft; what a slow
//! disk keeps waiting is told meanwhile. The recovery
//! file is not part of it but of [`super::keeping`]: it must be written also while a disk keeps this
//! thread waiting.

use super::errands::Errands;
use super::events::Mail;
use super::exports::ExportWanted;
use super::program::Host;
use super::waiting::Waiting;
use crate::app::message::{Command, Message, OpenFailure, SaveFailure};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// What is said of work that ended by a fault of the program.
const BROKE: &str = "a fault of the program: nothing is known of the file";

/// The thread and the way to it.
pub(super) struct Filing {
    host: Arc<dyn Host>,
    errands: Errands<Command>,
}

impl Filing {
    /// Starts the thread; its answers go to `mail`.
    pub(super) fn open(host: Arc<dyn Host>, mail: Mail) -> Filing {
        let theirs = Arc::clone(&host);
        let waiting = Waiting::open(mail.clone());
        let errands = Errands::open("files", move |order| {
            if let Some(message) = waiting.during(|| carry_out(theirs.as_ref(), order)) {
                mail.send(message);
            }
        });
        Filing { host, errands }
    }

    /// No thread.
    #[cfg(test)]
    pub(super) fn on_the_spot(host: Arc<dyn Host>) -> Filing {
        Filing { host, errands: Errands::on_the_spot() }
    }

    /// Hands in an order; its answer, where there is no thread to do it.
    pub(super) fn order(&self, order: Command) -> Option<Message> {
        carry_out(self.host.as_ref(), self.errands.order(order)?)
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
        Command::ReadMethod { path, of } => {
            Message::MethodRead { of: of.clone(), result: host.read_method(path, of) }
        }
        Command::KeepSettings { changed, settings } => {
            Message::KeptAtHome(host.keep_settings(*changed, settings))
        }
        Command::KeepMesh { mesh } => Message::KeptAtHome(host.keep_mesh(mesh).map(Some)),
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
        Command::KeepSettings { .. } | Command::KeepMesh { .. } => {
            Message::KeptAtHome(Err(message))
        }
        Command::ReadMethod { of, .. } => {
            Message::MethodRead { of: of.clone(), result: Err(message) }
        }
        _ => return None,
    })
}
