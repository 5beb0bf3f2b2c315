//! Numbers that are written in groups of three digits, as data sheets do: `3 000 mm`, `1,250 mm`.

/// A number in groups with what stands behind it.
#[derive(Debug, PartialEq)]
pub(super) struct Grouped {
    /// The number without its groups, with a decimal point.
    pub(super) plain: String,
    /// The same text with a point for its only comma, which may have been a decimal comma.
    pub(super) or_decimal: Option<String>,
    /// The unit, or nothing.
    pub(super) unit: String,
}

/// Reads a number in groups; nothing where the text is another number, or none.
pub(super) fn read(text: &str) -> Option<Grouped> {
    let (sign, rest) = match text.strip_prefix(['-', '+']) {
        Some(rest) => (&text[..1], rest),
        None => ("", text),
    };
    let (first, rest) = digits(rest);
    let mark = rest.chars().next().filter(|c| separates(*c))?;
    if !(1..=3).contains(&first.len()) {
        return None;
    }
    let (mut plain, mut groups, mut rest) = (format!("{sign}{first}"), 0, rest);
    while let Some(after) = rest.strip_prefix(mark) {
        let (group, behind) = digits(after);
        if group.len() != 3 {
            break;
        }
        plain.push_str(group);
        (groups, rest) = (groups + 1, behind);
    }
    let decimals = rest.strip_prefix(['.', ',']).map(digits).filter(|(part, _)| !part.is_empty());
    let or_decimal =
        (groups == 1 && mark == ',' && decimals.is_none()).then(|| text.replacen(',', ".", 1));
    if let Some((part, behind)) = decimals {
        plain = format!("{plain}.{part}");
        rest = behind;
    }
    // One point with three digits behind it is a decimal point.
    let ordinary = groups == 0 || (groups == 1 && mark == '.' && decimals.is_none());
    let unit = rest.trim();
    let number_ends = !unit.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ','));
    (!ordinary && number_ends).then(|| Grouped { plain, or_decimal, unit: unit.to_string() })
}

/// The digits at the start, and the rest.
fn digits(text: &str) -> (&str, &str) {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    text.split_at(end)
}

/// Signs that stand between groups: comma, point, apostrophes, blanks (plain, fixed, narrow, thin).
fn separates(c: char) -> bool {
    matches!(c, ',' | '.' | '\'' | '\u{2019}' | ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_found_and_other_numbers_are_not() {
        for (text, plain, unit) in [
            ("3 000 mm", "3000", "mm"),
            ("1\u{202f}250,5 mm", "1250.5", "mm"),
            ("1'250", "1250", ""),
            ("-1.250,5", "-1250.5", ""),
            ("1,250.5 kN", "1250.5", "kN"),
            ("1.250.000 N", "1250000", "N"),
        ] {
            let grouped = read(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!((grouped.plain.as_str(), grouped.unit.as_str()), (plain, unit), "{text}");
            assert_eq!(grouped.or_decimal, None, "{text}");
        }
        let either = read("1,250 mm").unwrap();
        assert_eq!(
            (either.plain.as_str(), either.or_decimal.as_deref()),
            ("1250", Some("1.250 mm"))
        );
        for text in
            ["1.250 mm", "250 mm", "2,7", "2,75 m", "1250", "1,2500", "3 00 mm", "", "mm", "12 m"]
        {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
