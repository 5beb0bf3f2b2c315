//! Two sessions of one file that edit, save, take over, read anew, are killed and come back, often at the
//! same moment. One changes L, the other D, and neither ever says that the other's file may be replaced:
//! so what each was last told as saved must stand in the file.

use super::{Chance, number};
use crate::pty::{Launch, Pty};
use rustix::process::Signal;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::Duration;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

/// A session and its field.
struct User {
    name: &'static str,
    path: PathBuf,
    /// Keys that select the field, as it is from the top.
    down: usize,
    /// What stands before the value on the screen and in the file.
    label: &'static str,
    word: &'static str,
    /// Least value that is typed, and the last one; hundredths.
    least: usize,
    typed: usize,
    /// What was last reported as saved.
    saved: Option<usize>,
    pty: Pty,
}

/// What came of a save.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Outcome {
    Saved,
    Held,
    Changed,
}

fn start(path: &Path, name: &str, down: usize) -> Pty {
    let data = path.parent().unwrap().join("data");
    let launch = Launch::meshcast().env("MESHCAST_DATA_DIR", data).env("USER", name);
    let pty = launch.size(100, 30).arg(path).start();
    pty.wait_for("bench 1");
    quiet(&pty);
    // Edits that a killed session left: this attack is about what was saved.
    while pty.dump().contains("was cut off") {
        pty.send("d");
        quiet(&pty);
    }
    pty.send(&"\x1b[B".repeat(down));
    pty
}

/// Waits until what was sent is drawn: a terminal may be quiet because it has not begun.
fn quiet(pty: &Pty) {
    sleep(Duration::from_millis(150));
    pty.settle();
}

impl User {
    fn pause(&self) {
        quiet(&self.pty);
    }

    fn edit(&mut self, chance: &mut Chance) {
        self.typed = loop {
            let value = self.least + chance.below(140);
            if !value.is_multiple_of(10) && value != self.typed {
                break value;
            }
        };
        self.pty.send(&format!("{:.2}\r", self.value()));
        self.pty.wait_for("site.ron *");
    }

    fn value(&self) -> f64 {
        self.typed as f64 / 100.0
    }

    fn outcome(&self) -> Outcome {
        let found = |screen: &str| {
            // What is said of a save may be said over by who has taken the file meanwhile.
            let edited = screen.lines().next().is_some_and(|title| title.contains('*'));
            match () {
                () if screen.contains("── File held by another") => Some(Outcome::Held),
                () if screen.contains("── File changed on disk") => Some(Outcome::Changed),
                () if !edited => Some(Outcome::Saved),
                () => None,
            }
        };
        self.pty.wait_until("the end of a save", |screen| found(&screen.contents()).is_some());
        found(&self.pty.dump()).unwrap()
    }

    /// Follows a save to its end; what it was taken for.
    fn follow(&mut self, chance: &mut Chance) {
        loop {
            match self.outcome() {
                Outcome::Saved => {
                    self.saved = Some(self.typed);
                    return;
                }
                Outcome::Held if chance.below(2) == 0 => {
                    self.pty.send("t");
                    self.pause();
                }
                Outcome::Held => {
                    self.pty.send("\x1b");
                    self.pause();
                    return;
                }
                Outcome::Changed => {
                    self.pty.send("r");
                    self.pause();
                    return;
                }
            }
        }
    }

    fn die_and_come_back(&mut self) {
        self.pty.signal(Signal::KILL);
        self.pty.wait_exit();
        self.pty = start(&self.path, self.name, self.down);
    }

    /// Reads the file anew, letting its own edits go.
    fn reload(&mut self) {
        self.pty.send(":reload\r");
        self.pause();
        if self.pty.dump().contains("lets them go") {
            self.pty.send("d");
            self.pause();
        }
    }

    fn check(&self, text: &str) {
        if let Some(saved) = self.saved {
            let held = format!("{}: {},", self.word, saved as f64 / 100.0);
            assert!(text.contains(&held), "{} was told that {held} is saved:\n{text}", self.name);
        }
    }
}

fn attack(steps: usize) {
    let mut chance = Chance::of_try(0);
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let user = |name, down, label, word, least| {
        let pty = start(&path, name, down);
        User { name, path: path.clone(), down, label, word, least, typed: 0, saved: None, pty }
    };
    let mut users = [user("anna", 1, "spacing", "L", 251), user("bert", 2, "block", "D", 51)];
    let (mut at_once, mut both) = (0, 0);
    for _ in 0..steps {
        let who = chance.below(2);
        match chance.below(8) {
            0 => users[who].die_and_come_back(),
            1 => users[who].reload(),
            2 => {
                users[who].pty.send(":own\r");
                users[who].pause();
            }
            3..=5 => {
                for user in &mut users {
                    user.edit(&mut chance);
                }
                users[who].pty.send("\x13");
                sleep(Duration::from_micros(chance.below(3_000) as u64));
                users[1 - who].pty.send("\x13");
                at_once += 1;
                let before = users.each_ref().map(|user| user.saved);
                for user in &mut users {
                    user.follow(&mut chance);
                }
                both += usize::from(users.iter().zip(before).all(|(u, old)| u.saved != old));
            }
            _ => {
                users[who].edit(&mut chance);
                users[who].pty.send("\x13");
                users[who].follow(&mut chance);
            }
        }
        let text = fs::read_to_string(&path).unwrap();
        for user in &users {
            user.check(&text);
            assert!(user.pty.dump().contains(user.label), "{}", user.pty.dump());
        }
    }
    println!(
        "{steps} steps, {at_once} times two saves at once, {both} times both saved in the end"
    );
}

#[test]
fn two_sessions() {
    attack(12);
}

#[test]
#[ignore = "minutes"]
fn two_sessions_for_long() {
    attack(number("MESHCAST_ATTACK_STEPS", 200));
}
