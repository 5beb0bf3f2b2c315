//! The cell from above: anchor plates and punch to scale, and the direction of the net.

use super::contours;
use super::text::{self, below, heading, put};
use super::theme::Theme;
use crate::app::App;
use crate::app::look::Glyphs;
use crate::layout::{Blocks, Layout};
use crate::show::grid::{DotGrid, DotPen, Pattern};
use crate::show::picture::{Ink, Picture};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::f64::consts::TAU;

/// Draws the plan with its heading. x runs to the right, y up the slope.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let layout = app.layout().layout;
    let along = layout.turned(["cell, twists || y", "cell, twists || x"])[0];
    heading(buf, area, along, "", theme);
    let room = below(area, 1);
    if room.height < 3 || room.width < 10 {
        return;
    }
    // A character is about twice as high as wide.
    let rows = room.height.min((room.width - 5) / 2);
    let plan = Rect { x: room.x + 1, y: room.y, width: rows * 2, height: rows };
    let mut grid = DotGrid::new(usize::from(plan.width), usize::from(plan.height), theme.glyphs);
    let view = View::new(&layout, &grid);
    contours::draw(app, view.reach, &mut grid);
    punch(&layout, &view, &mut grid);
    plates(&layout, &view, &mut grid);
    let mut picture = Picture::new(usize::from(plan.width), usize::from(plan.height));
    grid.put(&mut picture, 0, 0);
    text::draw(&picture, plan, buf, theme);
    if let Some(shown) = app.shown_check() {
        // Where the first wire of each run broke; the middle of the bond in the flat net.
        for broken in &shown.result.breaks {
            let (x, y) = view.dot(broken.place[0], broken.place[1]);
            let (w, h) = grid.dots();
            let column = (x / f64::from(w) * f64::from(plan.width)) as u16;
            let row = (y / f64::from(h) * f64::from(plan.height)) as u16;
            let style = if shown.stale() { theme.text } else { theme.caution };
            put(buf, plan, row.min(plan.height - 1), column.min(plan.width - 1), "x", style);
        }
    }
    let side =
        Rect { x: plan.right() + 1, width: room.right().saturating_sub(plan.right() + 1), ..room };
    let (up, right) = match theme.glyphs {
        Glyphs::Ascii => ("^", "+->x"),
        _ => ("↑", "└─→x"),
    };
    let bottom = rows.saturating_sub(1);
    put(buf, side, bottom, 0, right, theme.heading);
    put(buf, side, bottom.saturating_sub(1), 0, up, theme.heading);
    put(buf, side, bottom.saturating_sub(2), 0, "y", theme.heading);
}

/// How much more than the cell is shown where the other blocks stand otherwise than this one.
const AROUND: f64 = 1.6;

/// Whether blocks face each other: then where they stand is what the plan is looked at for.
fn facing(layout: &Layout) -> bool {
    layout.facing() && layout.folded() != (0.0, 0.0)
}

/// World to dots: the whole cell with its plates, and what is around it where blocks face each other.
struct View {
    reach: f64,
    width: f64,
    height: f64,
}

impl View {
    fn new(layout: &Layout, grid: &DotGrid) -> View {
        let (w, h) = grid.dots();
        let [x, y] = layout.sides();
        let around = if facing(layout) { AROUND } else { 1.0 };
        let reach = around * x.max(y) + layout.plate;
        View { reach, width: f64::from(w), height: f64::from(h) }
    }

    fn dot(&self, x: f64, y: f64) -> (f64, f64) {
        let half = self.reach / 2.0;
        ((x + half) / self.reach * self.width, (half - y) / self.reach * self.height)
    }
}

/// The plates fill the view's corners: it reaches from the outer edge of one to that of the next.
fn plates(layout: &Layout, view: &View, grid: &mut DotGrid) {
    let pen = DotPen { ink: Ink::Title, pattern: Pattern::Solid, ascii: Some('#') };
    if !layout.is_square() || facing(layout) {
        return plates_of_rows(layout, view, grid, pen);
    }
    let part = layout.plate / view.reach;
    let (width, height) = grid.dots();
    // A plate smaller than a dot is still one dot; in ASCII a sign is three dots high.
    let size = |dots: i32| (part * f64::from(dots)).round().max(1.0) as i32;
    let (w, h) = (size(width), size(height));
    for x0 in [0, width - w] {
        for y0 in [0, height - h] {
            for y in y0..y0 + h {
                for x in x0..x0 + w {
                    grid.dot(x, y, pen);
                }
            }
        }
    }
}

/// The plates of a grid that does not fill the view's corners.
fn plates_of_rows(layout: &Layout, view: &View, grid: &mut DotGrid, pen: DotPen) {
    let (width, height) = grid.dots();
    let dots =
        |metres: f64, of: i32| ((metres / view.reach * f64::from(of)).round().max(1.0) as i32, of);
    let ((w, _), (h, _)) = (dots(layout.plate, width), dots(layout.plate, height));
    for above in -1..=2 {
        for right in -2..=2 {
            let (x, y) = layout.anchor_in(right, above);
            let (x, y) = view.dot(x, y);
            let (x0, y0) = (x.round() as i32 - w / 2, y.round() as i32 - h / 2);
            for y in y0.max(0)..(y0 + h).min(height) {
                for x in x0.max(0)..(x0 + w).min(width) {
                    grid.dot(x, y, pen);
                }
            }
        }
    }
}

/// The outline of the punch and of its images in the neighbouring cells, and its centre.
fn punch(layout: &Layout, view: &View, grid: &mut DotGrid) {
    let outline = DotPen { ink: Ink::Forecast, pattern: Pattern::Solid, ascii: Some('o') };
    let radius = layout.punch / 2.0;
    let reach = view.reach / 2.0;
    for ix in -1..=1 {
        for iy in -1..=1 {
            let (cx, cy) = layout.block_in(ix, iy);
            if cx.abs() - radius > reach || cy.abs() - radius > reach {
                continue;
            }
            let circle = (0..=64).map(|i| {
                let angle = TAU * f64::from(i) / 64.0;
                view.dot(cx + radius * angle.cos(), cy + radius * angle.sin())
            });
            let own = (ix, iy) == (0, 0);
            let faint = DotPen { ink: Ink::Overlay, ascii: Some('.'), ..outline };
            if !own && layout.blocks == Blocks::Single {
                continue;
            }
            grid.line(circle, if own || layout.blocks == Blocks::Paper { outline } else { faint });
            let (x, y) = view.dot(cx, cy);
            grid.dot(x.floor() as i32, y.floor() as i32, DotPen { ascii: Some('+'), ..outline });
        }
    }
}
