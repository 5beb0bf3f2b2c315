//! A comparison as a table of 80 columns, the governing layout named below, and what to know.

use super::{Compared, both, mark};
use crate::case::Derived;
use crate::cli::VERSION;
use crate::cli::page::{BASIS, NAME, NO_LAYOUTS, Page, cut};
use crate::remark::Weight;
use crate::show::comparison::{self, width};
use crate::show::verdict::short;
use crate::study::compare::{Column, CompareRow, Comparison};
use crate::study::verdict::Finding;
use crate::units::Units;
use crate::words::Choice;

/// Columns of the table behind the name: as many of all as 80 columns hold.
fn columns() -> impl Iterator<Item = Column> {
    Column::ALL.iter().copied().filter(|column| match column {
        Column::Size(_)
        | Column::Force
        | Column::Deflection
        | Column::ForceRatio
        | Column::DeflectionRatio
        | Column::Use => true,
        Column::Name
        | Column::Mesh
        | Column::Utilisation
        | Column::DesignDeflection
        | Column::ServiceDeflection
        | Column::Warnings => false,
    })
}

/// The table with its notes.
pub(crate) fn report(compared: &Compared, order: &[usize], unit: Units) -> String {
    let c = &compared.comparison;
    if c.rows.is_empty() {
        return NO_LAYOUTS.to_string();
    }
    let mut page = Page::new(unit);
    let count = match c.rows.len() {
        1 => "1 layout".to_string(),
        n => format!("{n} layouts"),
    };
    page.line("compare", format!("{}   [meshcast {VERSION}, inputs {}]", count, c.fingerprint()));
    meshes(&mut page, c);
    page.lines.push(String::new());
    let head = |word: &str, part: fn(Column, Units) -> &'static str| {
        let cell = |column: Column| format!("{:>w$}", part(column, unit), w = width(column));
        let cells: String = columns().map(cell).collect();
        format!("  {word:<NAME$}{cells}")
    };
    page.lines.push(head("layout", |column, unit| comparison::head(column, unit).0));
    page.lines.push(head("", |column, unit| comparison::head(column, unit).1));
    for index in order {
        let governs = c.governing.is_some_and(|g| g.row == *index);
        let mark = c.rows[*index].verdict.finding().mark();
        page.lines.push(line(&c.rows[*index], governs, mark, unit));
    }
    page.lines.push(String::new());
    let (name, why) = comparison::governing(c, page.unit);
    let name = name.map_or(String::new(), |name| format!("{name}: "));
    page.line("> governing", name + &why);
    if let Some(remark) = c.mixed() {
        page.line("!", remark);
    }
    both::table(&mut page, compared, order);
    for index in order {
        let found = &c.rows[*index].verdict;
        if found.finding() != Finding::NotAsked {
            let name = &c.rows[*index].name;
            page.line(
                &format!("{} verdict", found.finding().mark()),
                format!("{name}: {}", short(found)),
            );
        }
    }
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

fn line(row: &CompareRow, governs: bool, found: char, unit: Units) -> String {
    let cells: String = columns()
        .map(|column| {
            let text = match (column, row.values()) {
                // In the two columns together.
                (Column::Force, Err(_)) => return String::new(),
                (Column::Deflection, Err(why)) => return format!("{:>14}", why.short()),
                _ => comparison::cell(row, column, unit),
            };
            format!("{text:>w$}", w = width(column))
        })
        .collect();
    let sign = if governs { ">" } else { " " };
    format!("{sign}{found}{}{cells} {}", cut(&row.name, NAME), mark(row)).trim_end().to_string()
}

fn remarks(page: &mut Page, row: &CompareRow) {
    let name = &row.name;
    match &row.derived {
        Ok(Derived { forecast: f, .. }) => {
            let all = f.warnings.iter().filter(|w| w.weight() >= Weight::Caution);
            let all: Vec<String> = all.map(|w| w.short(page.unit)).collect();
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
