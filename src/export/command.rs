//! The command lines that give the numbers of a layout again, to the last bit.

use super::ExportedLayout;
use crate::case::Input;
use crate::case::input::Missing;
use crate::layout::{Blocks, BranchRule, MethodChoice, PunchShape, Twists};
use crate::mesh::catalogue;
use crate::units::{Quantity, from_kn, shortest, to_kn};
use crate::words::Choice;

/// The command that forecasts a layout from its project file.
pub(crate) fn from_file(file_name: &str, case: &ExportedLayout) -> String {
    // In one word, so that no name is taken for another flag.
    let layout = format!("--layout={}", case.entry.name);
    format!("meshcast forecast {} {}", file_word(file_name), quoted(&layout))
}

/// The name of a file as a shell takes it; one that begins like a flag is not taken for one.
pub(crate) fn file_word(file_name: &str) -> String {
    if file_name.starts_with('-') { quoted(&format!("./{file_name}")) } else { quoted(file_name) }
}

/// The command that forecasts a layout from its numbers alone; only where the mesh is the
/// catalogue's, because the command line can name no other.
pub(crate) fn from_numbers(case: &ExportedLayout) -> Option<String> {
    if catalogue::find(&case.case.mesh.id).is_none_or(|mesh| *mesh != *case.case.mesh) {
        return None;
    }
    let case = &case.case;
    let given = |inputs: &[Input]| -> Vec<String> {
        let text = |input: Input| {
            let text = flag(input, case.get(input)?)?;
            let two = input == Input::Spacing && case.layout.grid.up.is_some();
            Some(if two { text.replacen("-L", "--Lx", 1) } else { text })
        };
        inputs.iter().filter_map(|input| text(*input)).collect()
    };
    let mut words = vec!["meshcast forecast".to_string()];
    words.extend(given(&Input::GEOMETRY));
    if case.layout.grid.stagger {
        words.push("--stagger".to_string());
    }
    if case.layout.grid.twists != Twists::default() {
        words.push(format!("--twists {}", case.layout.grid.twists.word()));
    }
    if case.layout.shape != PunchShape::default() {
        words.push(format!("--shape {}", case.layout.shape.word()));
    }
    if case.layout.blocks != Blocks::default() {
        words.push(format!("--blocks {}", case.layout.blocks.word()));
    }
    if case.layout.method != MethodChoice::default() {
        words.push(format!("--method {}", case.layout.method.word()));
    }
    words.push(format!("--mesh {}", quoted(&case.mesh.id)));
    if case.rule != BranchRule::default() {
        words.push(format!("--branch {}", case.rule.word()));
    }
    words.extend(given(&Input::QUESTION));
    Some(words.join(" "))
}

/// The flag with a value; nothing where it would say what holds anyway.
fn flag(input: Input, value: f64) -> Option<String> {
    let row = input.row();
    let text = match row.quantity {
        Quantity::Force => kilo_word(value, "N"),
        Quantity::Pressure => kilo_word(value, "Pa"),
        Quantity::Length | Quantity::Number => bare(value),
    };
    // One word, because a negative number would look like a flag of its own.
    let between = if input.is_offset() { "=" } else { " " };
    (row.missing != Missing::Means(value)).then(|| format!("{}{between}{text}", row.flag))
}

/// A number that is read back as the same number: free of noise where that holds.
fn bare(value: f64) -> String {
    let short = shortest(value);
    if short.parse() == Ok(value) { short } else { value.to_string() }
}

/// A number in thousands of its unit, or with the unit where that does not lead back to it.
fn kilo_word(si: f64, unit: &str) -> String {
    let short = shortest(to_kn(si));
    if short.parse().map(from_kn) == Ok(si) { short } else { format!("{si}{unit}") }
}

/// A word for a shell: in quotes where it needs them.
pub(crate) fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '/' | '.' | '-' | '_' | '+' | '=');
    if !word.is_empty() && word.chars().all(plain) {
        word.to_string()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_to_the_bit() {
        for value in [0.25, 0.1 + 0.2, 1.0 / 3.0, 1e-6] {
            assert_eq!(bare(value).parse(), Ok(value));
        }
        assert_eq!(kilo_word(15_300.0, "N"), "15.3");
        assert_eq!(kilo_word(15_300.000_000_000_002, "Pa"), "15300.000000000002Pa");
    }

    #[test]
    fn words_are_quoted_where_a_shell_needs_it() {
        assert_eq!(quoted("road-cut.ron"), "road-cut.ron");
        assert_eq!(quoted("--layout=it's $HOME"), "'--layout=it'\\''s $HOME'");
    }
}
