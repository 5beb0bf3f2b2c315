//! A campaign of random layouts behind the screen and the method derived from it, step by step. It is kept in
//! a folder as it is made, so that one that was ended goes on where it was.

use super::desk::Ticket;
use super::news::{StepProgress, What};
use super::pace::{Pace, QUIET};
use crate::dem::Flow;
use crate::lab::campaign::kept::{Kept, KeptFault};
use crate::lab::campaign::{CampaignPlan, EXPECTED_BREAK, Header};
use crate::lab::derive::derive;
use crate::mesh::MeshType;
use crate::project::{self, SaveError};
use crate::study::ensemble::EnsembleProgress;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Name of the method's file in the campaign's folder.
pub(crate) const METHOD: &str = "method.ron";

/// What to run and where to keep it.
#[derive(Debug, Clone)]
pub struct MethodJob {
    /// Folder of the campaign and of its method.
    pub(crate) folder: PathBuf,
    /// The campaign.
    pub(crate) plan: CampaignPlan,
    /// The mesh, which has wires.
    pub(crate) mesh: Arc<MeshType>,
}

impl MethodJob {
    /// Does it, until the ticket says to end.
    pub(super) fn carry_out(&self, threads: usize, ticket: &Ticket, say: &(dyn Fn(What) + Sync)) {
        say(What::Told(self.steps(threads, ticket, say)));
    }

    /// The steps; what is to be said at the end.
    fn steps(
        &self,
        threads: usize,
        ticket: &Ticket,
        say: &(dyn Fn(What) + Sync),
    ) -> Result<String, String> {
        let Some(wire) = &self.mesh.wire else {
            return Err("the mesh has no net and wires to simulate".into());
        };
        let header = Header::new(&self.plan, &self.mesh.id, wire);
        let folder = self.folder.display();
        let kept = Kept::open(&self.folder, &header, (true, ""));
        let mut kept = kept.map_err(KeptFault::into_text)?;
        let (from, lines) = (kept.rows().len(), self.plan.lines());
        let watch = Watch::new(from, lines);
        let tell = |now: EnsembleProgress| {
            if let Some(step) = watch.take(&now) {
                say(What::Step(step));
            }
            if ticket.cancelled() { Flow::Cancel } else { Flow::Continue }
        };
        let end = kept.make(&header, wire, threads, &tell);
        let end = end.map_err(KeptFault::into_text)?;
        if !end.whole {
            let made = kept.rows().len();
            return Ok(format!("{made} of {lines} runs are kept in {folder}; the same goes on"));
        }
        say(What::Step(StepProgress {
            text: "deriving the method".into(),
            fraction: 1.0,
            left: None,
        }));
        let method = derive(&[kept.into_text(header)])?;
        let text = project::method_text(&method).ok_or("the method cannot be written as RON")?;
        let path = self.folder.join(METHOD);
        match project::create(&path, &text) {
            Ok(()) => {}
            // The same campaign gives the same method; another text is somebody's own.
            Err(SaveError::Exists(path)) => {
                let there = project::load_table(&path, project::LARGEST_FILE);
                if !there.is_ok_and(|bytes| bytes == text.as_bytes()) {
                    return Err(format!("{} is another one and stays", path.display()));
                }
            }
            Err(other) => return Err(other.to_string()),
        }
        Ok(format!("{lines} runs and the method from them are in {}", path.display()))
    }
}

/// Watches the runs: a word four times a second.
struct Watch {
    from: usize,
    lines: usize,
    start: Instant,
    state: Mutex<(Pace, Instant)>,
}

impl Watch {
    fn new(from: usize, lines: usize) -> Watch {
        let mut pace = Pace::default();
        pace.begin(0, 1, EXPECTED_BREAK);
        let start = Instant::now();
        Watch { from, lines, start, state: Mutex::new((pace, start)) }
    }

    fn take(&self, now: &EnsembleProgress) -> Option<StepProgress> {
        // Nothing that holds the lock can panic halfway.
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let (pace, spoke) = &mut *state;
        pace.take(now.run, now.planned, &now.inner);
        if spoke.elapsed() < QUIET {
            return None;
        }
        *spoke = Instant::now();
        let share = self.from as f64 / self.lines as f64;
        Some(StepProgress {
            text: format!("{} of {} runs", self.from + now.done, self.lines),
            fraction: share + (1.0 - share) * pace.fraction(),
            left: Some(pace.left(self.start.elapsed().as_secs_f64())),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::{Order, Task};
    use super::*;
    use crate::lab::campaign::file;
    use crate::mesh::catalogue;

    fn job(folder: PathBuf) -> MethodJob {
        let ranges = [[0.3, 0.34], [1.3, 1.4], [0.5, 0.6]];
        let plan = CampaignPlan { runs: 24, eccentric: 0.0, ranges, ..CampaignPlan::default() };
        MethodJob { folder, plan, mesh: catalogue::reference() }
    }

    /// What is said at the end of the job; ended at its first word of progress where that is asked.
    fn told(job: &MethodJob, end: bool) -> Result<String, String> {
        let (ticket, heard) = (Ticket::default(), Mutex::new(None));
        let order = Order { number: 3, task: Task::Method(job.clone()) };
        order.carry_out(2, &ticket, &|news| match news.what {
            What::Step(_) if end => ticket.cancel(),
            What::Told(said) => *heard.lock().unwrap() = Some(said),
            _ => {}
        });
        heard.into_inner().unwrap().unwrap()
    }

    #[test]
    fn a_campaign_that_was_ended_goes_on_to_the_same_bytes_and_its_method() {
        let dir = tempfile::tempdir().unwrap();
        let [whole, parts] = ["whole", "parts"].map(|name| job(dir.path().join(name)));
        let said = told(&whole, false).unwrap();
        assert!(said.starts_with("30 runs and the method") && said.ends_with(METHOD), "{said}");
        // Cut off within a line, as by a kill.
        let read = |job: &MethodJob, name: &str| std::fs::read(job.folder.join(name)).unwrap();
        let text = read(&whole, file::NAME);
        std::fs::create_dir(&parts.folder).unwrap();
        std::fs::write(parts.folder.join(file::NAME), &text[..text.len() / 2]).unwrap();
        assert!(told(&parts, false).is_ok());
        for name in [file::NAME, METHOD] {
            assert_eq!(read(&parts, name), read(&whole, name), "{name}");
        }
        // Asked again there is nothing to do; another campaign is not mixed with it.
        assert_eq!(told(&whole, false), Ok(said));
        let mut other = whole.clone();
        other.plan.seed = 9;
        assert!(told(&other, false).unwrap_err().contains("made otherwise: seed 0 and not 9"));
    }

    #[test]
    fn a_campaign_that_is_ended_keeps_its_runs() {
        let dir = tempfile::tempdir().unwrap();
        let mut job = job(dir.path().join("long"));
        job.plan.runs = 100_000;
        let said = told(&job, true).unwrap();
        assert!(said.contains("of 120000 runs are kept"), "{said}");
    }
}
