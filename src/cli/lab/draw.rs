//! What the commands that draw random layouts share.

use crate::cli::check::threads;
use crate::cli::choice::one_of;
use crate::cli::output::Fault;
use crate::cli::quantity;
use crate::dem::Fidelity;
use crate::words::Choice;
use clap::Args;
use std::num::NonZeroUsize;

/// How runs are drawn and computed.
#[derive(Debug, Args)]
pub(crate) struct DrawFlags {
    /// Seed of all that is drawn.
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub(super) seed: u64,
    /// How exactly each run is computed.
    #[arg(long, value_name = "FIDELITY", default_value = "quick", value_parser = one_of(Fidelity::ALL))]
    pub(super) fidelity: Fidelity,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

impl DrawFlags {
    pub(super) fn threads(&self) -> usize {
        threads(self.threads)
    }
}

/// Ranges other than the paper's.
#[derive(Debug, Args)]
pub(crate) struct WidenFlag {
    /// Takes d, L and D from ranges that are wider by this part: from min/(1 + PART) to max (1 + PART).
    #[arg(long, value_name = "PART", default_value_t = 0.0, value_parser = quantity::number, allow_hyphen_values = true)]
    widen: f64,
}

impl WidenFlag {
    /// The part, 0 to 1.
    ///
    /// # Errors
    /// A part that is out of range.
    pub(super) fn part(&self) -> Result<f64, Fault> {
        if (0.0..=1.0).contains(&self.widen) {
            Ok(self.widen)
        } else {
            Err(Fault::input("--widen: a part from 0 to 1"))
        }
    }
}
