//! The real terminal, its threads and the loop, put together.

use super::cells::Charset;
use super::error::TermError;
use super::events::{self, Event, Mail};
use super::filing::Filing;
use super::guard::{self, Guard};
use super::keeping::Keeping;
use super::painter::Painter;
use super::panic::Hook;
use super::program::{Host, Program};
use super::rescue::Rescue;
use super::run::{Ending, Loop, Stage};
use super::signals::suspend;
use super::workshop::Workshop;
use super::{abort, input, signals, tty, watch};
use std::io::{self, IsTerminal};
use std::sync::Arc;
use std::sync::mpsc::Receiver;
use std::time::Duration;

/// How a session runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SessionOptions {
    /// What the terminal takes.
    pub charset: Charset,
    /// How long edits may stay out of the recovery file; `None` keeps them only at the end.
    pub autosave: Option<Duration>,
    /// Whether the terminal takes OSC 52, or at least passes over it.
    pub clipboard: bool,
}

impl Default for SessionOptions {
    /// UTF-8, edits kept after a second and a half, copies sent.
    fn default() -> SessionOptions {
        SessionOptions {
            charset: Charset::Utf8,
            autosave: Some(Duration::from_millis(1500)),
            clipboard: true,
        }
    }
}

/// An interactive session on this process's terminal. One at a time.
#[derive(Debug)]
pub struct Session {
    mail: Mail,
    events: Receiver<Event>,
    options: SessionOptions,
}

impl Session {
    /// Checks that there is a terminal; nothing is changed on it yet.
    ///
    /// # Errors
    /// There is none, or it cannot be watched.
    pub fn open(options: SessionOptions) -> Result<Session, TermError> {
        if !io::stdin().is_terminal() {
            return Err(TermError::NoTerminal("standard input"));
        }
        if !io::stdout().is_terminal() {
            return Err(TermError::NoTerminal("standard output"));
        }
        let (mail, events) = events::open();
        Ok(Session { mail, events, options })
    }

    /// A way for worker threads to send messages to the program.
    pub fn mail(&self) -> Mail {
        self.mail.clone()
    }

    /// Runs the program until it quits or its terminal is gone. The terminal is as before when this
    /// returns, and also when it does not: on a panic or a signal.
    ///
    /// # Errors
    /// The terminal cannot be read, written or set.
    pub fn run<P: Program>(
        self,
        program: &mut P,
        host: Arc<dyn Host>,
    ) -> Result<Ending, TermError> {
        let Session { mail, events, options } = self;
        let rescue = Arc::new(Rescue::new(Arc::clone(&host)));
        // From here on a signal finds somebody who restores the terminal.
        signals::start(mail.clone(), Arc::clone(&rescue)).map_err(TermError::Setup)?;
        abort::start(Arc::clone(&rescue)).map_err(TermError::Setup)?;
        let hook = Hook::install(mail.clone(), Arc::clone(&rescue));
        let guard = Guard::take().map_err(TermError::Setup)?;
        input::start(mail.clone()).map_err(TermError::Setup)?;
        watch::start(Arc::clone(&host), mail.clone());
        let mut all = Loop {
            program,
            stage: Tty,
            filing: Filing::open(Arc::clone(&host), mail.clone()),
            keeping: Keeping::open(Arc::clone(&host), Arc::clone(&rescue), mail.clone()),
            host: Arc::clone(&host),
            rescue: Arc::clone(&rescue),
            events,
            workshop: Workshop::open(mail),
            painter: Painter::new(options.charset),
            clipboard: options.clipboard,
            autosave: options.autosave,
            size: (0, 0),
            unkept_since: None,
            kept_at: None,
            away: false,
            redraw: true,
            ending: None,
        };
        let (ending, _meter) = all.run();
        // A signal from here on must not end the process before the terminal is given back.
        rescue.settle();
        drop(guard);
        // Waits for files that are being written, with the terminal as it was.
        drop(all);
        host.leave();
        rescue.end();
        drop(hook);
        Ok(ending)
    }
}

/// The process's own terminal.
struct Tty;

impl Stage for Tty {
    fn size(&self) -> (u16, u16) {
        tty::size()
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        // It may have been given back by another thread: the process is about to end.
        if guard::is_taken() { tty::write_all(bytes) } else { Ok(()) }
    }

    fn take(&mut self) -> io::Result<()> {
        guard::take()
    }

    fn suspend(&mut self, group: bool) -> bool {
        if !suspend::possible() {
            return false;
        }
        guard::restore();
        suspend::stop(group);
        true
    }
}
