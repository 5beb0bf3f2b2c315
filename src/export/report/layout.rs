//! One layout of the report: pictures, the value at each step, design, warnings, command lines.

use super::Report;
use super::document::{Block, Picture, ReportDocument, Words, code, ours, sentence, strong};
use super::front::entered_force;
use crate::export::svg::{Series, chart, plan};
use crate::export::{Check, ExportedLayout, command};
use crate::forecast::{Field, Strength, Values, field};
use crate::layout::Layout;
use crate::mesh::STANDARD_PANEL;
use crate::show::say;
use crate::show::verdict;
use crate::study::verdict::Finding;
use crate::units::{
    Units, energy_text, force_text, length_entry, length_text, shortest, significant,
};
use crate::words::Choice;

/// Writes the section of a layout.
pub(crate) fn layout(
    report: &Report<'_>,
    index: usize,
    case: &ExportedLayout,
    document: &mut ReportDocument,
) {
    let unit = report.unit;
    let name = heading(index, case, document);
    if !case.entry.note.trim().is_empty() {
        document.blocks.push(Block::Free(case.entry.note.clone()));
    }
    judged(case, unit, document);
    warnings(case, unit, document);
    let check = report.check(index);
    pictures(name, Series { case, check }, unit, document);
    steps(case, unit, document);
    if let Ok(field) = &case.forecast().field {
        if let Some(end) = field.end() {
            points(&end, unit, document);
        }
        anchors(&case.case.layout, field, unit, document);
    }
    design(case, unit, document);
    if let Some(check) = check {
        checked(case, check, unit, document);
    }
    let mut lines = Vec::new();
    if !report.source.file_name.is_empty() {
        lines.push(command::from_file(report.source.file_name, case));
    }
    lines.extend(command::from_numbers(case));
    if !lines.is_empty() {
        let mut words = Words::from("The same numbers; fingerprint of the forecast's inputs ");
        words.0.extend(code(case.case.fingerprint().to_string()).0);
        words.0.extend(Words::from(":").0);
        document.quote(words);
        document.blocks.push(Block::Commands(lines));
    }
}

/// Chart, where there is a line to draw, and plan.
fn pictures(name: &str, series: Series<'_>, unit: Units, document: &mut ReportDocument) {
    let caption = format!("{name}: force over deflection");
    let lines = (!series.bare()).then(|| Picture {
        svg: chart(&[series], &caption, unit),
        caption,
        wide: true,
    });
    let plan =
        Picture { svg: plan(series.case, unit), caption: format!("{name}: plan"), wide: false };
    document.blocks.push(Block::Pictures(lines.into_iter().chain([plan]).collect()));
}

/// A layout on one page: verdict, what to distrust, curve and plan.
pub(crate) fn short(
    report: &Report<'_>,
    index: usize,
    case: &ExportedLayout,
    document: &mut ReportDocument,
) {
    let unit = report.unit;
    let name = heading(index, case, document);
    judged(case, unit, document);
    warnings(case, unit, document);
    pictures(name, Series { case, check: report.check(index) }, unit, document);
}

/// Begins the section of a layout and returns its name.
fn heading<'a>(index: usize, case: &'a ExportedLayout, document: &mut ReportDocument) -> &'a str {
    let name = &case.entry.name;
    document.section(format!("{}. {name}", index + 1));
    name
}

/// Whether it is enough: each check, what to know beside it, and what would mend it.
fn judged(case: &ExportedLayout, unit: Units, document: &mut ReportDocument) {
    let v = &case.verdict;
    if v.finding() == Finding::NotAsked {
        return;
    }
    document.quote(strong(format!("{}; {} values", verdict::short(v), v.basis.word())));
    let lines = verdict::lines(&case.case, v, unit).into_iter();
    document.blocks.push(Block::List(lines.map(Words::from).collect()));
}

fn warnings(case: &ExportedLayout, unit: Units, document: &mut ReportDocument) {
    let mut all: Vec<_> = case.forecast().warnings.iter().collect();
    all.sort_by_key(|w| std::cmp::Reverse(w.weight()));
    if all.is_empty() {
        document.say("No warnings: all sizes are inside the published ranges.");
        return;
    }
    let items = all.iter().map(|w| {
        let mut words = strong(format!("{}: ", sentence(w.weight().word()).trim_end_matches('.')));
        words.0.extend(Words::from(sentence(&w.sentence(unit))).0);
        words
    });
    document.blocks.push(Block::List(items.collect()));
}

/// The value at each step of the method.
fn steps(case: &ExportedLayout, unit: Units, document: &mut ReportDocument) {
    let forecast = &case.forecast();
    let mut rows = Vec::new();
    let four = |v: f64| significant(v, 4);
    let length = |v: f64| format!("{} {}", unit.length_with(v, 1), unit.symbol());
    let mut row = |words: Words, force: String, deflection: String| {
        rows.push(vec![words, force.into(), deflection.into()]);
    };
    let pair = |v: Strength| {
        let delta = v.deflection.map_or("-".into(), length);
        (format!("{} {}", unit.force_number(v.force, 4), unit.force_symbol()), delta)
    };
    let lab = &case.case.mesh.laboratory;
    if lab.panel != STANDARD_PANEL {
        let (f, d) = pair(Strength { force: lab.force, deflection: lab.deflection });
        let panel =
            format!("laboratory test, panel {} {}", length_entry(lab.panel, unit), unit.symbol());
        row(panel.into(), f, d);
    }
    let (f, d) = pair(forecast.laboratory);
    row(ours("laboratory, standard panel: {F_l*}, {delta_l*}"), f, d);
    let r = &forecast.ratios;
    row(ours("ratios {alpha_F}, {alpha_delta}"), four(r.force), four(r.deflection));
    let (f, d) = pair(forecast.reference);
    row(ours("field reference {F_a*}, {delta_a*} (step 1)"), f, d);
    if let Ok(values) = &forecast.field {
        let branch = values.branch;
        let layout = &forecast.layout;
        let (words, ratios, map) = match values.method {
            None => (
                format!(
                    "relations A.1, A.2 for a {}, over the reference",
                    branch.word().replace('_', " ")
                ),
                [field::force_ratio(layout, branch), field::deflection_ratio(layout, branch)],
                "eccentricity factors (map of Fig. A1)",
            ),
            Some(method) => {
                let at = method.sizes.at(layout);
                let words = format!(
                    "relations of the derived method for {} blocks, over the reference",
                    method.blocks.word()
                );
                (words, [at.force, at.deflection], "factors of the offset (derived method)")
            }
        };
        row(words.into(), four(ratios[0]), four(ratios[1]));
        let (f, d) = pair(Strength {
            force: ratios[0] * forecast.reference.force,
            deflection: forecast.reference.deflection.map(|delta| ratios[1] * delta),
        });
        row("centred block".into(), f, d);
        let e = &forecast.eccentricity;
        let with_sd = |v: f64, sd: f64| {
            if sd > 0.0 { format!("{} \u{b1} {}", four(v), significant(sd, 2)) } else { four(v) }
        };
        row(map.into(), with_sd(e.force, e.force_sd), with_sd(e.deflection, e.deflection_sd));
        let (f, d) = pair(values.values);
        rows.push(vec![ours("at failure: {F_a}, {delta_a} (step 2)"), strong(f), strong(d)]);
        let mut row = |words: Words, force: String, deflection: String| {
            rows.push(vec![words, force.into(), deflection.into()]);
        };
        if let Some(published) = values.published {
            let (f, d) = pair(published);
            row("the same by the published method".into(), f, d);
        }
        if let Some(other) = values.other_branch {
            let (f, d) = pair(other);
            let relation = branch.other().word().replace('_', " ");
            row(format!("the same by the other branch ({relation})").into(), f, d);
        }
        let over = [forecast.force_over_lab(), forecast.deflection_over_lab()];
        let [f, d] = over.map(|ratio| ratio.map_or("-".into(), four));
        row(ours("over the laboratory: {F_a}/{F_l*}, {delta_a}/{delta_l*}"), f, d);
    }
    document.blocks.push(Block::Table {
        head: ["step", "force", "deflection"].map(Words::from).to_vec(),
        rows,
        numbers: true,
    });
}

/// A few points of the curve.
fn points(end: &Values, unit: Units, document: &mut ReportDocument) {
    let rows = [25, 50, 75, 90, 100].map(|percent| {
        let delta = end.deflection * f64::from(percent) / 100.0;
        vec![
            Words::from(format!("{percent} %")),
            length_text(delta, unit).into(),
            force_text(end.force_at(delta), unit).into(),
            unit.stiffness_number(end.tangent_at(delta)).into(),
            unit.stiffness_number(end.secant_at(delta)).into(),
            unit.energy_number(end.energy_to(delta)).into(),
        ]
    });
    let stiffness = unit.stiffness_symbol();
    let head = [
        "of {delta_a}".to_string(),
        "{delta}".to_string(),
        "{F}".to_string(),
        format!("tangent ({stiffness})"),
        format!("secant ({stiffness})"),
        format!("energy ({})", unit.energy_symbol()),
    ];
    document.blocks.push(Block::Table {
        head: head.iter().map(|words| ours(words)).collect(),
        rows: rows.to_vec(),
        numbers: true,
    });
}

/// What each anchor carries.
fn anchors(layout: &Layout, field: &Field, unit: Units, document: &mut ReportDocument) {
    let (which, said) = say::anchors(layout, field.values.force, unit);
    document.say(&format!("What the panel can ask of a bolt: {which} {said}."));
}

/// The answers to the design questions, with the factors that act.
fn design(case: &ExportedLayout, unit: Units, document: &mut ReportDocument) {
    let question = &case.case.asked();
    let Some(answer) = &case.design() else {
        if question.force.is_some() || question.deflection.is_some() {
            document.say("Design: no answer, because there is no field value.");
        }
        return;
    };
    let mut items = vec![ours(&format!(
        "Resistance {{F_a}} / {{gamma_R}} = {} with {{gamma_R}} = {}.",
        force_text(answer.resistance, unit),
        shortest(question.gamma_resistance)
    ))];
    if let (Some(at), Some(force)) = (&answer.at_force, question.force) {
        items.push(ours(&format!(
            "Design force {} with {{gamma_F}} = {}: load {}, utilisation {} %, margin {}.",
            entered_force(force, unit),
            shortest(question.gamma_load),
            force_text(at.load, unit),
            significant(at.utilisation * 100.0, 3),
            force_text(at.margin, unit)
        )));
        items.push(match at.deflection {
            Some(reached) => {
                let reached = length_text(reached, unit);
                ours(&format!("Deflection under that load: {reached}."))
            }
            None if at.beyond_failure => {
                ours("That load is beyond failure: there is no deflection.")
            }
            None => ours("Deflection: unknown, the laboratory record has none."),
        });
    }
    if let (Some(at), Some(deflection)) = (&answer.at_deflection, question.deflection) {
        let fails = if at.beyond_failure { " The panel fails before it is reached." } else { "" };
        items.push(ours(&format!(
            "At the allowable deflection of {} {}: {} mobilised, {} with {{gamma_R}}, {} absorbed.{fails}",
            length_entry(deflection, unit),
            unit.symbol(),
            force_text(at.force, unit),
            force_text(at.design_force, unit),
            energy_text(at.energy, unit)
        )));
    }
    document.quote(strong("Design"));
    document.blocks.push(Block::List(items));
}

/// The check beside the forecast.
fn checked(case: &ExportedLayout, check: &Check, unit: Units, document: &mut ReportDocument) {
    document.quote(strong(sentence(&check.title())));
    let mut items = Vec::new();
    if let Some(end) = check.mean.failure {
        let difference = case.forecast().field.ok().map_or(String::new(), |field| {
            let percent =
                |ours: f64, theirs: f64| format!("{:+.0} %", (ours / theirs - 1.0) * 100.0);
            format!(
                "; against the forecast {} in force{}",
                percent(end.force, field.values.force),
                field.values.deflection.map_or(String::new(), |delta| {
                    format!(" and {} in deflection", percent(end.deflection, delta))
                })
            )
        });
        let at =
            format!("{} at {}", force_text(end.force, unit), length_text(end.deflection, unit));
        items.push(Words::from(format!("First break {at}{difference}.")));
    }
    items.extend(check.notes.iter().map(|note| Words::from(sentence(note))));
    if !items.is_empty() {
        document.blocks.push(Block::List(items));
    }
}
