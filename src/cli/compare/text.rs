//! A comparison as a table of 80 columns, the governing layout named below, and what to know.

use super::{Compared, both, mark};
use crate::case::{Derived, Input};
use crate::cli::VERSION;
use crate::cli::page::{BASIS, NAME, NO_LAYOUTS, Page, cut};
use crate::remark::Weight;
use crate::show::comparison::{self, width};
use crate::study::compare::{Column, CompareRow, Comparison};
use crate::units::{LengthUnit, force_text};

/// Columns of the table behind the name.
const COLUMNS: [Column; 10] = [
    Column::Size(Input::Plate),
    Column::Size(Input::Spacing),
    Column::Size(Input::Punch),
    Column::Size(Input::OffsetX),
    Column::Size(Input::OffsetY),
    Column::Force,
    Column::Deflection,
    Column::ForceRatio,
    Column::DeflectionRatio,
    Column::Utilisation,
];

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
    let head = |word: &str, part: fn(Column, LengthUnit) -> &'static str| {
        let cell = |column: &Column| format!("{:>w$}", part(*column, unit), w = width(*column));
        let cells: String = COLUMNS.iter().map(cell).collect();
        format!("  {word:<NAME$}{cells}")
    };
    page.lines.push(head("layout", |column, unit| comparison::head(column, unit).0));
    page.lines.push(head("", |column, unit| comparison::head(column, unit).1));
    for index in order {
        let governs = c.governing.is_some_and(|g| g.row == *index);
        page.lines.push(line(&c.rows[*index], governs, unit));
    }
    page.lines.push(String::new());
    page.line("> governing", comparison::governing(c));
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
    let cells: String = (COLUMNS.iter())
        .map(|column| {
            let text = match (column, row.values()) {
                // In the two columns together.
                (Column::Force, Err(_)) => return String::new(),
                (Column::Deflection, Err(why)) => return format!("{:>14}", why.short()),
                _ => comparison::cell(row, *column, unit),
            };
            format!("{text:>w$}", w = width(*column))
        })
        .collect();
    let sign = if governs { ">" } else { " " };
    format!("{sign} {}{cells} {}", cut(&row.name, NAME), mark(row)).trim_end().to_string()
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
            let all: Vec<String> = all.map(crate::forecast::warning::Warning::short).collect();
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
