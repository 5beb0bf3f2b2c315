//! Work on a disk that may not answer, such as a network drive that has gone.

use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// What some work gives, if it ends in time. Else its thread is left to itself, for nothing can wake whoever
/// waits for a disk, and what it gives then is dropped there.
pub(crate) fn in_time<T: Send + 'static>(
    time: Duration,
    work: impl FnOnce() -> T + Send + 'static,
) -> Option<T> {
    let (tell, told) = channel();
    let work = Arc::new(Mutex::new(Some(work)));
    let take = |work: &Mutex<Option<_>>| work.lock().unwrap_or_else(PoisonError::into_inner).take();
    let theirs = Arc::clone(&work);
    let thread = thread::Builder::new().name("disk".to_owned()).spawn(move || {
        if let Some(work) = take(&theirs) {
            // Nobody listens any more where it came too late.
            let _ = tell.send(work());
        }
    });
    let Ok(thread) = thread else {
        // No thread is to be had: as well as it goes.
        return take(&work).map(|work| work());
    };
    match told.recv_timeout(time) {
        Ok(done) => Some(done),
        Err(RecvTimeoutError::Timeout) => None,
        // A fault of the program in there is one here.
        Err(RecvTimeoutError::Disconnected) => match thread.join() {
            Err(panic) => resume_unwind(panic),
            Ok(()) => None,
        },
    }
}

/// Time that nobody notices.
pub(crate) const MOMENT: Duration = Duration::from_millis(200);

/// Drops something, such as an open file that is to be removed, and waits no longer than a moment for its disk.
pub(crate) fn put_away(what: impl Send + 'static) {
    in_time(MOMENT, move || drop(what));
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn what_comes_too_late_is_dropped_and_a_fault_is_handed_on() {
        struct Told(std::sync::mpsc::Sender<()>);
        impl Drop for Told {
            fn drop(&mut self) {
                let _ = self.0.send(());
            }
        }
        let (tell, told) = channel();
        let (open, gate) = channel::<()>();
        let late = in_time(Duration::from_millis(20), move || {
            let _ = gate.recv();
            Told(tell)
        });
        assert!(late.is_none() && told.try_recv().is_err());
        drop(open);
        told.recv_timeout(Duration::from_secs(60)).expect("it was dropped");
        assert_eq!(in_time(Duration::from_secs(60), || 7), Some(7));
        let fault =
            || in_time(Duration::from_secs(60), || -> u32 { std::panic::panic_any("broke") });
        let caught = catch_unwind(AssertUnwindSafe(fault)).unwrap_err();
        assert_eq!(caught.downcast_ref::<&str>(), Some(&"broke"));
    }
}
