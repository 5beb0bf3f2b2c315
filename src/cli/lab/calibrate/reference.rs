//! `meshcast calibrate --reference-fit`: the wires of the reference mesh, decided by a rule.

use super::{CalibrateArgs, exists};
use crate::cli::VERSION;
use crate::cli::check::threads;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, wrapped};
use crate::cli::watch::Watch;
use crate::cli::written::create;
use crate::dem::Flow;
use crate::lab::fit::family::{LawParameters, WORDS};
use crate::lab::fit::reference::{FitStart, question, search, source, starts};
use crate::lab::fit::rows::{Ended, FitQuestion, FitScene, Measure};
use crate::lab::fit::{FittedLaw, better};
use crate::mesh::wire::WireData;
use crate::project::{SaveError, commented};
use crate::show::value::{Object, Value};
use crate::study::ensemble::EnsembleProgress;
use crate::units::{shortest, significant, to_kn};
use crate::words::Choice;
use std::fmt::Write;
use std::path::Path;
use std::sync::Mutex;

/// Simulations of all rows that a search takes, about.
const USUAL: usize = 30;

/// What the fit found.
struct Decision {
    question: FitQuestion,
    /// The law from each start, in order.
    found: Vec<(&'static FitStart, FittedLaw)>,
    /// Number of the one with the lowest score.
    better: usize,
    command: String,
}

/// Fits from every start and prints all of it.
pub(super) fn run(args: &CalibrateArgs) -> CommandEnd {
    if let Some(path) = args.out.as_ref().filter(|path| path.exists()) {
        return Err(exists(path));
    }
    let question = question(args.fidelity, threads(args.threads));
    let watch = Watch::start();
    let mut found = Vec::new();
    for (number, start) in starts().iter().enumerate() {
        let count = Mutex::new((String::new(), 0));
        let tell = |scene: &FitScene, now: EnsembleProgress| {
            tell(&watch, &count, (number, start), &question, scene, now)
        };
        match search(&question, start, &tell) {
            Ok(Some(law)) => found.push((start, law)),
            Ok(None) => {
                return Err(Fault::Failure(format!("{}: the start cannot be run", start.name)));
            }
            Err(Ended::Bad(problems)) => return Err(problems.into()),
            Err(Ended::Cancelled) => {
                watch.finish("no fit yet");
                return Ok(Output { interrupted: true, ..Output::default() });
            }
        }
    }
    watch.finish("all starts");
    let better = better(found.iter().map(|(_, law)| law));
    let mut command = "meshcast calibrate --reference-fit".to_string();
    if args.fidelity != crate::dem::Fidelity::Standard {
        let _ = write!(command, " --fidelity {}", args.fidelity.word());
    }
    let decision = Decision { question, found, better, command };
    if let Some(path) = &args.out {
        write(path, &decision)?;
    }
    let result = match args.format {
        Format::Text => text(&decision),
        Format::Json => json(&object(&decision))? + "\n",
    };
    Ok(Output { result, ..Output::default() })
}

fn tell(
    watch: &Watch,
    count: &Mutex<(String, usize)>,
    (number, start): (usize, &FitStart),
    question: &FitQuestion,
    scene: &FitScene,
    now: EnsembleProgress,
) -> Flow {
    let scenes = question.scenes.len();
    let done = {
        // A lock is only poisoned by a panic, and the count stays whole.
        let mut count = count.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if count.0 != scene.words {
            *count = (scene.words.clone(), count.1 + 1);
        }
        count.1.max(1) - 1
    };
    let part = number * USUAL * scenes + done.min(USUAL * scenes - 1);
    let label = format!("{}, trial {}: {}", start.name, done / scenes + 1, scene.words);
    watch.part(&label, part, starts().len() * USUAL * scenes, scene.end());
    watch.tell(now)
}

/// The wires of a law with their source.
fn wires(d: &Decision) -> WireData {
    let (start, law) = &d.found[d.better];
    let scores: Vec<String> = d
        .found
        .iter()
        .map(|(start, law)| format!("{} {}", start.name, significant(law.score, 4)))
        .collect();
    let source = format!(
        "Made by `{}`: started from the {} ({}) and kept because its score is the lowest ({}); fitted to {}. Table 1 was not read",
        d.command,
        start.name,
        start.words,
        scores.join(", "),
        source()
    );
    law.law.wire(d.question.net, source)
}

fn write(path: &Path, d: &Decision) -> Result<(), Fault> {
    let comment = format!(
        "Net and wires of the reference mesh for the discrete element check: meshcast check --mesh-file THIS\nLengths m, mass kg, curves (strain, stress in MPa). Made by\n  {}",
        d.command
    );
    let text = commented(&wires(d), &comment)
        .ok_or_else(|| Fault::Failure("the fitted wires cannot be written as RON".into()))?;
    create(path, &text).map_err(|e| match e {
        SaveError::Exists(path) => exists(&path),
        other => Fault::Failure(other.to_string()),
    })
}

/// A value of a row as people read it.
fn shown(measure: Measure, over: bool, value: f64) -> String {
    match measure {
        Measure::Force | Measure::Stiffness if !over => significant(to_kn(value), 4),
        _ => format!("{value:.3}"),
    }
}

fn parameters(law: &LawParameters) -> String {
    let all: Vec<String> =
        WORDS.iter().zip(law.values()).map(|(w, v)| format!("{w} {}", shortest(v))).collect();
    all.join(", ")
}

fn text(d: &Decision) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: &str| {
        lines.extend(wrapped(&format!("{head:<14}"), text, 80));
    };
    line("reference fit", &format!("[meshcast {VERSION}], {}", d.command));
    line("rows", source());
    for (start, fit) in &d.found {
        line(&start.name, &start.words);
        line("", &format!("start: {}", parameters(&fit.start)));
        line("", &format!("found: {}", parameters(&fit.law)));
        let said = format!(
            "score {} at the start, {} at the end, {} simulations of all rows",
            significant(fit.start_score, 4),
            significant(fit.score, 4),
            fit.evaluations
        );
        line("", &said);
    }
    let mut out = lines.join("\n") + "\n\n";
    let heads: Vec<String> = d.found.iter().map(|(s, _)| format!("{:>20}", s.name)).collect();
    let _ = writeln!(out, "{:<36}{:>9} {:>6}{}", "row", "target", "sigma", heads.concat());
    for (k, row) in d.question.rows.iter().enumerate() {
        let of = |value: f64| shown(row.measure, row.over.is_some(), value);
        let cells: Vec<String> = d
            .found
            .iter()
            .map(|(_, fit)| {
                let value = fit.values[k];
                format!("{:>11} ({:+5.1})", of(value), row.residual(value))
            })
            .map(|cell| format!("{cell:>20}"))
            .collect();
        let _ = writeln!(
            out,
            "{:<36}{:>9} {:>6}{}",
            row.label,
            of(row.target),
            shortest(row.sigma),
            cells.concat()
        );
    }
    let (start, _) = d.found[d.better];
    let decided = format!(
        "In brackets: (ours - target)/sigma, in logarithms but for the curve. The score is the sum of their squares. The best law by it: from the {}.",
        start.name
    );
    let _ = write!(out, "\n{}\n", wrapped("", &decided, 80).join("\n"));
    out
}

fn object(d: &Decision) -> Object {
    let law = |l: &LawParameters| {
        let names = ["wire_stress", "wire_strain", "rupture", "twist_stress", "twist_strain"];
        let names = names.into_iter().chain(["lambda_u"]);
        names.zip(l.values()).fold(Object::new(), |o, (name, v)| o.with(name, Value::Exact(v)))
    };
    let of = |(start, fit): &(&FitStart, FittedLaw)| {
        let rows = d.question.rows.iter().zip(&fit.values).map(|(row, value)| {
            Object::new()
                .with("row", row.label.clone())
                .with("target", Value::Exact(row.target))
                .with("sigma", Value::Exact(row.sigma))
                .with("ours", Value::Exact(*value))
                .with("residual", Value::Exact(row.residual(*value)))
        });
        Object::new()
            .with("start", start.name.clone())
            .with("start_law", law(&fit.start))
            .with("start_score", Value::Exact(fit.start_score))
            .with("law", law(&fit.law))
            .with("score", Value::Exact(fit.score))
            .with("simulations", fit.evaluations)
            .with("rows", rows.collect::<Value>())
    };
    Object::new()
        .with("version", VERSION)
        .with("command", d.command.clone())
        .with("source", source())
        .with("better", d.found[d.better].0.name.clone())
        .with("starts", d.found.iter().map(of).collect::<Value>())
}
