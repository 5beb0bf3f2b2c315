//! A campaign of checks: many cases, one after the other, each an ensemble of the anchored test.
//!
//! - this file: the campaign, watched from outside; it neither prints nor knows a command line.
//! - [`change`]: what two results say about the difference of their cases; [`figures`]: what one says
//!   beside a forecast.
//!
//! All cases are asked for with one [`Wanted`], so with the same seeds: run k has the same draw of slack in
//! every case (common random numbers), and where the plates catch the same patterns of nodes (another block,
//! not another plate, spacing or offset from the centre) the same alignment of the net. What the cases share
//! then cancels in their difference; where they do not share their alignments the error is that of two means,
//! each over exact areas of its own patterns.
//!
//! A check takes its wires from the mesh and not from the laboratory values, so there is none for
//! another F_l* or delta_l*: see [`NoCheck::Laboratory`].

pub(crate) mod change;
pub(crate) mod figures;

use super::ensemble::EnsembleProgress;
use super::result::make::{self, wires};
use super::result::{CheckResult, Wanted};
use crate::case::Case;
use crate::dem::Flow;
use crate::dem::field::OVERLAP;
use crate::fingerprint::Fingerprint;
use crate::forecast::Strength;
use crate::forecast::design::Question;
use crate::problem::{Problem, summary};
use std::collections::HashMap;

/// Runs of each case of a study where nobody says how many. The least of a check
/// ([`super::ensemble::LEAST`]) and always as many: with a number that each case decides for itself the
/// cases would not have the same runs, and their difference would hold the noise of those that only
/// one has.
pub(crate) const RUNS: usize = super::ensemble::LEAST;

/// Why a case has no check.
#[derive(Debug, Clone, PartialEq)]
pub enum NoCheck {
    /// A laboratory value is changed, which the check does not know.
    Laboratory,
    /// The layout or the wires cannot be checked.
    Impossible(Vec<Problem>),
    /// The campaign was ended before a run of this case was whole.
    NotMade,
}

impl NoCheck {
    /// Stable identifier for programs: `laboratory`, `blocks_overlap`, `impossible` or `not_made`.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            NoCheck::Laboratory => "laboratory",
            NoCheck::Impossible(problems) if overlap(problems) => "blocks_overlap",
            NoCheck::Impossible(_) => "impossible",
            NoCheck::NotMade => "not_made",
        }
    }

    /// A word or two for a narrow column.
    pub(crate) fn short(&self) -> &'static str {
        match self {
            NoCheck::Laboratory => "none",
            NoCheck::Impossible(problems) if overlap(problems) => "overlap",
            NoCheck::Impossible(_) => "not possible",
            NoCheck::NotMade => "not made",
        }
    }

    /// The reason as a sentence without a final stop.
    pub(crate) fn sentence(&self) -> String {
        match self {
            NoCheck::Laboratory => {
                "the check takes its wires from the mesh, not from the laboratory values".into()
            }
            NoCheck::Impossible(problems) => summary(problems),
            NoCheck::NotMade => "ended before a run of it was whole".into(),
        }
    }
}

/// Whether a layout cannot be checked because its mirrored blocks overlap.
fn overlap(problems: &[Problem]) -> bool {
    problems.iter().any(|problem| problem.message == OVERLAP)
}

/// A case's check, or why there is none.
pub(crate) type CheckAnswer = Result<CheckResult, NoCheck>;

/// What a campaign tells while it runs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CaseNews<'a> {
    /// Place of the case among the cases.
    pub index: usize,
    /// Number of cases.
    pub total: usize,
    /// What there is to say of it.
    pub what: CaseEvent<'a>,
}

/// Of one case of a campaign.
#[derive(Debug, Clone, Copy)]
pub(crate) enum CaseEvent<'a> {
    /// How far its ensemble has come; told from several threads.
    Progress(EnsembleProgress),
    /// It is done; told from the thread that called, in the order of the cases.
    Done(&'a CheckAnswer),
}

/// Checks cases one after the other, each on so many threads; one answer a case, in their order.
///
/// Cases that are equal for a check ([`make::fingerprint`]) are run once. `tell` may end the campaign:
/// what is done is kept (an unfinished case with the runs that are whole, see [`CheckResult::partial`]), the
/// rest is [`NoCheck::NotMade`].
pub(crate) fn checks(
    cases: &[Case],
    wanted: &Wanted,
    threads: usize,
    tell: &(dyn Fn(CaseNews) -> Flow + Sync),
) -> Vec<CheckAnswer> {
    let total = cases.len();
    let mut made: HashMap<Fingerprint, usize> = HashMap::new();
    let mut answers: Vec<CheckAnswer> = Vec::with_capacity(total);
    for (index, case) in cases.iter().enumerate() {
        let before = inputs(case, wanted).ok().and_then(|inputs| match made.get(&inputs) {
            Some(place) => answers.get(*place).cloned(),
            None => {
                made.insert(inputs, index);
                None
            }
        });
        let progress =
            |now: EnsembleProgress| tell(CaseNews { index, total, what: CaseEvent::Progress(now) });
        let answer = before.unwrap_or_else(|| one(case, wanted, threads, &progress));
        // One that was cut short is the last: the callback has asked for the end.
        let short = match &answer {
            Ok(result) => result.partial(),
            Err(why) => *why == NoCheck::NotMade,
        };
        let flow = tell(CaseNews { index, total, what: CaseEvent::Done(&answer) });
        answers.push(answer);
        if short || flow == Flow::Cancel {
            break;
        }
    }
    answers.resize(total, Err(NoCheck::NotMade));
    answers
}

/// Fingerprint of a case's check.
///
/// # Errors
/// Its mesh has no wires.
pub(crate) fn inputs(case: &Case, wanted: &Wanted) -> Result<Fingerprint, NoCheck> {
    let wire = wires(&case.mesh).map_err(NoCheck::Impossible)?;
    Ok(make::fingerprint(&case.layout, wire, wanted))
}

fn one(
    case: &Case,
    wanted: &Wanted,
    threads: usize,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
) -> CheckAnswer {
    let tell = |told: make::Told| match told {
        make::Told::Progress(now) => progress(now),
        make::Told::Finished(..) => Flow::Continue,
    };
    let made = make::make(&case.layout, &case.mesh, wanted, threads, &tell)
        .map_err(NoCheck::Impossible)?;
    if made.result.partial() && made.result.runs == 0 {
        return Err(NoCheck::NotMade);
    }
    Ok(made.result)
}

/// Utilisation of a panel that holds `force` (N), where a design force is set: as of a forecast,
/// gamma_load times the design force over the force over gamma_resistance.
pub(crate) fn utilisation(question: &Question, force: f64) -> Option<f64> {
    let load = question.gamma_load * question.force?;
    (force > 0.0).then(|| load * question.gamma_resistance / force)
}

/// How far a check's means are from a forecast, as parts of the forecast: 0.05 is 5 % above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Difference {
    /// Of the force at failure.
    pub(crate) force: f64,
    /// Of the deflection at failure, where the forecast has one.
    pub(crate) deflection: Option<f64>,
}

/// The difference of a check from a forecast; nothing where no run broke.
pub(crate) fn difference(result: &CheckResult, forecast: Strength) -> Option<Difference> {
    result.broke().then(|| Difference {
        force: result.force.mean / forecast.force - 1.0,
        deflection: forecast.deflection.map(|delta| result.deflection.mean / delta - 1.0),
    })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::case::{Input, example};
    use crate::layout::{Layout, REFERENCE};
    use crate::study::exactness::Exactness;
    use std::sync::Mutex;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// A panel that is checked in a few milliseconds a run.
    pub(crate) const SMALL: Layout = Layout { spacing: 1.3, punch: 0.4, ..REFERENCE };

    /// Two quick runs.
    pub(crate) fn two() -> Wanted {
        Wanted { fidelity: Exactness::Quick, runs: Some(2), seed: 3 }
    }

    #[test]
    fn each_case_is_its_own_check_and_equal_ones_are_run_once() {
        let base = example(SMALL, None);
        let cases = [
            base.clone(),
            base.with(Input::Spacing, 1.4),
            base.with(Input::LabForce, 5.0e4),
            base.with(Input::Punch, 1.4),
        ];
        let (done, progress) = (Mutex::new(Vec::new()), AtomicUsize::new(0));
        let answers = checks(&cases, &two(), 2, &|news| {
            assert_eq!(news.total, 4);
            match news.what {
                CaseEvent::Done(answer) => done.lock().unwrap().push((news.index, answer.clone())),
                CaseEvent::Progress(_) => {
                    assert!(news.index < 2, "case {} is not run", news.index);
                    progress.fetch_add(1, Ordering::Relaxed);
                }
            }
            Flow::Continue
        });
        assert!(progress.into_inner() > 0);
        let done = done.into_inner().unwrap();
        assert_eq!(done.iter().map(|d| d.0).collect::<Vec<_>>(), [0, 1, 2, 3]);
        assert!(done.iter().zip(&answers).all(|(told, kept)| told.1 == *kept));
        let alone = make::make(&SMALL, &base.mesh, &two(), 1, &|_| Flow::Continue).unwrap();
        assert_eq!(answers[0], Ok(alone.result), "the check of one thread, to the last bit");
        assert_eq!(answers[2], answers[0], "the laboratory's force is no input of a check");
        assert_ne!(answers[1], answers[0]);
        let why = answers[3].as_ref().unwrap_err();
        assert!(why.code() == "impossible" && why.sentence().starts_with("D = 1.4 m"), "{why:?}");
    }

    #[test]
    fn a_campaign_that_is_ended_keeps_what_is_done() {
        let base = example(SMALL, None);
        let cases = [base.clone(), base.with(Input::Plate, 0.3), base.with(Input::Plate, 0.35)];
        let answers = checks(&cases, &two(), 1, &|news| match news.what {
            CaseEvent::Done(_) if news.index == 1 => Flow::Cancel,
            _ => Flow::Continue,
        });
        assert!(answers[..2].iter().all(Result::is_ok));
        assert_eq!(answers[2], Err(NoCheck::NotMade));
        // In the middle of a case's first run nothing of it is whole.
        let answers = checks(&cases, &two(), 1, &|news| match news.what {
            CaseEvent::Progress(_) if news.index == 1 => Flow::Cancel,
            _ => Flow::Continue,
        });
        assert!(answers[0].is_ok() && answers[1..].iter().all(|a| *a == Err(NoCheck::NotMade)));
        assert!(checks(&[], &two(), 1, &|_| Flow::Continue).is_empty());
    }

    /// A screen once showed an empty line where an error had come without a reason.
    #[test]
    fn nothing_is_refused_without_a_word() {
        assert!(!NoCheck::Impossible(Vec::new()).sentence().is_empty());
        let none = crate::case::NoValue::Senseless(Vec::new()).sentence();
        assert_eq!(none, "no value: no reason is known");
    }

    #[test]
    fn utilisation_and_difference_are_those_of_the_forecast() {
        let case = example(REFERENCE, Some(20_000.0));
        let question = Question { gamma_load: 1.3, gamma_resistance: 1.1, ..case.question };
        let point = Case { question, ..case }.outcome().unwrap();
        let ours = utilisation(&question, point.values().force).unwrap();
        assert!((ours - point.utilisation().unwrap()).abs() < 1e-12);
        assert_eq!(utilisation(&Question { force: None, ..question }, 1.0), None);
        assert_eq!(utilisation(&question, 0.0), None);
    }
}
