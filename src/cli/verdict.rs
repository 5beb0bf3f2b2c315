//! Flags of the verdict, and the exit code it gives.

use super::choice::one_of;
use super::output::{FAILS, NOT_JUDGED};
use crate::study::verdict::{Basis, Finding, Verdict};
use crate::words::Choice;
use clap::Args;

/// How verdicts are made.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct BasisFlag {
    /// Capacity that decides: the mean, or the characteristic value [default: the project's, or mean].
    #[arg(long, value_name = "BASIS", value_parser = one_of(Basis::ALL))]
    basis: Option<Basis>,
}

impl BasisFlag {
    /// Which capacity decides, where the project has one of its own.
    pub(crate) fn basis(&self, project: Basis) -> Basis {
        self.basis.unwrap_or(project)
    }
}

/// How verdicts are made and what the exit code says of them.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct VerdictFlags {
    /// Exit with 3 where a layout fails, with 4 where none fails but one could not be judged.
    #[arg(long)]
    verdict: bool,
    #[command(flatten)]
    basis: BasisFlag,
}

impl VerdictFlags {
    /// Which capacity decides, where the project has one of its own.
    pub(crate) fn basis(&self, project: Basis) -> Basis {
        self.basis.basis(project)
    }

    /// The exit code of these verdicts, where it is asked for and they are no passes.
    pub(crate) fn code<'v>(&self, verdicts: impl Iterator<Item = &'v Verdict>) -> Option<u8> {
        let found: Vec<Finding> = verdicts.map(Verdict::finding).collect();
        match () {
            () if !self.verdict => None,
            () if found.contains(&Finding::Fails) => Some(FAILS),
            () if found.contains(&Finding::NotJudged) => Some(NOT_JUDGED),
            () => None,
        }
    }
}
