//! Bytes of a terminal to keys and pastes.
//!
//! A terminal has one line for two things: what is typed, and what it says of itself. Both may come in
//! pieces of any size. So this decoder takes bytes as they come, keeps what is not whole yet, and is told
//! when nothing came for a while ([`Decoder::patience`], [`Decoder::idle`]); it has no clock, and what it
//! gives does not depend on where the pieces begin.
//!
//! - ESC followed by silence is the Escape key; ESC followed by a key is Escape, then that key. Alt is
//!   told where a sequence says so (`ESC [ 1 ; 3 C`, `ESC ESC [ C`) and for Backspace.
//! - `[` or its like just after an Escape that was given out because its rest was late still begins a
//!   sequence: no line is so slow that an arrow becomes letters.
//! - Answers and strings of the terminal (OSC, DCS, SOS, PM, APC, reports, mouse) are passed over to
//!   their end. Where there is no end, silence is one.
//! - A paste ends with its mark or with silence. It keeps no control characters but tabs and line ends.

mod sequence;
#[cfg(test)]
mod tests;

use crate::app::key::{Code, Key};
use crate::words::shown;
use std::time::Duration;

/// Silence after which ESC was the Escape key: longer than a byte takes at 300 baud and than the pause
/// that SSH makes within a packet, too short to be felt.
const ESCAPE: Duration = Duration::from_millis(50);
/// Silence after which the rest of something that is no key by itself is not waited for.
const REST: Duration = Duration::from_millis(500);
/// How long after an Escape its late rest is recognised.
const LATE: Duration = Duration::from_secs(1);
/// Silence that ends a paste without its mark: a lost packet is sent again within this time.
const PASTE: Duration = Duration::from_secs(2);

/// Bytes kept of a sequence; what is longer is no key.
const LONGEST: usize = 64;
/// Bytes kept of a paste, far above what any field takes.
const LONGEST_PASTE: usize = 1 << 16;

const ESC: u8 = 0x1b;
/// What ends a paste.
const PASTE_END: &[u8] = b"\x1b[201~";

/// What was typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Typed {
    Key(Key),
    /// A marked paste.
    Paste(String),
}

/// What is under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Nothing.
    Ground,
    /// Nothing, but an Escape was given out a moment ago.
    Late,
    /// The first bytes of a character that has so many.
    Utf8(usize),
    /// ESC, or two of them.
    Escape,
    /// ESC `[` and what follows.
    Csi,
    /// ESC `O` and what follows.
    Ss3,
    /// OSC, DCS, SOS, PM or APC.
    String,
    /// ESC within such a string, perhaps its end.
    StringEscape,
    /// ESC `[` `[`: a function key of the Linux console.
    Console,
    /// A report of the old mouse protocol, so many bytes before its end.
    Mouse(u8),
    /// A paste, so many bytes into what may be its end.
    Paste(usize),
}

/// Makes keys of bytes.
#[derive(Debug)]
pub(super) struct Decoder {
    state: State,
    /// What is under way, from its ESC on; of a late rest without it.
    held: Vec<u8>,
    paste: Vec<u8>,
}

impl Decoder {
    /// Nothing under way.
    pub(super) fn new() -> Decoder {
        Decoder { state: State::Ground, held: Vec::new(), paste: Vec::new() }
    }

    /// Takes bytes in; what they complete is added to `out`.
    pub(super) fn feed(&mut self, bytes: &[u8], out: &mut Vec<Typed>) {
        for byte in bytes {
            self.byte(*byte, out);
        }
    }

    /// How long a silence must be before [`idle`](Decoder::idle) is to be called; `None` while nothing
    /// is under way.
    pub(super) fn patience(&self) -> Option<Duration> {
        match self.state {
            State::Ground => None,
            State::Late => Some(LATE),
            State::Escape => Some(ESCAPE),
            // The key itself is likelier than a rest that comes late and in pieces.
            State::Csi | State::Ss3 | State::String if self.held.len() == 1 => Some(ESCAPE),
            State::Paste(_) => Some(PASTE),
            _ => Some(REST),
        }
    }

    /// Nothing came for as long as [`patience`](Decoder::patience) said.
    pub(super) fn idle(&mut self, out: &mut Vec<Typed>) {
        match self.state {
            State::Escape => {
                self.give_up(out);
                self.state = State::Late;
            }
            State::StringEscape => {
                out.push(Typed::Key(Key::plain(Code::Esc)));
                self.state = State::Late;
            }
            State::Paste(_) => self.end_paste(out),
            _ => self.give_up(out),
        }
    }

    fn byte(&mut self, byte: u8, out: &mut Vec<Typed>) {
        match self.state {
            State::Ground | State::Late => self.ground(byte, out),
            State::Utf8(length) => self.character(byte, length, out),
            State::Escape => self.escape(byte, out),
            State::Csi => self.csi(byte, out),
            State::Ss3 => self.ss3(byte, out),
            State::String => self.string(byte, out),
            State::StringEscape => self.string_escape(byte, out),
            State::Console => self.console(byte, out),
            State::Mouse(left) => self.mouse(byte, left, out),
            State::Paste(matched) => self.paste(byte, matched, out),
        }
    }

    fn ground(&mut self, byte: u8, out: &mut Vec<Typed>) {
        let late = self.state == State::Late;
        self.state = State::Ground;
        match byte {
            ESC => self.begin(byte, State::Escape),
            b'[' if late => self.begin(byte, State::Csi),
            b'O' if late => self.begin(byte, State::Ss3),
            b']' if late => self.begin(byte, State::String),
            ..0x80 => out.extend(sequence::plain(byte).map(Typed::Key)),
            0xc2..=0xdf => self.begin(byte, State::Utf8(2)),
            0xe0..=0xef => self.begin(byte, State::Utf8(3)),
            0xf0..=0xf4 => self.begin(byte, State::Utf8(4)),
            // Introducers of terminals that send eight bits; never text in UTF-8.
            0x9b => self.begin(byte, State::Csi),
            0x8f => self.begin(byte, State::Ss3),
            0x90 | 0x98 | 0x9d..=0x9f => self.begin(byte, State::String),
            _ => {}
        }
    }

    fn begin(&mut self, byte: u8, state: State) {
        self.held.clear();
        self.held.push(byte);
        self.state = state;
    }

    fn hold(&mut self, byte: u8) {
        if self.held.len() < LONGEST {
            self.held.push(byte);
        }
    }

    fn character(&mut self, byte: u8, length: usize, out: &mut Vec<Typed>) {
        if !(0x80..0xc0).contains(&byte) {
            self.state = State::Ground;
            return self.ground(byte, out);
        }
        self.held.push(byte);
        if self.held.len() == length {
            self.state = State::Ground;
            let text = str::from_utf8(&self.held).unwrap_or_default();
            let printable = text.chars().filter(|c| shown(*c));
            out.extend(printable.map(|c| Typed::Key(Key::char(c))));
        }
    }

    fn escape(&mut self, byte: u8, out: &mut Vec<Typed>) {
        let next = match byte {
            b'[' => State::Csi,
            b'O' => State::Ss3,
            b']' | b'P' | b'X' | b'^' | b'_' => State::String,
            ESC if self.held.len() == 1 => State::Escape,
            ESC => {
                out.push(Typed::Key(Key::plain(Code::Esc)));
                return;
            }
            0x7f | 0x08 => {
                // Alt with Backspace is a habit from other programs; as two keys it would drop a line
                // that is being typed.
                self.held.pop();
                self.give_up(out);
                let alt = Key { alt: true, ..Key::plain(Code::Backspace) };
                return out.push(Typed::Key(alt));
            }
            _ => {
                self.give_up(out);
                return self.ground(byte, out);
            }
        };
        self.held.push(byte);
        self.state = next;
    }

    /// What follows the introducer.
    fn body(&self) -> &[u8] {
        let escapes = self.held.iter().take(2).filter(|byte| **byte == ESC).count();
        self.held.get(escapes + 1..).unwrap_or_default()
    }

    /// Two ESC before the introducer: how PuTTY, rxvt and the terminal of macOS send Alt.
    fn alt(&self) -> bool {
        self.held.get(1) == Some(&ESC)
    }

    /// Ends a sequence with the key that it is, if any.
    fn end(&mut self, key: Option<Key>, out: &mut Vec<Typed>) {
        let alt = self.alt();
        self.state = State::Ground;
        out.extend(key.map(|key| Typed::Key(Key { alt: key.alt || alt, ..key })));
    }

    /// No sequence after all: a bare introducer was keys, anything longer is dropped.
    fn give_up(&mut self, out: &mut Vec<Typed>) {
        let keys = match self.state {
            State::Escape | State::Console => true,
            State::Csi | State::Ss3 | State::String => self.body().is_empty(),
            _ => false,
        };
        self.state = State::Ground;
        if keys {
            let held = self.held.iter().filter_map(|byte| sequence::plain(*byte));
            out.extend(held.map(Typed::Key));
        }
    }

    fn csi(&mut self, byte: u8, out: &mut Vec<Typed>) {
        match byte {
            b'$' if sequence::is_rxvt_shift(self.body()) => {
                let key = sequence::csi(self.body(), byte);
                self.end(key, out);
            }
            b' '..=b'?' => self.hold(byte),
            b'[' if self.body().is_empty() => {
                self.hold(byte);
                self.state = State::Console;
            }
            b'M' if self.body().is_empty() => self.state = State::Mouse(3),
            b'~' if self.body() == b"200" => {
                self.paste.clear();
                self.state = State::Paste(0);
            }
            b'@'..=b'~' => {
                let whole = self.held.len() < LONGEST;
                let key = sequence::csi(self.body(), byte).filter(|_| whole);
                self.end(key, out);
            }
            _ => {
                self.give_up(out);
                self.ground(byte, out);
            }
        }
    }

    fn ss3(&mut self, byte: u8, out: &mut Vec<Typed>) {
        match byte {
            b'0'..=b'9' | b';' => self.hold(byte),
            b' '..=b'~' => match sequence::ss3(self.body(), byte) {
                Some(key) => self.end(key, out),
                None => {
                    self.give_up(out);
                    self.ground(byte, out);
                }
            },
            _ => {
                self.give_up(out);
                self.ground(byte, out);
            }
        }
    }

    fn string(&mut self, byte: u8, out: &mut Vec<Typed>) {
        let eight_bits = self.held.first().is_some_and(|first| *first >= 0x80);
        match byte {
            // Of a late `]` nothing but an answer to OSC is believed.
            _ if self.held == b"]" && !byte.is_ascii_digit() => {
                self.give_up(out);
                self.ground(byte, out);
            }
            ESC => self.state = State::StringEscape,
            // BEL and the cancelling characters; no answer has other control characters either.
            ..0x20 => self.state = State::Ground,
            0x9c if eight_bits => self.state = State::Ground,
            _ => self.hold(byte),
        }
    }

    fn string_escape(&mut self, byte: u8, out: &mut Vec<Typed>) {
        if byte == b'\\' {
            self.state = State::Ground;
            return;
        }
        // The string was cut off and something else begins.
        self.begin(ESC, State::Escape);
        self.escape(byte, out);
    }

    fn console(&mut self, byte: u8, out: &mut Vec<Typed>) {
        match byte {
            b'A'..=b'E' => self.end(Some(Key::plain(Code::F(byte - b'A' + 1))), out),
            _ => {
                self.give_up(out);
                self.ground(byte, out);
            }
        }
    }

    fn mouse(&mut self, byte: u8, left: u8, out: &mut Vec<Typed>) {
        self.state = if left > 1 { State::Mouse(left - 1) } else { State::Ground };
        // Places on the screen are sent as printable characters.
        if byte < b' ' {
            self.state = State::Ground;
            self.ground(byte, out);
        }
    }

    fn paste(&mut self, byte: u8, matched: usize, out: &mut Vec<Typed>) {
        if byte == PASTE_END[matched] {
            if matched + 1 == PASTE_END.len() {
                self.end_paste(out);
            } else {
                self.state = State::Paste(matched + 1);
            }
            return;
        }
        let room = LONGEST_PASTE.saturating_sub(self.paste.len());
        self.paste.extend(PASTE_END[..matched].iter().take(room));
        if byte == ESC {
            self.state = State::Paste(1);
            return;
        }
        self.state = State::Paste(0);
        if matched < room {
            self.paste.push(byte);
        }
    }

    fn end_paste(&mut self, out: &mut Vec<Typed>) {
        self.state = State::Ground;
        let mut text = String::new();
        for chunk in self.paste.utf8_chunks() {
            text.extend(chunk.valid().chars().filter(|c| sequence::may_be_pasted(*c)));
        }
        self.paste.clear();
        out.push(Typed::Paste(text));
    }
}
