//! A comparison as a table of 80 columns, the governing layout named below, and what to know.

use super::{Compared, both, mark};
use crate::case::Derived;
use crate::cli::VERSION;
use crate::cli::page::{BASIS, NAME, NO_LAYOUTS, Page, cut, percent};
use crate::remark::Weight;
use crate::study::compare::{CompareRow, Comparison};
use crate::units::{LengthUnit, force_text, significant, to_kn};

/// The table with its notes.
pub(crate) fn report(compared: &Compared, order: &[usize], unit: LengthUnit) -> String {
    let c = &compared.comparison;
    if c.rows.is_empty() {
        return NO_LAYOUTS.to_string();
    }
    let mut page = Page::new(unit);
    page.line(
        "compare",
        format!("{} layouts   [meshcast {VERSION}, inputs {}]", c.rows.len(), c.fingerprint()),
    );
    meshes(&mut page, c);
    page.lines.push(String::new());
    page.lines.push(format!(
        "  {:<NAME$}{:>6}{:>6}{:>6}{:>6}{:>6}{:>7}{:>7}{:>6}{:>6}{:>6}",
        "layout", "d", "L", "D", "ex", "ey", "F_a", "delta", "F/Fl", "d/dl", "use"
    ));
    let u = unit.symbol();
    page.lines.push(format!(
        "  {:<NAME$}{u:>6}{u:>6}{u:>6}{u:>6}{u:>6}{:>7}{u:>7}{:>6}{:>6}{:>6}",
        "", "kN", "", "", "%"
    ));
    for index in order {
        let governs = c.governing.is_some_and(|g| g.row == *index);
        page.lines.push(line(&c.rows[*index], governs, unit));
    }
    page.lines.push(String::new());
    governing(&mut page, c);
    both::table(&mut page, compared, order);
    for index in order {
        remarks(&mut page, &c.rows[*index]);
    }
    page.line("basis", BASIS);
    page.text()
}

fn meshes(page: &mut Page, c: &Comparison) {
    let mut ids: Vec<&str> = c.rows.iter().map(|r| r.case.mesh.id.as_str()).collect();
    ids.sort_unstable();
    ids.dedup();
    page.line(if ids.len() == 1 { "mesh" } else { "meshes" }, ids.join(", "));
    if ids.len() > 1 {
        for row in &c.rows {
            page.line("", format!("{}: {}", row.name, row.case.mesh.id));
        }
    }
}

fn line(row: &CompareRow, governs: bool, unit: LengthUnit) -> String {
    let l = &row.case.layout;
    let size = |v: f64| match unit {
        LengthUnit::Metre => format!("{v:.2}"),
        LengthUnit::Millimetre => format!("{:.0}", v * unit.per_metre()),
    };
    let deflection = |v: f64| match unit {
        LengthUnit::Metre => format!("{v:.3}"),
        LengthUnit::Millimetre => size(v),
    };
    let (force, reached) = match row.values() {
        Ok(v) => (significant(to_kn(v.force), 3), deflection(v.deflection)),
        // In the two columns together.
        Err(why) => (String::new(), why.short().to_string()),
    };
    let forecast = row.forecast();
    let ratio = |v: Option<f64>| v.map_or("-".to_string(), |v| format!("{v:.3}"));
    let line = format!(
        "{} {}{:>6}{:>6}{:>6}{:>6}{:>6}{:>14}{:>6}{:>6}{:>6} {}",
        if governs { ">" } else { " " },
        cut(&row.name, NAME),
        size(l.plate),
        size(l.spacing),
        size(l.punch),
        size(l.ex),
        size(l.ey),
        format!("{force:>7}{reached:>7}").trim_start(),
        ratio(forecast.and_then(|f| f.force_over_lab())),
        ratio(forecast.and_then(|f| f.deflection_over_lab())),
        row.utilisation().map_or("-".to_string(), percent),
        mark(row)
    );
    line.trim_end().to_string()
}

fn governing(page: &mut Page, c: &Comparison) {
    let text = match c.governing {
        Some(g) => {
            let row = &c.rows[g.row];
            match (g.text(), row.values()) {
                (Some(text), _) => format!("{}: {text}", row.name),
                (None, Ok(v)) => format!(
                    "{}: the lowest force, {}; no layout has a design force",
                    row.name,
                    force_text(v.force)
                ),
                (None, Err(_)) => row.name.clone(),
            }
        }
        None => "none, no layout has a value".to_string(),
    };
    page.line("> governing", text);
}

fn remarks(page: &mut Page, row: &CompareRow) {
    let name = &row.name;
    let at = row.answer().and_then(|a| a.at_force);
    if let Some((at, trouble)) = at.and_then(|at| Some((at, at.trouble()?))) {
        let load = force_text(at.load);
        let text = match at.deflection.filter(|_| at.over_allowed()) {
            Some(reached) => {
                format!("{name}: {} at {load}{}", page.length(reached), at.allowed_text())
            }
            None => format!("{name}: {} short at {load}", force_text(-at.margin)),
        };
        page.line(trouble, text);
    }
    match &row.derived {
        Ok(Derived { forecast: f, .. }) => {
            let all = f.warnings.iter().filter(|w| w.weight() >= Weight::Caution);
            let all: Vec<String> = all.map(|w| w.short()).collect();
            if !all.is_empty() {
                page.line("!", format!("{name}: {}", all.join("; ")));
            }
        }
        Err(problems) => {
            for p in problems {
                page.line("!", format!("{name}: {p}"));
            }
        }
    }
}
