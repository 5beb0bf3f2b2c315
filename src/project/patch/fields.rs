//! Changes to the fields of a struct.

use super::super::text::{Entry, Group, Node, Span};
use super::{Edit, PatchSource};

/// What happens to a field.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum FieldChange {
    /// It gets this value, in RON.
    Set(String),
    /// It has no value any more.
    Unset,
}

/// The fields of one struct and the changes to them so far.
pub(crate) struct Fields<'t> {
    source: PatchSource<'t>,
    group: &'t Group,
    /// The order in which fields are written.
    order: &'t [&'t str],
    edits: Vec<Edit>,
    /// Entries that go away.
    removed: Vec<usize>,
    /// Fields to put in, in the order in which they were asked for.
    missing: Vec<(&'t str, String)>,
}

impl<'t> Fields<'t> {
    /// The fields of a struct; `order` has all their names.
    pub(crate) fn new(source: PatchSource<'t>, group: &'t Group, order: &'t [&'t str]) -> Self {
        Fields { source, group, order, edits: Vec::new(), removed: Vec::new(), missing: Vec::new() }
    }

    fn find(&self, name: &str) -> Option<usize> {
        self.group.entries.iter().position(|e| e.key.as_ref().is_some_and(|k| k.0 == name))
    }

    /// The value of a field, if it is there.
    pub(crate) fn value(&self, name: &str) -> Option<&'t Node> {
        self.find(name).map(|k| self.group.entries[k].value.unwrapped())
    }

    /// Takes in changes that were made inside a field.
    pub(crate) fn add(&mut self, edits: Vec<Edit>) {
        self.edits.extend(edits);
    }

    /// Changes a field.
    pub(crate) fn change(&mut self, name: &'t str, change: FieldChange) {
        match (self.find(name), change) {
            (Some(k), FieldChange::Set(text)) => {
                self.edits.push((self.group.entries[k].value.unwrapped().span, text));
            }
            (Some(k), FieldChange::Unset) => self.unset(k),
            (None, FieldChange::Set(text)) => self.missing.push((name, text)),
            (None, FieldChange::Unset) => {}
        }
    }

    /// Takes a field out, or writes `None` where a comment speaks of it.
    fn unset(&mut self, k: usize) {
        let entries = &self.group.entries;
        let entry = &entries[k];
        let (start, end) = (entry.span().start, entry.end());
        let before = match k.checked_sub(1).and_then(|p| entries.get(p)) {
            // A comment behind the previous field on its line belongs to that field.
            Some(p) => self.source.line_end(p.end()).map_or(p.end(), |(_, next)| next.min(start)),
            None => self.group.inner.start,
        };
        let line = self.source.line_end(end);
        let behind = line.map_or(end, |(before_newline, _)| before_newline);
        if self.source.has_comment(before, behind) {
            self.edits.push((entry.value.span, "None".to_string()));
            return;
        }
        let span = match (self.source.indent(start), line) {
            (Some(indent), Some((_, next))) => Span::new(start - indent.len(), next),
            // Others follow on its line: it goes with the blanks behind it.
            (Some(_), None) => {
                let rest = &self.source.text[end..];
                Span::new(start, end + rest.len() - rest.trim_start_matches([' ', '\t']).len())
            }
            // Others stand before it on its line: it goes with the blanks before it.
            (None, _) => {
                let from = k.checked_sub(1).map_or(self.group.inner.start, |p| entries[p].end());
                Span::new(from, end)
            }
        };
        self.edits.push((span, String::new()));
        self.removed.push(k);
    }

    /// All changes, those for missing fields included. Nothing if there is no place for a field.
    pub(crate) fn finish(mut self) -> Option<Vec<Edit>> {
        let rank = |name: &str| self.order.iter().position(|n| *n == name);
        let mut missing = std::mem::take(&mut self.missing);
        missing.sort_by_key(|(name, _)| rank(name));
        // Fields that follow the same neighbour are put in together.
        let mut places: Vec<(usize, Vec<(&str, String)>)> = Vec::new();
        for (name, text) in missing {
            let mine = rank(name)?;
            let neighbours = self.order[..mine].iter().rev();
            // One that goes away is no place to stand behind.
            let k = neighbours.filter_map(|n| self.find(n)).find(|k| !self.removed.contains(k))?;
            match places.last_mut().filter(|p| p.0 == k) {
                Some(place) => place.1.push((name, text)),
                None => places.push((k, vec![(name, text)])),
            }
        }
        for (k, fields) in places {
            self.insert(&self.group.entries[k], fields);
        }
        Some(self.edits)
    }

    fn insert(&mut self, neighbour: &Entry, fields: Vec<(&str, String)>) {
        let value_end = neighbour.value.span.end;
        let line =
            self.source.indent(neighbour.span().start).zip(self.source.line_end(neighbour.end()));
        match line {
            Some((indent, (end, _))) => {
                if neighbour.comma.is_none() {
                    self.edits.push((Span::new(value_end, value_end), ",".to_string()));
                }
                let newline = self.source.newline();
                let text: String = fields
                    .iter()
                    .map(|(name, value)| format!("{newline}{indent}{name}: {value},"))
                    .collect();
                self.edits.push((Span::new(end, end), text));
            }
            None => {
                let texts: Vec<String> =
                    fields.iter().map(|(name, value)| format!("{name}: {value}")).collect();
                let (at, text) = match neighbour.comma {
                    Some(comma) => (comma.end, format!(" {},", texts.join(", "))),
                    None => (value_end, format!(", {}", texts.join(", "))),
                };
                self.edits.push((Span::new(at, at), text));
            }
        }
    }
}
