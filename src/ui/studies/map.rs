//! A sweep of two inputs as a map: the checks below the forecast in each cell, or instead of it.

use super::super::text::{self, cut, put, width};
use super::super::theme::Theme;
use super::{nothing, size};
use crate::app::App;
use crate::app::studies::sweep::SweepView;
use crate::case::{Input, input_unit, input_value};
use crate::show::effect;
use crate::show::map::{self, Cell, CellMap, Fit, LEFT, MapLayer};
use crate::show::picture::Ink;
use crate::show::verdict;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Rows of the axis across and of the values below it.
const FOOT: usize = 2;

/// Draws the map with its legend.
pub(crate) fn draw(app: &App, view: &SweepView, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let Some(grid) = &view.grid else { return };
    let Some(second) = &grid.second else { return };
    let unit = app.units();
    let (forecast, checks) = cells(view);
    let Some(ends) = map::extent(forecast.iter().chain(&checks)) else {
        return nothing("no value anywhere on the map", area, buf, theme);
    };
    let (columns, rows) = size(area);
    let basis = app.project().basis;
    let marks = verdict::marks(&view.case, grid, &view.points, &view.answers, basis);
    let any = view.coverage.any();
    let head = |two: bool| {
        let check = any && !two && view.checks_shown;
        let seen: Vec<Cell> = match (two, check) {
            (true, _) => forecast.iter().chain(&checks).copied().collect(),
            (false, true) => checks.clone(),
            (false, false) => forecast.clone(),
        };
        let title = format!(
            "{} {}{}",
            effect::whose(view.shown, check),
            effect::unit(view.shown, unit),
            if two { ", DEM below" } else { "" }
        );
        let number = |v| effect::number(v, view.shown, unit);
        let signs = [map::legend(seen.iter()), map::marks_legend(&marks)];
        let signs: Vec<String> = signs.into_iter().filter(|signs| !signs.is_empty()).collect();
        legend(&title, ends, &number, &signs.join(", "), columns)
    };
    let room = |head: &[String]| rows.saturating_sub(head.len() + FOOT + 1);
    let both = head(true);
    let two = any && room(&both) >= 2 * grid.rows.len();
    let head = if two { both } else { head(false) };
    let layers: &[MapLayer] = match (two, any && view.checks_shown) {
        (true, _) => &[
            MapLayer { cells: &forecast, ink: Ink::Text, marks: &marks },
            MapLayer { cells: &checks, ink: Ink::Check, marks: &[] },
        ],
        (false, true) => &[MapLayer { cells: &checks, ink: Ink::Text, marks: &marks }],
        (false, false) => &[MapLayer { cells: &forecast, ink: Ink::Text, marks: &marks }],
    };
    let fit = Fit::new(grid.columns.len(), &grid.rows, columns, room(&head) / layers.len());
    let label =
        |input, values: &[f64]| values.iter().map(|v| input_value(input, *v, unit)).collect();
    let picture = map::draw(&CellMap {
        fit: &fit,
        labels: (label(grid.first.input, &grid.columns), label(second.input, &grid.rows)),
        layers,
        ends,
        number: &|v| effect::number(v, view.shown, unit),
        marked: Some(view.marked),
        glyphs: theme.glyphs,
    });
    for (row, text) in head.iter().enumerate() {
        put(buf, area, row as u16, 1, &cut(text, columns.saturating_sub(2)), theme.heading);
    }
    let body = text::below(area, head.len() as u16);
    text::draw(&picture, body, buf, theme);
    let foot = text::below(body, (fit.rows.len() * layers.len()) as u16);
    let name = |input: Input| format!("{} {}", input.symbol(), input_unit(input, unit));
    put(buf, foot, 0, 0, &cut(&name(second.input), LEFT - 2), theme.heading);
    put(buf, foot, 1, 0, &cut(&format!("{:>7}", name(grid.first.input)), LEFT - 1), theme.heading);
}

/// The cells of forecast and checks.
fn cells(view: &SweepView) -> (Vec<Cell>, Vec<Cell>) {
    let forecast = view.points.iter().map(|outcome| map::forecast(outcome, view.shown));
    let checks = view.answers.iter().zip(&view.figures);
    let checks = checks.map(|(answer, f)| map::checked(answer, f.as_ref(), view.shown));
    (forecast.collect(), checks.collect())
}

/// The shades with their values, and the signs: in one line, or in two where one is too short.
fn legend(
    title: &str,
    ends: (f64, f64),
    number: &dyn Fn(f64) -> String,
    signs: &str,
    columns: usize,
) -> Vec<String> {
    let shades = map::shades(ends).map(|(sign, from)| format!("{sign}{}", number(from)));
    let shades = shades.collect::<Vec<String>>().join(" ");
    let shades = format!("{title}: {shades} to {}", number(ends.1));
    if signs.is_empty() {
        return vec![shades];
    }
    let line = format!("{shades}; {signs}");
    if usize::from(width(&line)) + 2 <= columns { vec![line] } else { vec![shades, signs.into()] }
}
