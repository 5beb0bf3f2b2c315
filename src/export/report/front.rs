//! Project, results at a glance, inputs, meshes, and how to repeat it all.

use super::Report;
use super::document::{Block, Picture, ReportDocument, TextSpan, Words, code, ours, strong};
use crate::VERSION;
use crate::export::ExportedLayout;
use crate::export::svg::{Series, chart};
use crate::mesh::MeshType;
use crate::show::{say, verdict};
use crate::study::compare::mixed;
use crate::study::verdict::Finding;
use crate::units::{
    ForceUnit, Units, force_entry, force_text, length_entry, maybe_length_text, shortest,
};
use crate::words::Choice;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// Most curves in one chart of the report.
const CURVES: usize = 10;

/// What the report is about and what it was made from.
pub(crate) fn project(report: &Report<'_>, document: &mut ReportDocument) {
    let project = report.project;
    let mut rows = vec![(Words::from("Project"), Words::from(project.name.clone()))];
    if !project.site.is_empty() {
        rows.push(("Site".into(), project.site.clone().into()));
    }
    let words = ["Client", "Author", "Checked by", "Revision", "Date"];
    for (word, (_, text)) in words.into_iter().zip(project.title.rows()) {
        if !text.is_empty() {
            rows.push((word.into(), text.to_string().into()));
        }
    }
    let source = &report.source;
    if !source.file_name.is_empty() {
        rows.push(("File".into(), code(source.file_name)));
    }
    if let Some(text) = source.text {
        rows.push(("SHA-256 of the file".into(), code(sha256(text))));
    }
    rows.push(("Made by".into(), format!("meshcast {VERSION}").into()));
    document.facts(["Report", ""], rows);
    if source.edited || source.text.is_none() {
        document.quote(strong("The project had edits that were not saved when this report was made: the file does not hold these numbers."));
    }
    if !project.notes.trim().is_empty() {
        document.section("Notes");
        document.blocks.push(Block::Free(project.notes.clone()));
    }
}

/// Whether each layout is enough, with the inputs and the demand it was judged by.
pub(crate) fn verdicts(report: &Report<'_>, document: &mut ReportDocument) {
    if report.cases.is_empty() {
        return;
    }
    document.chapter("Verdict");
    let unit = report.unit;
    let mut head = vec![Words::from("Layout")];
    for symbol in ["{d}", "{L}", "{D}"] {
        let mut words = ours(symbol);
        words.0.push(TextSpan::Plain(format!(" ({})", unit.symbol())));
        head.push(words);
    }
    let load = format!("load ({})", unit.force_symbol());
    let rest = [
        load.as_str(),
        "{gamma_F}",
        "{gamma_R}",
        "allowed {delta}",
        "strength",
        "deflection",
        "anchor",
        "verdict",
    ];
    head.extend(rest.map(ours));
    let rows = report.cases.iter().map(|case| verdict_row(case, unit)).collect();
    document.blocks.push(Block::Table { head, rows, numbers: true });
    let basis = report.project.basis.word();
    document.say(&format!(
        "A use of at most 100 % passes. Strength, by mean and characteristic values: the load with {{gamma_F}} times {{gamma_R}} over {{F_a}}; deflection: that under the load without its factor on the mean curve, over the allowed one; anchor: the load with {{gamma_F}}, which in a field with a block in every cell each anchor carries, over what it can take. Verdicts here go by {basis} values; where a check by simulation is kept and its inputs are unchanged, the larger use of forecast and check counts."
    ));
}

fn verdict_row(case: &ExportedLayout, unit: Units) -> Vec<Words> {
    let v = &case.verdict;
    let asked = case.case.asked();
    let mut row = vec![Words::from(case.entry.name.clone())];
    let layout = &case.entry.layout;
    row.push(length_entry(layout.plate, unit).into());
    row.push(say::spacings(layout, unit).into());
    row.push(length_entry(layout.punch, unit).into());
    let load = asked.force.map(|force| unit.force_number(force, 3));
    row.push(load.unwrap_or("-".into()).into());
    row.push(shortest(asked.gamma_load).into());
    row.push(shortest(asked.gamma_resistance).into());
    let allowed = asked.deflection.map(|v| length_entry(v, unit));
    row.push(allowed.unwrap_or("-".into()).into());
    for c in &v.checks {
        let text = verdict::cell(c, unit);
        row.push(if c.state.fails() { strong(text) } else { text.into() });
    }
    let found = v.finding().word();
    row.push(if v.finding() == Finding::Passes { found.into() } else { strong(found) });
    row
}

/// The results of all layouts.
pub(crate) fn results(report: &Report<'_>, document: &mut ReportDocument) {
    document.chapter("Results");
    if report.cases.is_empty() {
        document.say("The project has no layouts.");
        return;
    }
    let head = [
        "Layout",
        "{F_a}",
        "{delta_a}",
        "{F_a}/{F_l*}",
        "{delta_a}/{delta_l*}",
        "verdict",
        "to know",
    ];
    document.blocks.push(Block::Table {
        head: head.map(ours).to_vec(),
        rows: report.cases.iter().map(|case| result_row(case, report.unit)).collect(),
        numbers: true,
    });
    if let Some(remark) = mixed(report.cases.iter().map(|case| &*case.case.mesh)) {
        document.quote(strong(format!("Note: {remark}.")));
    }
    document.say("Forces are those at failure of the panel, and the forces on each anchor. The last column counts the warnings, which stand in whole with each layout.");
    let series: Vec<Series<'_>> = report
        .cases
        .iter()
        .enumerate()
        .map(|(index, case)| Series { case, check: report.check(index) })
        .collect();
    if series.len() < 2 {
        return;
    }
    let pictures = series
        .chunks(CURVES)
        .enumerate()
        .filter(|(_, some)| !some.iter().all(Series::bare))
        .map(|(index, some)| {
            let (from, to) = (index * CURVES + 1, index * CURVES + some.len());
            let title = if series.len() <= CURVES {
                "Forecast of all layouts".to_string()
            } else {
                format!("Forecast of layouts {from} to {to} of {}", series.len())
            };
            // A chart of a single curve would be that of the layout itself.
            Picture { svg: chart(some, &title, report.unit), caption: title, wide: true }
        })
        .collect();
    document.blocks.push(Block::Pictures(pictures));
}

fn result_row(case: &ExportedLayout, unit: Units) -> Vec<Words> {
    let forecast = &case.forecast();
    let nothing = || Words::from("-");
    let part = |value: Option<f64>| value.map_or_else(nothing, |v| format!("{v:.3}").into());
    let (force, deflection) = match &forecast.field {
        Ok(field) => (
            strong(force_text(field.values.force, unit)),
            strong(maybe_length_text(field.values.deflection, unit)),
        ),
        Err(_) => ("no value".into(), nothing()),
    };
    let v = &case.verdict;
    let found = match v.finding() {
        Finding::NotAsked => nothing(),
        Finding::Passes => verdict::short(v).into(),
        _ => strong(verdict::short(v)),
    };
    let known = match (forecast.warnings.len(), forecast.extrapolated()) {
        (0, _) => nothing(),
        (n, false) => n.to_string().into(),
        (n, true) => strong(format!("{n}, extrapolated")),
    };
    let (f, d) = (forecast.force_over_lab(), forecast.deflection_over_lab());
    vec![case.entry.name.clone().into(), force, deflection, part(f), part(d), found, known]
}

/// The inputs of all layouts.
pub(crate) fn inputs(report: &Report<'_>, document: &mut ReportDocument) {
    if report.cases.is_empty() {
        return;
    }
    document.chapter("Inputs");
    let unit = report.unit;
    let sign = unit.symbol();
    let mut head = vec![Words::from("Layout")];
    for symbol in ["{d}", "{L}", "{D}", "{e_x}", "{e_y}"] {
        let mut words = ours(symbol);
        words.0.push(TextSpan::Plain(format!(" ({sign})")));
        head.push(words);
    }
    for text in
        ["mesh", "branch rule", "design force", "{gamma_F}", "allowable {delta}", "{gamma_R}"]
    {
        head.push(ours(text));
    }
    let rows = report.cases.iter().map(|case| {
        let e = &case.entry;
        let mut row = vec![Words::from(e.name.clone())];
        row.push(length_entry(e.layout.plate, unit).into());
        row.push(say::spacings(&e.layout, unit).into());
        for metres in [e.layout.punch, e.layout.ex, e.layout.ey] {
            row.push(length_entry(metres, unit).into());
        }
        let length = |v: f64| format!("{} {sign}", length_entry(v, unit));
        row.push(code(e.mesh.clone()));
        row.push(e.branch.word().into());
        row.push(e.question.force.map_or("-".into(), |force| entered_force(force, unit)).into());
        row.push(shortest(e.question.gamma_load).into());
        row.push(e.question.deflection.map_or("-".into(), length).into());
        row.push(shortest(e.question.gamma_resistance).into());
        row
    });
    let rows = rows.collect();
    document.blocks.push(Block::Table { head, rows, numbers: true });
}

/// A force as it was entered.
pub(crate) fn entered_force(newton: f64, unit: Units) -> String {
    let exact = match unit.force {
        ForceUnit::Kilonewton => shortest(unit.force(newton)),
        _ => force_entry(newton, unit),
    };
    format!("{exact} {}", unit.force_symbol())
}

/// The meshes that the layouts use, each once.
pub(crate) fn meshes(report: &Report<'_>, document: &mut ReportDocument) {
    let mut seen: Vec<&str> = Vec::new();
    for case in report.cases {
        if seen.contains(&case.case.mesh.id.as_str()) {
            continue;
        }
        if seen.is_empty() {
            document.chapter("Meshes");
        }
        seen.push(&case.case.mesh.id);
        mesh(&case.case.mesh, case, report.unit, document);
    }
}

fn mesh(mesh: &MeshType, case: &ExportedLayout, unit: Units, document: &mut ReportDocument) {
    let lab = &mesh.laboratory;
    let length = |v: f64| format!("{} {}", length_entry(v, unit), unit.symbol());
    let mut rows = vec![
        (Words::from("Identifier"), code(mesh.id.clone())),
        (
            "Punch test".into(),
            format!(
                "{} at {}, {} values",
                entered_force(lab.force, unit),
                lab.deflection.map_or("a deflection that is not stated".into(), length),
                lab.statistic.word()
            )
            .into(),
        ),
        (
            "Panel and punch of the test".into(),
            format!("{} and {}", length(lab.panel), length(lab.punch)).into(),
        ),
    ];
    if !lab.standard.is_empty() {
        rows.push(("Standard".into(), lab.standard.clone().into()));
    }
    rows.push(("Source".into(), lab.source.clone().into()));
    let ratios = &case.forecast().ratios;
    let source = match &mesh.ratios {
        Some(own) => own.source.clone(),
        None if mesh.reference => "Pol & Gabrieli (2021), section 4".into(),
        None => "assumed: those of the double-twist reference mesh".into(),
    };
    rows.push((
        ours("{alpha_F}, {alpha_delta}"),
        format!("{:.4}, {:.4}; {source}", ratios.force, ratios.deflection).into(),
    ));
    document.section(mesh.title().to_string());
    document.facts(["Mesh", ""], rows);
}

/// How a reviewer gets the same numbers.
pub(crate) fn repeat(report: &Report<'_>, document: &mut ReportDocument) {
    document.chapter("How to repeat it");
    document.quote(format!(
        "Every number above comes from meshcast {VERSION}; another version may round or warn differently. The command lines with each layout print its values; with --format json they print the inputs' fingerprint too, which must be the one given here."
    ));
    let Some(text) = report.source.text.filter(|_| !report.source.file_name.is_empty()) else {
        return;
    };
    let file = crate::export::command::file_word(report.source.file_name);
    document.say("The file is the one named above if its hash is the same. The whole report, and the paper's own table beside this program's values, come from:");
    document.blocks.push(Block::Commands(vec![
        format!("sha256sum {file}   # {}", sha256(text)),
        format!("meshcast report {file} --format html"),
        "meshcast validate".to_string(),
    ]));
}

fn sha256(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().fold(String::new(), |mut out, byte| {
        // Writing to a string cannot fail.
        let _ = write!(out, "{byte:02x}");
        out
    })
}
