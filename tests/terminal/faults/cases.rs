//! Keys made from public reports, `tests/files/cases/*.keys`, played as they stand there: a line is bytes
//! in hexadecimal sent in one piece, `wait SECONDS`, `screen`, or a remark behind `#`.

use crate::program::with_sample;
use crate::pty::{Launch, Pty};
use std::fs;
use std::thread::sleep;
use std::time::Duration;

/// Plays a file of keys on an open program.
fn play(pty: &Pty, name: &str) {
    let text = fs::read_to_string(format!("tests/files/cases/{name}.keys")).unwrap();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            None | Some("#") => {}
            Some("screen") => {
                pty.settle();
            }
            Some("wait") => sleep(Duration::from_secs_f64(words.next().unwrap().parse().unwrap())),
            Some(_) => {
                let bytes = line.split_whitespace().map(|b| u8::from_str_radix(b, 16).unwrap());
                pty.send_bytes(&bytes.collect::<Vec<u8>>());
            }
        }
    }
}

/// The last screen after keys on the sample.
fn played(name: &str) -> String {
    let (launch, _) = with_sample();
    let pty = launch.start();
    pty.wait_for("bench 1");
    play(&pty, name);
    pty.dump()
}

#[test]
fn arrows_that_come_oddly_start_no_check() {
    for name in ["split-right-arrow", "alt-right"] {
        let screen = played(name);
        assert!(!screen.contains("checking") && !screen.contains("DEM"), "{name}: {screen}");
        assert!(screen.contains("bench 1"), "{screen}");
    }
    // The arrow is one: the spacing is edited.
    assert!(played("split-right-arrow").contains("site.ron *"));
}

#[test]
fn a_late_answer_types_nothing() {
    let screen = played("late-osc11-reply");
    assert!(!screen.contains("1e1e") && screen.contains("site.ron *"), "{screen}");
}

#[test]
fn pastes_are_values_or_nothing() {
    let screen = played("paste-on-main");
    assert!(screen.contains("2.75"), "{screen}");
    let screen = played("paste-unbracketed");
    for name in ["bench 1", "bench 2", "portal", "gully", "shelf"] {
        assert!(screen.contains(name), "{screen}");
    }
    assert!(screen.contains("as of a paste") && !screen.contains("site.ron *"), "{screen}");
}

#[test]
fn signs_with_a_selector_leave_no_letters_behind() {
    let launch = Launch::meshcast();
    let path = launch.home().join("p.ron");
    fs::copy("tests/files/cases/names-vs16.ron", &path).unwrap();
    let pty = launch.arg(&path).start();
    pty.wait_for("plain");
    play(&pty, "names-vs16");
    // The selector never reaches the terminal, so nothing of two widths stands there.
    assert!(!String::from_utf8_lossy(&pty.received()).contains('\u{fe0f}'));
    assert!(pty.dump().contains("sensitivity of"), "{}", pty.dump());
}

#[test]
fn a_tilde_is_the_home_directory() {
    let (launch, _) = with_sample();
    let home = launch.home();
    let pty = launch.start();
    pty.wait_for("bench 1");
    play(&pty, "tilde");
    pty.wait_for("saved");
    assert!(home.join("t.ron").is_file());
}
