//! A sweep as a text: a line of one input with its plot turned on its side, or a map of two.

use super::{Swept, both, map, point};
use crate::case::CaseValue;
use crate::cli::dem::text as dem;
use crate::cli::page::{BASIS, Page, WIDTH, input_unit, input_value, pages, percent};
use crate::show::effect::{deflection, maybe_deflection};
use crate::show::strip::{StripMark, strip};
use crate::study::result::Wanted;
use crate::study::sweep::{SweepAxis, extent};
use crate::study::verdict::{Simulated, verdict};
use crate::units::{Units, force_text, shortest};

/// The reports of all layouts, an empty line between them.
pub(crate) fn report(swept: &[Swept], wanted: Option<&Wanted>, unit: Units) -> String {
    pages(swept, |s| one(s, wanted, unit))
}

fn one(s: &Swept, wanted: Option<&Wanted>, unit: Units) -> String {
    let mut page = Page::new(unit);
    let grid = &s.sweep.grid;
    page.inputs("sweep", s.name.as_deref(), grid.fingerprint(&s.case), &s.case);
    for axis in std::iter::once(&grid.first).chain(&grid.second) {
        page.line("vary", range(axis, unit));
    }
    if let Some(force) = s.case.asked().force {
        let q = &s.case.question;
        page.line(
            "design",
            format!(
                "{}, gamma_load {}, gamma_resistance {}",
                force_text(force, unit),
                shortest(q.gamma_load),
                shortest(q.gamma_resistance)
            ),
        );
    }
    if let Some(wanted) = wanted {
        dem::plan(&mut page, wanted);
    }
    match (&grid.second, &s.checked) {
        (None, None) => line_plot(&mut page, s),
        (None, Some(answers)) => both::line_plot(&mut page, s, answers),
        (Some(second), _) => map::draw(&mut page, s, second),
    }
    codes(&mut page, &s.sweep.points);
    if let Some(answers) = &s.checked {
        let named = answers.iter().enumerate().map(|(index, answer)| (point(grid, index), answer));
        dem::notes(&mut page, named);
    }
    page.line("basis", BASIS);
    page.text()
}

fn range(axis: &SweepAxis, unit: Units) -> String {
    format!(
        "{} from {} to {} {} in {} values",
        axis.input.symbol(),
        input_value(axis.input, axis.from, unit),
        input_value(axis.input, axis.to, unit),
        input_unit(axis.input, unit),
        axis.steps
    )
}

fn line_plot(page: &mut Page, s: &Swept) {
    let (unit, input, points) = (page.unit, s.sweep.grid.first.input, &s.sweep.points);
    let forces = extent(points, |p| Some(p.values().force));
    let deflections = extent(points, |p| p.values().deflection);
    let Some(forces) = forces else {
        page.line("field", "no value anywhere in the range");
        return;
    };
    let kn = |v: f64| unit.force_number(v, 3);
    page.line(
        "plot",
        format!(
            "F from {} to {} {}{}, left to right{}",
            kn(forces.0),
            kn(forces.1),
            unit.force_symbol(),
            deflections.map_or(String::new(), |(least, most)| format!(
                ", x delta_a from {} to {} {}, * both",
                deflection(least, unit),
                deflection(most, unit),
                unit.symbol()
            )),
            if s.case.asked().force.is_some() { "; : where use is 100 %" } else { "" }
        ),
    );
    page.lines.push(String::new());
    let asked = s.case.asked().force.is_some();
    let used = if asked { format!("{:>7}{:>9}", "use %", "at F") } else { String::new() };
    let head = format!("{} {}", input.symbol(), input_unit(input, unit));
    let delta = format!("delta {}", unit.symbol());
    let front =
        format!("{head:>11}{:>8}{delta:>10}{used}    ", format!("F_a {}", unit.force_symbol()));
    let width = WIDTH - front.len() - 2;
    page.lines.push(front.trim_end().to_string());
    for (at, outcome) in s.sweep.grid.columns.iter().zip(points) {
        let case = s.case.with(input, *at);
        let found = verdict(&case, outcome, Simulated::Missing, s.basis).finding().mark();
        let at = input_value(input, *at, unit);
        let line = match outcome {
            Err(why) => format!("{at:>11}{:>18}", why.short()),
            Ok(p) => {
                let v = p.values();
                let used = match p.utilisation() {
                    Some(u) => {
                        let service = p.service_deflection().map(|v| deflection(v, unit));
                        format!("{:>7}{:>9}", percent(u), service.unwrap_or("-".into()))
                    }
                    None => String::new(),
                };
                let mark = format!("{found}{}", if p.doubtful() { "!" } else { " " });
                // F_a at which the factored resistance is the factored load.
                let needed = p.answer.at_force.map(|at| at.utilisation * v.force);
                let marks = [
                    needed.map(|needed| StripMark::at(needed, forces, ':')),
                    v.deflection.zip(deflections).map(|(v, ends)| StripMark::at(v, ends, 'x')),
                    Some(StripMark::at(v.force, forces, 'F')),
                ];
                let drawn = strip(width, marks.into_iter().flatten());
                format!(
                    "{at:>11}{:>8}{:>10}{used} {mark} |{drawn}|",
                    kn(v.force),
                    maybe_deflection(v.deflection, unit)
                )
            }
        };
        page.lines.push(line);
    }
    page.lines.push(String::new());
}

/// What the points warn of, with how many of them do.
fn codes(page: &mut Page, points: &[CaseValue]) {
    let mut counted: Vec<(&'static str, usize)> = Vec::new();
    let mut count = |code: &'static str| match counted.iter_mut().find(|(c, _)| *c == code) {
        Some((_, n)) => *n += 1,
        None => counted.push((code, 1)),
    };
    for outcome in points {
        match outcome {
            Ok(p) => p.warnings.iter().for_each(|w| count(w.code())),
            Err(why) => count(why.code()),
        }
    }
    let all = points.len();
    for (code, n) in counted {
        page.line("warning", format!("{code}: {n} of {all} points"));
    }
}
