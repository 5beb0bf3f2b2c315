//! A thread that does errands, one after the other, so that the loop never waits for a disk.
//!
//! Where the system gives no thread, each errand is given back and done on the spot.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Duration;

/// How long the end of a session waits for errands that are under way: much longer than a file takes to
/// be written, and short for somebody whose disk does not answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// The way to the thread. Dropping it lets the thread do what it was given, and waits for that.
#[derive(Debug)]
pub(super) struct Errands<J> {
    queue: Option<Sender<J>>,
    /// Closed by the thread's end.
    end: Option<Receiver<()>>,
}

impl<J: Send + 'static> Errands<J> {
    /// Starts a thread of a name.
    pub(super) fn open(name: &str, mut work: impl FnMut(J) + Send + 'static) -> Errands<J> {
        let (queue, orders) = channel();
        let (ending, end) = channel::<()>();
        let all = move || {
            for order in orders {
                work(order);
            }
            drop(ending);
        };
        match thread::Builder::new().name(name.to_owned()).spawn(all) {
            Ok(_) => Errands { queue: Some(queue), end: Some(end) },
            Err(_) => Errands::on_the_spot(),
        }
    }

    /// No thread.
    pub(super) fn on_the_spot() -> Errands<J> {
        Errands { queue: None, end: None }
    }

    /// Hands in an errand; gives it back where there is no thread to do it.
    pub(super) fn order(&self, order: J) -> Option<J> {
        match &self.queue {
            Some(queue) => queue.send(order).err().map(|refused| refused.0),
            None => Some(order),
        }
    }
}

impl<J> Drop for Errands<J> {
    fn drop(&mut self) {
        drop(self.queue.take());
        if let Some(end) = self.end.take() {
            // Nothing is ever sent: it ends with the thread, or the disk does not answer.
            let _ = end.recv_timeout(PATIENCE);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Arc, Mutex};

    #[test]
    fn what_was_ordered_is_done_before_the_end_and_in_its_order() {
        let done = Arc::new(Mutex::new(Vec::new()));
        let theirs = Arc::clone(&done);
        let errands = Errands::open("test", move |n: u32| {
            thread::sleep(Duration::from_millis(20));
            theirs.lock().unwrap().push(n);
        });
        for n in 0..5 {
            assert_eq!(errands.order(n), None);
        }
        drop(errands);
        assert_eq!(*done.lock().unwrap(), [0, 1, 2, 3, 4]);
    }

    #[test]
    fn an_errand_that_never_ends_does_not_hold_the_end_up() {
        let (open_gate, gate) = channel::<()>();
        let (told, ended) = channel();
        let errands = Errands::open("test", move |()| {
            let _ = gate.recv();
        });
        assert_eq!(errands.order(()), None);
        thread::spawn(move || {
            drop(errands);
            let _ = told.send(());
        });
        ended.recv_timeout(10 * PATIENCE).expect("the end came");
        drop(open_gate);
    }

    #[test]
    fn without_a_thread_an_errand_is_given_back() {
        assert_eq!(Errands::on_the_spot().order(7), Some(7));
    }
}
