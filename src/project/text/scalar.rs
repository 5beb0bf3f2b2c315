//! Numbers and strings of RON, both ways.

/// Reads a number as RON writes them: `3`, `-0.25`, `1_000`, `2.5e-1`, `0x10`, `inf`, `NaN`, each
/// with an optional type behind it (`3.0f64`). Too large a number becomes infinite.
pub(crate) fn number(text: &str) -> Option<f64> {
    let (sign, digits) = match text.as_bytes().first()? {
        b'-' => (-1.0, &text[1..]),
        b'+' => (1.0, &text[1..]),
        _ => (1.0, text),
    };
    match digits {
        "inf" => return Some(sign * f64::INFINITY),
        "NaN" => return Some(f64::NAN),
        _ => {}
    }
    if digits.starts_with('_') || !digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
        return None;
    }
    for (prefix, base) in [("0x", 16), ("0o", 8), ("0b", 2)] {
        if let Some(rest) = digits.strip_prefix(prefix) {
            let rest = rest.replace('_', "");
            if rest.starts_with(['+', '-']) {
                return None;
            }
            return u64::from_str_radix(&rest, base).ok().map(|v| sign * v as f64);
        }
    }
    let bare = ["f32", "f64", "i8", "i16", "i32", "i64", "u8", "u16", "u32", "u64"]
        .iter()
        .find_map(|suffix| digits.strip_suffix(suffix))
        .unwrap_or(digits);
    let plain = bare.replace('_', "");
    let shape_is_right =
        plain.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'))
            && plain.bytes().any(|b| b.is_ascii_digit());
    if !shape_is_right {
        return None;
    }
    plain.parse::<f64>().ok().map(|v| sign * v)
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
            ("-inf", f64::NEG_INFINITY),
            ("1e999", f64::INFINITY),
        ] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        assert!(number("NaN").is_some_and(f64::is_nan));
        for text in ["", "-", "_1", "1.2.3", "250mm", "0x", "0x-1", "e5", "--1", "."] {
            assert_eq!(number(text), None, "{text}");
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
