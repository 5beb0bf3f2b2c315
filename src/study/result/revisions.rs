//! Which solver and which sampling made a result.

use crate::dem;
use crate::study::ensemble;
use std::fmt;

/// Revisions of the two things that decide a check's numbers beside its inputs. A kept result carries
/// them and is stale where one of them is another than this program's. Nothing else of the program
/// counts: neither its version nor its commit says whether a number would come out otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Revisions {
    /// [`dem::REVISION`]: what one run gives.
    pub solver: u32,
    /// [`ensemble::REVISION`]: which runs are made and what is made of them.
    pub sampling: u32,
}

impl Revisions {
    /// This program's.
    pub const CURRENT: Revisions =
        Revisions { solver: dem::REVISION, sampling: ensemble::REVISION };
    /// Those of a record that does not say any that this program can read: never current.
    const UNKNOWN: Revisions = Revisions { solver: 0, sampling: 0 };

    /// Reads what [`Revisions`] display as. Before there were revisions a record named the program's
    /// version, which was 0.1.0 all the time, and that program had the first of both.
    pub(crate) fn from_text(text: &str) -> Revisions {
        if text == "0.1.0" {
            return Revisions { solver: 1, sampling: 1 };
        }
        let (solver, sampling) = text.split_once(", ").unwrap_or_default();
        let number = |part: &str, name| part.strip_prefix(name)?.parse().ok();
        match (number(solver, "solver "), number(sampling, "sampling ")) {
            (Some(solver), Some(sampling)) => Revisions { solver, sampling },
            _ => Revisions::UNKNOWN,
        }
    }
}

impl fmt::Display for Revisions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "solver {}, sampling {}", self.solver, self.sampling)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Curve, Point};
    use crate::dem::{Arrangement, PLAIN_PHASE, RunOutcome, Scene, SceneSpec, Stop, Test};
    use crate::fingerprint::{Fingerprint, Fingerprinter};
    use crate::layout::REFERENCE;
    use crate::mesh::laws;
    use crate::study::ensemble::{Plan, Run};
    use crate::study::result::{CheckResult, Wanted};
    use crate::study::sampling::{Member, Sample};

    #[test]
    fn what_is_written_is_read_and_what_cannot_be_read_is_never_current() {
        let some = Revisions { solver: 3, sampling: 12 };
        assert_eq!(some.to_string(), "solver 3, sampling 12");
        assert_eq!(Revisions::from_text("solver 3, sampling 12"), some);
        assert_eq!(Revisions::from_text("0.1.0"), Revisions { solver: 1, sampling: 1 });
        for text in
            ["", "0.0.1", "solver 1", "solver 1, sampling x", "solver 1, sampling 1, more 1"]
        {
            assert_eq!(Revisions::from_text(text), Revisions::UNKNOWN, "{text}");
        }
        assert_ne!(Revisions::CURRENT, Revisions::UNKNOWN);
    }

    /// Where the runs of the reference layout stand under a plan.
    fn sample(plan: &Plan) -> Sample {
        let spec = SceneSpec {
            layout: REFERENCE,
            test: Test::Anchored,
            wire: laws::reference(),
            phase: PLAIN_PHASE,
            seed: 0,
            arrangement: Arrangement::default(),
        };
        Sample::of(&Scene::new(&spec).unwrap(), plan)
    }

    /// A run of these as the solver might have made it, in round numbers.
    fn canned(sample: &Sample, k: usize) -> Run {
        let Member { seed, phase, pattern } = sample.member(k);
        let at = |part: f64| Point {
            deflection: 0.3 * part + 0.01 * k as f64,
            force: 20_000.0 * part * part + 500.0 * (k % 3) as f64,
        };
        let points: Vec<Point> = (0..30).map(|n| at(f64::from(n) / 29.0)).collect();
        let first_break = (k != 4).then(|| at(0.95));
        let curve = Curve {
            deflection: points.iter().map(|p| p.deflection).collect(),
            force: points.iter().map(|p| p.force).collect(),
            failure: first_break,
        };
        let outcome = RunOutcome {
            stop: if k == 5 { Stop::Diverged } else { Stop::AfterBreak },
            peak: at(0.98),
            energy: 3_000.0 + 7.0 * k as f64,
            k75: 1.0e5 / (k + 1) as f64,
            punch: vec![0.0; points.len()],
            support: vec![0.0; points.len()],
            ..RunOutcome::invented(curve)
        };
        Run { seed, phase, pattern, outcome, wall: 0.0, processor: 0.0 }
    }

    /// The draws of the first runs, and the figures of an ensemble of canned ones.
    fn exact() -> Vec<String> {
        let seeded = Plan { seed: 7, ..Plan::default() };
        let mut lines: Vec<String> = [(Plan::default(), 0), (Plan::default(), 1), (seeded, 2)]
            .iter()
            .map(|(plan, k)| {
                let Member { seed, phase: [x, y], pattern } = sample(plan).member(*k);
                format!("run {k}: seed {seed:016x}, phase {x:?} {y:?}, pattern {pattern:?}")
            })
            .collect();
        lines.push(format!(
            "{} to {} runs, to {:?}",
            ensemble::LEAST,
            ensemble::MOST,
            ensemble::TARGET
        ));
        for runs in [1, 7] {
            let sample = sample(&Plan { runs: Some(runs), ..Plan::default() });
            let made = (0..runs).map(|k| canned(&sample, k)).collect();
            let ensemble = ensemble::summary(made, sample);
            let r = CheckResult::from_ensemble(&ensemble, &Wanted::default(), Fingerprint(0));
            let mut print = Fingerprinter::new("sampling");
            for s in [&r.force, &r.deflection] {
                print = [s.mean, s.deviation, s.error, s.band[0], s.band[1]]
                    .into_iter()
                    .fold(print, Fingerprinter::number);
            }
            let curve =
                r.curve.deflection.iter().chain(&r.curve.force).chain(r.band.iter().flatten());
            let others = [r.peak.force, r.peak.deflection, r.k75, r.energy];
            print = curve.chain(&others).copied().fold(print, Fingerprinter::number);
            lines.push(format!("{} of {runs} runs: {}", r.runs, print.finish()));
        }
        lines
    }

    #[test]
    fn draws_and_figures_are_those_of_the_revision() {
        let held = (
            2,
            [
                "run 0: seed 46b73e79f0c37c00, phase 0.21332834766444012 0.6212039176218308, pattern Some(0)",
                "run 1: seed 5c46c78d48c94041, phase 0.5875942306863058 0.6319092602671225, pattern Some(0)",
                "run 2: seed 33522a3411c16a04, phase 0.14038699342609526 0.27703875905351427, pattern Some(1)",
                "8 to 64 runs, to 0.01",
                "1 of 1 runs: 6ac85b5911eef6a0",
                "6 of 7 runs: 6809f9d4417cfbbf",
            ],
        );
        let now = exact();
        assert!(
            held.0 == ensemble::REVISION && now == held.1,
            "Runs are drawn or summed up otherwise than under this revision. If that is meant, raise \
             `ensemble::REVISION` (kept checks then are stale, as they must be) and put it here with \
             these lines:\n{now:#?}"
        );
    }
}
