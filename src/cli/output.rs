//! Results to standard output, everything else to standard error, and exit codes.

use crate::problem::Problem;
use crate::project::LoadError;
use crate::show::table::with_decimal_comma;
use clap::ValueEnum;
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};
use unicode_width::UnicodeWidthStr;

/// Exit code of a failure: a disk, a printed digit that differs.
pub(crate) const FAILURE: u8 = 1;
/// Exit code of bad input: a flag, a value, a file.
pub(crate) const BAD_INPUT: u8 = 2;
/// Exit code where a verdict was asked for and a layout fails.
pub(crate) const FAILS: u8 = 3;
/// Exit code where a verdict was asked for, none fails and one could not be judged.
pub(crate) const NOT_JUDGED: u8 = 4;
/// Exit code of a run that the user ended with Ctrl+C: 128 and the signal's number.
pub(crate) const INTERRUPTED: u8 = 130;

/// How a result is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum Format {
    /// A text for people.
    #[default]
    Text,
    /// JSON, SI with kN.
    Json,
}

/// How a result is written that is a table too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub(crate) enum TableFormat {
    /// A text for people.
    #[default]
    Text,
    /// JSON, SI with kN.
    Json,
    /// A table with a header line, SI with kN.
    Csv,
    /// The same for spreadsheets with a decimal comma: semicolons between the fields.
    CsvComma,
}

impl TableFormat {
    /// A result in this form.
    ///
    /// # Errors
    /// Why there is no JSON of it.
    pub(crate) fn write(
        self,
        text: impl FnOnce() -> String,
        json: impl FnOnce() -> Result<String, Fault>,
        csv: impl FnOnce() -> String,
    ) -> Result<String, Fault> {
        match self {
            TableFormat::Text => Ok(text()),
            TableFormat::Json => json(),
            TableFormat::Csv => Ok(csv()),
            TableFormat::CsvComma => Ok(with_decimal_comma(&csv())),
        }
    }
}

/// What a subcommand has to say when it went well.
#[derive(Debug, Default)]
pub(crate) struct Output {
    /// The result, for standard output, with its last line feed.
    pub(crate) result: String,
    /// Remarks, for standard error.
    pub(crate) notes: Vec<String>,
    /// Whether the result itself is bad news: exit code 1.
    pub(crate) failed: bool,
    /// Exit code of the verdict, where it was asked for and is no pass.
    pub(crate) verdict: Option<u8>,
    /// Whether the user ended it early, so that the result is a part: exit code 130.
    pub(crate) interrupted: bool,
}

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fault {
    /// Something that was typed or stands in a file is wrong; one sentence each.
    #[error("{}", .0.join("\n"))]
    Input(Vec<String>),
    /// The machine did not do what it was asked.
    #[error("{0}")]
    Failure(String),
}

impl Fault {
    /// One thing that is wrong with the input.
    pub(crate) fn input(said: impl Into<String>) -> Fault {
        Fault::Input(vec![said.into()])
    }
}

impl From<Vec<Problem>> for Fault {
    fn from(found: Vec<Problem>) -> Fault {
        Fault::Input(found.iter().map(Problem::to_string).collect())
    }
}

impl From<LoadError> for Fault {
    fn from(error: LoadError) -> Fault {
        if error.is_bad_input() {
            Fault::input(error.to_string())
        } else {
            Fault::Failure(error.to_string())
        }
    }
}

/// What a subcommand returns.
pub(crate) type CommandEnd = Result<Output, Fault>;

/// A result without remarks.
pub(crate) fn result(text: String) -> CommandEnd {
    Ok(Output { result: text, ..Output::default() })
}

/// Writes an outcome and returns the exit code.
pub(crate) fn finish(outcome: CommandEnd) -> ExitCode {
    match outcome {
        Ok(output) => {
            for note in &output.notes {
                say("note", note);
            }
            match to_stdout(&output.result) {
                Ok(()) if output.interrupted => ExitCode::from(INTERRUPTED),
                Ok(()) if output.failed => ExitCode::from(FAILURE),
                Ok(()) => output.verdict.map_or(ExitCode::SUCCESS, ExitCode::from),
                // The reader has what it wanted: `| head` is no failure.
                Err(e) if e.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
                Err(e) => {
                    say("error", &format!("the result cannot be written: {e}"));
                    ExitCode::from(FAILURE)
                }
            }
        }
        Err(fault) => {
            let code = match &fault {
                Fault::Input(all) => {
                    all.iter().for_each(|one| say("error", one));
                    BAD_INPUT
                }
                Fault::Failure(one) => {
                    say("error", one);
                    FAILURE
                }
            };
            ExitCode::from(code)
        }
    }
}

/// Says something on standard error; where nobody listens, nothing happens.
pub(crate) fn say(kind: &str, text: &str) {
    let _ = writeln!(io::stderr(), "{kind}: {text}");
}

fn to_stdout(text: &str) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()
}

/// JSON of a value that is made of structs, lists, texts and finite numbers.
pub(crate) fn json(value: &impl serde::Serialize) -> Result<String, Fault> {
    serde_json::to_string(value)
        .map_err(|e| Fault::Failure(format!("the result cannot be written as JSON: {e}")))
}

/// JSON objects as one line each in a list, or the one object alone.
pub(crate) fn json_list<T: serde::Serialize>(
    objects: impl IntoIterator<Item = T>,
    several: bool,
) -> Result<String, Fault> {
    let objects = objects.into_iter().map(|o| json(&o)).collect::<Result<Vec<String>, Fault>>()?;
    Ok(match objects.as_slice() {
        [one] if !several => format!("{one}\n"),
        [] => "[]\n".to_string(),
        all => format!("[\n{}\n]\n", all.join(",\n")),
    })
}

/// Breaks a text into lines of at most `width` columns: the first begins with `head`, the others are
/// indented to the width of it. A word that is too long stands on a line of its own.
pub(crate) fn wrapped(head: &str, text: &str, width: usize) -> Vec<String> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() {
        return vec![head.trim_end().to_string()];
    }
    let indent = " ".repeat(head.width());
    let options = Options::new(width)
        .initial_indent(head)
        .subsequent_indent(&indent)
        .break_words(false)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    textwrap::wrap(&text, options).into_iter().map(std::borrow::Cow::into_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words_and_keep_their_indent() {
        assert_eq!(wrapped("ab  ", "one two three", 11), ["ab  one two", "    three"]);
        assert_eq!(wrapped("a ", "", 10), ["a"]);
        assert_eq!(wrapped("", "immeasurable", 4), ["immeasurable"]);
    }
}
