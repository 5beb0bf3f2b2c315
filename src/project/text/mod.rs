//! A small lossless reader of RON: a tree of groups and scalars, each with its place in the text.
//!
//! A plain RON reader turns a text into values and forgets where they stood and what was written
//! around them. This one keeps both, so that every problem can be shown at its line and a save
//! can change one value and leave the comments and the layout of the file alone.
//!
//! - [`Tree`], [`Node`], [`Entry`]: what is read; this file.
//! - [`parser`]: text to tree, with plain words for what is wrong.
//! - [`scalar`]: numbers and strings, both ways.

pub mod parser;
pub(crate) mod scalar;

/// A part of the text, in bytes; `end` is the first byte behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// First byte behind the part.
    pub end: usize,
}

impl Span {
    /// The part from `start` to before `end`.
    pub(crate) fn new(start: usize, end: usize) -> Self {
        Span { start, end }
    }

    /// The part's text; empty if the span does not fit the text.
    pub fn slice(self, text: &str) -> &str {
        text.get(self.start..self.end).unwrap_or("")
    }
}

/// A whole text as a tree.
#[derive(Debug, Clone, PartialEq)]
pub struct Tree {
    /// The one value that the text holds.
    pub root: Node,
    /// Every comment, in order.
    pub comments: Vec<Span>,
}

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Where it stands, from its first to its last character.
    pub(crate) span: Span,
    /// What it is.
    pub(crate) kind: NodeKind,
}

/// What a value is.
#[derive(Debug, Clone, PartialEq)]
pub enum NodeKind {
    /// A number; may be infinite or not a number.
    Number(f64),
    /// `true` or `false`.
    Bool(bool),
    /// A string, unescaped.
    Text(String),
    /// A bare word, such as `published` or `None`.
    Word(String),
    /// A character or a byte string, which project files have no use for.
    Other,
    /// Something in brackets.
    Group(Group),
}

/// The kind of a group's brackets and entries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// `(a: 1, b: 2)`.
    Struct,
    /// `(1, 2)`, `Some(1)` or `()`.
    Tuple,
    /// `[1, 2]`.
    List,
    /// `{"a": 1}`.
    Map,
}

/// Something in brackets.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Kind of brackets.
    pub(crate) shape: Shape,
    /// The word in front, as in `Some(1)`.
    pub(crate) name: Option<String>,
    /// What stands between the brackets, brackets excluded.
    pub(crate) inner: Span,
    /// The parts.
    pub(crate) entries: Vec<Entry>,
}

/// One part of a group.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The field's name and where it stands; in a map the key's text.
    pub(crate) key: Option<(String, Span)>,
    pub(crate) value: Node,
    /// The comma behind it.
    pub(crate) comma: Option<Span>,
}

impl Entry {
    /// From the key, or the value where there is no key, to the end of the value.
    pub(crate) fn span(&self) -> Span {
        let start = self.key.as_ref().map_or(self.value.span.start, |k| k.1.start);
        Span::new(start, self.value.span.end)
    }

    /// The end of the comma, or of the value where none follows.
    pub(crate) fn end(&self) -> usize {
        self.comma.map_or(self.value.span.end, |c| c.end)
    }
}

impl Node {
    /// The group, if this is one.
    pub(crate) fn group(&self) -> Option<&Group> {
        match &self.kind {
            NodeKind::Group(g) => Some(g),
            _ => None,
        }
    }

    /// The value inside `Some(...)`, if this is one.
    pub(crate) fn inside_some(&self) -> Option<&Node> {
        let some = |g: &&Group| g.shape == Shape::Tuple && g.name.as_deref() == Some("Some");
        match self.group().filter(some)?.entries.as_slice() {
            [entry] => Some(&entry.value),
            _ => None,
        }
    }

    /// The value inside any number of `Some(...)`, or this value itself.
    pub(crate) fn unwrapped(&self) -> &Node {
        self.inside_some().map_or(self, Node::unwrapped)
    }

    /// Whether this is the word `None`.
    pub(crate) fn is_none(&self) -> bool {
        matches!(&self.kind, NodeKind::Word(word) if word == "None")
    }

    /// The entry of a struct's field.
    pub(crate) fn field(&self, name: &str) -> Option<&Entry> {
        let group = self.group()?;
        (group.shape == Shape::Struct)
            .then(|| group.entries.iter().find(|e| e.key.as_ref().is_some_and(|k| k.0 == name)))?
    }

    /// The entries of a list or a tuple.
    pub(crate) fn items(&self) -> Option<&[Entry]> {
        let group = self.group()?;
        matches!(group.shape, Shape::List | Shape::Tuple).then_some(group.entries.as_slice())
    }

    /// The value at a path such as `layouts[2].d`, or the nearest one above it that is there.
    pub(crate) fn locate(&self, path: &str) -> Span {
        let mut node = self;
        let mut place = self.span;
        for step in path.split(['.', '[']).map(|s| s.trim_end_matches(']')) {
            if step.is_empty() {
                continue;
            }
            let inner = node.unwrapped();
            let next = match step.parse::<usize>() {
                Ok(index) => inner.items().and_then(|items| items.get(index)),
                Err(_) => inner.field(step),
            };
            let Some(entry) = next else { break };
            node = &entry.value;
            place = node.span;
        }
        place
    }
}

/// Line and column of a byte, both counted from 1, the column in characters.
pub(crate) fn line_column(text: &str, at: usize) -> (usize, usize) {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    let before = &text[..at];
    let line = 1 + before.bytes().filter(|&b| b == b'\n').count();
    let start = before.rfind('\n').map_or(0, |n| n + 1);
    (line, 1 + before[start..].chars().filter(|&c| c != '\u{feff}').count())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "(\n  a: 1, // one\n  \u{e4}b: [(c: Some(2)), (c: \"x\")],\n)";

    #[test]
    fn a_path_leads_to_its_place() {
        let tree = parser::parse(TEXT).unwrap();
        for (path, shown) in [
            ("a", "1"),
            ("\u{e4}b[0].c", "Some(2)"),
            ("\u{e4}b[1].c", "\"x\""),
            ("\u{e4}b[1].none", "(c: \"x\")"),
            ("\u{e4}b[7].c", "[(c: Some(2)), (c: \"x\")]"),
        ] {
            assert_eq!(tree.root.locate(path).slice(TEXT), shown, "{path}");
        }
        assert_eq!(tree.root.locate("none"), tree.root.span);
        assert_eq!(tree.comments.len(), 1);
        assert_eq!(tree.comments[0].slice(TEXT), "// one");
    }

    #[test]
    fn lines_and_columns_count_characters() {
        let b = TEXT.find('b').unwrap();
        assert_eq!(line_column(TEXT, b), (3, 4));
        // A byte inside a character stands for the character.
        assert_eq!(line_column(TEXT, b - 1), (3, 3));
        assert_eq!(line_column(TEXT, 9999), (4, 2));
        assert_eq!(line_column("\u{feff}(", 3), (1, 1));
    }

    #[test]
    fn every_kind_of_value_is_told_from_the_others() {
        let text = "(a: -1.5e3, b: true, c: 'x', d: b\"y\", e: r#\"z\"\"#, f: w, g: (), h: {1: 2}, i: N(3), j: '\\'')";
        let tree = parser::parse(text).unwrap();
        let kind = |name: &str| tree.root.field(name).map(|e| e.value.kind.clone());
        assert_eq!(kind("a"), Some(NodeKind::Number(-1500.0)));
        assert_eq!(kind("b"), Some(NodeKind::Bool(true)));
        assert_eq!(kind("c"), Some(NodeKind::Other));
        assert_eq!(kind("d"), Some(NodeKind::Other));
        assert_eq!(kind("e"), Some(NodeKind::Text("z\"".into())));
        assert_eq!(kind("f"), Some(NodeKind::Word("w".into())));
        assert_eq!(kind("j"), Some(NodeKind::Other));
        let shape = |name: &str| {
            let entry = tree.root.field(name)?;
            entry.value.group().map(|g| (g.shape, g.name.clone(), g.entries.len()))
        };
        assert_eq!(shape("g"), Some((Shape::Tuple, None, 0)));
        assert_eq!(shape("h"), Some((Shape::Map, None, 1)));
        assert_eq!(shape("i"), Some((Shape::Tuple, Some("N".into()), 1)));
    }
}
