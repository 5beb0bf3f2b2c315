//! SIGKILL at any moment of loops that edit and save, half of them within milliseconds of a save.

use super::{Chance, number, strangers};
use crate::pty::{Launch, Pty};
use rustix::process::Signal;
use std::fs;
use std::path::Path;
use std::thread::sleep;
use std::time::Duration;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

/// What was seen.
#[derive(Debug, Default)]
struct Count {
    tries: usize,
    saves: usize,
    reported: usize,
    offered: usize,
    halves: usize,
}

/// The nth value that is typed, and the text of the file that holds it.
fn value(n: usize) -> String {
    match n {
        0 => "2.5".to_owned(),
        _ => format!("{}", 2.6 + 0.01 * (n % 100) as f64).chars().take(4).collect(),
    }
}

fn text_of(n: usize) -> String {
    // A number is written as short as it can be.
    let value: f64 = value(n).parse().unwrap();
    SAMPLE.replacen("L: 2.5,", &format!("L: {value},"), 1)
}

fn start(path: &Path) -> Pty {
    let data = path.parent().unwrap().join("data");
    Launch::meshcast().env("MESHCAST_DATA_DIR", data).arg(path).start()
}

/// Whether the screen says that this value is saved.
fn told(pty: &Pty, n: usize) -> bool {
    let screen = pty.dump();
    let shown = format!("spacing {:>9.2}", value(n).parse::<f64>().unwrap());
    let edited = screen.lines().next().is_some_and(|title| title.contains('*'));
    screen.contains(" saved /") && !edited && screen.contains(&shown)
}

/// Edits and saves until the end.
fn kill_one(chance: &mut Chance, aimed: bool, count: &mut Count) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let mut pty = start(&path);
    pty.wait_for("bench 1");
    pty.send("\x1b[B");
    let (last, mut reported) = (1 + chance.below(5), 0);
    for n in 1..=last {
        pty.send(&format!("{}\r", value(n)));
        sleep(Duration::from_millis(4));
        if aimed || chance.below(3) > 0 {
            pty.send("\x13");
            count.saves += 1;
        }
        let pause = match n == last {
            true if aimed => chance.below(4_000),
            // Now and then long enough for edits to be kept.
            true if chance.below(5) == 0 => 1_700_000,
            _ => chance.below(60_000),
        };
        sleep(Duration::from_micros(pause as u64));
        if told(&pty, n) {
            reported = n;
            count.reported += 1;
        }
    }
    pty.signal(Signal::KILL);
    pty.wait_exit();
    count.tries += 1;

    let now = fs::read_to_string(&path).unwrap();
    let held = (0..=last).rev().find(|n| text_of(*n) == now);
    let held = held.unwrap_or_else(|| panic!("the file is torn:\n{now}"));
    assert!(held >= reported, "value {reported} was reported as saved, the file holds {held}");
    assert_eq!(strangers(&path), Vec::<String>::new());
    count.halves += usize::from(halves(dir.path()));
    let kept = fs::read_to_string(path.with_file_name(".site.ron.recovery")).ok();
    let differs = kept.is_some_and(|kept| kept != now);
    let mut next = start(&path);
    next.wait_for("bench 1");
    if differs {
        count.offered += 1;
        next.wait_for("was cut off");
    }
    next.signal(Signal::KILL);
    next.wait_exit();
}

fn halves(dir: &Path) -> bool {
    let mut names = fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().file_name());
    names.any(|name| name.to_string_lossy().ends_with(".saving"))
}

fn attack(kills: usize) {
    let mut count = Count::default();
    for n in 0..kills {
        kill_one(&mut Chance::of_try(n), n % 2 == 0, &mut count);
    }
    println!("{count:?}");
}

#[test]
fn fifty_kills() {
    attack(50);
}

#[test]
#[ignore = "minutes"]
fn many_kills() {
    attack(number("MESHCAST_ATTACK_KILLS", 600));
}
