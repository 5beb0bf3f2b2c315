//! `meshcast validate --dem`: the paper's simulations beside ours.

use crate::cli::output::{Fault, wrapped};
use crate::cli::watch::Watch;
use crate::cli::wire::Wires;
use crate::dem::Fidelity;
use crate::lab::paper::{
    AIM, AIM_FACING, AIM_FACTORS, ERROR_AIM, PaperOptions, PaperQuantity, PaperRow, SHAPE_AIM,
    compare as paper,
};
use crate::mesh::catalogue;
use crate::show::value::{Object, Value, exact};
use crate::units::{significant, to_kn};
use crate::words::Choice;
use std::fmt::Write;

/// The comparison with the wires it was made with.
pub(crate) struct Compared {
    rows: Vec<PaperRow>,
    law: String,
    fidelity: Fidelity,
}

/// Makes the comparison. Nothing where the user ended it.
///
/// # Errors
/// An unknown law, or wires that cannot be run.
pub(crate) fn compare(
    law: Option<&str>,
    options: &PaperOptions,
) -> Result<Option<Compared>, Fault> {
    let wire = Wires::read(None, law)?.for_mesh(&catalogue::reference())?;
    let watch = Watch::start();
    let rows = paper(&wire, options, &|words, part, parts, end, now| {
        watch.part(words, part, parts, end);
        watch.tell(now)
    })?;
    watch.finish("comparison with the paper");
    Ok(rows.map(|rows| Compared { rows, law: wire.source, fidelity: options.fidelity }))
}

/// A value in the unit it is printed in.
fn shown(row: &PaperRow, value: f64) -> f64 {
    match row.quantity {
        PaperQuantity::Force | PaperQuantity::Stiffness => to_kn(value),
        PaperQuantity::Deflection | PaperQuantity::Ratio | PaperQuantity::Shape => value,
    }
}

fn unit(row: &PaperRow) -> &'static str {
    match row.quantity {
        PaperQuantity::Force => "kN",
        PaperQuantity::Deflection => "m",
        PaperQuantity::Stiffness => "kN/m",
        PaperQuantity::Ratio | PaperQuantity::Shape => "",
    }
}

/// What a row says of its aim.
fn result(row: &PaperRow) -> &'static str {
    match (row.aim.is_some(), row.hit(), row.known()) {
        (false, ..) => "",
        (true, false, _) => "MISSED",
        (true, true, true) => "met",
        (true, true, false) => "met, uncertain",
    }
}

/// The table.
pub(crate) fn text(c: &Compared) -> String {
    let mut out = format!(
        "The paper's simulations beside ours (first break; means and 5-95 % bands of\nensembles over alignment and slack, {} fidelity)\n\n",
        c.fidelity.word()
    );
    let head = format!(
        "{:<33}{:>6} {:>7} {:>15} {:>7} {:>5} {:>4}",
        "case", "paper", "ours", "band", "diff", "s.e.", "runs"
    );
    let _ = writeln!(out, "{head}  law, aim");
    for row in &c.rows {
        let digits = |v: f64| significant(shown(row, v), 3);
        let part = |v: f64| format!("{:+.1}%", 100.0 * v);
        let (paper, difference, error) = if row.quantity == PaperQuantity::Shape {
            ("0".to_string(), format!("{:+.3}", row.ours), format!("{:.3}", row.error))
        } else {
            (
                digits(row.paper),
                part(row.difference()),
                format!("{:.1}%", 100.0 * row.error / row.ours),
            )
        };
        let line = format!(
            "{:<33}{:>6} {:>7} {:>15} {:>7} {:>5} {:>4}  {} {}",
            format!("{} {}", row.case, unit(row)),
            paper,
            digits(row.ours),
            format!("{}-{}", digits(row.band[0]), digits(row.band[1])),
            difference,
            error,
            row.runs,
            row.standing.word(),
            result(row)
        );
        let _ = writeln!(out, "{}", line.trim_end());
    }
    let peaks: Vec<String> = c
        .rows
        .iter()
        .filter(|r| r.quantity == PaperQuantity::Force)
        .filter_map(|r| Some(format!("{}: {}", r.case, significant(to_kn(r.peak?), 3))))
        .collect();
    let aimed: Vec<&PaperRow> = c.rows.iter().filter(|r| r.aim.is_some()).collect();
    let missed: Vec<String> = aimed
        .iter()
        .filter(|r| !r.hit())
        .map(|r| format!("{} {}", r.case, unit(r)).trim().to_string())
        .collect();
    let unknown = aimed.iter().filter(|r| !r.known()).count();
    let summary = format!(
        "Aims: {:.0} % in force, {:.0} % in deflection ({:.0} and {:.0} % of mirrored test 5, {:.0} and {:.0} % of factors), {SHAPE_AIM} in the curve's shape, standard error below {:.0} %. Met: {} of {}. Missed: {}. Standard error above its aim: {unknown}.",
        100.0 * AIM[0],
        100.0 * AIM[1],
        100.0 * AIM_FACING[0],
        100.0 * AIM_FACING[1],
        100.0 * AIM_FACTORS[0],
        100.0 * AIM_FACTORS[1],
        100.0 * ERROR_AIM,
        aimed.len() - missed.len(),
        aimed.len(),
        if missed.is_empty() { "none".to_string() } else { missed.join("; ") }
    );
    for paragraph in [
        summary,
        format!("Mean peak, kN: {}", peaks.join("; ")),
        "law: fitted = the law of the reference mesh was fitted to it; in view = much the same as what it was fitted to; after the fact = the explanation was found with it in view; predicted = not read by the fit. k75 is the stiffness at 75 % of the force; the fit takes it by the tangent, and how the paper does is not known.".to_string(),
        "mirrored: blocks of neighbouring cells face each other across the anchor lines; all other anchored rows repeat the same block in every cell, as the paper says of its own. With facing blocks the paper's eccentric results come out, which is an explanation found after the fact and no proof that they were made so. Factors are over the centred block of as many cells, run by run at the same alignment and slack.".to_string(),
        format!("Wire law: {}", c.law),
    ] {
        let _ = write!(out, "\n{}\n", wrapped("", &paragraph, 80).join("\n"));
    }
    out
}

/// A comparison as JSON.
pub(crate) fn object(c: &Compared) -> Object {
    Object::new()
        .with("fidelity", c.fidelity.word())
        .with("law", c.law.clone())
        .with("rows", c.rows.iter().map(of_row).collect::<Value>())
}

fn of_row(row: &PaperRow) -> Object {
    let quantity = match row.quantity {
        PaperQuantity::Force => "force",
        PaperQuantity::Deflection => "deflection",
        PaperQuantity::Stiffness => "stiffness",
        PaperQuantity::Ratio => "ratio",
        PaperQuantity::Shape => "shape",
    };
    Object::new()
        .with("case", row.case.clone())
        .with("quantity", quantity)
        .with("unit", unit(row))
        .with("paper", shown(row, row.paper))
        .with("ours", shown(row, row.ours))
        .with("band", exact(row.band.map(|v| shown(row, v))))
        .with("difference", row.difference())
        .with("standard_error", shown(row, row.error))
        .with("mean_peak", row.peak.map(|v| Value::Exact(shown(row, v))))
        .with("law", row.standing.word())
        .with("aim", row.aim.map(Value::Exact))
        .with("met", row.hit())
        .with("runs", row.runs)
}
