//! One line of a plot that is turned on its side: values between the ends of their extents.

/// What stands on the line: a sign, or a stretch of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StripMark {
    /// Where it begins and ends; one value twice for a single sign.
    pub(crate) from: f64,
    /// Its end.
    pub(crate) to: f64,
    /// The values of the line's first and last column.
    pub(crate) ends: (f64, f64),
    pub(crate) sign: char,
}

impl StripMark {
    /// A single sign.
    pub(crate) fn at(value: f64, ends: (f64, f64), sign: char) -> StripMark {
        StripMark { from: value, to: value, ends, sign }
    }
}

/// The line of a width. Later marks stand over earlier ones; two letters at one place are `*`; what is
/// outside its extent is left out.
pub(crate) fn strip(width: usize, marks: impl IntoIterator<Item = StripMark>) -> String {
    let mut cells = vec![' '; width];
    let last = width.saturating_sub(1);
    for mark in marks {
        let (least, most) = mark.ends;
        if !(mark.from <= most && mark.to >= least) {
            continue;
        }
        let place = |value: f64| {
            let part = if most > least { (value - least) / (most - least) } else { 0.5 };
            ((part.clamp(0.0, 1.0) * last as f64).round() as usize).min(last)
        };
        for cell in cells.iter_mut().take(place(mark.to) + 1).skip(place(mark.from)) {
            let both = cell.is_alphabetic() && mark.sign.is_alphabetic();
            *cell = if both { '*' } else { mark.sign };
        }
    }
    cells.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_stand_at_their_parts_and_letters_share_a_star() {
        let ends = (10.0, 20.0);
        let at = |value, sign| StripMark::at(value, ends, sign);
        assert_eq!(strip(11, [at(10.0, 'x'), at(20.0, 'F')]), "x         F");
        assert_eq!(strip(11, [at(15.0, 'x'), at(15.0, 'F')]), "     *     ");
        assert_eq!(strip(11, [at(15.0, ':'), at(15.0, 'F'), at(21.0, 'x')]), "     F     ");
        let band = StripMark { from: 12.0, to: 30.0, ends, sign: '-' };
        assert_eq!(strip(11, [band, at(13.0, 'D')]), "  -D-------");
        assert_eq!(strip(3, [StripMark::at(5.0, (5.0, 5.0), 'F')]), " F ");
    }
}
