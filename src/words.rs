//! Words: of choices, and mistyped ones with the known one that was meant.

use strsim::levenshtein;

/// Something chosen from a few, each with a word of its own in files, on the command line, among the
/// settings and for people.
pub trait Choice: Copy + PartialEq + Send + Sync + 'static {
    /// All of them, in the order in which they are listed.
    const ALL: &'static [Self];

    /// The word of one.
    fn word(self) -> &'static str;

    /// The one of a word.
    fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|one| one.word() == word)
    }
}

/// Whether a character can be shown as it is: no control character, which would be a command to a
/// terminal, and none that turns the direction of the text around it, which makes a line read otherwise
/// than it is.
pub(crate) fn shown(c: char) -> bool {
    let turns = matches!(
        c,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    !turns && !c.is_control()
}

/// Whether a character can stand in a text of several lines.
pub(crate) fn in_text(c: char) -> bool {
    shown(c) || matches!(c, '\n' | '\r' | '\t')
}

/// The words of some choices.
pub(crate) fn words_of<T: Choice>(choices: &[T]) -> Vec<&'static str> {
    choices.iter().map(|one| one.word()).collect()
}

/// The known word that differs least from `typed`, if it is near enough to be what was meant: at most
/// one change for every three letters, capitals aside, or the only one that begins so.
pub(crate) fn nearest<'a>(typed: &str, known: &[&'a str]) -> Option<&'a str> {
    let typed = typed.trim().to_lowercase();
    known
        .iter()
        .map(|word| {
            let lower = word.to_lowercase();
            let longer = lower.chars().count().max(typed.chars().count());
            (levenshtein(&typed, &lower), longer, *word)
        })
        .filter(|(changes, length, _)| changes * 3 <= *length)
        .min_by_key(|(changes, ..)| *changes)
        .map(|(.., word)| word)
        .or_else(|| only_beginning(&typed, known))
}

/// The only known word that begins with what was typed, three letters at least.
fn only_beginning<'a>(typed: &str, known: &[&'a str]) -> Option<&'a str> {
    let mut longer = known.iter().filter(|word| word.to_lowercase().starts_with(typed));
    let first = longer.next().filter(|_| typed.chars().count() >= 3)?;
    longer.next().is_none().then_some(*first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_turned_text_are_not_shown() {
        for c in ['\u{1b}', '\u{7}', '\u{9b}', '\u{7f}', '\n', '\u{202e}', '\u{2066}', '\u{200f}'] {
            assert!(!shown(c), "{c:?}");
        }
        // Letters of any direction, and the joiners that spell words.
        for c in ['a', 'ö', 'ش', 'ש', '漢', '\u{200d}', ' ', '\u{a0}'] {
            assert!(shown(c), "{c:?}");
        }
        assert!(in_text('\n') && in_text('\t') && !in_text('\u{1b}'));
    }

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let known = ["bench 2", "bench 3", "gully"];
        assert_eq!(nearest("Bench2", &known), Some("bench 2"));
        assert_eq!(nearest("guly", &known), Some("gully"));
        assert_eq!(nearest("portal", &known), None);
        assert_eq!(nearest("", &known), None);
        assert_eq!(nearest("dt-8x10", &["dt-8x10-2.7", "dt-6x8-2.2"]), Some("dt-8x10-2.7"));
        assert_eq!(nearest("ben", &known), None);
        assert_eq!(nearest("x", &[]), None);
    }
}
