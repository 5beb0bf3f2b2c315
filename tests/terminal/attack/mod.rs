//! Attacks on the real program, as whoever pulls a plug or loses a line makes them.
//!
//! `cargo test --test terminal attack::` makes the short forms in a minute;
//! `cargo test --release --test terminal attack:: -- --ignored --nocapture` the long ones, with what they
//! counted. `MESHCAST_ATTACK_KEYS`, `_KILLS`, `_SIGNALS` and `_STEPS` say how many, `MESHCAST_ATTACK_SEED`
//! from which beginning.

mod keys;
mod kills;
mod sessions;
mod signals;

use std::fs;
use std::path::Path;

/// A row of numbers that looks random.
struct Chance(u64);

impl Chance {
    /// A row of its own for one try.
    fn of_try(n: usize) -> Chance {
        Chance(seed().wrapping_mul(7_919).wrapping_add(n as u64))
    }

    fn below(&mut self, limit: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }
}

/// A number from the environment.
fn number(name: &str, default: usize) -> usize {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn seed() -> u64 {
    number("MESHCAST_ATTACK_SEED", 1) as u64
}

/// Files beside a project but for those that may be there: the recovery files and the claim of a session
/// that was killed, and what it had half written, which the next start sweeps.
fn strangers(path: &Path) -> Vec<String> {
    let names = fs::read_dir(path.parent().unwrap()).unwrap();
    names
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| {
            let own = name.starts_with(".site.ron.") || name.starts_with("..site.ron.");
            let known = [".recovery", ".lock", ".saving"].iter().any(|end| name.ends_with(end));
            !(name == "site.ron" || name == "data" || (own && known))
        })
        .collect()
}
