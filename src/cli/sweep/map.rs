//! A sweep of two inputs as maps of shaded cells: the second input upwards, the first to the right.
//! Light is little, dense is much; where there is room the number stands in the cell.

use super::Swept;
use super::text::deflection;
use crate::cli::page::{Page, WIDTH, input_unit, input_value, percent};
use crate::forecast::design::Question;
use crate::study::case::{CasePoint, CaseValue, NoValue};
use crate::study::checks::figures::Figures;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::sweep::SweepAxis;
use crate::units::{LengthUnit, significant, to_kn};

/// From little to much; eight signs that can be told apart on paper and without colour.
const SHADES: [char; 8] = ['.', ':', '-', '=', '+', 'o', '#', '@'];
/// Columns of the values of the second input, with their line.
const LEFT: usize = 9;
/// Columns of a cell with a number.
const NUMBER: usize = 7;
/// Most rows that are drawn.
const MOST_ROWS: usize = 24;

/// What a map shows.
#[derive(Clone, Copy, PartialEq)]
enum Shown {
    Force,
    Deflection,
    Utilisation,
}

impl Shown {
    fn read(self, p: &CasePoint) -> Option<f64> {
        match self {
            Shown::Force => Some(p.values().force),
            Shown::Deflection => Some(p.values().deflection),
            Shown::Utilisation => p.utilisation(),
        }
    }

    /// The same of a check, where a run broke.
    fn found(self, f: &Figures) -> Option<f64> {
        match self {
            Shown::Force => f.mean.map(|v| v.force),
            Shown::Deflection => f.mean.map(|v| v.deflection),
            Shown::Utilisation => f.utilisation,
        }
    }

    fn text(self, v: f64, unit: LengthUnit) -> String {
        match self {
            Shown::Force => significant(to_kn(v), 3),
            Shown::Deflection => deflection(v, unit),
            Shown::Utilisation => percent(v),
        }
    }

    /// The word in front of a map, shorter than the margin.
    fn title(self, unit: LengthUnit, checked: bool) -> String {
        match (self, checked) {
            (Shown::Force, false) => "F_a, kN".into(),
            (Shown::Force, true) => "DEM F, kN".into(),
            (Shown::Deflection, false) => format!("delta_a, {}", unit.symbol()),
            (Shown::Deflection, true) => format!("DEM delta, {}", unit.symbol()),
            (Shown::Utilisation, false) => "use, %".into(),
            (Shown::Utilisation, true) => "DEM use, %".into(),
        }
    }
}

/// A cell: a value, a sign for why there is none, or nothing.
#[derive(Clone, Copy)]
enum Cell {
    Value(f64),
    Sign(char),
    Empty,
}

/// A map: its title and its cells, and the ends of its shades.
struct Layer {
    title: String,
    shown: Shown,
    cells: Vec<Cell>,
    ends: (f64, f64),
}

/// Draws a map of F_a, of delta_a, and with a design force of the utilisation; each is followed by
/// that of the checks, where there are any, in the same shades.
pub(crate) fn draw(page: &mut Page, s: &Swept, second: &SweepAxis) {
    let asked = s.case.question.force.is_some();
    for shown in [Shown::Force, Shown::Deflection, Shown::Utilisation] {
        if shown == Shown::Utilisation && !asked {
            continue;
        }
        let forecast: Vec<Cell> = s.sweep.points.iter().map(|o| forecast(o, shown)).collect();
        let checked: Option<Vec<Cell>> = s.checked.as_ref().map(|answers| {
            answers.iter().map(|answer| checked(answer, &s.case.question, shown)).collect()
        });
        let all = || forecast.iter().chain(checked.iter().flatten());
        let Some(ends) = extent(all()) else {
            page.lines.push(String::new());
            page.line("field", "no value anywhere on the map");
            continue;
        };
        let titles = [false, true].map(|checked| shown.title(page.unit, checked));
        let maps = titles.into_iter().zip([Some(forecast), checked]);
        for (title, cells) in maps {
            if let Some(cells) = cells {
                one(page, s, second, &Layer { title, shown, cells, ends });
            }
        }
    }
}

fn forecast(outcome: &CaseValue, shown: Shown) -> Cell {
    match outcome {
        Ok(p) => shown.read(p).map_or(Cell::Empty, Cell::Value),
        Err(NoValue::PunchOnPlate) => Cell::Sign('P'),
        Err(NoValue::Senseless(_)) => Cell::Sign('?'),
    }
}

fn checked(answer: &CheckAnswer, question: &Question, shown: Shown) -> Cell {
    match answer {
        Ok(v) => shown.found(&Figures::of(v, None, question)).map_or(Cell::Sign('n'), Cell::Value),
        Err(NoCheck::Impossible(_)) => Cell::Sign('X'),
        Err(NoCheck::Laboratory | NoCheck::NotMade) => Cell::Empty,
    }
}

/// Smallest and largest value of some cells.
fn extent<'a>(cells: impl Iterator<Item = &'a Cell>) -> Option<(f64, f64)> {
    cells.fold(None, |extent, cell| match cell {
        Cell::Value(v) => {
            let (least, most) = extent.unwrap_or((*v, *v));
            Some((least.min(*v), most.max(*v)))
        }
        Cell::Sign(_) | Cell::Empty => extent,
    })
}

/// Places of at most `most` of `count` values at equal distances, both ends included.
fn thinned(count: usize, most: usize) -> Vec<usize> {
    let shown = count.min(most);
    let last = shown.saturating_sub(1).max(1);
    (0..shown).map(|i| (i * (count - 1) + last / 2) / last).collect()
}

fn one(page: &mut Page, s: &Swept, second: &SweepAxis, layer: &Layer) {
    let (unit, grid) = (page.unit, &s.sweep.grid);
    page.lines.push(String::new());
    let across = WIDTH - LEFT;
    let columns = thinned(grid.columns.len(), across);
    let rows = thinned(grid.rows.len(), MOST_ROWS);
    let width = match across / columns.len().max(1) {
        wide if wide >= NUMBER => NUMBER,
        some => some.clamp(1, 3),
    };
    legend(page, layer);
    if columns.len() < grid.columns.len() || rows.len() < grid.rows.len() {
        page.line(
            "shown",
            format!(
                "{} of {} columns, {} of {} rows; all in JSON and CSV",
                columns.len(),
                grid.columns.len(),
                rows.len(),
                grid.rows.len()
            ),
        );
    }
    page.lines.push(format!("{} {}", second.input.symbol(), input_unit(second.input, unit)));
    // Upwards is more, whichever way the range runs.
    let mut upwards = rows;
    upwards.sort_by(|a, b| grid.rows[*b].total_cmp(&grid.rows[*a]));
    for row in upwards {
        let cells: String = columns
            .iter()
            .map(|c| cell(layer, row * grid.columns.len() + c, width, unit))
            .collect();
        let at = input_value(second.input, grid.rows[row], unit);
        page.lines.push(format!("{at:>7} |{}", cells.trim_end()));
    }
    axis(page, s, &columns, width);
}

fn legend(page: &mut Page, layer: &Layer) {
    let (unit, shown, (least, most)) = (page.unit, layer.shown, layer.ends);
    let step = (most - least) / SHADES.len() as f64;
    let shades: Vec<String> = SHADES
        .iter()
        .enumerate()
        .map(|(i, sign)| format!("{sign} {}", shown.text(least + step * i as f64, unit)))
        .collect();
    let top = shown.text(most, unit);
    page.line(&layer.title, format!("from: {}  up to {top}", shades.join("  ")));
    let there = |sign: char| layer.cells.iter().any(|c| matches!(c, Cell::Sign(s) if *s == sign));
    let signs = [
        ('P', "P punch on a plate"),
        ('?', "? makes no sense"),
        ('n', "n no break"),
        ('X', "X cannot be checked"),
    ];
    let signs: Vec<&str> = signs.into_iter().filter(|s| there(s.0)).map(|s| s.1).collect();
    if !signs.is_empty() {
        page.line("", signs.join(", "));
    }
}

fn shade(value: f64, (least, most): (f64, f64)) -> char {
    let part = if most > least { (value - least) / (most - least) } else { 0.0 };
    let level = (part * SHADES.len() as f64) as usize;
    SHADES[level.min(SHADES.len() - 1)]
}

fn cell(layer: &Layer, index: usize, width: usize, unit: LengthUnit) -> String {
    let (sign, number) = match layer.cells.get(index) {
        Some(Cell::Value(v)) => (shade(*v, layer.ends), layer.shown.text(*v, unit)),
        Some(Cell::Sign(sign)) => (*sign, String::new()),
        Some(Cell::Empty) | None => (' ', String::new()),
    };
    if width == NUMBER { format!("{sign}{number:<6}") } else { sign.to_string().repeat(width) }
}

/// The values of the first input under the map: first, middle and last, or all where there is room.
fn axis(page: &mut Page, s: &Swept, columns: &[usize], width: usize) {
    let (unit, grid) = (page.unit, &s.sweep.grid);
    let text = |c: usize| input_value(grid.first.input, grid.columns[c], unit);
    let drawn = columns.len() * width;
    page.lines.push(format!("{:>8}+{}", "", "-".repeat(drawn)));
    let mut line = format!("{:>LEFT$}", "");
    if width == NUMBER {
        columns.iter().for_each(|c| line.push_str(&format!("{:<NUMBER$}", text(*c))));
    } else if let (Some(first), Some(last)) = (columns.first(), columns.last()) {
        let (first, last) = (text(*first), text(*last));
        let room = drawn.saturating_sub(first.len()).max(last.len() + 1);
        line.push_str(&format!("{first}{last:>room$}"));
    }
    let name = format!("{} {}", grid.first.input.symbol(), input_unit(grid.first.input, unit));
    page.lines.push(line.trim_end().to_string());
    page.lines.push(format!("{:>LEFT$}{name:^drawn$}", "").trim_end().to_string());
}
