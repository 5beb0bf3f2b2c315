//! Files that a command writes: whole or not at all, also where a signal comes in between.

use crate::project::{self, Overwrite, SaveError};
use std::path::Path;

/// Writes a text, see [`project::write_file`].
pub(crate) fn write_file(path: &Path, text: &str, overwrite: Overwrite) -> Result<(), SaveError> {
    held::through(|| {
        project::sweep_beside(path);
        project::write_file(path, text, overwrite)
    })
}

/// Makes a new file.
pub(crate) fn create(path: &Path, text: &str) -> Result<(), SaveError> {
    write_file(path, text, Overwrite::No)
}

/// Signals that end a program, held while a file is written: it takes some milliseconds, and a program that
/// ended in the middle of them would leave a draft behind.
#[cfg(unix)]
mod held {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    use signal_hook::flag;
    use signal_hook::low_level::emulate_default_handler;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

    /// Does some work; a signal that came meanwhile has its usual effect after it, and a second one at once,
    /// for the disk may not answer.
    pub(super) fn through<T>(work: impl FnOnce() -> T) -> T {
        let (free, came) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(0)));
        for signal in [SIGHUP, SIGINT, SIGQUIT, SIGTERM].into_iter().filter(|s| !ignored(*s)) {
            // In this order, so that only the second one finds the flag set. Where no handler can be installed,
            // a signal ends the program as it always does.
            let _ = flag::register_conditional_default(signal, Arc::clone(&free));
            let _ = flag::register(signal, Arc::clone(&free));
            let _ = flag::register_usize(signal, Arc::clone(&came), signal as usize);
        }
        let done = work();
        free.store(true, Ordering::SeqCst);
        if let Ok(signal @ 1..) = i32::try_from(came.load(Ordering::SeqCst)) {
            let _ = emulate_default_handler(signal);
        }
        done
    }

    /// Whether whoever started this process wants a signal to mean nothing, as `nohup` does of a hang-up.
    fn ignored(signal: i32) -> bool {
        // SAFETY: all zeroes is a `sigaction` of plain numbers and pointers; without a new one the call only
        // writes the present one into it.
        let now = unsafe {
            let mut now: libc::sigaction = std::mem::zeroed();
            match libc::sigaction(signal, std::ptr::null(), &raw mut now) {
                0 => now.sa_sigaction,
                _ => libc::SIG_DFL,
            }
        };
        now == libc::SIG_IGN
    }

    /// Seen in the code: a command under `nohup` was ended by a hang-up once it had written a file. A hang-up
    /// cannot be ignored here for one test alone, but Rust's runtime ignores a pipe that nobody reads.
    #[cfg(test)]
    #[test]
    fn a_signal_that_is_to_mean_nothing_is_known() {
        assert!(ignored(libc::SIGPIPE));
        assert!(!ignored(libc::SIGUSR2));
    }
}

#[cfg(not(unix))]
mod held {
    pub(super) fn through<T>(work: impl FnOnce() -> T) -> T {
        work()
    }
}
