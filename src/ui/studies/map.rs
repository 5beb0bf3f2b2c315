//! A sweep of two inputs as a map: cells with a sign of rising density and, where it fits, the number;
//! the checks below the forecast in each cell, or instead of it.

use super::super::text::{cut, put};
use super::super::theme::Theme;
use super::sweep::{found, read};
use super::{nothing, symbol, unit_of};
use crate::app::App;
use crate::app::studies::sweep::SweepView;
use crate::study::case::{NoValue, input_unit, input_value};
use crate::study::checks::NoCheck;
use crate::study::sensitivity::Effect;
use crate::units::{LengthUnit, significant};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// From little to much; eight signs that can be told apart without colour.
const SHADES: [char; 8] = ['.', ':', '-', '=', '+', 'o', '#', '@'];
/// Columns of the values of the second input, with their line.
const LEFT: u16 = 9;
/// Columns of a cell with a number.
const NUMBER: usize = 7;

/// A cell: a value, a sign for why there is none, or nothing.
#[derive(Clone, Copy)]
enum Cell {
    Value(f64),
    Sign(char),
    Empty,
}

/// Draws the map with its legend.
pub(crate) fn draw(app: &App, view: &SweepView, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let Some(grid) = &view.grid else { return };
    let Some(second) = &grid.second else { return };
    let unit = app.units();
    let (forecast, checks) = cells(view, unit);
    let values = forecast.iter().chain(&checks).filter_map(|cell| match cell {
        Cell::Value(v) => Some(*v),
        Cell::Sign(_) | Cell::Empty => None,
    });
    let ends = values.fold(None, |ends: Option<(f64, f64)>, v| {
        Some(ends.map_or((v, v), |(a, b)| (a.min(v), b.max(v))))
    });
    let Some(ends) = ends else {
        return nothing("no value anywhere on the map", area, buf, theme);
    };
    // Legend above; axis, values and name below.
    let room = area.height.saturating_sub(4);
    let many = grid.rows.len() as u16;
    let any = view.coverage.any();
    let two = any && room >= 2 * many;
    let layer = if any && !two && view.checks_shown { &checks } else { &forecast };
    legend(view, ends, (any && !two && view.checks_shown, two), area, buf, unit, theme);
    let across = usize::from(area.width.saturating_sub(LEFT));
    let shown = grid.columns.len().min(across);
    let width = match across / shown.max(1) {
        wide if wide >= NUMBER => NUMBER,
        some => some.clamp(1, 3),
    };
    let columns = thinned(grid.columns.len(), shown);
    let lines = if two { 2 } else { 1 };
    let rows = thinned(grid.rows.len(), usize::from(room / lines));
    // Upwards is more, whichever way the range runs.
    let mut upwards = rows;
    upwards.sort_by(|a, b| grid.rows[*b].total_cmp(&grid.rows[*a]));
    let mut line = area.y + 1;
    for row in upwards {
        let at = Rect { y: line, height: lines, ..area };
        let text = input_value(second.input, grid.rows[row], unit);
        put(buf, at, 0, 0, &format!("{text:>7} {}", theme.upright()), theme.text);
        if two {
            put(buf, at, 1, 0, &format!("{:>7} {}", "", theme.upright()), theme.text);
        }
        for (place, column) in columns.iter().enumerate() {
            let index = row * grid.columns.len() + column;
            let x = LEFT + (place * width) as u16;
            let marked = index == view.marked;
            let style = if marked { theme.selected } else { theme.text };
            put(buf, at, 0, x, &text_of(layer.get(index), ends, width, true), style);
            if two {
                let style = if marked { theme.selected } else { theme.check };
                put(buf, at, 1, x, &text_of(checks.get(index), ends, width, true), style);
            }
        }
        line += lines;
    }
    let foot = Rect { y: line, height: area.bottom().saturating_sub(line), ..area };
    let rule = theme.rule().repeat(columns.len() * width);
    put(buf, foot, 0, LEFT - 1, &format!("{}{rule}", theme.corner()), theme.heading);
    let head = format!("{} {}", second.input.symbol(), input_unit(second.input, unit));
    put(buf, foot, 0, 0, &cut(&head, 7), theme.heading);
    let value = |c: usize| input_value(grid.first.input, grid.columns[c], unit);
    // As many values as stand apart.
    let every = (6 / width.max(1)).max(1);
    let every = if width == NUMBER { 1 } else { every + 1 };
    for (place, column) in columns.iter().enumerate().step_by(every) {
        put(buf, foot, 1, LEFT + (place * width) as u16, &value(*column), theme.text);
    }
    let name = format!("{} {}", grid.first.input.symbol(), input_unit(grid.first.input, unit));
    put(buf, foot, 1, 0, &cut(&format!("{name:>7}"), 8), theme.heading);
}

/// The cells of forecast and checks, in the unit shown.
fn cells(view: &SweepView, unit: LengthUnit) -> (Vec<Cell>, Vec<Cell>) {
    let effect = view.shown;
    let forecast = view.points.iter().map(|outcome| match outcome {
        Ok(p) => read(p, effect, unit).map_or(Cell::Empty, Cell::Value),
        Err(NoValue::PunchOnPlate) => Cell::Sign('P'),
        Err(NoValue::Senseless(_)) => Cell::Sign('?'),
    });
    let checks = view.answers.iter().zip(&view.figures).map(|(answer, figures)| match answer {
        // A run that slipped has no force of its own.
        Ok(_) => figures
            .as_ref()
            .and_then(|f| found(f, effect, unit))
            .map_or(Cell::Sign('s'), Cell::Value),
        Err(NoCheck::Impossible(_)) => Cell::Sign('x'),
        Err(NoCheck::Laboratory | NoCheck::NotMade) => Cell::Empty,
    });
    (forecast.collect(), checks.collect())
}

/// Places of at most `most` of `count` values at equal distances, both ends included.
fn thinned(count: usize, most: usize) -> Vec<usize> {
    let shown = count.min(most);
    if shown == 0 {
        return Vec::new();
    }
    let last = (shown - 1).max(1);
    (0..shown).map(|i| (i * (count - 1) + last / 2) / last).collect()
}

fn shade(value: f64, (least, most): (f64, f64)) -> char {
    let part = if most > least { (value - least) / (most - least) } else { 0.0 };
    let level = (part * SHADES.len() as f64) as usize;
    SHADES[level.min(SHADES.len() - 1)]
}

/// Three digits, or none behind the point for what is a length in millimetres.
fn number(v: f64) -> String {
    significant(v, 3)
}

fn text_of(cell: Option<&Cell>, ends: (f64, f64), width: usize, shaded: bool) -> String {
    let (sign, text) = match cell {
        Some(Cell::Value(v)) => (if shaded { shade(*v, ends) } else { ' ' }, number(*v)),
        Some(Cell::Sign(sign)) => (*sign, String::new()),
        Some(Cell::Empty) | None => (' ', String::new()),
    };
    if width == NUMBER { format!("{sign} {text:<5}") } else { sign.to_string().repeat(width) }
}

fn legend(
    view: &SweepView,
    ends: (f64, f64),
    (checks, two): (bool, bool),
    area: Rect,
    buf: &mut Buffer,
    unit: LengthUnit,
    theme: &Theme,
) {
    let (least, most) = ends;
    let step = (most - least) / SHADES.len() as f64;
    let from = |i: usize| number(least + step * i as f64);
    let what = match (checks, view.shown) {
        (true, Effect::Force) => "DEM F",
        (false, Effect::Force) => "F_a",
        (true, Effect::Deflection) => "DEM delta",
        (false, Effect::Deflection) => "delta_a",
        (true, Effect::Utilisation) => "DEM use",
        (false, Effect::Utilisation) => symbol(view.shown),
    };
    let below = if two { ", DEM below" } else { "" };
    let shades: Vec<String> =
        SHADES.iter().enumerate().map(|(i, sign)| format!("{sign}{}", from(i))).collect();
    let mut text = format!(
        "{what} {}{below}: {} to {}",
        unit_of(view.shown, unit),
        shades.join(" "),
        number(most)
    );
    let there = |why: fn(&NoValue) -> bool| view.points.iter().any(|p| p.as_ref().is_err_and(why));
    if there(|why| *why == NoValue::PunchOnPlate) {
        text.push_str("; P on plate");
    }
    if there(|why| matches!(why, NoValue::Senseless(_))) {
        text.push_str("; ? no sense");
    }
    put(buf, area, 0, 1, &cut(&text, usize::from(area.width.saturating_sub(2))), theme.heading);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_read_without_colour() {
        let text = |v| text_of(Some(&Cell::Value(v)), (10.0, 20.0), NUMBER, true);
        assert_eq!([text(10.0), text(15.1), text(20.0)], [". 10.0 ", "+ 15.1 ", "@ 20.0 "]);
        assert_eq!(text_of(Some(&Cell::Sign('P')), (0.0, 1.0), 3, true), "PPP");
        assert_eq!(text_of(None, (0.0, 1.0), 2, true), "  ");
        assert_eq!(shade(1.0, (1.0, 1.0)), '.');
        assert_eq!(thinned(9, 20), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(thinned(9, 3), [0, 4, 8]);
        assert!(thinned(9, 0).is_empty());
    }
}
