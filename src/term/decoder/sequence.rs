//! Which key a whole sequence is: xterm and its like, PuTTY, rxvt, screen, tmux, the Linux console.

use crate::app::key::{Code, Key};
use crate::words::in_text;

/// The key of a byte that stands for itself.
pub(super) fn plain(byte: u8) -> Option<Key> {
    Some(match byte {
        // Serial lines and some terminals send ^H for Backspace and ^J for Enter.
        0x08 | 0x7f => Key::plain(Code::Backspace),
        b'\t' => Key::plain(Code::Tab),
        b'\n' | b'\r' => Key::plain(Code::Enter),
        0x1b => Key::plain(Code::Esc),
        0x00 => Key::ctrl(' '),
        b' '..=b'~' => Key::char(char::from(byte)),
        // Ctrl takes the upper bits away: ^A to ^Z, and a few signs.
        0x01..=0x07 | 0x0b..=0x0c | 0x0e..=0x1a => Key::ctrl(char::from(byte | 0x60)),
        0x1c..=0x1f => Key::ctrl(char::from(byte | 0x40)),
        _ => return None,
    })
}

/// Whether a pasted character is kept: line ends, tabs, and what is printed and does not turn the
/// direction of the text around it.
pub(super) fn may_be_pasted(c: char) -> bool {
    in_text(c)
}

/// The parameters of a sequence: each number with the one after a colon.
struct Parameters {
    numbers: [(u32, u32); 3],
    count: usize,
}

impl Parameters {
    fn read(body: &[u8]) -> Parameters {
        let mut read = Parameters { numbers: [(0, 0); 3], count: 0 };
        if body.is_empty() {
            return read;
        }
        for part in body.split(|byte| *byte == b';') {
            if let Some(slot) = read.numbers.get_mut(read.count) {
                let mut parts = part.split(|byte| *byte == b':').map(number);
                *slot = (parts.next().unwrap_or(0), parts.next().unwrap_or(0));
            }
            read.count += 1;
        }
        read
    }
}

fn number(digits: &[u8]) -> u32 {
    let digits = digits.iter().filter(|byte| byte.is_ascii_digit());
    digits.fold(0, |n: u32, byte| n.saturating_mul(10).saturating_add(u32::from(byte - b'0')))
}

/// Shift, Alt and Control as the parameter tells them: one more than the sum of 1, 2 and 4. What is
/// called Meta or Super counts as Alt, so that it is not taken for the bare key.
#[derive(Clone, Copy)]
struct Modifiers {
    shift: bool,
    alt: bool,
    ctrl: bool,
}

impl Modifiers {
    const NONE: Modifiers = Modifiers { shift: false, alt: false, ctrl: false };
    const SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::NONE };
    const CTRL: Modifiers = Modifiers { ctrl: true, ..Modifiers::NONE };
    const CTRL_SHIFT: Modifiers = Modifiers { shift: true, ..Modifiers::CTRL };

    fn of(parameter: u32) -> Modifiers {
        let bits = parameter.saturating_sub(1);
        Modifiers { shift: bits & 1 != 0, alt: bits & (2 | 8 | 32) != 0, ctrl: bits & 4 != 0 }
    }

    fn with(self, code: Code) -> Key {
        let Modifiers { shift, alt, ctrl } = self;
        match code {
            Code::BackTab => Key { code, ctrl, alt, shift: false },
            Code::Tab if shift => Key { code: Code::BackTab, ctrl, alt, shift: false },
            code => Key { code, ctrl, alt, shift },
        }
    }
}

/// Shift with a key of rxvt: `ESC [ 3 $`. A report that ends in `$y` has more than one number.
pub(super) fn is_rxvt_shift(body: &[u8]) -> bool {
    !body.is_empty() && body.iter().all(u8::is_ascii_digit) && numbered(number(body)).is_some()
}

/// The key of `ESC [` `body` `last`; `None` for answers, for releases and for what is no key here.
pub(super) fn csi(body: &[u8], last: u8) -> Option<Key> {
    // Signs before the numbers or spaces behind them: the terminal speaks of itself.
    if body.iter().any(|byte| !matches!(byte, b'0'..=b'9' | b';' | b':')) {
        return None;
    }
    let read = Parameters::read(body);
    let [first, second, third] = read.numbers;
    /// What a key's third state is called: let go.
    const RELEASE: u32 = 3;
    if second.1 == RELEASE {
        return None;
    }
    let modifiers = match (read.count, last) {
        // Old xterms give the modifiers alone: `ESC [ 5 C`.
        (1, b'A'..=b'H') => Modifiers::of(first.0),
        _ => Modifiers::of(second.0),
    };
    match last {
        b'Z' => Some(modifiers.with(Code::BackTab)),
        b'P' => Some(modifiers.with(Code::F(1))),
        b'Q' => Some(modifiers.with(Code::F(2))),
        b'S' => Some(modifiers.with(Code::F(4))),
        b'a'..=b'd' if body.is_empty() => Some(Modifiers::SHIFT.with(arrow(last - 32)?)),
        b'~' if first.0 == 27 && read.count == 3 => typed(third.0, modifiers),
        b'~' => Some(modifiers.with(numbered(first.0)?)),
        b'$' => Some(Modifiers::SHIFT.with(numbered(first.0)?)),
        b'^' => Some(Modifiers::CTRL.with(numbered(first.0)?)),
        b'@' if !body.is_empty() => Some(Modifiers::CTRL_SHIFT.with(numbered(first.0)?)),
        b'u' if read.count > 0 => typed(first.0, modifiers),
        _ => Some(modifiers.with(arrow(last)?)),
    }
}

/// Arrows and the keys that are sent like them.
fn arrow(last: u8) -> Option<Code> {
    Some(match last {
        b'A' => Code::Up,
        b'B' => Code::Down,
        b'C' => Code::Right,
        b'D' => Code::Left,
        b'F' => Code::End,
        b'H' => Code::Home,
        _ => return None,
    })
}

/// Keys that are sent by number.
fn numbered(number: u32) -> Option<Code> {
    let function = |from: u32, first: u8| Some(Code::F((number - from) as u8 + first));
    match number {
        1 | 7 => Some(Code::Home),
        3 => Some(Code::Delete),
        4 | 8 => Some(Code::End),
        5 => Some(Code::PageUp),
        6 => Some(Code::PageDown),
        11..=15 => function(11, 1),
        17..=21 => function(17, 6),
        23..=26 => function(23, 11),
        28..=29 => function(28, 15),
        31..=34 => function(31, 17),
        _ => None,
    }
}

/// A key by the number of its character, as xterm (`modifyOtherKeys`) and kitty send it.
fn typed(number: u32, modifiers: Modifiers) -> Option<Key> {
    let code = match number {
        9 => Code::Tab,
        13 | 57414 => Code::Enter,
        27 => Code::Esc,
        8 | 127 => Code::Backspace,
        // The keypad of kitty.
        57399..=57408 => Code::Char(char::from(b'0' + (number - 57399) as u8)),
        57409 => Code::Char('.'),
        57410 => Code::Char('/'),
        57411 => Code::Char('*'),
        57412 => Code::Char('-'),
        57413 => Code::Char('+'),
        57415 => Code::Char('='),
        57417 => Code::Left,
        57418 => Code::Right,
        57419 => Code::Up,
        57420 => Code::Down,
        57421 => Code::PageUp,
        57422 => Code::PageDown,
        57423 => Code::Home,
        57424 => Code::End,
        57426 => Code::Delete,
        // Modifiers by themselves and media keys.
        57344..=63743 => return None,
        other => Code::Char(char::from_u32(other).filter(|c| !c.is_control())?),
    };
    let Code::Char(c) = code else { return Some(modifiers.with(code)) };
    let Modifiers { shift, alt, ctrl } = modifiers;
    if ctrl && !alt {
        // The same keys as where they arrive as one byte.
        let byte = u8::try_from(u32::from(c)).unwrap_or(0).to_ascii_lowercase();
        if byte.is_ascii_lowercase() {
            return plain(byte - b'a' + 1);
        }
    }
    let c = if shift && !ctrl { c.to_uppercase().next().unwrap_or(c) } else { c };
    let c = if ctrl { c.to_lowercase().next().unwrap_or(c) } else { c };
    Some(Key { code: Code::Char(c), ctrl, alt, shift: false })
}

/// The key of `ESC O` `body` `last`, application keypad included: `None` when no terminal sends that,
/// `Some(None)` when it is no key here.
pub(super) fn ss3(body: &[u8], last: u8) -> Option<Option<Key>> {
    let read = Parameters::read(body);
    let held = read.numbers[read.count.saturating_sub(1).min(2)].0;
    let modifiers = Modifiers::of(held);
    let plain = |code: Code| Some(Some(modifiers.with(code)));
    match last {
        b'A'..=b'D' | b'F' | b'H' => Some(arrow(last).map(|code| modifiers.with(code))),
        b'E' => Some(None),
        b'P'..=b'S' => plain(Code::F(last - b'P' + 1)),
        b'M' => plain(Code::Enter),
        b'I' => plain(Code::Tab),
        b'a'..=b'd' => Some(arrow(last - 32).map(|code| Modifiers::CTRL.with(code))),
        b' ' | b'X' | b'j'..=b'y' => {
            let c = match last {
                b' ' => b' ',
                b'X' => b'=',
                // j to o: * + , - . / and p to y: 0 to 9.
                last => last - b'j' + b'*',
            };
            Some(Some(Key::char(char::from(c))))
        }
        _ => None,
    }
}
