//! `meshcast check --pull`: a piece of the net pulled until it breaks, the test by which makers state a strength.

use super::CheckArgs;
use crate::cli::VERSION;
use crate::cli::output::{CommandEnd, Fault, Output, json, wrapped};
use crate::cli::watch::Watch;
use crate::cli::wire::Wires;
use crate::dem::hash::hash;
use crate::dem::lattice::Role;
use crate::dem::tensile::{Pull, TensileOutcome, TensileSpec, tensile};
use crate::mesh::catalogue;
use crate::mesh::wire::WireData;
use crate::show::value::{Object, Value};
use crate::study::ensemble::EnsembleProgress;
use crate::study::sampling::spread::Spread;
use crate::units::{shortest, significant, to_kn};
use crate::words::Choice;
use std::fmt::Write;

/// Pulls where nothing is said: the strength of a piece of metres scatters little.
const RUNS: usize = 4;

/// Pulls and prints.
pub(super) fn run(args: &CheckArgs, pull: Pull) -> CommandEnd {
    let [width, length] = args.piece.0;
    let wire = Wires::read(args.mesh_file.as_deref(), args.law.as_deref())?
        .for_mesh(&catalogue::reference())?;
    let plan = args.plan();
    let runs = plan.runs.unwrap_or(RUNS);
    let watch = Watch::start();
    watch.begin("tensile test", 0, 1, 0.15 * length);
    let mut made = Vec::with_capacity(runs);
    for run in 0..runs {
        let seed = hash(plan.seed, run as u64);
        let spec = TensileSpec { width, length, pull, wire: wire.clone(), seed };
        let told = |elongation: f64| {
            let inner = spec.progress(elongation);
            watch.tell(EnsembleProgress { done: run, planned: runs, run, inner })
        };
        let outcome = tensile(&spec, &mut { told }).map_err(|found| {
            let flag = &[("width", "--piece"), ("length", "--piece")];
            Fault::from(found.into_iter().map(|p| p.renamed(flag)).collect::<Vec<_>>())
        })?;
        if watch.cancelled() {
            break;
        }
        made.push(outcome);
    }
    watch.finish(&format!("{} pulls", made.len()));
    let pulled = Pulled { pull, sides: [width, length], wire, made };
    let result = args.format.write(
        || pulled.text(),
        || Ok(json(&pulled.object())? + "\n"),
        || pulled.csv(),
    )?;
    let interrupted = pulled.made.len() < runs;
    let failed = !interrupted && pulled.made.iter().all(|one| one.broke.is_none());
    Ok(Output { result, failed, interrupted, ..Output::default() })
}

/// The pulls of a net.
struct Pulled {
    pull: Pull,
    sides: [f64; 2],
    wire: WireData,
    made: Vec<TensileOutcome>,
}

impl Pulled {
    fn spread(&self, of: fn(&TensileOutcome) -> f64) -> Spread {
        let values: Vec<f64> = self.made.iter().map(of).collect();
        Spread::of(&values, &values)
    }

    /// In how many a twist broke first.
    fn twists(&self) -> usize {
        self.made.iter().filter(|one| one.broke == Some(Role::Twist)).count()
    }

    fn text(&self) -> String {
        let mut lines = Vec::new();
        let mut line = |head: &str, text: &str| {
            lines.extend(wrapped(&format!("{head:<12}"), text, 80));
        };
        let [width, length] = self.sides.map(shortest);
        line(
            "tensile",
            &format!(
                "a piece of the net {width} m wide and {length} m long pulled {} its twists, sides held [meshcast {VERSION}]",
                self.pull.word()
            ),
        );
        let (strength, elongation) =
            (self.spread(|one| one.strength), self.spread(|one| one.elongation));
        let plus = |deviation: f64| significant(deviation, 2);
        line(
            "STRENGTH",
            &format!(
                "{} +- {} kN/m at {} +- {} % of elongation, first break of {} pulls",
                significant(to_kn(strength.mean), 4),
                plus(to_kn(strength.deviation)),
                significant(100.0 * elongation.mean, 3),
                plus(100.0 * elongation.deviation),
                self.made.len()
            ),
        );
        let twists = self.twists();
        line(
            "breaks",
            &format!("a twist in {twists}, a single wire in {}", self.made.len() - twists),
        );
        line("wires", &self.wire.source);
        lines.join("\n") + "\n"
    }

    fn object(&self) -> Object {
        let pulls = self.made.iter().map(|one| {
            Object::new()
                .with("strength_kN_per_m", Value::Exact(to_kn(one.strength)))
                .with("elongation", Value::Exact(one.elongation))
                .with("twist_broke", one.broke.map(|role| Value::from(role == Role::Twist)))
        });
        Object::new()
            .with("version", VERSION)
            .with("pull", self.pull.word())
            .with("width_m", Value::Exact(self.sides[0]))
            .with("length_m", Value::Exact(self.sides[1]))
            .with("strength_kN_per_m", Value::Exact(to_kn(self.spread(|one| one.strength).mean)))
            .with("elongation", Value::Exact(self.spread(|one| one.elongation).mean))
            .with("pulls", pulls.collect::<Value>())
    }

    fn csv(&self) -> String {
        let mut out = "pull,elongation_m,force_kN\n".to_string();
        for (k, one) in self.made.iter().enumerate() {
            for point in one.curve.points() {
                // Writing to a text cannot fail.
                let _ = writeln!(out, "{},{},{}", k + 1, point.deflection, to_kn(point.force));
            }
        }
        out
    }
}
