//! A mesh type written out in a project: read with the mesh room's own schema, with the places and
//! the wording of this room.

use super::error::Found;
use super::text::{Node, NodeKind, Shape, line_column, offset_at};
use super::words;
use crate::mesh::MeshType;
use crate::mesh::wire::WireData;
use crate::problem::Problem;

/// RON as the program reads it everywhere: optional values need no `Some`.
pub(crate) fn ron_options() -> ron::Options {
    ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME)
}

/// Reads the mesh of a node.
///
/// # Errors
/// The first thing that is wrong with its fields.
pub(crate) fn read(text: &str, node: &Node, path: &str) -> Result<MeshType, Found> {
    if let Some(wire) = node.field("wire")
        && let Some(found) = decimal_comma_in_curve(text, &wire.value, &format!("{path}.wire."))
    {
        return Err(found);
    }
    ron_options()
        .from_str::<MeshType>(node.span.of(text))
        .map_err(|e| translate(text, node, path, &e, in_mesh))
}

/// Reads the wire data that are the whole of a text.
///
/// # Errors
/// The first thing that is wrong with its fields.
pub(crate) fn read_wire(text: &str, node: &Node) -> Result<WireData, Found> {
    if let Some(found) = decimal_comma_in_curve(text, node, "") {
        return Err(found);
    }
    ron_options()
        .from_str::<WireData>(node.span.of(text))
        .map_err(|e| translate(text, node, "", &e, in_wire))
}

/// A mesh type as RON, one field a line, `indent` steps of four blanks in.
pub(crate) fn write(mesh: &MeshType, indent: usize) -> Option<String> {
    let text = pretty(mesh)?;
    // Line feeds inside strings are escaped by the writer, so every one of these starts a line.
    Some(text.replace('\n', &format!("\n{}", "    ".repeat(indent))))
}

fn pretty(value: &impl serde::Serialize) -> Option<String> {
    let pretty = ron::ser::PrettyConfig::new()
        .depth_limit(4)
        .new_line("\n")
        .extensions(ron::extensions::Extensions::IMPLICIT_SOME);
    let mut text = ron_options().to_string_pretty(value, pretty).ok()?;
    // The writer names the extension that is on anyway.
    if let Some(rest) = text.strip_prefix("#![enable(implicit_some)]") {
        text = rest.trim_start().to_string();
    }
    Some(text)
}

/// Wire data as RON, one field a line.
pub(crate) fn write_wire(wire: &WireData) -> Option<String> {
    pretty(wire)
}

/// A problem of the `ron` crate in this room's words, at its place. `holder` tells where the structs
/// of the mesh room stand.
fn translate(
    text: &str,
    node: &Node,
    path: &str,
    error: &ron::error::SpannedError,
    holder: fn(&str) -> &'static str,
) -> Found {
    use ron::Error as E;
    let base = node.span.start;
    let inside = node.span.of(text);
    let start = base + offset_at(inside, error.span.start.line, error.span.start.col);
    let end = base + offset_at(inside, error.span.end.line, error.span.end.col);
    // The reader stands behind what it has read; the value it did not like ends there or starts there.
    let at = end.saturating_sub(1).max(start);
    let inner = node.path_at(at);
    let full = |inner: &str| match (path.is_empty(), inner.is_empty() || inner.starts_with('[')) {
        (true, _) => inner.to_string(),
        (_, true) => format!("{path}{inner}"),
        _ => format!("{path}.{inner}"),
    };
    let place = node.locate(&inner);
    let parent = |name: &str| {
        let mut steps: Vec<&str> = inner.split('.').filter(|s| !s.is_empty()).collect();
        if steps.last() == Some(&name) {
            steps.pop();
        }
        steps.push(name);
        steps.join(".")
    };
    let (at, problem) = match &error.code {
        E::NoSuchStructField { expected, found, .. } => {
            let field = find_field(node, found, start);
            let inner = field.map_or_else(|| parent(found), |f| node.path_at(f));
            (field.unwrap_or(start), words::unknown_field(&full(&inner), found, expected))
        }
        E::MissingStructField { field, outer } => {
            let holder = outer.as_deref().map_or("", holder);
            let inner =
                if holder.is_empty() { (*field).to_string() } else { format!("{holder}.{field}") };
            let problem = Problem::new(full(&inner), "this field is missing")
                .advice(format!("add {field}: {}", words::example(field)));
            (node.locate(holder).start, problem)
        }
        E::DuplicateStructField { field, .. } => {
            (place.start, Problem::new(full(&parent(field)), "this field is given twice"))
        }
        E::NoSuchEnumVariant { expected, found, .. } => (
            place.start,
            Problem::new(full(&inner), "this word is not known here")
                .value(words::shorten(found))
                .allowed(expected.join(" or ")),
        ),
        other => {
            let value = value_at(node, &inner).map_or("", |n| n.span.of(text));
            (place.start, Problem::new(full(&inner), plain(other)).value(words::shorten(value)))
        }
    };
    Found::new(at, problem)
}

/// Where in a mesh a struct of the mesh room stands; the mesh itself for one not known here.
fn in_mesh(name: &str) -> &'static str {
    match name {
        "LabRecord" => "laboratory",
        "RatioRecord" => "ratios",
        "WireData" => "wire",
        "NetGeometry" => "wire.net",
        "Distortion" => "wire.distortion",
        _ => "",
    }
}

/// The same in a file of wire data.
fn in_wire(name: &str) -> &'static str {
    match name {
        "NetGeometry" => "net",
        "Distortion" => "distortion",
        _ => "",
    }
}

/// What the `ron` crate says, without its terms.
fn plain(error: &ron::Error) -> String {
    use ron::Error as E;
    match error {
        E::ExpectedFloat | E::ExpectedInteger => "a number is expected here".into(),
        E::ExpectedBoolean => "true or false is expected here".into(),
        E::ExpectedString => "a text in double quotes is expected here".into(),
        E::ExpectedArray => "a list in square brackets is expected here".into(),
        E::ExpectedStructLike | E::ExpectedNamedStructLike(_) => {
            "a group of fields in round brackets is expected here".into()
        }
        E::InvalidValueForType { expected, .. } => format!("this should be {expected}"),
        E::ExpectedDifferentLength { expected, found } => {
            format!("{expected} is expected here, not {found} values")
        }
        E::Message(said) => said.clone(),
        E::ExpectedOption => "a value is expected here".into(),
        other => {
            let said = other.to_string();
            let mut letters = said.chars();
            letters.next().map_or(String::new(), |c| c.to_lowercase().chain(letters).collect())
        }
    }
}

/// The field of this name at or nearest before a place, anywhere below a node.
fn find_field(node: &Node, name: &str, near: usize) -> Option<usize> {
    let group = node.group()?;
    let mut best: Option<usize> = None;
    for entry in &group.entries {
        let here = entry.key.as_ref().filter(|k| k.0 == name).map(|k| k.1.start);
        for at in [here, find_field(&entry.value, name, near)].into_iter().flatten() {
            if best.is_none_or(|b| at.abs_diff(near) < b.abs_diff(near)) {
                best = Some(at);
            }
        }
    }
    best
}

fn value_at<'n>(node: &'n Node, path: &str) -> Option<&'n Node> {
    let mut node = node;
    for step in path.split(['.', '[']).map(|s| s.trim_end_matches(']')).filter(|s| !s.is_empty()) {
        let inner = node.unwrapped();
        let entry = match step.parse::<usize>() {
            Ok(index) => inner.items()?.get(index)?,
            Err(_) => inner.field(step)?,
        };
        node = &entry.value;
    }
    Some(node)
}

/// A curve point of more than two numbers, which is a decimal comma; RON's own words do not help.
fn decimal_comma_in_curve(text: &str, wire: &Node, path: &str) -> Option<Found> {
    let wire = wire.unwrapped();
    for name in ["single", "double_twist"] {
        let Some(points) = wire.field(name).and_then(|e| e.value.items()) else { continue };
        for (k, point) in points.iter().enumerate() {
            let many =
                point.value.group().is_some_and(|g| g.shape == Shape::Tuple && g.entries.len() > 2);
            let numbers = point.value.items().is_some_and(|items| {
                items.iter().all(|e| matches!(e.value.kind, NodeKind::Number(_)))
            });
            if many && numbers {
                let problem = Problem::new(
                    format!("{path}{name}[{k}]"),
                    "a point is a strain and a stress, two numbers",
                )
                .value(words::shorten(point.value.span.of(text)))
                .advice("a decimal point is written as a point, not as a comma");
                return Some(Found::new(point.value.span.start, problem));
            }
        }
    }
    None
}

/// What the `ron` crate has against a text that this room's reader takes, if anything.
pub(crate) fn second_opinion(text: &str, root: &Node) -> Option<Found> {
    let bare = text.strip_prefix('\u{feff}').unwrap_or(text);
    let error = ron_options().from_str::<serde::de::IgnoredAny>(bare).err()?;
    let skipped = text.len() - bare.len();
    let at = skipped + offset_at(bare, error.span.start.line, error.span.start.col);
    let (line, _) = line_column(text, at);
    let problem = Problem::new(root.path_at(at), plain(&error.code))
        .advice(format!("something before or in line {line} is no RON"));
    Some(Found::new(at, problem))
}
