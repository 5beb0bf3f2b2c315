//! What a check has to say about itself.

use super::Checked;
use crate::dem::{Stop, Test};
use crate::forecast::warning::Weight;
use crate::study::ensemble::TARGET;
use crate::units::{significant, to_kn};

/// A remark on a check.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CheckRemark {
    /// Stable identifier for programs.
    pub(super) code: &'static str,
    /// How much it weighs.
    pub(super) weight: &'static str,
    /// The sentence.
    pub(super) message: String,
}

/// Stretch of the net beyond which it is said.
const MUCH_STRETCH: f64 = 0.02;

/// The remarks on a check, the heaviest first.
pub(crate) fn of(c: &Checked) -> Vec<CheckRemark> {
    let mut list = Vec::new();
    let mut say = |code, weight: Weight, message: String| {
        list.push((weight, CheckRemark { code, weight: weight.word(), message }));
    };
    let e = &c.ensemble;
    let stopped = |stop: Stop| e.runs.iter().filter(|r| r.outcome.stop == stop).count();
    if let Some(probe) = e.probe.filter(|p| p.bifurcation()) {
        let kn = |v: f64| significant(to_kn(v), 3);
        say(
            "bifurcation",
            Weight::Caution,
            format!(
                "bifurcation: the block can stay on a wire or slip off it; 5 mm and 3 mm beside the given place the first break is at {} kN instead of {} kN. A single run means nothing here, only the ensemble counts",
                kn(probe.beside),
                kn(probe.here)
            ),
        );
    }
    if stopped(Stop::Diverged) > 0 {
        let text = format!("{} runs diverged and are not counted", stopped(Stop::Diverged));
        say("diverged", Weight::Caution, text);
    }
    if e.warnings.iter().any(|w| w == "cancelled") {
        let text = format!("ended early by the user: {} of its runs are whole", c.counted());
        say("cancelled", Weight::Caution, text);
    }
    if e.slipped > 0 {
        let text = format!(
            "{} of {} runs slipped through without a break; they are in the band by their peak and not in the mean",
            e.slipped,
            e.runs.len()
        );
        say("slipped", Weight::Caution, text);
    }
    if stopped(Stop::DisplacementLimit) > 0 {
        let text = format!(
            "{} runs came to the displacement limit; --limit sets it",
            stopped(Stop::DisplacementLimit)
        );
        say("displacement_limit", Weight::Caution, text);
    }
    scatter(c, &mut say);
    if c.forecast.values.is_none() {
        let why = match c.spec.test {
            Test::Laboratory => "Eqs. 1-2 hold for a centred punch of 1.0 m only",
            Test::Anchored => "the method has none for this layout",
        };
        say("no_forecast", Weight::Note, format!("no forecast to compare with: {why}"));
    }
    let [x, y] = c.stretch.map(|s| 100.0 * (s - 1.0));
    if x.abs().max(y.abs()) > 100.0 * MUCH_STRETCH {
        let text = format!(
            "the net was stretched by {x:+.1} % in x and {y:+.1} % in y to a whole number of openings"
        );
        say("stretch", Weight::Caution, text);
    }
    say("wire_law", Weight::Note, format!("wire law: {}", c.spec.wire.source));
    list.sort_by_key(|(weight, _)| std::cmp::Reverse(*weight));
    list.into_iter().map(|(_, warning)| warning).collect()
}

/// What the scatter of the runs and their own errors leave open.
fn scatter(c: &Checked, say: &mut impl FnMut(&'static str, Weight, String)) {
    let e = &c.ensemble;
    let relative = e.force.error / e.force.mean.max(f64::MIN_POSITIVE);
    if e.runs.len() == 1 || c.plan.phase.is_some() {
        let text = "one alignment of the net with anchors and punch alone can be 25 % off; leave --runs and --phase out for a mean and its band";
        say("one_alignment", Weight::Note, text.into());
    } else if c.broken() > 1 && relative > TARGET {
        let text = format!(
            "the mean force is known to {:.1} % only (standard error); more --runs make it better",
            100.0 * relative
        );
        say("standard_error", Weight::Caution, text);
    }
    let worst = e.runs.iter().map(|r| r.outcome.quality.error_estimate).fold(0.0, f64::max);
    if worst.is_finite() && worst > 2.0 * c.fidelity.aim() {
        let text = format!(
            "estimated error of a run up to {:.1} %, where {} aims at {:.1} %; a higher --fidelity or a lower --speed makes it smaller",
            100.0 * worst,
            c.fidelity.word(),
            100.0 * c.fidelity.aim()
        );
        say("error_estimate", Weight::Caution, text);
    }
}
