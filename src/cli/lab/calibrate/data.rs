//! `meshcast calibrate` with more than one punch test's force and deflection: the laws that fit all that is
//! told of a mesh.

use super::{CalibrateArgs, exists};
use crate::cli::VERSION;
use crate::cli::check::threads;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, wrapped};
use crate::cli::quantity;
use crate::cli::watch::Watch;
use crate::cli::written::create;
use crate::dem::{Fidelity, Flow};
use crate::lab::adopt::NO_LAW;
use crate::lab::fit::curve::{LabCurve, told};
use crate::lab::fit::data::{FirstBond, MeshData};
use crate::lab::fit::family::WORDS;
use crate::lab::fit::posterior::{Identified, IdentifyOptions, SIMULATIONS, START_WORDS, identify};
use crate::lab::fit::rows::{Ended, FitScene};
use crate::lab::fit::say::{Trials, remarks, shown, wire};
use crate::lab::fit::sheet::Sheet;
use crate::mesh::wire::{NetGeometry, WireData};
use crate::project::{self, SaveError, commented};
use crate::show::value::{Object, Value};
use crate::study::ensemble::EnsembleProgress;
use crate::units::{from_kn, shortest, significant, to_kn};
use crate::words::Choice;
use clap::Args;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// What else is known of the mesh.
#[derive(Debug, Args, Clone, Default)]
pub(crate) struct DataArgs {
    /// The test's whole curve: a table with a header such as deflection_mm,force_kN.
    #[arg(long, value_name = "FILE", help_heading = "More data")]
    curve: Option<PathBuf>,
    /// Stiffness of the test at 75 % of its force, by the tangent, kN/m.
    #[arg(long, value_name = "KN/M", value_parser = quantity::number, help_heading = "More data")]
    k75: Option<f64>,
    /// Another punch test of the mesh, each number as the flags take it; may be repeated.
    #[arg(long, value_name = "FORCE,DEFLECTION,PANEL,PUNCH", value_parser = another, help_heading = "More data")]
    another: Vec<[f64; 4]>,
    /// Strength of the net along its twists, kN/m; each strength takes a minute more.
    #[arg(long, value_name = "KN/M", value_parser = quantity::number, help_heading = "More data")]
    strength_along: Option<f64>,
    /// Strength of the net across its twists, kN/m.
    #[arg(long, value_name = "KN/M", value_parser = quantity::number, help_heading = "More data")]
    strength_across: Option<f64>,
    /// Width and length of the piece that was pulled.
    #[arg(long, value_name = "WIDTH,LENGTH", value_parser = quantity::sides, default_value = "1,1", help_heading = "More data")]
    piece: quantity::Sides,
    /// Strength of the wire, MPa.
    #[arg(long, value_name = "MPA", value_parser = quantity::number, help_heading = "More data")]
    wire_strength: Option<f64>,
    /// Elongation of the wire at rupture, %.
    #[arg(long, value_name = "PERCENT", value_parser = quantity::number, help_heading = "More data")]
    wire_elongation: Option<f64>,
    /// Which bond breaks first in the test.
    #[arg(long, value_name = "BOND", value_parser = one_of(FirstBond::ALL), help_heading = "More data")]
    breaks: Option<FirstBond>,
    /// Opening of the mesh, across the twists, instead of that of --from.
    #[arg(long, value_name = "M", value_parser = quantity::length, help_heading = "More data")]
    opening: Option<f64>,
    /// Length of a double twist.
    #[arg(long, value_name = "M", value_parser = quantity::length, help_heading = "More data")]
    twist: Option<f64>,
    /// Diameter of the wire.
    #[arg(long, value_name = "M", value_parser = quantity::length, help_heading = "More data")]
    diameter: Option<f64>,
}

fn another(text: &str) -> Result<[f64; 4], String> {
    let what = "force, deflection, panel, punch, such as 55,0.5,2,1";
    let [force, deflection, panel, punch] = quantity::parts(text, what)?;
    Ok([
        quantity::test_force(force)?,
        quantity::length(deflection)?,
        quantity::length(panel)?,
        quantity::length(punch)?,
    ])
}

impl DataArgs {
    /// Whether anything of the group was given.
    pub(super) fn given(&self) -> bool {
        let flags = [self.curve.is_some(), !self.another.is_empty(), self.breaks.is_some()];
        let numbers = [
            self.k75,
            self.strength_along,
            self.strength_across,
            self.wire_strength,
            self.wire_elongation,
            self.opening,
            self.twist,
            self.diameter,
        ];
        flags.contains(&true) || numbers.iter().any(Option::is_some)
    }

    /// What was told beside a punch test, given by its force and deflection, panel and punch; or what is
    /// wrong with it.
    pub(in crate::cli::lab) fn data(
        &self,
        [force, deflection]: [Option<f64>; 2],
        [panel, punch]: [f64; 2],
        start: &NetGeometry,
    ) -> Result<MeshData, Fault> {
        let sheet = Sheet {
            force,
            deflection,
            panel,
            punch,
            stiffness: self.k75.map(from_kn),
            curve: self.curve.as_deref().map(read).transpose()?,
            another: self.another.clone(),
            strengths: [self.strength_along, self.strength_across].map(|s| s.map(from_kn)),
            piece: self.piece.0,
            wire_strength: self.wire_strength,
            wire_elongation: self.wire_elongation.map(|percent| percent / 100.0),
            first: self.breaks,
            net: [self.opening, self.twist, self.diameter],
        };
        Ok(sheet.data(start)?)
    }
}

fn read(path: &Path) -> Result<LabCurve, Fault> {
    let bytes = project::load_table(path, project::LARGEST_FILE)?;
    let text = String::from_utf8(bytes).map_err(|_| {
        Fault::input(format!(
            "--curve: {}: this is no text in UTF-8; save the table as CSV",
            path.display()
        ))
    })?;
    LabCurve::read(&text)
        .map_err(|problem| Fault::input(format!("--curve: {}: {problem}", path.display())))
}

/// Finds the laws and prints them.
pub(super) fn run(args: &CalibrateArgs) -> CommandEnd {
    let start = super::start(&args.from)?;
    if let Some(path) = args.out.as_ref().filter(|path| path.exists()) {
        return Err(exists(path));
    }
    let data =
        args.data.data([args.force, args.deflection], [args.panel, args.punch], &start.net)?;
    let options = IdentifyOptions {
        seed: args.seed,
        // The prior and the ensemble leave more open than a quick run does.
        fidelity: if args.fidelity == Fidelity::Fine { Fidelity::Standard } else { args.fidelity },
        threads: threads(args.threads),
    };
    let watch = Watch::start();
    let Some(found) = laws(&data, &options, &watch)? else {
        watch.finish("no law yet");
        return Ok(Output { interrupted: true, ..Output::default() });
    };
    watch.finish("laws that fit");
    let result = Told { args, data, found };
    if let Some(path) = &args.out {
        write_wires(path, &result.wire())?;
    }
    let text = match args.format {
        Format::Text => result.text(),
        Format::Json => json(&result.object())? + "\n",
    };
    Ok(Output { result: text, notes: result.remarks(), ..Output::default() })
}

fn write_wires(path: &Path, wire: &WireData) -> Result<(), Fault> {
    let comment = "Net and wires of a mesh for the discrete element check: meshcast check --mesh-file THIS\nLengths m, mass kg, curves (strain, stress in MPa).";
    let text = commented(wire, comment)
        .ok_or_else(|| Fault::Failure("the fitted wires cannot be written as RON".into()))?;
    create(path, &text).map_err(|e| match e {
        SaveError::Exists(path) => exists(&path),
        other => Fault::Failure(other.to_string()),
    })
}

/// The laws that fit; nothing where the user ended it.
///
/// # Errors
/// A scene that cannot be built, or no law that fits.
fn laws(
    data: &MeshData,
    options: &IdentifyOptions,
    watch: &Watch,
) -> Result<Option<Identified>, Fault> {
    let count = Mutex::new(Trials::default());
    let parts = 2 * SIMULATIONS * (data.punches.len() + data.tensile.len());
    let tell = |scene: &FitScene, now: EnsembleProgress| -> Flow {
        // A lock is only poisoned by a panic, and the count stays whole.
        let trial = count.lock().unwrap_or_else(std::sync::PoisonError::into_inner).at(scene, now);
        let part = trial.min(parts) - 1;
        watch.part(&format!("{}, trial {trial}", scene.words), part, parts, scene.end());
        watch.tell(now)
    };
    match identify(data, options, &tell) {
        Ok(Some(found)) => Ok(Some(found)),
        Ok(None) => Err(Fault::Failure(NO_LAW.into())),
        Err(Ended::Bad(problems)) => Err(problems.into()),
        Err(Ended::Cancelled) => Ok(None),
    }
}

/// What was found, to be told.
struct Told<'a> {
    args: &'a CalibrateArgs,
    data: MeshData,
    found: Identified,
}

impl Told<'_> {
    fn wire(&self) -> WireData {
        wire(&self.found, &self.found.laws[0], "the best")
    }

    fn remarks(&self) -> Vec<String> {
        remarks(&self.data, &self.found)
    }

    fn text(&self) -> String {
        let f = &self.found;
        let mut lines = Vec::new();
        let mut line = |head: &str, text: &str| {
            lines.extend(wrapped(&format!("{head:<14}"), text, 80));
        };
        line("calibration", &format!("[meshcast {VERSION}]"));
        for (k, test) in self.data.punches.iter().enumerate() {
            let curve = test.curve.as_ref().map_or(String::new(), |c| {
                format!(
                    "; curve of {} points to {}, {} gaps, {} points behind the largest force left out",
                    c.points.len(),
                    told(c.end()),
                    c.gaps,
                    c.behind
                )
            });
            let delta =
                test.deflection.map_or("not known".into(), |d| format!("{} m", significant(d, 3)));
            line(
                if k == 0 { "test" } else { "" },
                &format!(
                    "{} kN at {delta}; panel {} m, punch {} m{curve}",
                    significant(to_kn(test.force), 4),
                    shortest(test.panel),
                    shortest(test.punch)
                ),
            );
        }
        for (number, fit) in &f.fits {
            let weight: f64 =
                f.laws.iter().filter(|law| law.start == *number).map(|law| law.weight).sum();
            line(
                START_WORDS[*number],
                &format!(
                    "best law: sum of squares {}, {} of the weight, {} simulations",
                    significant(fit.score, 3),
                    percent(weight),
                    fit.evaluations
                ),
            );
        }
        let [force, deflection] = f.anchored;
        line(
            "PREDICTED",
            &format!(
                "anchored reference (d 0.32, L 3, D 1 m): {} kN (5 to 95 %: {} to {}) at {:.3} m ({:.3} to {:.3}), over {} laws",
                significant(to_kn(force[1]), 3),
                significant(to_kn(force[0]), 3),
                significant(to_kn(force[2]), 3),
                deflection[1],
                deflection[0],
                deflection[2],
                f.laws.len()
            ),
        );
        let mut out = lines.join("\n") + "\n\n";
        let _ =
            writeln!(out, "{:<22}{:>9} {:>20}  held by the data", "parameter", "best", "5 to 95 %");
        for (k, word) in WORDS.iter().enumerate() {
            let [low, _, high] = f.ranges[k];
            let _ = writeln!(
                out,
                "{word:<22}{:>9} {:>20}  {}",
                significant(f.laws[0].law.values()[k], 3),
                format!("{} to {}", significant(low, 3), significant(high, 3)),
                percent(f.shares[k])
            );
        }
        let _ = writeln!(out, "\n{:<36}{:>10} {:>10} {:>6}", "row", "data", "best law", "off");
        for (row, value) in f.question.rows.iter().zip(&f.values) {
            let _ = writeln!(
                out,
                "{:<36}{:>10} {:>10} {:>+6.1}",
                row.label,
                shown(row.measure, row.target),
                shown(row.measure, *value),
                row.residual(*value)
            );
        }
        let method = "off: in standard deviations granted to the row. Held by the data: the part of a parameter's precision that the rows give; the prior (steel wire of 350 to 550 MPa and 8 to 35 %, the rest near the start) holds what is left.";
        let _ = write!(out, "\n{}\n", wrapped("", method, 80).join("\n"));
        if let Some(path) = &self.args.out {
            let _ = writeln!(out, "\nThe best law is written to {}", path.display());
        }
        out
    }

    fn object(&self) -> Object {
        let f = &self.found;
        let range = |[low, middle, high]: [f64; 3]| {
            Object::new()
                .with("p5", Value::Exact(low))
                .with("p50", Value::Exact(middle))
                .with("p95", Value::Exact(high))
        };
        let parameters = WORDS.iter().enumerate().map(|(k, word)| {
            range(f.ranges[k])
                .with("parameter", *word)
                .with("best", Value::Exact(f.laws[0].law.values()[k]))
                .with("held_by_data", Value::Exact(f.shares[k]))
        });
        let rows = f.question.rows.iter().zip(&f.values).map(|(row, value)| {
            Object::new()
                .with("row", row.label.clone())
                .with("data", Value::Exact(row.target))
                .with("best_law", Value::Exact(*value))
                .with("off", Value::Exact(row.residual(*value)))
        });
        let laws = f.laws.iter().map(|law| {
            let values = law.law.values().map(Value::Exact).into_iter();
            Object::new()
                .with("start", START_WORDS[law.start])
                .with("parameters", values.collect::<Value>())
                .with("sum_of_squares", Value::Exact(law.score))
                .with("weight", Value::Exact(law.weight))
                .with("twists_first", Value::Exact(law.twists_first))
                .with("anchored_F_kN", Value::Exact(to_kn(law.anchored[0])))
                .with("anchored_delta_m", Value::Exact(law.anchored[1]))
        });
        Object::new()
            .with("version", VERSION)
            .with("anchored_F_kN", range(f.anchored[0].map(to_kn)))
            .with("anchored_delta_m", range(f.anchored[1]))
            .with("parameters", parameters.collect::<Value>())
            .with("rows", rows.collect::<Value>())
            .with("laws", laws.collect::<Value>())
            .with("remarks", self.remarks().into_iter().map(Value::from).collect::<Value>())
    }
}

fn percent(part: f64) -> String {
    // Nothing summed up is minus zero.
    format!("{:.0} %", 100.0 * part + 0.0)
}
