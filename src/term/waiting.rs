//! Tells that something is still being written to a disk that takes its time.

use super::events::Mail;
use crate::app::message::Message;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Time between two tellings; the first one comes after it, so that a save as it should be tells nothing.
const BEAT: Duration = Duration::from_secs(1);

/// The way to the thread that tells.
#[derive(Debug)]
pub(super) struct Waiting(Sender<bool>);

impl Waiting {
    /// Starts the thread. Without it nothing is told.
    pub(super) fn open(mail: Mail) -> Waiting {
        Waiting::with(BEAT, move |since| {
            mail.send(Message::StillAtFiles { seconds: since.as_secs() });
        })
    }

    fn with(beat: Duration, tell: impl Fn(Duration) + Send + 'static) -> Waiting {
        let (order, orders) = channel::<bool>();
        let work = move || {
            let mut since: Option<Instant> = None;
            loop {
                let next = match since {
                    Some(_) => orders.recv_timeout(beat),
                    None => orders.recv().map_err(|_| RecvTimeoutError::Disconnected),
                };
                match (next, since) {
                    (Ok(begins), _) => since = begins.then(Instant::now),
                    (Err(RecvTimeoutError::Timeout), Some(since)) => tell(since.elapsed()),
                    (Err(_), _) => return,
                }
            }
        };
        // Nobody hears what is sent to a thread that is not there.
        let _ = thread::Builder::new().name("waiting".to_owned()).spawn(work);
        Waiting(order)
    }

    /// Does something and tells of it as long as it has not ended.
    pub(super) fn during<T>(&self, work: impl FnOnce() -> T) -> T {
        let _ = self.0.send(true);
        let done = work();
        let _ = self.0.send(false);
        done
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_takes_its_time_is_told_until_it_ends() {
        let (told, news) = channel();
        let beat = Duration::from_millis(10);
        let waiting = Waiting::with(beat, move |since| {
            let _ = told.send(since);
        });
        // Ends with the third word of it.
        let words: Vec<Duration> = waiting.during(|| news.iter().take(3).collect());
        assert!(words.is_sorted() && words[0] >= beat, "{words:?}");
        // One more can have been on its way; nothing comes of what ends at once.
        drop(waiting);
        assert!(news.iter().count() <= 1);
    }
}
