//! A wire law fitted to many figures at once, from more than one start.
//!
//! - [`family`]: the laws to choose from.
//! - [`data`], [`curve`], [`sheet`]: what a laboratory tells of a mesh, as rows; [`posterior`]: which laws fit it;
//!   [`coverage`]: whether their range is as wide as it should be.
//! - [`rows`]: what is compared, and the simulations that give it.
//! - [`levenberg`]: the search; [`memory`]: what it was told, so that it can go on where it was.
//! - [`say`]: what is told of the laws that fit.
//! - [`mod@reference`]: the rows and the starts that give the wires of the reference mesh.
//!
//! A fit minimises the sum of squares of (ours - target) / sigma over the rows, in the logarithms of the
//! parameters. Weak rows that hold each parameter near its start keep those in place that no row feels (a
//! twist that never breaks); they are no part of the score by which starts are compared. All laws see the
//! same alignments and slack, so that a row changes with the law alone.

pub(crate) mod coverage;
pub(crate) mod curve;
pub(crate) mod data;
pub mod family;
mod levenberg;
pub(crate) mod memory;
pub(crate) mod posterior;
pub mod reference;
pub(crate) mod rows;
pub(crate) mod say;
pub(crate) mod sheet;

use family::LawParameters;
use levenberg::squares;
use rows::{Ended, FitQuestion};

/// A row that holds a parameter where no data row feels it: no part of the score.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Held {
    /// What is held.
    pub(crate) what: HeldFigure,
    /// Where.
    pub(crate) at: f64,
    /// Standard deviation of its logarithm.
    pub(crate) sigma: f64,
}

/// What can be held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HeldFigure {
    /// A parameter by its number.
    Parameter(usize),
    /// The strength of the single wire, MPa.
    WireStrength,
}

impl Held {
    /// All parameters near those of a law.
    pub(crate) fn near(law: &LawParameters, sigma: f64) -> Vec<Held> {
        let held = |(k, at)| Held { what: HeldFigure::Parameter(k), at, sigma };
        law.values().into_iter().enumerate().map(held).collect()
    }

    fn residual(&self, law: &LawParameters) -> f64 {
        let value = match self.what {
            HeldFigure::Parameter(k) => law.values()[k],
            HeldFigure::WireStrength => law.wire_strength(),
        };
        (value / self.at).ln() / self.sigma
    }
}

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
    /// Sum of squares of what holds the law there.
    pub(crate) held: f64,
    /// Change of the residuals of the rows, then of what holds the law, with each parameter's logarithm.
    pub(crate) jacobian: Vec<Vec<f64>>,
    /// How often all rows were simulated.
    pub(crate) evaluations: usize,
}

/// Number of the law with the lowest score; 0 where none has one.
pub(crate) fn better<'a>(laws: impl Iterator<Item = &'a FittedLaw>) -> usize {
    let lowest = laws.enumerate().min_by(|a, b| a.1.score.total_cmp(&b.1.score));
    lowest.map_or(0, |(number, _)| number)
}

/// Makes the value of every row under a law; nothing where it cannot be run.
pub(crate) type ValuesOf<'a> = dyn FnMut(&LawParameters) -> Result<Option<Vec<f64>>, Ended> + 'a;

impl FitQuestion {
    /// Sum of squares of the rows at these values.
    pub(crate) fn score(&self, values: &[f64]) -> f64 {
        squares(&self.residuals(values))
    }

    fn residuals(&self, values: &[f64]) -> Vec<f64> {
        self.rows.iter().zip(values).map(|(row, value)| row.residual(*value)).collect()
    }

    /// Searches from a law that rows of `held` keep where the data do not, with about `most` simulations of
    /// all rows at most; `values` makes them. Nothing where the start cannot be run.
    ///
    /// # Errors
    /// Why it was ended.
    pub(crate) fn fit(
        &self,
        start: &LawParameters,
        held: &[Held],
        most: usize,
        values: &mut ValuesOf,
    ) -> Result<Option<FittedLaw>, Ended> {
        let mut first = None;
        let mut residuals = |at: &[f64]| -> Result<_, Ended> {
            let law = LawParameters::of_logarithms(at);
            let Some(made) = values(&law)? else { return Ok(None) };
            let mut all = self.residuals(&made);
            first.get_or_insert(squares(&all));
            all.extend(held.iter().map(|held| held.residual(&law)));
            Ok(Some(all))
        };
        let Some(found) = levenberg::search(&start.logarithms(), most, &mut residuals)? else {
            return Ok(None);
        };
        let start_score = first.unwrap_or(f64::NAN);
        let law = LawParameters::of_logarithms(&found.at).rounded();
        // Six digits move no row, but what is told shall be what is written.
        let Some(values) = values(&law)? else { return Ok(None) };
        Ok(Some(FittedLaw {
            start: *start,
            start_score,
            law,
            score: self.score(&values),
            values,
            held: held.iter().map(|held| held.residual(&law).powi(2)).sum(),
            jacobian: found.jacobian,
            evaluations: found.evaluations + 1,
        }))
    }
}
