//! A mesh adopted from its own tests behind the screen, step by step. It is kept in a folder as it is made, so that
//! one that was ended goes on where it was.

use super::desk::Ticket;
use super::news::{StepProgress, What};
use super::pace::{Pace, QUIET};
use crate::dem::{Fidelity, Flow};
use crate::lab::adopt::{AdoptFault, AdoptPlan, AdoptStep, MeshWords, folder, remove};
use crate::lab::campaign::EXPECTED_BREAK;
use crate::lab::fit::curve::LabCurve;
use crate::lab::fit::posterior::IdentifyOptions;
use crate::lab::fit::say::remarks;
use crate::lab::fit::sheet::Sheet;
use crate::mesh::laws;
use crate::problem::Problem;
use crate::project::{self, MeshUse, Project};
use crate::study::ensemble::EnsembleProgress;
use crate::words::Choice;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// What to adopt and where to keep it.
#[derive(Debug, Clone)]
pub struct AdoptJob {
    /// Folder of what is done.
    pub(crate) folder: PathBuf,
    /// What was typed; its curve comes from the file.
    pub(crate) sheet: Sheet,
    /// File of the test's curve.
    pub(crate) curve: Option<PathBuf>,
    /// What the mesh is to be called.
    pub(crate) words: MeshWords,
    /// Runs of random layouts in its campaign.
    pub(crate) runs: usize,
    /// The layout that the mesh is for, by its uid.
    pub(crate) uid: u64,
}

/// What was kept on the way to the project's adopted meshes can go: they are written.
pub(crate) fn forget(project: &Project, file: &Path) {
    for held in &project.meshes {
        if let MeshUse::Inline(mesh) = held
            && mesh.adopted.is_some()
        {
            remove(&folder(file, &mesh.id));
        }
    }
}

impl AdoptJob {
    /// Does it, until the ticket says to end.
    pub(super) fn carry_out(&self, threads: usize, ticket: &Ticket, say: &(dyn Fn(What) + Sync)) {
        match self.adopt(threads, ticket, say) {
            Ok(Some(adopted)) => say(adopted),
            Ok(None) => say(What::Told(Ok(format!(
                "{}: what is done is kept; m and A go on with it",
                self.words.id
            )))),
            Err(AdoptFault::Problems(problems)) => {
                say(What::FormRefused(problems));
            }
            Err(AdoptFault::Kept(why)) => say(What::Told(Err(why.into_text()))),
            Err(AdoptFault::Failed(why)) => say(What::Told(Err(why))),
        }
    }

    fn adopt(
        &self,
        threads: usize,
        ticket: &Ticket,
        say: &(dyn Fn(What) + Sync),
    ) -> Result<Option<What>, AdoptFault> {
        let mut sheet = self.sheet.clone();
        sheet.curve = self.curve.as_deref().map(read).transpose()?;
        let data = sheet.data(&laws::reference().net).map_err(AdoptFault::Problems)?;
        let (words, runs) = (self.words.clone(), self.runs);
        let options = IdentifyOptions { seed: 0, fidelity: Fidelity::Quick, threads };
        let plan = AdoptPlan { words, data, options, runs, more: Vec::new() };
        let watch = Watch::new();
        let tell = |step: AdoptStep, now: EnsembleProgress| {
            if let Some(told) = watch.take(&step, &now) {
                say(What::Step(told));
            }
            if ticket.cancelled() { Flow::Cancel } else { Flow::Continue }
        };
        let Some(made) = plan.adopt(&self.folder, (true, ""), &tell)? else { return Ok(None) };
        let remarks = remarks(&plan.data, &made.found);
        Ok(Some(What::Adopted { uid: self.uid, mesh: Arc::new(made.mesh), remarks }))
    }
}

/// The curve in a file.
fn read(path: &Path) -> Result<LabCurve, AdoptFault> {
    let of_field = |why: String| {
        AdoptFault::Problems(vec![Problem::new("--curve", format!("{}: {why}", path.display()))])
    };
    let bytes = project::load_table(path, project::LARGEST_FILE)
        .map_err(|error| of_field(error.in_one_line()))?;
    let text = String::from_utf8(bytes)
        .map_err(|_| of_field("this is no text in UTF-8; save the table as CSV".into()))?;
    LabCurve::read(&text).map_err(|problem| of_field(problem.to_string()))
}

/// Watches the steps: a word four times a second.
struct Watch {
    state: Mutex<State>,
}

struct State {
    pace: Pace,
    /// The step that runs, and since when.
    step: String,
    since: Instant,
    spoke: Instant,
}

impl Watch {
    fn new() -> Watch {
        let now = Instant::now();
        let state = State { pace: Pace::default(), step: String::new(), since: now, spoke: now };
        Watch { state: Mutex::new(state) }
    }

    fn take(&self, step: &AdoptStep, now: &EnsembleProgress) -> Option<StepProgress> {
        // Nothing that holds the lock can panic halfway.
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let name = match step {
            AdoptStep::Laws { .. } => "laws",
            AdoptStep::Campaign { blocks, .. } => blocks.word(),
        };
        if state.step != name {
            state.step = name.into();
            state.since = Instant::now();
            state.pace.begin(0, 1, EXPECTED_BREAK);
        }
        state.pace.take(now.run, now.planned, &now.inner);
        if state.spoke.elapsed() < QUIET {
            return None;
        }
        state.spoke = Instant::now();
        Some(match step {
            AdoptStep::Laws { trial, of, .. } => StepProgress {
                text: format!("laws that fit, trial {trial} of about {of}"),
                fraction: (*trial as f64 / *of as f64).min(0.99),
                left: None,
            },
            AdoptStep::Campaign { blocks, from, lines } => {
                let share = *from as f64 / *lines as f64;
                StepProgress {
                    text: format!("{} blocks, {} of {lines} runs", blocks.word(), from + now.done),
                    fraction: share + (1.0 - share) * state.pace.fraction(),
                    left: Some(state.pace.left(state.since.elapsed().as_secs_f64())),
                }
            }
        })
    }
}
