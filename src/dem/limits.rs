//! What is too large to be run, told before anything of its size is allocated.

use super::lattice::Lattice;
use crate::problem::Problem;
use crate::units::{shortest, significant};

/// Most nodes of a net: some hundred times those of the reference panel, and enough for a single block in
/// a field of 7 x 7 cells of 4.5 m with openings of 80 mm.
pub(crate) const MOST_NODES: f64 = 300_000.0;

/// Steps of one node in a second on one core, about: measured with AVX2 on a net that fits into the
/// caches (`meshcast check --format json`: nodes times steps over wall_ms). Only to tell people what to
/// expect; nothing that is computed depends on it.
const NODE_STEPS_A_SECOND: f64 = 4.0e8;
/// Longest run that is begun, s, by that rate. The reference fidelity of a 3 m panel takes about a second.
const LONGEST: f64 = 600.0;
/// Steps of a run of standard fidelity, about, for a panel of usual size.
const USUAL_STEPS: f64 = 9.0e3;

/// What is wrong with a net of too many nodes.
pub(super) fn of_net(lattice: &Lattice, spacing: f64) -> Option<Problem> {
    // Products of counts that may be as large as a file says them.
    let nodes = 2.0 * lattice.columns as f64 * lattice.rows as f64;
    (nodes > MOST_NODES).then(|| {
        Problem::new("L", format!("a net of {nodes:.0} nodes is too large to simulate"))
            .value(format!("{} m", shortest(spacing)))
            .allowed(format!(
                "up to {MOST_NODES:.0} nodes; a run of this net would take about {}",
                time(nodes * USUAL_STEPS)
            ))
            .advice("take a smaller spacing, or check the opening of the mesh")
    })
}

/// What is wrong with a run of so many steps, at most; `slow` is the field that makes it slow, with its
/// value, m.
pub(super) fn of_run(lattice: &Lattice, steps: f64, slow: (&str, f64)) -> Option<Problem> {
    let work = 2.0 * lattice.pairs() as f64 * steps;
    (work > LONGEST * NODE_STEPS_A_SECOND).then(|| {
        Problem::new(slow.0, format!("a run would take about {}", time(work)))
            .value(format!("{} m", shortest(slow.1)))
            .allowed(format!("what ends within about {}", time(LONGEST * NODE_STEPS_A_SECOND)))
            .advice("take a larger block, a smaller displacement limit or a coarser fidelity")
    })
}

/// How long so many steps of single nodes take.
fn time(node_steps: f64) -> String {
    let seconds = node_steps / NODE_STEPS_A_SECOND;
    match seconds {
        s if s < 120.0 => format!("{} s", significant(s, 2)),
        s if s < 7200.0 => format!("{} min", significant(s / 60.0, 2)),
        s => format!("{} h", significant(s / 3600.0, 2)),
    }
}
