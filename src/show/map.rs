//! A map: cells of two inputs with a sign of rising density and, where it fits, the number.

use super::effect;
use super::glyphs::Glyphs;
use super::picture::{Ink, Picture};
use crate::case::{CaseValue, NoValue};
use crate::forecast::NoField;
use crate::study::checks::figures::Figures;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::sensitivity::Effect;

/// From little to much; eight signs that can be told apart on paper and without colour.
const SHADES: [char; 8] = ['.', ':', '-', '=', '+', 'o', '#', '@'];
/// Columns of the values of the second input, with their line.
pub(crate) const LEFT: usize = 9;
/// Columns of a cell with a number.
const NUMBER: usize = 7;
/// Columns that the values under a map take at least, where not all of them fit.
const APART: usize = 7;

/// Why a cell has no value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NoCell {
    /// The punch is on a plate.
    OnPlate,
    /// The block is smaller than the opening of the mesh.
    Through,
    /// There is no relation for the grid.
    Grid,
    /// The inputs make no sense together.
    Senseless,
    /// No run of the check broke a wire.
    NoBreak,
    /// The layout cannot be checked.
    Impossible,
}

impl NoCell {
    /// All of them with their signs and legends.
    const ALL: [(NoCell, char, &str); 6] = [
        (NoCell::OnPlate, 'P', "P block on a plate"),
        (NoCell::Through, 'T', "T block below the mesh opening"),
        (NoCell::Grid, 'G', "G no relation for the grid"),
        (NoCell::Senseless, '?', "? makes no sense"),
        (NoCell::NoBreak, 'n', "n no break"),
        (NoCell::Impossible, 'X', "X cannot be checked"),
    ];

    fn sign(self) -> char {
        NoCell::ALL.iter().find(|row| row.0 == self).map_or(' ', |row| row.1)
    }
}

/// A cell of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell {
    /// A value, SI.
    Value(f64),
    /// Why there is none.
    None(NoCell),
    /// Nothing is known yet, or ever.
    Empty,
}

/// The cell of a forecast.
pub(crate) fn forecast(outcome: &CaseValue, shown: Effect) -> Cell {
    match outcome {
        Ok(point) => effect::read(point, shown).map_or(Cell::Empty, Cell::Value),
        Err(NoValue::Outside(NoField::PunchOnPlate)) => Cell::None(NoCell::OnPlate),
        Err(NoValue::Outside(NoField::PassesThrough)) => Cell::None(NoCell::Through),
        Err(NoValue::Outside(NoField::Grid)) => Cell::None(NoCell::Grid),
        Err(NoValue::Outside(NoField::Overlap)) => Cell::None(NoCell::Impossible),
        Err(NoValue::Senseless(_)) => Cell::None(NoCell::Senseless),
    }
}

/// The cell of a check with its figures.
pub(crate) fn checked(answer: &CheckAnswer, figures: Option<&Figures>, shown: Effect) -> Cell {
    match answer {
        // A run that slipped has no force of its own.
        Ok(_) => figures
            .and_then(|f| effect::found(f, shown))
            .map_or(Cell::None(NoCell::NoBreak), Cell::Value),
        Err(NoCheck::Impossible(_)) => Cell::None(NoCell::Impossible),
        Err(NoCheck::Laboratory | NoCheck::NotMade) => Cell::Empty,
    }
}

/// Smallest and largest value of some cells.
pub(crate) fn extent<'a>(cells: impl Iterator<Item = &'a Cell>) -> Option<(f64, f64)> {
    let values = cells.filter_map(|cell| match cell {
        Cell::Value(v) => Some((*v, *v)),
        Cell::None(_) | Cell::Empty => None,
    });
    values.reduce(|(least, most), (v, _)| (least.min(v), most.max(v)))
}

/// The shades with the value from which each stands.
pub(crate) fn shades((least, most): (f64, f64)) -> impl Iterator<Item = (char, f64)> {
    let step = (most - least) / SHADES.len() as f64;
    SHADES.into_iter().enumerate().map(move |(i, sign)| (sign, least + step * i as f64))
}

/// What the marks of a verdict mean, of those that stand in some cells.
pub(crate) fn marks_legend(marks: &[char]) -> String {
    let all = [('x', "x fails"), ('?', "? behind a value: doubtful")];
    let there = all.iter().filter(|row| marks.contains(&row.0)).map(|row| row.1);
    there.collect::<Vec<&str>>().join(", ")
}

/// The legend of the signs that stand in some cells, empty where there are none.
pub(crate) fn legend<'a>(cells: impl Iterator<Item = &'a Cell> + Clone) -> String {
    let there = |why: NoCell| cells.clone().any(|cell| *cell == Cell::None(why));
    let signs = NoCell::ALL.iter().filter(|row| there(row.0)).map(|row| row.2);
    signs.collect::<Vec<&str>>().join(", ")
}

/// Places of at most `most` of `count` values at equal distances, both ends included.
fn thinned(count: usize, most: usize) -> Vec<usize> {
    let shown = count.min(most);
    let last = shown.saturating_sub(1).max(1);
    (0..shown).map(|i| (i * (count - 1) + last / 2) / last).collect()
}

fn shade(value: f64, (least, most): (f64, f64)) -> char {
    let part = if most > least { (value - least) / (most - least) } else { 0.0 };
    let level = (part * SHADES.len() as f64) as usize;
    SHADES[level.min(SHADES.len() - 1)]
}

/// Which columns and rows of a map are drawn, and how wide a cell is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fit {
    /// Places of the columns drawn.
    pub(crate) columns: Vec<usize>,
    /// Places of the rows drawn, the largest value first.
    pub(crate) rows: Vec<usize>,
    cell: usize,
}

impl Fit {
    /// For columns and values of rows, in a width with the labels and in so many rows.
    pub(crate) fn new(columns: usize, rows: &[f64], width: usize, height: usize) -> Fit {
        let across = width.saturating_sub(LEFT);
        let columns = thinned(columns, across);
        let cell = match across / columns.len().max(1) {
            wide if wide >= NUMBER => NUMBER,
            some => some.clamp(1, 3),
        };
        let mut upwards = thinned(rows.len(), height);
        // Upwards is more, whichever way the range runs.
        upwards.sort_by(|a, b| rows[*b].total_cmp(&rows[*a]));
        Fit { columns, rows: upwards, cell }
    }

    /// Columns of all cells together.
    pub(crate) fn width(&self) -> usize {
        self.columns.len() * self.cell
    }
}

/// Cells that are drawn on one line of a row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MapLayer<'a> {
    /// The cells, row by row.
    pub(crate) cells: &'a [Cell],
    /// What they stand for.
    pub(crate) ink: Ink,
    /// Marks of the verdict, cell by cell: `x` and `?` are drawn in it. Empty where nothing is asked.
    pub(crate) marks: &'a [char],
}

/// A map to draw.
pub(crate) struct CellMap<'a> {
    /// What is drawn of it.
    pub(crate) fit: &'a Fit,
    /// The values of all columns and rows as texts.
    pub(crate) labels: (Vec<String>, Vec<String>),
    /// One line of a row each.
    pub(crate) layers: &'a [MapLayer<'a>],
    /// Where the shades begin and end.
    pub(crate) ends: (f64, f64),
    /// How a value is written.
    pub(crate) number: &'a dyn Fn(f64) -> String,
    /// A cell that is marked.
    pub(crate) marked: Option<usize>,
    /// Signs of the axes.
    pub(crate) glyphs: Glyphs,
}

/// The rows with their values at the left, and below them the axis with the values of the columns. The
/// last line is that of these values, the line before it the axis.
pub(crate) fn draw(map: &CellMap) -> Picture {
    let (fit, lines) = (map.fit, map.layers.len());
    let (columns, rows) = &map.labels;
    let height = fit.rows.len() * lines;
    // The last value may stand out.
    let mut picture = Picture::new(LEFT + fit.width() + NUMBER, height + 2);
    for (place, row) in fit.rows.iter().enumerate() {
        picture.put_right(place * lines, LEFT - 2, &rows[*row], Ink::Text);
        for (line, layer) in map.layers.iter().enumerate() {
            let line = place * lines + line;
            picture.put(line, LEFT - 1, map.glyphs.upright(), Ink::Text);
            for (at, column) in fit.columns.iter().enumerate() {
                let index = row * columns.len() + column;
                let ink = if map.marked == Some(index) { Ink::Selected } else { layer.ink };
                let text = text(layer.cells.get(index), map, fit.cell);
                picture.put(line, LEFT + at * fit.cell, &text, ink);
                if let Some(mark @ ('x' | '?')) = layer.marks.get(index)
                    && matches!(layer.cells.get(index), Some(Cell::Value(_)))
                {
                    // In the last column of the cell, which else is blank or a repeated sign.
                    let ink = if map.marked == Some(index) { ink } else { Ink::Caution };
                    picture.put(line, LEFT + (at + 1) * fit.cell - 1, &mark.to_string(), ink);
                }
            }
        }
    }
    let rule = format!("{}{}", map.glyphs.corner(), map.glyphs.rule().repeat(fit.width()));
    picture.put(height, LEFT - 1, &rule, Ink::Heading);
    for (at, text) in values(fit, columns) {
        picture.put(height + 1, LEFT + at, text, Ink::Text);
    }
    picture
}

/// The values below a map with their columns in it: as many as stand apart, the last one in any case.
fn values<'a>(fit: &Fit, texts: &'a [String]) -> Vec<(usize, &'a str)> {
    let all = || fit.columns.iter().enumerate().map(|(place, c)| (place * fit.cell, &*texts[*c]));
    if fit.cell == NUMBER {
        return all().collect();
    }
    let Some((_, last)) = all().next_back() else { return Vec::new() };
    let end = fit.width().saturating_sub(last.len());
    let mut values: Vec<(usize, &str)> = all()
        .step_by(APART / fit.cell + 1)
        .filter(|(at, text)| *at == 0 || at + text.len() < end)
        .collect();
    let first = values.first().map_or(0, |first| first.1.len() + 1);
    if fit.columns.len() > 1 {
        values.push((end.max(first), last));
    }
    values
}

fn text(cell: Option<&Cell>, map: &CellMap, width: usize) -> String {
    let (sign, number) = match cell {
        Some(Cell::Value(v)) => (shade(*v, map.ends), (map.number)(*v)),
        Some(Cell::None(why)) => (why.sign(), String::new()),
        Some(Cell::Empty) | None => (' ', String::new()),
    };
    // The blank stands behind: numbers of five characters would touch the next cell's sign.
    if width == NUMBER { format!("{sign}{number:<6}") } else { sign.to_string().repeat(width) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(cells: &[Cell], width: usize, glyphs: Glyphs) -> Vec<String> {
        let rows = [0.5, 1.5];
        let fit = Fit::new(2, &rows, width, 9);
        let map = CellMap {
            fit: &fit,
            labels: (vec!["2.00".into(), "3.00".into()], vec!["0.5".into(), "1.5".into()]),
            layers: &[MapLayer { cells, ink: Ink::Text, marks: &[] }],
            ends: (10.0, 20.0),
            number: &|v| format!("{v:.1}"),
            marked: Some(3),
            glyphs,
        };
        let picture = draw(&map);
        assert!(picture.cells().any(|cell| cell.0 == 0 && cell.3 == Ink::Selected));
        picture.lines()
    }

    #[test]
    fn more_is_upwards_and_cells_read_without_colour() {
        let cells =
            [Cell::Value(10.0), Cell::Value(20.0), Cell::None(NoCell::OnPlate), Cell::Value(15.1)];
        assert_eq!(
            drawn(&cells, 40, Glyphs::Ascii),
            [
                "    1.5 |P      +15.1",
                "    0.5 |.10.0  @20.0",
                "        +--------------",
                "         2.00   3.00"
            ]
        );
        let narrow = drawn(&cells, 15, Glyphs::Block);
        assert_eq!(narrow[..2], ["    1.5 │PPP+++", "    0.5 │...@@@"]);
        assert_eq!(narrow[3], "         2.00 3.00");
    }

    #[test]
    fn a_verdict_stands_in_the_last_column_of_its_cell() {
        let rows = [0.5];
        let draw_in = |width| {
            let fit = Fit::new(2, &rows, width, 9);
            let layer = MapLayer {
                cells: &[Cell::Value(10.0), Cell::Value(20.0)],
                ink: Ink::Text,
                marks: &['x', '+'],
            };
            draw(&CellMap {
                fit: &fit,
                labels: (vec!["2.00".into(), "3.00".into()], vec!["0.5".into()]),
                layers: &[layer],
                ends: (10.0, 20.0),
                number: &|v| format!("{v:.1}"),
                marked: None,
                glyphs: Glyphs::Ascii,
            })
            .lines()
            .remove(0)
        };
        assert_eq!(draw_in(40), "    0.5 |.10.0 x@20.0");
        assert_eq!(draw_in(15), "    0.5 |..x@@@");
        assert_eq!(marks_legend(&['+', 'x', ' ']), "x fails");
    }

    #[test]
    fn only_signs_that_stand_there_are_explained() {
        let cells = [Cell::None(NoCell::Impossible), Cell::Empty, Cell::None(NoCell::NoBreak)];
        assert_eq!(legend(cells.iter()), "n no break, X cannot be checked");
        assert_eq!(legend(cells[1..2].iter()), "");
        assert_eq!(extent(cells.iter()), None);
        assert_eq!(
            extent([Cell::Value(2.0), Cell::Empty, Cell::Value(-1.0)].iter()),
            Some((-1.0, 2.0))
        );
    }

    #[test]
    fn a_map_is_thinned_to_its_room() {
        assert_eq!(shade(1.0, (1.0, 1.0)), '.');
        assert_eq!(thinned(9, 20), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(thinned(9, 3), [0, 4, 8]);
        assert!(thinned(9, 0).is_empty());
        let texts: Vec<String> = (0..30).map(|i| format!("{i}.0")).collect();
        let fit = Fit::new(30, &[1.0], LEFT + 60, 9);
        let columns: Vec<(usize, &str)> = values(&fit, &texts);
        assert_eq!(columns[..2], [(0, "0.0"), (8, "4.0")]);
        assert_eq!(columns[6..], [(48, "24.0"), (56, "29.0")]);
        let from: Vec<(char, f64)> = shades((0.0, 8.0)).collect();
        assert_eq!((from[0], from[7]), (('.', 0.0), ('@', 7.0)));
    }
}
