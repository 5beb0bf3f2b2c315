//! An end that no panic hook sees: the stack of a thread or the memory is used up, and the process is
//! aborted. The terminal comes back and the edits are kept all the same.
//!
//! The signal finds the thread that brought it in a state in which it may do next to nothing. It wakes
//! another one, which has been there since the start, and waits until that is done, or has taken too
//! long; then the process ends as it was to.

use super::rescue::Rescue;
use std::io;
use std::sync::Arc;

/// Takes care of aborts from now on, as long as the process lives.
///
/// # Errors
/// What the system said.
#[cfg(unix)]
pub(super) fn start(rescue: Arc<Rescue>) -> io::Result<()> {
    use std::io::Read;
    use std::thread;

    let (mut woken, bell) = io::pipe()?;
    thread::Builder::new().name("abort".to_owned()).spawn(move || {
        let mut byte = [0];
        if woken.read_exact(&mut byte).is_ok() {
            last_words(&rescue);
            signal::done();
        }
    })?;
    signal::listen(bell)
}

/// No signals here.
#[cfg(not(unix))]
pub(super) fn start(_rescue: Arc<Rescue>) -> io::Result<()> {
    Ok(())
}

/// The terminal first: keeping may take long.
#[cfg(unix)]
fn last_words(rescue: &Rescue) {
    use super::guard;
    use std::io::Write;

    let taken = guard::restore();
    if rescue.is_over() || !taken {
        return;
    }
    let kept = match rescue.keep() {
        None => "No edits were unsaved.".to_owned(),
        Some(Ok(path)) => format!(
            "Unsaved edits are kept in {} and offered when the project is opened again.",
            path.display()
        ),
        Some(Err(why)) => format!("Unsaved edits could not be kept: {why}"),
    };
    let text = format!("meshcast was ended: its memory or a stack was used up.\n{kept}\n");
    // Standard error may be closed; there is nobody else to tell.
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// What happens in the thread that the signal finds: nothing but calls that are allowed there.
#[cfg(unix)]
mod signal {
    use signal_hook::consts::SIGABRT;
    use signal_hook::low_level::{emulate_default_handler, register};
    use std::io::{self, PipeWriter};
    use std::os::fd::OwnedFd;
    use std::sync::OnceLock;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Rounds of waiting, a hundredth of a second each.
    const ROUNDS: usize = 400;

    /// The way to the thread that is woken. Never closed: a signal may come until the very end.
    static BELL: OnceLock<OwnedFd> = OnceLock::new();
    static DONE: AtomicBool = AtomicBool::new(false);

    pub(super) fn done() {
        DONE.store(true, Ordering::SeqCst);
    }

    pub(super) fn listen(bell: PipeWriter) -> io::Result<()> {
        if BELL.set(bell.into()).is_err() {
            return Ok(());
        }
        // SAFETY: the action calls write, nanosleep, sigaction and raise, and reads statics that are set
        // before; it takes no memory and no lock.
        unsafe { register(SIGABRT, wake_and_wait) }.map(|_| ())
    }

    fn wake_and_wait() {
        if let Some(bell) = BELL.get() {
            let _ = rustix::io::write(bell, &[1]);
            let pause = rustix::thread::Timespec { tv_sec: 0, tv_nsec: 10_000_000 };
            for _ in 0..ROUNDS {
                if DONE.load(Ordering::SeqCst) {
                    break;
                }
                let _ = rustix::thread::nanosleep(&pause);
            }
        }
        let _ = emulate_default_handler(SIGABRT);
    }
}
