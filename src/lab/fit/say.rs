//! What is told of the laws that fit, and how many simulations a search has made.

use super::data::MeshData;
use super::posterior::{EnsembleLaw, Identified, START_WORDS};
use super::rows::{FitScene, Measure};
use crate::lab::calibrate::unlike_steel;
use crate::mesh::wire::WireData;
use crate::study::ensemble::EnsembleProgress;
use crate::units::{significant, to_kn};

/// Counts the simulations of scenes by their progress: each has a first run, whose punch starts anew. The
/// others may speak at the same time and from other threads.
#[derive(Debug, Default)]
pub(crate) struct Trials {
    words: String,
    travel: f64,
    trials: usize,
}

impl Trials {
    /// So many were made before.
    pub(crate) fn after(trials: usize) -> Trials {
        Trials { trials, ..Trials::default() }
    }

    /// The number of the simulation that tells this, from 1.
    pub(crate) fn at(&mut self, scene: &FitScene, now: EnsembleProgress) -> usize {
        if now.run == 0 {
            if self.words != scene.words || now.inner.deflection < self.travel {
                self.words.clone_from(&scene.words);
                self.trials += 1;
            }
            self.travel = now.inner.deflection;
        }
        self.trials.max(1)
    }
}

/// A law as wires, and which of them it is.
pub(crate) fn wire(found: &Identified, law: &EnsembleLaw, which: &str) -> WireData {
    let rows: Vec<&str> = found.question.rows.iter().map(|r| r.label.as_str()).collect();
    let source = format!(
        "Made by meshcast from a mesh's own tests: {which} of {} laws, in the valley of the {}; fitted to {}; the prior is steel wire by EN 10223-3, 350 to 550 MPa, and 8 to 35 %",
        found.laws.len(),
        START_WORDS[law.start],
        rows.join(", ")
    );
    law.law.wire(found.question.net, source)
}

/// What a reader must know: steel that is none, and what cannot be reached.
pub(crate) fn remarks(data: &MeshData, found: &Identified) -> Vec<String> {
    let mut said: Vec<String> =
        unlike_steel(&wire(found, &found.laws[0], "")).into_iter().collect();
    let rows = found.question.rows.iter().zip(&found.values);
    let off: Vec<String> = rows
        .filter(|(row, value)| row.residual(**value).abs() > 3.0)
        .map(|(row, value)| {
            format!(
                "{}: nearest {}, wanted {}",
                row.label,
                shown(row.measure, *value),
                shown(row.measure, row.target)
            )
        })
        .collect();
    if !off.is_empty() {
        said.push(format!(
                "no law of the family reaches all of the data; the nearest is given ({}); see whether force, deflection, panel and units are those of one mesh, or start --from another net",
                off.join("; ")
            ));
    }
    let weight = |start| -> f64 {
        let laws = found.laws.iter().filter(|law| law.start == start);
        laws.map(|law| law.weight).sum()
    };
    if data.first.is_none() && weight(0) > 0.05 && weight(1) > 0.05 {
        said.push("the data do not tell whether the twist or the wire is the weaker one; which bond broke first in the test would (--breaks)".into());
    }
    said
}

/// A row's value as people read it.
pub(crate) fn shown(measure: Measure, value: f64) -> String {
    match measure {
        Measure::Force | Measure::ForceAt(_) | Measure::Stiffness | Measure::Strength => {
            significant(to_kn(value), 4)
        }
        _ => significant(value, 4),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dem::RunProgress;
    use crate::dem::tensile::Pull;
    use crate::lab::fit::rows::SceneKind;

    #[test]
    fn runs_that_speak_in_turn_are_one_simulation() {
        let scene = |words: &str| FitScene {
            words: words.into(),
            kind: SceneKind::Tensile(1.0, 1.0, Pull::Along),
            runs: 2,
        };
        let (one, other) = (scene("punch test 1"), scene("pull along"));
        let mut trials = Trials::default();
        let mut said = |scene: &FitScene, run: usize, deflection: f64| {
            let inner = RunProgress {
                deflection,
                force: 0.0,
                utilisation: 0.0,
                limit: 1.0,
                steps: 0,
                broken: false,
            };
            trials.at(scene, EnsembleProgress { done: run, planned: 2, run, inner })
        };
        let first =
            [said(&one, 0, 0.1), said(&one, 1, 0.1), said(&one, 0, 0.2), said(&one, 1, 0.3)];
        assert_eq!(first, [1; 4]);
        // The punch of the next law starts anew; another scene is another simulation.
        assert_eq!([said(&one, 0, 0.1), said(&one, 1, 0.1)], [2, 2]);
        assert_eq!([said(&other, 0, 0.2), said(&one, 0, 0.3)], [3, 4]);
    }
}
