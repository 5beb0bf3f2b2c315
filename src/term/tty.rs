//! The terminal's two ends: plain writes without the standard library's buffer and lock, because a
//! thread may hold that lock while it waits for a terminal that takes nothing, and the size.

use std::io;

/// Size when the terminal tells none or nonsense.
const DEFAULT_SIZE: (u16, u16) = (80, 24);

/// Columns and rows.
pub(super) fn size() -> (u16, u16) {
    known_size().unwrap_or(DEFAULT_SIZE)
}

/// Columns and rows if the terminal tells them.
pub(super) fn known_size() -> Option<(u16, u16)> {
    raw_size().filter(|(width, height)| *width > 0 && *height > 0)
}

#[cfg(unix)]
fn raw_size() -> Option<(u16, u16)> {
    rustix::termios::tcgetwinsize(rustix::stdio::stdout()).ok().map(|s| (s.ws_col, s.ws_row))
}

#[cfg(not(unix))]
fn raw_size() -> Option<(u16, u16)> {
    crossterm::terminal::size().ok()
}

/// Writes all bytes to the terminal: one `write` unless the terminal takes less.
#[cfg(unix)]
pub(super) fn write_all(mut bytes: &[u8]) -> io::Result<()> {
    use rustix::event::{PollFd, PollFlags, poll};
    use rustix::io::Errno;

    let terminal = rustix::stdio::stdout();
    while !bytes.is_empty() {
        match rustix::io::write(terminal, bytes) {
            Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
            Ok(taken) => bytes = &bytes[taken.min(bytes.len())..],
            Err(Errno::INTR) => {}
            // Another program that shares the terminal may have made it non-blocking.
            Err(Errno::AGAIN) => {
                let mut ends = [PollFd::new(&terminal, PollFlags::OUT)];
                match poll(&mut ends, None) {
                    Ok(_) | Err(Errno::INTR) => {}
                    Err(error) => return Err(error.into()),
                }
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// Writes all bytes to the terminal.
#[cfg(not(unix))]
pub(super) fn write_all(bytes: &[u8]) -> io::Result<()> {
    use std::io::Write;

    let mut terminal = io::stdout();
    terminal.write_all(bytes)?;
    terminal.flush()
}
