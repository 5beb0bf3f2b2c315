//! Changes to a text that leave the rest of it as it is.

use super::text::Span;

/// Puts new text in the place of parts of a text. Parts must not overlap; an empty part is a place
/// to put text in, and several texts for one place come in the order given.
pub fn apply(text: &str, mut edits: Vec<(Span, String)>) -> String {
    edits.sort_by_key(|e| (e.0.start, e.0.end));
    let mut out = String::with_capacity(text.len() + 256);
    let mut done = 0;
    for (span, new) in edits {
        if span.start < done {
            continue;
        }
        out.push_str(Span::new(done, span.start).of(text));
        out.push_str(&new);
        done = span.end;
    }
    out.push_str(Span::new(done, text.len()).of(text));
    out
}
