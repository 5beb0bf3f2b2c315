//! The published scenes of YADE 2023.02a beside ours: the same scenes, the time of both, the
//! difference of the first break and of the curve. YADE's times are those that its record states, of one
//! thread of a 2.1 GHz server processor; ours are processor time here, set-up included, to the first
//! break.
//!
//! `cargo bench --bench yade`

use meshcast::dem::{
    Arrangement, Controls, Fidelity, Flow, PLAIN_PHASE, RunOutcome, SceneSpec, Test, check,
};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::laws;
use meshcast::study::clock::thread_seconds;
use meshcast::words::Choice;

/// A published run.
struct Published {
    name: &'static str,
    test: Test,
    /// Panel, m.
    spacing: f64,
    /// First break, N and m.
    first: (f64, f64),
    /// Time it took, s.
    seconds: f64,
    curve: &'static str,
}

const RUNS: [Published; 2] = [
    Published {
        name: "anchored, 0.2 m/s",
        test: Test::Anchored,
        spacing: 3.04,
        first: (30_200.0, 0.666),
        seconds: 769.0,
        curve: include_str!("../data/anchored_v02.csv"),
    },
    Published {
        name: "laboratory, 1 m/s, 72 x 30 facets",
        test: Test::Laboratory,
        spacing: 3.0,
        first: (83_500.0, 0.691),
        seconds: 231.0,
        curve: include_str!("../data/lab_v1_facets72x30.csv"),
    },
];

/// Displacement and mean force of a published curve; a row's mean is over the time since the row
/// before, so it stands half a row earlier.
fn curve(text: &str) -> Vec<(f64, f64)> {
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect())
        .collect();
    rows.windows(2).map(|w| (0.5 * (w[0][0] + w[1][0]), w[1][2])).collect()
}

/// The run and its processor time, s, the best of several.
fn timed(spec: &SceneSpec, controls: &Controls, times: usize) -> (RunOutcome, f64) {
    let once = || {
        let start = thread_seconds();
        let outcome = check(spec, controls, &mut |_| Flow::Continue).expect("the scene is sound");
        (outcome, thread_seconds() - start)
    };
    (1..times).map(|_| once()).fold(once(), |best, next| if next.1 < best.1 { next } else { best })
}

fn main() {
    println!(
        "{:<36} {:<10} {:>9} {:>9} {:>8} {:>8} {:>8}",
        "scene", "fidelity", "time s", "YADE s", "F %", "delta %", "curve %"
    );
    for run in RUNS {
        let spec = SceneSpec {
            layout: Layout { spacing: run.spacing, ..REFERENCE },
            test: run.test,
            wire: laws::yade(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        for fidelity in Fidelity::ALL {
            let controls =
                Controls { fidelity: *fidelity, after_break: 0.0, ..Controls::default() };
            let times = if *fidelity == Fidelity::Reference { 1 } else { 5 };
            let (ours, seconds) = timed(&spec, &controls, times);
            let Some(first) = ours.first_break else {
                println!("{:<36} {:<10} no wire broke", run.name, fidelity.word());
                continue;
            };
            let last = ours.curve.deflection.last().copied().unwrap_or(0.0).min(run.first.1);
            let published = curve(run.curve);
            let most = published.iter().filter(|p| p.0 < last).map(|p| p.1).fold(0.0, f64::max);
            let gap = published
                .iter()
                .filter(|p| p.0 > 0.1 && p.0 < last)
                .map(|p| (ours.curve.force_at(p.0) - p.1).abs() / most)
                .fold(0.0, f64::max);
            println!(
                "{:<36} {:<10} {:>9.3} {:>9.0} {:>+8.2} {:>+8.2} {:>8.2}",
                run.name,
                fidelity.word(),
                seconds,
                run.seconds,
                100.0 * (first.force / run.first.0 - 1.0),
                100.0 * (first.deflection / run.first.1 - 1.0),
                100.0 * gap
            );
        }
    }
}
