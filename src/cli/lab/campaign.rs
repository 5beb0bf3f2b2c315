//! `meshcast campaign`: many single runs of random layouts, kept as they are made.

use super::draw::{DrawFlags, WidenFlag};
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Output};
use crate::cli::watch::Watch;
use crate::cli::wire::Wires;
use crate::cli::{case, quantity};
use crate::lab::campaign::kept::{Kept, KeptFault};
use crate::lab::campaign::row::{Kind, Row, RowEnd};
use crate::lab::campaign::{CampaignPlan, EXPECTED_BREAK, Header, PAPER_RANGES};
use crate::layout::Blocks;
use crate::mesh::{REFERENCE_ID, catalogue};
use crate::project::home::typed_path;
use crate::words::Choice;
use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;

const AFTER_HELP: &str = "\
d, L and D are uniform in the paper's ranges (0.16 to 0.48, 1.25 to 4.5, 0.1 to 2.5 m). Offsets are
uniform in the cell. A tenth as many runs of the standard laboratory test and of the reference panel
come first. Runs that slipped or diverged and layouts that cannot be run (block on a plate, mirrored
blocks that overlap) stay in the file with their reason. The file is the same for any number of threads
and however often it was resumed.";

/// Run many random layouts, to derive a method from.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct CampaignArgs {
    /// Folder of the campaign; its file in it is campaign.jsonl.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Goes on with a campaign that was ended, from its last whole line.
    #[arg(long)]
    resume: bool,
    /// How the blocks of the cells stand.
    #[arg(long, value_name = "BLOCKS", default_value = "repeated", value_parser = one_of(&ARRANGED))]
    blocks: Blocks,
    /// Runs of random layouts.
    #[arg(long, value_name = "N", default_value_t = 320, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    runs: u32,
    /// Share of them with an offset, 0 to 0.9.
    #[arg(long, value_name = "PART", default_value_t = 0.5, value_parser = quantity::number, allow_hyphen_values = true)]
    eccentric: f64,
    #[command(flatten)]
    widen: WidenFlag,
    /// Mesh, by its identifier in the catalogue.
    #[arg(long, value_name = "ID", default_value = REFERENCE_ID)]
    mesh: String,
    /// Net and wires from a file instead of the mesh's own.
    #[arg(long, value_name = "FILE")]
    mesh_file: Option<PathBuf>,
    #[command(flatten)]
    draw: DrawFlags,
}

/// Arrangements that a campaign may have.
const ARRANGED: [Blocks; 3] = [Blocks::Repeated, Blocks::Mirrored, Blocks::Single];

/// Makes the lines that are missing and says what the file holds.
pub(crate) fn run(args: &CampaignArgs) -> CommandEnd {
    let plan = plan(args)?;
    let Some(mesh) = catalogue::find(&args.mesh) else {
        let known: Vec<String> = catalogue::all().iter().map(|m| m.id.clone()).collect();
        return Err(Fault::input(case::unknown_mesh("--mesh", &args.mesh, &known)));
    };
    let wire = Wires::read(args.mesh_file.as_deref(), None)?.for_mesh(&mesh)?;
    let header = Header::new(&plan, &args.mesh, &wire);
    let resumed = (args.resume, "give --resume to go on with it, or another --out");
    let mut kept = Kept::open(&typed_path(&args.out), &header, resumed)?;
    let (from, lines) = (kept.rows().len(), plan.lines());
    let watch = Watch::start();
    watch.begin("campaign", 0, 1, EXPECTED_BREAK);
    let tell = |now| watch.tell(now);
    let end = kept.make(&header, &wire, args.draw.threads(), &tell)?;
    let said = format!("{} lines, {:.1} s of processor in runs", lines - from, end.processor);
    watch.finish(&said);
    let mut notes = Vec::new();
    if !end.whole {
        let made = kept.rows().len();
        notes.push(format!("{made} of {lines} lines are made; --resume goes on with them"));
    }
    let result = text(&kept, &header);
    Ok(Output { result, notes, interrupted: !end.whole, ..Output::default() })
}

fn plan(args: &CampaignArgs) -> Result<CampaignPlan, Fault> {
    if !(0.0..=0.9).contains(&args.eccentric) {
        return Err(Fault::input("--eccentric: a share from 0 to 0.9"));
    }
    let wider = 1.0 + args.widen.part()?;
    Ok(CampaignPlan {
        blocks: args.blocks,
        runs: args.runs as usize,
        eccentric: args.eccentric,
        seed: args.draw.seed,
        fidelity: args.draw.fidelity,
        ranges: PAPER_RANGES.map(|[from, to]| [from / wider, to * wider]),
    })
}

impl From<KeptFault> for Fault {
    fn from(fault: KeptFault) -> Fault {
        match fault {
            KeptFault::Asked(said) => Fault::input(said),
            KeptFault::Failed(said) => Fault::Failure(said),
        }
    }
}

/// What the file holds.
fn text(kept: &Kept, header: &Header) -> String {
    let plan = &header.plan;
    let mut out = format!(
        "campaign       {}\nmesh           {}, wires {}\nblocks         {}, fidelity {}, seed {}\nrevisions      {}\n",
        kept.path().display(),
        header.mesh,
        header.wires,
        plan.blocks.word(),
        plan.fidelity.word(),
        plan.seed,
        header.revisions
    );
    let kinds = [
        (Kind::Laboratory, "laboratory"),
        (Kind::Reference, "reference"),
        (Kind::Centred, "centred"),
        (Kind::Eccentric, "eccentric"),
    ];
    for (kind, name) in kinds {
        let rows: Vec<&Row> = kept.rows().iter().filter(|row| row.kind == kind).collect();
        let mut ends: Vec<RowEnd> = rows.iter().map(|row| row.end).collect();
        ends.sort_unstable();
        ends.dedup();
        let counts = ends.iter().map(|end| {
            let n = rows.iter().filter(|row| row.end == *end).count();
            format!("{n} {}", end.words())
        });
        let counts: Vec<String> = counts.collect();
        let _ = writeln!(out, "{name:<15}{} runs: {}", rows.len(), counts.join(", "));
    }
    out
}
