//! Design solutions as sentences.

use super::Solved;
use crate::case::{CaseValue, NoValue};
use crate::cli::page::{BASIS, Page, pages, percent};
use crate::forecast::NoField;
use crate::forecast::warning::Warning;
use crate::remark::Weight;
use crate::show::say;
use crate::study::solve::{Crossing, Place, Requirement, RequirementKind, Solution};
use crate::units::{Units, force_text};

/// Behind a deflection at the design force.
const AT_LOAD: &str = "at F";

/// The reports of all layouts, an empty line between them.
pub(crate) fn report(solved: &[Solved], unit: Units) -> String {
    pages(solved, |s| one(s, unit))
}

fn one(s: &Solved, unit: Units) -> String {
    let mut page = Page::new(unit);
    page.inputs("design", s.name.as_deref(), s.case.question_fingerprint(), &s.case);
    if s.solutions.is_empty() {
        page.line("asked", "nothing: no design force, no allowable deflection");
        return page.text();
    }
    asked(&mut page, s);
    match &s.outcome {
        Ok(point) => {
            page.line("FIELD", say::values(point.values(), page.unit));
            page.design(&point.answer, &s.case.asked());
            page.verdict(&s.case, &s.verdict);
        }
        Err(why) => page.line("field", why.sentence()),
    }
    let mut heading = None;
    for solution in &s.solutions {
        if heading != Some(solution.input) {
            heading = Some(solution.input);
            let (min, max) = (page.entry(solution.range.min), page.entry(solution.range.max));
            page.lines.push(String::new());
            page.line(
                &format!("SOLVE {}", solution.input.word()),
                format!(
                    "{}, searched from {min} to {max}, all else as it stands",
                    solution.range.words
                ),
            );
        }
        sentences(&mut page, solution);
    }
    page.lines.push(String::new());
    page.line("basis", BASIS);
    page.text()
}

fn asked(page: &mut Page, s: &Solved) {
    let q = s.case.asked();
    let mut words = Vec::new();
    if let Some(force) = q.force {
        words.push(format!("carry {}", force_text(force, page.unit)));
    }
    if let Some(deflection) = q.deflection {
        let what = if q.force.is_some() { "at that force" } else { "at failure" };
        words.push(format!("deflect at most {} {what}", page.entry(deflection)));
    }
    page.line("asked", words.join(", "));
}

fn sentences(page: &mut Page, s: &Solution) {
    let head = format!("  {}", s.requirement.word());
    if s.always() {
        let ends: Vec<String> = s.ends.iter().map(|e| place(page, e, s.requirement)).collect();
        page.line(&head, format!("met in the whole range: {}", ends.join("; ")));
        return;
    }
    if s.never() {
        let mut ends: Vec<String> = s.ends.iter().map(|e| place(page, e, s.requirement)).collect();
        if let Some(best) = s.best.as_ref().filter(|b| s.ends.iter().all(|e| e.value != b.value)) {
            ends.push(format!("nearest: {}", place(page, best, s.requirement)));
        }
        page.line(&head, format!("NOT MET anywhere in the range: {}", ends.join("; ")));
        return;
    }
    let spans: Vec<String> = s
        .spans
        .iter()
        .map(|span| format!("from {} to {}", length(page, span.from), length(page, span.to)))
        .collect();
    page.line(&head, format!("met {}", spans.join(" and ")));
    for c in &s.crossings {
        let text = crossing(page, c, s);
        page.line("", text);
    }
}

/// A length at a tenth of a millimetre, or of what the unit shown has for a millimetre.
fn length(page: &Page, metres: f64) -> String {
    format!("{} {}", page.unit.length_with(metres, 1), page.unit.symbol())
}

fn crossing(page: &Page, c: &Crossing, s: &Solution) -> String {
    let (word, at) = (s.input.word(), length(page, c.value));
    let side = if c.met_above { "or more" } else { "or less" };
    let mut text = match c.kind {
        RequirementKind::Exact => {
            let take = match c.rounded {
                _ if !c.advised => " (no cure: more rock hangs on each anchor)".to_string(),
                Some(r) => format!(" (take {} {side})", page.length(r)),
                None => String::new(),
            };
            format!(
                "{word} {at} just meets it{take}: {}",
                say::point_at_load(&c.point, page.unit, AT_LOAD)
            )
        }
        RequirementKind::Jump => format!(
            "at {word} {at} the forecast jumps (branch of A.1-A.2): met with {}, not beyond with {}",
            say::point_at_load(&c.point, page.unit, AT_LOAD),
            outcome(page, &c.beyond)
        ),
        RequirementKind::Edge => format!(
            "{word} {at} is the end of the method, beyond it {}: {}",
            outcome(page, &c.beyond),
            say::point_at_load(&c.point, page.unit, AT_LOAD)
        ),
    };
    let heavy = |w: &&Warning| w.weight() >= Weight::Caution;
    for warning in c.point.warnings.iter().filter(heavy) {
        text.push_str(&format!("; ! {}", warning.short(page.unit)));
    }
    text
}

fn outcome(page: &Page, o: &CaseValue) -> String {
    match o {
        Ok(p) => say::point_at_load(p, page.unit, AT_LOAD),
        Err(NoValue::Outside(NoField::PunchOnPlate)) => "the block is on a plate".to_string(),
        Err(NoValue::Outside(NoField::PassesThrough)) => {
            "the block is smaller than the opening of the mesh".to_string()
        }
        Err(NoValue::Outside(NoField::Grid)) => "no relation for this grid".to_string(),
        Err(NoValue::Outside(NoField::Overlap)) => "mirrored blocks overlap".to_string(),
        Err(NoValue::Senseless(_)) => "plate or block is as large as the spacing".to_string(),
    }
}

fn place(page: &Page, p: &Place, requirement: Requirement) -> String {
    let at = page.length(p.value);
    let Ok(point) = &p.outcome else { return format!("at {at} {}", outcome(page, &p.outcome)) };
    let used = point.utilisation().map(|u| format!("use {} %", percent(u)));
    let reached = match &point.answer.at_force {
        None => page.maybe_length(point.values().deflection),
        Some(force) => match force.service_deflection {
            Some(reached) => page.length(reached),
            None if point.field.end().is_none() => "no deflection".to_string(),
            None => "failure before the load".to_string(),
        },
    };
    match (requirement, used) {
        (Requirement::Force, Some(used)) => format!("at {at} {used}"),
        (Requirement::Both, Some(used)) => format!("at {at} {used}, {reached}"),
        _ => format!("at {at} {reached}"),
    }
}
