//! The latest unsaved project, where the panic hook and the signal thread can reach it.

use super::program::Host;
use crate::project::Project;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What must be kept if the program ends now, and the way to keep it.
pub(super) struct Rescue {
    host: Arc<dyn Host>,
    state: Mutex<State>,
    over: AtomicBool,
}

#[derive(Default)]
struct State {
    unsaved: Option<Arc<Project>>,
    kept: Option<Arc<Project>>,
    /// The loop has ended: what it has done about the recovery file stands.
    settled: bool,
}

impl Rescue {
    /// Nothing unsaved yet.
    pub(super) fn new(host: Arc<dyn Host>) -> Rescue {
        Rescue { host, state: Mutex::default(), over: AtomicBool::new(false) }
    }

    /// The lock is only ever held to copy two pointers, so a holder cannot panic or wait.
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes what is unsaved now. `true` when a recovery file of this run has become pointless.
    pub(super) fn note(&self, unsaved: Option<Arc<Project>>) -> bool {
        let mut state = self.state();
        let pointless = unsaved.is_none() && state.kept.take().is_some();
        state.unsaved = unsaved;
        pointless
    }

    /// Whether there are edits that no recovery file holds.
    pub(super) fn pending(&self) -> bool {
        let state = self.state();
        match (&state.unsaved, &state.kept) {
            (Some(unsaved), Some(kept)) => !Arc::ptr_eq(unsaved, kept),
            (unsaved, _) => unsaved.is_some(),
        }
    }

    /// Notes that a project went into the recovery file.
    pub(super) fn kept(&self, project: Arc<Project>) {
        self.state().kept = Some(project);
    }

    /// Whether the loop runs and nothing is unsaved.
    pub(super) fn is_clean(&self) -> bool {
        let state = self.state();
        state.unsaved.is_none() && !state.settled
    }

    /// Writes the recovery file when there is something in need of it, also when it was written before.
    /// A project that could not be kept counts as kept, so that nobody tries it again and again.
    pub(super) fn keep(&self) -> Option<Result<PathBuf, String>> {
        let unsaved = self.state().unsaved.clone()?;
        let result = self.host.recover(&unsaved);
        self.kept(unsaved);
        Some(result)
    }

    /// The loop has ended in good order; nothing is left to rescue.
    pub(super) fn settle(&self) {
        let mut state = self.state();
        (state.unsaved, state.settled) = (None, true);
    }

    /// The terminal has been given back as well.
    pub(super) fn end(&self) {
        self.over.store(true, Ordering::SeqCst);
    }

    /// Whether the loop has ended and the terminal has been given back.
    pub(super) fn is_over(&self) -> bool {
        self.over.load(Ordering::SeqCst)
    }
}
