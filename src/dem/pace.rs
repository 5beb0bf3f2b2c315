//! How the punch's speed goes with the utilisation, the largest strain over the strain at rupture.
//!
//! The error of a run has two parts. That of the curve arises while the net is slack: it is thrown up and rings. That
//! of the first break goes with the speed just before it, where the net is at its slowest. With an inertia out of the
//! plane that is fitted to the net's slopes (see [`super::inertia`]) the first part is half as large, so that the punch
//! may begin nearly twice as fast, if it slows down in good time.

/// Punch travel between two fits of the inertia to the net's slopes, m: with twice that some random nets shake.
pub(super) const FOLLOW: f64 = 0.004;

/// Part of its speed that the punch has at a utilisation before the first break: whole up to a half and falling to 0.4
/// at 1, or, where the inertia is fitted, whole up to a tenth and falling to a quarter.
pub(super) fn before_break(utilisation: f64, fitted: bool) -> f64 {
    let ([begin, fall], end) =
        if fitted { ([13.0 / 12.0, 5.0 / 6.0], 0.25) } else { ([1.6, 1.2], 0.4) };
    (begin - fall * utilisation).clamp(end, 1.0)
}

/// Part of its speed that the punch has behind the first break, where the net is wholly tense: about the same travel in
/// a step whether the inertia is fitted or not. At its whole speed where it is, peaks were 10 % too high.
pub(super) fn behind_break(fitted: bool) -> f64 {
    if fitted { 0.5 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_punch_slows_down_straight_to_what_is_left_at_a_break() {
        for (fitted, from, end) in [(false, 0.5, 0.4), (true, 0.1, 0.25)] {
            for (utilisation, due) in [
                (0.0, 1.0),
                (from, 1.0),
                ((from + 1.0) / 2.0, (1.0 + end) / 2.0),
                (1.0, end),
                (1.2, end),
            ] {
                let found = before_break(utilisation, fitted);
                assert!((found - due).abs() < 1e-12, "{fitted} {utilisation}: {found}");
            }
        }
    }
}
