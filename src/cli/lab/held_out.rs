//! `meshcast held-out`: forecasts against checks of layouts that no fit has seen.

use super::draw::WidenFlag;
use crate::cli::check::threads;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Output};
use crate::cli::watch::Watch;
use crate::dem::{Fidelity, Flow};
use crate::lab::campaign::EXPECTED_BREAK;
use crate::lab::held_out::{AIMS, HeldOutPlan, HeldOutTable, Points, SMALL, held_out};
use crate::layout::Blocks;
use crate::mesh::catalogue;
use crate::study::result::Revisions;
use crate::study::result::make::Told;
use crate::words::Choice;
use clap::Args;
use std::fmt::Write;
use std::num::NonZeroUsize;

const AFTER_HELP: &str = "\
Layouts are drawn as a campaign draws them, half of them with an offset, and checked with as many runs as a
check makes. A seed that a method was made from is refused.";

/// Compare both methods of forecasting with checks of random layouts.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct HeldOutArgs {
    /// Layouts that are drawn.
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u16).range(1..=10_000))]
    layouts: u16,
    /// How their blocks stand.
    #[arg(long, value_name = "BLOCKS", default_value = "repeated", value_parser = one_of(&[Blocks::Repeated, Blocks::Mirrored]))]
    blocks: Blocks,
    /// Seed of layouts, alignments and slack.
    #[arg(long, value_name = "S")]
    seed: u64,
    #[command(flatten)]
    widen: WidenFlag,
    /// Draws blocks below 0.4 m only: of all that are drawn they are few.
    #[arg(long)]
    small: bool,
    /// How exactly the checks compute.
    #[arg(long, value_name = "FIDELITY", default_value = "quick", value_parser = one_of(Fidelity::ALL))]
    fidelity: Fidelity,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
}

/// Checks and prints the table.
pub(crate) fn run(args: &HeldOutArgs) -> CommandEnd {
    let plan = HeldOutPlan {
        layouts: usize::from(args.layouts),
        blocks: args.blocks,
        seed: args.seed,
        fidelity: args.fidelity,
        widen: args.widen.part()?,
        small: args.small,
        threads: threads(args.threads),
    };
    let watch = Watch::start();
    let tell = |layout: usize, told: Told| {
        let Told::Progress(now) = told else { return Flow::Continue };
        watch.part(&format!("layout {}", layout + 1), layout, plan.layouts, EXPECTED_BREAK);
        watch.tell(now)
    };
    let table = held_out(&plan, &catalogue::reference(), &tell)?;
    watch.finish(&format!("{} layouts", table.drawn));
    let result = text(&plan, &table);
    Ok(Output { result, interrupted: table.part, ..Output::default() })
}

fn text(plan: &HeldOutPlan, table: &HeldOutTable) -> String {
    let mut t = format!(
        "held-out layouts: {} drawn of {}, seed {}, {} blocks, fidelity {}, {}",
        table.drawn,
        plan.layouts,
        plan.seed,
        plan.blocks.word(),
        plan.fidelity.word(),
        Revisions::CURRENT
    );
    if plan.widen > 0.0 {
        let _ = write!(t, ", ranges wider by {:.0} %", 100.0 * plan.widen);
    }
    if plan.small {
        let _ = write!(t, ", blocks below {SMALL} m");
    }
    let left: usize = table.left_out.values().sum();
    let share = 100.0 * left as f64 / table.drawn.max(1) as f64;
    let _ = write!(t, "\nleft out: {left} ({share:.0} %)");
    for (why, n) in &table.left_out {
        let _ = write!(t, ", {n} {why}");
    }
    t.push_str("\n\ncheck over forecast: 10, 50, 90 % of the layouts\n");
    let _ = writeln!(
        t,
        "{:<32}{:>4}   {:<20}{:<20}   {:<20}published delta",
        "", "n", "derived F", "derived delta", "published F"
    );
    for part in table.parts() {
        let three = |v: [f64; 3]| match part.n {
            0 => format!("{:<20}", "-"),
            _ => format!("{:<20}", v.map(|x| format!("{x:.3}")).join(" ")),
        };
        let both = |p: &Points| three(p.force) + &three(p.deflection);
        let [derived, published] = &part.points;
        let line =
            format!("{:<32}{:>4}   {}   {}", part.words, part.n, both(derived), both(published));
        let _ = writeln!(t, "{}", line.trim_end());
    }
    t.push_str("\nforce, median and 90 % of the layouts: standard error of a check's mean; scatter of its single runs\n");
    for part in table.parts().iter().filter(|part| part.n > 0 && part.words.contains("D ")) {
        let [error, scatter] = part
            .errors
            .map(|[median, high]| format!("{:.1} %, {:.1} %", 100.0 * median, 100.0 * high));
        let _ = writeln!(t, "  {:<32}{error}; {scatter}", part.words);
    }
    t.push_str("\naims for the middle 80 % of check over derived forecast:");
    for (words, [low, high]) in ["centred", "with an offset"].iter().zip(AIMS) {
        let part = table.parts().into_iter().find(|part| part.words == *words);
        let Some(part) = part.filter(|part| part.n > 0) else { continue };
        let met = |v: [f64; 3]| if v[0] >= low && v[2] <= high { "met" } else { "MISSED" };
        let Points { force, deflection } = part.points[0];
        let _ = write!(t, " {words} {low} to {high}: F {}, delta {};", met(force), met(deflection));
    }
    t.pop();
    t.push('\n');
    t
}
