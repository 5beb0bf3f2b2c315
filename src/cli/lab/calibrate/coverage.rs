//! `meshcast calibrate --coverage`: how often the range that a curve gives contains what the law behind the
//! curve does in the field.

use super::CalibrateArgs;
use crate::cli::VERSION;
use crate::cli::check::threads;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, say, wrapped};
use crate::cli::watch::Watch;
use crate::lab::fit::coverage::{CoverageDraw, CoveragePlan, draw};
use crate::lab::fit::posterior::{IdentifyOptions, START_WORDS};
use crate::lab::fit::rows::Ended;
use crate::show::value::{Object, Value};
use crate::units::{shortest, significant, to_kn};
use crate::words::Choice;
use std::fmt::Write;

/// Draws, counts and prints.
pub(super) fn run(args: &CalibrateArgs, draws: usize) -> CommandEnd {
    if args.punch >= args.panel {
        return Err(Fault::input("--punch: it must be smaller than the panel"));
    }
    let plan = CoveragePlan {
        net: super::start(&args.from)?.net,
        test: [args.panel, args.punch],
        options: IdentifyOptions {
            seed: args.seed,
            fidelity: args.fidelity,
            threads: threads(args.threads),
        },
    };
    let watch = Watch::start();
    let mut made = Vec::with_capacity(draws);
    let mut interrupted = false;
    for k in 0..draws {
        match draw(&plan, k, &|scene, now| {
            watch.part(&format!("draw {}, {}", k + 1, scene.words), k, draws, scene.end());
            watch.tell(now)
        }) {
            Ok(Some(one)) => {
                say("progress", &format!("draw {}: {}", k + 1, told(&one)));
                made.push(one);
            }
            Ok(None) => say("progress", &format!("draw {}: no law that can be tested", k + 1)),
            Err(Ended::Bad(problems)) => return Err(problems.into()),
            Err(Ended::Cancelled) => {
                interrupted = true;
                break;
            }
        }
    }
    watch.finish(&format!("{} draws", made.len()));
    let result = match args.format {
        Format::Text => text(&plan, &made),
        Format::Json => json(&object(&plan, &made))? + "\n",
    };
    Ok(Output { result, interrupted, ..Output::default() })
}

/// A draw in a line.
fn told(one: &CoverageDraw) -> String {
    let kn = |force: f64| significant(to_kn(force), 4);
    let range = one.range.map_or("no law fits".into(), |[low, middle, high]| {
        format!("{} ({} to {})", kn(middle), kn(low), kn(high))
    });
    format!(
        "{} (weight {:.2}), test {} kN at {:.3} m; in the field {} kN, by the test {range}: {}",
        START_WORDS[one.start],
        one.weight,
        kn(one.test.force),
        one.test.deflection,
        kn(one.truth),
        if one.inside() { "inside" } else { "OUTSIDE" }
    )
}

/// How many are inside, and below and above, and the mean width of the ranges.
fn counts(made: &[CoverageDraw]) -> ([usize; 3], f64) {
    let inside = made.iter().filter(|one| one.inside()).count();
    let below = |one: &&CoverageDraw| one.range.is_some_and(|[low, ..]| one.truth < low);
    let below = made.iter().filter(below).count();
    let widths = made.iter().filter_map(|one| one.range.map(|[low, _, high]| (high / low).ln()));
    let widths: Vec<f64> = widths.collect();
    let mean = widths.iter().sum::<f64>() / widths.len().max(1) as f64;
    ([inside, below, made.len() - inside - below], 0.5 * mean)
}

fn text(plan: &CoveragePlan, made: &[CoverageDraw]) -> String {
    let ([inside, below, above], half) = counts(made);
    let mut out = String::new();
    let mut line = |head: &str, text: &str| {
        for line in wrapped(&format!("{head:<14}"), text, 80) {
            out.push_str(&line);
            out.push('\n');
        }
    };
    let [panel, punch] = plan.test;
    line(
        "coverage",
        &format!(
            "{} laws drawn from the prior, half of weak and half of strong twists, each found again from a noisy curve of one run of its own; panel {} m, punch {} m, {} [meshcast {VERSION}]",
            made.len(),
            shortest(panel),
            shortest(punch),
            plan.options.fidelity.word()
        ),
    );
    let part = inside as f64 / made.len().max(1) as f64;
    let error = (part * (1.0 - part) / made.len().max(1) as f64).sqrt();
    line(
        "INSIDE",
        &format!(
            "{inside} of {}, {:.0} +- {:.0} %; the range is meant to hold 90 %. The law's force lies below its range in {below}, above it or without one in {above}",
            made.len(),
            100.0 * part,
            100.0 * error
        ),
    );
    line("width", &format!("half of a range is {} % of its middle", significant(100.0 * half, 2)));
    for (k, one) in made.iter().enumerate() {
        let _ = writeln!(out, "{:>4}  {}", k + 1, told(one));
    }
    out
}

fn object(plan: &CoveragePlan, made: &[CoverageDraw]) -> Object {
    let ([inside, below, above], half) = counts(made);
    let draws = made.iter().map(|one| {
        let range = one.range.map(|range| range.map(|force| Value::Exact(to_kn(force))));
        let [low, middle, high] = range.unwrap_or([Value::None, Value::None, Value::None]);
        Object::new()
            .with("start", START_WORDS[one.start])
            .with("weight_of_start", Value::Exact(one.weight))
            .with("law", one.law.values().map(Value::Exact).into_iter().collect::<Value>())
            .with("passed_over", one.passed_over)
            .with("test_F_kN", Value::Exact(to_kn(one.test.force)))
            .with("test_delta_m", Value::Exact(one.test.deflection))
            .with("field_F_kN", Value::Exact(to_kn(one.truth)))
            .with("p5_kN", low)
            .with("p50_kN", middle)
            .with("p95_kN", high)
            .with("inside", one.inside())
    });
    Object::new()
        .with("version", VERSION)
        .with("fidelity", plan.options.fidelity.word())
        .with("inside", inside)
        .with("below", below)
        .with("above", above)
        .with("half_width", Value::Exact(half))
        .with("draws", draws.collect::<Value>())
}
