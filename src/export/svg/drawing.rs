//! The few shapes that pictures are made of, written as SVG.

use crate::export::escape;
use std::fmt::Write;
use unicode_width::UnicodeWidthStr;

/// Size of ordinary text, in units of the picture (a pixel at full size).
pub(crate) const TEXT: f64 = 14.0;
/// Width of a letter over the size of the text: that of wide sans-serif fonts, so that no text is cut.
const LETTER: f64 = 0.6;

/// Width that a text takes, estimated on the safe side.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    text.width() as f64 * size * LETTER
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    /// Colour; dark enough to print.
    pub(crate) colour: &'static str,
    pub(crate) width: f64,
    /// Lengths of dashes and gaps; empty for a solid line.
    pub(crate) dashes: &'static str,
}

impl Stroke {
    /// A solid line.
    pub(crate) const fn solid(colour: &'static str, width: f64) -> Stroke {
        Stroke { colour, width, dashes: "" }
    }
}

/// Where a text stands against its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A rectangle: left, top, right, bottom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    /// Left edge.
    pub(crate) left: f64,
    /// Upper edge.
    pub(crate) top: f64,
    /// Right edge.
    pub(crate) right: f64,
    /// Lower edge.
    pub(crate) bottom: f64,
}

impl Frame {
    /// Whether a point is inside; the edges belong to it.
    pub(crate) fn holds(&self, (x, y): (f64, f64)) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    /// Whether two rectangles overlap.
    pub(crate) fn meets(&self, other: &Frame) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// Whether another rectangle is wholly inside.
    pub(crate) fn holds_all(&self, other: &Frame) -> bool {
        self.holds((other.left, other.top)) && self.holds((other.right, other.bottom))
    }

    /// The part of a segment that is inside, if any (Liang and Barsky's method).
    fn clip(&self, a: (f64, f64), b: (f64, f64)) -> Option<[(f64, f64); 2]> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let edges = [
            (-dx, a.0 - self.left),
            (dx, self.right - a.0),
            (-dy, a.1 - self.top),
            (dy, self.bottom - a.1),
        ];
        for (p, q) in edges {
            if p == 0.0 {
                if q < 0.0 {
                    return None;
                }
            } else if p < 0.0 {
                from = from.max(q / p);
            } else {
                to = to.min(q / p);
            }
        }
        let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
        (from <= to).then(|| [at(from), at(to)])
    }

    /// The pieces of a line that are inside.
    pub(crate) fn pieces(&self, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
        let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
        let mut joined = false;
        for pair in points.windows(2) {
            let Some([a, b]) = self.clip(pair[0], pair[1]) else {
                joined = false;
                continue;
            };
            match pieces.last_mut() {
                Some(piece) if joined && a == pair[0] => piece.push(b),
                _ => pieces.push(vec![a, b]),
            }
            joined = b == pair[1];
        }
        pieces
    }
}

/// A picture as it grows.
#[derive(Debug)]
pub(crate) struct Drawing {
    width: f64,
    body: String,
}

impl Drawing {
    /// An empty picture of this width; its height is said at the end.
    pub(crate) fn new(width: f64) -> Drawing {
        Drawing { width, body: String::new() }
    }

    /// An open line through points.
    pub(crate) fn line(&mut self, points: &[(f64, f64)], stroke: Stroke) {
        self.shape("polyline", points, "none", stroke);
    }

    /// A closed shape; `fill` is a colour.
    pub(crate) fn area(&mut self, points: &[(f64, f64)], fill: &str, stroke: Stroke) {
        self.shape("polygon", points, fill, stroke);
    }

    fn shape(&mut self, kind: &str, points: &[(f64, f64)], fill: &str, stroke: Stroke) {
        // Writing to a string cannot fail.
        let _ = write!(self.body, "<{kind} points=\"");
        for (index, (x, y)) in points.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            let _ = write!(self.body, "{gap}{},{}", number(*x), number(*y));
        }
        let _ = writeln!(self.body, "\" fill=\"{fill}\"{}/>", stroked(stroke));
    }

    pub(crate) fn rectangle(&mut self, frame: Frame, fill: &str, stroke: Stroke) {
        let _ = writeln!(
            self.body,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{fill}\"{}/>",
            number(frame.left),
            number(frame.top),
            number(frame.right - frame.left),
            number(frame.bottom - frame.top),
            stroked(stroke)
        );
    }

    pub(crate) fn circle(&mut self, (x, y): (f64, f64), radius: f64, fill: &str, stroke: Stroke) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{fill}\"{}/>",
            number(x),
            number(y),
            number(radius),
            stroked(stroke)
        );
    }

    /// A text on its base line, with a white rim that keeps it readable over lines.
    pub(crate) fn text(&mut self, at: (f64, f64), anchor: Anchor, size: f64, text: &str) {
        self.words(at, anchor, size, "", text);
    }

    /// The same in bold.
    pub(crate) fn bold(&mut self, at: (f64, f64), anchor: Anchor, size: f64, text: &str) {
        self.words(at, anchor, size, " font-weight=\"bold\"", text);
    }

    /// A text that reads upwards.
    pub(crate) fn upright(&mut self, at: (f64, f64), size: f64, text: &str) {
        let turn = format!(" transform=\"rotate(-90 {} {})\"", number(at.0), number(at.1));
        self.words(at, Anchor::Middle, size, &turn, text);
    }

    fn words(&mut self, (x, y): (f64, f64), anchor: Anchor, size: f64, more: &str, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let start = format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{anchor}\"{more}",
            number(x),
            number(y),
            number(size)
        );
        let text = escape::xml(text);
        // The rim is a text of its own below the words: renderers that do not know `paint-order` would
        // paint one that belongs to them over them.
        let _ = writeln!(
            self.body,
            "{start} aria-hidden=\"true\" fill=\"#fff\" stroke=\"#fff\" stroke-width=\"4\" stroke-linejoin=\"round\">{text}</text>\n{start}>{text}</text>"
        );
    }

    /// The picture, with a title and a description for those who cannot see it.
    pub(crate) fn finish(self, height: f64, title: &str, description: &str) -> String {
        let (w, h) = (number(self.width), number(height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" role=\"img\" font-family=\"sans-serif\" fill=\"#000\">\n\
             <title>{}</title>\n<desc>{}</desc>\n\
             <rect x=\"0\" y=\"0\" width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n{}</svg>\n",
            escape::xml(title),
            escape::xml(description),
            self.body
        )
    }
}

fn stroked(stroke: Stroke) -> String {
    if stroke.width == 0.0 {
        return " stroke=\"none\"".to_string();
    }
    let dashes = if stroke.dashes.is_empty() {
        String::new()
    } else {
        format!(" stroke-dasharray=\"{}\"", stroke.dashes)
    };
    format!(
        " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"{}\"{dashes}",
        stroke.colour,
        number(stroke.width),
        // Dots are dashes of no length with round ends.
        if stroke.dashes.starts_with("0.1 ") { "round" } else { "butt" }
    )
}

/// A coordinate with two decimals at most. What is not finite never gets here; should it, the picture
/// stays well-formed.
fn number(value: f64) -> String {
    let value = if value.is_finite() { value } else { 0.0 };
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short() {
        let all = [1.0, 0.5, -0.001, 12.345_6, 100.0, f64::NAN].map(number);
        assert_eq!(all, ["1", "0.5", "0", "12.35", "100", "0"]);
    }

    #[test]
    fn lines_are_cut_at_the_frame() {
        let frame = Frame { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        let out = frame.pieces(&[(-5.0, 5.0), (5.0, 5.0), (5.0, 15.0), (8.0, 15.0), (8.0, 5.0)]);
        assert_eq!(out, [vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)], vec![(8.0, 10.0), (8.0, 5.0)]]);
        assert!(frame.pieces(&[(11.0, 0.0), (12.0, 5.0)]).is_empty());
    }
}
