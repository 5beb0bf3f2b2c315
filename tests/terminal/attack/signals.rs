//! Signals and a broken line in every state of the program.

use super::{Chance, number, strangers};
use crate::pty::{Launch, Pty};
use rustix::process::Signal;
use std::fs;
use std::thread::sleep;
use std::time::Duration;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

/// A state of the program: its name, what is typed to come there one after the other, and whether edits are unsaved then.
const STATES: &[(&str, &[&str], bool)] = &[
    ("idle", &[], false),
    ("edited", &[DOWN, EDIT], true),
    ("typing", &[DOWN, EDIT, "2.9"], true),
    ("checking", &["C"], false),
    ("checking, edited", &[DOWN, EDIT, "C"], true),
    ("live", &["l", DOWN, EDIT, RIGHT, RIGHT], true),
    ("saving", &[DOWN, EDIT, "\x13"], true),
    ("exporting", &["e", "\r"], false),
    ("settings", &[":set\r"], false),
    ("asking", &[DOWN, EDIT, "q"], true),
];
const DOWN: &str = "\x1b[B";
const RIGHT: &str = "\x1b[C";
/// L of the first layout.
const EDIT: &str = "2.61\r";
/// What comes faster than anybody types is taken as a paste.
const TYPING: Duration = Duration::from_millis(60);

/// What happens to it.
#[derive(Debug, Clone, Copy)]
enum Blow {
    Signal(Signal),
    Twice,
    Stopped,
    HangUp,
}

const BLOWS: &[Blow] = &[
    Blow::Signal(Signal::HUP),
    Blow::Signal(Signal::TERM),
    Blow::Signal(Signal::INT),
    Blow::Signal(Signal::QUIT),
    Blow::Signal(Signal::ABORT),
    Blow::Twice,
    Blow::Stopped,
    Blow::HangUp,
];

/// Ends as the seconds of grace say that it must, on a machine that others use too.
const PROMPT: Duration = Duration::from_secs(10);

fn strike(pty: &mut Pty, blow: Blow, chance: &mut Chance) {
    match blow {
        Blow::Signal(signal) => pty.signal(signal),
        Blow::Twice => {
            pty.signal(Signal::TERM);
            sleep(Duration::from_micros(chance.below(6_000) as u64));
            pty.try_signal(Signal::TERM);
        }
        Blow::Stopped => {
            pty.signal(Signal::STOP);
            sleep(Duration::from_millis(20));
            pty.signal(Signal::CONT);
            sleep(Duration::from_millis(chance.below(50) as u64));
            pty.signal(Signal::TERM);
        }
        Blow::HangUp => pty.hang_up(),
    }
}

fn one(n: usize) {
    let mut chance = Chance::of_try(n);
    // Every pair comes once in as many tries as there are pairs.
    let (state, keys, dirty) = STATES[n % STATES.len()];
    let blow = BLOWS[(n / STATES.len() + n) % BLOWS.len()];
    let at = format!("{state}, {blow:?}");
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let launch = Launch::meshcast().env("MESHCAST_DATA_DIR", dir.path().join("data"));
    let mut pty = launch.arg("--fidelity").arg("fine").arg(&path).start();
    pty.wait_for("bench 1");
    for part in keys {
        pty.send(part);
        match *part {
            EDIT => pty.wait_for("site.ron *"),
            "\x13" => {}
            _ => sleep(TYPING),
        }
    }
    sleep(Duration::from_micros(
        chance.below(if state == "saving" { 4_000 } else { 200_000 }) as u64
    ));
    strike(&mut pty, blow, &mut chance);
    assert!(pty.ends_within(PROMPT), "{at}: it goes on");
    // Shown where what follows fails.
    println!("{n}: {at}");
    if !matches!(blow, Blow::HangUp) {
        pty.assert_restored();
    }
    let text = fs::read_to_string(&path).unwrap();
    let kept = fs::read_to_string(path.with_file_name(".site.ron.recovery"));
    let saved = text.contains("L: 2.61,");
    assert!(!dirty || saved || kept.is_ok_and(|kept| kept != SAMPLE), "{at}: edits are lost");
    assert!(saved || text == SAMPLE, "{at}: the file is torn:\n{text}");
    let made: Vec<_> =
        strangers(&path).into_iter().filter(|name| !name.starts_with("site-")).collect();
    assert!(state == "exporting" || made.is_empty(), "{at}: {made:?}");
}

fn attack(signals: usize) {
    (0..signals).for_each(one);
    println!("{signals} signals");
}

#[test]
fn fifty_signals() {
    attack(50);
}

#[test]
#[ignore = "minutes"]
fn many_signals() {
    attack(number("MESHCAST_ATTACK_SIGNALS", 480));
}
