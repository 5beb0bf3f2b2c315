//! `meshcast bench --estimate` as a text.

use crate::cli::output::wrapped;
use crate::lab::estimates::{EstimateSurvey, SMALL_BLOCK};
use std::fmt::Write;

/// The survey as a text: the counts, then the runs whose estimates are beaten and those that miss their aim.
pub(super) fn text(survey: &EstimateSurvey) -> String {
    let mut out = format!(
        "{} scenes drawn by seed {}; errors are the worst of force, deflection and curve.\n\n\
         fidelity  aim %  runs  beaten  median ratio  snaps  large  missed   rms %  most %  steps  time, s\n",
        survey.scenes, survey.seed
    );
    for c in &survey.counts {
        let [snaps, large] = c.snaps_of_large;
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{:<9} {:>5} {:>5} {:>7} {:>13.2} {:>6} {:>6} {:>7} {:>7.2} {:>7.2} {:>6} {:>8.2}",
            c.fidelity,
            c.aim_pct,
            c.runs,
            c.beaten,
            c.median_ratio,
            c.snaps,
            format!("{snaps}/{large}"),
            c.misses,
            c.rms_pct,
            c.largest_pct,
            c.steps,
            c.seconds
        );
    }
    let legend = format!(
        "beaten: error above the estimate by more than the truth is known to. ratio: estimate over error. \
         snaps: runs that say that a snap decides; large: of these with a block of {SMALL_BLOCK} m and more, of \
         how many. missed: error above the aim without saying so. rms and most: of the errors without a snap."
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
