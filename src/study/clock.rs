//! Clocks.

use std::time::Instant;

/// Processor time of this thread, s; time on the wall where the system does not tell.
pub fn thread_seconds() -> f64 {
    #[cfg(unix)]
    {
        let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
        // SAFETY: `time` is a valid place for the answer.
        if unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &raw mut time) } == 0 {
            return time.tv_sec as f64 + 1.0e-9 * time.tv_nsec as f64;
        }
    }
    wall_seconds()
}

/// Seconds since the first call of a clock.
pub(crate) fn wall_seconds() -> f64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}
