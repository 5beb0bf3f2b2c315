//! Text of people inside XML, HTML and Markdown: whatever a name holds, it is shown and never obeyed.

use crate::words::in_text;

/// Text that is safe between tags and inside double quotes, in XML and in HTML. What XML cannot hold
/// at all (control characters) is shown as the replacement character.
pub(crate) fn xml(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(printable(c)),
        }
    }
    out
}

/// Text that Markdown shows as it is, anywhere in a line, a cell of a table included.
///
/// `start` says that a block begins here, where a dash or a number would begin a list. The text must
/// be a single line.
pub(crate) fn markdown(text: &str, start: bool) -> String {
    let mut out = String::with_capacity(text.len());
    // Digits at the start of a block; a stop or a bracket after them begins a numbered list.
    let mut at_start = start;
    let mut in_number = false;
    for c in text.chars() {
        let c = if c == '\n' || c == '\r' { ' ' } else { printable(c) };
        // A colon and a stop make links of addresses in some dialects.
        let active = matches!(
            c,
            '\\' | '`'
                | '*'
                | '_'
                | '['
                | ']'
                | '<'
                | '>'
                | '#'
                | '|'
                | '~'
                | '&'
                | '$'
                | '@'
                | '!'
        ) || (c == ':' && out.ends_with(['p', 's']));
        let opens_list = (at_start && matches!(c, '-' | '+' | '=' | ':'))
            || (in_number && matches!(c, '.' | ')'));
        if active || opens_list {
            out.push('\\');
        }
        in_number = (at_start || in_number) && c.is_ascii_digit();
        at_start = at_start && c.is_whitespace();
        out.push(c);
    }
    out
}

fn printable(c: char) -> char {
    let refused = !in_text(c) || matches!(c, '\u{fffe}' | '\u{ffff}');
    if refused { char::REPLACEMENT_CHARACTER } else { c }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_and_quotes_lose_their_meaning() {
        assert_eq!(xml("<b a=\"1\" c='2'>&"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;");
        assert_eq!(xml("a\u{1b}[31m\u{0}\tb"), "a\u{fffd}[31m\u{fffd}\tb");
    }

    #[test]
    fn markdown_is_shown_as_it_stands() {
        assert_eq!(markdown("a_b*c|d <i>", false), "a\\_b\\*c\\|d \\<i\\>");
        assert_eq!(markdown("- 1. x", true), "\\- 1. x");
        assert_eq!(markdown("12. x", true), "12\\. x");
        assert_eq!(markdown("12. x", false), "12. x");
        assert_eq!(markdown("![x](http://y)", true), "\\!\\[x\\](http\\://y)");
        assert_eq!(markdown("two\nlines", false), "two lines");
    }
}
