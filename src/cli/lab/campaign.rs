//! `meshcast campaign`: many single runs of random layouts, kept as they are made.

use super::draw::{DrawFlags, EXPECTED_BREAK, WidenFlag};
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Output};
use crate::cli::watch::Watch;
use crate::cli::wire::Wires;
use crate::cli::{case, quantity};
use crate::dem::Flow;
use crate::lab::campaign::file::{self, CampaignText};
use crate::lab::campaign::make::make;
use crate::lab::campaign::row::{Kind, Row, RowEnd};
use crate::lab::campaign::{CampaignPlan, Header, PAPER_RANGES};
use crate::layout::Blocks;
use crate::mesh::{REFERENCE_ID, catalogue};
use crate::project::home::typed_path;
use crate::words::Choice;
use clap::Args;
use std::fmt::Write as _;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

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
    let mut kept = Kept::open(&typed_path(&args.out), &header, args.resume)?;
    let (from, lines) = (kept.rows.len(), plan.lines());
    let watch = Watch::start();
    watch.begin("campaign", 0, 1, EXPECTED_BREAK);
    let mut failed = None;
    let Kept { file, rows, .. } = &mut kept;
    let mut hand_on = |row: Row| {
        let written = file.write_all(file::line(&row).as_bytes());
        rows.push(row);
        match written {
            Ok(()) => Flow::Continue,
            Err(e) => {
                failed = Some(e);
                Flow::Cancel
            }
        }
    };
    let tell = |now| watch.tell(now);
    let end = make(&plan, &wire, from, args.draw.threads(), &tell, &mut hand_on);
    let synced = file.sync_all();
    if let Some(e) = failed.or(synced.err()) {
        return Err(kept.fault("cannot be written", &e));
    }
    let said = format!("{} lines, {:.1} s of processor in runs", lines - from, end.processor);
    watch.finish(&said);
    let mut notes = Vec::new();
    if !end.whole {
        let made = kept.rows.len();
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

/// A campaign's file, open to be written at its end, and what stands in it.
struct Kept {
    path: PathBuf,
    file: File,
    rows: Vec<Row>,
}

impl Kept {
    /// Opens the file in a folder, new or to be gone on with.
    fn open(folder: &Path, header: &Header, resume: bool) -> Result<Kept, Fault> {
        let path = folder.join(file::NAME);
        std::fs::create_dir_all(folder).map_err(|e| {
            Fault::Failure(format!("--out: {} cannot be made: {e}", folder.display()))
        })?;
        let mut options = OpenOptions::new();
        options.read(true).write(true).create(true);
        let file = options.open(&path);
        let file = file.map_err(|e| refused(&path, "cannot be opened", &e))?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                let said = format!("{}: another meshcast writes this campaign", path.display());
                return Err(Fault::input(said));
            }
            // A disk that locks nothing is no reason to refuse.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let mut kept = Kept { path, file, rows: Vec::new() };
        kept.go_on(header, resume)?;
        Ok(kept)
    }

    /// Reads what is there, cuts off a torn line, and stands behind the last whole one.
    fn go_on(&mut self, header: &Header, resume: bool) -> Result<(), Fault> {
        let mut text = Vec::new();
        self.file.read_to_end(&mut text).map_err(|e| self.fault("cannot be read", &e))?;
        if !text.is_empty() && !resume {
            return Err(Fault::input(format!(
                "{} exists already and is not overwritten; give --resume to go on with it, or another --out",
                self.path.display()
            )));
        }
        let found = file::read(&text).map_err(|said| self.wrong(&said))?;
        let whole = found.as_ref().map_or(0, |found| found.whole);
        if let Some(CampaignText { header: there, rows, .. }) = found {
            if let Some(said) = there.differs(header) {
                return Err(self.wrong(&format!("it was made otherwise: {said}")));
            }
            if rows.len() > header.plan.lines() {
                return Err(self.wrong("it has more lines than it should"));
            }
            self.rows = rows;
        }
        let cut = self.file.set_len(whole as u64);
        cut.and_then(|()| self.file.seek(SeekFrom::End(0)).map(|_| ()))
            .and_then(|()| if whole == 0 { self.write_header(header) } else { Ok(()) })
            .map_err(|e| self.fault("cannot be written", &e))
    }

    fn write_header(&mut self, header: &Header) -> io::Result<()> {
        self.file.write_all(file::line(header).as_bytes())
    }

    fn wrong(&self, said: &str) -> Fault {
        Fault::input(format!("{}: {said}", self.path.display()))
    }

    fn fault(&self, what: &str, error: &io::Error) -> Fault {
        refused(&self.path, what, error)
    }
}

fn refused(path: &Path, what: &str, error: &io::Error) -> Fault {
    Fault::Failure(format!("{} {what}: {error}", path.display()))
}

/// What the file holds.
fn text(kept: &Kept, header: &Header) -> String {
    let plan = &header.plan;
    let mut out = format!(
        "campaign       {}\nmesh           {}, wires {}\nblocks         {}, fidelity {}, seed {}\nrevisions      {}\n",
        kept.path.display(),
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
        let rows: Vec<&Row> = kept.rows.iter().filter(|row| row.kind == kind).collect();
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
