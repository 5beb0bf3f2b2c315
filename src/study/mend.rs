//! What would mend a failed verdict: one input and its value, found by [`super::solve`] on the forecast.
//!
//! Only what cannot raise the load is advised: a larger plate, or anchors nearer together, which with a
//! pressure takes load away and with a force leaves it. Anchors farther apart make the forecast's panel
//! stronger, but no engineer means that as a cure.

use super::solve::{Requirement, Solution, solve};
use super::verdict::{Aspect, Basis, Finding, Simulated, Verdict, verdict};
use crate::case::{Case, Input};

/// An input and the value that would mend what fails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mend {
    /// What to change.
    pub input: Input,
    /// To what, SI.
    pub value: f64,
}

impl Mend {
    /// As a phrase: `spacing L 1.87 m`.
    pub fn text(&self) -> String {
        let row = self.input.row();
        format!("{} {} {}", row.label, row.symbol, self.input.text(self.value))
    }
}

/// What would make all that fails pass, by the forecast and within the published ranges; nothing where
/// nothing fails, and where no single input does it.
pub fn mend(case: &Case, verdict: &Verdict) -> Option<Mend> {
    if verdict.finding() != Finding::Fails {
        return None;
    }
    let fails =
        |aspect: Aspect| verdict.checks.iter().any(|c| c.aspect == aspect && c.state.fails());
    let candidates = [
        plate_or_spacing(case, Input::Plate, verdict.basis, &fails),
        plate_or_spacing(case, Input::Spacing, verdict.basis, &fails),
        stronger_anchor(case, verdict, &fails),
    ];
    candidates.into_iter().flatten().find(|m| passes(case, *m, verdict.basis))
}

/// Whether nothing fails with it, by the forecast.
fn passes(case: &Case, mend: Mend, basis: Basis) -> bool {
    let case = case.with(mend.input, mend.value);
    let found = verdict(&case, &case.derive(), Simulated::Missing, basis).finding();
    matches!(found, Finding::Passes | Finding::Doubtful)
}

/// The nearest larger plate or smaller spacing that meets all that fails of the panel.
fn plate_or_spacing(
    case: &Case,
    input: Input,
    basis: Basis,
    fails: &impl Fn(Aspect) -> bool,
) -> Option<Mend> {
    let now = input.value(case);
    let mut value = now;
    for (aspect, requirement) in
        [(Aspect::Strength, Requirement::Force), (Aspect::Deflection, Requirement::Deflection)]
    {
        if fails(aspect) {
            let found = nearest(&solve(case, input, requirement, basis)?, now)?;
            value = if input == Input::Plate { value.max(found) } else { value.min(found) };
        }
    }
    if fails(Aspect::Anchor) {
        if input == Input::Plate {
            return None;
        }
        // q L^2 gamma = R, rounded to the millimetre that takes less load.
        let question = &case.question;
        let area = question.anchor_resistance? / (question.pressure? * question.gamma_load);
        value = value.min((area.sqrt() * 1000.0).floor() / 1000.0);
    }
    (value != now).then_some(Mend { input, value })
}

/// The nearest value above (plate) or below (spacing) from which on the requirement is met.
fn nearest(solution: &Solution, now: f64) -> Option<f64> {
    let up = solution.input == Input::Plate;
    let ends = solution.crossings.iter().filter(|c| c.met_above == up);
    let beyond = ends.filter(|c| if up { c.value > now } else { c.value < now });
    let values = beyond.map(|c| c.rounded.unwrap_or(c.value));
    if up { values.reduce(f64::min) } else { values.reduce(f64::max) }
}

/// The anchor that takes the load, where the anchor alone fails.
fn stronger_anchor(
    case: &Case,
    verdict: &Verdict,
    fails: &impl Fn(Aspect) -> bool,
) -> Option<Mend> {
    if fails(Aspect::Strength) || fails(Aspect::Deflection) || case.question.pressure.is_some() {
        return None;
    }
    let demand = verdict.checks.iter().find(|c| c.aspect == Aspect::Anchor)?.demand?;
    Some(Mend { input: Input::AnchorResistance, value: demand })
}
