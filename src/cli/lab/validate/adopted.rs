//! `meshcast validate --adopted`: what the laboratory test alone would have told of the field.

use super::ValidateArgs;
use crate::cli::VERSION;
use crate::cli::check::threads;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, wrapped};
use crate::cli::watch::Watch;
use crate::lab::adopt::NO_LAW;
use crate::lab::fit::posterior::IdentifyOptions;
use crate::lab::fit::rows::Ended;
use crate::lab::paper::adopted::{AdoptedFrom, FieldRange, adopted};
use crate::show::value::{Object, Value};
use crate::units::{significant, to_kn};
use std::fmt::Write;

/// Makes the table and prints it.
pub(super) fn run(args: &ValidateArgs) -> CommandEnd {
    let options = IdentifyOptions {
        seed: args.seed,
        fidelity: args.fidelity,
        threads: threads(args.threads),
    };
    let watch = Watch::start();
    let made = adopted(&options, &|words, part, parts, end, now| {
        watch.part(words, part, parts, end);
        watch.tell(now)
    });
    let made = match made {
        Ok(Some(made)) => made,
        Ok(None) => return Err(Fault::Failure(NO_LAW.into())),
        Err(Ended::Bad(problems)) => return Err(problems.into()),
        Err(Ended::Cancelled) => {
            watch.finish("no table yet");
            return Ok(Output { interrupted: true, ..Output::default() });
        }
    };
    watch.finish("the table");
    let result = match args.format {
        Format::Text => text(&made),
        Format::Json => json(&object(&made))? + "\n",
    };
    Ok(Output { result, ..Output::default() })
}

fn shown(row: &FieldRange, value: f64) -> String {
    if row.deflection { format!("{value:.3}") } else { significant(to_kn(value), 3) }
}

fn text(made: &[AdoptedFrom]) -> String {
    let mut out =
        format!("The reference mesh adopted from its laboratory test [meshcast {VERSION}]\n");
    for from in made {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "\n{}, {} laws", from.words, from.laws);
        let _ = writeln!(
            out,
            "  {:<24}{:>7}   {:<23}{:<5}{:<16}",
            "", "paper", "mean, 5 to 95 %", "", "one run"
        );
        for row in &from.rows {
            let unit = if row.deflection { "m" } else { "kN" };
            let range =
                |[low, _, high]: [f64; 3]| format!("{} to {}", shown(row, low), shown(row, high));
            let word = |range| if row.within(range) { "in" } else { "OUT" };
            let _ = writeln!(
                out,
                "  {:<22}{:>2}{:>7}   {:<7}{:<16}{:<5}{:<16} {}",
                row.case,
                unit,
                shown(row, row.paper),
                shown(row, row.mean[1]),
                range(row.mean),
                word(row.mean),
                range(row.one),
                word(row.one)
            );
        }
    }
    let said = "Each range is over the laws that fit, 5 to 95 %, with the error of few runs and 1.5 % between solvers. The paper's values are single simulations: the range of one run is for them. No curve of the test is published: it is simulated with the catalogue's law, which has seen the field.";
    let _ = write!(out, "\n{}\n", wrapped("", said, 80).join("\n"));
    out
}

fn object(made: &[AdoptedFrom]) -> Object {
    let from = |from: &AdoptedFrom| {
        let rows = from.rows.iter().map(|row| {
            let si = |v: f64| Value::Exact(if row.deflection { v } else { to_kn(v) });
            let list = |range: [f64; 3]| range.into_iter().map(si).collect::<Value>();
            Object::new()
                .with("case", row.case.clone())
                .with("quantity", if row.deflection { "delta_m" } else { "F_kN" })
                .with("paper", si(row.paper))
                .with("mean", list(row.mean))
                .with("one_run", list(row.one))
                .with("mean_contains", row.within(row.mean))
                .with("one_run_contains", row.within(row.one))
        });
        Object::new()
            .with("told", from.words)
            .with("laws", from.laws)
            .with("rows", rows.collect::<Value>())
    };
    Object::new()
        .with("version", VERSION)
        .with("adopted_from", made.iter().map(from).collect::<Value>())
}
