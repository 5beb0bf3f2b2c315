//! Five statements about one block on a large mesh of pinned anchors, from the conclusions of Marchelli, Pol,
//! Peila & Gabrieli (2023), against runs of ours: an independent check of single blocks. No numbers of theirs
//! were readable, so each is answered yes or no.
//!
//! All scenes have the same field of cells, alignments and slack, so that changes are of pairs of runs. What
//! counts as "hardly" was written down before the first run: [`HARDLY`].

use super::bench::Listener;
use crate::dem::{Arrangement, Controls, Fidelity, Flow, SceneSpec, Test};
use crate::layout::{Layout, REFERENCE};
use crate::mesh::catalogue;
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, Plan, Run, Spread};
use crate::units::to_kn;
use serde::Serialize;

/// Cells in a direction around the block.
const FIELD: usize = 5;
/// Fields of the reference scene that say how much the number of cells matters.
const FIELDS: [usize; 4] = [3, 5, 7, 9];
/// Runs of each scene, in pairs.
const RUNS: usize = 12;
/// Runs of each field.
const FIELD_RUNS: usize = 4;
/// Largest change, as a part, that is called hardly any.
const HARDLY: f64 = 0.05;
/// Standard errors beyond which a change is one.
const SURE: f64 = 2.0;
/// Diameters around the one at which the way of failing is said to change, m.
const BLOCKS: [f64; 6] = [0.25, 0.3, 0.35, 0.45, 0.5, 0.6];

/// A scene with its figures.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SingleRow {
    /// The scene in words.
    pub(crate) scene: String,
    /// Mean force at the first break and its standard error, kN.
    pub(crate) force_kn: [f64; 2],
    /// Deflection there and its standard error, m.
    pub(crate) delta_m: [f64; 2],
    /// Change of the force against the reference scene, run by run, with its standard error; parts.
    pub(crate) force_change: Option<[f64; 2]>,
    /// The same of the deflection.
    pub(crate) delta_change: Option<[f64; 2]>,
    /// Runs that broke first at the block, at a plate, elsewhere; and those that slipped or did not break.
    pub(crate) places: [usize; 4],
    /// How many of the first breaks are double twists.
    pub(crate) twists: usize,
    /// Most anchors that carry 90 % in a run.
    pub(crate) carrying: usize,
    /// Processor time of a run, ms.
    pub(crate) ms: f64,
}

/// A statement and what our runs say.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Statement {
    /// The statement.
    pub(crate) says: String,
    /// Whether our runs say so too.
    pub(crate) holds: bool,
    /// How it was judged.
    pub(crate) judged: String,
}

/// The statements with the scenes that answer them.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct Statements {
    /// The scenes; the reference first.
    pub(crate) scenes: Vec<SingleRow>,
    /// The reference scene in fields of growing size.
    pub(crate) fields: Vec<SingleRow>,
    /// The answers; none where it was ended early.
    pub(crate) answers: Vec<Statement>,
    /// Whether it was ended early.
    pub(crate) part: bool,
}

/// The scenes behind the statements, the reference first.
fn scenes() -> Vec<(String, Layout)> {
    let off = REFERENCE.spacing / 4.0;
    let mut list = vec![
        ("reference".to_string(), REFERENCE),
        (format!("ex = {off}"), Layout { ex: off, ..REFERENCE }),
        (format!("ey = {off}"), Layout { ey: off, ..REFERENCE }),
        ("L = 2.5".to_string(), Layout { spacing: 2.5, ..REFERENCE }),
        ("L = 3.5".to_string(), Layout { spacing: 3.5, ..REFERENCE }),
        ("d = 0.24".to_string(), Layout { plate: 0.24, ..REFERENCE }),
        ("d = 0.48".to_string(), Layout { plate: 0.48, ..REFERENCE }),
    ];
    list.extend(BLOCKS.map(|punch| (format!("D = {punch}"), Layout { punch, ..REFERENCE })));
    list
}

/// Makes the runs and answers.
///
/// # Errors
/// What is wrong with the wires of the reference mesh.
pub(crate) fn statements(listener: Listener) -> Result<Statements, Vec<Problem>> {
    let wire = crate::study::result::make::wires(&catalogue::reference())?.clone();
    let mut all = Statements::default();
    let mut made: Vec<Ensemble> = Vec::new();
    let cancelled = || (listener.ask)() == Flow::Cancel;
    for (scene, layout) in scenes() {
        (listener.tell)(&scene);
        let ensemble = single(&wire, layout, FIELD, RUNS)?;
        let base = made.first().unwrap_or(&ensemble);
        all.scenes.push(row(scene, &layout, &ensemble, base));
        made.push(ensemble);
        if cancelled() {
            return Ok(Statements { part: true, ..all });
        }
    }
    let mut base: Option<Ensemble> = None;
    for n in FIELDS {
        (listener.tell)(&format!("{n} x {n} cells"));
        let ensemble = single(&wire, REFERENCE, n, FIELD_RUNS)?;
        let before = base.as_ref().unwrap_or(&ensemble);
        all.fields.push(row(format!("{n} x {n} cells"), &REFERENCE, &ensemble, before));
        base = Some(ensemble);
        if cancelled() {
            return Ok(Statements { part: true, ..all });
        }
    }
    all.answers = answers(&all.scenes);
    Ok(all)
}

fn single(
    wire: &WireData,
    layout: Layout,
    cells: usize,
    runs: usize,
) -> Result<Ensemble, Vec<Problem>> {
    let plain = SceneSpec::plain(layout, Test::Anchored, wire.clone());
    let spec = SceneSpec { arrangement: Arrangement::Single(cells), ..plain };
    let controls = Controls { fidelity: Fidelity::Quick, after_break: 0.0, ..Controls::default() };
    let plan = Plan { runs: Some(runs), ..Plan::default() };
    ensemble::run(&spec, &controls, &plan, &|_| Flow::Continue)
}

/// Distance from the block's edge, and from a plate's, within which a break counts as one there, m.
const NEAR: f64 = 0.16;

fn row(scene: String, layout: &Layout, made: &Ensemble, base: &Ensemble) -> SingleRow {
    let change = |of: fn(&Run) -> Option<f64>| {
        let pairs = made.runs.iter().zip(&base.runs);
        let changes: Vec<f64> = pairs.filter_map(|(a, b)| Some(of(a)? / of(b)? - 1.0)).collect();
        let spread = Spread::of(&changes, &changes);
        (changes.len() > 1).then_some([spread.mean, spread.error])
    };
    let (mut places, mut twists) = ([0; 4], 0);
    for run in &made.runs {
        let Some(first) = run.outcome.breaks.first() else {
            places[3] += 1;
            continue;
        };
        let [x, y] = first.place;
        let from_block = (x - layout.ex).hypot(y - layout.ey) - layout.punch / 2.0;
        let at = if from_block <= NEAR {
            0
        } else if layout.apart_from_plate(first.place) <= NEAR {
            1
        } else {
            2
        };
        places[at] += 1;
        twists += usize::from(first.role == crate::dem::lattice::Role::Twist);
    }
    let runs = made.runs.len().max(1) as f64;
    SingleRow {
        scene,
        force_kn: [made.force.mean, made.force.error].map(to_kn),
        delta_m: [made.deflection.mean, made.deflection.error],
        force_change: change(|run| Some(run.outcome.first_break?.force)),
        delta_change: change(|run| Some(run.outcome.first_break?.deflection)),
        places,
        twists,
        carrying: made.runs.iter().map(|r| r.outcome.anchors_carrying(0.9)).max().unwrap_or(0),
        ms: made.runs.iter().map(|run| 1.0e3 * run.processor).sum::<f64>() / runs,
    }
}

/// The five answers from the scenes in the order of [`scenes`].
fn answers(rows: &[SingleRow]) -> Vec<Statement> {
    let [_, ex, ey, closer, wider, smaller, larger, blocks @ ..] = rows else {
        return Vec::new();
    };
    let f = |row: &SingleRow| row.force_change.unwrap_or([f64::NAN; 2]);
    let d = |row: &SingleRow| row.delta_change.unwrap_or([f64::NAN; 2]);
    let rises = |[change, error]: [f64; 2]| change > SURE * error;
    let falls = |[change, error]: [f64; 2]| change < -SURE * error;
    let hardly = |[change, _]: [f64; 2]| change.abs() <= HARDLY;
    let text = |row: &SingleRow| {
        let part =
            |[change, error]: [f64; 2]| format!("{:+.1} +-{:.1} %", 100.0 * change, 100.0 * error);
        format!("{}: F {}, delta {}", row.scene, part(f(row)), part(d(row)))
    };
    let kinds: Vec<String> = blocks.iter().map(kind).collect();
    let half = blocks.len() / 2;
    let (below, above) = kinds.split_at(half.min(kinds.len()));
    let alike = |all: &[String]| all.windows(2).all(|pair| pair[0] == pair[1]);
    let changes = alike(below) && alike(above) && below.first() != above.first();
    let of_blocks: Vec<String> =
        blocks.iter().zip(&kinds).map(|(row, kind)| format!("{}: {kind}", row.scene)).collect();
    let statement = |says: &str, holds: bool, judged: String| Statement {
        says: says.to_string(),
        holds,
        judged,
    };
    vec![
        statement(
            "an offset along x lowers both force and deflection",
            falls(f(ex)) && falls(d(ex)),
            text(ex),
        ),
        statement("an offset along y hardly matters", hardly(f(ey)) && hardly(d(ey)), text(ey)),
        statement(
            "more spacing raises the deflection, and slightly the force",
            rises(d(wider))
                && falls(d(closer))
                && rises(f(wider))
                && falls(f(closer))
                && f(wider)[0] < d(wider)[0],
            format!("{}; {}", text(closer), text(wider)),
        ),
        statement(
            "a larger plate raises the force, and hardly the deflection",
            rises(f(larger)) && falls(f(smaller)) && hardly(d(larger)) && hardly(d(smaller)),
            format!("{}; {}", text(smaller), text(larger)),
        ),
        statement(
            "the way of failing changes at D = 0.4 m",
            changes,
            format!("most first breaks: {}", of_blocks.join("; ")),
        ),
    ]
}

/// Where most of a scene's runs broke first, and whether most were twists.
fn kind(row: &SingleRow) -> String {
    let words = ["at the block", "at a plate", "between", "none"];
    let most = (0..4).max_by_key(|at| (row.places[*at], 4 - at)).unwrap_or(3);
    let broke: usize = row.places[..3].iter().sum();
    let bond = if 2 * row.twists > broke { "twists" } else { "wires" };
    if most == 3 { words[3].to_string() } else { format!("{}, {bond}", words[most]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, force: f64, delta: f64) -> SingleRow {
        SingleRow {
            scene: scene.into(),
            force_kn: [30.0, 0.3],
            delta_m: [0.9, 0.01],
            force_change: Some([force, 0.01]),
            delta_change: Some([delta, 0.01]),
            places: [0, 12, 0, 0],
            twists: 0,
            carrying: 4,
            ms: 1.0,
        }
    }

    #[test]
    fn answers_follow_from_changes_and_their_errors() {
        let mut rows = vec![
            row("reference", 0.0, 0.0),
            row("ex", -0.1, -0.05),
            row("ey", 0.03, -0.04),
            row("L-", -0.03, -0.1),
            row("L+", 0.03, 0.1),
            row("d-", -0.1, 0.01),
            row("d+", 0.1, -0.01),
        ];
        rows.extend(BLOCKS.map(|d| row(&format!("D = {d}"), 0.0, 0.0)));
        let holds = |rows: &[SingleRow]| -> Vec<bool> {
            answers(rows).iter().map(|answer| answer.holds).collect()
        };
        assert_eq!(holds(&rows), [true, true, true, true, false], "all fail alike");
        for small in &mut rows[7..10] {
            small.places = [12, 0, 0, 0];
        }
        assert_eq!(holds(&rows), [true; 5]);
        // Within two standard errors nothing has changed; 6 % is more than hardly any.
        rows[1].delta_change = Some([-0.019, 0.01]);
        rows[2].force_change = Some([-0.06, 0.01]);
        assert_eq!(holds(&rows)[..2], [false, false]);
    }
}
