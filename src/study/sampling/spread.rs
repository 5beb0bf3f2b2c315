//! Mean, spread and extremes of values.

/// Mean, spread and extremes of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Spread {
    /// In the unit of the values, as the others are.
    pub mean: f64,
    /// Standard deviation of a single run.
    pub deviation: f64,
    /// Standard error of the mean.
    pub error: f64,
    /// 5 % and 95 % points.
    pub band: [f64; 2],
}

impl Spread {
    /// Standard error of the mean, over it.
    pub(crate) fn uncertainty(&self) -> f64 {
        self.error / self.mean.max(f64::MIN_POSITIVE)
    }

    /// Of `values`; the band of `banded`, which may hold more.
    pub(crate) fn of(values: &[f64], banded: &[f64]) -> Spread {
        let n = values.len() as f64;
        if values.is_empty() {
            return Spread {
                band: [quantile(banded, 0.05), quantile(banded, 0.95)],
                ..Spread::default()
            };
        }
        let mean = values.iter().sum::<f64>() / n;
        let squares = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>();
        let deviation = if n > 1.0 { (squares / (n - 1.0)).sqrt() } else { 0.0 };
        Spread {
            mean,
            deviation,
            error: deviation / n.sqrt(),
            band: [quantile(banded, 0.05), quantile(banded, 0.95)],
        }
    }
}

/// Quantile of unsorted values by linear interpolation; 0 without values.
pub(crate) fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
    let place = part * last as f64;
    let low = (place.floor() as usize).min(last);
    let high = (low + 1).min(last);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_of_known_numbers() {
        let s = Spread::of(&[1.0, 2.0, 3.0, 4.0], &[0.0, 10.0]);
        // Mean 2.5; sum of squares 5, over 3; quantiles of two numbers by interpolation.
        assert!(
            (s.mean - 2.5).abs() < 1e-15 && (s.deviation - (5.0_f64 / 3.0).sqrt()).abs() < 1e-15
        );
        assert!((s.error - s.deviation / 2.0).abs() < 1e-15);
        assert!((s.band[0] - 0.5).abs() < 1e-12 && (s.band[1] - 9.5).abs() < 1e-12);
    }
}
