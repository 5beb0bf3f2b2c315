//! Text to tree. Stops at the first thing that is no RON and says so in plain words, most of which
//! stand in `complaints`.

mod complaints;

use super::{Entry, Group, Node, NodeKind, Shape, Span, Tree, scalar};
use crate::problem::Problem;

/// Deepest nesting of brackets of any kind, and of comments; a project needs seven. Reading, walking
/// and dropping a tree all go as deep as it does, so this is what keeps them on the stack.
const DEEPEST: usize = 64;

/// Something that is no RON: the byte where it stands, and what to say about it.
/// The problem's field is the path of the entry that was being read.
#[derive(Debug, Clone, PartialEq)]
pub struct SyntaxError {
    /// The byte where it stands.
    pub(crate) at: usize,
    /// What is wrong, and in which field.
    pub(crate) problem: Box<Problem>,
}

/// Reads a whole text.
///
/// # Errors
/// The first thing that is no RON.
pub fn parse(text: &str) -> Result<Tree, SyntaxError> {
    let mut p = Parser { text, at: 0, depth: 0, comments: Vec::new(), path: Vec::new() };
    if text.starts_with('\u{feff}') {
        p.at = '\u{feff}'.len_utf8();
    }
    p.trivia()?;
    if p.peek().is_none() {
        return Err(p.error(p.at, "the file holds nothing"));
    }
    p.attributes()?;
    let root = p.value()?;
    p.trivia()?;
    if p.peek().is_some() {
        let shown = p.word_at(p.at).to_string();
        return Err(p
            .error(p.at, "something stands behind the end of the project")
            .with_value(shown)
            .with_advice("a closing bracket too many, or one too early, further up?"));
    }
    Ok(Tree { root, comments: p.comments })
}

impl SyntaxError {
    fn with_value(mut self, value: impl Into<String>) -> Self {
        self.problem.value = value.into();
        self
    }
    fn with_advice(mut self, advice: impl Into<String>) -> Self {
        self.problem.advice = advice.into();
        self
    }
}

enum Step {
    Key(String),
    Index(usize),
}

struct Parser<'t> {
    text: &'t str,
    at: usize,
    /// Brackets that are open.
    depth: usize,
    comments: Vec<Span>,
    path: Vec<Step>,
}

impl<'t> Parser<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn error(&self, at: usize, message: impl Into<String>) -> SyntaxError {
        let mut path = String::new();
        for step in &self.path {
            match step {
                Step::Key(key) if path.is_empty() => path.push_str(key),
                Step::Key(key) => path.push_str(&format!(".{key}")),
                Step::Index(index) => path.push_str(&format!("[{index}]")),
            }
        }
        SyntaxError { at, problem: Box::new(Problem::new(path, message)) }
    }

    /// The word, number or sign at a place, to show it.
    fn word_at(&self, at: usize) -> &'t str {
        let rest = &self.text[at..];
        let plain = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '-' | '+');
        let end = rest.find(|c| !plain(c)).unwrap_or(rest.len());
        let end = if end == 0 { rest.chars().next().map_or(0, char::len_utf8) } else { end };
        &rest[..end]
    }

    /// Skips blanks and comments and notes the comments.
    fn trivia(&mut self) -> Result<(), SyntaxError> {
        loop {
            let rest = self.rest();
            let blank = rest.len() - rest.trim_start_matches(is_blank).len();
            self.at += blank;
            let start = self.at;
            let rest = self.rest();
            if rest.starts_with("//") {
                let end = rest.find('\n').unwrap_or(rest.len());
                let end = rest[..end].trim_end_matches('\r').len();
                self.at += end;
            } else if rest.starts_with("/*") {
                match block_comment(rest) {
                    Comment::Ends(end) => self.at += end,
                    Comment::NeverEnds => {
                        return Err(self
                            .error(start, "the comment /* that starts here never ends")
                            .with_advice("close it with */"));
                    }
                    Comment::TooDeep(at) => {
                        return Err(self.too_deep(start + at, "comments are nested too deep"));
                    }
                }
            } else {
                return Ok(());
            }
            self.comments.push(Span::new(start, self.at));
        }
    }

    /// `#![enable(implicit_some)]`, which is on anyway; no other extension has a use here.
    fn attributes(&mut self) -> Result<(), SyntaxError> {
        while self.peek() == Some('#') {
            let start = self.at;
            let mut rest = self.rest();
            let mut eat = |token: &str| {
                let behind = rest.trim_start_matches(is_blank).strip_prefix(token);
                rest = behind.unwrap_or(rest);
                behind.is_some()
            };
            let known = ["#", "!", "[", "enable", "(", "implicit_some"].into_iter().all(&mut eat);
            eat(",");
            if !(known && eat(")") && eat("]")) {
                return Err(self
                    .error(start, "project files use no RON extensions but implicit_some")
                    .with_advice("take the line out"));
            }
            self.at = self.text.len() - rest.len();
            self.trivia()?;
        }
        Ok(())
    }

    fn value(&mut self) -> Result<Node, SyntaxError> {
        let start = self.at;
        let Some(c) = self.peek() else {
            return Err(self.error(start, "the file ends where a value is expected"));
        };
        let rest = self.rest();
        let kind = match c {
            '(' | '[' | '{' => return self.group(start, None),
            '"' => self.string(0)?,
            '\'' => self.character()?,
            'r' if rest.starts_with("r\"") || raw_string_follows(rest) => self.raw_string(1)?,
            'b' if rest.starts_with("b\"") => {
                self.at += 1;
                self.string(1)?;
                NodeKind::Other
            }
            'b' if rest.starts_with("br")
                && (rest.starts_with("br\"") || raw_string_follows(&rest[1..])) =>
            {
                self.raw_string(2)?;
                NodeKind::Other
            }
            'b' if rest.starts_with("b'") => {
                self.at += 1;
                self.character()?
            }
            _ if c.is_ascii_digit() || matches!(c, '+' | '-' | '.') => self.number()?,
            _ if c.is_alphabetic() || c == '_' => {
                let word = self.identifier();
                let end = self.at;
                self.trivia()?;
                if self.peek() == Some('(') {
                    return self.group(start, Some(word));
                }
                // What was skipped belongs to what follows; the comments are noted already, and
                // reading them again would note them twice.
                let kept = self.comments.partition_point(|s| s.start < end);
                self.comments.truncate(kept);
                self.at = end;
                match word.as_str() {
                    "true" => NodeKind::Bool(true),
                    "false" => NodeKind::Bool(false),
                    "inf" => NodeKind::Number(f64::INFINITY),
                    "NaN" => NodeKind::Number(f64::NAN),
                    _ => NodeKind::Word(word),
                }
            }
            _ => {
                let shown = self.word_at(start).to_string();
                let error = self.error(start, "a value is expected here").with_value(shown.clone());
                let curly =
                    shown.starts_with(['\u{201c}', '\u{201d}', '\u{201e}', '\u{ab}', '\u{bb}']);
                return Err(if curly {
                    error.with_advice("texts stand in straight quotes: \"bench 2\"")
                } else {
                    error
                });
            }
        };
        Ok(Node { span: Span::new(start, self.at), kind })
    }

    fn identifier(&mut self) -> String {
        let rest = self.rest();
        let (skip, raw) = if rest.starts_with("r#") { (2, true) } else { (0, false) };
        let plain =
            |c: char| c.is_alphanumeric() || c == '_' || (raw && matches!(c, '.' | '+' | '-'));
        let end = rest[skip..].find(|c| !plain(c)).map_or(rest.len(), |n| n + skip);
        self.at += end;
        rest[skip..end].to_string()
    }

    fn number(&mut self) -> Result<NodeKind, SyntaxError> {
        let start = self.at;
        let bytes = self.text.as_bytes();
        let hex = self.rest().trim_start_matches(['+', '-']).starts_with("0x");
        self.at += 1;
        while let Some(&b) = bytes.get(self.at) {
            let exponent_sign =
                matches!(b, b'+' | b'-') && !hex && matches!(bytes[self.at - 1], b'e' | b'E');
            if b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.') || exponent_sign {
                self.at += 1;
            } else {
                break;
            }
        }
        let shown = &self.text[start..self.at];
        match scalar::number(shown) {
            Some(value) => Ok(NodeKind::Number(value)),
            None => Err(self.not_a_number(start, shown)),
        }
    }

    fn string(&mut self, prefix: usize) -> Result<NodeKind, SyntaxError> {
        let start = self.at;
        let bytes = self.text.as_bytes();
        self.at += 1;
        let inner = self.at;
        loop {
            match bytes.get(self.at) {
                None => {
                    self.at = start;
                    return Err(self
                        .error(start, "the text that starts here never ends")
                        .with_advice("close it with a \""));
                }
                Some(b'"') => break,
                Some(b'\\') => self.at += 2,
                Some(_) => self.at += 1,
            }
        }
        let raw = self.text.get(inner..self.at).unwrap_or("");
        self.at += 1;
        if prefix > 0 {
            return Ok(NodeKind::Other);
        }
        scalar::unescape(raw).map(NodeKind::Text).map_err(|(at, what)| {
            self.error(inner + at, what).with_advice("write a backslash twice: \\\\")
        })
    }

    fn raw_string(&mut self, prefix: usize) -> Result<NodeKind, SyntaxError> {
        let start = self.at;
        let rest = &self.rest()[prefix..];
        let hashes = rest.len() - rest.trim_start_matches('#').len();
        let close = format!("\"{}", "#".repeat(hashes));
        let inner = &rest[hashes + 1..];
        match inner.find(&close) {
            Some(end) => {
                self.at += prefix + hashes + 1 + end + close.len();
                Ok(NodeKind::Text(inner[..end].to_string()))
            }
            None => Err(self
                .error(start, "the text that starts here never ends")
                .with_advice(format!("close it with {close}"))),
        }
    }

    fn character(&mut self) -> Result<NodeKind, SyntaxError> {
        let start = self.at;
        let line = self.rest().split('\n').next().unwrap_or("");
        // One character, or a backslash and what belongs to it.
        let first = line.chars().nth(1).map_or(0, char::len_utf8);
        let end = if line.starts_with("'\\") {
            line.char_indices().skip(3).find(|c| c.1 == '\'').map(|c| c.0)
        } else {
            line.get(1 + first..).filter(|rest| rest.starts_with('\'')).map(|_| 1 + first)
        };
        match end {
            Some(end) => {
                self.at += end + 1;
                Ok(NodeKind::Other)
            }
            None => Err(self
                .error(start, "a single ' stands here")
                .with_advice("text stands in double quotes: \"text\"")),
        }
    }

    fn group(&mut self, start: usize, name: Option<String>) -> Result<Node, SyntaxError> {
        let open = self.at;
        if self.depth > DEEPEST {
            self.path.truncate(3);
            return Err(self.too_deep(open, "brackets are nested too deep"));
        }
        self.depth += 1;
        let (close, mut shape) = match self.peek() {
            Some('[') => (']', Shape::List),
            Some('{') => ('}', Shape::Map),
            _ => (')', Shape::Tuple),
        };
        self.at += 1;
        let inner = self.at;
        let mut entries: Vec<Entry> = Vec::new();
        loop {
            self.trivia()?;
            match self.peek() {
                Some(c) if c == close => break,
                None => return Err(self.unclosed(open)),
                _ => {}
            }
            if let Some(previous) = entries.last()
                && previous.comma.is_none()
            {
                return Err(self.comma_missing(previous, open, close));
            }
            if shape == Shape::Tuple && entries.is_empty() && self.key_follows() {
                shape = Shape::Struct;
            }
            let key = match shape {
                Shape::Struct => Some(self.key(&entries)?),
                Shape::Map => {
                    let key = self.value()?;
                    self.trivia()?;
                    self.colon(key.span.slice(self.text))?;
                    Some((key.span.slice(self.text).to_string(), key.span))
                }
                _ => None,
            };
            self.path.push(match &key {
                Some((key, _)) => Step::Key(key.clone()),
                None => Step::Index(entries.len()),
            });
            self.trivia()?;
            let value = self.value()?;
            // The blanks before a comma are skipped; comments there are noted.
            self.trivia()?;
            let comma = (self.peek() == Some(',')).then(|| Span::new(self.at, self.at + 1));
            if comma.is_some() {
                self.at += 1;
            }
            self.path.pop();
            entries.push(Entry { key, value, comma });
        }
        let group = Group { shape, name, inner: Span::new(inner, self.at), entries };
        self.at += 1;
        self.depth -= 1;
        Ok(Node { span: Span::new(start, self.at), kind: NodeKind::Group(group) })
    }

    /// Whether `name:` follows, which makes a group in round brackets a struct.
    fn key_follows(&self) -> bool {
        let mut ahead = Parser {
            text: self.text,
            at: self.at,
            depth: 0,
            comments: Vec::new(),
            path: Vec::new(),
        };
        if !ahead.peek().is_some_and(|c| c.is_alphabetic() || c == '_') {
            return false;
        }
        ahead.identifier();
        ahead.trivia().is_ok() && ahead.peek() == Some(':')
    }

    fn key(&mut self, entries: &[Entry]) -> Result<(String, Span), SyntaxError> {
        let start = self.at;
        if !self.peek().is_some_and(|c| c.is_alphabetic() || c == '_') {
            return Err(self.key_missing(entries));
        }
        let key = self.identifier();
        let span = Span::new(start, self.at);
        self.trivia()?;
        self.colon(&key)?;
        Ok((key, span))
    }

    fn colon(&mut self, key: &str) -> Result<(), SyntaxError> {
        if self.peek() == Some(':') {
            self.at += 1;
            return Ok(());
        }
        let shown = self.word_at(self.at).to_string();
        let advice = if shown == "=" {
            format!("write {key}: and not {key} =")
        } else {
            format!("write {key}: and then the value")
        };
        Err(self.error(self.at, format!("a colon is missing behind {key}")).with_advice(advice))
    }
}

fn is_blank(c: char) -> bool {
    // The blanks that RON knows.
    matches!(
        c,
        ' ' | '\t'
            | '\n'
            | '\r'
            | '\u{b}'
            | '\u{c}'
            | '\u{85}'
            | '\u{200e}'
            | '\u{200f}'
            | '\u{2028}'
            | '\u{2029}'
    )
}

fn raw_string_follows(rest: &str) -> bool {
    rest.strip_prefix("r#").is_some_and(|r| r.trim_start_matches('#').starts_with('"'))
}

/// How a block comment ends, in bytes from its start.
enum Comment {
    Ends(usize),
    NeverEnds,
    TooDeep(usize),
}

/// The block comment at the start of a text, nested ones included.
fn block_comment(text: &str) -> Comment {
    let bytes = text.as_bytes();
    let (mut depth, mut at) = (0usize, 0usize);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" if depth > DEEPEST => return Comment::TooDeep(at),
            b"/*" => {
                depth += 1;
                at += 2;
            }
            b"*/" => {
                depth -= 1;
                at += 2;
                if depth == 0 {
                    return Comment::Ends(at);
                }
            }
            _ => at += 1,
        }
    }
    Comment::NeverEnds
}
