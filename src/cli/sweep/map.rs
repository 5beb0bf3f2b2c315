//! A sweep of two inputs as maps: the second input upwards, the first to the right.

use super::Swept;
use crate::cli::page::{Page, WIDTH, input_unit, input_value};
use crate::show::effect;
use crate::show::glyphs::Glyphs;
use crate::show::map::{self, Cell, CellMap, Fit, LEFT, MapLayer};
use crate::show::picture::Ink;
use crate::show::verdict;
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::Effect;
use crate::study::sweep::SweepAxis;

/// Most rows that are drawn.
const MOST_ROWS: usize = 24;

/// Draws a map of F_a, of delta_a, and with a design force of the utilisation and of the deflection
/// at that force; each is followed by
/// that of the checks, where there are any, in the same shades.
pub(crate) fn draw(page: &mut Page, s: &Swept, second: &SweepAxis) {
    let asked = s.case.asked().force.is_some();
    for shown in Effect::all(asked).iter().copied() {
        let forecast: Vec<Cell> =
            s.sweep.points.iter().map(|outcome| map::forecast(outcome, shown)).collect();
        let checked: Option<Vec<Cell>> = s.checked.as_ref().map(|answers| {
            let cell = |(index, answer): (usize, &CheckAnswer)| {
                let asked = s.sweep.grid.case(&s.case, index).asked();
                let figures = answer.as_ref().ok().map(|v| Figures::of(v, None, &asked));
                map::checked(answer, figures.as_ref(), shown)
            };
            answers.iter().enumerate().map(cell).collect()
        });
        let Some(ends) = map::extent(forecast.iter().chain(checked.iter().flatten())) else {
            page.lines.push(String::new());
            page.line("field", "no value anywhere on the map");
            continue;
        };
        for (check, cells) in [(false, Some(&forecast)), (true, checked.as_ref())] {
            if let Some(cells) = cells {
                let symbol = effect::whose(shown, check);
                let title = format!("{symbol}, {}", effect::unit(shown, page.unit));
                one(page, s, second, (&title, shown), cells, ends);
            }
        }
    }
}

fn one(
    page: &mut Page,
    s: &Swept,
    second: &SweepAxis,
    (title, shown): (&str, Effect),
    cells: &[Cell],
    ends: (f64, f64),
) {
    let (unit, grid) = (page.unit, &s.sweep.grid);
    let fit = Fit::new(grid.columns.len(), &grid.rows, WIDTH, MOST_ROWS);
    let marks = verdict::marks(&s.case, grid, &s.sweep.points, &[], s.basis);
    let number = |v| effect::number(v, shown, unit);
    page.lines.push(String::new());
    let shades = map::shades(ends).map(|(sign, from)| format!("{sign} {}", number(from)));
    let shades = shades.collect::<Vec<String>>().join("  ");
    page.line(title, format!("from: {shades}  up to {}", number(ends.1)));
    let signs = [map::legend(cells.iter()), map::marks_legend(&marks)];
    let signs: Vec<String> = signs.into_iter().filter(|signs| !signs.is_empty()).collect();
    if !signs.is_empty() {
        page.line("", signs.join("; "));
    }
    let (columns, rows) = (fit.columns.len(), fit.rows.len());
    if columns < grid.columns.len() || rows < grid.rows.len() {
        let (all, high) = (grid.columns.len(), grid.rows.len());
        page.line(
            "shown",
            format!("{columns} of {all} columns, {rows} of {high} rows; all in JSON and CSV"),
        );
    }
    let name =
        |axis: &SweepAxis| format!("{} {}", axis.input.symbol(), input_unit(axis.input, unit));
    page.lines.push(name(second));
    let label = |axis: &SweepAxis, values: &[f64]| {
        values.iter().map(|v| input_value(axis.input, *v, unit)).collect()
    };
    let picture = map::draw(&CellMap {
        fit: &fit,
        labels: (label(&grid.first, &grid.columns), label(second, &grid.rows)),
        layers: &[MapLayer { cells, ink: Ink::Text, marks: &marks }],
        ends,
        number: &number,
        marked: None,
        glyphs: Glyphs::Ascii,
    });
    page.lines.extend(picture.lines());
    let (name, drawn) = (name(&grid.first), fit.width());
    page.lines.push(format!("{:>LEFT$}{name:^drawn$}", "").trim_end().to_string());
}
