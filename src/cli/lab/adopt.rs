//! `meshcast adopt`: from a mesh's own tests to forecasts, checks and verdicts of its own.

use super::calibrate::data::DataArgs;
use super::draw::DrawFlags;
use crate::cli::VERSION;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Output, wrapped};
use crate::cli::quantity;
use crate::cli::watch::Watch;
use crate::lab::adopt::{
    AdoptFault, AdoptPlan, AdoptStep, MeshWords, RUNS, folder, identifier, remove,
};
use crate::lab::campaign::{EXPECTED_BREAK, FEWEST_FOR_METHOD};
use crate::lab::fit::posterior::IdentifyOptions;
use crate::lab::fit::say::remarks;
use crate::layout::{Blocks, Layout, MethodChoice, REFERENCE};
use crate::mesh::{MeshType, STANDARD_PANEL, STANDARD_PUNCH, Statistic, laws};
use crate::project::home::{Home, typed_path};
use crate::project::{
    MeshUse, NamedLayout, Opened, Overwrite, Project, SaveError, load, parse, write,
};
use crate::show::say;
use crate::units::{Units, shortest, significant, to_kn};
use crate::words::Choice;
use clap::Args;
use std::path::{Path, PathBuf};
use std::sync::Arc;

// One paragraph, which is wrapped as wide as the terminal is.
const AFTER_HELP: &str = "\
All laws that fit the tests are sought, a campaign of random layouts is run with the middle one of them, and a \
method is derived from it. Mesh, wires and method are written into the project, so that it needs nothing else \
elsewhere. Where the laws that fit differ by more than 15 %, no verdict is a plain pass. What is done stands \
beside the project in PROJECT.adopt-NAME until the mesh is written; --resume goes on with it.";

/// Adopt a mesh from its tests: forecasts, checks and verdicts of its own, in a project.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct AdoptArgs {
    /// Project to put it into; made with one layout where there is none.
    #[arg(value_name = "PROJECT.ron")]
    project: PathBuf,
    /// Name of the mesh.
    #[arg(long, value_name = "NAME")]
    name: String,
    /// Force at failure of its punch test.
    #[arg(long, value_name = "KN", value_parser = quantity::test_force, allow_hyphen_values = true, required_unless_present = "curve")]
    force: Option<f64>,
    /// Deflection at failure of its punch test.
    #[arg(long, value_name = "M", value_parser = quantity::length, allow_hyphen_values = true)]
    deflection: Option<f64>,
    /// Side of the test's panel.
    #[arg(long, value_name = "M", default_value_t = STANDARD_PANEL, value_parser = quantity::length, allow_hyphen_values = true)]
    panel: f64,
    /// Diameter of the test's punch.
    #[arg(long, value_name = "M", default_value_t = STANDARD_PUNCH, value_parser = quantity::length, allow_hyphen_values = true)]
    punch: f64,
    /// The values are characteristic ones, not means.
    #[arg(long)]
    characteristic: bool,
    /// The values are made up, to show something.
    #[arg(long)]
    example: bool,
    /// Standard of the test.
    #[arg(long, value_name = "TEXT", default_value = "")]
    standard: String,
    /// Where the values stand.
    #[arg(long, value_name = "TEXT", default_value = "given to meshcast adopt")]
    source: String,
    /// Runs of random layouts in the campaign.
    #[arg(long, value_name = "N", default_value_t = RUNS as u16, value_parser = clap::value_parser!(u16).range(FEWEST_FOR_METHOD as i64..=5000))]
    runs: u16,
    /// Arrangement of blocks that gets a campaign and a map of its own beside repeated blocks; may be given twice.
    #[arg(long, value_name = "BLOCKS", value_parser = one_of(&MORE))]
    blocks: Vec<Blocks>,
    /// Keeps the mesh in your own catalogue too, from which other projects can take it.
    #[arg(long)]
    catalogue: bool,
    /// Goes on with an adoption that was cut off.
    #[arg(long)]
    resume: bool,
    #[command(flatten)]
    draw: DrawFlags,
    #[command(flatten)]
    data: DataArgs,
}

/// Arrangements that may be asked for beside repeated blocks.
const MORE: [Blocks; 2] = [Blocks::Mirrored, Blocks::Single];

/// Finds, runs, derives, and writes into the project.
pub(crate) fn run(args: &AdoptArgs) -> CommandEnd {
    let path = typed_path(&args.project);
    let Some(id) = identifier(&args.name) else {
        return Err(Fault::input("--name: a name needs letters or digits"));
    };
    let mut opened = open(&path, &id, &args.name)?;
    let plan = plan(args, id)?;
    let home = Home::find();
    if args.catalogue {
        own(&home, &plan.words.id)?;
    }
    let folder = folder(&path, &plan.words.id);
    let advice = format!("give --resume to go on with it, or remove {}", folder.display());
    let watch = Watch::start();
    let tell = |step: AdoptStep, now| {
        match step {
            AdoptStep::Laws { scene, trial, of } => {
                let label = format!("{}, trial {trial}", scene.words);
                watch.part(&label, trial.min(of) - 1, of, scene.end());
            }
            AdoptStep::Campaign { blocks, .. } => {
                watch.part(&format!("campaign, {} blocks", blocks.word()), 0, 1, EXPECTED_BREAK);
            }
        }
        watch.tell(now)
    };
    let Some(made) = plan.adopt(&folder, (args.resume, &advice), &tell)? else {
        watch.finish("no mesh is written; --resume goes on with what is done");
        return Ok(Output { interrupted: true, ..Output::default() });
    };
    let [fitted, ran] = made.seconds;
    watch.finish(&format!("laws {fitted:.1} s, campaign and method {ran:.1} s"));
    let mut notes = remarks(&plan.data, &made.found);
    let mesh = Arc::new(made.mesh);
    put(&mut opened, &path, &mesh)?;
    if args.catalogue {
        // The project has it; what is kept on the way can go.
        match home.keep_own_mesh(&mesh) {
            Ok(file) => notes.push(format!("kept in your catalogue too: {}", file.display())),
            Err(why) => notes.push(format!("not kept in your catalogue: {why}")),
        }
    }
    remove(&folder);
    Ok(Output { result: text(&mesh, &path), notes, ..Output::default() })
}

/// Whether the user's own catalogue can take a mesh of this identifier.
fn own(home: &Home, id: &str) -> Result<(), Fault> {
    let Some(file) = home.meshes_file() else {
        return Err(Fault::input("--catalogue: there is no folder for a catalogue of your own"));
    };
    if home.own_meshes()?.iter().any(|mesh| mesh.id == id) {
        return Err(Fault::input(format!(
            "--catalogue: {} has a mesh {id:?} already, which stays; choose another name",
            file.display()
        )));
    }
    Ok(())
}

/// What is asked for.
fn plan(args: &AdoptArgs, id: String) -> Result<AdoptPlan, Fault> {
    let test = [args.force, args.deflection];
    let data = args.data.data(test, [args.panel, args.punch], &laws::reference().net)?;
    let mut more = args.blocks.clone();
    more.sort_by_key(|blocks| blocks.word());
    more.dedup();
    Ok(AdoptPlan {
        words: MeshWords {
            id,
            name: args.name.trim().to_string(),
            example: args.example,
            statistic: if args.characteristic {
                Statistic::Characteristic
            } else {
                Statistic::Mean
            },
            standard: args.standard.clone(),
            source: args.source.clone(),
        },
        data,
        options: IdentifyOptions {
            seed: args.draw.seed,
            fidelity: args.draw.fidelity,
            threads: args.draw.threads(),
        },
        runs: usize::from(args.runs),
        more,
    })
}

impl From<AdoptFault> for Fault {
    fn from(fault: AdoptFault) -> Fault {
        match fault {
            AdoptFault::Problems(problems) => problems.into(),
            AdoptFault::Kept(fault) => fault.into(),
            AdoptFault::Failed(said) => Fault::Failure(said),
        }
    }
}

/// The project, with no mesh of this identifier.
fn open(path: &Path, id: &str, name: &str) -> Result<Opened, Fault> {
    let opened = if path.exists() {
        load(path)?
    } else {
        let text = write::new_project(&name.chars().take(60).collect::<String>());
        parse(&text, "").map_err(|e| Fault::Failure(e.to_string()))?
    };
    if opened.project.find_mesh(id).is_some() {
        return Err(Fault::input(format!(
            "--name: the project or the catalogue has a mesh {id:?} already; choose another name"
        )));
    }
    Ok(opened)
}

/// Puts the mesh into the project, with a layout of it where the project is new, and saves.
fn put(opened: &mut Opened, path: &Path, mesh: &Arc<MeshType>) -> Result<(), Fault> {
    let Opened { document, project } = opened;
    let new = document.path().is_none();
    let held = MeshUse::Inline(mesh.clone());
    if new {
        *project = Project {
            meshes: vec![held],
            layouts: vec![layout(project, &mesh.id)],
            ..project.clone()
        };
    } else {
        project.meshes.push(held);
    }
    let saved = if new {
        document.save_as(path, project, Overwrite::No)
    } else {
        document.save(project, Overwrite::No)
    };
    saved.map(|_| ()).map_err(|e| match e {
        SaveError::Exists(_) | SaveError::ChangedOnDisk(_) => {
            Fault::input(format!("{e}; the mesh is not written"))
        }
        other => Fault::Failure(other.to_string()),
    })
}

/// A first layout: the reference panel, by the mesh's own method.
fn layout(project: &Project, mesh: &str) -> NamedLayout {
    let layout = Layout { method: MethodChoice::Derived, blocks: Blocks::Repeated, ..REFERENCE };
    NamedLayout::new(project.free_name("first layout"), layout, mesh)
}

fn text(mesh: &MeshType, path: &Path) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: &str| {
        lines.extend(wrapped(&format!("{head:<12}"), text, 80));
    };
    line("adopted", &format!("{} ({}) [meshcast {VERSION}]", mesh.title(), mesh.id));
    let lab = &mesh.laboratory;
    let delta = lab.deflection.map_or("not known".into(), |d| format!("{} m", significant(d, 3)));
    line(
        "test",
        &format!(
            "{} kN at {delta} ({}); panel {} m, punch {} m",
            significant(to_kn(lab.force), 4),
            lab.statistic.word(),
            shortest(lab.panel),
            shortest(lab.punch)
        ),
    );
    if let Some(adopted) = &mesh.adopted {
        line("quality", &say::adopted(adopted, Units::METRES));
        for method in adopted.methods.iter().map(|kept| kept.0) {
            let a = &method.alpha;
            let said = format!(
                "{}: alpha_F {} +- {}, alpha_delta {} +- {}; {} runs, {}",
                method.name,
                significant(a.force, 3),
                significant(a.force_error, 1),
                significant(a.deflection, 3),
                significant(a.deflection_error, 1),
                method.runs.used,
                method.fidelity
            );
            line("method", &said);
        }
    }
    line(
        "written",
        &format!("{}; a layout takes it with mesh: {:?}, method: derived", path.display(), mesh.id),
    );
    lines.join("\n") + "\n"
}
