//! Tells typing from a paste that the terminal does not mark: GNU screen, old consoles and serial lines
//! send it as keys.
//!
//! A run is text that came without a pause. It counts as a paste from [`FEWEST`] keys on, if at least
//! [`DIFFERENT`] of them differ. Neither bound is reached by hand: a held key repeats one key, however
//! many of them a slow line delivers at once, and eight keys of quick typing take two thirds of a second,
//! longer than a line stalls without being noticed. The shortest pastes of two or three fields are above
//! both.
//!
//! Only text waits to be told apart, and only when two different keys came together: a key by itself is
//! never held back.

use super::decoder::Typed;
use crate::app::key::{Code, Key};
use crate::app::message::Message;
use std::time::{Duration, Instant};

/// Keys of the shortest run that counts as a paste.
const FEWEST: usize = 8;
/// Keys that must differ in it.
const DIFFERENT: usize = 4;
/// Most keys kept of a run; no field takes more.
const MOST: usize = 4096;
/// A pause that ends a run. A serial line of 9600 baud sends a byte each millisecond.
pub(super) const PAUSE: Duration = Duration::from_millis(10);

/// Text that may be the beginning of a paste.
#[derive(Debug, Default)]
pub(super) struct Bursts {
    run: Vec<Key>,
    /// The text key that was let through last, and when.
    passed: Option<(Key, Instant)>,
}

impl Bursts {
    /// Takes what was typed, and adds what can be said of it now to `out`.
    pub(super) fn take(&mut self, typed: Vec<Typed>, now: Instant, out: &mut Vec<Message>) {
        for typed in typed {
            match typed {
                Typed::Key(key) if is_text(key) => {
                    if self.run.len() < MOST {
                        self.run.push(key);
                    }
                }
                other => {
                    self.end_run(now, out);
                    out.push(match other {
                        Typed::Key(key) => Message::Key(key),
                        Typed::Paste(text) => Message::Paste(text),
                    });
                }
            }
        }
        if !self.may_go_on(now) {
            self.end_run(now, out);
        }
    }

    /// Whether keys wait for the pause after them.
    pub(super) fn waiting(&self) -> bool {
        !self.run.is_empty()
    }

    /// No more keys come, for now.
    pub(super) fn end_run(&mut self, now: Instant, out: &mut Vec<Message>) {
        if let Some(last) = self.run.last() {
            self.passed = Some((*last, now));
        }
        if is_paste(&self.run) {
            out.push(Message::Burst(std::mem::take(&mut self.run)));
        } else {
            out.extend(self.run.drain(..).map(Message::Key));
        }
    }

    /// Whether the run looks as if more of it were on its way.
    fn may_go_on(&self, now: Instant) -> bool {
        let Some(first) = self.run.first() else { return false };
        let soon = |at: Instant| now.saturating_duration_since(at) < PAUSE;
        let before = self.passed.filter(|(_, at)| soon(*at)).map(|(key, _)| key);
        self.run.iter().chain(&before).any(|key| key != first)
    }
}

/// Keys that pasted text consists of.
fn is_text(key: Key) -> bool {
    !key.ctrl && !key.alt && matches!(key.code, Code::Char(_) | Code::Enter | Code::Tab)
}

fn is_paste(run: &[Key]) -> bool {
    let mut different: Vec<Key> = Vec::with_capacity(DIFFERENT);
    for key in run {
        if different.len() < DIFFERENT && !different.contains(key) {
            different.push(*key);
        }
    }
    run.len() >= FEWEST && different.len() >= DIFFERENT
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(text: &str) -> Vec<Typed> {
        let key = |c| if c == '\r' { Key::plain(Code::Enter) } else { Key::char(c) };
        text.chars().map(|c| Typed::Key(key(c))).collect()
    }

    fn spell(messages: &[Message]) -> String {
        let words = messages.iter().map(|message| match message {
            Message::Key(key) => key.to_string(),
            Message::Burst(keys) => format!("<{}>", keys.len()),
            other => format!("{other:?}"),
        });
        words.collect::<Vec<_>>().join(" ")
    }

    /// What comes out of pieces that are so far apart; the run is ended after the last one.
    fn out(pieces: &[&str], apart: Duration) -> String {
        let mut now = Instant::now();
        let (mut bursts, mut out) = (Bursts::default(), Vec::new());
        for piece in pieces {
            if bursts.waiting() && apart >= PAUSE {
                bursts.end_run(now, &mut out);
            }
            now += apart;
            bursts.take(keys(piece), now, &mut out);
        }
        bursts.end_run(now, &mut out);
        spell(&out)
    }

    #[test]
    fn a_paste_is_one_message_also_in_pieces() {
        let paste = "2.75\r3.1\rxxq\r";
        assert_eq!(out(&[paste], Duration::ZERO), "<13>");
        assert_eq!(out(&["2.", "75\r3.", "1\rxxq\r"], Duration::from_millis(1)), "<13>");
        // Where the first key comes alone it cannot be known.
        let bytes: Vec<String> = paste.chars().map(String::from).collect();
        let bytes: Vec<&str> = bytes.iter().map(String::as_str).collect();
        assert_eq!(out(&bytes, Duration::from_millis(1)), "2 <12>");
    }

    #[test]
    fn typing_is_keys() {
        let slow = Duration::from_millis(100);
        let word: Vec<&str> = "reference".split("").filter(|c| !c.is_empty()).collect();
        assert_eq!(out(&word, slow), "r e f e r e n c e");
        // Typed while the line stood still.
        assert_eq!(out(&["2.75\rs"], slow), "2 . 7 5 Enter s");
        // Held, for four seconds of a line that stands still.
        assert_eq!(out(&[&"x".repeat(120)], slow), ["x"; 120].join(" "));
        assert_eq!(out(&["><><><><><><"], slow), "> < > < > < > < > < > <");
    }

    #[test]
    fn a_key_by_itself_does_not_wait() {
        let (mut bursts, mut out) = (Bursts::default(), Vec::new());
        let now = Instant::now();
        bursts.take(keys("s"), now, &mut out);
        bursts.take(keys("ss"), now, &mut out);
        assert!(!bursts.waiting());
        assert_eq!(spell(&out), "s s s");
        // Another one right after it may be the second letter of a paste.
        bursts.take(keys("q"), now + Duration::from_millis(1), &mut out);
        assert!(bursts.waiting());
        bursts.end_run(now, &mut out);
        bursts.take(keys("w"), now + Duration::from_millis(60), &mut out);
        assert!(!bursts.waiting());
    }

    #[test]
    fn keys_that_are_no_text_end_a_run_and_order_is_kept() {
        let (mut bursts, mut out) = (Bursts::default(), Vec::new());
        let mut typed = keys("2.61\r");
        typed.insert(0, Typed::Key(Key::plain(Code::Down)));
        typed.push(Typed::Key(Key::ctrl('s')));
        bursts.take(typed, Instant::now(), &mut out);
        assert_eq!(spell(&out), "Down 2 . 6 1 Enter Ctrl+S");
        assert!(!bursts.waiting());
    }
}
