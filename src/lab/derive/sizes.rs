//! Fits of the size relations: the published form and forms of two ways of failing.

use super::Runs;
use super::fit::{Relation, Start, crossed, fit};
use crate::method::sizes::{PUBLISHED, Product, Sizes, Surface, Term, meet, power};

/// How strongly the coefficients are drawn to their start: as much as a run or so would.
const PULL: f64 = 0.05;
/// A more complex form is taken if its error is smaller by this part at least.
const BETTER: f64 = 0.01;

const LINEAR: &[[u8; 3]] = &[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const SQUARES: &[[u8; 3]] = &[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0], [0, 2, 0]];
const QUADRATIC: &[[u8; 3]] = &[
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [2, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
    [1, 1, 0],
    [1, 0, 1],
    [0, 1, 1],
];

/// A form of the anchors' surface: its words and powers.
type Form = (&'static str, &'static [[u8; 3]]);

/// Forms of the anchors' surface, the simplest first.
const FORMS: [Form; 3] = [
    ("powers of d, L, D", LINEAR),
    ("powers, with squares of the logarithms of d and L", SQUARES),
    ("quadratic in the logarithms of d, L, D", QUADRATIC),
];
/// How sharply the two ways meet, as tried.
const SHARPNESS: [f64; 2] = [4.0, 8.0];

/// A form with what it says of each run by fits that did not see it.
pub(super) struct Crossed<T> {
    pub(super) form: T,
    pub(super) words: String,
    /// Force and deflection.
    pub(super) said: [Vec<f64>; 2],
}

/// Coefficients of the force's two surfaces, through and anchors.
fn force(runs: &Runs, seen: &[usize], anchors: &[[u8; 3]], n: f64) -> Vec<f64> {
    let mut at = vec![libm::log(PUBLISHED.force_small), 0.0, 0.0, 1.0, 0.0, 0.5, 0.15, 0.05];
    at.resize(LINEAR.len() + anchors.len(), 0.0);
    let relation = |at: &[f64], i: usize| {
        let x = runs.at[i];
        let (first, second) = at.split_at(LINEAR.len());
        let [a, b] = [(first, LINEAR), (second, anchors)]
            .map(|(c, powers)| c.iter().zip(powers).map(|(c, p)| c * power(*p, x)).sum::<f64>());
        let (value, part) = meet(a, b, n);
        let gradient = LINEAR
            .iter()
            .map(|p| part * power(*p, x))
            .chain(anchors.iter().map(|p| (1.0 - part) * power(*p, x)));
        (libm::log(value), gradient.collect())
    };
    fit(Start { at, pull: PULL }, seen, &runs.force, &relation)
}

/// Coefficients of the deflection's two surfaces, given the part of the first way in each run.
fn deflection(runs: &Runs, seen: &[usize], anchors: &[[u8; 3]], parts: &[f64]) -> Vec<f64> {
    let mut at = vec![0.0, 0.0, 1.0, 0.3, 0.0, 0.0, 1.0, -0.05];
    at.resize(LINEAR.len() + anchors.len(), 0.0);
    let relation = |at: &[f64], i: usize| {
        let gradient: Vec<f64> = LINEAR
            .iter()
            .map(|p| parts[i] * power(*p, runs.at[i]))
            .chain(anchors.iter().map(|p| (1.0 - parts[i]) * power(*p, runs.at[i])))
            .collect();
        (gradient.iter().zip(at).map(|(g, c)| g * c).sum(), gradient)
    };
    fit(Start { at, pull: PULL }, seen, &runs.deflection, &relation)
}

fn surface(powers: &[[u8; 3]], coefficients: &[f64]) -> Surface {
    Surface(powers.iter().zip(coefficients).map(|(p, c)| Term(*p, super::digits(*c))).collect())
}

/// The relations in one form, by the runs `seen`.
fn sizes(runs: &Runs, seen: &[usize], (words, anchors): Form, sharpness: f64) -> Sizes {
    let of_force = force(runs, seen, anchors, sharpness);
    let split = LINEAR.len();
    let mut found = Sizes {
        form: format!(
            "lower of two, rounded off: through the mesh by powers of d, L, D; at the anchors by {words}"
        ),
        sharpness,
        through: surface(LINEAR, &of_force[..split]),
        anchors: surface(anchors, &of_force[split..]),
        deflection_through: Surface(Vec::new()),
        deflection_anchors: Surface(Vec::new()),
        threshold: [0.0; 3],
    };
    let parts: Vec<f64> = runs
        .at
        .iter()
        .map(|x| meet(found.through.logarithm(*x), found.anchors.logarithm(*x), sharpness).1)
        .collect();
    // The deflection has a curvature in every form of the force (see the errors that derive prints).
    let of_deflection = deflection(runs, seen, QUADRATIC, &parts);
    found.deflection_through = surface(LINEAR, &of_deflection[..split]);
    found.deflection_anchors = surface(QUADRATIC, &of_deflection[split..]);
    found.threshold = [0.16, 0.32, 0.48].map(|plate| super::digits(found.meeting(plate)));
    found
}

/// All forms of two ways of failing, with what they say of runs that they did not see.
pub(super) fn forms(runs: &Runs) -> Vec<Crossed<Sizes>> {
    let all: Vec<usize> = (0..runs.len()).collect();
    let mut made = Vec::new();
    for form in FORMS {
        for sharpness in SHARPNESS {
            let said = crossed(runs.len(), |seen| {
                let found = sizes(runs, seen, form, sharpness);
                let layouts = runs.layouts.clone();
                Box::new(move |i| {
                    let at = found.at(&layouts[i]);
                    [at.force, at.deflection]
                })
            });
            made.push(Crossed {
                form: sizes(runs, &all, form, sharpness),
                words: format!("lower of two, {}, n = {sharpness}", form.0),
                said,
            });
        }
    }
    made
}

/// The place of the best form: the first whose error of the force is within [`BETTER`] of the least.
pub(super) fn best(forms: &[Crossed<Sizes>], runs: &Runs) -> usize {
    let errors: Vec<f64> =
        forms.iter().map(|form| super::error(&runs.force, &form.said[0], |_| true)).collect();
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    errors.iter().position(|error| *error <= least * (1.0 + BETTER)).unwrap_or(0)
}

/// The published form refitted.
pub(super) fn product(runs: &Runs) -> Crossed<Product> {
    let all: Vec<usize> = (0..runs.len()).collect();
    let said = crossed(runs.len(), |seen| {
        let found = refitted(runs, seen);
        let layouts = runs.layouts.clone();
        Box::new(move |i| found.at(&layouts[i]))
    });
    Crossed { form: refitted(runs, &all), words: "A.1-A.2 refitted".into(), said }
}

fn refitted(runs: &Runs, seen: &[usize]) -> Product {
    let p = PUBLISHED;
    let of_force = |v: &[f64]| Product {
        force_small: v[0],
        force_large: v[1],
        force_plate: [v[2], v[3]],
        force_spacing: v[4],
        ..p
    };
    let start =
        vec![p.force_small, p.force_large, p.force_plate[0], p.force_plate[1], p.force_spacing];
    let f = numeric(start, seen, &runs.force, &|v, i| of_force(v).at(&runs.layouts[i])[0]);
    let of_deflection = |v: &[f64]| Product {
        deflection_small: [v[0], v[1]],
        deflection_large: [v[2], v[3], v[4]],
        deflection_plate: v[5],
        ..p
    };
    let [s, l] = [p.deflection_small, [p.deflection_large[0], p.deflection_large[1]]];
    let start = vec![s[0], s[1], l[0], l[1], p.deflection_large[2], p.deflection_plate];
    let d =
        numeric(start, seen, &runs.deflection, &|v, i| of_deflection(v).at(&runs.layouts[i])[1]);
    let [f, d] = [f, d].map(|v| v.into_iter().map(super::digits).collect::<Vec<f64>>());
    Product {
        force_small: f[0],
        force_large: f[1],
        force_plate: [f[2], f[3]],
        force_spacing: f[4],
        deflection_small: [d[0], d[1]],
        deflection_large: [d[2], d[3], d[4]],
        deflection_plate: d[5],
    }
}

/// Fits a relation that is known by its value, with a gradient by differences.
fn numeric(
    start: Vec<f64>,
    seen: &[usize],
    y: &[f64],
    value: &dyn Fn(&[f64], usize) -> f64,
) -> Vec<f64> {
    const STEP: f64 = 1.0e-6;
    const LEAST: f64 = 1.0e-3; // A product that falls below nothing has no logarithm.
    let logarithm = |at: &[f64], i: usize| libm::log(value(at, i).max(LEAST));
    let relation: &Relation = &|at, i| {
        let here = logarithm(at, i);
        let gradient = (0..at.len()).map(|k| {
            let mut beside = at.to_vec();
            beside[k] += STEP;
            (logarithm(&beside, i) - here) / STEP
        });
        (here, gradient.collect())
    };
    fit(Start { at: start, pull: PULL }, seen, y, relation)
}
