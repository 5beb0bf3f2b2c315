//! Ties the solver's revision to exact results: a change of what a run gives cannot forget to raise it.
//!
//! `revisions.txt` holds the revision and the bits of some small runs. `MESHCAST_REVISION=write` writes
//! it anew, and only under a revision that it does not hold yet.

use meshcast::dem::{
    Arrangement, Controls, Fidelity, Flow, PLAIN_PHASE, REVISION, RunOutcome, SceneSpec, Test,
    check,
};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::laws;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn scene(test: Test, ex: f64, ey: f64) -> SceneSpec {
    let layout = Layout { plate: 0.25, spacing: 1.2, punch: 0.5, ex, ey, ..REFERENCE };
    SceneSpec {
        layout,
        test,
        wire: laws::reference(),
        phase: PLAIN_PHASE,
        seed: 7,
        arrangement: Arrangement::default(),
    }
}

/// What a run gives, as the bits of its figures and a hash (FNV-1a) of its curve.
fn bits(outcome: &RunOutcome) -> String {
    let first = outcome.first_break.unwrap_or_default();
    let figures = [
        first.force,
        first.deflection,
        outcome.peak.force,
        outcome.energy,
        outcome.k75,
        outcome.quality.error_estimate,
        outcome.quality.energy_balance,
    ];
    let mut text = String::new();
    for figure in figures {
        let _ = write!(text, " {:016x}", figure.to_bits());
    }
    let curve = outcome.curve.deflection.iter().chain(&outcome.curve.force);
    let hash = curve
        .chain(&outcome.punch)
        .chain(&outcome.support)
        .fold(0xcbf2_9ce4_8422_2325_u64, |h, v| {
            (h ^ v.to_bits()).wrapping_mul(0x0000_0100_0000_01b3)
        });
    let _ = write!(text, " {hash:016x} {} {}", outcome.breaks.len(), outcome.cost.steps);
    text
}

/// The runs and their bits, under the revision.
fn now() -> String {
    let mut text = format!("revision {REVISION}\n");
    let mut add = |name: &str, spec: &SceneSpec, controls: &Controls| {
        let outcome = check(spec, controls, &mut |_| Flow::Continue).unwrap();
        let _ = writeln!(text, "{name}{}", bits(&outcome));
    };
    for (fidelity, word) in [(Fidelity::Quick, "quick"), (Fidelity::Standard, "standard")] {
        let controls = Controls { fidelity, ..Controls::default() };
        add(&format!("centred-{word}"), &scene(Test::Anchored, 0.0, 0.0), &controls);
        add(&format!("eccentric-{word}"), &scene(Test::Anchored, 0.2, -0.1), &controls);
        add(&format!("laboratory-{word}"), &scene(Test::Laboratory, 0.0, 0.0), &controls);
    }
    // The first decimetre of the full law in double precision, and of a fine run.
    for (fidelity, word) in [(Fidelity::Fine, "fine"), (Fidelity::Reference, "reference")] {
        let controls = Controls { fidelity, limit: Some(0.1), ..Controls::default() };
        add(&format!("begun-{word}"), &scene(Test::Anchored, 0.2, -0.1), &controls);
    }
    text
}

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/physics/revisions.txt")
}

#[test]
fn what_a_run_gives_is_that_of_the_revision() {
    let (held, now) = (std::fs::read_to_string(file()).unwrap_or_default(), now());
    if held == now {
        return;
    }
    let same_revision = held.lines().next() == now.lines().next();
    if std::env::var_os("MESHCAST_REVISION").is_some_and(|v| v == "write") && !same_revision {
        std::fs::write(file(), now).unwrap();
        return;
    }
    let what_to_do = if same_revision {
        "The solver gives other numbers than under this revision. If that is meant, raise \
         `dem::REVISION` (kept checks then are stale, as they must be)"
    } else {
        "`dem::REVISION` is another than that of the bits held"
    };
    panic!(
        "{what_to_do} and write its bits:\n  MESHCAST_REVISION=write cargo test --test physics \
         revision\nheld:\n{held}\nnow:\n{now}"
    );
}
