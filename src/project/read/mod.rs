//! Tree to values: the one reader of everything that the program keeps as RON. It reads what serde
//! can describe, and knows of every value where it stands, so that all that is wrong is said at its
//! line, with its path, what stood there and what is allowed.
//!
//! - [`values()`], [`Reader`], [`At`]: this file. A problem is noted where it is met, by the innermost
//!   value that knows of it; what serde sees of it after that is [`Wrong::Noted`].
//! - `deserializer`: what each kind of value may be; `access`: fields, items and variants.
//! - [`soft`]: fields whose faults do not hide those of their neighbours.

mod access;
mod deserializer;
#[cfg(test)]
mod oracle;
pub(crate) mod soft;
mod wrong;

use super::error::Found;
use super::text::{Group, Node, NodeKind, Shape};
use super::words;
use crate::problem::Problem;
pub(crate) use access::Fields;
use serde::Deserialize;
use std::cell::RefCell;
use std::fmt;
use wrong::Wrong;

/// More problems than this are not looked for; a message shows a handful.
const MOST_FOUND: usize = 200;

/// Reads a value; `path` is where it stands in the whole, empty for the whole itself.
///
/// # Errors
/// Everything that is wrong.
pub(crate) fn values<'t, T: Deserialize<'t>>(
    text: &'t str,
    node: &'t Node,
    path: &str,
) -> Result<T, Vec<Found>> {
    let reader = Reader::new(text);
    let value = T::deserialize(reader.at(node, &Path::Root(path)));
    match (value, reader.found()) {
        (Ok(value), found) if found.is_empty() => Ok(value),
        (_, found) => Err(found),
    }
}

/// Reads a value as far as it can be read: what it knows nothing of is passed over, as a file of
/// another version may have more. Nothing where that leaves no value.
pub(crate) fn what_is_known<'t, T: Deserialize<'t>>(text: &'t str, node: &'t Node) -> Option<T> {
    let reader = Reader { unknown_pass: true, ..Reader::new(text) };
    T::deserialize(reader.at(node, &Path::Root(""))).ok()
}

/// A text that is being read, and what was found wrong with it so far.
pub(crate) struct Reader<'t> {
    text: &'t str,
    /// Whether fields that are not known are passed over.
    unknown_pass: bool,
    found: RefCell<Vec<Found>>,
}

impl<'t> Reader<'t> {
    pub(crate) fn new(text: &'t str) -> Self {
        Reader { text, unknown_pass: false, found: RefCell::default() }
    }

    /// A value to be read.
    pub(crate) fn at<'r>(&'r self, node: &'t Node, path: &'r Path<'r>) -> At<'r, 't> {
        At { reader: self, node, path }
    }

    /// All that was found wrong.
    pub(crate) fn found(&self) -> Vec<Found> {
        self.found.take()
    }

    fn has_enough(&self) -> bool {
        self.found.borrow().len() > MOST_FOUND
    }
}

/// The way from the whole to a value; written out only when something is wrong there.
#[derive(Clone, Copy)]
pub(crate) enum Path<'p> {
    /// The value that reading began with, by its own path.
    Root(&'p str),
    Field(&'p Path<'p>, &'p str),
    /// An item of a list.
    Item(&'p Path<'p>, usize),
}

impl Path<'_> {
    /// The field's name, if this is one.
    fn name(&self) -> &str {
        match self {
            Path::Field(_, name) => name,
            Path::Root(path) => path.rsplit('.').next().unwrap_or(path),
            Path::Item(..) => "",
        }
    }
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Path::Root(path) => f.write_str(path),
            Path::Field(Path::Root(""), name) => f.write_str(name),
            Path::Field(parent, name) => write!(f, "{parent}.{name}"),
            Path::Item(parent, index) => write!(f, "{parent}[{index}]"),
        }
    }
}

/// A value at its place.
#[derive(Clone, Copy)]
pub(crate) struct At<'r, 't> {
    reader: &'r Reader<'t>,
    node: &'t Node,
    path: &'r Path<'r>,
}

impl<'r, 't> At<'r, 't> {
    /// Notes a problem with this value or, where it names a field, with what is below it.
    fn note(self, problem: Problem) -> Wrong {
        self.note_at(self.node.span.start, problem)
    }

    fn note_at(self, at: usize, mut problem: Problem) -> Wrong {
        if problem.field.is_empty() && problem.value.is_empty() {
            problem.value = words::shorten(self.node.span.slice(self.reader.text));
        }
        let found = Found::new(at, problem.under(&self.path.to_string()));
        let mut all = self.reader.found.borrow_mut();
        if all.len() <= MOST_FOUND && !all.contains(&found) {
            all.push(found);
        }
        Wrong::Noted
    }

    /// Notes that something else is due here.
    fn note_due(self, expected: &str) -> Wrong {
        let range = words::range(self.path.name());
        self.note(Problem::new("", words::expected(expected)).allowed(range))
    }

    /// What a visitor made of the value; a problem of its is noted here, where its place is known.
    fn settle<T>(self, result: Result<T, Wrong>) -> Result<T, Wrong> {
        result.map_err(|wrong| match wrong {
            Wrong::Noted => Wrong::Noted,
            Wrong::Said(mut problem) => {
                if problem.field.is_empty() && problem.allowed.is_empty() {
                    problem.allowed = words::range(self.path.name());
                }
                self.note(*problem)
            }
        })
    }

    /// The group of a struct of this name; an empty pair of brackets is one too.
    fn as_struct(self, name: &str) -> Result<&'t Group, Wrong> {
        match &self.node.kind {
            NodeKind::Group(group)
                if group.shape == Shape::Struct
                    || (group.shape == Shape::Tuple && group.entries.is_empty()) =>
            {
                self.check_name(group, name);
                Ok(group)
            }
            _ => Err(self.note_due(words::A_STRUCT)),
        }
    }

    /// Notes a name before a bracket that is not the one that may stand there.
    fn check_name(self, group: &Group, name: &str) {
        if let Some(other) = group.name.as_deref().filter(|n| *n != name) {
            let said = format!("the name {other} stands before the bracket");
            let advice = format!("leave it out, or write {name}");
            let value = words::shorten(self.node.span.slice(self.reader.text));
            self.note(Problem::new("", said).value(value).advice(advice));
        }
    }

    /// The fields of a struct, after noting those that are missing. With `known` fields, others and
    /// repeated ones are noted when their turn comes.
    pub(crate) fn fields(
        self,
        holder: &'r str,
        known: Option<&'r [&'r str]>,
    ) -> Result<Fields<'r, 't>, Wrong> {
        let group = self.as_struct(holder)?;
        for name in words::needed(holder) {
            let field = Path::Field(self.path, name);
            match self.node.field(name) {
                None if words::stands_for(holder, name)
                    .iter()
                    .any(|other| self.node.field(other).is_some()) => {}
                None => drop(self.note(words::missing_field(name))),
                Some(entry) if entry.value.is_none() => {
                    At { node: &entry.value, path: &field, ..self }.note_due("a value");
                }
                Some(_) => {}
            }
        }
        Ok(Fields::new(self, group, holder, known))
    }
}
