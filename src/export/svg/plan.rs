//! The cell from above: anchor plates and punch to scale, the direction of the net.

use super::drawing::{Anchor, Drawing, Frame, Stroke, TEXT, text_width};
use crate::export::ExportedLayout;
use crate::layout::{Blocks, Layout};
use crate::units::{Units, length_entry};
use crate::words::Choice;
use std::f64::consts::TAU;

/// Width of a plan, in units of the picture.
const WIDTH: f64 = 440.0;
/// The window through which the net is seen.
const WINDOW: Frame = Frame { left: 24.0, top: 44.0, right: 344.0, bottom: 364.0 };

/// Draws the plan of a layout's cell. x runs to the right, y up the slope. What lies beyond the cell are the
/// blocks and anchors of its neighbours. Lengths are written in `unit`.
pub fn plan(case: &ExportedLayout, unit: Units) -> String {
    let layout = &case.forecast().layout;
    let title = format!("{}: the cell from above", case.entry.name);
    let mut drawing = Drawing::new(WIDTH);
    let view = View::new(layout);
    let [half_x, half_y] = layout.sides().map(|side| side / 2.0);

    let corners = [
        (-half_x, -half_y),
        (half_x, -half_y),
        (half_x, half_y),
        (-half_x, half_y),
        (-half_x, -half_y),
    ];
    let cell = Stroke { colour: "#555", width: 1.0, dashes: "6 4" };
    drawing.line(&corners.map(|p| view.at(p)), cell);
    punches(layout, &view, &mut drawing);
    plates(layout, &view, &mut drawing);
    drawing.rectangle(WINDOW, "none", Stroke::solid("#000", 1.0));
    directions(layout, &mut drawing);
    let spacing = format!("{} = {}", layout.words()[0], length(layout.spacing, unit));
    dimension(layout, &view, &spacing, &mut drawing);

    drawing.bold((24.0, 26.0), Anchor::Start, TEXT, "plan of the cell, to scale");
    let up = layout.grid.up.map_or(String::new(), |up| format!(", Ly = {}", length(up, unit)));
    let spacing = spacing + &up + if layout.grid.stagger { ", staggered" } else { "" };
    let grid = (!layout.is_square() || !up.is_empty()).then(|| format!("grid: {spacing}"));
    let others = match layout.blocks {
        Blocks::Paper | Blocks::Repeated => None,
        Blocks::Single => Some("no blocks in other cells: single".to_string()),
        Blocks::Mirrored | Blocks::Worst => {
            Some(format!("blocks of other cells (dashed): {}", layout.blocks.word()))
        }
    };
    let lines = [
        format!("plates (filled): d = {}", length(layout.plate, unit)),
        format!("block (circle): D = {}", length(layout.punch, unit)),
        format!("offset: ex = {}, ey = {}", length(layout.ex, unit), length(layout.ey, unit)),
    ];
    let lines: Vec<String> = grid.into_iter().chain(lines).chain(others).collect();
    let mut y = 422.0;
    for line in &lines {
        drawing.text((24.0, y), Anchor::Start, 13.0, line);
        y += 19.0;
    }
    drawing.finish(y + 2.0, &title, &format!("{spacing}, {}", lines.join(", ")))
}

fn length(metres: f64, unit: Units) -> String {
    format!("{} {}", length_entry(metres, unit), unit.symbol())
}

/// From the cell, in metres around its middle, to the picture.
struct View {
    scale: f64,
}

impl View {
    /// The cell with its plates, and a little of what lies beyond; more where the blocks of the neighbours
    /// stand in a way of their own.
    fn new(layout: &Layout) -> View {
        let [x, y] = layout.sides();
        let side = x.max(y);
        let alike = matches!(layout.blocks, Blocks::Paper | Blocks::Repeated) && layout.is_square();
        let beyond = if alike { 0.06 } else { 0.8 };
        let reach = side + layout.plate + beyond * side;
        View { scale: (WINDOW.right - WINDOW.left) / reach }
    }

    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (
            (WINDOW.left + WINDOW.right) / 2.0 + x * self.scale,
            (WINDOW.top + WINDOW.bottom) / 2.0 - y * self.scale,
        )
    }
}

/// The anchors' plates, those of the cell's corners and those around it that are in the window.
fn plates(layout: &Layout, view: &View, drawing: &mut Drawing) {
    let r = layout.plate / 2.0;
    for above in -1..=2 {
        for right in -2..=2 {
            let (x, y) = layout.anchor_in(right, above);
            let plate = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)];
            let plate = plate.map(|p| view.at(p));
            let inside = |(x, y): &(f64, f64)| {
                (WINDOW.left..=WINDOW.right).contains(x) && (WINDOW.top..=WINDOW.bottom).contains(y)
            };
            if plate.iter().all(inside) {
                drawing.area(&plate, "#444", Stroke::solid("#000", 1.0));
            }
        }
    }
}

/// The punch, its images in the neighbouring cells, and the way from the cell's middle to it.
fn punches(layout: &Layout, view: &View, drawing: &mut Drawing) {
    let (offset, block) = (layout.folded(), layout.block_in(0, 0));
    let radius = layout.punch / 2.0;
    for ix in -1..=1 {
        for iy in -1..=1 {
            let (cx, cy) = layout.block_in(ix, iy);
            let round: Vec<(f64, f64)> = (0..=96)
                .map(|i| {
                    let angle = TAU * f64::from(i) / 96.0;
                    view.at((cx + radius * libm::cos(angle), cy + radius * libm::sin(angle)))
                })
                .collect();
            let own = (ix, iy) == (0, 0);
            if !own && layout.blocks == Blocks::Single {
                continue;
            }
            let stroke = if own {
                Stroke::solid("#8a2b00", 2.2)
            } else {
                Stroke { colour: "#8a2b00", width: 1.2, dashes: "3 3" }
            };
            for piece in WINDOW.pieces(&round) {
                drawing.line(&piece, stroke);
            }
        }
    }
    let from = (block.0 - offset.0, block.1 - offset.1);
    let (middle, centre) = (view.at(from), view.at(block));
    if offset != (0.0, 0.0) {
        drawing.line(&[middle, centre], Stroke { colour: "#000", width: 1.0, dashes: "2 3" });
        drawing.circle(middle, 2.5, "#fff", Stroke::solid("#000", 1.0));
    }
    let (x, y) = centre;
    let pen = Stroke::solid("#8a2b00", 1.6);
    for ends in [[(x - 6.0, y), (x + 6.0, y)], [(x, y - 6.0), (x, y + 6.0)]] {
        for piece in WINDOW.pieces(&ends) {
            drawing.line(&piece, pen);
        }
    }
}

/// The spacing below the window, from anchor to anchor.
fn dimension(layout: &Layout, view: &View, text: &str, drawing: &mut Drawing) {
    let y = WINDOW.bottom + 22.0;
    let half = layout.spacing / 2.0;
    let (left, right) = (view.at((-half, 0.0)).0, view.at((half, 0.0)).0);
    let pen = Stroke::solid("#000", 1.0);
    for x in [left, right] {
        drawing.line(&[(x, WINDOW.bottom + 4.0), (x, y + 5.0)], pen);
    }
    arrow(drawing, (left, y), (right, y));
    arrow(drawing, (right, y), (left, y));
    let (middle, wide) = ((left + right) / 2.0, text_width(text, 13.0) + 8.0);
    let behind = Frame {
        left: middle - wide / 2.0,
        top: y - 9.0,
        right: middle + wide / 2.0,
        bottom: y + 9.0,
    };
    drawing.rectangle(behind, "#fff", Stroke::solid("#fff", 0.0));
    drawing.text(((left + right) / 2.0, y + 5.0), Anchor::Middle, 13.0, text);
}

/// Axes beside the window and how the net hangs.
fn directions(layout: &Layout, drawing: &mut Drawing) {
    let (x, y) = (WINDOW.right + 30.0, WINDOW.bottom - 40.0);
    arrow(drawing, (x, y), (x, y - 60.0));
    arrow(drawing, (x, y), (x + 46.0, y));
    drawing.text((x, y - 66.0), Anchor::Middle, 13.0, "y");
    drawing.text((x + 52.0, y + 4.0), Anchor::Start, 13.0, "x");
    // Twists: short double strokes along them.
    let pen = Stroke::solid("#000", 1.4);
    let (left, top) = (x, WINDOW.top + 40.0);
    for (column, from) in [(0.0, 0.0), (16.0, 20.0), (32.0, 0.0)] {
        for shift in [-1.6, 1.6] {
            let at = x + column + shift;
            for row in [0.0, 40.0] {
                let ends = [from + row, from + row + 18.0].map(|along| {
                    // Across there is less room.
                    let along = layout.turned([along, 0.7 * along])[0];
                    let [x, y] = layout.turned([at - left, along]);
                    (x + left, y + top)
                });
                drawing.line(&ends, pen);
            }
        }
    }
    let along = layout.turned(["along y", "along x"])[0];
    for (line, word) in ["twists of", "the net:", along].iter().enumerate() {
        let y = top + 108.0 + 16.0 * line as f64;
        drawing.text((WINDOW.right + 14.0, y), Anchor::Start, 13.0, word);
    }
}

/// A line with a head at its end.
fn arrow(drawing: &mut Drawing, from: (f64, f64), to: (f64, f64)) {
    let pen = Stroke::solid("#000", 1.2);
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = (dx * dx + dy * dy).sqrt().max(1e-9);
    let (ux, uy) = (dx / length, dy / length);
    drawing.line(&[from, to], pen);
    let back = (to.0 - 8.0 * ux, to.1 - 8.0 * uy);
    let head = [to, (back.0 - 3.0 * uy, back.1 + 3.0 * ux), (back.0 + 3.0 * uy, back.1 - 3.0 * ux)];
    drawing.area(&head, "#000", Stroke::solid("#000", 0.0));
}
