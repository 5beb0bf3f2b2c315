//! A page of text as it grows, wrapped to a width.

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PageLine {
    /// The text, no wider than the page was asked for.
    pub(crate) text: String,
    /// Whether it is a heading.
    pub(crate) heading: bool,
}

/// A page as it grows.
pub(super) struct TextPage {
    width: usize,
    pub(super) lines: Vec<PageLine>,
}

impl TextPage {
    pub(super) fn new(width: usize) -> TextPage {
        TextPage { width: width.max(20), lines: Vec::new() }
    }

    pub(super) fn heading(&mut self, text: &str) {
        if !self.lines.is_empty() {
            self.lines.push(PageLine { text: String::new(), heading: false });
        }
        self.push(text, 0, true);
    }

    /// A paragraph; its further lines are indented by `hang`.
    pub(super) fn text(&mut self, text: &str, hang: usize) {
        self.push(text, hang, false);
    }

    fn push(&mut self, text: &str, hang: usize, heading: bool) {
        let indent = " ".repeat(hang.min(self.width / 2));
        let options = textwrap::Options::new(self.width)
            .subsequent_indent(&indent)
            .word_separator(textwrap::WordSeparator::AsciiSpace);
        for line in textwrap::wrap(text, options) {
            self.lines.push(PageLine { text: line.into_owned(), heading });
        }
    }

    /// A quantity with its value, in two columns.
    pub(super) fn row(&mut self, words: &str, value: &str) {
        self.push(&format!("  {words:<34} {value}"), 37, false);
    }
}
