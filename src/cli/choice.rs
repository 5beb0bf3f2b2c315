//! Choices on the command line, by their words.

use crate::words::Choice;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// One of some choices.
pub(crate) fn one_of<T: Choice>(choices: &'static [T]) -> impl TypedValueParser<Value = T> {
    parser(choices.iter().map(|one| PossibleValue::new(one.word())))
}

/// One of some choices, with what each of them means for the long help.
pub(crate) fn explained<T: Choice>(
    choices: &'static [(T, &'static str)],
) -> impl TypedValueParser<Value = T> {
    parser(choices.iter().map(|(one, help)| PossibleValue::new(one.word()).help(*help)))
}

fn parser<T: Choice>(
    values: impl Iterator<Item = PossibleValue>,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(values)
        .map(|word| T::from_word(&word).expect("no other word comes through the parser in front"))
}
