//! Random keys, pastes, new sizes and half sequences into the real program: 10,000 bytes of them in a few
//! seconds, or `MESHCAST_ATTACK_KEYS` many.

use super::{Chance, number, seed};
use crate::program::with_sample;
use crate::pty::Pty;
use rustix::process::Signal;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Bytes that a session gets.
const SESSION: usize = 6_000;

const KEYS: &[&str] = &[
    "\x1b[A",
    "\x1b[B",
    "\x1b[C",
    "\x1b[D",
    "\r",
    "\t",
    "\x1b[Z",
    "\x7f",
    "\x1b[3~",
    "\x1b[5~",
    "\x1b[6~",
    "\x1b[H",
    "\x1b[F",
    "\x1bOP",
    " ",
    ">",
    "<",
    "u",
    "U",
    "c",
    "C",
    "l",
    "f",
    "s",
    "w",
    "v",
    "g",
    "o",
    "e",
    "y",
    "Y",
    "O",
    "i",
    "?",
    "a",
    "d",
    "D",
    "r",
    "R",
    "n",
    "m",
    "b",
    "x",
    "p",
    "j",
    "k",
    "h",
    "\x13",
    "\x07",
    "\x0c",
    "\x12",
    "\x01",
    "\x05",
    "\x0b",
    "\x15",
    "\x17",
    "0",
    "1",
    "2",
    "3",
    ".",
    "-",
    "5",
    "9",
    "/",
    "*",
    "+",
    "=",
    "'",
    "{",
    "[",
    "(",
    "\x1b[1;5C",
    "\x1b[1;2A",
    "\x1b[1;3B",
    "\x1bx",
    "\x1b\x1b",
    "J",
    "K",
    "A",
    "N",
    "M",
    "B",
    "P",
    "S",
    "W",
    "V",
    "G",
    "X",
    "t",
    "T",
    "z",
    "Z",
    "q",
];
const LINES: &[&str] = &[
    ":w\r",
    ":w other.ron\r",
    ":w! other.ron\r",
    ":w /dev/full\r",
    ":w /proc/x\r",
    ":w .\r",
    ":set\r",
    ":set fidelity quick\r",
    ":set runs 2\r",
    ":set units mm\r",
    ":set units m\r",
    ":set glyphs ascii\r",
    ":set glyphs braille\r",
    ":set color none\r",
    ":set live on\r",
    ":set live off\r",
    ":set runs 99999999999999999999\r",
    ":export! report r.html\r",
    ":export chart\r",
    ":export table\r",
    ":export nothing\r",
    ":open other.ron\r",
    ":help\r",
    ":\r",
    ":wq!!\r",
    "2.5\r",
    "2750mm\r",
    "1e999\r",
    "nan\r",
    "-1\r",
    "1e-320\r",
    "0\r",
    "2,5\r",
    "99999999999999999999999\r",
    "3.0000000001\r",
    "14.9\r",
];
const PASTES: &[&[u8]] = &[
    b"hello",
    b"2.5",
    b"\n\n\n",
    b"\x1b[31mred",
    b"\x1b]52;c;eA==\x07",
    "\u{202e}abc\u{200f}".as_bytes(),
    b"\xff\xfe\x80",
    b"\0\0\0",
    b"x\r\ny",
    b"\x9b2J",
    b"\xc2\x9b2J",
];
const HALVES: &[&[u8]] = &[
    b"\x1b",
    b"\x1b[",
    b"\x1b[1;",
    b"\x1bO",
    b"\x1b[<0;1;1",
    b"\x1b[200~",
    b"\x1b[M",
    b"\xe2\x82",
    b"\xf0\x9f",
    b"\x1b]0;",
    b"\x1bP",
    b"\x1b[?1;2c",
    b"\x1b[999999999999999999999C",
    b"\x1b[;;;;;;;;;;m",
    b"\x1b[97;5u",
    b"\x1b[1;1R",
    b"\x1b[M !!",
    b"\x1b[<65;1;1m",
];
const SIZES: &[(u16, u16)] = &[
    (80, 24),
    (1, 1),
    (2, 2),
    (40, 12),
    (39, 11),
    (132, 50),
    (300, 100),
    (80, 1),
    (1, 24),
    (500, 10),
    (0, 0),
    (3, 1000),
];
/// What no paste may bring to the screen.
const COMMANDS: &[&[u8]] =
    &[b"\x9b2J", b"\xc2\x9b", "\u{202e}".as_bytes(), b"\x1b[31mred", b"\x1b]52;c;eA=="];
/// What a fault says.
const FAULTS: &[&[u8]] = &[b"fault in the program", b"was stopped:", b"panicked"];

/// The next thing to send; nothing for a new size.
fn next(chance: &mut Chance) -> Vec<u8> {
    let bytes = match chance.below(100) {
        0..80 => {
            let count = 1 + chance.below(29);
            (0..count).map(|_| chance.of(KEYS)).collect::<String>().into_bytes()
        }
        80..90 => chance.of(LINES).as_bytes().to_vec(),
        90..93 => {
            let body = match chance.below(PASTES.len() + 2) {
                0 => vec![b'a'; 65_536],
                1 => "é漢💩".repeat(2000).into_bytes(),
                n => PASTES[n - 2].to_vec(),
            };
            // One in four has no end.
            let end: &[u8] = if chance.below(4) == 0 { b"" } else { b"\x1b[201~" };
            [b"\x1b[200~", &body[..], end].concat()
        }
        93..96 => chance.of(HALVES).to_vec(),
        96 => (0..40).map(|_| chance.below(256) as u8).collect(),
        _ => return Vec::new(),
    };
    // Not to leave all the time, and not to stop where nobody continues it.
    let leave = chance.below(33) == 0;
    bytes.into_iter().filter(|b| !matches!(b, 0x03 | 0x1a) && (*b != b'q' || leave)).collect()
}

/// One session, from start to end; the bytes that were sent.
fn session(seed: u64) -> usize {
    let mut chance = Chance(seed);
    let (launch, path) = with_sample();
    fs::copy(&path, launch.home().join("other.ron")).unwrap();
    let runs = chance.of(&["1", "2", "4"]);
    let mut launch = launch.arg("--fidelity").arg("quick").arg("--runs").arg(runs);
    for flags in chance.of(&[&[][..], &["--live"], &["--glyphs", "ascii"], &["--units", "mm"]]) {
        launch = launch.arg(*flags);
    }
    let mut pty = launch.unseen().start();
    pty.wait_for_bytes(b"meshcast");
    let (mut sent, mut steps) = (0, 0);
    while sent < SESSION && !pty.ends_within(Duration::ZERO) {
        let bytes = next(&mut chance);
        if bytes.is_empty() {
            let (width, height) = chance.of(SIZES);
            pty.resize(width, height);
            continue;
        }
        steps += 1;
        if steps % 5 == 0 {
            // A paste without its end swallows all that follows at once.
            pty.send_bytes(b"\x1b[201~");
        }
        sent += bytes.len().min(200);
        // It may leave, with the terminal, while it is sent the rest.
        if !pty.try_send(&bytes) {
            break;
        }
    }
    leave(&mut pty);
    judge(&pty, &path, seed);
    sent
}

/// Out of whatever is open; then it must draw when it is asked to, and leave.
fn leave(pty: &mut Pty) {
    if !pty.ends_within(Duration::from_millis(50)) {
        pty.resize(80, 24);
        pty.try_send(b"\x1b[201~");
        for _ in 0..14 {
            pty.try_send(b"\x1b");
            std::thread::sleep(Duration::from_millis(60));
        }
        if !pty.ends_within(Duration::ZERO) {
            pty.settle();
            assert!(pty.cost_of("\x0c") > 0, "it draws nothing");
        }
        for keys in ["q", "d", "n", "q", "d"] {
            if !pty.ends_within(Duration::from_millis(200)) {
                pty.try_send(keys.as_bytes());
            }
        }
        if !pty.ends_within(Duration::from_secs(1)) {
            pty.try_signal(Signal::TERM);
        }
    }
    let code = pty.wait_exit().exit_code();
    assert!(code <= 1, "it ended with {code}");
}

/// Whether all is as it should be afterwards.
fn judge(pty: &Pty, path: &Path, seed: u64) {
    // The last thing that is sent, and only once.
    pty.wait_for_bytes(b"\x1b[?1049l");
    let bytes = pty.received();
    let last = |part: &[u8]| bytes.windows(part.len()).rposition(|window| window == part);
    for (on, off) in [
        (&b"\x1b[?1049h"[..], &b"\x1b[?1049l"[..]),
        (b"\x1b[?25l", b"\x1b[?25h"),
        (b"\x1b[?2004h", b"\x1b[?2004l"),
    ] {
        assert!(last(off) > last(on), "seed {seed}: {} holds", on.escape_ascii());
    }
    assert!(pty.is_cooked(), "seed {seed}: line editing and echo are off");
    for part in COMMANDS.iter().chain(FAULTS) {
        assert!(last(part).is_none(), "seed {seed}: {} was sent", part.escape_ascii());
    }
    let text = fs::read_to_string(path).unwrap();
    assert!(text.trim_end().ends_with(')'), "seed {seed}: the project is torn");
}

/// Sessions until so many bytes were sent.
fn attack(keys: usize) {
    let seed = seed();
    let (mut sent, mut sessions) = (0, 0);
    while sent < keys {
        sent += session(seed.wrapping_mul(7_919).wrapping_add(sessions));
        sessions += 1;
    }
    println!("{sent} bytes of keys in {sessions} sessions");
}

#[test]
fn ten_thousand_keys() {
    attack(10_000);
}

#[test]
#[ignore = "minutes"]
fn many_keys() {
    attack(number("MESHCAST_ATTACK_KEYS", 200_000));
}
