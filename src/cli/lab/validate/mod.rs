//! `meshcast validate`: everything that the paper prints beside what this program returns; with
//! `--dem` its simulations beside ours ([`dem`]); with `--adopted` what its laboratory test alone would have told
//! ([`adopted`]).
//!
//! Exit code 1 when a printed digit differs.

mod adopted;
mod dem;

use crate::case::Input;
use crate::cli::VERSION;
use crate::cli::check::threads;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Format, Output, json, wrapped};
use crate::dem::Fidelity;
use crate::forecast::published::{
    PublishedComparison, TestRow, Validation, published, reference_point_factors, validate,
};
use crate::lab::paper::PaperOptions;
use crate::show::value::{Object, Value};
use crate::words::Choice;
use clap::Args;
use std::fmt::Write;
use std::num::NonZeroUsize;

/// Compare the program with everything that the paper prints; exit code 1 if a digit differs.
#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Compare the paper's simulations with ours too: some minutes.
    #[arg(long, group = "simulated")]
    dem: bool,
    /// Adopts the reference mesh from its laboratory test alone, and says whether the ranges contain what the paper
    /// found in the field: some minutes.
    #[arg(long, group = "simulated", conflicts_with = "law")]
    adopted: bool,
    /// How exactly each of our runs is computed.
    #[arg(long, value_name = "FIDELITY", default_value = "standard", requires = "simulated", value_parser = one_of(Fidelity::ALL))]
    fidelity: Fidelity,
    /// Seed of alignments and slack of our runs.
    #[arg(long, value_name = "S", default_value_t = 0, requires = "simulated")]
    seed: u64,
    /// Wires of our runs instead of the reference mesh's: bench, yade, reference or a mesh file.
    #[arg(long, value_name = "LAW", requires = "dem")]
    law: Option<String>,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N", requires = "simulated")]
    threads: Option<NonZeroUsize>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Compares and prints the tables.
pub(crate) fn run(args: &ValidateArgs) -> CommandEnd {
    if args.adopted {
        return adopted::run(args);
    }
    let validation = validate();
    if !args.dem {
        return outcome(&validation, args.format);
    }
    let options =
        PaperOptions { fidelity: args.fidelity, seed: args.seed, threads: threads(args.threads) };
    let Some(compared) = dem::compare(args.law.as_deref(), &options)? else {
        return Ok(Output { interrupted: true, ..Output::default() });
    };
    let result = match args.format {
        Format::Text => format!("{}\n{}", text(&validation), dem::text(&compared)),
        Format::Json => json(&object(&validation).with("dem", dem::object(&compared)))? + "\n",
    };
    Ok(Output { result, failed: !validation.agrees(), ..Output::default() })
}

fn outcome(validation: &Validation, format: Format) -> CommandEnd {
    let result = match format {
        Format::Text => text(validation),
        Format::Json => json(&object(validation))? + "\n",
    };
    Ok(Output { result, failed: !validation.agrees(), ..Output::default() })
}

fn text(v: &Validation) -> String {
    let mut out = format!("{}\n\n", wrapped("", &published().source, 80).join("\n"));
    table(&mut out, "Table 1: force at failure F_a, kN (DEM: the paper's simulation)", v, 2, |t| {
        (t.force, t.test.dem.force.text())
    });
    table(&mut out, "Table 1: deflection at failure delta_a, m (DEM: the same)", v, 3, |t| {
        (t.deflection, t.test.dem.deflection.text())
    });
    out.push_str("Other printed numbers                     printed     ours  digits\n");
    for (fact, c) in &v.facts {
        let decimals = fact.printed.decimals() + 2;
        let line = format!(
            "  {:<38}  {:>7}  {:>7.decimals$}  {:<7} {}",
            fact.words,
            fact.printed.text(),
            c.ours,
            verdict(c, false),
            fact.unit
        );
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", line.trim_end());
    }
    let (force, deflection) = reference_point_factors();
    let disclosed = format!(
        "At the reference point (d = 0.32, L = 3, D = 1 m) the published relations return {:.1} kN and {:.3} m (worked by hand: {}, {}), not the 29.1 kN and 0.65 m that they scale: factors {force:.2} and {deflection:.2}. Published as they are.",
        v.reference_force.ours,
        v.reference_deflection.ours,
        v.reference_force.printed.text(),
        v.reference_deflection.printed.text(),
    );
    let _ = write!(out, "\n{}\n\n", wrapped("", &disclosed, 80).join("\n"));
    out.push_str(&tally(v));
    out
}

fn tally(v: &Validation) -> String {
    let cells = || v.tests.iter().flat_map(|t| [(t, t.force), (t, t.deflection)]);
    let count = |built: bool| {
        cells().filter(|(t, c)| t.test.by_construction == built && c.agrees()).count()
    };
    let all = cells().count();
    let verdict = if v.agrees() { "Every printed digit agrees" } else { "A PRINTED DIGIT DIFFERS" };
    format!(
        "{verdict}.\nTable 1: {} of {all}, {} by the equations and {} by construction.\n",
        count(false) + count(true),
        count(false),
        count(true)
    )
}

fn table(
    out: &mut String,
    title: &str,
    v: &Validation,
    decimals: usize,
    column: fn(&TestRow) -> (PublishedComparison, &'static str),
) {
    let _ = writeln!(out, "{title}");
    let _ =
        writeln!(out, "test    d     L     D    ex    ey  printed    ours   diff   DEM  digits");
    for row in &v.tests {
        let (t, (c, dem)) = (row.test, column(row));
        let _ = writeln!(
            out,
            "{:>4} {:.2}  {:.2}  {:.2}  {:.2}  {:.2}  {:>7}  {:>6.decimals$} {:>+6.decimals$}  {:>4}  {}",
            t.test,
            t.plate,
            t.spacing,
            t.punch,
            t.ex,
            t.ey,
            c.printed.text(),
            c.ours,
            shown_difference(&c, decimals),
            dem,
            verdict(&c, t.by_construction)
        );
    }
    out.push('\n');
}

/// The difference at the digits that are shown; never the negative zero.
fn shown_difference(c: &PublishedComparison, decimals: usize) -> f64 {
    let unit = 10.0_f64.powi(i32::try_from(decimals).unwrap_or(0));
    (c.difference() * unit).round() / unit + 0.0
}

fn verdict(c: &PublishedComparison, by_construction: bool) -> &'static str {
    match (c.agrees(), by_construction) {
        (true, false) => "same",
        (true, true) => "by construction",
        (false, _) => "DIFFER",
    }
}

fn object(v: &Validation) -> Object {
    let facts = v.facts.iter().map(|(fact, c)| {
        let fact = Object::new()
            .with("fact", fact.words.clone())
            .with("unit", fact.unit.clone())
            .with("source", fact.source.clone());
        fact.and(compared(c))
    });
    let point = Object::new()
        .with("F_kN", compared(&v.reference_force))
        .with("delta_m", compared(&v.reference_deflection));
    Object::new()
        .with("version", VERSION)
        .with("source", published().source.clone())
        .with("agrees", v.agrees())
        .with("table_1", v.tests.iter().map(test).collect::<Value>())
        .with("facts", facts.collect::<Value>())
        .with("reference_point", point)
}

fn compared(c: &PublishedComparison) -> Object {
    Object::new()
        .with("printed", c.printed.text())
        .with("ours", c.ours)
        .with("difference", c.difference())
        .with("agrees", c.agrees())
}

fn test(row: &TestRow) -> Object {
    let t = row.test;
    let cell = |c: &PublishedComparison, dem: &'static str| {
        compared(c).with("dem", dem).with("by_construction", t.by_construction)
    };
    let sizes = [t.plate, t.spacing, t.punch, t.ex, t.ey];
    let geometry = Input::GEOMETRY.iter().filter(|input| **input != Input::SpacingUp);
    let inputs = geometry.zip(sizes).fold(Object::new(), |object, (input, size)| {
        object.with(input.column(), Value::Exact(size))
    });
    Object::new()
        .with("test", t.test as usize)
        .with("inputs", inputs)
        .with("F_kN", cell(&row.force, t.dem.force.text()))
        .with("delta_m", cell(&row.deflection, t.dem.deflection.text()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_digit_that_differs_is_marked_and_is_a_failure() {
        let sound = validate();
        let output = outcome(&sound, Format::Text).unwrap();
        assert!(!output.failed && !output.result.contains("DIFFER"));
        let mut wrong = sound;
        wrong.tests[3].force.ours += 0.1;
        let output = outcome(&wrong, Format::Text).unwrap();
        assert!(output.failed, "{}", output.result);
        assert_eq!(output.result.matches("  DIFFER\n").count(), 1, "{}", output.result);
        assert!(output.result.contains("A PRINTED DIGIT DIFFERS"), "{}", output.result);
        assert!(output.result.contains("9 of 10, 6 by the equations and 3"), "{}", output.result);
        let output = outcome(&wrong, Format::Json).unwrap();
        assert!(output.failed && output.result.contains("\"agrees\":false"));
        let mut wrong = validate();
        wrong.facts[0].1.ours = f64::NAN;
        assert!(outcome(&wrong, Format::Text).unwrap().failed);
    }
}
