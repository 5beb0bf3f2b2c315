//! What is taken out of quick members of an ensemble.

/// Error estimate of a run above which it tells no more of the bias: that of a small block is far above.
pub(crate) const MOST_ESTIMATE: f64 = 0.2;

/// What standard runs give over quick ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bias {
    /// How many pairs say so.
    pub(crate) pairs: usize,
    /// Factors on force and deflection.
    pub(crate) factors: [f64; 2],
    /// What is not known of them: standard errors, as parts.
    pub(crate) errors: [f64; 2],
    /// Scatter of the force from pair to pair, as a part.
    pair: f64,
}

/// What is known of the bias before a pair is made, as parts, of force and deflection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Prior {
    /// Mean over scenes like this one.
    pub(super) mean: [f64; 2],
    /// Standard deviation from scene to scene about that mean.
    pub(super) scenes: [f64; 2],
    /// Standard deviation from pair to pair of one scene.
    pub(super) pairs: [f64; 2],
}

/// Pairs that the scatter assumed from pair to pair counts for.
const SEEN: f64 = 3.0;

impl Prior {
    /// The bias after these ratios of standard over quick: the means of normal distributions that are known
    /// beforehand by the prior, so that few pairs say little and many all.
    pub(super) fn bias(&self, ratios: &[[f64; 2]]) -> Bias {
        let m = ratios.len() as f64;
        let of = |k: usize| {
            let mean = ratios.iter().map(|r| r[k] - 1.0).sum::<f64>() / m.max(1.0);
            let squares: f64 = ratios.iter().map(|r| (r[k] - 1.0 - mean).powi(2)).sum();
            let assumed = SEEN * self.pairs[k] * self.pairs[k];
            let pair = (assumed + squares) / (SEEN + (m - 1.0).max(0.0));
            let scenes = self.scenes[k] * self.scenes[k];
            let whole = (m * scenes + pair).max(f64::MIN_POSITIVE);
            let mean = (mean * m * scenes + self.mean[k] * pair) / whole;
            (1.0 + mean, (scenes * pair / whole).sqrt(), pair.sqrt())
        };
        let [force, deflection] = [of(0), of(1)];
        Bias {
            pairs: ratios.len(),
            factors: [force.0, deflection.0],
            errors: [force.1, deflection.1],
            pair: force.2,
        }
    }
}

impl Bias {
    /// Pairs still to be made until the force's is known to a standard error of `goal`, a part.
    pub(super) fn more(&self, goal: f64) -> usize {
        let [now, goal] = [self.errors[0], goal].map(|error| error * error);
        // Each pair adds one over its own variance to one over that of the bias.
        let short = (1.0 / goal - 1.0 / now.max(f64::MIN_POSITIVE)) * self.pair * self.pair;
        if short > 0.0 { short.ceil() as usize } else { 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bias_of_a_few_pairs_worked_by_hand() {
        let prior = Prior { mean: [0.0; 2], scenes: [0.01, 0.0], pairs: [0.02, 0.01] };
        // Nothing seen: no bias, known to 1 %.
        let none = prior.bias(&[]);
        assert_eq!((none.pairs, none.factors), (0, [1.0; 2]));
        assert!((none.errors[0] - 0.01).abs() < 1e-12);
        // Ratios 1.01 and 1.03: mean 1.02, squares 2e-4, variance of a pair (3 x 4e-4 + 2e-4) / 4 = 3.5e-4,
        // of their mean 1.75e-4 beside 1e-4 of the scenes: 100/275 of the 2 % are believed.
        let two = prior.bias(&[[1.01, 1.0], [1.03, 1.0]]);
        assert!((two.factors[0] - 1.0 - 0.02 * 100.0 / 275.0).abs() < 1e-12);
        assert!((two.errors[0] - (1.0e-4_f64 * 1.75e-4 / 2.75e-4).sqrt()).abs() < 1e-12);
        // A scene whose deflection has no bias keeps it.
        assert_eq!((two.factors[1], two.errors[1]), (1.0, 0.0));
        // Where scenes like it are off by 0.5 %, that is believed with the other 175/275.
        let off = Prior { mean: [0.005, 0.003], ..prior };
        assert!((off.bias(&[]).factors[0] - 1.005).abs() < 1e-12);
        let two = off.bias(&[[1.01, 1.0], [1.03, 1.0]]);
        assert!((two.factors[0] - 1.0 - (2.0 + 0.005 * 175.0) / 275.0).abs() < 1e-12);
        assert_eq!((two.factors[1], two.errors[1]), (1.003, 0.0));
    }

    #[test]
    fn as_many_pairs_as_the_target_asks_for() {
        let prior = Prior { mean: [0.0; 2], scenes: [0.02, 0.01], pairs: [0.01, 0.01] };
        // 1/0.75^2 - 1/2^2 = 1.53, of pairs that scatter by 1 %.
        assert_eq!(prior.bias(&[]).more(0.0075), 2);
        assert_eq!(prior.bias(&[[1.0; 2]; 2]).more(0.0075), 0);
        let known = Prior { scenes: [0.005, 0.01], ..prior };
        assert_eq!(known.bias(&[]).more(0.0075), 0);
    }

    #[test]
    fn the_error_holds_where_scenes_are_as_the_prior_says() {
        use crate::dem::hash::uniform;
        let normal = |seed: u64, n: u64| {
            let [a, b] = [2 * n, 2 * n + 1].map(|k| uniform(seed, k).max(1e-300));
            (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
        };
        let prior = Prior { mean: [0.004, 0.0], scenes: [0.012, 0.006], pairs: [0.009, 0.004] };
        for m in 0..=6 {
            let (mut off, mut said, mut inside) = (0.0, 0.0, 0);
            for seed in 0..2000 {
                let truth = 1.004 + 0.012 * normal(seed, 0);
                let pair = |k: u64| [truth + 0.009 * normal(seed, k + 1), 1.0];
                let bias = prior.bias(&(0..m).map(pair).collect::<Vec<_>>());
                let error = bias.factors[0] - truth;
                off += error * error;
                said += bias.errors[0] * bias.errors[0];
                inside += i32::from(error.abs() < 1.96 * bias.errors[0]);
            }
            // Of 2000 the ratio is known to 2 %, the coverage to half a per cent; a scatter that is seen a few
            // times only is not quite a normal one's.
            let (ratio, covered) = ((said / off).sqrt(), f64::from(inside) / 2000.0);
            assert!((0.93..1.07).contains(&ratio), "{m} pairs: {ratio}");
            assert!(covered > 0.92, "{m} pairs: {covered}");
        }
    }
}
