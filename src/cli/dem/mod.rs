//! Checks beside the forecasts of a study: the flags that ask for them, and how they are run.
//!
//! What a check says is read by [`crate::study::checks::figures`]; its columns are those of
//! [`crate::show::columns`], [`text`] is what people are told.

pub(crate) mod text;

use super::check::{runs, threads};
use super::watch::Watch;
use crate::case::Case;
use crate::cli::choice::one_of;
use crate::dem::Flow;
use crate::study::checks::{CaseEvent, CheckAnswer, NoCheck, RUNS, checks};
use crate::study::exactness::Exactness;
use crate::study::result::Wanted;
use crate::words::Choice;
use clap::Args;
use std::num::NonZeroUsize;

/// Which checks a study makes. Quick fidelity and few runs, because a study is many checks; always as
/// many runs, so that all cases have the same ones (see [`RUNS`]).
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Check by discrete elements, beside the forecast")]
pub(crate) struct DemFlags {
    /// Check each case too: runs with the same slack in all of them, and the same alignments where the
    /// block alone changes.
    #[arg(long)]
    dem: bool,
    /// Aim: errors within 3 % (quick), 1 % (standard), 0.2 % (fine), or the reference itself.
    #[arg(long, value_name = "FIDELITY", requires = "dem", default_value = "quick", value_parser = one_of(Exactness::ALL))]
    fidelity: Exactness,
    /// Number of runs of each check.
    #[arg(long, value_name = "N", requires = "dem", default_value_t = RUNS, value_parser = runs)]
    runs: usize,
    /// Seed of alignments and slack.
    #[arg(long, value_name = "S", requires = "dem", default_value_t = 0)]
    seed: u64,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N", requires = "dem")]
    threads: Option<NonZeroUsize>,
}

/// A case to check, by the name under which its progress is told.
#[derive(Debug)]
pub(crate) struct Job {
    pub(crate) name: String,
    pub(crate) case: Case,
}

/// What the jobs gave.
#[derive(Debug, Default)]
pub(crate) struct Done {
    /// One answer a job, in their order.
    pub(crate) answers: Vec<CheckAnswer>,
    /// Whether the user ended it early.
    pub(crate) interrupted: bool,
}

/// How far a run goes on after its first break where nobody says otherwise, m; only for the guess of
/// the time left.
const AFTER_BREAK: f64 = 0.05;

impl DemFlags {
    /// What is asked of each check; nothing where none is asked for.
    pub(crate) fn wanted(&self) -> Option<Wanted> {
        self.dem.then_some(Wanted {
            fidelity: self.fidelity,
            runs: Some(self.runs),
            seed: self.seed,
        })
    }

    /// Checks the jobs, with progress on standard error and Ctrl+C.
    pub(crate) fn run(&self, wanted: &Wanted, jobs: &[Job]) -> Done {
        let watch = Watch::start();
        let cases: Vec<Case> = jobs.iter().map(|job| job.case.clone()).collect();
        // Until the first run of a case has ended, its end is expected where the forecast has it.
        let ends: Vec<f64> = cases.iter().map(|c| c.expected_break() + AFTER_BREAK).collect();
        let answers = checks(&cases, wanted, threads(self.threads), &|news| match news.what {
            CaseEvent::Progress(now) => {
                let (part, parts) = (news.index, news.total);
                let label = match jobs.get(part) {
                    Some(job) if parts > 1 => format!("{} ({} of {parts})", job.name, part + 1),
                    _ => "check".to_string(),
                };
                watch.part(&label, part, parts, ends.get(part).copied().unwrap_or(1.0));
                watch.tell(now)
            }
            CaseEvent::Done(_) if watch.cancelled() => Flow::Cancel,
            CaseEvent::Done(_) => Flow::Continue,
        });
        let made = answers.iter().flatten().count();
        watch.finish(&format!("{made} of {} checks", answers.len()));
        // An interrupt that came when all was done took nothing away.
        let short = |a: &CheckAnswer| match a {
            Ok(result) => result.partial(),
            Err(why) => *why == NoCheck::NotMade,
        };
        Done { interrupted: answers.iter().any(short), answers }
    }
}
