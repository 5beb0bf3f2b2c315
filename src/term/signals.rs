//! The signal thread: turns signals into events, and sees the program off when the loop cannot.

use super::events::Mail;
use super::rescue::Rescue;
#[cfg(unix)]
use crate::app::message::Message;
use std::io;
use std::sync::Arc;

/// Starts the thread.
#[cfg(unix)]
pub(super) fn start(mail: Mail, rescue: Arc<Rescue>) -> io::Result<()> {
    use signal_hook::iterator::Signals;
    use std::thread;

    let mut signals = Signals::new(heard::all())?;
    thread::Builder::new().name("signals".to_owned()).spawn(move || {
        let mut ending = false;
        for signal in signals.forever() {
            match heard::meaning(signal) {
                heard::Meaning::Tell(event) => {
                    event.into_iter().for_each(|event| {
                        mail.event(event);
                    });
                }
                heard::Meaning::End if rescue.is_over() => see_out(signal),
                heard::Meaning::End => {
                    mail.send(Message::HangUp);
                    if !ending {
                        ending = true;
                        see_off(Arc::clone(&rescue));
                    }
                }
            }
        }
    })?;
    Ok(())
}

/// Signals that are heard, and what they mean here.
#[cfg(unix)]
mod heard {
    use super::super::events::Event;
    use super::super::tty;
    use super::suspend;
    use crate::app::message::Message;
    use signal_hook::consts::*;

    /// Signals that end a process which does not hear them, but for those that only a fault of the
    /// process itself brings. None may leave the terminal raw or lose edits.
    const ENDING: &[i32] = &[
        SIGHUP, SIGTERM, SIGINT, SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGPROF, SIGVTALRM, SIGXCPU,
        SIGIO,
    ];
    /// Failing power, which Linux alone tells.
    #[cfg(target_os = "linux")]
    const ENDING_HERE: &[i32] = &[libc::SIGPWR];
    #[cfg(not(target_os = "linux"))]
    const ENDING_HERE: &[i32] = &[];

    pub(super) enum Meaning {
        /// Something to tell the loop, if anything.
        Tell(Option<Event>),
        /// The program is to end.
        End,
    }

    pub(super) fn all() -> Vec<i32> {
        // A file that grows too large is an error of that write, and told as one.
        let telling = [SIGTSTP, SIGCONT, SIGWINCH, SIGXFSZ];
        let mut all = [ENDING, ENDING_HERE, &telling].concat();
        all.extend(real_time());
        all
    }

    /// Signals without a meaning of their own; they end a process like the others.
    #[cfg(target_os = "linux")]
    fn real_time() -> impl Iterator<Item = i32> {
        libc::SIGRTMIN()..=libc::SIGRTMAX()
    }

    #[cfg(not(target_os = "linux"))]
    fn real_time() -> impl Iterator<Item = i32> {
        std::iter::empty()
    }

    pub(super) fn meaning(signal: i32) -> Meaning {
        Meaning::Tell(match signal {
            SIGTSTP if suspend::is_own() => None,
            SIGTSTP => Some(Event::Stop),
            SIGCONT => Some(Event::Continue),
            SIGWINCH => tty::known_size()
                .map(|(width, height)| Event::Message(Message::Resize { width, height })),
            SIGXFSZ => None,
            _ => return Meaning::End,
        })
    }
}

/// No signals here.
#[cfg(not(unix))]
pub(super) fn start(_mail: Mail, _rescue: Arc<Rescue>) -> io::Result<()> {
    Ok(())
}

/// Ends a process whose session is over, and all is in order, as the signal would have done, but not
/// before it had the time to end by itself: a line that drops is noticed by what is read from it and told by
/// a signal, in either order, and the status told to a shell should be the same.
#[cfg(unix)]
fn see_out(signal: i32) {
    use signal_hook::low_level::emulate_default_handler;
    use std::thread;
    use std::time::Duration;

    /// Time for the last words and the end of the process.
    const LEAVE: Duration = Duration::from_millis(500);

    let waiting = thread::Builder::new().name("see-out".to_owned()).spawn(move || {
        thread::sleep(LEAVE);
        let _ = emulate_default_handler(signal);
    });
    if waiting.is_err() {
        let _ = emulate_default_handler(signal);
    }
}

/// Ends the process when the loop has not done so in good time: it may be waiting for a terminal that
/// takes no more output, or for a disk.
#[cfg(unix)]
fn see_off(rescue: Arc<Rescue>) {
    use super::guard;
    use std::time::Duration;
    use std::{process, thread};

    /// Time for the loop to end by itself.
    const GRACE: Duration = Duration::from_secs(5);
    /// Time for the terminal to take the few bytes that restore it.
    const FAREWELL: Duration = Duration::from_millis(300);

    // Without this thread the loop still ends, if it can.
    let _ = thread::Builder::new().name("see-off".to_owned()).spawn(move || {
        thread::sleep(GRACE);
        if rescue.is_over() {
            return;
        }
        // A failure has nowhere to be shown: the terminal is stuck or gone.
        let _ = rescue.keep();
        let _ = thread::Builder::new().spawn(guard::restore);
        thread::sleep(FAREWELL);
        process::exit(1);
    });
}

/// Stopping and being continued.
#[cfg(unix)]
pub(super) mod suspend {
    use rustix::process::{Signal, getpgrp, getsid, kill_current_process_group};
    use signal_hook::consts::SIGSTOP;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// A SIGTSTP that this program sent to its own group is on its way.
    static OWN: AtomicBool = AtomicBool::new(false);

    pub(super) fn is_own() -> bool {
        OWN.swap(false, Ordering::SeqCst)
    }

    /// Whether a shell is there to continue us. The shell that started the session gives each job a
    /// group of its own; a program in the group of the session's leader is nobody's job, and stopped
    /// it would stay so.
    pub(in crate::term) fn possible() -> bool {
        getsid(None).is_ok_and(|session| session != getpgrp())
    }

    /// Stops the process, and with `group` what was started with it, such as a `cargo run` around it:
    /// the shell waits for all of them. Returns when continued.
    pub(in crate::term) fn stop(group: bool) {
        if group {
            OWN.store(true, Ordering::SeqCst);
            if kill_current_process_group(Signal::TSTP).is_err() {
                OWN.store(false, Ordering::SeqCst);
            }
        }
        // Cannot fail: the signal exists and a process may stop itself.
        let _ = signal_hook::low_level::raise(SIGSTOP);
    }
}

/// No job control here.
#[cfg(not(unix))]
pub(super) mod suspend {
    /// Never.
    pub(in crate::term) fn possible() -> bool {
        false
    }

    /// Does nothing.
    pub(in crate::term) fn stop(_group: bool) {}
}
