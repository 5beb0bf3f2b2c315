//! Changes to the items of a list: moved, put in, taken out, each with its comments.
//!
//! A list is cut into a head (what stands behind the opening bracket on its line, and comments that
//! a blank line separates from the first item), one piece an item, and a tail. The piece of an item
//! begins behind the piece before and so has the comments above the item; it ends with the line on
//! which the item ends, so that a comment behind the item is in it.

use super::super::text::{Entry, Group, Span};
use super::{Edit, PatchSource, apply_within};

/// An item of the list as it is to be.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Item {
    /// One that stands in the text, with changes inside it.
    Kept {
        /// Its place in the old list.
        index: usize,
        /// The changes.
        edits: Vec<Edit>,
    },
    /// One to be put in, in RON.
    New(String),
}

/// A list in a text.
pub(crate) struct List<'t> {
    source: PatchSource<'t>,
    group: &'t Group,
    indent: String,
}

impl<'t> List<'t> {
    /// A list in a text.
    pub(crate) fn new(source: PatchSource<'t>, group: &'t Group) -> Self {
        let first = group.entries.iter().find_map(|e| source.indent(e.span().start));
        let indent = match first {
            Some(blanks) => blanks.to_string(),
            None => format!("{}    ", source.line_indent(group.inner.start)),
        };
        List { source, group, indent }
    }

    /// The blanks in front of an item.
    pub(crate) fn indent(&self) -> &str {
        &self.indent
    }

    /// Whether the list has items and all of it stands on one line.
    pub(crate) fn is_one_line(&self) -> bool {
        !self.group.entries.is_empty() && !self.group.inner.slice(self.source.text).contains('\n')
    }

    /// The old item at an index.
    pub(crate) fn entry(&self, index: usize) -> Option<&'t Entry> {
        self.group.entries.get(index)
    }

    /// The changes that make the list hold these items.
    pub(crate) fn edits(&self, items: Vec<Item>) -> Option<Vec<Edit>> {
        let in_place = items.len() == self.group.entries.len()
            && items
                .iter()
                .enumerate()
                .all(|(k, i)| matches!(i, Item::Kept { index, .. } if *index == k));
        if in_place {
            let edits = items.into_iter().flat_map(|item| match item {
                Item::Kept { edits, .. } => edits,
                Item::New(_) => Vec::new(),
            });
            return Some(edits.collect());
        }
        let text = if self.is_one_line() { self.one_line(items)? } else { self.lines(items)? };
        Some(vec![(self.group.inner, text)])
    }

    fn one_line(&self, items: Vec<Item>) -> Option<String> {
        let mut texts = Vec::new();
        for item in items {
            texts.push(match item {
                Item::New(text) => text,
                Item::Kept { index, mut edits } => {
                    let entry = self.entry(index)?;
                    let start = match index.checked_sub(1) {
                        Some(previous) => self.entry(previous)?.end(),
                        None => self.group.inner.start,
                    };
                    let mut end = entry.end();
                    if index + 1 == self.group.entries.len() {
                        end = self.group.inner.end;
                    }
                    edits.extend(entry.comma.map(|comma| (comma, String::new())));
                    apply_within(self.source.text, Span::new(start, end), edits).trim().to_string()
                }
            });
        }
        Some(texts.join(", "))
    }

    /// Where the head ends and where each piece ends.
    fn cuts(&self) -> (usize, Vec<usize>) {
        let inner = self.group.inner;
        let behind = |at: usize| match self.source.line_end(at) {
            Some((_, next)) => next.min(inner.end),
            None => at,
        };
        let ends: Vec<usize> = self.group.entries.iter().map(|e| behind(e.end())).collect();
        let mut head = behind(inner.start);
        if let Some(first) = self.group.entries.first() {
            head = head.min(first.span().start);
            head = self.own_start(head, first.span().start);
        }
        (head, ends)
    }

    /// Where the comments begin that belong to an item: behind the last blank line before it.
    fn own_start(&self, from: usize, item: usize) -> usize {
        let text = self.source.text;
        let between = &text[from..item];
        let mut at = from;
        let mut start = from;
        for line in between.split_inclusive('\n') {
            let blank = line.ends_with('\n') && line.trim().is_empty();
            at += line.len();
            // A blank line inside a comment separates nothing.
            let comments = &self.source.tree.comments;
            let before = comments.partition_point(|c| c.start < at);
            let in_comment = before.checked_sub(1).is_some_and(|k| at < comments[k].end);
            if blank && !in_comment {
                start = at;
            }
        }
        start
    }

    fn lines(&self, items: Vec<Item>) -> Option<String> {
        let source = self.source;
        let newline = source.newline();
        let (head, ends) = self.cuts();
        let count = self.group.entries.len();
        let starts: Vec<usize> =
            std::iter::once(head).chain(ends.iter().copied()).take(count).collect();
        let tail = ends.last().copied().unwrap_or(head);

        // Comments set apart from an item that goes away stay, before the next item that stays.
        let kept: Vec<usize> = items
            .iter()
            .filter_map(|i| match i {
                Item::Kept { index, .. } => Some(*index),
                Item::New(_) => None,
            })
            .collect();
        let mut left_over = vec![String::new(); count + 1];
        let mut carried = String::new();
        for index in 0..count {
            if kept.contains(&index) {
                left_over[index] = std::mem::take(&mut carried);
                continue;
            }
            let own = self.own_start(starts[index], self.entry(index)?.span().start);
            if source.has_comment(starts[index], own) {
                carried.push_str(Span::new(starts[index], own).slice(source.text));
            }
        }
        left_over[count] = carried;

        let mut out = Span::new(self.group.inner.start, head).slice(source.text).to_string();
        for item in items {
            match item {
                Item::New(text) => {
                    fresh_line(&mut out, newline);
                    out.push_str(&format!("{}{text},{newline}", self.indent));
                }
                Item::Kept { index, mut edits } => {
                    let entry = self.entry(index)?;
                    if !out.ends_with('\n') && !out.is_empty() {
                        out.push_str(newline);
                    }
                    out.push_str(&left_over[index]);
                    if entry.comma.is_none() {
                        let end = entry.value.span.end;
                        edits.push((Span::new(end, end), ",".to_string()));
                    }
                    let piece = Span::new(starts[index], ends[index]);
                    out.push_str(&apply_within(source.text, piece, edits));
                }
            }
        }
        if !left_over[count].is_empty() {
            fresh_line(&mut out, newline);
            out.push_str(&left_over[count]);
        }
        let tail = Span::new(tail, self.group.inner.end).slice(source.text);
        if out.ends_with('\n') && tail.is_empty() {
            // The bracket stood behind the last item; now it needs a line of its own.
            let deeper = self.indent.strip_suffix("    ").unwrap_or(&self.indent);
            out.push_str(deeper);
        }
        out.push_str(tail);
        Some(out)
    }
}

fn fresh_line(out: &mut String, newline: &str) {
    if !out.ends_with('\n') {
        out.push_str(newline);
    }
}
