//! Fits of what an offset does.

use super::Runs;
use super::fit::{Start, crossed, fit};
use crate::layout::Layout;
use crate::method::offset::{Offsets, ThroughForm, count, limited, variables};
use crate::method::sizes::{Centred, Sizes};
use std::rc::Rc;

/// Harmonics, weights of smallness and forms that are tried.
const HARMONICS: [usize; 2] = [2, 3];
const RIDGES: [f64; 3] = [1.0e-5, 1.0e-4, 1.0e-3];
const FORMS: [ThroughForm; 2] = [ThroughForm::Cosines, ThroughForm::BySize];

/// The factors, and what they say of each run by fits that did not see it, force and deflection.
pub(super) fn offsets(runs: &Runs, sizes: &Sizes) -> (Offsets, [Vec<f64>; 2]) {
    let centred: Vec<_> = runs.layouts.iter().map(|layout| sizes.at(layout)).collect();
    // Over the centred block of the relations: runs with an offset have layouts of their own.
    let quotient = |values: &[f64], of: fn(&Centred) -> f64| -> Vec<f64> {
        values.iter().zip(&centred).map(|(value, centred)| value / of(centred)).collect()
    };
    let factors =
        [quotient(&runs.force, |c| c.force), quotient(&runs.deflection, |c| c.deflection)];
    let mut best: Option<(f64, Offsets, [Vec<f64>; 2])> = None;
    for (harmonics, ridge) in HARMONICS.into_iter().flat_map(|h| RIDGES.map(|ridge| (h, ridge))) {
        let tried = FORMS.map(|form| Tried::new(form, runs, &centred, &factors, harmonics, ridge));
        // Force and deflection have the form that says best of runs that it has not seen, each its own.
        let error = |q: usize, k: usize| super::error(&factors[q], &tried[k].said[q], |_| true);
        let taken = [0, 1].map(|q| &tried[usize::from(error(q, 1) < error(q, 0))]);
        let sum: f64 = (0..2).map(|q| super::error(&factors[q], &taken[q].said[q], |_| true)).sum();
        if best.as_ref().is_some_and(|b| b.0 <= sum) {
            continue;
        }
        let all: Vec<usize> = (0..runs.len()).collect();
        let [force, deflection] = [0, 1].map(|q| {
            let found = taken[q].coefficients(&factors[q], &all);
            found.into_iter().map(super::digits).collect()
        });
        let found = Offsets {
            harmonics,
            through: taken.map(|tried| tried.form),
            ridge,
            force,
            deflection,
            deviation: [0.0; 2],
            runs: runs.len(),
        };
        let values = [0, 1].map(|q| {
            let said = taken[q].said[q].iter().zip(&centred);
            said.map(|(f, c)| f * [c.force, c.deflection][q]).collect()
        });
        best = Some((sum, found, values));
    }
    // There is always a first one.
    best.map_or_else(|| (none(), [Vec::new(), Vec::new()]), |b| (b.1, b.2))
}

/// No effect at all.
fn none() -> Offsets {
    let zeros = vec![0.0; count(HARMONICS[0], FORMS[0])];
    Offsets {
        harmonics: HARMONICS[0],
        through: [FORMS[0]; 2],
        ridge: RIDGES[0],
        force: zeros.clone(),
        deflection: zeros,
        deviation: [0.0; 2],
        runs: 0,
    }
}

/// A form of the sums with its variables of each run, and what fits that did not see a run say of it, force and
/// deflection.
struct Tried {
    form: ThroughForm,
    x: Rc<Vec<Vec<f64>>>,
    /// Variables.
    count: usize,
    ridge: f64,
    said: [Vec<f64>; 2],
}

impl Tried {
    fn new(
        form: ThroughForm,
        runs: &Runs,
        centred: &[Centred],
        factors: &[Vec<f64>; 2],
        harmonics: usize,
        ridge: f64,
    ) -> Tried {
        let of_run = |(layout, centred): (&Layout, &Centred)| {
            variables(layout, centred.through, harmonics, form)
        };
        let x = Rc::new(runs.layouts.iter().zip(centred).map(of_run).collect());
        let count = count(harmonics, form);
        let mut tried = Tried { form, x, count, ridge, said: [Vec::new(), Vec::new()] };
        tried.said = crossed(runs.len(), |seen| {
            let c = [0, 1].map(|q| tried.coefficients(&factors[q], seen));
            let x = Rc::clone(&tried.x);
            Box::new(move |i| [0, 1].map(|q| libm::exp(limited(dot(&x[i], &c[q])))))
        });
        tried
    }

    /// By the runs `seen`.
    fn coefficients(&self, factors: &[f64], seen: &[usize]) -> Vec<f64> {
        let start = Start { at: vec![0.0; self.count], pull: self.ridge * seen.len() as f64 };
        fit(start, seen, factors, &|at, i| (limited(dot(&self.x[i], at)), self.x[i].clone()))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
