//! The legend below a chart: a piece of each line with its sign, and what it is, in as many lines as
//! the words need.

use super::drawing::{Anchor, Drawing, Stroke, TEXT, text_width};
use super::marks::Mark;

/// One line of a legend.
#[derive(Debug, Clone, Default)]
pub(crate) struct LegendEntry {
    /// The line's style; nothing where there is no line to explain.
    pub(crate) line: Option<Stroke>,
    /// The sign at the line's end.
    pub(crate) mark: Option<Mark>,
    /// Whether a filled band belongs to it.
    pub(crate) band: bool,
    /// A short name in front.
    pub(crate) tag: String,
    /// What it is.
    pub(crate) words: String,
}

/// Length of the piece of line.
const SAMPLE: f64 = 52.0;
/// Height of a line of text.
const ROW: f64 = 20.0;

/// Draws the entries from `top` on and returns where they end.
pub(crate) fn draw(
    drawing: &mut Drawing,
    entries: &[LegendEntry],
    left: f64,
    right: f64,
    top: f64,
) -> f64 {
    let mut y = top;
    let begin = left + SAMPLE + 12.0;
    for entry in entries {
        let middle = y + ROW / 2.0;
        if entry.band {
            let (up, down) = (middle - 7.0, middle + 7.0);
            let (l, r) = (left, left + SAMPLE);
            let corners = [(l, up), (r, up), (r, down), (l, down)];
            drawing.area(&corners, super::marks::FILL, super::marks::BAND);
        }
        if let Some(line) = entry.line {
            drawing.line(&[(left, middle), (left + SAMPLE, middle)], line);
            if let Some(mark) = entry.mark {
                let at = if entry.tag.is_empty() { SAMPLE / 2.0 } else { SAMPLE - 8.0 };
                mark.draw(drawing, (left + at, middle), 9.0, line);
            }
        }
        let tag = if entry.tag.is_empty() { 0.0 } else { text_width(&entry.tag, TEXT) + 8.0 };
        if tag > 0.0 {
            drawing.bold((begin, middle + 5.0), Anchor::Start, TEXT, &entry.tag);
        }
        for line in wrapped(&entry.words, right - begin - tag) {
            drawing.text((begin + tag, y + ROW / 2.0 + 5.0), Anchor::Start, TEXT, &line);
            y += ROW;
        }
    }
    y
}

/// A text in lines that fit a width.
pub(crate) fn wrapped(text: &str, width: f64) -> Vec<String> {
    let columns = (width / text_width("x", TEXT)).floor().max(10.0) as usize;
    let options = textwrap::Options::new(columns)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    textwrap::wrap(text, options).into_iter().map(std::borrow::Cow::into_owned).collect()
}
