//! How much of a number of runs is done, and how long the rest will take.
//!
//! A run's end is not known before it breaks: it is expected where the forecast has it, and once one
//! has ended, where that one did.

use crate::dem::RunProgress;
use std::collections::HashMap;
use std::thread::{self, ThreadId};
use std::time::Duration;

/// Least time between two words of progress: four a second.
pub(crate) const QUIET: Duration = Duration::from_millis(250);

/// Counts what is done. Runs belong to parts, as the layouts of a project.
#[derive(Debug, Default)]
pub(crate) struct Pace {
    part: usize,
    parts: usize,
    /// Punch displacement at which a run of this part is expected to end, m.
    end: f64,
    /// Of each run of this part, how much is done, 0 to 1.
    runs: Vec<f64>,
    /// The run each thread is at, and its punch displacement.
    threads: HashMap<ThreadId, (usize, f64)>,
}

impl Pace {
    /// Goes on to part `part` of `parts`, whose runs are expected to end at `end` (m).
    pub(crate) fn begin(&mut self, part: usize, parts: usize, end: f64) {
        (self.part, self.parts, self.end) = (part, parts.max(1), end.max(0.01));
        self.runs.clear();
        self.threads.clear();
    }

    /// Takes the progress of a run on the thread that calls.
    pub(crate) fn take(&mut self, run: usize, planned: usize, inner: &RunProgress) {
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
    pub(crate) fn fraction(&self) -> f64 {
        let here = self.runs.iter().sum::<f64>() / self.runs.len().max(1) as f64;
        (self.part as f64 + here) / self.parts.max(1) as f64
    }

    /// Time left after so many seconds, s.
    pub(crate) fn left(&self, elapsed: f64) -> f64 {
        let fraction = self.fraction().clamp(1.0e-4, 1.0);
        elapsed * (1.0 - fraction) / fraction
    }
}

/// A time as people say it: `8 s`, `3 min`, `2.5 h`.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 99.5 {
        format!("{seconds:.0} s")
    } else if seconds < 99.5 * 60.0 {
        format!("{:.0} min", seconds / 60.0)
    } else {
        format!("{:.1} h", seconds / 3600.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(deflection: f64) -> RunProgress {
        RunProgress {
            deflection,
            force: 0.0,
            utilisation: 0.0,
            limit: 1.8,
            steps: 0,
            broken: false,
        }
    }

    #[test]
    fn the_time_left_follows_what_is_done() {
        let mut pace = Pace::default();
        pace.begin(0, 2, 0.5);
        pace.take(0, 4, &at(0.25));
        // Half of the first of four runs of the first of two parts: 1/16.
        assert!((pace.fraction() - 1.0 / 16.0).abs() < 1e-12);
        assert!((pace.left(2.0) - 30.0).abs() < 1e-9);
        // The first ends where it is when the second begins, and so will the others.
        pace.take(1, 4, &at(0.125));
        assert!((pace.fraction() - 1.5 / 8.0).abs() < 1e-12);
        assert_eq!(duration(30.4), "30 s");
        assert_eq!(duration(600.0), "10 min");
    }
}
