//! The paper's own results (Pol & Gabrieli 2021), as ensembles of ours.

use super::ensemble::{self, Ensemble, Plan};
use crate::dem::{Controls, Flow, SceneSpec, Test};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use serde::Serialize;

/// One compared value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Which result.
    pub name: String,
    /// Quantity and unit: `F_kN`, `delta_m`, `k75_kN_per_m`, `ratio` or `part`.
    pub quantity: String,
    /// The paper's value.
    pub paper: f64,
    /// Ours: mean of the ensemble.
    pub ours: f64,
    /// 5 and 95 % points of ours.
    pub band: [f64; 2],
    /// Standard error of our mean.
    pub standard_error: f64,
    /// Ours over the paper's, less 1, %; for a `part` the difference in hundredths.
    pub difference_pct: f64,
    /// `fitted`, `in view when the starting law was chosen`, or `predicted`.
    pub standing: String,
    /// Runs, and how many of them slipped.
    pub runs: usize,
    /// Runs that slipped.
    pub slipped: usize,
}

/// Table 1: d, L, D, e_x, e_y in m, F_max in kN, delta_max in m.
pub const TABLE_1: [([f64; 5], f64, f64); 5] = [
    ([0.25, 2.5, 0.60, 0.0, 0.0], 22.6, 0.56),
    ([0.32, 2.5, 0.20, 0.0, 0.0], 13.4, 0.49),
    ([0.40, 3.0, 1.25, 0.0, 0.0], 30.9, 0.62),
    ([0.40, 4.0, 1.20, 2.0, 0.20], 34.9, 0.67),
    ([0.25, 3.5, 0.80, 0.55, 1.15], 14.9, 0.65),
];
/// Stiffness k75 in kN/m of laboratory panels of side L in m (section 3).
pub const K75: [(f64, f64); 3] = [(2.0, 247.0), (3.0, 193.0), (4.0, 170.0)];
/// Laboratory and anchored reference: kN, m.
pub const LABORATORY: (f64, f64) = (73.3, 0.60);
/// Anchored reference: kN, m.
pub const ANCHORED: (f64, f64) = (29.1, 0.65);
/// Panel sides of the comparison with Eqs. 1-2, m.
pub const PANELS: [f64; 6] = [2.0, 2.5, 3.0, 3.5, 4.0, 4.5];

/// Eq. 3, the master curve.
fn master(x: f64) -> f64 {
    1.312 * x * x * x - 0.385 * x * x + 0.073 * x
}

fn push(rows: &mut Vec<Row>, name: &str, standing: &str, e: &Ensemble, paper: (f64, f64)) {
    let kn = 1.0e-3;
    for (quantity, paper, s, unit) in
        [("F_kN", paper.0, e.force, kn), ("delta_m", paper.1, e.deflection, 1.0)]
    {
        let ours = unit * s.mean;
        rows.push(Row {
            name: name.into(),
            quantity: quantity.into(),
            paper,
            ours,
            band: s.band.map(|x| unit * x),
            standard_error: unit * s.error,
            difference_pct: 100.0 * (ours / paper - 1.0),
            standing: standing.into(),
            runs: e.runs.len(),
            slipped: e.slipped,
        });
    }
}

/// Every row, for the mesh with this wire law. `tell` hears what is being run and may end it all.
///
/// # Errors
/// What is wrong with the law.
pub fn compare(
    wire: &WireData,
    controls: &Controls,
    plan: &Plan,
    tell: &(dyn Fn(&str) -> Flow + Sync),
) -> Result<Vec<Row>, Vec<Problem>> {
    let mut rows = Vec::new();
    let run = |layout: Layout, test: Test| {
        let spec = SceneSpec { layout, test, wire: wire.clone(), phase: [0.0; 2], seed: 0 };
        ensemble::run(&spec, controls, plan, &|_| tell(""))
    };
    for side in PANELS {
        tell(&format!("laboratory, L = {side} m"));
        let e = run(Layout { spacing: side, ..REFERENCE }, Test::Laboratory)?;
        let x = side / 3.0;
        if side == 3.0 {
            push(&mut rows, "laboratory L = 3 D = 1", "fitted", &e, LABORATORY);
        } else {
            let paper = ((0.89 + 0.11 * x) * LABORATORY.0, (0.15 + 0.85 * x) * LABORATORY.1);
            push(&mut rows, &format!("Eqs. 1-2, L = {side}"), "predicted", &e, paper);
        }
        if let Some((_, k75)) = K75.iter().find(|k| k.0 == side) {
            let values: Vec<f64> = e.runs.iter().map(|r| r.outcome.k75 * 1.0e-3).collect();
            let s = ensemble::Spread::of(&values, &values);
            rows.push(Row {
                name: format!("k75, L = {side}"),
                quantity: "k75_kN_per_m".into(),
                paper: *k75,
                ours: s.mean,
                band: s.band,
                standard_error: s.error,
                difference_pct: 100.0 * (s.mean / k75 - 1.0),
                standing: "predicted".into(),
                runs: e.runs.len(),
                slipped: e.slipped,
            });
        }
    }
    tell("anchored reference");
    let e = run(REFERENCE, Test::Anchored)?;
    push(&mut rows, "anchored reference", "in view when the starting law was chosen", &e, ANCHORED);
    rows.push(shape(&e));
    for (k, (v, force, deflection)) in TABLE_1.iter().enumerate() {
        tell(&format!("Table 1, test {}", k + 1));
        let layout = Layout { plate: v[0], spacing: v[1], punch: v[2], ex: v[3], ey: v[4] };
        let e = run(layout, Test::Anchored)?;
        push(
            &mut rows,
            &format!("Table 1, test {}", k + 1),
            "predicted",
            &e,
            (*force, *deflection),
        );
    }
    Ok(rows)
}

/// Largest distance of the mean normalised curve from Eq. 3 between 0.05 and 1.
fn shape(e: &Ensemble) -> Row {
    let mut worst = (0.0_f64, 0.0, 0.0);
    for k in 1..=20 {
        let x = 0.05 * f64::from(k);
        let (mut sum, mut count) = (0.0, 0.0);
        for run in &e.runs {
            if let Some(p) = run.outcome.first_break {
                let force = super::bench::force_at(
                    &run.outcome,
                    (x * p.deflection).min(p.deflection - 0.003),
                );
                sum += force / p.force;
                count += 1.0;
            }
        }
        let ours = sum / f64::max(count, 1.0);
        if (ours - master(x)).abs() > worst.0 {
            worst = ((ours - master(x)).abs(), ours, master(x));
        }
    }
    Row {
        name: "master curve, largest distance".into(),
        quantity: "part".into(),
        paper: worst.2,
        ours: worst.1,
        band: [worst.1, worst.1],
        standard_error: 0.0,
        difference_pct: 100.0 * (worst.1 - worst.2),
        standing: "predicted".into(),
        runs: e.runs.len(),
        slipped: e.slipped,
    }
}
