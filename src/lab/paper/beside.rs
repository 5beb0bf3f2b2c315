//! Rows beside those of the paper's own scenes: blocks that face each other, and a small punch of other shapes.

use super::{
    AIM_FACING, AIM_FACTORS, ANCHORED, Case, PaperQuantity, PaperRow, PaperStanding, pair,
};
use crate::curve::Point;
use crate::dem::{Arrangement, Test};
use crate::forecast::published::published;
use crate::layout::{Layout, PunchShape, REFERENCE};
use crate::study::ensemble::Ensemble;
use crate::study::sampling::{self, Placed};
use crate::units::from_kn;
use crate::words::Choice;

/// Places of the paper's map, as parts of L at its reference panel, and the factors of force and deflection
/// that its Table 1 has there (tests 5 and 4).
const PLACES: [([f64; 2], [f64; 2]); 2] =
    [([0.157, 0.329], [0.628, 0.85]), ([0.5, 0.05], [1.139, 0.815])];
/// Runs of a place and of the centred block that it is compared with, in pairs.
const PAIRS: usize = 16;
/// Runs of a scene of facing blocks at most: four cells are four times the work.
const MOST_FACING: usize = 24;

/// The scenes of blocks that face each other: the eccentric tests, then the centred block of as many cells
/// and the places of the map.
pub(super) fn facing() -> Vec<Case> {
    let mut list = Vec::new();
    for t in published().tests.iter().filter(|t| (t.layout().ex, t.layout().ey) != (0.0, 0.0)) {
        let words = format!("Table 1, test {}, mirrored", t.test);
        list.push(Case {
            arrangement: Arrangement::Mirrored,
            most: (MOST_FACING, false),
            ..Case::new(words, Test::Anchored, t.layout(), t.dem.deflection.value())
        });
    }
    let most = (PAIRS, true);
    let centred = "centred, as many cells".to_string();
    list.push(Case {
        arrangement: Arrangement::Repeated([2, 2]),
        most,
        ..Case::new(centred, Test::Anchored, REFERENCE, ANCHORED[1])
    });
    list.extend(PLACES.iter().map(|([x, y], factors)| {
        let side = REFERENCE.spacing;
        let layout = Layout { ex: x * side, ey: y * side, ..REFERENCE };
        let words = format!("map ({x}, {y}), mirrored");
        let deflection = factors[1] * ANCHORED[1];
        let case = Case::new(words, Test::Anchored, layout, deflection);
        Case { arrangement: Arrangement::Mirrored, most, ..case }
    }));
    list
}

/// Test 2, a small punch, with the punch in its other shapes.
pub(super) fn shaped() -> Vec<Case> {
    let second = published().tests.iter().filter(|t| t.test == 2);
    second
        .flat_map(|t| {
            [PunchShape::Sphere, PunchShape::Flat].map(|shape| {
                let words = format!("Table 1, test 2, {}", shape.word());
                let layout = Layout { shape, ..t.layout() };
                Case::new(words, Test::Anchored, layout, t.dem.deflection.value())
            })
        })
        .collect()
}

/// The rows of the ensembles of [`shaped`], in their order: reported, with no aim.
pub(super) fn shaped_rows(made: &[Ensemble]) -> Vec<PaperRow> {
    let Some(test) = published().tests.iter().find(|t| t.test == 2) else { return Vec::new() };
    let paper = [from_kn(test.dem.force.value()), test.dem.deflection.value()];
    let rows = shaped()
        .into_iter()
        .zip(made)
        .flat_map(|(case, ensemble)| pair(&case.words, paper, ensemble, PaperStanding::InView));
    rows.map(|row| PaperRow { aim: None, ..row }).collect()
}

/// The rows of the ensembles of [`facing`], in their order.
pub(super) fn facing_rows(made: &[Ensemble]) -> Vec<PaperRow> {
    let cases = facing();
    let tests = cases.len() - PLACES.len() - 1;
    let (eccentric, map) = made.split_at(tests);
    let papers = published().tests.iter().filter(|t| (t.layout().ex, t.layout().ey) != (0.0, 0.0));
    let mut list = Vec::new();
    for ((case, test), ensemble) in cases.iter().zip(papers).zip(eccentric) {
        let paper = [from_kn(test.dem.force.value()), test.dem.deflection.value()];
        let mut rows = pair(&case.words, paper, ensemble, PaperStanding::AfterTheFact);
        // A block on the line is one for two cells, which a repeated block is not: reported alone.
        let aimed = !case.layout.on_line(0, case.layout.ex);
        for (row, aim) in rows.iter_mut().zip(AIM_FACING) {
            row.aim = aimed.then_some(aim);
        }
        list.extend(rows);
    }
    let Some((centred, places)) = map.split_first() else { return list };
    for (k, ensemble) in places.iter().enumerate() {
        let case = &cases[tests + 1 + k];
        let parts: [fn(&Point) -> f64; 2] = [|p| p.force, |p| p.deflection];
        for (part, of) in parts.into_iter().enumerate() {
            let pairs = ensemble.runs.iter().zip(&centred.runs);
            let ratios: Vec<Placed> = pairs
                .filter_map(|(a, b)| {
                    Some(a.placed(of(&a.outcome.first_break?) / of(&b.outcome.first_break?)))
                })
                .collect();
            let spread = sampling::figures(&ensemble.sample, &ratios, &ratios);
            list.push(PaperRow {
                case: format!("{}, {}", case.words, ["F", "delta"][part]),
                quantity: PaperQuantity::Ratio,
                paper: PLACES[k].1[part],
                ours: spread.mean,
                band: spread.band,
                error: spread.error,
                peak: None,
                standing: PaperStanding::AfterTheFact,
                aim: (k == 0).then_some(AIM_FACTORS[part]),
                runs: ratios.len(),
            });
        }
    }
    list
}
