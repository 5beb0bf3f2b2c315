//! The `:campaign` command: hundreds of runs of random layouts with the selected layout's mesh, and the method
//! derived from them.

use super::App;
use super::message::Command;
use crate::dem::Fidelity;
use crate::job::method::MethodJob;
use crate::job::order::Task;
use crate::lab::campaign::{CampaignPlan, FEWEST_FOR_METHOD};
use crate::layout::Blocks;
use crate::project::home::typed_path;
use crate::words::Choice;
use std::path::Path;

/// Most runs that are taken for meant.
const MOST_RUNS: usize = 1_000_000;

impl App {
    /// Starts a campaign or goes on with it: `campaign [RUNS] [BLOCKS] [FIDELITY] FOLDER`.
    ///
    /// # Errors
    /// Why it cannot be started.
    pub(super) fn campaign_command(&mut self, text: &str) -> Result<Vec<Command>, String> {
        let mesh = self.result().mesh().cloned().ok_or("this layout's mesh is not known")?;
        if mesh.wire.is_none() {
            return Err(format!("{} has no net and wires to simulate", mesh.id));
        }
        let (plan, folder) = asked(text)?;
        let folder = typed_path(Path::new(folder));
        // No message: it would stand until the next key where the progress belongs.
        let job = MethodJob { folder, plan, mesh };
        Ok(vec![self.work.start_steps("campaign", Task::Method(job))])
    }
}

/// What was asked for: words that are known stand before the folder, which may have blanks.
fn asked(text: &str) -> Result<(CampaignPlan, &str), String> {
    let mut plan = CampaignPlan::default();
    let mut rest = text;
    while let Some((word, after)) = rest.split_once(char::is_whitespace) {
        if let Ok(runs) = word.parse::<usize>() {
            if !(FEWEST_FOR_METHOD..=MOST_RUNS).contains(&runs) {
                return Err(format!(
                    "runs: {FEWEST_FOR_METHOD} to {MOST_RUNS}; fewer give no method"
                ));
            }
            plan.runs = runs;
        } else if let Some(fidelity) = Fidelity::from_word(word) {
            plan.fidelity = fidelity;
        } else if let Some(blocks) = Blocks::from_word(word) {
            if matches!(blocks, Blocks::Paper | Blocks::Worst) {
                return Err("a campaign is of blocks repeated, mirrored or single".into());
            }
            plan.blocks = blocks;
        } else {
            break;
        }
        rest = after.trim_start();
    }
    if rest.is_empty() {
        return Err("campaign [RUNS] [BLOCKS] [FIDELITY] FOLDER".into());
    }
    Ok((plan, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_words_stand_before_the_folder() {
        let (plan, folder) = asked("64 mirrored standard my runs").unwrap();
        assert_eq!((plan.runs, plan.blocks, folder), (64, Blocks::Mirrored, "my runs"));
        assert_eq!(plan.fidelity, Fidelity::Standard);
        assert_eq!(asked("runs").unwrap(), (CampaignPlan::default(), "runs"));
        for wrong in ["", "0 x", "40 x", "worst x"] {
            assert!(asked(wrong).is_err(), "{wrong}");
        }
    }
}
