//! Axes with ticks at 1, 2 or 5 times a power of ten.

/// An axis from 0 to a round end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    /// Distance of two ticks, in the unit shown.
    pub step: f64,
    /// Number of steps; the end is `step * steps`.
    pub steps: u32,
}

impl Axis {
    /// An axis that holds `largest` in at most `most` steps of 1, 2 or 5 times a power of ten.
    pub(crate) fn holding(largest: f64, most: u32) -> Axis {
        let largest = if largest.is_finite() && largest > 0.0 { largest } else { 1.0 };
        let most = most.max(1);
        let mut power = libm::floor(libm::log10(largest / f64::from(most))) as i32;
        loop {
            for digit in [1.0, 2.0, 5.0] {
                let step = digit * libm::pow(10.0, f64::from(power));
                // A value a rounding above a tick still belongs to it.
                let steps = libm::ceil(largest / step * (1.0 - 1e-9)).max(1.0);
                if steps <= f64::from(most) {
                    return Axis { step, steps: steps as u32 };
                }
            }
            power += 1;
        }
    }

    /// The end of the axis.
    pub(crate) fn end(&self) -> f64 {
        self.step * f64::from(self.steps)
    }

    /// The ticks with their labels, all of the same number of decimals.
    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        let decimals = (-libm::floor(libm::log10(self.step * (1.0 + 1e-9)))).max(0.0) as usize;
        (0..=self.steps)
            .map(|i| {
                let v = f64::from(i) * self.step;
                (v, if i == 0 { "0".to_string() } else { format!("{v:.decimals$}") })
            })
            .collect()
    }
}

/// An axis between two round ends, for values that do not begin at 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Range {
    /// First tick, in steps of `step`.
    first: f64,
    /// Distance of two ticks, in the unit shown.
    pub(crate) step: f64,
    /// Number of steps.
    pub(crate) steps: u32,
}

impl Range {
    /// An axis that holds both values in at most `most` steps of 1, 2 or 5 times a power of ten. Where
    /// they are equal, or no numbers, it has some width all the same.
    pub(crate) fn holding(least: f64, largest: f64, most: u32) -> Range {
        let sound = least.is_finite() && largest.is_finite();
        let (mut low, mut high) =
            if sound { (least.min(largest), least.max(largest)) } else { (0.0, 1.0) };
        let size = low.abs().max(high.abs());
        if high - low <= 1.0e-9 * size || high <= low {
            let half = if size > 0.0 { 0.05 * size } else { 0.5 };
            (low, high) = (low - half, high + half);
        }
        // Both ends may lie inside a step, so one more is needed than the width takes.
        let mut step = Axis::holding(high - low, most.max(2)).step;
        loop {
            let first = libm::floor(low / step * (1.0 + 1e-12) + 1e-9);
            let last = libm::ceil(high / step * (1.0 - 1e-12) - 1e-9);
            let steps = (last - first).max(1.0);
            if steps <= f64::from(most.max(2)) {
                return Range { first, step, steps: steps as u32 };
            }
            step = Axis::holding(step * 1.5, 1).step;
        }
    }

    /// Where the axis begins and ends.
    pub(crate) fn ends(&self) -> (f64, f64) {
        (self.first * self.step, (self.first + f64::from(self.steps)) * self.step)
    }

    /// The ticks with their labels, all of the same number of decimals.
    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        let decimals = (-libm::floor(libm::log10(self.step * (1.0 + 1e-9)))).max(0.0) as usize;
        (0..=self.steps)
            .map(|i| {
                // Never the negative zero.
                let v = (self.first + f64::from(i)) * self.step + 0.0;
                (v, format!("{v:.decimals$}"))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_one_two_five() {
        let labels = |largest, most| {
            let axis = Axis::holding(largest, most);
            axis.ticks().into_iter().map(|t| t.1).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(labels(31.0, 5), "0 10 20 30 40");
        assert_eq!(labels(0.62, 4), "0 0.2 0.4 0.6 0.8");
        assert_eq!(labels(73.3, 5), "0 20 40 60 80");
        assert_eq!(labels(0.034, 5), "0 0.01 0.02 0.03 0.04");
        assert_eq!(labels(620.0, 4), "0 200 400 600 800");
        assert_eq!(labels(40.0, 4), "0 10 20 30 40");
        assert_eq!(labels(f64::NAN, 4), "0 0.5 1.0");
    }

    #[test]
    fn a_range_has_round_ends_around_what_it_holds() {
        let labels = |least, largest, most| {
            let range = Range::holding(least, largest, most);
            let low = range.first * range.step;
            let high = (range.first + f64::from(range.steps)) * range.step;
            if f64::is_finite(least + largest) {
                assert!(low <= least + 1e-9 && high >= largest - 1e-9, "{range:?}");
            }
            range.ticks().into_iter().map(|t| t.1).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(labels(24.9, 29.2, 5), "24 26 28 30");
        assert_eq!(labels(1.25, 4.5, 8), "1.0 1.5 2.0 2.5 3.0 3.5 4.0 4.5");
        assert_eq!(labels(-0.75, 0.75, 4), "-1.0 -0.5 0.0 0.5 1.0");
        assert_eq!(labels(3.0, 3.0, 4), "2.8 2.9 3.0 3.1 3.2");
        assert_eq!(labels(f64::NAN, 2.0, 4), "0.0 0.5 1.0");
        let range = Range::holding(10.0, 20.0, 5);
        assert_eq!(range.ends(), (10.0, 20.0));
    }
}
