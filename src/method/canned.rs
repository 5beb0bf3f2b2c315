//! A method in round numbers for tests.

use super::offset::{Offsets, ThroughForm, count};
use super::sizes::{PUBLISHED, Sizes, Surface, Term};
use super::*;

/// Through the mesh 2.5 D, at the anchors (d/d*)^0.5, deflection as L; offsets lower both a little.
pub(crate) fn method() -> DerivedMethod {
    let surface = |constant: f64, powers: [f64; 3]| {
        let unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        let mut terms = vec![Term([0, 0, 0], constant)];
        terms.extend(unit.into_iter().zip(powers).map(|(unit, power)| Term(unit, power)));
        Surface(terms)
    };
    let anchor = |force: f64, deflection| Anchor {
        force,
        force_error: force / 100.0,
        deflection,
        deflection_error: 0.001,
        runs: 32,
    };
    let offsets = vec![0.05; count(2, ThroughForm::Cosines)];
    DerivedMethod {
        format: FORMAT,
        name: "canned".into(),
        mesh: "dt-8x10-2.7".into(),
        wires: "0".into(),
        blocks: Blocks::Repeated,
        revisions: "solver 1, sampling 1".into(),
        fidelity: "quick".into(),
        campaigns: vec![Source { seed: 7, runs: 320, eccentric: 0.5 }],
        runs: Counts {
            asked: 320,
            used: 300,
            slipped: 1,
            diverged: 0,
            left_out: vec![("block on a plate".into(), 19)],
        },
        ranges: [[0.16, 0.48], [1.25, 4.5], [0.1, 2.5]],
        laboratory: anchor(75_000.0, 0.6),
        reference: anchor(30_000.0, 0.66),
        alpha: Alpha { force: 0.4, force_error: 0.005, deflection: 1.1, deflection_error: 0.002 },
        refitted: PUBLISHED,
        sizes: Sizes {
            form: "canned".into(),
            sharpness: 8.0,
            through: surface(libm::log(2.5), [0.0, 0.0, 1.0]),
            anchors: surface(0.0, [0.5, 0.125, 0.0]),
            deflection_through: surface(0.25, [0.0, 1.0, 0.25]),
            deflection_anchors: surface(0.0, [0.0, 1.0, -0.125]),
            threshold: [0.28, 0.4, 0.49],
        },
        offsets: Offsets {
            harmonics: 2,
            through: [ThroughForm::Cosines; 2],
            ridge: 0.0001,
            force: offsets.clone(),
            deflection: offsets,
            deviation: [0.0625, 0.03125],
            runs: 120,
        },
        master: MasterCurve {
            cubic: [1.25, -0.3125, 0.0625],
            free: [1.3, -0.3, 0.05],
            envelope: (0..21)
                .map(|i| f64::from(i) / 20.0)
                .map(|x| [0.9 * x * x * x, x * x * x, x * x])
                .collect(),
        },
        scatter: Scatter {
            small: [0.125, 0.05],
            large: [0.0625, 0.03],
            small_offset: [0.15, 0.06],
            large_offset: [0.1, 0.04],
        },
        compared: vec![FormError {
            form: "canned".into(),
            below: [0.1, 0.05],
            above: [0.08, 0.04],
        }],
        cross_validated: vec![HeldOut {
            part: "centred".into(),
            n: 3,
            force: [0.9, 1.0, 1.1],
            deflection: [0.95, 1.0, 1.05],
        }],
    }
}
