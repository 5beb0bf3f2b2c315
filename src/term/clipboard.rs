//! Copying through OSC 52: the terminal puts the text into the clipboard of the machine it runs on,
//! through SSH too. tmux takes it itself where `set-clipboard` is on.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Most bytes of an encoded text; several terminals pass over longer ones.
const LONGEST: usize = 74_000;

/// The bytes that put a text into the clipboard. They draw nothing and move no cursor.
///
/// # Errors
/// That the text is too long, in words.
pub(super) fn copy(text: &str) -> Result<Vec<u8>, String> {
    let encoded = STANDARD.encode(text);
    if encoded.len() > LONGEST {
        return Err(format!(
            "not copied: {} kB are more than terminals take; export to a file instead",
            text.len() / 1000
        ));
    }
    Ok(format!("\x1b]52;c;{encoded}\x07").into_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_becomes_the_sequence_of_osc_52() {
        // `printf 'F_a 22.8 kN\n' | base64` by hand.
        let bytes = copy("F_a 22.8 kN\n").unwrap();
        assert_eq!(bytes, b"\x1b]52;c;Rl9hIDIyLjgga04K\x07");
        assert_eq!(copy("δ").unwrap(), b"\x1b]52;c;zrQ=\x07");
        assert_eq!(copy("").unwrap(), b"\x1b]52;c;\x07");
    }

    #[test]
    fn nothing_in_a_text_can_end_the_sequence_early() {
        let bytes = copy("\x07\x1b\\\x1b[2J").unwrap();
        let inside = &bytes[7..bytes.len() - 1];
        assert!(inside.iter().all(|b| b.is_ascii_alphanumeric() || b"+/=".contains(b)));
    }

    #[test]
    fn what_is_too_long_is_refused() {
        assert!(copy(&"x".repeat(55_500)).is_ok());
        let said = copy(&"x".repeat(55_501)).unwrap_err();
        assert!(said.contains("55 kB"), "{said}");
    }
}
