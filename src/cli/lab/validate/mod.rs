//! `meshcast validate`: everything that the paper prints beside what this program returns; with
//! `--dem` its simulations beside ours ([`dem`]).
//!
//! Exit code 1 when a printed digit differs.

mod dem;

use crate::cli::VERSION;
use crate::cli::check::{fidelity, threads};
use crate::cli::output::{CommandEnd, Format, Output, json, number, wrapped};
use crate::dem::Fidelity;
use crate::forecast::published::{
    PublishedComparison, TestRow, Validation, published, reference_point_factors, validate,
};
use crate::lab::paper::PaperOptions;
use clap::Args;
use serde::Serialize;
use std::fmt::Write;
use std::num::NonZeroUsize;

/// Compare the program with everything that the paper prints; exit code 1 if a digit differs.
#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Compare the paper's simulations with ours too: some minutes.
    #[arg(long)]
    dem: bool,
    /// How exactly each of our runs is computed.
    #[arg(long, value_name = "FIDELITY", default_value = "standard", requires = "dem", value_parser = fidelity())]
    fidelity: Fidelity,
    /// Seed of alignments and slack of our runs.
    #[arg(long, value_name = "S", default_value_t = 0, requires = "dem")]
    seed: u64,
    /// Wires of our runs instead of the reference mesh's: bench, yade, reference or a mesh file.
    #[arg(long, value_name = "LAW", requires = "dem")]
    law: Option<String>,
    /// Threads; the result does not depend on them [default: as many as the machine has].
    #[arg(long, value_name = "N", requires = "dem")]
    threads: Option<NonZeroUsize>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Compares and prints the tables.
pub(crate) fn run(args: &ValidateArgs) -> CommandEnd {
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
        Format::Json => {
            let dem = dem::DemJson::of(&compared);
            json(&WithDem { closed_form: ValidationJson::of(&validation), dem })? + "\n"
        }
    };
    Ok(Output { result, failed: !validation.agrees(), ..Output::default() })
}

fn outcome(validation: &Validation, format: Format) -> CommandEnd {
    let result = match format {
        Format::Text => text(validation),
        Format::Json => json(&ValidationJson::of(validation))? + "\n",
    };
    Ok(Output { result, failed: !validation.agrees(), ..Output::default() })
}

/// The closed form's comparison with that of the simulations beside it.
#[derive(Serialize)]
struct WithDem<'a> {
    #[serde(flatten)]
    closed_form: ValidationJson,
    dem: dem::DemJson<'a>,
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

#[derive(Serialize)]
struct ValidationJson {
    version: &'static str,
    source: &'static str,
    agrees: bool,
    table_1: Vec<TestJson>,
    facts: Vec<FactJson>,
    reference_point: ReferenceJson,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct TestJson {
    test: u32,
    inputs: InputsJson,
    F_kN: CellJson,
    delta_m: CellJson,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct InputsJson {
    d_m: f64,
    L_m: f64,
    D_m: f64,
    ex_m: f64,
    ey_m: f64,
}

#[derive(Serialize)]
struct CellJson {
    #[serde(flatten)]
    compared: ComparedJson,
    dem: &'static str,
    by_construction: bool,
}

#[derive(Serialize)]
struct ComparedJson {
    printed: &'static str,
    #[serde(serialize_with = "number")]
    ours: f64,
    #[serde(serialize_with = "number")]
    difference: f64,
    agrees: bool,
}

#[derive(Serialize)]
struct FactJson {
    fact: &'static str,
    unit: &'static str,
    source: &'static str,
    #[serde(flatten)]
    compared: ComparedJson,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct ReferenceJson {
    F_kN: ComparedJson,
    delta_m: ComparedJson,
}

impl ComparedJson {
    fn of(c: &PublishedComparison) -> ComparedJson {
        ComparedJson {
            printed: c.printed.text(),
            ours: c.ours,
            difference: c.difference(),
            agrees: c.agrees(),
        }
    }
}

impl ValidationJson {
    fn of(v: &Validation) -> ValidationJson {
        ValidationJson {
            version: VERSION,
            source: &published().source,
            agrees: v.agrees(),
            table_1: v.tests.iter().map(TestJson::of).collect(),
            facts: v
                .facts
                .iter()
                .map(|(fact, c)| FactJson {
                    fact: &fact.words,
                    unit: &fact.unit,
                    source: &fact.source,
                    compared: ComparedJson::of(c),
                })
                .collect(),
            reference_point: ReferenceJson {
                F_kN: ComparedJson::of(&v.reference_force),
                delta_m: ComparedJson::of(&v.reference_deflection),
            },
        }
    }
}

impl TestJson {
    fn of(row: &TestRow) -> TestJson {
        let t = row.test;
        let cell = |c: &PublishedComparison, dem| CellJson {
            compared: ComparedJson::of(c),
            dem,
            by_construction: t.by_construction,
        };
        TestJson {
            test: t.test,
            inputs: InputsJson {
                d_m: t.plate,
                L_m: t.spacing,
                D_m: t.punch,
                ex_m: t.ex,
                ey_m: t.ey,
            },
            F_kN: cell(&row.force, t.dem.force.text()),
            delta_m: cell(&row.deflection, t.dem.deflection.text()),
        }
    }
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
