//! Sequences to keys, whole and in pieces. The sequences are those of the terminals' own manuals
//! (ctlseqs of xterm, terminfo entries of putty, rxvt, screen, tmux and linux).

use super::*;
use proptest::prelude::*;

/// What a keyboard sends, and the keys it stands for, as the help writes them.
const KEYS: &[(&[u8], &str)] = &[
    (b"a", "a"),
    (b"?", "?"),
    (b" ", "Space"),
    ("é".as_bytes(), "é"),
    ("網".as_bytes(), "網"),
    ("🏔".as_bytes(), "🏔"),
    (b"\r", "Enter"),
    (b"\n", "Enter"),
    (b"\t", "Tab"),
    (b"\x7f", "Backspace"),
    (b"\x08", "Backspace"),
    (b"\x13", "Ctrl+S"),
    (b"\x1a", "Ctrl+Z"),
    (b"\x00", "Ctrl+Space"),
    // Escape and the next key in one packet.
    (b"\x1b:", "Esc :"),
    (b"\x1bq", "Esc q"),
    (b"\x1b\r", "Esc Enter"),
    (b"\x1b\x1bq", "Esc Esc q"),
    ("\x1bé".as_bytes(), "Esc é"),
    (b"\x1b\x7f", "Alt+Backspace"),
    // Arrows and their like: cursor and application mode, with modifiers.
    (b"\x1b[A", "Up"),
    (b"\x1b[B", "Down"),
    (b"\x1b[C", "Right"),
    (b"\x1b[D", "Left"),
    (b"\x1bOA", "Up"),
    (b"\x1bOC", "Right"),
    (b"\x1b[H", "Home"),
    (b"\x1b[F", "End"),
    (b"\x1bOH", "Home"),
    (b"\x1bOF", "End"),
    (b"\x1b[1~", "Home"),
    (b"\x1b[4~", "End"),
    (b"\x1b[7~", "Home"),
    (b"\x1b[8~", "End"),
    (b"\x1b[3~", "Delete"),
    (b"\x1b[5~", "PgUp"),
    (b"\x1b[6~", "PgDn"),
    (b"\x1b[Z", "Shift+Tab"),
    (b"\x1b[1;2C", "Shift+Right"),
    (b"\x1b[1;3C", "Alt+Right"),
    (b"\x1b[1;5D", "Ctrl+Left"),
    (b"\x1b[1;6A", "Ctrl+Shift+Up"),
    (b"\x1b[5C", "Ctrl+Right"),
    (b"\x1bO5C", "Ctrl+Right"),
    (b"\x1bO1;5D", "Ctrl+Left"),
    (b"\x1b[3;5~", "Ctrl+Delete"),
    (b"\x1b\x1b[C", "Alt+Right"),
    (b"\x1b\x1bOD", "Alt+Left"),
    (b"\x1b\x1b[3~", "Alt+Delete"),
    // rxvt
    (b"\x1b[a", "Shift+Up"),
    (b"\x1bOc", "Ctrl+Right"),
    (b"\x1b[3$", "Shift+Delete"),
    (b"\x1b[3^", "Ctrl+Delete"),
    (b"\x1b[5@", "Ctrl+Shift+PgUp"),
    // Function keys: vt220, xterm, Linux console.
    (b"\x1bOP", "F1"),
    (b"\x1bOS", "F4"),
    (b"\x1b[11~", "F1"),
    (b"\x1b[15~", "F5"),
    (b"\x1b[17~", "F6"),
    (b"\x1b[24~", "F12"),
    (b"\x1b[34~", "F20"),
    (b"\x1b[1;2P", "Shift+F1"),
    (b"\x1b[[A", "F1"),
    (b"\x1b[[E", "F5"),
    // Application keypad.
    (b"\x1bOp", "0"),
    (b"\x1bOy", "9"),
    (b"\x1bOn", "."),
    (b"\x1bOm", "-"),
    (b"\x1bOk", "+"),
    (b"\x1bOj", "*"),
    (b"\x1bOo", "/"),
    (b"\x1bOM", "Enter"),
    // Keys by number: modifyOtherKeys and kitty.
    (b"\x1b[27;5;13~", "Ctrl+Enter"),
    (b"\x1b[27;5;115~", "Ctrl+S"),
    (b"\x1b[115;5u", "Ctrl+S"),
    (b"\x1b[97u", "a"),
    (b"\x1b[97;2u", "A"),
    (b"\x1b[97;3u", "Alt+a"),
    (b"\x1b[27u", "Esc"),
    (b"\x1b[9;2u", "Shift+Tab"),
    (b"\x1b[104;5u", "Backspace"),
    // Eight bits.
    (b"\x9bC", "Right"),
    (b"\x8fP", "F1"),
];

/// What a terminal says of itself, what was cut short, and bytes that are no text: no key at all.
const NO_KEYS: &[&[u8]] = &[
    // Colours, title, clipboard.
    b"\x1b]11;rgb:1e1e/1e1e/1e1e\x1b\\",
    b"\x1b]10;rgb:ffff/ffff/ffff\x07",
    b"\x1b]4;1;rgb:cdcd/0000/0000\x07",
    b"\x1b]52;c;cXVpdA==\x1b\\",
    b"\x1b]lquit\x1b\\",
    // DCS, SOS, PM, APC.
    b"\x1bP1$r0m\x1b\\",
    b"\x1bP>|xterm(370)\x1b\\",
    b"\x1bP!|00000000\x1b\\",
    b"\x1bXquit\x1b\\",
    b"\x1b^quit\x1b\\",
    b"\x1b_Gi=31;OK\x1b\\",
    b"\x9d11;rgb:1e1e/1e1e/1e1e\x9c",
    b"\x90quit\x9c",
    // Attributes, cursor position, state, size, modes.
    b"\x1b[?1;2c",
    b"\x1b[>0;276;0c",
    b"\x1b[0n",
    b"\x1b[24;80R",
    b"\x1b[1;2R",
    b"\x1b[8;24;80t",
    b"\x1b[?2026;2$y",
    b"\x1b[4;1$y",
    b"\x1b[?0u",
    b"\x1b[?1;0;256S",
    // Focus, mouse of three kinds, release of a key.
    b"\x1b[I",
    b"\x1b[O",
    b"\x1b[M qQ",
    b"\x1b[<0;10;10M",
    b"\x1b[<65;1;1m",
    b"\x1b[32;10;10M",
    b"\x1b[97;5:3u",
    b"\x1b[1;1:3C",
    // Insert, keypad 5 and others have no name here.
    b"\x1b[2~",
    b"\x1b[E",
    b"\x1bOE",
    b"\x1b[57441u",
    b"\x1b[201~",
    // Too long, nonsense, cancelled.
    b"\x1b[999999999999999999999999999999999999999999999999999999999999999999999999999999C",
    b"\x1b[1;2;3;4;5;6;7;8z",
    b"\x1b]11;rgb\x18",
    // Not UTF-8, overlong, surrogates, controls of two bytes.
    b"\xff\xfe",
    b"\xc0\xaf",
    b"\xe0\x80\xaf",
    b"\xed\xa0\x80",
    b"\xf5\x80\x80\x80",
    b"\xc2\x9b",
];

/// Feeds pieces and says what came out, in words; a silence after each piece but not within.
fn words(pieces: &[&[u8]], silence: bool) -> String {
    let mut decoder = Decoder::new();
    let mut out = Vec::new();
    for piece in pieces {
        decoder.feed(piece, &mut out);
        if silence {
            quiet(&mut decoder, &mut out);
        }
    }
    quiet(&mut decoder, &mut out);
    spell(&out)
}

/// A long silence. It must end.
fn quiet(decoder: &mut Decoder, out: &mut Vec<Typed>) {
    for _ in 0..4 {
        if decoder.patience().is_none() {
            return;
        }
        decoder.idle(out);
    }
    panic!("still waiting: {decoder:?}");
}

fn spell(typed: &[Typed]) -> String {
    let spelled = typed.iter().map(|typed| match typed {
        Typed::Key(key) => key.to_string(),
        Typed::Paste(text) => format!("<{text}>"),
    });
    spelled.collect::<Vec<_>>().join(" ")
}

/// All ways to cut in two and in three, and into single bytes.
fn cuts(bytes: &[u8]) -> Vec<Vec<&[u8]>> {
    let mut cuts = vec![bytes.chunks(1).collect()];
    for i in 0..=bytes.len() {
        for j in i..=bytes.len() {
            cuts.push(vec![&bytes[..i], &bytes[i..j], &bytes[j..]]);
        }
    }
    cuts
}

#[test]
fn every_key_however_it_is_cut() {
    for (bytes, keys) in KEYS {
        for pieces in cuts(bytes) {
            assert_eq!(words(&pieces, false), *keys, "{}", bytes.escape_ascii());
        }
    }
}

#[test]
fn answers_and_nonsense_are_no_keys_however_they_are_cut() {
    for bytes in NO_KEYS {
        for pieces in cuts(bytes) {
            assert_eq!(words(&pieces, false), "", "{}", bytes.escape_ascii());
        }
    }
}

#[test]
fn what_follows_is_a_key_again() {
    for (bytes, keys) in KEYS.iter().copied().chain(NO_KEYS.iter().map(|bytes| (*bytes, ""))) {
        let both = [bytes, b"w\x1b[B"].concat();
        let wanted = format!("{keys} w Down");
        assert_eq!(words(&[&both], false), wanted.trim_start(), "{}", bytes.escape_ascii());
    }
}

#[test]
fn after_a_silence_a_lone_escape_is_a_key() {
    assert_eq!(words(&[b"\x1b"], true), "Esc");
    assert_eq!(words(&[b"\x1b\x1b"], true), "Esc Esc");
    assert_eq!(words(&[b"\x1b", b"q"], true), "Esc q");
    let mut decoder = Decoder::new();
    decoder.feed(b"\x1b", &mut Vec::new());
    assert_eq!(decoder.patience(), Some(Duration::from_millis(50)));
}

/// Escape itself has been given out by then; but no rest of a sequence becomes letters.
#[test]
fn a_rest_that_comes_too_late_is_still_no_text() {
    for (rest, keys) in [
        (&b"[C"[..], "Esc Right"),
        (b"OC", "Esc Right"),
        (b"[1;5D", "Esc Ctrl+Left"),
        (b"[3~", "Esc Delete"),
        (b"[24;80R", "Esc"),
        (b"]11;rgb:1e1e/1e1e/1e1e\x1b\\", "Esc"),
    ] {
        let mut decoder = Decoder::new();
        let mut out = Vec::new();
        decoder.feed(b"\x1b", &mut out);
        decoder.idle(&mut out);
        decoder.feed(rest, &mut out);
        quiet(&mut decoder, &mut out);
        assert_eq!(spell(&out), keys);
    }
}

#[test]
fn brackets_after_an_escape_are_keys_again_after_a_silence() {
    assert_eq!(words(&[b"\x1b", b"[", b"C"], true), "Esc [ C");
    assert_eq!(words(&[b"\x1b["], true), "Esc [");
    assert_eq!(words(&[b"\x1bO"], true), "Esc O");
    assert_eq!(words(&[b"\x1bP"], true), "Esc P");
    // A letter that repeats while it is held.
    let mut decoder = Decoder::new();
    let mut out = Vec::new();
    decoder.feed(b"\x1b", &mut out);
    decoder.idle(&mut out);
    decoder.feed(b"OOOO", &mut out);
    quiet(&mut decoder, &mut out);
    assert_eq!(spell(&out), "Esc O O O O");
}

#[test]
fn a_string_without_its_end_ends_with_silence_or_with_the_next_key() {
    assert_eq!(words(&[b"\x1b]11;rgb:1e1e", b"q"], true), "q");
    assert_eq!(words(&[b"\x1bP1$r0m", b"q"], true), "q");
    assert_eq!(words(&[b"\x1b]11;rgb:1e1e\x1b[Aq"], false), "Up q");
    assert_eq!(words(&[b"\x1b[1;5", b"q"], true), "q");
    assert_eq!(words(&[b"\x1b[1;5\x1b[Aq"], false), "Up q");
    assert_eq!(words(&[b"\x1b[M !", b"q"], true), "q");
    assert_eq!(words(&[b"\xe2\x82", b"q"], true), "q");
}

#[test]
fn pastes_are_text_without_commands() {
    for (pasted, text) in [
        (&b"2.75"[..], "2.75"),
        (b"", ""),
        (b"a\r\nb\tc", "a\r\nb\tc"),
        (b"\x1b[31mred\x07\x00\x7f", "[31mred"),
        (b"\x1b]52;c;eA==\x07", "]52;c;eA=="),
        (b"\x1b[20", "[20"),
        (b"\x1b\x1b[201", "[201"),
        (b"\xff\xfe\x80ok", "ok"),
        (b"\xc2\x9b2J", "2J"),
        ("\u{202e}abc\u{200f}é漢".as_bytes(), "abcé漢"),
    ] {
        let bytes = [b"\x1b[200~", pasted, b"\x1b[201~q"].concat();
        for pieces in cuts(&bytes) {
            assert_eq!(words(&pieces, false), format!("<{text}> q"), "{}", pasted.escape_ascii());
        }
    }
}

#[test]
fn a_paste_without_its_end_ends_with_silence() {
    assert_eq!(words(&[b"\x1b[200~hello", b"q"], true), "<hello> q");
    assert_eq!(words(&[b"\x1b[200~hello\x1b[2", b"q"], true), "<hello> q");
}

#[test]
fn of_a_huge_paste_the_beginning_is_kept_and_the_end_is_found() {
    let bytes = [b"\x1b[200~", "é".repeat(1 << 20).as_bytes(), b"\x1b[201~q"].concat();
    let mut decoder = Decoder::new();
    let mut out = Vec::new();
    bytes.chunks(1000).for_each(|chunk| decoder.feed(chunk, &mut out));
    let [Typed::Paste(text), Typed::Key(key)] = &out[..] else { panic!("{}", out.len()) };
    assert_eq!(*key, Key::char('q'));
    assert_eq!(text.len(), LONGEST_PASTE);
    assert!(text.chars().all(|c| c == 'é'));
}

/// Bytes that mean something, more often than chance would have them.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let telling =
        prop::sample::select(b"\x1b\x1b[]OPM<?;:$~\\0123456789CRu^_\x07\x9b\x9c".to_vec());
    let pieces = prop_oneof![
        4 => telling.prop_map(|byte| vec![byte]),
        2 => any::<u8>().prop_map(|byte| vec![byte]),
        1 => prop::sample::select(KEYS).prop_map(|(bytes, _)| bytes.to_vec()),
        1 => prop::sample::select(NO_KEYS).prop_map(<[u8]>::to_vec),
        1 => Just(b"\x1b[200~".to_vec()),
        1 => Just(b"\x1b[201~".to_vec()),
    ];
    prop::collection::vec(pieces, 0..60).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    /// No panic, no waiting without end, and the pieces make no difference.
    #[test]
    fn random_bytes_give_the_same_however_they_are_cut(bytes in bytes(), size in 1..20_usize) {
        let pieces: Vec<&[u8]> = bytes.chunks(size).collect();
        let whole = words(&[&bytes], false);
        prop_assert_eq!(words(&pieces, false), whole);
        words(&pieces, true);
    }

    /// Whatever came before, a key after a silence is that key.
    #[test]
    fn after_a_silence_the_keyboard_lives(bytes in bytes()) {
        let after = words(&[&bytes, b"w"], true);
        prop_assert!(after.ends_with('w'), "{after}");
    }

    /// Control characters never come out.
    #[test]
    fn no_control_character_comes_out(bytes in bytes()) {
        let mut out = Vec::new();
        let mut decoder = Decoder::new();
        decoder.feed(&bytes, &mut out);
        quiet(&mut decoder, &mut out);
        for typed in out {
            match typed {
                Typed::Key(Key { code: Code::Char(c), .. }) => prop_assert!(!c.is_control()),
                Typed::Key(_) => {}
                Typed::Paste(text) => {
                    prop_assert!(text.chars().all(|c| !c.is_control() || "\r\n\t".contains(c)));
                }
            }
        }
    }
}
