//! Changes to a text that leave the rest of it as it is.
//!
//! A changed value is replaced where it stands. A value that was left out and is needed now is put
//! behind its nearest neighbour; one that is no longer needed goes with its line, or stays as `None`
//! where a comment speaks of it. Layouts and meshes are moved, put in and taken out with the comments
//! that stand directly above and behind them.
//!
//! - [`patch`]: the whole project; this file. [`fields`]: the fields of a struct. [`list`]: the
//!   items of a list.

mod fields;
mod list;

use super::decode::{DISPLAY_FIELDS, LAYOUT_FIELDS, PROJECT_FIELDS};
use super::schema::{NamedLayout, Project};
use super::text::scalar::quoted;
use super::text::{Group, Node, NodeKind, Shape, Span, Tree};
use super::write;
use crate::case::Input;
use crate::case::input::Missing;
use crate::words::Choice;
use fields::{FieldChange, Fields};
use list::{Item, List};

/// The text of an edited project.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendered {
    pub text: String,
    /// Whether the comments and the form of the old text are kept. They are, unless the text was of
    /// a form in which the change could not be made safely; then the clean form is written.
    pub comments_kept: bool,
}

/// A part of a text and what comes in its place.
pub(crate) type Edit = (Span, String);

/// Puts new text in the place of parts of a text. Parts must not overlap; an empty part is a place
/// to put text in, and several texts for one place come in the order given.
pub(crate) fn apply(text: &str, edits: Vec<Edit>) -> String {
    apply_within(text, Span::new(0, text.len()), edits)
}

/// The same for a part of a text, with edits inside that part.
pub(crate) fn apply_within(text: &str, part: Span, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|e| (e.0.start, e.0.end));
    let mut out = String::with_capacity(part.end - part.start + 64);
    let mut done = part.start;
    for (span, new) in edits {
        if span.start < done || span.end > part.end {
            continue;
        }
        out.push_str(Span::new(done, span.start).slice(text));
        out.push_str(&new);
        done = span.end;
    }
    out.push_str(Span::new(done, part.end).slice(text));
    out
}

/// A text with its tree, and how lines end in it.
#[derive(Clone, Copy)]
pub(crate) struct PatchSource<'t> {
    pub text: &'t str,
    pub tree: &'t Tree,
}

impl PatchSource<'_> {
    /// How lines end.
    pub(crate) fn newline(&self) -> &'static str {
        if self.text.contains("\r\n") { "\r\n" } else { "\n" }
    }

    /// The comments that lie in a part.
    pub(crate) fn has_comment(&self, start: usize, end: usize) -> bool {
        self.tree.comments.iter().any(|c| c.start >= start && c.end <= end)
    }

    /// Blanks in front of a place, if nothing else stands before it on its line.
    pub(crate) fn indent(&self, at: usize) -> Option<&str> {
        let start = self.text[..at].rfind('\n').map_or(0, |n| n + 1);
        let before = &self.text[start..at];
        before.chars().all(|c| c == ' ' || c == '\t').then_some(before)
    }

    /// Blanks at the start of the line on which a place is.
    pub(crate) fn line_indent(&self, at: usize) -> &str {
        let start = self.text[..at].rfind('\n').map_or(0, |n| n + 1);
        let line = &self.text[start..at];
        &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
    }

    /// Walks blanks and one-line comments from a place. Where the line ends: the place before and
    /// the place behind the line end. Nothing if something else stands on the line.
    pub(crate) fn line_end(&self, from: usize) -> Option<(usize, usize)> {
        let mut at = from;
        loop {
            let rest = &self.text[at..];
            if rest.is_empty() {
                return Some((at, at));
            }
            if rest.starts_with("\r\n") {
                return Some((at, at + 2));
            }
            if rest.starts_with('\n') {
                return Some((at, at + 1));
            }
            if rest.starts_with([' ', '\t', '\r']) {
                at += 1;
                continue;
            }
            let found = self.tree.comments.binary_search_by_key(&at, |c| c.start).ok()?;
            let comment = self.tree.comments[found];
            if comment.slice(self.text).contains('\n') {
                return None;
            }
            at = comment.end;
        }
    }
}

/// The text with the changes that lead from one project to another, or nothing where the text is of
/// a form in which they cannot be made, or the project cannot be written at all. A mesh written out is changed as a whole; its comments are
/// lost then. The caller reads the result back before trusting it.
pub(crate) fn patch(text: &str, tree: &Tree, base: &Project, new: &Project) -> Option<Rendered> {
    let source = PatchSource { text, tree };
    let root = tree.root.unwrapped();
    let group = as_struct(root)?;
    let mut lost = false;
    let mut fields = Fields::new(source, group, PROJECT_FIELDS);
    for (name, was, is, lines) in [
        ("name", &base.name, &new.name, false),
        ("site", &base.site, &new.site, false),
        ("notes", &base.notes, &new.notes, true),
    ] {
        if was != is {
            fields.change(name, FieldChange::Set(quoted(is, lines)));
        }
    }
    for ((name, was), (_, is)) in base.title.rows().into_iter().zip(new.title.rows()) {
        if was != is {
            let change = match is {
                "" => FieldChange::Unset,
                _ => FieldChange::Set(quoted(is, false)),
            };
            fields.change(name, change);
        }
    }
    if base.basis != new.basis {
        fields.change("basis", FieldChange::Set(new.basis.word().to_string()));
    }
    if base.method_files != new.method_files {
        let change = match &new.method_files[..] {
            [] => FieldChange::Unset,
            files => FieldChange::Set(write::method_files(files)),
        };
        fields.change("method_files", change);
    }
    if base.display != new.display {
        let units = new.display.units;
        let whole = format!("({})", write::display(units));
        match root.field("display").map(|e| e.value.unwrapped()) {
            Some(node) if as_struct(node).is_some_and(|g| !g.entries.is_empty()) => {
                let mut display = Fields::new(source, as_struct(node)?, DISPLAY_FIELDS);
                let set = |symbol: &str| FieldChange::Set(symbol.to_string());
                display.change("length_unit", set(units.length.symbol()));
                if base.display.units.force != units.force {
                    display.change("force_unit", set(units.force.symbol()));
                }
                fields.add(display.finish()?);
            }
            _ => fields.change("display", FieldChange::Set(whole)),
        }
    }
    if base.meshes != new.meshes {
        match root.field("meshes") {
            Some(entry) => {
                let (edits, some_lost) = meshes(source, entry.value.unwrapped(), base, new)?;
                fields.add(edits);
                lost = some_lost;
            }
            None => {
                let items: Option<Vec<String>> =
                    new.meshes.iter().map(|m| write::mesh_use(m, 1).ok()).collect();
                fields.change("meshes", FieldChange::Set(format!("[{}]", items?.join(", "))));
            }
        }
    }
    let list = root.field("layouts")?.value.unwrapped();
    fields.add(layouts(source, list, base, new)?);
    Some(Rendered { text: apply(text, fields.finish()?), comments_kept: !lost })
}

fn as_struct(node: &Node) -> Option<&Group> {
    let empty = |g: &Group| g.shape == Shape::Tuple && g.entries.is_empty();
    node.group().filter(|g| g.shape == Shape::Struct || empty(g))
}

fn as_list(node: &Node) -> Option<&Group> {
    node.group().filter(|g| g.shape == Shape::List)
}

/// The changes to the meshes; tells as well whether a comment inside a changed mesh is lost.
fn meshes(
    source: PatchSource,
    node: &Node,
    base: &Project,
    new: &Project,
) -> Option<(Vec<Edit>, bool)> {
    let list = List::new(source, as_list(node)?);
    let steps = list.indent().len() / 4;
    let mut items = Vec::with_capacity(new.meshes.len());
    let mut lost = false;
    for mesh in &new.meshes {
        let text = || {
            let text = write::mesh_use(mesh, steps).ok()?;
            Some(text.replace('\n', source.newline()))
        };
        let Some(index) = base.meshes.iter().position(|m| m.id() == mesh.id()) else {
            items.push(Item::New(text()?));
            continue;
        };
        let span = list.entry(index)?.value.unwrapped().span;
        let changed = base.meshes.get(index) != Some(mesh);
        lost |= changed && source.has_comment(span.start, span.end);
        let edits = if changed { vec![(span, text()?)] } else { Vec::new() };
        items.push(Item::Kept { index, edits });
    }
    Some((list.edits(items)?, lost))
}

fn layouts(source: PatchSource, node: &Node, base: &Project, new: &Project) -> Option<Vec<Edit>> {
    let list = List::new(source, as_list(node)?);
    let mut items = Vec::with_capacity(new.layouts.len());
    for layout in &new.layouts {
        let default = new.default_mesh();
        let item = match base.layouts.iter().position(|l| l.uid == layout.uid) {
            Some(index) => {
                let was = base.layouts.get(index)?;
                let entry = list.entry(index)?;
                let edits = one_layout(source, &entry.value, was, layout, default)?;
                Item::Kept { index, edits }
            }
            None if list.is_one_line() => {
                Item::New(write::layout_on_one_line(layout, default).ok()?)
            }
            None => {
                let text = write::layout(layout, default, list.indent(), source.newline());
                Item::New(text.ok()?)
            }
        };
        items.push(item);
    }
    list.edits(items)
}

/// The changes inside one layout.
fn one_layout(
    source: PatchSource,
    node: &Node,
    was: &NamedLayout,
    is: &NamedLayout,
    default_mesh: &str,
) -> Option<Vec<Edit>> {
    let group = as_struct(node.unwrapped())?;
    let mut fields = Fields::new(source, group, LAYOUT_FIELDS);
    for name in LAYOUT_FIELDS {
        let Some(present) = fields.value(name) else {
            if let Some(text) = write::layout_field(is, name, default_mesh).ok()? {
                fields.change(name, FieldChange::Set(text));
            }
            continue;
        };
        // With no identifier for the default mesh, a mesh is always written out.
        let [old, new] = [was, is].map(|l| write::layout_field(l, name, "").ok());
        let (old, new) = (old?, new?);
        if old == new {
            continue;
        }
        let input = Input::named(name);
        let in_its_unit = match (input, &present.kind) {
            (Some(input), NodeKind::Text(text)) if new.is_some() => is
                .get(input)
                .and_then(|si| write::number_with_unit(si, input.row().quantity, unit_of(text))),
            _ => None,
        };
        fields.change(
            name,
            match (in_its_unit.or(new), *name) {
                (Some(text), _) => FieldChange::Set(text),
                (None, "check") => FieldChange::Unset,
                (None, "note") => FieldChange::Set("\"\"".to_string()),
                (None, "shape") => FieldChange::Set(is.layout.shape.word().to_string()),
                (None, "stagger") => FieldChange::Set("false".to_string()),
                (None, "twists") => FieldChange::Set(is.layout.grid.twists.word().to_string()),
                (None, "overlay") => FieldChange::Set("false".to_string()),
                (None, "method") => FieldChange::Set(format!("{:?}", is.layout.method.word())),
                (None, "blocks") => FieldChange::Set(is.layout.blocks.word().to_string()),
                (None, "branch") => FieldChange::Set(is.branch.word().to_string()),
                (None, _) => match input.map(|input| (input.row().missing, input)) {
                    Some((Missing::Means(default), input)) => {
                        FieldChange::Set(write::number(default, input.row().quantity))
                    }
                    _ => FieldChange::Unset,
                },
            },
        );
    }
    fields.finish()
}

/// The unit at the end of a quantity's text.
fn unit_of(text: &str) -> &str {
    let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | ' ');
    let unit = text.trim().trim_start_matches(digits);
    // An exponent is left over in front of the unit.
    unit.trim_start_matches(['e', 'E']).trim_start_matches(digits)
}
