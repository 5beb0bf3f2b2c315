//! Taking the terminal and giving it back.

use super::tty;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};

/// Alternate screen, cursor hidden, pastes marked as such. The mouse is left to the terminal, so that
/// its own selection keeps working. Attributes are reset first: a terminal that is taken again, after a stop
/// from outside, saves those of the moment for the way back.
const ENTER: &[u8] = b"\x1b[0m\x1b[?1049h\x1b[?25l\x1b[?2004h";

/// The way back, attributes first, and once more behind the alternate screen, which brings saved ones. The screen is cleared before the alternate screen is left, because
/// GNU screen and old consoles may have none and would keep the program's picture.
const LEAVE: &[u8] = b"\x1b[0m\x1b[?2004l\x1b[H\x1b[2J\x1b[?25h\x1b[?1049l\x1b[0m";

/// Whether the terminal is ours now.
static TAKEN: AtomicBool = AtomicBool::new(false);

/// Gives the terminal back as it was: raw mode off, attributes reset, cursor shown, pastes plain,
/// alternate screen left. Does nothing when that has been done, and never fails: quit, error, panic,
/// signals and suspend all come through here, perhaps at once and perhaps without a terminal. Whether it
/// was this call that did it.
pub(crate) fn restore() -> bool {
    let taken = TAKEN.swap(false, Ordering::SeqCst);
    if taken {
        // Both may fail on a terminal that is gone, and then there is nobody to tell.
        let _ = modes::back();
        let _ = tty::write_all(LEAVE);
    }
    taken
}

/// Whether the terminal is ours now.
pub(super) fn is_taken() -> bool {
    TAKEN.load(Ordering::SeqCst)
}

/// Takes the terminal, also when it was taken before: after a stop from outside its modes are unknown.
pub(super) fn take() -> io::Result<()> {
    if TAKEN.swap(true, Ordering::SeqCst) {
        modes::back()?;
    }
    modes::raw()?;
    tty::write_all(ENTER)
}

/// Line editing, echo and signals from keys, switched off and back on.
#[cfg(unix)]
mod modes {
    use rustix::termios::{OptionalActions, Termios, tcgetattr, tcsetattr};
    use std::io;
    use std::sync::{Mutex, PoisonError};

    /// The modes as they were found.
    static FOUND: Mutex<Option<Termios>> = Mutex::new(None);

    pub(super) fn raw() -> io::Result<()> {
        let terminal = rustix::stdio::stdin();
        let mut found = FOUND.lock().unwrap_or_else(PoisonError::into_inner);
        let before = tcgetattr(terminal)?;
        let mut raw = before.clone();
        raw.make_raw();
        tcsetattr(terminal, OptionalActions::Now, &raw)?;
        found.get_or_insert(before);
        Ok(())
    }

    pub(super) fn back() -> io::Result<()> {
        let mut found = FOUND.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(before) = found.take() {
            tcsetattr(rustix::stdio::stdin(), OptionalActions::Now, &before)?;
        }
        Ok(())
    }
}

#[cfg(not(unix))]
mod modes {
    pub(super) use crossterm::terminal::{disable_raw_mode as back, enable_raw_mode as raw};
}

/// Restores the terminal when it goes out of scope.
pub(super) struct Guard;

impl Guard {
    /// Takes the terminal.
    pub(super) fn take() -> io::Result<Guard> {
        let guard = Guard;
        take()?;
        Ok(guard)
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        restore();
    }
}
