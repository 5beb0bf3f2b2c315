//! The axes of a chart: what is where, ticks and names with units.

use super::drawing::{Anchor, Drawing, Frame, Stroke};
use crate::axis::Axis;
use crate::curve::Point;
use crate::units::Units;

/// Size of the numbers at the axes.
const TICK_TEXT: f64 = 13.0;

/// A plane with two axes from 0 on, in the units of their names.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    /// Where the plot stands in the picture.
    pub(crate) frame: Frame,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
}

impl Plane {
    /// Where a point is in the picture.
    pub(crate) fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let f = &self.frame;
        let (x, y) = (x / self.x.end(), y / self.y.end());
        (f.left + x * (f.right - f.left), f.bottom - y * (f.bottom - f.top))
    }

    /// Draws grid, axes, ticks and names.
    pub(crate) fn draw(&self, drawing: &mut Drawing, [across, up]: [&str; 2]) {
        let f = &self.frame;
        let grid = Stroke::solid("#ddd", 1.0);
        for (value, label) in self.x.ticks() {
            let x = f.left + value / self.x.end() * (f.right - f.left);
            drawing.line(&[(x, f.top), (x, f.bottom)], grid);
            drawing.text((x, f.bottom + 19.0), Anchor::Middle, TICK_TEXT, &label);
        }
        for (value, label) in self.y.ticks() {
            let y = f.bottom - value / self.y.end() * (f.bottom - f.top);
            drawing.line(&[(f.left, y), (f.right, y)], grid);
            drawing.text((f.left - 8.0, y + 4.5), Anchor::End, TICK_TEXT, &label);
        }
        drawing.rectangle(*f, "none", Stroke::solid("#000", 1.2));
        let middle = (f.left + f.right) / 2.0;
        drawing.text((middle, f.bottom + 42.0), Anchor::Middle, 14.0, across);
        let middle = (f.top + f.bottom) / 2.0;
        drawing.upright((f.left - 48.0, middle), 14.0, up);
    }
}

/// A plane of a layout's chart: deflection to the right, force up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ChartPlane {
    plane: Plane,
    unit: Units,
}

impl ChartPlane {
    /// A plane that holds a deflection (m) and a force (N).
    pub(crate) fn holding(frame: Frame, deflection: f64, force: f64, unit: Units) -> ChartPlane {
        let x = Axis::holding(deflection * unit.per_metre() * 1.02, 10);
        let y = Axis::holding(unit.force(force) * 1.02, 8);
        ChartPlane { plane: Plane { frame, x, y }, unit }
    }

    /// Deflection at the right edge, m.
    pub(crate) fn last_deflection(&self) -> f64 {
        self.plane.x.end() / self.unit.per_metre()
    }

    /// Force at the upper edge, N.
    pub(crate) fn largest_force(&self) -> f64 {
        self.unit.newtons(self.plane.y.end())
    }

    /// Where a point is in the picture.
    pub(crate) fn at(&self, point: Point) -> (f64, f64) {
        let f = &self.plane.frame;
        let x = point.deflection / self.last_deflection();
        let y = point.force / self.largest_force();
        (f.left + x * (f.right - f.left), f.bottom - y * (f.bottom - f.top))
    }

    /// Whether a point is in the plot.
    pub(crate) fn holds(&self, point: Point) -> bool {
        self.plane.frame.holds(self.at(point))
    }

    /// Draws grid, axes, ticks and names.
    pub(crate) fn draw(&self, drawing: &mut Drawing) {
        let across = format!("deflection \u{3b4} ({})", self.unit.symbol());
        let up = format!("force F ({})", self.unit.force_symbol());
        self.plane.draw(drawing, [&across, &up]);
    }
}
