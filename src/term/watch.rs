//! The watch over the project's file: who holds it, and whether something else changed it.

use super::events::Mail;
use super::program::Host;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

/// Time between two looks.
const PAUSE: Duration = Duration::from_secs(2);

/// Starts the thread; it ends when nobody reads its news any more. Without it the program goes on: a save
/// looks for itself.
pub(super) fn start(host: Arc<dyn Host>, mail: Mail) {
    let work = move || {
        host.tidy();
        loop {
            thread::sleep(PAUSE);
            for news in host.watch() {
                if !mail.send(news) {
                    return;
                }
            }
        }
    };
    let _ = thread::Builder::new().name("watch".to_owned()).spawn(work);
}
