//! The first difference of two texts, to be read by a person.

/// Characters shown before and after the first that differs; some lines are a whole JSON document.
const AROUND: usize = 60;

/// Nothing if they are the same bytes.
pub(crate) fn first(expected: &str, got: &str) -> Option<String> {
    if expected == got {
        return None;
    }
    let (mut old, mut new) = (expected.split('\n'), got.split('\n'));
    let mut number = 1;
    let mut part = String::new();
    loop {
        match (old.next(), new.next()) {
            (Some(a), Some(b)) if a == b => {
                if let Some(title) = a.strip_prefix("--- ") {
                    part = format!(" of {title}");
                }
                number += 1;
            }
            (a, b) => {
                let column = match (a, b) {
                    (Some(a), Some(b)) => {
                        a.chars().zip(b.chars()).take_while(|(a, b)| a == b).count()
                    }
                    _ => 0,
                };
                let more = differing(expected, got).saturating_sub(1);
                return Some(format!(
                    "   line {number}{part}, column {}; {more} more lines differ\n   - {}\n   + {}",
                    column + 1,
                    near(a, column),
                    near(b, column)
                ));
            }
        }
    }
}

/// Lines that differ, place by place.
fn differing(expected: &str, got: &str) -> usize {
    let (old, new): (Vec<_>, Vec<_>) = (expected.split('\n').collect(), got.split('\n').collect());
    old.iter().zip(&new).filter(|(a, b)| a != b).count() + old.len().abs_diff(new.len())
}

fn near(line: Option<&str>, column: usize) -> String {
    let Some(line) = line else { return "(the end)".into() };
    let start = column.saturating_sub(AROUND);
    let shown: String = line.chars().skip(start).take(2 * AROUND).collect();
    let before = if start > 0 { "..." } else { "" };
    let after = if line.chars().count() > start + 2 * AROUND { "..." } else { "" };
    format!("{before}{shown}{after}").escape_debug().to_string()
}

#[test]
fn the_first_difference_is_shown() {
    assert_eq!(first("a\nb\n", "a\nb\n"), None);
    let said = first("--- stdout\na 1\nb\n", "--- stdout\na 2\nb\nc\n").unwrap();
    assert!(said.contains("line 2 of stdout, column 3"), "{said}");
    assert!(said.contains("- a 1") && said.contains("+ a 2"), "{said}");
    assert!(first("a", "a\n").unwrap().contains("(the end)"));
}
