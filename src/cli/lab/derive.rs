//! `meshcast derive`: a method from the runs of campaigns.

use crate::cli::output::{CommandEnd, Fault, Output};
use crate::cli::written::create;
use crate::lab::campaign::file::{self, CampaignText};
use crate::lab::derive::derive;
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::method::offset::ThroughForm;
use crate::method::sizes::PUBLISHED;
use crate::method::{Anchor, DerivedMethod};
use crate::project::home::typed_path;
use crate::project::{self, SaveError};
use crate::units::{significant, to_kn};
use clap::Args;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Largest table of a campaign, bytes: some hundred thousand runs.
const LARGEST_TABLE: u64 = 64 * 1024 * 1024;

const AFTER_HELP: &str = "\
Everything comes from the campaigns' runs by least squares: the ratios of the anchored reference to the
laboratory, size relations in the published form and in the best of several forms (by fits that did not
see the runs they are judged by), what an offset does, the master curve with its envelope, and the scatter.
No value of the paper is in any fit.";

/// Derive a method of forecasts from campaigns.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct DeriveArgs {
    /// Folders of whole campaigns with one mesh, arrangement and solver, of different seeds.
    #[arg(value_name = "DIR", required = true)]
    campaigns: Vec<PathBuf>,
    /// Writes the method to a new file.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// Derives, writes and says what came out.
pub(crate) fn run(args: &DeriveArgs) -> CommandEnd {
    if let Some(path) = args.out.as_ref().filter(|path| path.exists()) {
        return Err(exists(path));
    }
    let all = args.campaigns.iter().map(|folder| read(&typed_path(folder)));
    let campaigns = all.collect::<Result<Vec<CampaignText>, Fault>>()?;
    let method = derive(&campaigns).map_err(Fault::input)?;
    if let Some(path) = &args.out {
        write(&typed_path(path), &method)?;
    }
    Ok(Output { result: text(&method, args.out.as_deref()), ..Output::default() })
}

fn read(folder: &Path) -> Result<CampaignText, Fault> {
    let path = folder.join(file::NAME);
    let bytes = project::load_table(&path, LARGEST_TABLE)?;
    match file::read(&bytes) {
        Ok(Some(found)) => Ok(found),
        Ok(None) => Err(Fault::input(format!("{}: there is nothing in it yet", path.display()))),
        Err(said) => Err(Fault::input(format!("{}: {said}", path.display()))),
    }
}

fn exists(path: &Path) -> Fault {
    Fault::input(format!(
        "--out: {} exists already and is not overwritten; choose another name",
        path.display()
    ))
}

fn write(path: &Path, method: &DerivedMethod) -> Result<(), Fault> {
    let text = project::method_text(method)
        .ok_or_else(|| Fault::Failure("the method cannot be written as RON".into()))?;
    create(path, &text).map_err(|e| match e {
        SaveError::Exists(path) => exists(&path),
        other => Fault::Failure(other.to_string()),
    })
}

/// The factors over the reference panel; a place on a plate has none.
pub(super) fn map_table(m: &DerivedMethod) -> String {
    let parts = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5];
    let mut t = format!("  {:>4}", "");
    for x in parts {
        let _ = write!(t, "  {x:>9}");
    }
    for y in parts.iter().rev() {
        let _ = write!(t, "\n  {y:>4}");
        for x in parts {
            let side = REFERENCE.spacing;
            let layout = Layout { ex: x * side, ey: y * side, blocks: m.blocks, ..REFERENCE };
            let overlap = m.blocks == Blocks::Mirrored && layout.blocks_overlap().is_some();
            let f = m.offsets.at(&layout, &m.sizes.at(&layout));
            let _ = match (layout.punch_on_plate(), overlap) {
                (true, _) => write!(t, "  {:>9}", "plate"),
                (_, true) => write!(t, "  {:>9}", "overlap"),
                _ => write!(t, "  {:>4.2} {:>4.2}", f.force, f.deflection),
            };
        }
    }
    t + "\n"
}

/// The method for people, beside the published one.
fn text(m: &DerivedMethod, out: Option<&Path>) -> String {
    let mut t = String::new();
    let mut line = |head: &str, text: String| {
        let _ = writeln!(t, "{head:<22}{text}");
    };
    line("method", format!("{}, fidelity {}, {}", m.name, m.fidelity, m.revisions));
    let c = &m.runs;
    let left: Vec<String> = c.left_out.iter().map(|(why, n)| format!(", {n} {why}")).collect();
    line(
        "runs",
        format!(
            "{} asked, {} used, {} slipped, {} diverged{}",
            c.asked,
            c.used,
            c.slipped,
            c.diverged,
            left.concat()
        ),
    );
    let anchor = |a: &Anchor| {
        format!(
            "{} +- {} kN, {} +- {} m ({} runs)",
            significant(to_kn(a.force), 4),
            significant(to_kn(a.force_error), 2),
            significant(a.deflection, 4),
            significant(a.deflection_error, 2),
            a.runs
        )
    };
    line("laboratory", anchor(&m.laboratory));
    line("reference", anchor(&m.reference));
    let a = &m.alpha;
    line(
        "alpha_F",
        format!(
            "{} +- {} (published 0.40)",
            significant(a.force, 4),
            significant(a.force_error, 2)
        ),
    );
    line(
        "alpha_delta",
        format!(
            "{} +- {} (1.08)",
            significant(a.deflection, 4),
            significant(a.deflection_error, 2)
        ),
    );
    let (r, p) = (&m.refitted, &PUBLISHED);
    let list = |v: &[f64]| v.iter().map(|x| format!("{x:.3}")).collect::<Vec<_>>().join(", ");
    line("A.1 refitted", "D <= d: f D; D > d: f D + 1 - f; f d + f; f L + 1 - f".into());
    let force = |q: &crate::method::sizes::Product| {
        list(&[q.force_small, q.force_large, q.force_plate[0], q.force_plate[1], q.force_spacing])
    };
    line("", format!("{} (published {})", force(r), force(p)));
    line("A.2 refitted", "D <= d: f D + f; D > d: f D^2 + f D + f; f d + 1 - f".into());
    let deflection = |q: &crate::method::sizes::Product| {
        let all = [&q.deflection_small[..], &q.deflection_large[..], &[q.deflection_plate]];
        list(&all.concat())
    };
    line("", format!("{} (published {})", deflection(r), deflection(p)));
    line("relations used", m.sizes.form.clone());
    line(
        "threshold D, m",
        format!("{} at d = 0.16, 0.32, 0.48 m, L = 3 m", list(&m.sizes.threshold)),
    );
    line("master curve", format!("{} (published 1.312, -0.385, 0.073)", list(&m.master.cubic)));
    line("  fitted freely", list(&m.master.free));
    let s = &m.scatter;
    line(
        "scatter V",
        format!(
            "of F and delta: block decides {}, anchors {}; with an offset {}, {}",
            list(&s.small),
            list(&s.large),
            list(&s.small_offset),
            list(&s.large_offset)
        ),
    );
    let [force, deflection] = m.offsets.through.map(|form| match form {
        ThroughForm::Cosines => "cosines to 2",
        ThroughForm::BySize => "by d, L, D as well",
    });
    let (runs, cosines) = (m.offsets.runs, m.offsets.harmonics);
    line("offsets", format!("{runs} runs, cosines to {cosines}"));
    line("  of small blocks", format!("force {force}, deflection {deflection}"));
    t.push_str(
        "\nfactors of an offset on F and delta at the reference panel; rows ey/L, columns ex/L\n",
    );
    t.push_str(&map_table(m));
    t.push_str(
        "\nerror of a run by fits that did not see it, F delta: D below 0.4 m, from 0.4 m\n",
    );
    for e in &m.compared {
        let _ = writeln!(t, "  {}; {}   {}", list(&e.below), list(&e.above), e.form);
    }
    t.push_str("\nrun over method by fits that did not see it: 10, 50, 90 % of F; of delta\n");
    for h in &m.cross_validated {
        let _ = writeln!(t, "  {}; {}   {} ({})", list(&h.force), list(&h.deflection), h.part, h.n);
    }
    if let Some(path) = out {
        let _ = writeln!(t, "\nwritten  {}", path.display());
    }
    t
}
