//! The screens: pure functions from the program's state to a buffer of characters. One panel a file.
//!
//! At 80x24 (title and bottom line are [`hint`]):
//!
//! ```text
//!  title
//!  layouts         | curve
//!  ...             | ... (chart)
//!  inputs          |
//!  ...             |
//!  range           | answer              cell
//!  laboratory to   | ...                 ... (plan)
//!  field (ratios)  |
//!  keys, message or prompt
//! ```
//!
//! From 110x34 the left column is wider, with ranges beside the inputs, and warnings in whole
//! sentences and points along the curve stand below the answer. Below 80x24 [`compact`] takes over,
//! below 40x12 one line says so.

pub(crate) mod answer;
pub(crate) mod chart;
pub(crate) mod check;
pub(crate) mod compact;
pub(crate) mod confirm;
pub(crate) mod contours;
mod curves;
mod empty;
pub(crate) mod export;
pub(crate) mod hint;
pub(crate) mod inputs;
pub(crate) mod layouts;
mod list;
pub(crate) mod mesh_form;
mod mesh_picker;
pub(crate) mod open;
pub(crate) mod page;
pub(crate) mod plan;
pub(crate) mod ratios;
pub(crate) mod settings;
pub(crate) mod studies;
pub(crate) mod text;
pub(crate) mod theme;
pub(crate) mod tour;
pub(crate) mod warnings;

use crate::app::{App, Mode};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use text::{below, heading};
use theme::Theme;

/// Columns and rows below which only a line of text is shown.
pub(crate) const SMALLEST: (u16, u16) = (40, 12);
/// Columns and rows of the full screen.
const FULL: (u16, u16) = (80, 24);
/// Columns and rows from which more is shown.
const LARGE: (u16, u16) = (110, 34);

/// Draws the whole screen. Returns the place of what is selected or typed, where the terminal's cursor
/// has to stand: screen readers, braille lines and input methods follow it.
pub fn draw(app: &App, buf: &mut Buffer) -> Option<Position> {
    let area = buf.area;
    let theme = Theme::new(app.look());
    let fits = |size: (u16, u16)| area.width >= size.0 && area.height >= size.1;
    if !fits(SMALLEST) {
        let line = format!("too small: q quits; {}x{} of 40x12", area.width, area.height);
        text::put(buf, area, 0, 0, &line, theme.text);
        return None;
    }
    let top = Rect { height: 1, ..area };
    let bottom = Rect { y: area.bottom() - 1, height: 1, ..area };
    let middle = Rect { y: area.y + 1, height: area.height - 2, ..area };
    hint::title(app, top, buf, &theme);
    if let Some(page) = app.page_open() {
        let place = studies::draw(app, page, middle, buf, &theme);
        return hint::bottom(app, bottom, fits(FULL), buf, &theme).or(place);
    }
    let place = match app.mode() {
        Mode::Help { scroll } => page::draw(app, "help", *scroll, middle, buf, &theme),
        Mode::Details { scroll } => page::draw(app, "details", *scroll, middle, buf, &theme),
        Mode::Export { index } => export::draw(app, *index, middle, buf, &theme),
        Mode::MeshPicker { index } => mesh_picker::draw(app, *index, middle, buf, &theme),
        Mode::MeshForm(form) => mesh_form::draw(form, middle, buf, &theme),
        Mode::Open(picker) => open::draw(picker, middle, buf, &theme),
        Mode::Settings { index } => settings::draw(app, *index, middle, buf, &theme),
        _ => {
            let behind = if app.empty() {
                empty::draw(app, middle, buf, &theme)
            } else if fits(LARGE) {
                large(app, middle, buf, &theme)
            } else if fits(FULL) {
                full(app, middle, buf, &theme)
            } else {
                compact::draw(app, middle, buf, &theme)
            };
            let asked = confirm::draw(app, middle, buf, &theme);
            let told = match app.mode() {
                Mode::Tour { stop } => tour::draw(*stop, middle, buf, &theme),
                _ => None,
            };
            told.or(asked).or(behind)
        }
    };
    hint::bottom(app, bottom, fits(FULL), buf, &theme).or(place)
}

/// Rows of an area, one below the other, each as high as asked for; the last takes the rest.
fn stack<const N: usize>(area: Rect, heights: [u16; N]) -> [Rect; N] {
    let mut rest = area;
    heights.map(|height| {
        let part = Rect { height: height.min(rest.height), ..rest };
        rest = below(rest, height);
        part
    })
}

/// The screen from 80x24.
fn full(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let left = Rect { width: 27, ..area };
    let right = Rect { x: area.x + 28, width: area.width - 28, ..area };
    let list = left.height - 16;
    let [layouts, inputs, ratios] = stack(left, [list, 11, 5]);
    layouts::draw(app, layouts, buf, theme);
    let place = inputs::draw(app, inputs, buf, theme);
    ratios::draw(app, ratios, buf, theme);

    let [curve, lower] = stack(right, [right.height - 8, 8]);
    heading(buf, curve, &chart::caption(app), "", theme);
    chart::draw(app, below(curve, 1), buf, theme);
    let plan = 20;
    let answer = Rect { width: lower.width - plan - 1, ..lower };
    answer::draw(app, answer, buf, theme);
    plan::draw(app, Rect { x: answer.right() + 1, width: plan, ..lower }, buf, theme);
    place
}

/// The screen from 110x34.
fn large(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let left = Rect { width: 42, ..area };
    let right = Rect { x: area.x + 43, width: area.width - 43, ..area };
    let list = left.height - 11 - 11;
    let [layouts, inputs, ratios] = stack(left, [list, 11, 11]);
    layouts::draw(app, layouts, buf, theme);
    let place = inputs::draw(app, inputs, buf, theme);
    ratios::draw(app, ratios, buf, theme);

    let [curve, middle, bottom] = stack(right, [right.height - 18, 10, 8]);
    heading(buf, curve, &chart::caption(app), "", theme);
    chart::draw(app, below(curve, 1), buf, theme);
    let plan = 25;
    let answer = Rect { width: middle.width - plan - 1, ..middle };
    answer::draw(app, answer, buf, theme);
    plan::draw(app, Rect { x: answer.right() + 1, width: plan, ..middle }, buf, theme);
    let table = Rect { width: warnings::TABLE.min(bottom.width), ..bottom };
    warnings::curve_table(app, table, buf, theme);
    let x = table.right() + 1;
    let notes = Rect { x, width: bottom.right().saturating_sub(x), ..bottom };
    warnings::draw(app, notes, buf, theme);
    place
}
