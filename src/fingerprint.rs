//! Fingerprints of inputs: a result names the inputs it was made from by a short stable number, so
//! that a result whose inputs have changed is never taken for a current one.
//!
//! FNV-1a, 64 bits: the same on every machine and in every version of the language's library. It
//! tells inputs apart; it is no protection against someone who wants two of them to look alike.
//!
//! Prints are kept in files, so they must outlive the program that made them:
//!
//! - what every result of a kind has had from the first is taken by its place (`text`, `number`,
//!   `optional`, `flag`), and that list never changes;
//! - what may be at a default, and every input that is added later, is taken by its name
//!   ([`Fingerprinter::with`], [`Fingerprinter::given`]), and at its default adds nothing: a new input
//!   leaves the prints of all that do not use it as they were. Names stand in one order, new ones last;
//! - what decides how a result is computed, and is no input, is told by revisions beside the print (see
//!   [`crate::study::result::Revisions`]), never by the program's version or commit.

use std::fmt;

/// Fingerprint of inputs; equal inputs have equal fingerprints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Fingerprint(pub(crate) u64);

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// Gathers inputs, in an order that the caller keeps for ever; see the head of this file.
#[derive(Debug, Clone)]
pub(crate) struct Fingerprinter(u64);

/// Start value and factor of FNV-1a for 64 bits (Fowler, Noll, Vo).
const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

impl Fingerprinter {
    /// Starts with a word for the kind of inputs, so that different kinds never look alike.
    pub(crate) fn new(kind: &str) -> Self {
        Fingerprinter(OFFSET_BASIS).text(kind)
    }

    /// Takes a text; its length goes first, so that neighbours do not run together.
    pub(crate) fn text(self, text: &str) -> Self {
        self.bytes(&(text.len() as u64).to_le_bytes()).bytes(text.as_bytes())
    }

    /// Takes a number to the last bit; the two zeros are the same.
    pub(crate) fn number(self, value: f64) -> Self {
        self.bytes(&(value + 0.0).to_bits().to_le_bytes())
    }

    /// Takes a number that may be missing.
    pub(crate) fn optional(self, value: Option<f64>) -> Self {
        match value {
            Some(value) => self.flag(true).number(value),
            None => self.flag(false),
        }
    }

    /// Takes a yes or no.
    pub(crate) fn flag(self, yes: bool) -> Self {
        self.bytes(&[u8::from(yes)])
    }

    /// Takes an input by its name; at its default it adds nothing.
    ///
    /// Numbers are taken as the shortest text that reads back as the same number.
    pub(crate) fn with<T: PartialEq + fmt::Display>(
        self,
        name: &str,
        value: T,
        default: T,
    ) -> Self {
        self.given(name, (value != default).then_some(value))
    }

    /// Takes an input by its name, where it is given; a missing one adds nothing.
    pub(crate) fn given(self, name: &str, value: Option<impl fmt::Display>) -> Self {
        match value {
            Some(value) => self.text(name).text(&value.to_string()),
            None => self,
        }
    }

    /// The fingerprint of all that was taken.
    pub(crate) fn finish(self) -> Fingerprint {
        Fingerprint(self.0)
    }

    fn bytes(mut self, bytes: &[u8]) -> Self {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_test_values_of_the_hash() {
        // From the authors' table of FNV-1a for 64 bits: the empty text, "a" and "foobar".
        let of = |text: &str| Fingerprinter(OFFSET_BASIS).bytes(text.as_bytes()).finish();
        assert_eq!(of("").to_string(), "cbf29ce484222325");
        assert_eq!(of("a").to_string(), "af63dc4c8601ec8c");
        assert_eq!(of("foobar").to_string(), "85944171f73967e8");
    }

    #[test]
    fn neighbours_do_not_run_together_and_zero_has_no_sign() {
        let of = |a: &str, b: &str| Fingerprinter::new("").text(a).text(b).finish();
        assert_ne!(of("ab", "c"), of("a", "bc"));
        let zero = |v: f64| Fingerprinter::new("").number(v).finish();
        assert_eq!(zero(0.0), zero(-0.0));
        assert_ne!(zero(0.0), zero(f64::MIN_POSITIVE));
        let maybe = |v| Fingerprinter::new("").optional(v).finish();
        assert_ne!(maybe(None), maybe(Some(0.0)));
    }
    #[test]
    fn a_named_input_at_its_default_adds_nothing() {
        let base = Fingerprinter::new("").number(1.0);
        let plain = base.clone().finish();
        assert_eq!(
            base.clone().with("stagger", false, false).given("Lx", None::<f64>).finish(),
            plain
        );
        assert_eq!(base.clone().with("ex", -0.0, 0.0).finish(), plain);
        let all = [
            plain,
            base.clone().with("ex", 0.1, 0.0).finish(),
            base.clone().with("ey", 0.1, 0.0).finish(),
            base.clone().with("ex", 0.1 + f64::EPSILON, 0.0).finish(),
            base.clone().given("ez", Some(0.0)).finish(),
            base.with("ex", 0.1, 0.0).with("ey", 0.1, 0.0).finish(),
        ];
        for (k, one) in all.iter().enumerate() {
            assert!(!all[..k].contains(one), "{k}");
        }
    }
}
