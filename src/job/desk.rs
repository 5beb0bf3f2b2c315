//! One worker and one waiting slot.
//!
//! - A new order takes the place of the one that waits.
//! - An order that will never begin is given back, so that whoever waits for its end can be told.
//! - An order that was asked for ends the one that runs; one that nobody asked for (live) ends a
//!   running live one, and waits for one that was asked for.
//! - A panic in the work ends that work alone: the worker goes on with the next order.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

/// Whether somebody waits for the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Urgency {
    /// Started by itself after an edit.
    Live,
    /// Asked for by the user.
    Asked,
}

/// What the work looks at to know whether it should end.
#[derive(Debug, Clone, Default)]
pub struct Ticket(Arc<AtomicBool>);

impl Ticket {
    /// Whether the work should end soon.
    pub(crate) fn cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Asks the work to end.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

struct State<J> {
    waiting: Option<(Urgency, J)>,
    running: Option<(Urgency, Ticket)>,
    closed: bool,
}

struct Shared<J> {
    state: Mutex<State<J>>,
    wake: Condvar,
}

impl<J> Shared<J> {
    /// Nothing that holds the lock can panic halfway, so what is in it is whole.
    fn lock(&self) -> MutexGuard<'_, State<J>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The owner's side of the worker. Dropping it ends the work that runs and the worker.
pub(crate) struct Desk<J> {
    shared: Arc<Shared<J>>,
}

impl<J: Send + 'static> Desk<J> {
    /// Starts the worker. `work` does an order and should look at its ticket often; `failed` is told of
    /// one that panicked. Nothing if the system gives no thread.
    pub(crate) fn open(
        work: impl Fn(&J, &Ticket) + Send + 'static,
        failed: impl Fn(&J) + Send + 'static,
    ) -> Option<Desk<J>> {
        let state = State { waiting: None, running: None, closed: false };
        let shared = Arc::new(Shared { state: Mutex::new(state), wake: Condvar::new() });
        let theirs = Arc::clone(&shared);
        let worker = move || {
            step_aside();
            while let Some((job, ticket)) = next(&theirs) {
                // The order is only read; whatever the work left half done is dropped with it.
                if catch_unwind(AssertUnwindSafe(|| work(&job, &ticket))).is_err() {
                    failed(&job);
                }
                theirs.lock().running = None;
            }
        };
        thread::Builder::new().name("worker".into()).spawn(worker).ok()?;
        Some(Desk { shared })
    }

    /// Hands in an order; the one that will not be done for it, be it the new one itself.
    #[must_use]
    pub(crate) fn submit(&self, urgency: Urgency, job: J) -> Option<J> {
        let mut state = self.shared.lock();
        // What was asked for and has not begun yet is not pushed aside by what nobody asked for.
        if urgency == Urgency::Live && matches!(state.waiting, Some((Urgency::Asked, _))) {
            return Some(job);
        }
        if let Some((running, ticket)) = &state.running
            && (urgency == Urgency::Asked || *running == Urgency::Live)
        {
            ticket.cancel();
        }
        let former = state.waiting.replace((urgency, job));
        self.shared.wake.notify_one();
        former.map(|(_, job)| job)
    }

    /// Ends what runs, which tells its end itself, and gives back what waits.
    #[must_use]
    pub(crate) fn cancel(&self) -> Option<J> {
        let mut state = self.shared.lock();
        if let Some((_, ticket)) = &state.running {
            ticket.cancel();
        }
        state.waiting.take().map(|(_, job)| job)
    }
}

impl<J> Drop for Desk<J> {
    fn drop(&mut self) {
        let mut state = self.shared.lock();
        state.closed = true;
        state.waiting = None;
        if let Some((_, ticket)) = &state.running {
            ticket.cancel();
        }
        self.shared.wake.notify_one();
    }
}

impl<J> std::fmt::Debug for Desk<J> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Desk")
    }
}

/// Waits for the next order; nothing when the desk is closed.
fn next<J>(shared: &Shared<J>) -> Option<(J, Ticket)> {
    let mut state = shared.lock();
    loop {
        if state.closed {
            return None;
        }
        if let Some((urgency, job)) = state.waiting.take() {
            let ticket = Ticket::default();
            state.running = Some((urgency, ticket.clone()));
            return Some((job, ticket));
        }
        state = shared.wake.wait(state).unwrap_or_else(PoisonError::into_inner);
    }
}

/// Lets the thread that draws go first where there are few processors: this thread and those that it
/// starts take what is left over.
fn step_aside() {
    #[cfg(target_os = "linux")]
    // SAFETY: the call takes numbers only; 0 is the calling thread on Linux. Being refused is fine.
    unsafe {
        libc::setpriority(libc::PRIO_PROCESS, 0, 5);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::{Receiver, channel};
    use std::time::Duration;

    /// Far beyond what any step here takes; only reached where something hangs.
    const PATIENCE: Duration = Duration::from_secs(20);

    /// A desk whose work says its number when it begins, runs until it is told to end, and says so;
    /// number 0 panics.
    fn desk() -> (Desk<i32>, Receiver<String>) {
        let (send, receive) = channel();
        let failed = send.clone();
        let desk = Desk::open(
            move |job: &i32, ticket: &Ticket| {
                let _ = send.send(format!("begin {job}"));
                assert!(*job != 0, "asked to fail");
                while !ticket.cancelled() {
                    thread::sleep(Duration::from_millis(1));
                }
                let _ = send.send(format!("end {job}"));
            },
            move |job| {
                let _ = failed.send(format!("failed {job}"));
            },
        );
        (desk.unwrap(), receive)
    }

    fn hear(from: &Receiver<String>, expected: &[&str]) {
        for word in expected {
            assert_eq!(from.recv_timeout(PATIENCE).unwrap(), *word);
        }
    }

    #[test]
    fn what_is_asked_for_replaces_what_runs() {
        let (desk, news) = desk();
        assert_eq!(desk.submit(Urgency::Asked, 1), None);
        hear(&news, &["begin 1"]);
        assert_eq!(desk.submit(Urgency::Asked, 2), None);
        hear(&news, &["end 1", "begin 2"]);
        assert_eq!(desk.cancel(), None);
        hear(&news, &["end 2"]);
        drop(desk);
        assert!(news.recv_timeout(PATIENCE).is_err(), "the worker ends and its channel with it");
    }

    #[test]
    fn the_newest_live_order_wins_and_waits_for_what_was_asked_for() {
        let (desk, news) = desk();
        assert_eq!(desk.submit(Urgency::Asked, 1), None);
        hear(&news, &["begin 1"]);
        assert_eq!(desk.submit(Urgency::Live, 2), None);
        for live in 3..6 {
            assert_eq!(desk.submit(Urgency::Live, live), Some(live - 1));
        }
        desk.shared.lock().running.as_ref().unwrap().1.cancel();
        hear(&news, &["end 1", "begin 5"]);
        assert_eq!(desk.submit(Urgency::Live, 6), None);
        hear(&news, &["end 5", "begin 6"]);
        // An order that waits and was asked for is not pushed aside.
        {
            let mut state = desk.shared.lock();
            state.waiting = Some((Urgency::Asked, 7));
        }
        assert_eq!(desk.submit(Urgency::Live, 8), Some(8), "the new one will not be done");
        desk.shared.lock().running.as_ref().unwrap().1.cancel();
        hear(&news, &["end 6", "begin 7"]);
    }

    #[test]
    fn an_order_that_waits_is_given_back_when_all_is_ended() {
        let (desk, news) = desk();
        assert_eq!(desk.submit(Urgency::Asked, 1), None);
        hear(&news, &["begin 1"]);
        desk.shared.lock().waiting = Some((Urgency::Asked, 2));
        assert_eq!(desk.cancel(), Some(2));
        hear(&news, &["end 1"]);
        assert_eq!(desk.cancel(), None);
    }

    #[test]
    fn a_panic_ends_one_order_and_not_the_worker() {
        let (desk, news) = desk();
        assert_eq!(desk.submit(Urgency::Asked, 0), None);
        hear(&news, &["begin 0", "failed 0"]);
        assert_eq!(desk.submit(Urgency::Asked, 1), None);
        hear(&news, &["begin 1"]);
    }
}
