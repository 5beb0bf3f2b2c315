//! Names in a narrow column: cut so that what tells them apart is kept.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// What stands where a part is left out.
const LEFT_OUT: char = '~';

/// Names in at most so many columns each. Those that fit are whole; of the others the beginning and the
/// end are kept, cut where the most of them differ.
pub(crate) fn shortened(names: &[&str], columns: usize) -> Vec<String> {
    let long: Vec<&str> = names.iter().copied().filter(|name| name.width() > columns).collect();
    let distinct = |tail: usize| {
        let mut all: Vec<String> = long.iter().map(|name| cut(name, columns, tail)).collect();
        all.sort_unstable();
        all.dedup();
        all.len()
    };
    // The shortest end that tells the most of them apart, a whole word if it can be: people read from
    // the beginning.
    let word = |tail: usize| long.iter().all(|name| name.chars().rev().nth(tail) == Some(' '));
    let tails = 0..=columns.saturating_sub(2);
    let key = |tail: &usize| (distinct(*tail), word(*tail), std::cmp::Reverse(*tail));
    let tail = tails.max_by_key(key).unwrap_or(0);
    let fit = |name: &&str| match name.width() > columns {
        true => cut(name, columns, tail),
        false => (*name).to_string(),
    };
    names.iter().map(fit).collect()
}

/// A name in at most so many columns, `tail` of them for its end.
fn cut(name: &str, columns: usize, tail: usize) -> String {
    let head = columns.saturating_sub(1 + tail);
    let mut kept = String::new();
    for c in name.chars() {
        if kept.width() + c.width().unwrap_or(0) > head {
            break;
        }
        kept.push(c);
    }
    let mut end: Vec<char> = Vec::new();
    let mut used = 0;
    for c in name.chars().rev() {
        used += c.width().unwrap_or(0);
        if used > tail {
            break;
        }
        end.push(c);
    }
    kept.push(LEFT_OUT);
    kept.extend(end.iter().rev());
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_differs_at_the_end_is_kept() {
        let names = ["DT grid 2.5 block 0.6", "DT grid 2.5 block 1.5", "HT"];
        assert_eq!(shortened(&names, 12), ["DT grid ~0.6", "DT grid ~1.5", "HT"]);
    }

    #[test]
    fn what_differs_at_both_places_is_kept() {
        let names = ["DT grid 2.5 block 0.6", "DT grid 3.0 block 0.6", "DT grid 3.0 block 1.5"];
        let cut = shortened(&names, 16);
        assert_eq!(cut, ["DT grid 2.5 ~0.6", "DT grid 3.0 ~0.6", "DT grid 3.0 ~1.5"]);
    }

    #[test]
    fn names_that_fit_are_whole_and_wide_letters_count_twice() {
        assert_eq!(shortened(&["bench 1", "bench 2"], 7), ["bench 1", "bench 2"]);
        let cut = shortened(&["石石石石石石"], 7);
        assert!(cut[0].width() <= 7 && cut[0].contains('~'), "{cut:?}");
    }
}
