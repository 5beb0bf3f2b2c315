//! The words of this room's messages, in one place: what is expected, missing, repeated or not known,
//! the closest known field, ranges and examples, shortened values.

use crate::case::Input;
use crate::problem::Problem;
use crate::words::shown;
use strsim::levenshtein;

/// Longest piece of a file that is shown in a message, in characters.
const LONGEST_SHOWN: usize = 40;

/// A piece of the file as a message shows it: on one line, without control characters, not too long.
pub(crate) fn shorten(text: &str) -> String {
    let mut out = String::new();
    let mut blank = false;
    for c in text.chars() {
        if c.is_whitespace() || !shown(c) {
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
    ("forces", "force_unit"),
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

/// Names that a later version of the program has a field for, each with the struct it stands in.
pub(crate) const RESERVED: &[(&str, &[&str])] = &[("Project", &["factors"])];

/// Fields that cannot be left out, by the name of their struct.
pub(crate) fn needed(holder: &str) -> &'static [&'static str] {
    match holder {
        "Project" => &["version", "name", "layouts"],
        "Layout" => &["name", "d", "L", "D"],
        "MeshType" => &["id", "laboratory"],
        "LabRecord" => &["force", "statistic", "source"],
        "RatioRecord" => &["force", "deflection", "source"],
        "WireData" => &["net", "single", "double_twist", "source"],
        "NetGeometry" => {
            &["opening", "twist", "projection", "diameter", "node_mass", "node_radius"]
        }
        "Distortion" => &["lambda_u", "lambda_f", "slack"],
        _ => &[],
    }
}

/// Fields one of which can be left out where the others stand: a grid has one spacing or two.
pub(crate) fn stands_for(holder: &str, field: &str) -> &'static [&'static str] {
    match (holder, field) {
        ("Layout", "L") => &["Lx", "Ly"],
        _ => &[],
    }
}

/// What is wrong with spacings of which some are given: a grid has one or two.
pub(crate) fn spacings(one: bool, two: [bool; 2]) -> Problem {
    let field = match (one, two) {
        (true, [true, _]) => "Lx",
        (true, _) => "Ly",
        (false, [true, _]) => "Ly",
        _ => "Lx",
    };
    if one {
        return Problem::new(field, "a layout has one spacing or two, never both")
            .allowed("L, or Lx and Ly");
    }
    Problem::new(field, "the other spacing is missing").allowed("L, or Lx and Ly")
}

/// A field that is not known at its place: one of a later version, or a slip.
pub(crate) fn unknown_field(holder: &str, path: &str, key: &str, known: &[&str]) -> Problem {
    if RESERVED.iter().any(|(struct_name, names)| *struct_name == holder && names.contains(&key)) {
        return Problem::new(
            path,
            "this name is reserved for a field that this version does not know yet",
        )
        .advice("use a newer meshcast, or take the field out");
    }
    let problem =
        Problem::new(path, "there is no field of this name here").allowed(known.join(", "));
    match closest(key, known) {
        Some(name) => problem.advice(format!("is {name} meant?")),
        None => problem,
    }
}

/// A field that cannot be left out and is.
pub(crate) fn missing_field(field: &str) -> Problem {
    let problem = Problem::new(field, "this field is missing");
    match field {
        // Nobody should copy a number or a word that stands in no record.
        "force" | "deflection" => problem.advice(format!(
            "add {field}: and the value of the record; one that is not known cannot be made up"
        )),
        "statistic" => problem.advice(
            "add statistic: Mean or statistic: Characteristic, as the record says; a maker's declared value is mostly characteristic",
        ),
        _ => problem.advice(format!("add {field}: {}", example(field))),
    }
}

/// A field that stands there already.
pub(crate) fn repeated_field(field: &str) -> Problem {
    Problem::new(field, "this field is given twice")
}

/// A word that is none of those that may stand there.
pub(crate) fn unknown_word(allowed: impl Into<String>) -> Problem {
    Problem::new("", "this word is not known here").allowed(allowed)
}

/// Words of which one is due.
pub(crate) fn one_of(allowed: &[&str]) -> String {
    // A word that is taken in small letters too is said once.
    let mut said: Vec<&str> = Vec::new();
    for word in allowed {
        if !said.iter().any(|other| other.eq_ignore_ascii_case(word)) {
            said.push(word);
        }
    }
    said.join(if said.len() > 2 { ", " } else { " or " })
}

/// Something else is due.
pub(crate) fn expected(what: &str) -> String {
    format!("{what} is expected here")
}

/// What a struct looks like.
pub(crate) const A_STRUCT: &str = "a group of fields in round brackets";

/// What a group of `len` values looks like, by its name if it has one.
pub(crate) fn tuple(name: &str, len: usize) -> String {
    match name {
        "CurvePoint" => "a point is a strain and a stress, two numbers".to_string(),
        _ => format!("{len} numbers in round brackets are expected here"),
    }
}

/// What to do about more numbers than there should be.
pub(crate) const DECIMAL_COMMA: &str = "a decimal point is written as a point, not as a comma";

/// An example of a field's value.
pub(crate) fn example(field: &str) -> &'static str {
    if let Some(input) = Input::named(field) {
        return input.row().example;
    }
    match field {
        "version" => "2",
        "blocks" => "worst",
        "shape" => "dome",
        "stagger" => "true",
        "twists" => "down",
        "method" => "derived",
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

/// What a field of a layout takes, with its unit; nothing where that is not limited, and for others.
pub(crate) fn range(field: &str) -> String {
    Input::named(field).map_or(String::new(), Input::allowed)
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
