//! A sweep of two inputs as maps of shaded cells: the second input upwards, the first to the right.
//! Light is little, dense is much; where there is room the number stands in the cell.

use super::Swept;
use super::text::deflection;
use crate::cli::page::{Page, WIDTH, input_unit, input_value, percent};
use crate::study::case::{NoValue, Outcome, Point};
use crate::study::sweep::{Axis, extent};
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
    fn read(self, p: &Point) -> Option<f64> {
        match self {
            Shown::Force => Some(p.values().force),
            Shown::Deflection => Some(p.values().deflection),
            Shown::Utilisation => p.utilisation(),
        }
    }

    fn text(self, v: f64, unit: LengthUnit) -> String {
        match self {
            Shown::Force => significant(to_kn(v), 3),
            Shown::Deflection => deflection(v, unit),
            Shown::Utilisation => percent(v),
        }
    }

    fn title(self, unit: LengthUnit) -> String {
        match self {
            Shown::Force => "F_a, kN".into(),
            Shown::Deflection => format!("delta_a, {}", unit.symbol()),
            Shown::Utilisation => "use, %".into(),
        }
    }
}

/// Draws a map of F_a, of delta_a, and with a design force of the utilisation.
pub fn draw(page: &mut Page, s: &Swept, second: &Axis) {
    let asked = s.case.question.force.is_some();
    for shown in [Shown::Force, Shown::Deflection, Shown::Utilisation] {
        if shown != Shown::Utilisation || asked {
            one(page, s, second, shown);
        }
    }
}

/// Places of at most `most` of `count` values at equal distances, both ends included.
fn thinned(count: usize, most: usize) -> Vec<usize> {
    let shown = count.min(most);
    let last = shown.saturating_sub(1).max(1);
    (0..shown).map(|i| (i * (count - 1) + last / 2) / last).collect()
}

fn one(page: &mut Page, s: &Swept, second: &Axis, shown: Shown) {
    let (unit, grid) = (page.unit, &s.sweep.grid);
    page.lines.push(String::new());
    let Some((least, most)) = extent(&s.sweep.points, |p| shown.read(p)) else {
        page.line("field", "no value anywhere on the map");
        return;
    };
    let across = WIDTH - LEFT;
    let columns = thinned(grid.columns.len(), across);
    let rows = thinned(grid.rows.len(), MOST_ROWS);
    let width = match across / columns.len().max(1) {
        wide if wide >= NUMBER => NUMBER,
        some => some.clamp(1, 3),
    };
    legend(page, &s.sweep.points, shown, (least, most));
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
            .map(|c| {
                cell(
                    &s.sweep.points[row * grid.columns.len() + c],
                    shown,
                    (least, most),
                    width,
                    unit,
                )
            })
            .collect();
        let at = input_value(second.input, grid.rows[row], unit);
        page.lines.push(format!("{at:>7} |{}", cells.trim_end()));
    }
    axis(page, s, &columns, width);
}

fn legend(page: &mut Page, points: &[Outcome], shown: Shown, (least, most): (f64, f64)) {
    let unit = page.unit;
    let step = (most - least) / SHADES.len() as f64;
    let shades: Vec<String> = SHADES
        .iter()
        .enumerate()
        .map(|(i, sign)| format!("{sign} {}", shown.text(least + step * i as f64, unit)))
        .collect();
    let top = shown.text(most, unit);
    page.line(&shown.title(unit), format!("from: {}  up to {top}", shades.join("  ")));
    let missing = |code: &str| points.iter().any(|o| o.as_ref().is_err_and(|e| e.code() == code));
    let signs = [("punch_on_plate", "P punch on a plate"), ("senseless", "? makes no sense")];
    let signs: Vec<&str> = signs.into_iter().filter(|s| missing(s.0)).map(|s| s.1).collect();
    if !signs.is_empty() {
        page.line("", signs.join(", "));
    }
}

fn shade(value: f64, (least, most): (f64, f64)) -> char {
    let part = if most > least { (value - least) / (most - least) } else { 0.0 };
    let level = (part * SHADES.len() as f64) as usize;
    SHADES[level.min(SHADES.len() - 1)]
}

fn cell(
    outcome: &Outcome,
    shown: Shown,
    ends: (f64, f64),
    width: usize,
    unit: LengthUnit,
) -> String {
    let (sign, number) = match outcome {
        Ok(p) => match shown.read(p) {
            Some(v) => (shade(v, ends), shown.text(v, unit)),
            None => (' ', String::new()),
        },
        Err(NoValue::PunchOnPlate) => ('P', String::new()),
        Err(NoValue::Senseless(_)) => ('?', String::new()),
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
