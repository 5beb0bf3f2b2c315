//! A report before it has a form: blocks of words. What people wrote is kept apart from our own
//! words, so that each form can make it safe in its own way.

/// A piece of a line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum TextSpan {
    /// Text as it is, ours or other people's.
    Plain(String),
    /// Text that weighs more.
    Strong(String),
    /// A symbol with its index: `F`, `a*`.
    Symbol(&'static str, &'static str),
    /// Something to type.
    Code(String),
}

/// A line of words.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Words(pub(crate) Vec<TextSpan>);

impl From<String> for Words {
    fn from(text: String) -> Words {
        Words(vec![TextSpan::Plain(text)])
    }
}

impl From<&str> for Words {
    fn from(text: &str) -> Words {
        Words::from(text.to_string())
    }
}

/// Symbols that our own words name in braces, with what is shown.
const SYMBOLS: &[(&str, &str, &str)] = &[
    ("F_l", "F", "l"),
    ("F_l*", "F", "l*"),
    ("F_a", "F", "a"),
    ("F_a*", "F", "a*"),
    ("delta_l", "\u{3b4}", "l"),
    ("delta_l*", "\u{3b4}", "l*"),
    ("delta_a", "\u{3b4}", "a"),
    ("delta_a*", "\u{3b4}", "a*"),
    ("alpha_F", "\u{3b1}", "F"),
    ("alpha_delta", "\u{3b1}", "\u{3b4}"),
    ("gamma_F", "\u{3b3}", "F"),
    ("gamma_R", "\u{3b3}", "R"),
    ("e_x", "e", "x"),
    ("e_y", "e", "y"),
    ("L_l", "L", "l"),
    ("F", "F", ""),
    ("L", "L", ""),
    ("D", "D", ""),
    ("d", "d", ""),
    ("x", "x", ""),
    ("y", "y", ""),
    ("delta", "\u{3b4}", ""),
];

/// Our own words; a symbol stands in braces: `{F_a*}`. Never for text of other people.
pub(crate) fn ours(template: &str) -> Words {
    let mut spans = Vec::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let Some((name, behind)) = after.split_once('}') else { break };
        if !before.is_empty() {
            spans.push(TextSpan::Plain(before.to_string()));
        }
        match SYMBOLS.iter().find(|symbol| symbol.0 == name) {
            Some(&(_, base, index)) => spans.push(TextSpan::Symbol(base, index)),
            None => spans.push(TextSpan::Plain(name.to_string())),
        }
        rest = behind;
    }
    if !rest.is_empty() {
        spans.push(TextSpan::Plain(rest.to_string()));
    }
    Words(spans)
}

/// Words that weigh more.
pub(crate) fn strong(text: impl Into<String>) -> Words {
    Words(vec![TextSpan::Strong(text.into())])
}

/// Something to type.
pub(crate) fn code(text: impl Into<String>) -> Words {
    Words(vec![TextSpan::Code(text.into())])
}

/// A block of a report.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Block {
    /// A heading of level 2 or 3.
    Heading(u8, Words),
    Paragraph(Words),
    /// Free text of other people, which may have several lines and paragraphs.
    Free(String),
    List(Vec<Words>),
    /// A table: its head, and rows of as many cells. The first column is words, others are numbers
    /// where `numbers` says so.
    Table {
        /// Names of the columns.
        head: Vec<Words>,
        rows: Vec<Vec<Words>>,
        /// Whether all columns but the first are set to the right.
        numbers: bool,
    },
    /// An equation with its number.
    Equation(Words, &'static str),
    /// Pictures beside each other: SVG with what they show.
    Pictures(Vec<Picture>),
    /// Lines to type.
    Commands(Vec<String>),
    /// What follows begins a page in print.
    NewPage,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Picture {
    pub(crate) svg: String,
    /// What it shows.
    pub(crate) caption: String,
    /// Whether it takes the whole width.
    pub(crate) wide: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ReportDocument {
    pub(crate) title: String,
    /// Whether a layout is to have one page.
    pub(crate) short: bool,
    /// Its blocks in order.
    pub(crate) blocks: Vec<Block>,
}

impl ReportDocument {
    /// Adds a chapter's heading.
    pub(crate) fn chapter(&mut self, words: impl Into<Words>) {
        self.blocks.push(Block::Heading(2, words.into()));
    }

    /// Adds a section's heading.
    pub(crate) fn section(&mut self, words: impl Into<Words>) {
        self.blocks.push(Block::Heading(3, words.into()));
    }

    /// Adds a paragraph of our own words, with symbols in braces.
    pub(crate) fn say(&mut self, template: &str) {
        self.blocks.push(Block::Paragraph(ours(template)));
    }

    /// Adds a paragraph that may hold other people's words.
    pub(crate) fn quote(&mut self, words: impl Into<Words>) {
        self.blocks.push(Block::Paragraph(words.into()));
    }

    /// Adds a table of two columns, without those rows that have nothing to say.
    pub(crate) fn facts(&mut self, head: [&str; 2], rows: Vec<(Words, Words)>) {
        self.blocks.push(Block::Table {
            head: head.map(Words::from).to_vec(),
            rows: rows.into_iter().map(|(name, value)| vec![name, value]).collect(),
            numbers: false,
        });
    }
}

/// A sentence: its first letter a capital, a full stop at its end.
pub(crate) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
    let stop = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    format!("{first}{}{stop}", letters.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_stand_in_braces() {
        let words = ours("of {F_a*} and {delta}");
        assert_eq!(
            words.0,
            [
                TextSpan::Plain("of ".into()),
                TextSpan::Symbol("F", "a*"),
                TextSpan::Plain(" and ".into()),
                TextSpan::Symbol("\u{3b4}", ""),
            ]
        );
        assert_eq!(ours("{").0, [TextSpan::Plain("{".into())]);
        assert_eq!(sentence("near the change"), "Near the change.");
    }
}
