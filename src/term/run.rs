//! The loop: waits on the channel, updates the state, carries out effects, draws what changed.

use super::clipboard;
use super::events::Event;
use super::filing::Filing;
use super::keeping::Keeping;
use super::painter::{Meter, Painter};
use super::program::{Host, Program};
use super::rescue::Rescue;
use super::workshop::Workshop;
use crate::app::message::{Command, Message};
use std::collections::VecDeque;
use std::io;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

/// Events taken in one go before the screen is drawn: a key held down costs one frame, but a flood of
/// messages does not freeze the screen.
const BATCH: usize = 256;

/// How the interactive program ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The user quit.
    Quit,
    /// The terminal hung up or a signal ended the program; unsaved edits went to the recovery file.
    HungUp,
}

/// The terminal as the loop sees it.
pub(super) trait Stage {
    /// Columns and rows.
    fn size(&self) -> (u16, u16);
    /// Sends bytes.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Takes the terminal back after a stop.
    fn take(&mut self) -> io::Result<()>;
    /// Gives the terminal back and stops the process, with `group` whatever was started with it; returns
    /// when continued. `false` when there is no shell to continue it and nothing was done.
    fn suspend(&mut self, group: bool) -> bool;
}

/// The loop and all it holds.
pub(super) struct Loop<'a, P, S> {
    pub(super) program: &'a mut P,
    pub(super) stage: S,
    pub(super) host: Arc<dyn Host>,
    pub(super) rescue: Arc<Rescue>,
    pub(super) events: Receiver<Event>,
    pub(super) workshop: Workshop,
    pub(super) filing: Filing,
    pub(super) keeping: Keeping,
    pub(super) painter: Painter,
    /// Whether the terminal may be sent what is to be copied.
    pub(super) clipboard: bool,
    /// How long edits may stay out of the recovery file; `None` leaves it to the program.
    pub(super) autosave: Option<Duration>,
    pub(super) size: (u16, u16),
    pub(super) unkept_since: Option<Instant>,
    /// When the recovery file was written or seen last.
    pub(super) kept_at: Option<Instant>,
    /// Stopped and not yet continued: the terminal is not ours.
    pub(super) away: bool,
    pub(super) redraw: bool,
    pub(super) ending: Option<Ending>,
}

impl<P: Program, S: Stage> Loop<'_, P, S> {
    /// Runs until the program quits or its terminal is gone.
    pub(super) fn run(&mut self) -> (Ending, Meter) {
        self.resize(self.stage.size());
        loop {
            self.keep_if_due();
            self.draw();
            if let Some(ending) = self.ending {
                return (ending, self.painter.meter());
            }
            let Some(event) = self.wait() else { continue };
            self.take(event);
            for _ in 1..BATCH {
                if self.ending.is_some() {
                    break;
                }
                match self.events.try_recv() {
                    Ok(event) => self.take(event),
                    Err(_) => break,
                }
            }
        }
    }

    /// When edits have waited long enough, or the recovery file should be looked for again.
    fn deadline(&self) -> Option<Instant> {
        self.unkept_since.or(self.kept_at)?.checked_add(self.autosave?)
    }

    /// Keeps edits that have waited long enough, however many events there are; and again those whose
    /// recovery file has gone.
    fn keep_if_due(&mut self) {
        if self.deadline().is_none_or(|deadline| Instant::now() < deadline) {
            return;
        }
        self.unkept_since = None;
        self.kept_at = Some(Instant::now());
        let told = self.keeping.keep();
        self.tell(told);
    }

    /// Waits for an event, but no longer than until edits are to be kept.
    fn wait(&mut self) -> Option<Event> {
        let event = match self.deadline() {
            None => self.events.recv().map_err(|_| RecvTimeoutError::Disconnected),
            Some(deadline) => {
                self.events.recv_timeout(deadline.saturating_duration_since(Instant::now()))
            }
        };
        match event {
            Ok(event) => Some(event),
            Err(RecvTimeoutError::Timeout) => None,
            // All senders are gone: nothing will ever come.
            Err(RecvTimeoutError::Disconnected) => {
                self.hang_up();
                None
            }
        }
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Message(Message::HangUp) => self.hang_up(),
            Event::Message(Message::Resize { width, height }) => self.resize((width, height)),
            Event::Message(message) => self.update(message),
            Event::Stop => self.suspend(false),
            Event::Continue => self.resume(),
        }
    }

    /// Gives a message to the program and carries out what it asks for.
    fn update(&mut self, message: Message) {
        let mut messages = VecDeque::from([message]);
        let mut saved = false;
        while let Some(message) = messages.pop_front() {
            saved |= matches!(message, Message::Saved(Ok(_)));
            for effect in self.program.update(message) {
                messages.extend(self.carry_out(effect));
            }
            // With an answer still to come the program may speak of what is no longer there.
            if messages.is_empty() {
                self.note_unsaved(std::mem::take(&mut saved));
            }
        }
    }

    /// Does what was asked for, or has it done; returns what is to be told of it at once.
    fn carry_out(&mut self, effect: Command) -> Vec<Message> {
        let message = match effect {
            Command::Save { .. }
            | Command::Export { .. }
            | Command::ListProjects
            | Command::OpenProject { .. }
            | Command::ReadMethod { .. }
            | Command::TakeFile { .. }
            | Command::KeepSettings { .. }
            | Command::KeepMesh { .. } => self.filing.order(effect),
            Command::Recover { project } => {
                let result = self.host.recover(&project);
                self.rescue.kept(project);
                self.unkept_since = None;
                result
                    .err()
                    .map(|why| Message::Trouble(format!("unsaved edits could not be kept: {why}")))
            }
            Command::ForgetRecovery => self.keeping.forget_aloud(),
            Command::TakeKept => {
                self.host.take_kept();
                None
            }
            Command::DropKept => self.host.drop_kept().map(Message::Kept),
            Command::LetGo => {
                self.host.let_go();
                None
            }
            Command::Suspend => {
                self.suspend(true);
                None
            }
            Command::Work(order) => return self.workshop.order(order),
            Command::StopWork => return self.workshop.stop(),
            Command::Redraw => {
                self.painter.forget();
                self.redraw = true;
                None
            }
            Command::Copy { text } => self.copy(&text),
            Command::TakeOver => {
                // The host drops the former project's recovery file; what is there then belongs to
                // the new one.
                self.rescue.note(None);
                self.host.take_over();
                None
            }
            Command::Quit => {
                self.ending = Some(Ending::Quit);
                None
            }
        };
        message.into_iter().collect()
    }

    /// Sends a text to the terminal's clipboard. The painter need not know: nothing on the screen
    /// changes and the cursor stays.
    fn copy(&mut self, text: &str) -> Option<Message> {
        if !self.clipboard {
            return Some(Message::Trouble("this kind of terminal has no clipboard".to_owned()));
        }
        match clipboard::copy(text) {
            Ok(bytes) => {
                if self.stage.write(&bytes).is_err() {
                    self.hang_up();
                }
                None
            }
            Err(why) => Some(Message::Trouble(why)),
        }
    }

    /// Notes what is unsaved after a message. A save that has ended makes the recovery file pointless,
    /// or, with edits made meanwhile, in need of being written anew: the save may have gone to another
    /// file, whose recovery file is another one.
    fn note_unsaved(&mut self, saved: bool) {
        let unsaved = self.program.unsaved();
        let clean = unsaved.is_none();
        let pointless = self.rescue.note(unsaved);
        if pointless || (saved && clean) {
            self.keeping.forget();
        } else if saved {
            self.kept_at = Some(Instant::now());
            let told = self.keeping.keep_anew();
            self.tell(told);
        }
        if self.rescue.pending() {
            self.unkept_since.get_or_insert_with(Instant::now);
        } else {
            self.unkept_since = None;
        }
        if clean {
            self.kept_at = None;
        }
    }

    fn tell(&mut self, told: Option<Message>) {
        if let Some(message) = told {
            self.update(message);
        }
    }

    /// The end that nobody asked for: what is unsaved is kept whatever the program answers.
    fn hang_up(&mut self) {
        if self.ending.is_some() {
            return;
        }
        for effect in self.program.update(Message::HangUp) {
            if matches!(effect, Command::Recover { .. } | Command::ForgetRecovery) {
                self.carry_out(effect);
            }
        }
        self.rescue.note(self.program.unsaved());
        if self.rescue.pending() {
            // A failure has nowhere to be shown.
            let _ = self.rescue.keep();
        }
        self.ending = Some(Ending::HungUp);
    }

    fn resize(&mut self, size: (u16, u16)) {
        if self.size != size {
            self.size = size;
            self.redraw = true;
            self.update(Message::Resize { width: size.0, height: size.1 });
        }
    }

    fn suspend(&mut self, group: bool) {
        if !self.away && self.stage.suspend(group) {
            // The terminal is taken back when the signal of continuing arrives, however it came.
            self.away = true;
        }
    }

    fn resume(&mut self) {
        self.away = false;
        if self.stage.take().is_err() {
            self.hang_up();
            return;
        }
        self.painter.forget();
        self.redraw = true;
        self.resize(self.stage.size());
        self.update(Message::Resumed);
    }

    fn draw(&mut self) {
        if self.away || self.ending.is_some() {
            return;
        }
        let dirty = self.program.take_dirty();
        if !dirty && !self.redraw {
            return;
        }
        self.redraw = false;
        let Self { program, painter, stage, .. } = self;
        let bytes = painter.paint(self.size, program.look().color, |buffer| program.draw(buffer));
        if !bytes.is_empty() && stage.write(bytes).is_err() {
            self.hang_up();
        }
    }
}

#[cfg(test)]
#[path = "run_tests.rs"]
mod tests;
