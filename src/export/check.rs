//! A discrete element check as charts and reports show it.

use super::ExportedLayout;
use super::command::{file_word, quoted};
use crate::curve::{Curve, Point};
use crate::dem::outcome::Quality;
use crate::study::result::places::Places;
use crate::study::result::sampled::{CHARACTERISTIC, sentence};
use crate::study::result::{CheckResult, Revisions};
use crate::study::verdict::Simulated;
use crate::units::Units;
use crate::units::{energy_text, force_text, length_text, significant, stiffness_text};
use crate::words::Choice;

/// Force between two limits over deflection; the three lists have the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Band {
    /// Deflections, m, rising.
    pub deflection: Vec<f64>,
    /// Lower limit, N.
    pub low: Vec<f64>,
    /// Upper limit, N.
    pub high: Vec<f64>,
}

/// A check of one layout: one run, or the mean of an ensemble with its band.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Check {
    /// What it is, in a few words: `check, 16 runs`.
    pub label: String,
    /// The curve, or the mean of the curves; its failure point is the (mean) first break.
    pub mean: Curve,
    /// The band of an ensemble.
    pub band: Option<Band>,
    /// First breaks of the runs.
    pub breaks: Vec<Point>,
    /// Quality figures, what was skipped, why it ended: one sentence each, for the report.
    pub notes: Vec<String>,
    /// Whether the inputs have changed since it was made.
    pub stale: bool,
}

impl Check {
    /// The check that the project keeps of a case's layout, if it keeps one. Lengths in the notes are
    /// shown in `unit`; `file_name` is the project's, for the command that makes it again.
    pub(crate) fn from_kept(case: &ExportedLayout, unit: Units, file_name: &str) -> Option<Check> {
        let v = case.entry.check.as_deref()?;
        let stale = !current(case, v);
        let runs = if v.runs == 1 { "1 run".to_string() } else { format!("{} runs", v.runs) };
        let band = (!v.band[0].is_empty()).then(|| Band {
            deflection: v.curve.deflection.clone(),
            low: v.band[0].clone(),
            high: v.band[1].clone(),
        });
        Some(Check {
            label: format!("check by simulation, {runs}, {}", v.wanted.fidelity.word()),
            mean: v.curve.clone(),
            band,
            breaks: v.breaks.iter().map(|b| b.at).collect(),
            notes: notes(case, v, unit, file_name, stale),
            stale,
        })
    }

    /// The label, with a mark where the inputs have changed since.
    pub(crate) fn title(&self) -> String {
        if self.stale {
            format!("{} (stale: inputs have changed since)", self.label)
        } else {
            self.label.clone()
        }
    }
}

/// Whether a result still is what this program would find for a case.
pub(crate) fn current(case: &ExportedLayout, result: &CheckResult) -> bool {
    !Simulated::of(Some(result), &case.case).stale()
}

/// What is to be known of a result, a sentence each.
fn notes(
    case: &ExportedLayout,
    v: &CheckResult,
    unit: Units,
    file: &str,
    stale: bool,
) -> Vec<String> {
    let m = |value: f64| length_text(value, unit);
    let kn = |value: f64| unit.force_number(value, 3);
    let mut notes = Vec::new();
    if v.breaks.len() > 1 {
        notes.push(format!(
            "over alignments and slack: force {} +- {} {} (standard deviation; standard error {}), 5 to 95 % {} to {} {}; deflection {} +- {}, 5 to 95 % {} to {}",
            kn(v.force.mean),
            kn(v.force.deviation),
            unit.force_symbol(),
            kn(v.force.error),
            kn(v.force.band[0]),
            kn(v.force.band[1]),
            unit.force_symbol(),
            m(v.deflection.mean),
            m(v.deflection.deviation),
            m(v.deflection.band[0]),
            m(v.deflection.band[1])
        ));
    }
    if let Some(force) = v.characteristic() {
        notes.push(format!("characteristic force {}: {CHARACTERISTIC}", force_text(force, unit)));
    }
    notes.extend(sentence(&v.catches(), unit));
    if let Some(arrangement) = &v.field.arrangement {
        notes.push(format!("blocks: {arrangement}"));
    }
    notes.push(format!(
        "peak {} at {}; stiffness at 75 % of the force {}; energy up to the first break {}",
        force_text(v.peak.force, unit),
        m(v.peak.deflection),
        stiffness_text(v.k75, unit),
        energy_text(v.energy, unit)
    ));
    if !v.breaks.is_empty() && !stale {
        let places = Places::from_result(v, &case.entry.layout);
        notes.push(format!(
            "the first wire broke at: {}; double twists: {} of {}",
            places.text(),
            places.twists,
            v.breaks.len()
        ));
    }
    // The label has the word alone.
    let auto = v.wanted.fidelity.auto();
    notes.extend(auto.then(|| format!("fidelity {}", v.wanted.fidelity_said())));
    notes.push(quality(&v.quality));
    notes.extend(v.remarks().iter().map(|remark| remark.sentence(unit)));
    let runs = v.wanted.runs.map_or(String::new(), |n| format!(" --runs {n}"));
    let repeat = format!(
        "meshcast check {} {} --fidelity {}{runs} --seed {}",
        file_word(file),
        quoted(&format!("--layout={}", case.entry.name)),
        v.wanted.fidelity.word(),
        v.wanted.seed
    );
    let other = if v.by == Revisions::CURRENT {
        String::new()
    } else {
        format!(" (this was written by {})", Revisions::CURRENT)
    };
    notes.push(format!(
        "made by {}{other}, fingerprint of the check's inputs {}; made again by: {repeat}",
        v.by, v.inputs
    ));
    notes
}

fn quality(q: &Quality) -> String {
    let percent = |part: f64| format!("{} %", significant(100.0 * part, 2));
    format!(
        "quality, the worst of the runs: estimated error of the curve {}, kinetic over internal energy {}, energy out of balance {}, support over punch force {}",
        percent(q.error_estimate),
        percent(q.kinetic_over_internal),
        percent(q.energy_balance),
        significant(q.support_over_punch, 3)
    )
}
