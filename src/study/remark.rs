//! What a check has to say of itself. A project keeps only the flags of a check; the other remarks follow
//! from its figures, so that a kept check says the same as one that has just been made.

use super::bias::MOST_ESTIMATE;
use crate::dem::Fidelity;
use crate::dem::bifurcation::Probe;
use crate::dem::estimate::SNAP;
use crate::forecast::NoField;
use crate::remark::Weight;
use crate::units::{Units, force_text};
use crate::words::Choice;

/// Standard error above which it is said; so few runs may have been asked for.
const UNCERTAIN: f64 = 0.02;

/// What an ensemble tells of itself besides its figures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CheckFlag {
    /// A millimetre of the punch's place decides.
    Bifurcation,
    /// Runs ran away.
    Diverged,
    /// It was ended early.
    Cancelled,
    /// More cells around a single block would still change it.
    Unsettled,
    /// One that another version of the program knows; kept and shown as it is.
    Other(String),
}

impl CheckFlag {
    /// The flag of this code.
    pub fn from_code(code: &str) -> CheckFlag {
        let known = [
            CheckFlag::Bifurcation,
            CheckFlag::Diverged,
            CheckFlag::Cancelled,
            CheckFlag::Unsettled,
        ];
        known
            .into_iter()
            .find(|flag| flag.code() == code)
            .unwrap_or_else(|| CheckFlag::Other(code.into()))
    }

    /// The code in files and JSON.
    pub(crate) fn code(&self) -> &str {
        match self {
            CheckFlag::Bifurcation => "bifurcation",
            CheckFlag::Diverged => "diverged",
            CheckFlag::Cancelled => "cancelled",
            CheckFlag::Unsettled => "not_converged",
            CheckFlag::Other(code) => code,
        }
    }
}

/// Why a check has no forecast beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NoForecast {
    /// A laboratory test that Eqs. 1-2 do not cover.
    Laboratory,
    /// A layout outside the method.
    Field(NoField),
    /// The net of a file, of which no laboratory record is known.
    OtherNet,
}

/// A remark on a check. Figures that a remark may lack are those that a kept check lacks, and those of
/// many checks at once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum CheckRemark {
    /// A millimetre of the punch's place decides; the two places where both were run.
    Bifurcation(Option<Probe>),
    /// So many runs ran away and were left out.
    Diverged(Option<usize>),
    /// It was ended early; so many runs are whole.
    Cancelled(Option<usize>),
    /// More cells around a single block would still change it.
    Unsettled,
    /// So many runs of so many slipped through without a break.
    Slipped(Option<(usize, usize)>),
    /// So many runs came to the displacement limit without a break.
    DisplacementLimit(Option<usize>),
    /// The mean force is known to this part only.
    StandardError(Option<f64>),
    /// The worst run's estimated error, as a part: so far above the aim of this fidelity that it may be missed.
    ErrorEstimate(Option<(f64, Fidelity)>),
    /// It is of one alignment alone.
    OneAlignment,
    /// Blocks stand as the paper has them, and may take less where they face each other.
    FacingLeftOut,
    /// There is no forecast to compare with.
    NoForecast(NoForecast),
    /// By how much the net was stretched in x and y, as parts.
    Stretch([f64; 2]),
    /// Where the wires' law comes from.
    WireLaw(String),
    /// One of another version of the program, as it was kept.
    Other(String),
}

impl CheckRemark {
    /// Stable identifier for programs.
    pub(crate) fn code(&self) -> &str {
        match self {
            CheckRemark::Bifurcation(_) => "bifurcation",
            CheckRemark::Diverged(_) => "diverged",
            CheckRemark::Cancelled(_) => "cancelled",
            CheckRemark::Unsettled => "not_converged",
            CheckRemark::Slipped(_) => "slipped",
            CheckRemark::DisplacementLimit(_) => "displacement_limit",
            CheckRemark::StandardError(_) => "standard_error",
            CheckRemark::ErrorEstimate(_) => "error_estimate",
            CheckRemark::OneAlignment => "one_alignment",
            CheckRemark::FacingLeftOut => "facing_left_out",
            CheckRemark::NoForecast(_) => "no_forecast",
            CheckRemark::Stretch(_) => "stretch",
            CheckRemark::WireLaw(_) => "wire_law",
            CheckRemark::Other(code) => code,
        }
    }

    /// How much it weighs.
    pub(crate) fn weight(&self) -> Weight {
        match self {
            CheckRemark::NoForecast(NoForecast::Field(NoField::PassesThrough)) => Weight::Caution,
            CheckRemark::OneAlignment
            | CheckRemark::FacingLeftOut
            | CheckRemark::NoForecast(_)
            | CheckRemark::WireLaw(_) => Weight::Note,
            _ => Weight::Caution,
        }
    }

    /// A few words for a narrow panel.
    pub(crate) fn short(&self) -> String {
        match self {
            CheckRemark::Bifurcation(_) => "a millimetre decides: band only".into(),
            CheckRemark::Diverged(Some(1)) => "1 run diverged".into(),
            CheckRemark::Diverged(Some(runs)) => format!("{runs} runs diverged"),
            CheckRemark::Diverged(None) => "runs diverged".into(),
            CheckRemark::Cancelled(_) => "ended early".into(),
            CheckRemark::Unsettled => "not converged: field too small".into(),
            CheckRemark::Slipped(Some((slipped, runs))) => {
                format!("slipped through: {slipped} of {runs}")
            }
            CheckRemark::Slipped(None) => "slipped through".into(),
            CheckRemark::DisplacementLimit(_) => "no break".into(),
            CheckRemark::StandardError(_) => "mean uncertain".into(),
            CheckRemark::ErrorEstimate(_) => "inexact".into(),
            CheckRemark::OneAlignment => "one alignment only".into(),
            CheckRemark::FacingLeftOut => "facing blocks may take less".into(),
            CheckRemark::NoForecast(_) => "no forecast".into(),
            CheckRemark::Stretch(_) => "net stretched".into(),
            CheckRemark::WireLaw(_) => "wire law".into(),
            CheckRemark::Other(code) => code.clone(),
        }
    }

    /// The whole sentence for people, without a final stop.
    pub(crate) fn sentence(&self, units: Units) -> String {
        let kn = |v: f64| force_text(v, units);
        let percent = |v: f64| format!("{:.1} %", 100.0 * v);
        match self {
            CheckRemark::Bifurcation(probe) => {
                let told = probe.map_or(String::new(), |p| format!(
                    "; 5 mm and 3 mm beside the given place the first break is at {} instead of {}",
                    kn(p.beside),
                    kn(p.here)
                ));
                format!(
                    "bifurcation: the block can stay on a wire or slip off it{told}. A single run means nothing here, only the ensemble counts"
                )
            }
            CheckRemark::Diverged(runs) => {
                let (who, are) = match runs {
                    Some(1) => ("1 run".into(), "is"),
                    Some(runs) => (format!("{runs} runs"), "are"),
                    None => ("some runs".into(), "are"),
                };
                format!("{who} diverged and {are} not counted")
            }
            CheckRemark::Cancelled(runs) => {
                let who = match runs {
                    Some(1) => "1 run that was".into(),
                    Some(runs) => format!("{runs} runs that were"),
                    None => "runs that were".into(),
                };
                format!("ended early: the figures are of the {who} whole")
            }
            CheckRemark::Unsettled => {
                "a single block, not converged: in a still larger field the net slides towards the block from farther away, which lowers the force and raises the deflection; by how much the last larger field did stands with the blocks".into()
            }
            CheckRemark::Slipped(runs) => {
                let who = runs.map_or("runs".into(), |(slipped, runs)| {
                    format!("{slipped} of {runs} runs")
                });
                format!("{who} slipped through without a break; {BY_PEAK}")
            }
            CheckRemark::DisplacementLimit(runs) => {
                let who = match runs {
                    Some(1) => "1 run".into(),
                    Some(runs) => format!("{runs} runs"),
                    None => "runs".into(),
                };
                format!("{who} came to the displacement limit without a break; {BY_PEAK}")
            }
            CheckRemark::StandardError(part) => {
                let known = match part {
                    Some(part) => format!("known to {} only (standard error)", percent(*part)),
                    None => format!("not known to {:.0} %", 100.0 * UNCERTAIN),
                };
                format!("the mean force is {known}; more runs make it better")
            }
            CheckRemark::ErrorEstimate(Some((worst, fidelity))) => format!(
                "estimated error of a run up to {}, where {} aims at {}; {}",
                percent(*worst),
                fidelity.word(),
                percent(fidelity.aim()),
                if *worst < SNAP {
                    "a higher fidelity makes it smaller"
                } else {
                    "a higher fidelity makes it smaller, but not where a snap of the net decides: there no single run is better than 10 %, and the mean of many is"
                }
            ),
            CheckRemark::ErrorEstimate(None) => {
                "estimated error of a run well above what the fidelity aims at; a higher one makes it smaller".into()
            }
            CheckRemark::OneAlignment => {
                "one alignment of the net with anchors and punch alone can be 25 % off; several, drawn at random, give a mean and its band".into()
            }
            CheckRemark::FacingLeftOut => {
                "blocks as the paper has them: the same in every cell; where they face each other across an anchor line less may be taken: `worst` computes both".into()
            }
            CheckRemark::NoForecast(why) => format!(
                "no forecast to compare with: {}",
                match why {
                    NoForecast::Laboratory => "Eqs. 1-2 hold for a centred punch of 1.0 m only",
                    NoForecast::Field(NoField::Grid) => "the method has none for this grid",
                    NoForecast::Field(why) => why.reason(),
                    NoForecast::OtherNet => "the net is the file's, and the laboratory record another mesh's",
                }
            ),
            CheckRemark::Stretch([x, y]) => format!(
                "the net was stretched by {:+.1} % in x and {:+.1} % in y to a whole number of openings",
                100.0 * x,
                100.0 * y
            ),
            CheckRemark::WireLaw(source) => format!("wire law: {source}"),
            CheckRemark::Other(code) => code.clone(),
        }
    }

    /// The same remark without figures, as it holds for many checks at once.
    pub(crate) fn general(&self) -> CheckRemark {
        match self {
            CheckRemark::Bifurcation(_) => CheckRemark::Bifurcation(None),
            CheckRemark::Diverged(_) => CheckRemark::Diverged(None),
            CheckRemark::Cancelled(_) => CheckRemark::Cancelled(None),
            CheckRemark::Slipped(_) => CheckRemark::Slipped(None),
            CheckRemark::DisplacementLimit(_) => CheckRemark::DisplacementLimit(None),
            CheckRemark::StandardError(_) => CheckRemark::StandardError(None),
            CheckRemark::ErrorEstimate(_) => CheckRemark::ErrorEstimate(None),
            other => other.clone(),
        }
    }
}

/// What becomes of a run without a break.
const BY_PEAK: &str = "they are in the band by their peak and not in the mean";

/// The figures that remarks follow from.
pub(super) struct Facts<'a> {
    pub(super) flags: &'a [CheckFlag],
    pub(super) probe: Option<Probe>,
    pub(super) diverged: Option<usize>,
    /// Runs that count, those of them with a break, and those that slipped.
    pub(super) runs: usize,
    pub(super) broken: usize,
    pub(super) slipped: usize,
    /// Whether all have the same alignment.
    pub(super) aligned: bool,
    /// Standard error of the mean force, over it.
    pub(super) force_error: f64,
    /// The worst run's.
    pub(super) error_estimate: f64,
    /// Of each run; nothing where the ensemble chooses it, see [`super::paired`]: then the force's error has what an
    /// estimate tells, and only one that tells nothing is said.
    pub(super) fidelity: Option<Fidelity>,
}

impl Facts<'_> {
    /// The remarks, all of them cautions but the note on a single alignment, which stands last.
    pub(super) fn remarks(&self) -> Vec<CheckRemark> {
        let mut list: Vec<CheckRemark> = self.flags.iter().map(|flag| self.of_flag(flag)).collect();
        // Where a millimetre decides, no other figure means much.
        list.sort_by_key(|remark| !matches!(remark, CheckRemark::Bifurcation(_)));
        if self.slipped > 0 {
            list.push(CheckRemark::Slipped(Some((self.slipped, self.runs))));
        }
        let unbroken = self.runs.saturating_sub(self.broken + self.slipped);
        if unbroken > 0 {
            list.push(CheckRemark::DisplacementLimit(Some(unbroken)));
        }
        let alone = self.aligned || self.runs == 1;
        if !alone && self.broken > 1 && self.force_error > UNCERTAIN {
            list.push(CheckRemark::StandardError(Some(self.force_error)));
        }
        let worst = self.error_estimate;
        let untold = worst > MOST_ESTIMATE;
        let fidelity = self.fidelity.or_else(|| untold.then_some(Fidelity::Standard));
        if let Some(fidelity) = fidelity.filter(|f| worst.is_finite() && !f.keeps(worst)) {
            list.push(CheckRemark::ErrorEstimate(Some((worst, fidelity))));
        }
        if alone {
            list.push(CheckRemark::OneAlignment);
        }
        list
    }

    fn of_flag(&self, flag: &CheckFlag) -> CheckRemark {
        match flag {
            CheckFlag::Bifurcation => CheckRemark::Bifurcation(self.probe),
            CheckFlag::Diverged => CheckRemark::Diverged(self.diverged),
            CheckFlag::Cancelled => CheckRemark::Cancelled(Some(self.runs)),
            CheckFlag::Unsettled => CheckRemark::Unsettled,
            CheckFlag::Other(code) => CheckRemark::Other(code.clone()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(flags: &[CheckFlag]) -> Facts<'_> {
        Facts {
            flags,
            probe: None,
            diverged: None,
            runs: 8,
            broken: 8,
            slipped: 0,
            aligned: false,
            force_error: 0.01,
            error_estimate: 0.01,
            fidelity: Some(Fidelity::Standard),
        }
    }

    fn codes(facts: &Facts) -> Vec<String> {
        facts.remarks().iter().map(|r| r.code().to_string()).collect()
    }

    #[test]
    fn a_good_check_has_nothing_to_say_and_each_flaw_has_its_remark() {
        let none: &[CheckFlag] = &[];
        assert!(codes(&facts(none)).is_empty());
        let said = [
            Facts { slipped: 2, broken: 6, ..facts(none) },
            Facts { broken: 7, ..facts(none) },
            // Above 2 % it is said.
            Facts { force_error: 0.023, ..facts(none) },
            // Standard aims at 1 %.
            Facts { error_estimate: 0.018, ..facts(none) },
            Facts { runs: 1, broken: 1, ..facts(none) },
            Facts { aligned: true, ..facts(none) },
        ];
        assert_eq!(
            said.iter().flat_map(codes).collect::<Vec<_>>(),
            [
                "slipped",
                "displacement_limit",
                "standard_error",
                "error_estimate",
                "one_alignment",
                "one_alignment"
            ]
        );
    }

    #[test]
    fn where_the_ensemble_chooses_only_an_estimate_that_tells_nothing_is_said() {
        let chosen = |error_estimate| {
            let none: &[CheckFlag] = &[];
            codes(&Facts { error_estimate, fidelity: None, ..facts(none) })
        };
        assert!(chosen(0.19).is_empty());
        assert_eq!(chosen(0.21), ["error_estimate"]);
    }

    #[test]
    fn a_flag_that_nobody_knows_is_kept_and_said_as_it_is() {
        let flags = ["diverged", "melted"].map(CheckFlag::from_code);
        assert_eq!(flags.clone().map(|f| f.code().to_string()), ["diverged", "melted"]);
        let said: Vec<String> =
            facts(&flags).remarks().iter().map(|r| r.sentence(Units::METRES)).collect();
        assert_eq!(said, ["some runs diverged and are not counted", "melted"]);
    }

    #[test]
    fn figures_stand_in_the_sentence_where_they_are_known() {
        let slipped = CheckRemark::Slipped(Some((2, 8)));
        assert!(slipped.sentence(Units::METRES).starts_with("2 of 8 runs slipped through"));
        assert!(slipped.general().sentence(Units::METRES).starts_with("runs slipped through"));
        let probe = Probe { here: 30_000.0, beside: 24_000.0 };
        let said = CheckRemark::Bifurcation(Some(probe)).sentence(Units::METRES);
        assert!(said.contains("at 24.0 kN instead of 30.0 kN"), "{said}");
        assert_eq!(
            CheckRemark::Diverged(Some(1)).sentence(Units::METRES),
            "1 run diverged and is not counted"
        );
    }
}
