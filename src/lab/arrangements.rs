//! How the answer depends on how the blocks stand: repeated, mirrored and single blocks of the paper's tests
//! and its reference, with what the worst anchor carries, and what each costs.

use super::bench::Listener;
use crate::dem::{Controls, Fidelity, Flow, SceneSpec, Test};
use crate::forecast::published::published;
use crate::layout::{Blocks, Grid, Layout, REFERENCE};
use crate::mesh::catalogue;
use crate::problem::Problem;
use crate::study::blocks;
use crate::study::ensemble::{Plan, Run, counts};
use crate::study::result::worst_anchor;
use crate::units::to_kn;
use serde::Serialize;

/// Runs of each.
const RUNS: usize = 8;

/// One arrangement of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ArrangementRow {
    /// The scene in words.
    pub(crate) scene: String,
    /// How its blocks stood.
    pub(crate) blocks: String,
    /// Mean force per block at the first break and its standard error, kN.
    pub(crate) force_kn: [f64; 2],
    /// Deflection there and its standard error, m.
    pub(crate) delta_m: [f64; 2],
    /// The worst anchor's force over that on a block, out of the plane and in it.
    pub(crate) anchor: Option<[f64; 2]>,
    /// Fewest anchors that carry 90 %, the most in any run.
    pub(crate) carrying: usize,
    /// Processor time per node and step up to the first break, set-up included, ns.
    pub(crate) ns: f64,
    /// Processor time of a run, ms.
    pub(crate) ms: f64,
}

/// The table, or what was made of it.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(crate) struct ArrangementTable {
    /// The rows, scene by scene.
    pub(crate) rows: Vec<ArrangementRow>,
    /// Why an arrangement of a scene has none.
    pub(crate) missing: Vec<String>,
    /// Whether it was ended early.
    pub(crate) part: bool,
}

/// Makes the table: quick runs on one thread, so that times can be compared.
///
/// # Errors
/// What is wrong with the wires of the reference mesh.
pub(crate) fn table(listener: Listener) -> Result<ArrangementTable, Vec<Problem>> {
    let mut scenes = vec![("reference".to_string(), REFERENCE)];
    scenes.extend(published().tests.iter().map(|t| (format!("test {}", t.test), t.layout())));
    scenes.extend(grids());
    let wire = crate::study::result::make::wires(&catalogue::reference())?.clone();
    let mut table = ArrangementTable::default();
    for (scene, layout) in scenes {
        for blocks in [Blocks::Repeated, Blocks::Mirrored, Blocks::Single] {
            let layout = Layout { blocks, ..layout };
            if blocks == Blocks::Mirrored && layout.grid.stagger {
                table.missing.push(format!("{scene}, mirrored: no anchor line to face across"));
                continue;
            }
            if blocks == Blocks::Mirrored && layout.folded() == (0.0, 0.0) {
                table.missing.push(format!("{scene}, mirrored: centred, as repeated"));
                continue;
            }
            (listener.tell)(&format!("{scene}, {blocks:?}"));
            let spec = SceneSpec::plain(layout, Test::Anchored, wire.clone());
            let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
            let plan = Plan { runs: Some(RUNS), ..Plan::default() };
            let stood = blocks::run(&spec, &controls, &plan, &|_| Flow::Continue, &|_, _| {})?;
            table.rows.extend(stood.iter().map(|stood| row(&scene, stood)));
            if (listener.ask)() == Flow::Cancel {
                table.part = true;
                return Ok(table);
            }
        }
    }
    Ok(table)
}

/// A rectangular grid and its staggered twin, each with a centred block and with one off the centre.
fn grids() -> Vec<(String, Layout)> {
    let at = |stagger: bool, ex: f64, ey: f64| {
        let grid = Grid { up: Some(3.5), stagger, ..Grid::SQUARE };
        Layout { spacing: 2.5, grid, ex, ey, ..REFERENCE }
    };
    let words = |stagger: bool, place: &str| {
        format!("2.5x3.5{}{place}", if stagger { " stag" } else { "" })
    };
    [false, true]
        .into_iter()
        .flat_map(|s| [(words(s, ""), at(s, 0.0, 0.0)), (words(s, " off"), at(s, OFF[0], OFF[1]))])
        .collect()
}

/// Offset of the blocks that are off the centre, m.
const OFF: [f64; 2] = [0.3, 0.6];

fn row(scene: &str, stood: &blocks::Stood) -> ArrangementRow {
    let e = &stood.ensemble;
    let runs: Vec<&Run> = e.runs.iter().filter(|run| counts(run)).collect();
    let n = runs.len().max(1) as f64;
    let mean = |of: &dyn Fn(&Run) -> f64| runs.iter().map(|run| of(run)).sum::<f64>() / n;
    let worst = worst_anchor(e);
    ArrangementRow {
        scene: scene.to_string(),
        blocks: stood.words(),
        force_kn: [e.force.mean, e.force.error].map(to_kn),
        delta_m: [e.deflection.mean, e.deflection.error],
        anchor: worst.map(|a| [a.normal, a.in_plane].map(|f| f / e.force.mean)),
        carrying: runs.iter().map(|run| run.outcome.anchors_carrying(0.9)).max().unwrap_or(0),
        ns: mean(&|run| {
            let cost = &run.outcome.cost;
            1.0e9 * run.processor / (cost.steps_to_break * cost.nodes).max(1) as f64
        }),
        ms: mean(&|run| 1.0e3 * run.processor),
    }
}
