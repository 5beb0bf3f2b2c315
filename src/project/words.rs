//! Wording that the room's messages share: the closest known field, ranges, shortened values.

use crate::case::Input;
use crate::problem::Problem;
use crate::units::Quantity;
use strsim::levenshtein;

/// Longest piece of a file that is shown in a message, in characters.
const LONGEST_SHOWN: usize = 40;

/// A piece of the file as a message shows it: on one line, without control characters, not too long.
pub(crate) fn shorten(text: &str) -> String {
    let mut out = String::new();
    let mut blank = false;
    for c in text.chars() {
        if c.is_whitespace() || c.is_control() {
            blank = !out.is_empty();
            continue;
        }
        if out.chars().count() >= LONGEST_SHOWN {
            out.push_str("...");
            return out;
        }
        if std::mem::take(&mut blank) {
            out.push(' ');
        }
        out.push(c);
    }
    out
}

/// Other names under which people look for a field.
const ALSO_CALLED: &[(&str, &str)] = &[
    ("plate", "d"),
    ("spacing", "L"),
    ("punch", "D"),
    ("e_x", "ex"),
    ("e_y", "ey"),
    ("force", "design_force"),
    ("load", "design_force"),
    ("deflection", "allowable_deflection"),
    ("allowable", "allowable_deflection"),
    ("gamma_r", "gamma_resistance"),
    ("gamma_m", "gamma_resistance"),
    ("gamma_f", "gamma_load"),
    ("notes", "note"),
    ("note", "notes"),
    ("mesh", "meshes"),
    ("layout", "layouts"),
    ("title", "name"),
    ("location", "site"),
    ("units", "length_unit"),
    ("unit", "length_unit"),
];

/// The known name that was most likely meant, if one is near.
pub(crate) fn closest<'k>(written: &str, known: &[&'k str]) -> Option<&'k str> {
    // Words longer than any field name are far enough.
    let lower: String = written.to_lowercase().chars().take(64).collect();
    let itself = known.iter().map(|k| (*k, *k));
    let other = ALSO_CALLED
        .iter()
        .filter_map(|(other, name)| known.iter().find(|k| *k == name).map(|k| (*other, *k)));
    itself
        .chain(other)
        .map(|(called, name)| (levenshtein(&lower, &called.to_lowercase()), called, name))
        .filter(|(steps, called, _)| *steps <= called.len().min(6) / 2)
        .min_by_key(|(steps, ..)| *steps)
        .map(|(.., name)| name)
}

/// A field that is not known at its place.
pub(crate) fn unknown_field(path: &str, key: &str, known: &[&str]) -> Problem {
    let problem =
        Problem::new(path, "there is no field of this name here").allowed(known.join(", "));
    match closest(key, known) {
        Some(name) => problem.advice(format!("is {name} meant?")),
        None => problem,
    }
}

/// An example of a field's value.
pub(crate) fn example(field: &str) -> &'static str {
    if let Some(input) = Input::named(field) {
        return input.row().example;
    }
    match field {
        "version" => "1",
        "layouts" => "[]",
        "id" => "\"my-mesh\"",
        "force" => "73.3",
        "deflection" => "0.60",
        "statistic" => "Mean",
        "laboratory" => "(force: 73.3, deflection: 0.60, statistic: Mean, source: \"...\")",
        "source" => "\"where the values stand\"",
        "net" => {
            "(opening: 0.08, twist: 0.04, projection: 0.04, diameter: 0.0027, node_mass: 0.0039, node_radius: 0.0108)"
        }
        "single" | "double_twist" => "[(0.002, 250.0), (0.14, 566.0)] (strain, stress in MPa)",
        "slack" => "Triangular",
        "opening" => "0.08",
        "twist" | "projection" => "0.04",
        "diameter" => "0.0027",
        "node_mass" => "0.0039",
        "node_radius" => "0.0108",
        "lambda_u" => "0.03",
        "lambda_f" => "1.0",
        _ => "\"...\"",
    }
}

/// What a quantity looks like in a file.
pub(crate) fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Length => "a length, a number in m or a text such as \"250 mm\",",
        Quantity::Force => "a force, a number in kN or a text such as \"73.3 kN\",",
        Quantity::Number => "a number",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shown_values_stay_on_one_short_line() {
        assert_eq!(shorten("(\n   a: 1,\t\u{1b}[31m b)"), "(a: 1, [31m b)".replace("(a", "( a"));
        assert_eq!(shorten(&"x".repeat(500)).len(), LONGEST_SHOWN + 3);
    }
}
