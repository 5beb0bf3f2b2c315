//! What the terminal at hand can show, as far as the environment tells.
//!
//! None of this can be asked of a terminal reliably, least of all through a serial line or two shells, so
//! the user's word (`--color`, `--glyphs`, `NO_COLOR`) stands above every guess.

use super::cells::Charset;
use crate::app::look::{ColorChoice, ColorMode, Glyphs, Look};

/// The surroundings that matter, read once.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Surroundings {
    /// `TERM`, empty when unset.
    pub(crate) term: String,
    /// `NO_COLOR` is set and not empty.
    pub(crate) no_color: bool,
    /// The locale's character set is UTF-8.
    pub(crate) utf8: bool,
}

impl Surroundings {
    /// From this process's environment.
    pub fn of_process() -> Surroundings {
        Surroundings::from_lookup(|name| {
            std::env::var_os(name).map(|value| value.to_string_lossy().into_owned())
        })
    }

    /// From any environment.
    pub(crate) fn from_lookup(get: impl Fn(&str) -> Option<String>) -> Surroundings {
        let filled = |name: &str| get(name).filter(|value| !value.is_empty());
        let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(filled);
        let locale = locale.unwrap_or_default().to_ascii_lowercase();
        Surroundings {
            term: filled("TERM").unwrap_or_default(),
            no_color: filled("NO_COLOR").is_some(),
            utf8: locale.contains("utf-8") || locale.contains("utf8"),
        }
    }

    /// Colours and glyphs: the user's choice, or what suits the terminal.
    pub fn look(&self, color: ColorChoice, glyphs: Option<Glyphs>) -> Look {
        let color = match color {
            ColorChoice::Basic16 => ColorMode::Basic16,
            ColorChoice::None => ColorMode::None,
            ColorChoice::Auto if self.no_color || self.is_colorless() => ColorMode::None,
            ColorChoice::Auto => ColorMode::Basic16,
        };
        Look { color, glyphs: glyphs.unwrap_or_else(|| self.default_glyphs()) }
    }

    /// What may be sent. Glyphs that the user asked for count as a promise that they arrive.
    pub fn charset(&self, glyphs: Option<Glyphs>) -> Charset {
        match glyphs {
            Some(Glyphs::Braille | Glyphs::Block) => Charset::Utf8,
            _ if self.utf8 && !self.is_serial() => Charset::Utf8,
            _ => Charset::Ascii,
        }
    }

    /// Whether what is to be copied may be sent (OSC 52). Old terminals would show it, and the Linux
    /// console has no clipboard.
    pub(crate) fn clipboard(&self) -> bool {
        !self.term.is_empty() && !self.is_serial() && !self.term.starts_with("linux")
    }

    fn default_glyphs(&self) -> Glyphs {
        if !self.utf8 || self.is_serial() {
            Glyphs::Ascii
        } else if self.term.starts_with("linux") || self.term.starts_with("putty") {
            // Their usual fonts have blocks and no braille.
            Glyphs::Block
        } else {
            Glyphs::Braille
        }
    }

    /// Real video terminals and what claims to be one.
    fn is_serial(&self) -> bool {
        self.term == "dumb" || self.term.starts_with("vt")
    }

    /// No colour, or no word about it.
    fn is_colorless(&self) -> bool {
        self.term.is_empty() || self.is_serial() || self.term.ends_with("-m")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surroundings(variables: &[(&str, &str)]) -> Surroundings {
        Surroundings::from_lookup(|name| {
            variables.iter().find(|(n, _)| *n == name).map(|(_, value)| (*value).to_owned())
        })
    }

    fn look(variables: &[(&str, &str)]) -> (ColorMode, Glyphs) {
        let look = surroundings(variables).look(ColorChoice::Auto, None);
        (look.color, look.glyphs)
    }

    #[test]
    fn terminals() {
        use ColorMode::{Basic16, None};
        use Glyphs::{Ascii, Block, Braille};
        let utf8 = ("LANG", "en_US.UTF-8");
        for (term, color, glyphs) in [
            ("xterm-256color", Basic16, Braille),
            ("xterm", Basic16, Braille),
            ("screen", Basic16, Braille),
            ("tmux-256color", Basic16, Braille),
            ("putty", Basic16, Block),
            ("linux", Basic16, Block),
            ("vt100", None, Ascii),
            ("dumb", None, Ascii),
            ("", None, Braille),
        ] {
            assert_eq!(look(&[("TERM", term), utf8]), (color, glyphs), "{term}");
        }
    }

    #[test]
    fn the_first_filled_locale_variable_counts() {
        let term = ("TERM", "xterm");
        assert_eq!(look(&[term, ("LC_ALL", ""), ("LANG", "C.utf8")]).1, Glyphs::Braille);
        assert_eq!(look(&[term, ("LC_ALL", "C"), ("LANG", "C.UTF-8")]).1, Glyphs::Ascii);
        assert_eq!(look(&[term, ("LC_CTYPE", "de_DE.UTF-8")]).1, Glyphs::Braille);
        assert_eq!(look(&[term]).1, Glyphs::Ascii);
    }

    #[test]
    fn no_color_counts_when_filled_and_the_users_word_counts_more() {
        let term = ("TERM", "xterm");
        assert_eq!(look(&[term, ("NO_COLOR", "1")]).0, ColorMode::None);
        assert_eq!(look(&[term, ("NO_COLOR", "")]).0, ColorMode::Basic16);
        let mono = surroundings(&[term, ("NO_COLOR", "1")]);
        assert_eq!(mono.look(ColorChoice::Basic16, None).color, ColorMode::Basic16);
        let plain = surroundings(&[("TERM", "vt100")]);
        let asked = plain.look(ColorChoice::Auto, Some(Glyphs::Braille));
        assert_eq!(asked.glyphs, Glyphs::Braille);
    }

    #[test]
    fn copies_go_to_terminals_that_pass_over_what_they_do_not_know() {
        for (term, takes) in [
            ("xterm-256color", true),
            ("tmux-256color", true),
            ("screen", true),
            ("putty", true),
            ("linux", false),
            ("vt220", false),
            ("dumb", false),
            ("", false),
        ] {
            assert_eq!(surroundings(&[("TERM", term)]).clipboard(), takes, "{term}");
        }
    }

    #[test]
    fn beyond_ascii_only_where_it_arrives() {
        let serial = surroundings(&[("TERM", "vt220"), ("LANG", "C.UTF-8")]);
        assert_eq!(serial.charset(None), Charset::Ascii);
        assert_eq!(serial.charset(Some(Glyphs::Block)), Charset::Utf8);
        let xterm = surroundings(&[("TERM", "xterm"), ("LANG", "C.UTF-8")]);
        assert_eq!(xterm.charset(None), Charset::Utf8);
        assert_eq!(xterm.charset(Some(Glyphs::Ascii)), Charset::Utf8);
        assert_eq!(surroundings(&[("TERM", "xterm")]).charset(None), Charset::Ascii);
    }
}
