//! `meshcast reproduce`: the paper's figures and tables from our own simulations.

mod map;
mod pictures;
#[cfg(test)]
mod tests;

use super::derive::map_table;
use super::draw::DrawFlags;
use crate::cli::VERSION;
use crate::cli::output::{CommandEnd, Fault, Output};
use crate::cli::watch::Watch;
use crate::cli::written::write_file;
use crate::lab::campaign::EXPECTED_BREAK;
use crate::lab::reproduce::{ReproducePlan, Reproduced, SeriesPoint, reproduce};
use crate::mesh::catalogue;
use crate::project::home::typed_path;
use crate::project::{Overwrite, SaveError};
use crate::study::result::Revisions;
use crate::units::{significant, to_kn};
use crate::words::Choice;
use clap::Args;
use std::fmt::Write;
use std::path::PathBuf;

/// Runs of a point of a laboratory series, and of an anchored test.
const RUNS: [usize; 2] = [4, 16];

const AFTER_HELP: &str = "\
Labels: fitted (the wires were fitted to it), in view (much the same as what they were fitted to), after the fact (the
explanation was found with the value in view), predicted. What differs by more than 5 % and is explained by
no run here is not explained.";

/// Make the paper's figures and tables from our simulations.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct ReproduceArgs {
    /// Folder for the pictures and the text; without it the text alone, to standard output.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Overwrites what the folder has of them.
    #[arg(long, requires = "out")]
    force: bool,
    /// Runs of random layouts for the master curve and the relations.
    #[arg(long, value_name = "N", default_value_t = 320, value_parser = clap::value_parser!(u32).range(60..=100_000))]
    runs: u32,
    #[command(flatten)]
    draw: DrawFlags,
}

/// Makes, writes and prints it.
pub(crate) fn run(args: &ReproduceArgs) -> CommandEnd {
    let plan = ReproducePlan {
        runs: args.runs as usize,
        beside: RUNS,
        every: 1,
        seed: args.draw.seed,
        fidelity: args.draw.fidelity,
        threads: args.draw.threads(),
    };
    let watch = Watch::start();
    let found = reproduce(&plan, &catalogue::reference(), &|words, part, parts, now| {
        watch.part(words, part, parts, EXPECTED_BREAK);
        watch.tell(now)
    })?;
    watch.finish("figures and tables");
    let Some(found) = found else {
        return Ok(Output { interrupted: true, ..Output::default() });
    };
    let text = text(&plan, &found);
    let Some(folder) = &args.out else {
        return Ok(Output { result: text, ..Output::default() });
    };
    let folder = typed_path(folder);
    std::fs::create_dir_all(&folder)
        .map_err(|e| Fault::Failure(format!("--out: {} cannot be made: {e}", folder.display())))?;
    let mut files = vec![("reproduced.txt", text)];
    files.extend(pictures::all(&found));
    let overwrite = if args.force { Overwrite::Yes } else { Overwrite::No };
    let mut written = String::new();
    for (name, content) in files {
        let path = folder.join(name);
        write_file(&path, &content, overwrite).map_err(|e| match e {
            SaveError::Exists(path) => Fault::input(format!(
                "{} exists already and is not overwritten; give --force",
                path.display()
            )),
            other => Fault::Failure(other.to_string()),
        })?;
        let _ = writeln!(written, "{}", path.display());
    }
    Ok(Output { result: written, ..Output::default() })
}

fn text(plan: &ReproducePlan, r: &Reproduced) -> String {
    let mut t = format!(
        "The paper's figures and tables from our simulations [meshcast {VERSION}, {}]\n\
         {} random layouts, seed {}, fidelity {}; ours over the paper's, less 1\n\n",
        Revisions::CURRENT,
        plan.runs,
        plan.seed,
        plan.fidelity.word()
    );
    let _ = writeln!(
        t,
        "{:<10} {:<49} {:>7} {:>7} {:>7}  {:<15} remark",
        "", "", "paper", "ours", "diff %", "label"
    );
    for row in &r.rows {
        let line = format!(
            "{:<10} {:<49} {:>7} {:>7} {:>+7.1}  {:<15} {}",
            row.place,
            row.words,
            significant(row.paper, 3),
            significant(row.ours, 3),
            100.0 * row.difference(),
            row.standing.word(),
            row.remark()
        );
        let _ = writeln!(t, "{}", line.trim_end());
    }
    let yes = |holds: bool| if holds { "holds" } else { "does not hold" };
    let _ = writeln!(
        t,
        "\nFigs. 3, 4  F rises with every step of D from 0.1 to 2.5 m: {}\n\
         Fig. 7a     Eq. 3 lies within our 5 to 95 % envelope at {} of {} inner points\n\
         Figs. 3, 4, 7a, A1 of the paper are pictures without numbers; what its text says of them is above.",
        yes(r.rising),
        r.held[0],
        r.held[1]
    );
    series(&mut t, "Fig. 4: laboratory, L = 3 m", "D, m", &r.over_block);
    series(&mut t, "Fig. 4: laboratory, D = 1 m", "L, m", &r.over_panel);
    t.push_str("\nFig. 7a: envelope of the normalised curves, 5, 50, 95 % and Eq. 3\n");
    let points = &r.method.master.envelope;
    for (i, point) in points.iter().enumerate().step_by(2) {
        let x = i as f64 / (points.len() - 1) as f64;
        let eq3 = crate::forecast::master::force(x);
        let _ = writeln!(
            t,
            "{x:>8.2}  {:>6.3} {:>6.3} {:>6.3}  {eq3:>6.3}",
            point[0], point[1], point[2]
        );
    }
    let _ = writeln!(
        t,
        "\nFig. A1: factors of an offset on F and delta at the reference panel, {} blocks, by {} runs of the \
         campaign; rows ey/L, columns ex/L\n{}",
        r.method.blocks.word(),
        r.method.offsets.runs,
        map_table(&r.method).trim_end()
    );
    t
}

fn series(t: &mut String, title: &str, head: &str, points: &[SeriesPoint]) {
    let _ = writeln!(t, "\n{title}\n{head:>8}   F, kN  delta, m");
    for p in points {
        let _ = writeln!(t, "{:>8.2} {:>7.1} {:>9.3}", p.size, to_kn(p.force), p.deflection);
    }
}
