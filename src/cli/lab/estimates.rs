//! `meshcast bench --estimate` as a text.

use crate::cli::check::CheckArgs;
use crate::cli::output::{Fault, wrapped};
use crate::dem::SceneSpec;
use crate::lab::estimates::{EstimateSurvey, SMALL_BLOCK};
use crate::project;
use clap::{Args, Command, FromArgMatches};
use std::fmt::Write;
use std::path::Path;

/// The scenes of a file: each line has the flags of a check. Empty lines and those from `#` on are left out.
///
/// # Errors
/// A file that cannot be read, or flags that make no scene.
pub(super) fn listed(path: &Path) -> Result<Vec<SceneSpec>, Fault> {
    let bytes = project::load_table(path, project::LARGEST_FILE)?;
    let text = String::from_utf8_lossy(&bytes);
    let said = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    let scene =
        |line: &str| scene_of(line).map_err(|why| Fault::input(format!("--listed: {line}: {why}")));
    text.lines().filter(said).map(scene).collect()
}

/// The scene of the flags of a check.
fn scene_of(line: &str) -> Result<SceneSpec, String> {
    let command = CheckArgs::augment_args(Command::new("check").no_binary_name(true));
    let found = command.try_get_matches_from(line.split_whitespace());
    let args = found.and_then(|m| CheckArgs::from_arg_matches(&m)).map_err(|e| e.to_string())?;
    args.scene().map_err(|fault| fault.to_string())
}

/// The survey as a text: the counts, then the runs whose estimates are beaten and those that miss their aim.
pub(super) fn text(survey: &EstimateSurvey) -> String {
    let mut out = format!(
        "{} scenes drawn by seed {}; errors are the worst of force, deflection and curve.\n\n\
         fidelity  aim %  runs  beaten  ratio  snaps  large  missed  flagged  silent   rms %  most %  steps  time, s\n",
        survey.scenes, survey.seed
    );
    for c in &survey.counts {
        let [snaps, large] = c.snaps_of_large;
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{:<9} {:>5} {:>5} {:>7} {:>6.2} {:>6} {:>6} {:>7} {:>8} {:>7} {:>7.2} {:>7.2} {:>6} {:>8.2}",
            c.fidelity,
            c.aim_pct,
            c.runs,
            c.beaten,
            c.median_ratio,
            c.snaps,
            format!("{snaps}/{large}"),
            c.misses,
            c.flagged,
            c.unflagged,
            c.rms_pct,
            c.largest_pct,
            c.steps,
            c.seconds
        );
    }
    let legend = format!(
        "beaten: error above the estimate by more than the truth is known to. ratio: estimate over error, median. \
         snaps: runs that say that a snap decides; large: of these with a block of {SMALL_BLOCK} m and more, of \
         how many. missed: error above the aim; flagged: runs that say that they may miss it; silent: missed without \
         saying so. rms and most: of the errors without a snap."
    );
    let _ = write!(out, "\n{}\n", wrapped("", &legend, 80).join("\n"));
    if !survey.unbroken.is_empty() {
        let _ = writeln!(out, "Without a first break, left out: scenes {:?}.", survey.unbroken);
    }
    for row in survey.rows.iter().filter(|r| r.beaten()) {
        let _ = writeln!(
            out,
            "\nbeaten, {}: {:.2} % over {:.2} %, truth known to {:.2} %\n  {}",
            row.fidelity, row.worst, row.estimate, row.known, row.flags
        );
    }
    out
}
