//! How well a typed word fits a text: its letters must stand in it in order, and the fit is better
//! the more of them stand together, at starts of words, and behind the last slash.

/// The fit, higher is better; none where a letter is missing. Case and blanks of the pattern do not
/// count.
pub(crate) fn score(pattern: &str, text: &str) -> Option<i64> {
    let text: Vec<char> = text.chars().flat_map(char::to_lowercase).collect();
    let pattern: Vec<char> =
        pattern.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
    let name = text.iter().rposition(|c| matches!(c, '/' | '\\')).map_or(0, |slash| slash + 1);
    // best[j]: the best fit of the pattern so far that ends with a letter at place j.
    let mut best: Vec<Option<i64>> = Vec::new();
    for (i, wanted) in pattern.iter().enumerate() {
        let mut next = vec![None; text.len()];
        let mut before: Option<i64> = (i == 0).then_some(0);
        for (j, here) in text.iter().enumerate() {
            let together = if i > 0 && j > 0 { best[j - 1] } else { None };
            if here == wanted {
                let starts = j == 0 || !text[j - 1].is_alphanumeric();
                let worth = 1 + i64::from(starts) * 4 + i64::from(j >= name) * 3;
                let fit = before.max(together.map(|b| b + 5));
                next[j] = fit.map(|fit| fit + worth);
            }
            if i > 0 {
                before = before.max(best[j]);
            }
        }
        best = next;
    }
    if pattern.is_empty() {
        return Some(0);
    }
    // Of equal fits the shorter text is the better one.
    let length = i64::try_from(text.len()).unwrap_or(i64::MAX / 4);
    best.into_iter().flatten().max().map(|fit| fit * 1000 - length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_must_stand_there_in_order() {
        for (pattern, text, fits) in [
            ("", "anything", true),
            ("rdct", "sites/road-cut.ron", true),
            ("RDCT", "road-cut.ron", true),
            ("cutroad", "road-cut.ron", false),
            ("roadd", "road-cut.ron", false),
            ("a", "", false),
            ("road cut", "road-cut.ron", true),
            ("aaa", "aa", false),
        ] {
            assert_eq!(score(pattern, text).is_some(), fits, "{pattern} in {text}");
        }
    }

    #[test]
    fn the_better_fit_stands_higher() {
        for (pattern, better, worse) in [
            ("road", "a/road.ron", "road/a-name.ron"),
            ("cut", "road-cut.ron", "c-u-t.ron"),
            ("nor", "north.ron", "minor.ron"),
            ("road", "road.ron", "road-cut.ron"),
            ("rc", "road-cut.ron", "march.ron"),
        ] {
            assert!(score(pattern, better) > score(pattern, worse), "{pattern}: {better} {worse}");
        }
    }
}
