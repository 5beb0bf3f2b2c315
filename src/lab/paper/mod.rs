//! The paper's own results beside ours: ensembles over alignment and scatter with one wire law.
//!
//! Which of them the law has seen is marked: the laboratory test with Eqs. 1-2 and the stiffness, the
//! anchored reference and its curve are rows of the fit (see [`super::fit::reference`]), which did not
//! read Table 1. The paper's blocks repeat from cell to cell. That its eccentric results come out where blocks of
//! neighbouring cells face each other was found with those results in view; rows of that arrangement stand
//! beside the repeated ones and say so ([`beside`], with a small punch of other shapes). What the laboratory test
//! alone would tell of the field stands in [`adopted`].

pub(crate) mod adopted;
mod beside;

use crate::dem::{Arrangement, Controls, Fidelity, Flow, SceneSpec, Test};
use crate::forecast::published::published;
use crate::forecast::{laboratory, master};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, EnsembleProgress, Plan, Run, Spread};
use crate::units::from_kn;
use beside::{facing, facing_rows, shaped, shaped_rows};

/// The paper's laboratory test: force, N, and deflection, m (section 3).
pub(crate) const LABORATORY: [f64; 2] = [73_300.0, 0.60];
/// The paper's anchored reference: force, N, and deflection, m (section 4).
pub(crate) const ANCHORED: [f64; 2] = [29_100.0, 0.65];
/// Its ratios alpha_F and alpha_delta (section 4).
pub(crate) const RATIOS: [f64; 2] = [0.40, 1.08];
/// Its laboratory stiffness at 75 % of the largest force: panel, m, and stiffness, N/m (section 3). How it
/// was taken is not said there.
pub(crate) const K75: [(f64, f64); 3] = [(2.0, 247.0e3), (3.0, 193.0e3), (4.0, 170.0e3)];
/// Panels at which Eqs. 1-2 are compared, m.
pub(crate) const PANELS: [f64; 6] = [2.0, 2.5, 3.0, 3.5, 4.0, 4.5];
/// Largest differences aimed at, as parts of the paper's value: force, deflection.
pub(crate) const AIM: [f64; 2] = [0.07, 0.06];
/// Largest difference of the normalised curve from Eq. 3 aimed at.
pub(crate) const SHAPE_AIM: f64 = 0.05;
/// The same for the two rows that blocks facing each other explain, of forces and deflections...
pub(crate) const AIM_FACING: [f64; 2] = [0.10, 0.08];
/// ... and of a place's factors over the centred block.
pub(crate) const AIM_FACTORS: [f64; 2] = [0.10, 0.05];
/// Standard error aimed at, as a part.
pub(crate) const ERROR_AIM: f64 = 0.02;
/// Runs of a scene at most.
const MOST: usize = 400;
/// Points of a normalised curve.
const POINTS: usize = 101;

/// What the wire law has seen of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PaperStanding {
    /// The law was fitted to it.
    Fitted,
    /// It is the same thing as a row of the fit, seen otherwise.
    InView,
    /// The explanation was found with the value in view.
    AfterTheFact,
    /// It was not looked at.
    Predicted,
}

impl PaperStanding {
    /// The word for people: `fitted`, `in view`, `after the fact` or `predicted`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            PaperStanding::Fitted => "fitted",
            PaperStanding::InView => "in view",
            PaperStanding::AfterTheFact => "after the fact",
            PaperStanding::Predicted => "predicted",
        }
    }
}

/// What a row is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PaperQuantity {
    /// Force at the first break, N.
    Force,
    /// Deflection at the first break, m.
    Deflection,
    /// Tangent stiffness at 75 % of the force, N/m.
    Stiffness,
    Ratio,
    /// Largest difference of the normalised curve from Eq. 3.
    Shape,
}

/// One value of the paper beside ours. SI.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PaperRow {
    /// The case in words.
    pub case: String,
    /// What is compared.
    pub quantity: PaperQuantity,
    /// The paper's value; 0 of a shape, which is a difference already.
    pub paper: f64,
    /// Our mean.
    pub ours: f64,
    /// Our band, 5 to 95 %.
    pub band: [f64; 2],
    /// Standard error of our mean.
    pub error: f64,
    /// Mean of the peaks beside a force.
    pub peak: Option<f64>,
    /// What the law has seen of it.
    pub standing: PaperStanding,
    /// Largest difference aimed at, as a part of the paper's value (of 1 for a shape), if any.
    pub aim: Option<f64>,
    /// Runs in the mean.
    pub runs: usize,
}

impl PaperRow {
    /// Ours less the paper's, as a part of the paper's; the value itself of a shape.
    pub(crate) fn difference(&self) -> f64 {
        if self.quantity == PaperQuantity::Shape { self.ours } else { self.ours / self.paper - 1.0 }
    }

    /// Whether the difference is within what is aimed at.
    pub(crate) fn hit(&self) -> bool {
        self.aim.is_none_or(|aim| self.difference().abs() <= aim)
    }

    /// Whether the mean is known as well as is aimed at.
    pub(crate) fn known(&self) -> bool {
        self.quantity == PaperQuantity::Shape || self.error <= ERROR_AIM * self.ours.abs()
    }
}

/// How the comparison is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PaperOptions {
    /// How exactly each run is computed.
    pub fidelity: Fidelity,
    /// Seed of the alignments and slack.
    pub seed: u64,
    /// Threads, at least 1; the result does not depend on them.
    pub threads: usize,
}

/// What is told on the way: the scene by its words, its number, how many there are, its first guess
/// of the deflection at failure, m, and the ensemble's progress.
pub(crate) type Tell<'a> = dyn Fn(&str, usize, usize, f64, EnsembleProgress) -> Flow + Sync + 'a;

/// A scene of the paper.
struct Case {
    words: String,
    test: Test,
    layout: Layout,
    /// A guess of its deflection.
    deflection: f64,
    /// How its blocks stand.
    arrangement: Arrangement,
    /// Runs at most, and whether as many are made in any case.
    most: (usize, bool),
}

impl Case {
    fn new(words: String, test: Test, layout: Layout, deflection: f64) -> Case {
        Case {
            words,
            test,
            layout,
            deflection,
            arrangement: Arrangement::default(),
            most: (MOST, false),
        }
    }
}

fn cases() -> Vec<Case> {
    let mut list: Vec<Case> = PANELS
        .iter()
        .map(|&panel| {
            Case::new(
                format!("laboratory, L = {panel}"),
                Test::Laboratory,
                Layout { spacing: panel, ..REFERENCE },
                LABORATORY[1] * laboratory::deflection_ratio(panel),
            )
        })
        .collect();
    let reference = "anchored reference".to_string();
    list.push(Case::new(reference, Test::Anchored, REFERENCE, ANCHORED[1]));
    list.extend(published().tests.iter().map(|t| {
        let words = format!("Table 1, test {}", t.test);
        Case::new(words, Test::Anchored, t.layout(), t.dem.deflection.value())
    }));
    list
}

/// Makes the comparison with these wires. Nothing where the caller cancels.
///
/// # Errors
/// What is wrong with the wires.
pub(crate) fn compare(
    wire: &WireData,
    options: &PaperOptions,
    tell: &Tell,
) -> Result<Option<Vec<PaperRow>>, Vec<Problem>> {
    let mut cases = cases();
    let repeated = cases.len();
    cases.extend(facing());
    let alike = cases.len();
    cases.extend(shaped());
    let mut made = Vec::new();
    for (number, case) in cases.iter().enumerate() {
        let told = |now| tell(&case.words, number, cases.len(), case.deflection, now);
        let Some(ensemble) = scene(case, wire, options, &told)? else { return Ok(None) };
        made.push(ensemble);
    }
    let (made, shaped) = made.split_at(alike);
    let (made, facing) = made.split_at(repeated);
    let more = [facing_rows(facing), shaped_rows(shaped)].concat();
    Ok(Some(rows(made, more)))
}

/// The ensemble of a case: as many runs as pin its force down, if [`MOST`] can.
fn scene(
    case: &Case,
    wire: &WireData,
    options: &PaperOptions,
    tell: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
) -> Result<Option<Ensemble>, Vec<Problem>> {
    let plain = SceneSpec::plain(case.layout, case.test, wire.clone());
    let spec = SceneSpec { arrangement: case.arrangement, ..plain };
    let controls = Controls { fidelity: options.fidelity, ..Controls::default() };
    let (most, all) = case.most;
    let mut plan = Plan {
        runs: all.then_some(most),
        seed: options.seed,
        phase: None,
        auto: false,
        threads: options.threads,
    };
    loop {
        let ensemble = ensemble::run(&spec, &controls, &plan, tell)?;
        if ensemble.partial() {
            return Ok(None);
        }
        let part = ensemble.force.error / (ensemble.force.mean * ERROR_AIM);
        if part < 1.0 || !part.is_finite() || plan.runs.is_some() {
            return Ok(Some(ensemble));
        }
        // The error falls with the root of the number; a tenth more, because it is an estimate.
        let needed = 1.1 * part * part * ensemble.runs.len() as f64;
        plan.runs = Some((needed.ceil() as usize).min(most));
    }
}

/// The rows of the ensembles of [`cases`], in their order; `more` stand behind those of Table 1.
fn rows(made: &[Ensemble], more: Vec<PaperRow>) -> Vec<PaperRow> {
    let (panels, anchored) = made.split_at(PANELS.len());
    let standard = PANELS.iter().position(|p| *p == 3.0).unwrap_or(0);
    let (lab, reference, tests) = (&panels[standard], &anchored[0], &anchored[1..]);
    let mut list = Vec::new();
    list.extend(pair("laboratory, L = 3, D = 1", LABORATORY, lab, PaperStanding::Fitted));
    list.extend(pair("anchored reference", ANCHORED, reference, PaperStanding::Fitted));
    for (case, paper, ours, base, aim) in [
        ("alpha_F", RATIOS[0], &reference.force, &lab.force, AIM[0]),
        ("alpha_delta", RATIOS[1], &reference.deflection, &lab.deflection, AIM[1]),
    ] {
        let mean = ours.mean / base.mean;
        let parts = [ours.error / ours.mean, base.error / base.mean];
        list.push(PaperRow {
            case: case.into(),
            quantity: PaperQuantity::Ratio,
            paper,
            ours: mean,
            band: ours.band.map(|v| v / base.mean),
            error: mean * parts[0].hypot(parts[1]),
            peak: None,
            standing: PaperStanding::InView,
            aim: Some(aim),
            runs: reference.runs.len(),
        });
    }
    for (test, ensemble) in published().tests.iter().zip(tests) {
        let paper = [from_kn(test.dem.force.value()), test.dem.deflection.value()];
        list.extend(pair(
            &format!("Table 1, test {}", test.test),
            paper,
            ensemble,
            PaperStanding::Predicted,
        ));
    }
    list.extend(more);
    for (panel, paper) in K75 {
        let at = PANELS.iter().position(|p| *p == panel).unwrap_or(standard);
        list.extend(stiffness(panel, paper, &panels[at].runs));
    }
    for (panel, ensemble) in PANELS.iter().zip(panels) {
        if *panel == PANELS[standard] {
            continue; // Eqs. 1-2 are 1 there: the first two rows.
        }
        let paper = [
            LABORATORY[0] * laboratory::force_ratio(*panel),
            LABORATORY[1] * laboratory::deflection_ratio(*panel),
        ];
        list.extend(pair(
            &format!("Eqs. 1-2, L = {panel}"),
            paper,
            ensemble,
            PaperStanding::Fitted,
        ));
    }
    list.push(shape("master curve, anchored reference", &reference.runs, PaperStanding::Fitted));
    let all: Vec<Run> = anchored.iter().flat_map(|e| e.runs.clone()).collect();
    list.push(shape("master curve, all anchored cases", &all, PaperStanding::InView));
    list
}

/// A way of taking the stiffness: its words, a run's, and what the law has seen of it.
type Way = (&'static str, fn(&Run) -> Option<f64>, PaperStanding);

/// The stiffness at 75 % of the force by three ways of taking it: the tangent, which the law is fitted to,
/// the chord from 10 %, and the secant from the origin.
fn stiffness(panel: f64, paper: f64, runs: &[Run]) -> Vec<PaperRow> {
    let ways: [Way; 3] = [
        ("tangent", |run| Some(run.outcome.k75).filter(|k| *k > 0.0), PaperStanding::Fitted),
        ("chord from 10 %", |run| chord(run, 0.1), PaperStanding::InView),
        ("secant", |run| chord(run, 0.0), PaperStanding::InView),
    ];
    let row = |(way, of, standing): Way| {
        let values: Vec<f64> = runs.iter().filter_map(of).collect();
        let spread = Spread::of(&values, &values);
        PaperRow {
            case: format!("k75 {way}, L = {panel}"),
            quantity: PaperQuantity::Stiffness,
            paper,
            ours: spread.mean,
            band: spread.band,
            error: spread.error,
            peak: None,
            standing,
            aim: None,
            runs: values.len(),
        }
    };
    ways.into_iter().map(row).collect()
}

/// Slope of the chord from this part of the force at the first break, or from the origin, to 75 % of it, N/m.
fn chord(run: &Run, from: f64) -> Option<f64> {
    let end = run.outcome.first_break?;
    let curve = &run.outcome.curve;
    let reached = |part: f64| {
        let k = curve.force.iter().position(|force| *force >= part * end.force)?;
        let (before, at) = match k.checked_sub(1) {
            Some(k) => (curve.deflection[k], curve.force[k]),
            None => (0.0, 0.0),
        };
        let rise = curve.force[k] - at;
        let along = if rise > 0.0 { (part * end.force - at) / rise } else { 1.0 };
        Some(before + along * (curve.deflection[k] - before))
    };
    let start = if from > 0.0 { reached(from)? } else { 0.0 };
    Some((0.75 - from) * end.force / (reached(0.75)? - start)).filter(|k| *k > 0.0)
}

/// The force and the deflection of an ensemble beside the paper's.
fn pair(case: &str, paper: [f64; 2], e: &Ensemble, standing: PaperStanding) -> [PaperRow; 2] {
    let row = |k: usize, quantity, spread: &Spread, peak| PaperRow {
        case: case.to_string(),
        quantity,
        paper: paper[k],
        ours: spread.mean,
        band: spread.band,
        error: spread.error,
        peak: Some(peak),
        standing,
        aim: Some(AIM[k]),
        runs: e.runs.iter().filter(|r| r.outcome.first_break.is_some()).count(),
    };
    [
        row(0, PaperQuantity::Force, &e.force, e.peak[0]),
        row(1, PaperQuantity::Deflection, &e.deflection, e.peak[1]),
    ]
}

/// A run's curve over its own first break, at [`POINTS`] equal steps of deflection.
fn normalised(run: &Run) -> Option<Vec<f64>> {
    let end = run.outcome.first_break?;
    let curve = &run.outcome.curve;
    let mut points: Vec<(f64, f64)> = std::iter::once((0.0, 0.0))
        .chain(curve.points().map(|p| (p.deflection / end.deflection, p.force / end.force)))
        .take_while(|p| p.0 < 1.0)
        .collect();
    points.push((1.0, 1.0));
    let mut out = Vec::with_capacity(POINTS);
    let mut k = 0;
    for step in 0..POINTS {
        let x = step as f64 / (POINTS - 1) as f64;
        while k + 2 < points.len() && points[k + 1].0 < x {
            k += 1;
        }
        let ((x0, y0), (x1, y1)) = (points[k], points[k + 1]);
        out.push(y0 + (y1 - y0) * ((x - x0) / (x1 - x0)).clamp(0.0, 1.0));
    }
    Some(out)
}

/// The largest difference of the mean normalised curve from Eq. 3; the band is that of the runs there.
fn shape(case: &str, runs: &[Run], standing: PaperStanding) -> PaperRow {
    let curves: Vec<Vec<f64>> = runs.iter().filter_map(normalised).collect();
    let mut worst = (0.0, Spread::default());
    if !curves.is_empty() {
        for k in 0..POINTS {
            let x = k as f64 / (POINTS - 1) as f64;
            let values: Vec<f64> = curves.iter().map(|c| c[k] - master::force(x)).collect();
            let spread = Spread::of(&values, &values);
            if spread.mean.abs() > worst.1.mean.abs() {
                worst = (x, spread);
            }
        }
    }
    PaperRow {
        case: format!("{case}, at {:.2} of delta", worst.0),
        quantity: PaperQuantity::Shape,
        paper: 0.0,
        ours: worst.1.mean,
        band: worst.1.band,
        error: worst.1.error,
        peak: None,
        standing,
        aim: Some(SHAPE_AIM),
        runs: curves.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;
    use crate::curve::Point;
    use crate::dem::PLAIN_PHASE;
    use crate::dem::outcome::RunOutcome;

    fn run(curve: Curve) -> Run {
        Run {
            pattern: None,
            seed: 0,
            phase: PLAIN_PHASE,
            outcome: RunOutcome::invented(curve),
            wall: 0.0,
            processor: 0.0,
        }
    }

    #[test]
    fn a_curve_that_is_the_master_curve_has_its_shape_and_a_straight_one_has_not() {
        let end = Point { deflection: 0.6, force: 30_000.0 };
        let x: Vec<f64> = (1..300).map(|k| f64::from(k) * 0.6 / 300.0).collect();
        let of = |shape: fn(f64) -> f64| {
            let force = x.iter().map(|d| 30_000.0 * shape(d / 0.6)).collect();
            run(Curve { deflection: x.clone(), force, failure: Some(end) })
        };
        let row = shape("", &[of(master::force), of(master::force)], PaperStanding::Predicted);
        assert!(row.hit() && row.ours.abs() < 1e-4 && row.runs == 2, "{row:?}");
        // Worked by hand: x - Eq. 3 is largest where 3.936 x^2 - 0.77 x - 0.927 = 0, at 0.593, 0.412.
        let row = shape("", &[of(|x| x)], PaperStanding::Predicted);
        assert!(!row.hit() && (row.ours - 0.412).abs() < 2e-3, "{row:?}");
    }

    #[test]
    fn three_ways_to_take_a_stiffness_differ_as_worked_by_hand() {
        // F = x^2 up to 1 m and 1 N: 75 % at sqrt 0.75 = 0.866, 10 % at sqrt 0.1 = 0.316.
        let x: Vec<f64> = (1..=1000).map(|k| f64::from(k) / 1000.0).collect();
        let force = x.iter().map(|x| x * x).collect();
        let end = Point { deflection: 1.0, force: 1.0 };
        let run = run(Curve { deflection: x, force, failure: Some(end) });
        assert!((chord(&run, 0.0).unwrap() - 0.75 / 0.866_025).abs() < 1e-4);
        assert!((chord(&run, 0.1).unwrap() - 0.65 / (0.866_025 - 0.316_228)).abs() < 1e-4);
        let rows = stiffness(3.0, 1.0, &[run]);
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0].runs, 0, "no tangent was found in this run");
    }

    #[test]
    fn the_cases_are_the_papers() {
        let all = cases();
        assert_eq!(all.len(), 12);
        assert_eq!(all.iter().filter(|c| c.layout == REFERENCE).count(), 2);
        assert_eq!(all.last().map(|c| c.layout.ey), Some(1.15));
        // Tests 4 and 5, the centred block of four cells, two places of the map.
        let facing = facing();
        assert_eq!(facing.len(), 5);
        let mirrored = facing.iter().filter(|c| c.arrangement == Arrangement::Mirrored);
        assert!(mirrored.clone().all(|c| c.layout.ex != 0.0 && c.layout.ey != 0.0));
        assert!(mirrored.clone().all(|c| c.layout.blocks_overlap().is_none()));
        assert_eq!(mirrored.count(), 4);
    }
}
