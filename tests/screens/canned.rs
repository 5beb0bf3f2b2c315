//! Checks that no solver made: the screens are fed with these, so that a change of the solver moves no
//! picture. The results are invented, see `canned.ron`, and scaled by hand to a layout's sizes; whether a
//! layout can be checked at all, and what its inputs' fingerprint is, the program itself says.

use meshcast::dem::{Arrangement, PLAIN_PHASE, Scene, SceneSpec, Test};
use meshcast::job::news::What;
use meshcast::job::order::Task;
use meshcast::job::{News, Order};
use meshcast::layout::Layout;
use meshcast::mesh::MeshType;
use meshcast::problem::Problem;
use meshcast::project;
use meshcast::study::checks::NoCheck;
use meshcast::study::result::make::{Made, fingerprint, wires};
use meshcast::study::result::relief::{CELLS, Relief};
use meshcast::study::result::{CheckResult, Revisions, Wanted};
use std::sync::Arc;

/// Runs of a check where nobody says how many.
const RUNS: usize = 8;

/// The invented result of this name, of the layout it stands with: a plate of 0.25 m, a spacing of
/// 1.3 m, a punch of 0.4 m in the middle.
fn invented(name: &str) -> CheckResult {
    let canned = project::parse(include_str!("canned.ron"), "canned.ron").unwrap().project;
    let layout = canned.find_layout(name).unwrap();
    (**layout.check.as_ref().unwrap()).clone()
}

/// The invented result of this name as if it had been made of a layout.
pub(crate) fn named(name: &str, layout: &Layout, mesh: &MeshType, wanted: &Wanted) -> CheckResult {
    let mut result = invented(name);
    result.inputs = fingerprint(layout, wires(mesh).unwrap(), wanted);
    result.by = Revisions::CURRENT;
    result.wanted = wanted.clone();
    scale(&mut result, layout);
    result
}

/// A check that went well, with so many of its runs.
fn whole(layout: &Layout, mesh: &MeshType, wanted: &Wanted, runs: usize) -> CheckResult {
    let mut result = named("whole", layout, mesh, wanted);
    result.runs = runs;
    result.breaks.truncate(runs);
    for spread in [&mut result.force, &mut result.deflection] {
        if runs == 1 {
            (spread.deviation, spread.band) = (0.0, [spread.mean; 2]);
        }
        spread.error = spread.deviation / (runs as f64).sqrt();
    }
    if runs == 1 {
        result.band = [Vec::new(), Vec::new()];
    }
    result
}

/// Makes a result that of other sizes: wider plates and punches hold more, wider panels less and give
/// way further. Products of a few numbers only, so that every machine has the same.
fn scale(result: &mut CheckResult, layout: &Layout) {
    let aside = layout.ex.abs() + layout.ey.abs();
    let wide = layout.spacing / 1.3;
    let force =
        (0.7 + 1.2 * layout.plate) * (0.5 + 1.25 * layout.punch) / wide * (1.0 - 0.1 * aside);
    let delta = wide * (1.0 - 0.2 * aside);
    for (spread, by) in [(&mut result.force, force), (&mut result.deflection, delta)] {
        for value in [&mut spread.mean, &mut spread.deviation, &mut spread.error] {
            *value *= by;
        }
        spread.band = spread.band.map(|v| v * by);
    }
    let ends = result.breaks.iter_mut().map(|b| &mut b.at);
    for point in ends.chain([&mut result.peak]).chain(&mut result.curve.failure) {
        point.force *= force;
        point.deflection *= delta;
    }
    for b in &mut result.breaks {
        b.place = b.place.map(|v| v * wide);
    }
    let [low, high] = &mut result.band;
    low.iter_mut().chain(high).chain(&mut result.curve.force).for_each(|v| *v *= force);
    result.curve.deflection.iter_mut().for_each(|v| *v *= delta);
    result.k75 *= force / delta;
    result.energy *= force * delta;
}

/// A net pushed out where the punch is, and held at its edges.
fn relief(layout: &Layout, result: &CheckResult) -> Relief {
    let (side, deflection) = (layout.spacing, result.deflection.mean);
    let middle = |k: usize| ((k as f64 + 0.5) / CELLS as f64 - 0.5) * side;
    let fall = |v: f64, e: f64| (1.0 - 4.0 * ((v - e) / side).powi(2)).max(0.0);
    let heights: Vec<f64> = (0..CELLS * CELLS)
        .map(|k| {
            let (x, y) = (middle(k % CELLS), middle(k / CELLS));
            deflection * fall(x, layout.ex) * fall(y, layout.ey)
        })
        .collect();
    let highest = heights.iter().copied().fold(0.0, f64::max);
    Relief { sides: [side; 2], heights, highest, deflection }
}

/// A check of a layout, or why there can be none.
fn check(
    layout: &Layout,
    mesh: &MeshType,
    wanted: &Wanted,
    runs: usize,
) -> Result<Made, Vec<Problem>> {
    let wire = wires(mesh)?.clone();
    let (test, phase, seed) = (Test::Anchored, PLAIN_PHASE, wanted.seed);
    Scene::new(&SceneSpec {
        layout: *layout,
        test,
        wire,
        phase,
        seed,
        arrangement: Arrangement::default(),
    })?;
    let result = whole(layout, mesh, wanted, runs);
    let relief = Some(relief(layout, &result));
    Ok(Made { result, relief })
}

/// The news of an order, as a worker would tell them.
pub(crate) fn news(order: &Order) -> Vec<News> {
    let mut told = Vec::new();
    match &order.task {
        Task::Checks(checks) => {
            let all = checks.wanted.runs.unwrap_or(RUNS);
            for target in &checks.targets {
                let uid = target.uid;
                let made = |runs, more| {
                    let made = check(&target.case.layout, &target.case.mesh, &checks.wanted, runs);
                    match made {
                        Ok(made) => {
                            What::Made { uid, made: Arc::new(made), more, live: checks.live }
                        }
                        Err(problems) => What::Refused { uid, problems },
                    }
                };
                // A live check tells its first run as soon as it is there.
                if checks.live {
                    told.push(made(1, true));
                }
                told.push(made(all, false));
            }
        }
        Task::Method(job) => panic!("not canned: {job:?}"),
        Task::Adopt(job) => panic!("not canned: {job:?}"),
        Task::Campaign(campaign) => {
            let total = campaign.cases.len();
            for (index, case) in campaign.cases.iter().enumerate() {
                let all = campaign.wanted.runs.unwrap_or(RUNS);
                let made = check(&case.layout, &case.mesh, &campaign.wanted, all);
                let answer = made.map(|made| made.result).map_err(NoCheck::Impossible);
                told.push(What::Case { index, total, answer: Arc::new(answer) });
            }
        }
    }
    told.push(What::Ended { cancelled: false });
    told.into_iter().map(|what| News { number: order.number, what }).collect()
}
