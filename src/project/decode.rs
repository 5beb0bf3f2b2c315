//! Tree to project: checks fields and types, and says of each problem where it stands.

use super::error::Found;
use super::schema::{CURRENT_VERSION, Display, MeshUse, NamedLayout, Project};
use super::text::{Group, Node, NodeKind, Shape};
use super::{inline_mesh, kept, words};
use crate::case::Input;
use crate::layout::{BranchRule, REFERENCE};
use crate::problem::Problem;
use crate::units::{self, LengthUnit, Quantity};
use std::collections::HashMap;
use std::sync::Arc;

/// Fields of a project, in the order in which they are written.
pub(crate) const PROJECT_FIELDS: &[&str] =
    &["version", "name", "site", "notes", "meshes", "layouts", "display"];
/// Fields of a layout, in the order in which they are written.
pub(crate) const LAYOUT_FIELDS: &[&str] = &[
    "name",
    "d",
    "L",
    "D",
    "ex",
    "ey",
    "mesh",
    "branch",
    "design_force",
    "allowable_deflection",
    "gamma_resistance",
    "gamma_load",
    "overlay",
    "note",
    "check",
];
/// Fields of the display preferences.
pub(crate) const DISPLAY_FIELDS: &[&str] = &["length_unit"];

/// More problems than this are not looked for; a message shows a handful.
const MOST_FOUND: usize = 200;

/// Reads a tree of the current version as a project. The result is checked field by field, but not
/// yet as a whole ([`Project::check`]).
///
/// # Errors
/// Everything that is wrong.
pub(crate) fn project(text: &str, root: &Node) -> Result<Project, Vec<Found>> {
    let mut d = Decoder { text, found: Vec::new() };
    let project = d.project(root);
    match project {
        Some(project) if d.found.is_empty() => Ok(project),
        _ => Err(d.found),
    }
}

struct Decoder<'t> {
    text: &'t str,
    found: Vec<Found>,
}

/// The fields of one struct.
struct Fields<'n> {
    group: &'n Group,
    path: String,
}

impl<'n> Fields<'n> {
    fn get(&self, name: &str) -> Option<&'n Node> {
        let entry = self.group.entries.iter().find(|e| e.key.as_ref().is_some_and(|k| k.0 == name));
        entry.map(|e| &e.value)
    }

    fn path(&self, name: &str) -> String {
        if self.path.is_empty() { name.to_string() } else { format!("{}.{name}", self.path) }
    }
}

impl<'t> Decoder<'t> {
    fn say(&mut self, at: usize, problem: Problem) {
        self.found.push(Found::new(at, problem));
    }

    fn wrong_type(&mut self, node: &Node, path: &str, expected: &str) {
        let shown = words::shorten(node.span.of(self.text));
        let said = format!("{expected} is expected here");
        self.say(node.span.start, Problem::new(path, said).value(shown));
    }

    fn project(&mut self, root: &Node) -> Option<Project> {
        let f =
            self.fields(root, "", PROJECT_FIELDS, &["version", "name", "layouts"], "Project")?;
        let name = self.text(&f, "name").unwrap_or_default();
        let site = self.text(&f, "site").unwrap_or_default();
        let notes = self.text(&f, "notes").unwrap_or_default();
        let meshes = self.list(&f, "meshes", |d, node, path| d.mesh(node, path));
        let display = f.get("display").and_then(|n| self.display(n)).unwrap_or_default();
        let mut project = Project {
            version: CURRENT_VERSION,
            name,
            site,
            notes,
            meshes,
            layouts: Vec::new(),
            display,
        };
        let default_mesh = project.default_mesh().to_string();
        project.layouts =
            self.list(&f, "layouts", |d, node, path| d.layout(node, path, &default_mesh));
        Some(project)
    }

    fn display(&mut self, node: &Node) -> Option<Display> {
        let f = self.fields(node, "display", DISPLAY_FIELDS, &[], "Display")?;
        let units = [("m", LengthUnit::Metre), ("mm", LengthUnit::Millimetre)];
        Some(Display { length_unit: self.word(&f, "length_unit", &units).unwrap_or_default() })
    }

    fn mesh(&mut self, node: &Node, path: &str) -> Option<MeshUse> {
        match &node.kind {
            NodeKind::Text(id) => Some(MeshUse::Catalogue(id.clone())),
            NodeKind::Group(g) if matches!(g.shape, Shape::Struct) => {
                match inline_mesh::read(self.text, node, path) {
                    Ok(mesh) => Some(MeshUse::Inline(Arc::new(mesh))),
                    Err(found) => {
                        self.found.push(found);
                        None
                    }
                }
            }
            _ => {
                self.wrong_type(node, path, "a mesh identifier in quotes, or a mesh in brackets,");
                None
            }
        }
    }

    fn layout(&mut self, node: &Node, path: &str, default_mesh: &str) -> Option<NamedLayout> {
        let f = self.fields(node, path, LAYOUT_FIELDS, &["name", "d", "L", "D"], "Layout")?;
        let rules = [
            (BranchRule::Published.word(), BranchRule::Published),
            (BranchRule::Conservative.word(), BranchRule::Conservative),
        ];
        let name = self.text(&f, "name");
        let check = self.optional(&f, "check").and_then(|node| {
            kept::read(self.text, node.unwrapped(), &f.path("check"))
                .map_err(|found| self.found.push(found))
                .ok()
        });
        // A missing one is reported above, so the layout is read on only to find more.
        let mut inputs = NamedLayout::new(name.clone().unwrap_or_default(), REFERENCE, "");
        let mut complete = name.is_some();
        for input in Input::LAYOUT {
            let row = input.row();
            let value = self.number(&f, row.name, row.quantity);
            complete &= value.is_some() || input.clearable();
            inputs.set(input, value);
        }
        complete.then_some(NamedLayout {
            mesh: self.text(&f, "mesh").unwrap_or_else(|| default_mesh.to_string()),
            branch: self.word(&f, "branch", &rules).unwrap_or_default(),
            overlay: self.word(&f, "overlay", &[("true", true), ("false", false)]).unwrap_or(false),
            note: self.text(&f, "note").unwrap_or_default(),
            check: check.map(Arc::new),
            ..inputs
        })
    }

    /// The fields of a struct, after reporting unknown, repeated and missing ones.
    fn fields<'n>(
        &mut self,
        node: &'n Node,
        path: &str,
        known: &[&str],
        required: &[&str],
        name: &str,
    ) -> Option<Fields<'n>> {
        let inner = node.unwrapped();
        let group = match &inner.kind {
            NodeKind::Group(g)
                if g.shape == Shape::Struct
                    || (g.shape == Shape::Tuple && g.entries.is_empty()) =>
            {
                g
            }
            _ => {
                self.wrong_type(node, path, "a group of fields in round brackets");
                return None;
            }
        };
        if let Some(other) = group.name.as_deref().filter(|n| *n != name) {
            let said = format!("the name {other} stands before the bracket");
            let advice = format!("leave it out, or write {name}");
            self.say(inner.span.start, Problem::new(path, said).advice(advice));
        }
        let fields = Fields { group, path: path.to_string() };
        let mut seen: HashMap<&str, usize> = HashMap::new();
        for entry in &group.entries {
            let Some((key, span)) = &entry.key else { continue };
            if !known.contains(&key.as_str()) {
                self.say(span.start, words::unknown_field(&fields.path(key), key, known));
            } else if let Some(first) = seen.get(key.as_str()) {
                let (line, _) = super::text::line_column(self.text, *first);
                let problem = Problem::new(fields.path(key), "this field is given twice")
                    .value(words::shorten(entry.value.span.of(self.text)))
                    .advice(format!("it also stands in line {line}; keep one"));
                self.say(span.start, problem);
            } else {
                seen.insert(key, span.start);
            }
            if self.found.len() > MOST_FOUND {
                return None;
            }
        }
        for name in required.iter().filter(|n| fields.get(n).is_none()) {
            let problem = Problem::new(fields.path(name), "this field is missing")
                .advice(format!("add {name}: {}", words::example(name)));
            self.say(inner.span.start, problem);
        }
        Some(fields)
    }

    fn list<T>(
        &mut self,
        f: &Fields,
        name: &str,
        mut read: impl FnMut(&mut Self, &Node, &str) -> Option<T>,
    ) -> Vec<T> {
        let Some(node) = f.get(name) else { return Vec::new() };
        let path = f.path(name);
        match &node.unwrapped().kind {
            NodeKind::Group(g) if g.shape == Shape::List => g
                .entries
                .iter()
                .enumerate()
                .filter_map(|(k, e)| {
                    let enough = self.found.len() > MOST_FOUND;
                    if enough { None } else { read(self, &e.value, &format!("{path}[{k}]")) }
                })
                .collect(),
            NodeKind::Word(word) if word == "None" => Vec::new(),
            _ => {
                self.wrong_type(node, &path, "a list in square brackets");
                Vec::new()
            }
        }
    }

    /// The value of an optional field; nothing where it is left out or `None`.
    fn optional<'n>(&mut self, f: &Fields<'n>, name: &str) -> Option<&'n Node> {
        let node = f.get(name)?.unwrapped();
        match &node.kind {
            NodeKind::Word(word) if word == "None" => {
                if matches!(name, "name" | "version" | "d" | "L" | "D") {
                    self.wrong_type(node, &f.path(name), "a value");
                }
                None
            }
            _ => Some(node),
        }
    }

    fn text(&mut self, f: &Fields, name: &str) -> Option<String> {
        let node = self.optional(f, name)?;
        match &node.kind {
            NodeKind::Text(text) => Some(text.clone()),
            _ => {
                self.wrong_type(node, &f.path(name), "a text in double quotes");
                None
            }
        }
    }

    fn word<T: Copy>(&mut self, f: &Fields, name: &str, words: &[(&str, T)]) -> Option<T> {
        let node = self.optional(f, name)?;
        let written = match &node.kind {
            NodeKind::Word(word) | NodeKind::Text(word) => word.as_str(),
            NodeKind::Bool(true) => "true",
            NodeKind::Bool(false) => "false",
            _ => "",
        };
        let value = words.iter().find(|w| w.0 == written).map(|w| w.1);
        if value.is_none() {
            let allowed: Vec<&str> = words.iter().map(|w| w.0).collect();
            let problem = Problem::new(f.path(name), "this word is not known here")
                .value(words::shorten(node.span.of(self.text)))
                .allowed(allowed.join(" or "));
            self.say(node.span.start, problem);
        }
        value
    }

    fn number(&mut self, f: &Fields, name: &str, quantity: Quantity) -> Option<f64> {
        let node = self.optional(f, name)?;
        let path = f.path(name);
        let shown = words::shorten(node.span.of(self.text));
        let (problem, advice) = match &node.kind {
            NodeKind::Number(v) if v.is_finite() => {
                let si = if quantity == Quantity::Force { units::from_kn(*v) } else { *v };
                if si.is_finite() {
                    return Some(si);
                }
                ("the number is too large".to_string(), String::new())
            }
            NodeKind::Number(v) if v.is_nan() => {
                ("this is not a number".to_string(), "write an ordinary number".to_string())
            }
            NodeKind::Number(_) => {
                ("the number is infinite".to_string(), "write an ordinary number".to_string())
            }
            NodeKind::Text(text) => match units::parse(text, quantity, LengthUnit::Metre) {
                Ok(value) => return Some(value),
                Err(e) => (e.to_string(), String::new()),
            },
            _ => (format!("{} is expected here", words::quantity(quantity)), String::new()),
        };
        let problem = Problem::new(&path, problem)
            .value(shown)
            .allowed(Input::named(name).map_or(String::new(), Input::allowed));
        self.say(node.span.start, problem.advice(advice));
        None
    }
}

/// What is said of a file of a newer version.
pub(super) const NEWER: &str =
    "the file was written by a newer meshcast and this one cannot read it";

/// The version field of a tree, before anything else is looked at.
///
/// # Errors
/// The one thing that is wrong with it.
pub(crate) fn version(text: &str, root: &Node) -> Result<u32, Found> {
    let missing = |at: usize| {
        Found::new(
            at,
            Problem::new("version", "the format version is missing")
                .allowed(format!("0 to {CURRENT_VERSION}"))
                .advice(format!("put version: {CURRENT_VERSION}, first in the file")),
        )
    };
    let is_struct = matches!(&root.kind, NodeKind::Group(g) if g.shape == Shape::Struct || g.entries.is_empty());
    if !is_struct {
        return Err(Found::new(
            root.span.start,
            Problem::new("", "this is no project")
                .value(words::shorten(root.span.of(text)))
                .advice("a project starts with (version: 1, name: ..."),
        ));
    }
    let Some(entry) = root.field("version") else { return Err(missing(root.span.start)) };
    let node = entry.value.unwrapped();
    let wrong = |said: String| {
        Found::new(
            entry.span().start,
            Problem::new("version", said)
                .value(words::shorten(node.span.of(text)))
                .allowed(format!("0 to {CURRENT_VERSION}")),
        )
    };
    match node.kind {
        NodeKind::Number(v) if v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&v) => {
            // Whole and within range, so nothing is lost.
            let version = v as u32;
            if version <= CURRENT_VERSION {
                return Ok(version);
            }
            let mut found = wrong(NEWER.to_string());
            found.problem.advice = "use the newer meshcast; the file is left as it is".to_string();
            Err(found)
        }
        _ => Err(wrong("the format version is a whole number".to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_and_other_names_lead_to_the_field() {
        for (written, meant) in [
            ("spacing", "L"),
            ("spaceing", "L"),
            ("l", "L"),
            ("E_x", "ex"),
            ("desing_force", "design_force"),
            ("gamma_laod", "gamma_load"),
            ("Overlay", "overlay"),
        ] {
            assert_eq!(words::closest(written, LAYOUT_FIELDS), Some(meant), "{written}");
        }
        assert_eq!(words::closest("layout", PROJECT_FIELDS), Some("layouts"));
        assert_eq!(words::closest("weather_forecast", LAYOUT_FIELDS), None);
    }
}
