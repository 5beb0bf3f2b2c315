//! Progress with the time left on standard error, and Ctrl+C, for commands that take their time.
//!
//! On a terminal one line is written over and over and taken away at the end; elsewhere a line comes
//! now and then and one at the end.

use super::output::say;
use crate::dem::Flow;
use crate::job::pace::{Pace, duration};
use crate::study::clock::wall_seconds;
use crate::study::ensemble::EnsembleProgress;
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// Columns of the line on a terminal.
const WIDTH: usize = 78;

/// Watches over one or several ensembles.
pub(crate) struct Watch {
    cancel: Arc<AtomicBool>,
    terminal: bool,
    start: f64,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    /// What is being made.
    label: String,
    /// How much of it is done.
    pace: Pace,
    /// When something was said last, s; nothing yet if missing.
    said: Option<f64>,
}

impl Watch {
    /// Starts to watch, and to listen for Ctrl+C: the first one asks for an early end, a second one
    /// ends the process.
    pub(crate) fn start() -> Watch {
        let cancel = Arc::new(AtomicBool::new(false));
        listen(&cancel);
        Watch {
            cancel,
            terminal: io::stderr().is_terminal(),
            start: wall_seconds(),
            state: Mutex::new(State::default()),
        }
    }

    /// Whether the user asked for an early end.
    pub(crate) fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }

    /// Goes on to part `part` of `parts`, whose runs are expected to end at `end` (m).
    pub(crate) fn begin(&self, label: &str, part: usize, parts: usize, end: f64) {
        let mut state = self.lock();
        state.label = label.to_string();
        state.pace.begin(part, parts, end);
    }

    /// The same, if this part has not begun yet.
    pub(crate) fn part(&self, label: &str, part: usize, parts: usize, end: f64) {
        let here = self.lock().label == label;
        if !here {
            self.begin(label, part, parts, end);
        }
    }

    /// Takes an ensemble's progress and answers it.
    pub(crate) fn tell(&self, now: EnsembleProgress) -> Flow {
        if self.cancelled() {
            return Flow::Cancel;
        }
        let mut state = self.lock();
        state.pace.take(now.run, now.planned, &now.inner);
        let time = wall_seconds();
        // A first word after a second, then often on a terminal and seldom elsewhere.
        let due = match (state.said, self.terminal) {
            (None, true) => true,
            (None, false) => time - self.start > 1.0,
            (Some(before), terminal) => time - before > if terminal { 0.2 } else { 5.0 },
        };
        if due {
            state.said = Some(time);
            self.say(&state.line(time - self.start, now.run.max(now.done) + 1, now.planned));
        }
        Flow::Continue
    }

    /// Ends: the line goes, or a last one says how long it took.
    pub(crate) fn finish(&self, done: &str) {
        let ended = if self.cancelled() { "ended early by the user" } else { "done" };
        if self.terminal {
            let _ = write!(io::stderr(), "\r{:WIDTH$}\r", "");
        } else {
            say("progress", &format!("{ended}: {done}, {:.1} s", wall_seconds() - self.start));
        }
    }

    fn say(&self, line: &str) {
        if self.terminal {
            let line: String = line.chars().take(WIDTH).collect();
            let mut err = io::stderr().lock();
            // Where nobody listens, nothing happens.
            let _ = write!(err, "\r{line:<WIDTH$}");
            let _ = err.flush();
        } else {
            say("progress", line);
        }
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, State> {
        // Nothing here panics while it holds the lock, and the state stays whole if it did.
        self.state.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl State {
    fn line(&self, elapsed: f64, run: usize, planned: usize) -> String {
        format!(
            "{}: run {} of {planned}, {:.0} %, about {} left",
            self.label,
            run.min(planned),
            100.0 * self.pace.fraction().clamp(1.0e-4, 1.0),
            duration(self.pace.left(elapsed))
        )
    }
}

#[cfg(unix)]
fn listen(cancel: &Arc<AtomicBool>) {
    use signal_hook::consts::SIGINT;
    use signal_hook::flag;
    // The order matters: the flag is set after it was looked at, so only a second signal ends the
    // process. Where no handler can be installed, Ctrl+C ends the process as it always does.
    let code = i32::from(super::output::INTERRUPTED);
    let _ = flag::register_conditional_shutdown(SIGINT, code, Arc::clone(cancel));
    let _ = flag::register(SIGINT, Arc::clone(cancel));
}

#[cfg(not(unix))]
fn listen(_cancel: &Arc<AtomicBool>) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_says_run_part_and_time_left() {
        let mut state = State { label: "check".into(), ..State::default() };
        state.pace.begin(0, 2, 0.5);
        let at = crate::dem::RunProgress {
            deflection: 0.25,
            force: 0.0,
            utilisation: 0.0,
            limit: 1.8,
            steps: 0,
            broken: false,
        };
        state.pace.take(0, 4, &at);
        assert_eq!(state.line(2.0, 1, 4), "check: run 1 of 4, 6 %, about 30 s left");
    }
}
