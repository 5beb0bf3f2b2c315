//! Progress with the time left on standard error, and Ctrl+C, for commands that take their time.
//!
//! On a terminal one line is written over and over and taken away at the end; elsewhere a line comes
//! now and then and one at the end.

use super::output::say;
use crate::dem::{Flow, Progress};
use crate::study::clock::wall_seconds;
use crate::study::ensemble::EnsembleProgress;
use std::collections::HashMap;
use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, ThreadId};

/// Columns of the line on a terminal.
const WIDTH: usize = 78;

/// Watches over one or several ensembles.
pub struct Watch {
    cancel: Arc<AtomicBool>,
    terminal: bool,
    start: f64,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    /// What is being made, and which part of how many.
    label: String,
    part: usize,
    parts: usize,
    /// Punch displacement at which a run of this part is expected to end, m.
    end: f64,
    /// Of each run of this part, how much is done, 0 to 1.
    runs: Vec<f64>,
    /// The run each thread is at, and its punch displacement.
    threads: HashMap<ThreadId, (usize, f64)>,
    /// When something was said last, s; nothing yet if missing.
    said: Option<f64>,
}

impl Watch {
    /// Starts to watch, and to listen for Ctrl+C: the first one asks for an early end, a second one
    /// ends the process.
    pub fn start() -> Watch {
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
    pub fn cancelled(&self) -> bool {
        self.cancel.load(Ordering::Relaxed)
    }

    /// Goes on to part `part` of `parts`, whose runs are expected to end at `end` (m).
    pub fn begin(&self, label: &str, part: usize, parts: usize, end: f64) {
        let mut state = self.lock();
        state.label = label.to_string();
        (state.part, state.parts, state.end) = (part, parts.max(1), end.max(0.01));
        state.runs.clear();
        state.threads.clear();
    }

    /// The same, if this part has not begun yet.
    pub fn part(&self, label: &str, part: usize, parts: usize, end: f64) {
        let here = self.lock().label == label;
        if !here {
            self.begin(label, part, parts, end);
        }
    }

    /// Takes an ensemble's progress and answers it.
    pub fn tell(&self, now: EnsembleProgress) -> Flow {
        if self.cancelled() {
            return Flow::Cancel;
        }
        let mut state = self.lock();
        state.take(now.run, now.planned, &now.inner);
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
    pub fn finish(&self, done: &str) {
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
        self.state.lock().unwrap_or_else(|e| e.into_inner())
    }
}

impl State {
    fn take(&mut self, run: usize, planned: usize, inner: &Progress) {
        if self.runs.len() < planned {
            self.runs.resize(planned, 0.0);
        }
        let thread = thread::current().id();
        if let Some((before, reached)) = self.threads.insert(thread, (run, inner.deflection))
            && (before != run || reached > inner.deflection)
        {
            // That run is over; the next ones will end about where it did.
            self.end = reached.max(0.01);
            if let Some(done) = self.runs.get_mut(before) {
                *done = 1.0;
            }
        }
        let part = (inner.deflection / self.end).min(0.99);
        if let Some(done) = self.runs.get_mut(run) {
            *done = done.max(part);
        }
    }

    /// How much of everything is done, 0 to 1.
    fn fraction(&self) -> f64 {
        let here = self.runs.iter().sum::<f64>() / self.runs.len().max(1) as f64;
        (self.part as f64 + here) / self.parts.max(1) as f64
    }

    fn line(&self, elapsed: f64, run: usize, planned: usize) -> String {
        let fraction = self.fraction().clamp(1.0e-4, 1.0);
        let left = elapsed * (1.0 - fraction) / fraction;
        format!(
            "{}: run {} of {planned}, {:.0} %, about {} left",
            self.label,
            run.min(planned),
            100.0 * fraction,
            duration(left)
        )
    }
}

/// A time as people say it: `8 s`, `3 min`, `2.5 h`.
fn duration(seconds: f64) -> String {
    if seconds < 99.5 {
        format!("{seconds:.0} s")
    } else if seconds < 99.5 * 60.0 {
        format!("{:.0} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
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

    fn at(deflection: f64) -> Progress {
        Progress { deflection, force: 0.0, utilisation: 0.0, limit: 1.8, steps: 0, broken: false }
    }

    #[test]
    fn the_time_left_follows_what_is_done() {
        let mut state = State { parts: 2, end: 0.5, ..State::default() };
        state.take(0, 4, &at(0.25));
        // Half of the first of four runs of the first of two parts: 1/16.
        assert!((state.fraction() - 1.0 / 16.0).abs() < 1e-12);
        assert_eq!(state.line(2.0, 1, 4), ": run 1 of 4, 6 %, about 30 s left");
        // The first ends where it is when the second begins, and so will the others.
        state.take(1, 4, &at(0.125));
        assert!((state.fraction() - 1.5 / 8.0).abs() < 1e-12);
        assert_eq!(duration(600.0), "10 min");
    }
}
