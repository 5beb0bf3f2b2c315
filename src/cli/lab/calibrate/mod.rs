//! `meshcast calibrate`: a wire law that reproduces a mesh's laboratory punch test; with
//! `--reference-fit` the wires of the reference mesh ([`mod@reference`]); with `--coverage` how often what is
//! stated holds ([`coverage`]).

mod coverage;
pub(super) mod data;
mod reference;

use crate::cli::check::threads;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, wrapped};
use crate::cli::watch::Watch;
use crate::cli::written::create;
use crate::cli::{VERSION, quantity, wire};
use crate::dem::{Controls, Fidelity};
use crate::lab::calibrate::{Fit, FitOptions, FitTarget, anchored_reference, fit, unlike_steel};
use crate::lab::paper::ANCHORED;
use crate::mesh::wire::{CurvePoint, WireData};
use crate::mesh::{STANDARD_PANEL, STANDARD_PUNCH, catalogue, laws};
use crate::project::{SaveError, commented};
use crate::show::objects::pair;
use crate::show::value::{Object, Value, kn};
use crate::study::ensemble::{self, Ensemble, Plan, Spread};
use crate::units::{shortest, significant, to_kn};
use crate::words::Choice;
use clap::Args;
use serde::Serialize;
use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;

const AFTER_HELP: &str = "\
Two scales are fitted, on single wire and double twist alike: all stresses (the elastic modulus
stays), and the strains past the first point of the curve. Net, slack, the shapes of the curves and
the ratio of twist to wire are those of --from. The result can be used with check --mesh-file.";

/// Fit a wire law to a laboratory punch test.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct CalibrateArgs {
    /// Force at failure of the test.
    #[arg(long, value_name = "KN", value_parser = quantity::test_force, allow_hyphen_values = true, required_unless_present_any = ["reference_fit", "coverage", "curve"])]
    force: Option<f64>,
    /// Deflection at failure of the test.
    #[arg(long, value_name = "M", value_parser = quantity::length, allow_hyphen_values = true, required_unless_present_any = ["reference_fit", "coverage", "curve"])]
    deflection: Option<f64>,
    /// Side of the test's panel.
    #[arg(long, value_name = "M", default_value_t = STANDARD_PANEL, value_parser = quantity::length, allow_hyphen_values = true)]
    panel: f64,
    /// Diameter of the test's punch.
    #[arg(long, value_name = "M", default_value_t = STANDARD_PUNCH, value_parser = quantity::length, allow_hyphen_values = true)]
    punch: f64,
    /// Fits the reference mesh to all that the paper has but its Table 1, from several starts: some minutes.
    #[arg(long, conflicts_with_all = ["force", "deflection", "panel", "punch", "from", "runs", "seed"])]
    reference_fit: bool,
    /// Draws so many laws, makes a noisy curve of each, and counts how often the range that the curve gives
    /// contains what the law does in the field.
    #[arg(long, value_name = "N", conflicts_with_all = ["force", "deflection", "reference_fit", "runs", "out"], value_parser = clap::value_parser!(u16).range(1..=10_000))]
    coverage: Option<u16>,
    /// What to start from: a mesh of the catalogue, a law (bench, yade, reference) or a mesh file.
    #[arg(long, value_name = "MESH", default_value = "reference")]
    from: String,
    /// Writes the fitted wires to a new file, for check --mesh-file.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Runs of the laboratory ensemble in each trial.
    #[arg(long, value_name = "N", default_value_t = FitOptions::default().runs as u16, value_parser = clap::value_parser!(u16).range(1..=1000))]
    runs: u16,
    /// Seed of alignments and slack.
    #[arg(long, value_name = "S", default_value_t = 0)]
    seed: u64,
    /// How exactly each run is computed.
    #[arg(long, value_name = "FIDELITY", default_value = "standard", value_parser = one_of(Fidelity::ALL))]
    fidelity: Fidelity,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Gives all laws that fit, from a weak and from a strong twist, and what the data hold; so does any flag
    /// of this group.
    #[arg(long, help_heading = "More data")]
    ensemble: bool,
    #[command(flatten)]
    data: data::DataArgs,
}

/// What a calibration found.
struct Result<'a> {
    args: &'a CalibrateArgs,
    fit: Fit,
    target: FitTarget,
    /// What the fitted law says of the anchored reference, which it was not fitted to.
    anchored: Ensemble,
}

/// Fits, predicts and prints.
pub(crate) fn run(args: &CalibrateArgs) -> CommandEnd {
    if args.reference_fit {
        return reference::run(args);
    }
    if let Some(draws) = args.coverage {
        return coverage::run(args, usize::from(draws));
    }
    if args.ensemble || args.data.given() {
        return data::run(args);
    }
    let start = start(&args.from)?;
    if let Some(path) = args.out.as_ref().filter(|path| path.exists()) {
        return Err(exists(path));
    }
    let target = FitTarget {
        // The flags' own rule asks for both.
        force: args.force.unwrap_or_default(),
        deflection: args.deflection.unwrap_or_default(),
        panel: args.panel,
        punch: args.punch,
    };
    let options = FitOptions {
        runs: usize::from(args.runs),
        seed: args.seed,
        fidelity: args.fidelity,
        threads: threads(args.threads),
    };
    let watch = Watch::start();
    // Four trials and the anchored reference are usual.
    let parts = 5;
    let fitted = fit(&start, &target, &options, &|trial, now| {
        watch.part(&format!("trial {}", trial + 1), trial.min(parts - 2), parts, target.deflection);
        watch.tell(now)
    })
    .map_err(|found| {
        Fault::from(found.into_iter().map(|p| p.renamed(FLAGS)).collect::<Vec<_>>())
    })?;
    let Some(mut fit) = fitted else { return interrupted(&watch) };
    fit.wire = rounded(&fit.wire);
    fit.wire.source = source(args, &target, &fit, &start);
    let controls = Controls { fidelity: args.fidelity, after_break: 0.0, ..Controls::default() };
    let plan =
        Plan { runs: None, seed: args.seed, phase: None, auto: false, threads: options.threads };
    watch.begin("anchored reference", parts - 1, parts, ANCHORED[1]);
    let spec = anchored_reference(fit.wire.clone());
    let anchored = ensemble::run(&spec, &controls, &plan, &|now| watch.tell(now))?;
    if watch.cancelled() {
        return interrupted(&watch);
    }
    watch.finish(&format!("{} trials", fit.trials));
    let result = Result { args, fit, target, anchored };
    if let Some(path) = &args.out {
        write_wires(path, &result)?;
    }
    let text = match args.format {
        Format::Text => text(&result),
        Format::Json => {
            json(&ResultJson { object: object(&result), wire: &result.fit.wire })? + "\n"
        }
    };
    let mut notes: Vec<String> = unlike_steel(&result.fit.wire).into_iter().collect();
    if !result.fit.found {
        notes
            .push("the fit did not come within 0.3 % of the test; the nearest law is given".into());
    }
    Ok(Output { result: text, notes, failed: !result.fit.found, ..Output::default() })
}

fn interrupted(watch: &Watch) -> CommandEnd {
    watch.finish("no fit yet");
    Ok(Output { interrupted: true, ..Output::default() })
}

/// The wires to start from.
fn start(from: &str) -> std::result::Result<WireData, Fault> {
    match catalogue::find(from) {
        Some(mesh) => mesh.wire.clone().ok_or_else(|| Fault::input(wire::without_wire(&mesh))),
        None if laws::find(from).is_none() && !from.contains(['.', '/', '\\']) => {
            let known: Vec<String> = catalogue::all().iter().map(|m| m.id.clone()).collect();
            Err(Fault::input(crate::cli::case::unknown_mesh("--from", from, &known)))
        }
        None => wire::named_or_file(from),
    }
}

/// The flags of the test's panel and punch, by the names of their fields.
const FLAGS: &[(&str, &str)] = &[("L", "--panel"), ("D", "--punch")];

/// The curves at seven digits, which is far more than is known of them, so that what is printed and
/// written is what is run.
fn rounded(wire: &WireData) -> WireData {
    let seven = |v: f64| format!("{v:.6e}").parse().unwrap_or(v);
    let curve =
        |points: &[CurvePoint]| points.iter().map(|p| CurvePoint(seven(p.0), seven(p.1))).collect();
    WireData {
        single: curve(&wire.single),
        double_twist: curve(&wire.double_twist),
        ..wire.clone()
    }
}

/// The command that makes this result.
fn command(args: &CalibrateArgs, target: &FitTarget) -> String {
    let mut said = format!(
        "meshcast calibrate --force {} --deflection {}",
        shortest(to_kn(target.force)),
        shortest(target.deflection)
    );
    if args.panel != STANDARD_PANEL {
        let _ = write!(said, " --panel {}", shortest(args.panel));
    }
    if args.punch != STANDARD_PUNCH {
        let _ = write!(said, " --punch {}", shortest(args.punch));
    }
    let usual = FitOptions::default();
    if usize::from(args.runs) != usual.runs {
        let _ = write!(said, " --runs {}", args.runs);
    }
    if args.seed != usual.seed {
        let _ = write!(said, " --seed {}", args.seed);
    }
    if args.fidelity != usual.fidelity {
        let _ = write!(said, " --fidelity {}", args.fidelity.word());
    }
    let _ = write!(said, " --from {}", args.from);
    said
}

/// Where the fitted law comes from.
fn source(args: &CalibrateArgs, target: &FitTarget, fit: &Fit, start: &WireData) -> String {
    format!(
        "Made by `{}`: stresses x {:.4}, strains past the first point x {:.4}, fitted to the laboratory force and deflection, nothing else. Started from: {}",
        command(args, target),
        fit.stress,
        fit.strain,
        start.source
    )
}

fn exists(path: &std::path::Path) -> Fault {
    Fault::input(format!(
        "--out: {} exists already and is not overwritten; choose another name",
        path.display()
    ))
}

fn write_wires(path: &std::path::Path, r: &Result) -> std::result::Result<(), Fault> {
    let comment = format!(
        "Net and wires of a mesh for the discrete element check: meshcast check --mesh-file THIS\nLengths m, mass kg, curves (strain, stress in MPa). Made by\n  {}\nFitted: laboratory {} kN, {} m. Not fitted: all else.",
        command(r.args, &r.target),
        significant(to_kn(r.fit.laboratory.force.mean), 4),
        significant(r.fit.laboratory.deflection.mean, 4)
    );
    let text = commented(&r.fit.wire, &comment)
        .ok_or_else(|| Fault::Failure("the fitted wires cannot be written as RON".into()))?;
    create(path, &text).map_err(|e| match e {
        SaveError::Exists(path) => exists(&path),
        other => Fault::Failure(other.to_string()),
    })
}

/// What was not touched.
fn held(r: &Result) -> Vec<String> {
    let w = &r.fit.wire;
    vec![
        format!("the start: {}", r.args.from),
        "the net, node mass and radius".into(),
        "the shape of both curves and the ratio of twist to wire".into(),
        format!(
            "slack: lambda_u {}, lambda_F {}",
            shortest(w.distortion.lambda_u),
            shortest(w.distortion.lambda_f)
        ),
        "the elastic modulus".into(),
    ]
}

fn text(r: &Result) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: String| {
        lines.extend(wrapped(&format!("{head:<14}"), &text, 80));
    };
    let (a, test) = (r.args, &r.target);
    line("calibration", format!("[meshcast {VERSION}]"));
    line(
        "test",
        format!(
            "{} kN at {} m; panel {} m, punch {} m",
            shortest(to_kn(test.force)),
            shortest(test.deflection),
            shortest(test.panel),
            shortest(test.punch)
        ),
    );
    line("FITTED", format!("stress scale {:.4}, strain scale {:.4}", r.fit.stress, r.fit.strain));
    line("held fixed", held(r).join("; "));
    let said = |force: &Spread, deflection: &Spread| {
        format!(
            "{} +- {} kN at {:.3} +- {:.3} m",
            significant(to_kn(force.mean), 3),
            significant(to_kn(force.deviation), 2),
            deflection.mean,
            deflection.deviation
        )
    };
    let lab = &r.fit.laboratory;
    line(
        "laboratory",
        format!(
            "{} ({} runs, {} trials); residual {:+.2} % on force, {:+.2} % on deflection; standard error {:.2} % and {:.2} %",
            said(&lab.force, &lab.deflection),
            lab.runs.len(),
            r.fit.trials,
            100.0 * r.fit.residual[0],
            100.0 * r.fit.residual[1],
            100.0 * lab.force.error / lab.force.mean,
            100.0 * lab.deflection.error / lab.deflection.mean,
        ),
    );
    let e = &r.anchored;
    line(
        "PREDICTED",
        format!(
            "anchored reference (d 0.32, L 3, D 1 m): {} ({} runs); standard error {:.2} %; for the double-twist reference mesh the paper has {} kN at {} m",
            said(&e.force, &e.deflection),
            e.runs.len(),
            100.0 * e.force.error / e.force.mean,
            to_kn(ANCHORED[0]),
            ANCHORED[1]
        ),
    );
    let curve = |points: &[CurvePoint]| {
        let all: Vec<String> =
            points.iter().map(|p| format!("({}, {})", shortest(p.0), shortest(p.1))).collect();
        all.join(" ")
    };
    line("single wire", curve(&r.fit.wire.single));
    line("double twist", curve(&r.fit.wire.double_twist));
    line("source", r.fit.wire.source.clone());
    if let Some(said) = unlike_steel(&r.fit.wire) {
        line("caution", said);
    }
    if let Some(path) = &a.out {
        line("written", path.display().to_string());
    }
    lines.join("\n") + "\n"
}

/// The result as JSON, with the wires as a mesh file has them.
#[derive(Serialize)]
struct ResultJson<'a> {
    #[serde(flatten)]
    object: Object,
    wire: &'a WireData,
}

fn object(r: &Result) -> Object {
    let test = Object::new()
        .with("F_kN", kn(r.target.force))
        .with("delta_m", Value::Exact(r.target.deflection))
        .with("panel_m", Value::Exact(r.args.panel))
        .with("punch_m", Value::Exact(r.args.punch));
    let fit = Object::new()
        .with("stress_scale", Value::Exact(r.fit.stress))
        .with("strain_scale", Value::Exact(r.fit.strain))
        .with("runs", r.fit.laboratory.runs.len())
        .with("trials", r.fit.trials)
        .with("found", r.fit.found);
    let residual = Object::new()
        .with("F_pct", Value::Exact(100.0 * r.fit.residual[0]))
        .with("delta_pct", Value::Exact(100.0 * r.fit.residual[1]));
    let both = |e: &Ensemble, part: fn(&Spread) -> f64| pair(part(&e.force), part(&e.deflection));
    Object::new()
        .with("version", VERSION)
        .with("command", command(r.args, &r.target))
        .with("from", r.args.from.clone())
        .with("test", test)
        .with("fit", fit)
        .with("held_fixed", held(r).into_iter().map(Value::from).collect::<Value>())
        .with("laboratory", both(&r.fit.laboratory, |s| s.mean))
        .with("laboratory_standard_error", both(&r.fit.laboratory, |s| s.error))
        .with("residual", residual)
        .with("anchored_reference", both(&r.anchored, |s| s.mean))
        .with("anchored_reference_standard_error", both(&r.anchored, |s| s.error))
        .with("anchored_reference_runs", r.anchored.runs.len())
        .with("caution", unlike_steel(&r.fit.wire))
}
