//! Numbers and strings of RON, both ways.

/// Reads a number as RON writes them: `3`, `-0.25`, `1_000`, `2.5e-1`, `0x10`, `inf`, `NaN`, each
/// with an optional type behind it (`3.0f64`). Too large a number becomes infinite.
pub(crate) fn number(text: &str) -> Option<f64> {
    let (negative, digits) = signed(text);
    let sign = if negative { -1.0 } else { 1.0 };
    match digits {
        "inf" => return Some(sign * f64::INFINITY),
        "NaN" => return Some(f64::NAN),
        _ => {}
    }
    if let Some(v) = integer(digits, negative) {
        return Some(sign * v as f64);
    }
    let (bare, single) = match (digits.strip_suffix("f32"), digits.strip_suffix("f64")) {
        (Some(bare), _) => (bare, true),
        (_, Some(bare)) => (bare, false),
        _ => (digits, false),
    };
    if !bare.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    let plain = without_underscores(bare)?;
    let right = |b: u8| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-');
    if !plain.bytes().all(right) || !plain.bytes().any(|b| b.is_ascii_digit()) {
        return None;
    }
    // A number that says of itself that it is of single precision is read so.
    let value = if single { plain.parse::<f32>().ok().map(f64::from) } else { plain.parse().ok() };
    value.map(|v: f64| sign * v)
}

/// Reads a whole number that is not negative, to the last digit: `3`, `1_000`, `0x10`, `7u64`.
pub(crate) fn whole(text: &str) -> Option<u64> {
    let (negative, digits) = signed(text);
    // Of the types that may stand behind it only its own is one, as RON has it.
    let bare = digits.strip_suffix("u64").unwrap_or(digits);
    let typed = bare.contains(['i', 'u']);
    integer(bare, negative).filter(|v| !typed && (!negative || *v == 0))
}

/// Whether a minus stands before a number, and the rest.
fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

/// A whole number without its sign, of a size that its type allows.
fn integer(digits: &str, negative: bool) -> Option<u64> {
    let bits = [("8", 8), ("16", 16), ("32", 32), ("64", 64)];
    let typed = bits.iter().find_map(|(size, bits)| {
        let bare = digits.strip_suffix(size)?;
        let (bare, most) = match (bare.strip_suffix('u'), bare.strip_suffix('i')) {
            (Some(bare), _) if negative => (bare, 0),
            (Some(bare), _) => (bare, u64::MAX >> (64 - bits)),
            (_, Some(bare)) => (bare, (u64::MAX >> (65 - bits)) + u64::from(negative)),
            _ => return None,
        };
        Some((bare, most))
    });
    let (bare, most) = typed.unwrap_or((digits, u64::MAX));
    let bases = [("0x", 16), ("0o", 8), ("0b", 2)];
    let based = bases.iter().find_map(|(prefix, base)| Some((bare.strip_prefix(prefix)?, *base)));
    let (bare, base) = based.unwrap_or((bare, 10));
    if bare.starts_with(['_', '+', '-']) {
        return None;
    }
    u64::from_str_radix(&bare.replace('_', ""), base).ok().filter(|v| *v <= most)
}

/// The digits without the underscores behind them; nothing if one stands elsewhere.
fn without_underscores(digits: &str) -> Option<String> {
    let mut plain = String::with_capacity(digits.len());
    let mut may_follow = false;
    for c in digits.chars() {
        match c {
            '_' if may_follow => continue,
            '_' => return None,
            '.' => may_follow = false,
            '+' | '-' => {}
            _ => may_follow = true,
        }
        plain.push(c);
    }
    Some(plain)
}

/// Reads the escapes of a string's inside.
///
/// # Errors
/// The byte inside `raw` where an escape is wrong, and what is wrong with it.
pub(crate) fn unescape(raw: &str) -> Result<String, (usize, String)> {
    let mut out = String::with_capacity(raw.len());
    let mut chars = raw.char_indices();
    while let Some((at, c)) = chars.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        let wrong = |what: &str| (at, format!("{what} is no escape that RON knows"));
        let Some((_, kind)) = chars.next() else { return Err(wrong("a \\ at the end")) };
        match kind {
            'n' => out.push('\n'),
            'r' => out.push('\r'),
            't' => out.push('\t'),
            '0' => out.push('\0'),
            '"' | '\'' | '\\' => out.push(kind),
            'x' => {
                let hex: String = chars.by_ref().take(2).map(|(_, c)| c).collect();
                match u8::from_str_radix(&hex, 16) {
                    Ok(v) if hex.len() == 2 && v < 0x80 => out.push(char::from(v)),
                    _ => return Err(wrong(&format!("\\x{hex}"))),
                }
            }
            'u' => {
                let rest = chars.as_str();
                let code = rest
                    .strip_prefix('{')
                    .and_then(|r| r.split_once('}'))
                    .map(|(code, _)| code)
                    .filter(|code| (1..=6).contains(&code.len()));
                let read = code.and_then(|c| u32::from_str_radix(c, 16).ok());
                match (code, read.and_then(char::from_u32)) {
                    (Some(code), Some(c)) => {
                        out.push(c);
                        // The braces and the digits, all of them one byte each.
                        for _ in 0..code.len() + 2 {
                            chars.next();
                        }
                    }
                    _ => return Err(wrong("\\u without a character's number in braces")),
                }
            }
            other => return Err(wrong(&format!("\\{other}"))),
        }
    }
    Ok(out)
}

/// A string as RON writes it, quotes included. Line feeds stay line feeds where `multiline` is set,
/// so that notes read as they were typed; other control characters are always escaped.
pub(crate) fn quoted(text: &str, multiline: bool) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' if multiline => out.push('\n'),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() || c == '\u{feff}' => {
                out.push_str(&format!("\\u{{{:x}}}", c as u32));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_ron_reads_them() {
        for (text, value) in [
            ("3", 3.0),
            ("-0.25", -0.25),
            ("+2.", 2.0),
            (".5", 0.5),
            ("1_000.5", 1000.5),
            ("2.5e-1", 0.25),
            ("0x1F", 31.0),
            ("0b101", 5.0),
            ("3.0f64", 3.0),
            ("7u32", 7.0),
            ("-128i8", -128.0),
            ("3f64", 3.0),
            ("0.1f32", f64::from(0.1f32)),
            ("18446744073709551616", 18446744073709551616.0),
            ("-inf", f64::NEG_INFINITY),
            ("1e999", f64::INFINITY),
        ] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        assert!(number("NaN").is_some_and(f64::is_nan));
        for text in [
            "", "-", "_1", "1.2.3", "250mm", "0x", "0x-1", "e5", "--1", ".", "1._5", "300u8",
            "128i8", "-1u8", "3.5u8",
        ] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn whole_numbers_are_read_to_the_last_digit() {
        for (text, value) in [
            ("0", 0),
            ("-0", 0),
            ("+1_000", 1000),
            ("0xff", 255),
            ("255u64", 255),
            ("18446744073709551615", u64::MAX),
            ("9007199254740993", 9007199254740993),
        ] {
            assert_eq!(whole(text), Some(value), "{text}");
            assert_eq!(ron::from_str::<u64>(text), Ok(value), "{text}");
        }
        for text in ["-1", "1.0", "1e3", "7u8", "7i64", "18446744073709551616", "_1", "", "0x"] {
            assert_eq!(whole(text), None, "{text}");
            assert!(ron::from_str::<u64>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn strings_survive_both_ways() {
        let odd = "a \"quoted\" \\ path,\ttab\r\nbell \u{7} nul \0 mark \u{feff} ä µ 石";
        for multiline in [false, true] {
            let written = quoted(odd, multiline);
            assert_eq!(unescape(&written[1..written.len() - 1]).as_deref(), Ok(odd));
            assert_eq!(ron::from_str::<String>(&written).as_deref(), Ok(odd));
        }
        assert_eq!(unescape(r"\x41\u{e4}\'").as_deref(), Ok("Aä'"));
        for wrong in [r"\q", r"\x4", r"\u{}", r"\u{110000}", r"\u41", "\\"] {
            assert!(unescape(wrong).is_err(), "{wrong}");
        }
    }
}
