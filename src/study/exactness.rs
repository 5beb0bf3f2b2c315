//! How exactly the runs of an ensemble compute.

use crate::dem::Fidelity;
use crate::units::significant;
use crate::words::Choice;
use serde::{Deserialize, Serialize};

/// One fidelity for all runs, or what the ensemble chooses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Exactness {
    /// Quick runs, as slow as it takes for a mean known to 1 %; one or two runs are standard ones.
    #[default]
    Auto,
    /// All quick.
    Quick,
    /// All standard.
    Standard,
    /// All fine.
    Fine,
    /// All the reference.
    Reference,
}

impl Choice for Exactness {
    const ALL: &'static [Exactness] = &[
        Exactness::Auto,
        Exactness::Quick,
        Exactness::Standard,
        Exactness::Fine,
        Exactness::Reference,
    ];

    fn word(self) -> &'static str {
        match self {
            Exactness::Auto => "auto",
            other => other.fidelity().word(),
        }
    }
}

impl From<Fidelity> for Exactness {
    fn from(fidelity: Fidelity) -> Exactness {
        match fidelity {
            Fidelity::Quick => Exactness::Quick,
            Fidelity::Standard => Exactness::Standard,
            Fidelity::Fine => Exactness::Fine,
            Fidelity::Reference => Exactness::Reference,
        }
    }
}

impl Exactness {
    /// Those that a person waits for; the reference is for comparing the others with it.
    pub(crate) const USUAL: [Exactness; 4] =
        [Exactness::Auto, Exactness::Quick, Exactness::Standard, Exactness::Fine];

    /// The fidelity of a run by itself: what is chosen for an ensemble is standard.
    pub fn fidelity(self) -> Fidelity {
        match self {
            Exactness::Quick => Fidelity::Quick,
            Exactness::Auto | Exactness::Standard => Fidelity::Standard,
            Exactness::Fine => Fidelity::Fine,
            Exactness::Reference => Fidelity::Reference,
        }
    }

    /// What it aims at, in a few words.
    pub(crate) fn about(self) -> String {
        match self {
            Exactness::Auto => "quick runs, as slow as it takes for a mean known to 1 %".into(),
            other => {
                format!("errors within {} %", significant(100.0 * other.fidelity().aim(), 1))
            }
        }
    }

    /// Whether the ensemble chooses.
    pub(crate) fn auto(self) -> bool {
        self == Exactness::Auto
    }
}
