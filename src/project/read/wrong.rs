//! What goes wrong while a value is read, as serde sees it.

use crate::problem::Problem;
use crate::project::words;
use serde::de::{Error, Expected, Unexpected};
use std::fmt;

/// Why there is no value.
#[derive(Debug)]
pub(crate) enum Wrong {
    /// It was noted already, at its place.
    Noted,
    /// What is wrong, from someone who does not know where it stands. A field that it names is below
    /// the value that is being read.
    Said(Box<Problem>),
}

impl Wrong {
    fn said(problem: Problem) -> Self {
        Wrong::Said(Box::new(problem))
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Wrong::Noted => f.write_str("noted"),
            Wrong::Said(problem) => write!(f, "{problem}"),
        }
    }
}

impl std::error::Error for Wrong {}

impl Error for Wrong {
    fn custom<T: fmt::Display>(said: T) -> Self {
        Wrong::said(Problem::new("", said.to_string()))
    }

    fn invalid_type(_: Unexpected, expected: &dyn Expected) -> Self {
        Wrong::said(Problem::new("", words::expected(&expected.to_string())))
    }

    fn invalid_value(_: Unexpected, expected: &dyn Expected) -> Self {
        Wrong::said(Problem::new("", words::expected(&expected.to_string())))
    }

    fn invalid_length(_: usize, expected: &dyn Expected) -> Self {
        Wrong::said(Problem::new("", words::expected(&expected.to_string())))
    }

    fn unknown_variant(_: &str, expected: &'static [&'static str]) -> Self {
        Wrong::said(words::unknown_word(words::one_of(expected)))
    }

    fn unknown_field(field: &str, expected: &'static [&'static str]) -> Self {
        Wrong::said(words::unknown_field("", field, field, expected))
    }

    fn missing_field(field: &'static str) -> Self {
        Wrong::said(words::missing_field(field))
    }

    fn duplicate_field(field: &'static str) -> Self {
        Wrong::said(words::repeated_field(field))
    }
}
