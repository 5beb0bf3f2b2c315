//! The flags of a case's inputs, made from the table of inputs.

use super::quantity;
use crate::case::Input;
use crate::units::Quantity;
use clap::builder::ValueParser;
use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};

/// Inputs that were given by their flags, SI: those of the geometry, or those of the question.
#[derive(Debug, Clone, Default)]
pub(crate) struct InputFlags<const QUESTION: bool>(Vec<(Input, f64)>);

impl<const QUESTION: bool> InputFlags<QUESTION> {
    fn inputs() -> impl Iterator<Item = Input> {
        let all = if QUESTION { &Input::QUESTION[..] } else { &Input::GEOMETRY[..] };
        all.iter().copied()
    }

    /// What was given.
    pub(crate) fn given(&self) -> impl Iterator<Item = (Input, f64)> + '_ {
        self.0.iter().copied()
    }

    /// Takes a value for what was not given, of inputs that have a flag here.
    pub(crate) fn default_to(&mut self, defaults: &[(Input, f64)]) {
        for (input, value) in defaults {
            let known = Self::inputs().any(|known| known == *input);
            if known && !self.0.iter().any(|(given, _)| given == input) {
                self.0.push((*input, *value));
            }
        }
    }

    fn read(matches: &ArgMatches) -> Self {
        let value = |input: Input| matches.get_one::<f64>(input.row().name).map(|v| (input, *v));
        InputFlags(Self::inputs().filter_map(value).collect())
    }
}

impl<const QUESTION: bool> FromArgMatches for InputFlags<QUESTION> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        Ok(Self::read(matches))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::read(matches);
        Ok(())
    }
}

impl<const QUESTION: bool> Args for InputFlags<QUESTION> {
    fn augment_args(command: Command) -> Command {
        command.args(Self::inputs().map(flag))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

fn flag(input: Input) -> Arg {
    let row = input.row();
    let arg = match row.flag.strip_prefix("--") {
        Some(long) => Arg::new(row.name).long(long),
        // A dash and one letter.
        None => Arg::new(row.name).short(row.flag.chars().nth(1)),
    };
    arg.help(row.help)
        .value_name(match row.quantity {
            Quantity::Length => "M",
            Quantity::Force => "KN",
            Quantity::Pressure => "KPA",
            Quantity::Number => "X",
        })
        .allow_hyphen_values(true)
        .value_parser(ValueParser::new(move |text: &str| quantity::of_input(input, text)))
}
