//! Which inputs an ensemble was made from.

use super::ensemble::Plan;
use super::exactness::Exactness;
use crate::dem::{Controls, SceneSpec, Test};
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::layout::{Blocks, PunchShape, Twists};
use crate::mesh::wire::{CurvePoint, Slack};
use crate::words::Choice;

/// Fingerprint of all that decides an ensemble's numbers: scene, controls and plan. The number of
/// threads and the instruction set decide nothing; where wires come from does neither. Files of users
/// hold such prints: what is here stays, and a new input is added at the end by its name
/// ([`Fingerprinter::with`]).
pub(crate) fn of_ensemble(spec: &SceneSpec, controls: &Controls, plan: &Plan) -> Fingerprint {
    let (layout, net, d) = (&spec.layout, &spec.wire.net, &spec.wire.distortion);
    let (anchored, grid) = (spec.test == Test::Anchored, &layout.grid);
    let mut print = Fingerprinter::new("check")
        .flag(anchored)
        // There are no plates in the laboratory.
        .optional(anchored.then_some(layout.plate))
        .number(layout.spacing)
        .number(layout.punch)
        .number(layout.ex)
        .number(layout.ey)
        .number(net.opening)
        .number(net.twist)
        .number(net.projection)
        .number(net.diameter)
        .number(net.node_mass)
        .number(net.node_radius)
        .number(d.lambda_u)
        .number(d.lambda_f)
        .optional(match d.slack {
            Slack::Fixed(t) => Some(t),
            Slack::Triangular => None,
        });
    for curve in [&spec.wire.single, &spec.wire.double_twist] {
        print = print.number(curve.len() as f64);
        for CurvePoint(strain, stress) in curve {
            print = print.number(*strain).number(*stress);
        }
    }
    print
        .text(if plan.auto { Exactness::Auto.word() } else { controls.fidelity.word() })
        .number(controls.step_factor)
        .optional(controls.speed)
        .optional(controls.damping)
        .number(controls.after_break)
        .optional(controls.limit)
        .optional(plan.runs.map(|n| n as f64))
        .text(&plan.seed.to_string())
        .optional(plan.phase.map(|p| p[0]))
        .optional(plan.phase.map(|p| p[1]))
        .given("Ly", grid.up.filter(|up| anchored && *up != layout.spacing))
        .with("stagger", anchored && grid.stagger, false)
        .with("twists", grid.twists.word(), Twists::Down.word())
        .with("shape", layout.shape.word(), PunchShape::Dome.word())
        .with("blocks", if anchored { blocks_word(layout.blocks) } else { REPEATED }, REPEATED)
        .given("field", (anchored && layout.blocks == Blocks::Single).then_some(SINGLE))
        .given("to_aim", controls.to_aim.then_some(true))
        .given("members", plan.auto.then_some(AUTO))
        .finish()
}

/// How a single block is found and its field stepped. Raise it with what changes the numbers of single blocks
/// alone: their kept checks are stale then, and no others.
const SINGLE: u32 = 2;

/// How members are made where the ensemble chooses, see [`super::paired`]. Raise it with what changes these alone.
const AUTO: u32 = 5;

/// What blocks are taken for where nothing else is said.
const REPEATED: &str = "repeated";

/// The word for blocks: the paper's are checked as repeated ones.
fn blocks_word(blocks: Blocks) -> &'static str {
    if blocks == Blocks::Paper { REPEATED } else { blocks.word() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::{Arrangement, PLAIN_PHASE};
    use crate::layout::{Layout, REFERENCE};
    use crate::mesh::laws;

    #[test]
    fn every_input_counts_and_threads_do_not() {
        let spec = SceneSpec {
            layout: REFERENCE,
            test: Test::Anchored,
            wire: laws::bench(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        let (controls, plan) = (Controls::default(), Plan::default());
        let base = of_ensemble(&spec, &controls, &plan);
        assert_eq!(base, of_ensemble(&spec, &controls, &Plan { threads: 7, ..plan.clone() }));
        let mut wires = spec.clone();
        wires.wire.double_twist[3].1 += 1.0;
        let shallow = SceneSpec {
            layout: Layout { plate: 0.3, ..REFERENCE },
            test: Test::Laboratory,
            ..spec.clone()
        };
        let lab = SceneSpec { test: Test::Laboratory, ..spec.clone() };
        let stood = |blocks| {
            let layout = Layout { blocks, ..REFERENCE };
            of_ensemble(&SceneSpec { layout, ..spec.clone() }, &controls, &plan)
        };
        let with = |change: &dyn Fn(&mut Layout)| {
            let mut spec = spec.clone();
            change(&mut spec.layout);
            of_ensemble(&spec, &controls, &plan)
        };
        let square = with(&|layout| layout.grid.up = Some(layout.spacing));
        assert_eq!(square, base, "two equal spacings are one");
        assert_eq!(stood(Blocks::Repeated), base, "the paper's are the repeated ones");
        let all = [
            base,
            of_ensemble(&wires, &controls, &plan),
            of_ensemble(&lab, &controls, &plan),
            of_ensemble(&spec, &Controls { speed: Some(1e-4), ..controls.clone() }, &plan),
            of_ensemble(&spec, &controls, &Plan { seed: 1, ..plan.clone() }),
            of_ensemble(&spec, &controls, &Plan { phase: Some([0.0; 2]), ..plan.clone() }),
            of_ensemble(&spec, &controls, &Plan { runs: Some(8), ..plan.clone() }),
            stood(Blocks::Mirrored),
            stood(Blocks::Worst),
            with(&|layout| layout.grid.up = Some(2.9)),
            with(&|layout| layout.grid.stagger = true),
            with(&|layout| layout.grid.twists = Twists::Across),
            with(&|layout| layout.shape = PunchShape::Flat),
            with(&|layout| layout.shape = PunchShape::Sphere),
        ];
        let different: std::collections::BTreeSet<u64> = all.iter().map(|f| f.0).collect();
        assert_eq!(different.len(), all.len());
        assert_eq!(
            of_ensemble(&lab, &controls, &plan),
            of_ensemble(&shallow, &controls, &plan),
            "plates do not count in the laboratory"
        );
    }
}
