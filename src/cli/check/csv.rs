//! The curves of a check as CSV: a header with the units, then one line a point. Runs count from 1.

use super::Checked;
use crate::cli::output::quoted;
use crate::units::{to_kn, without_noise};
use std::fmt::Write;

/// The table; several layouts share it, with the layout's name in front.
pub(crate) fn report(checked: &[Checked], several: bool) -> String {
    let mut out =
        String::from(if several { "layout,run,delta_m,F_kN\n" } else { "run,delta_m,F_kN\n" });
    for c in checked {
        let name = match &c.name {
            Some(name) if several => format!("{},", quoted(name)),
            _ => String::new(),
        };
        for (k, run) in c.ensemble.runs.iter().enumerate() {
            for point in run.outcome.curve.points() {
                let (delta, force) =
                    (without_noise(point.deflection), without_noise(to_kn(point.force)));
                // Writing to a string cannot fail.
                let _ = writeln!(out, "{name}{},{delta},{force}", k + 1);
            }
        }
    }
    out
}
