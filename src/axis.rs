//! Axes with ticks at 1, 2 or 5 times a power of ten.

/// An axis from 0 to a round end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Distance of two ticks, in the unit shown.
    pub step: f64,
    /// Number of steps; the end is `step * steps`.
    pub steps: u32,
}

impl Axis {
    /// An axis that holds `largest` in at most `most` steps of 1, 2 or 5 times a power of ten.
    pub fn holding(largest: f64, most: u32) -> Axis {
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
    pub fn end(&self) -> f64 {
        self.step * f64::from(self.steps)
    }

    /// The ticks with their labels, all of the same number of decimals.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let decimals = (-libm::floor(libm::log10(self.step * (1.0 + 1e-9)))).max(0.0) as usize;
        (0..=self.steps)
            .map(|i| {
                let v = f64::from(i) * self.step;
                (v, if i == 0 { "0".to_string() } else { format!("{v:.decimals$}") })
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
}
