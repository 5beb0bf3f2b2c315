//! A wire law fitted to many figures at once, from more than one start.
//!
//! - [`family`]: the laws to choose from.
//! - [`rows`]: what is compared, and the simulations that give it.
//! - [`levenberg`]: the search.
//! - [`reference`]: the rows and the starts that give the wires of the reference mesh.
//!
//! A fit minimises the sum of squares of (ours - target) / sigma over the rows, in the logarithms of the
//! parameters. Weak rows that hold each parameter near its start keep those in place that no row feels (a
//! twist that never breaks); they are no part of the score by which starts are compared. All laws see the
//! same alignments and slack, so that a row changes with the law alone.

pub mod family;
mod levenberg;
pub mod reference;
pub(crate) mod rows;

use family::{COUNT, LawParameters};
use levenberg::squares;
use rows::{Ended, FitQuestion, FitTell};

/// Simulations of all rows at most in a search.
const MOST: usize = 50;

/// A fitted law.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FittedLaw {
    /// Where the search began.
    pub(crate) start: LawParameters,
    /// Sum of squares of the rows there.
    pub(crate) start_score: f64,
    /// Where it ended, at six digits.
    pub(crate) law: LawParameters,
    /// Value of every row there.
    pub(crate) values: Vec<f64>,
    /// Sum of squares of the rows there.
    pub(crate) score: f64,
    /// How often all rows were simulated.
    pub(crate) evaluations: usize,
}

/// Number of the law with the lowest score; 0 where none has one.
pub(crate) fn better<'a>(laws: impl Iterator<Item = &'a FittedLaw>) -> usize {
    let lowest = laws.enumerate().min_by(|a, b| a.1.score.total_cmp(&b.1.score));
    lowest.map_or(0, |(number, _)| number)
}

impl FitQuestion {
    /// Sum of squares of the rows at these values.
    pub(crate) fn score(&self, values: &[f64]) -> f64 {
        squares(&self.residuals(values))
    }

    fn residuals(&self, values: &[f64]) -> Vec<f64> {
        self.rows.iter().zip(values).map(|(row, value)| row.residual(*value)).collect()
    }

    /// Searches from a law; `hold` is the standard deviation of the rows that hold each parameter near its
    /// start, in logarithms. Nothing where the start cannot be run.
    ///
    /// # Errors
    /// Why it was ended.
    pub(crate) fn fit(
        &self,
        start: &LawParameters,
        hold: f64,
        tell: &FitTell,
    ) -> Result<Option<FittedLaw>, Ended> {
        let origin = start.logarithms();
        let mut first = None;
        let mut residuals = |at: &[f64]| -> Result<_, Ended> {
            let Some(values) = self.values(&LawParameters::of_logarithms(at), tell)? else {
                return Ok(None);
            };
            let mut all = self.residuals(&values);
            first.get_or_insert(squares(&all));
            all.extend(at.iter().zip(&origin).map(|(at, from)| (at - from) / hold));
            Ok(Some(all))
        };
        let Some(found) = levenberg::search(&origin, MOST, &mut residuals)? else {
            return Ok(None);
        };
        let start_score = first.unwrap_or(f64::NAN);
        debug_assert_eq!(found.at.len(), COUNT);
        let law = LawParameters::of_logarithms(&found.at).rounded();
        // Six digits move no row, but what is told shall be what is written.
        let Some(values) = self.values(&law, tell)? else { return Ok(None) };
        let score = self.score(&values);
        let evaluations = found.evaluations + 1;
        Ok(Some(FittedLaw { start: *start, start_score, law, values, score, evaluations }))
    }
}
