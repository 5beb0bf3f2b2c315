//! The axes of a chart: what is where, ticks and names with units.

use super::drawing::{Anchor, Drawing, Frame, Stroke};
use crate::axis::Axis;
use crate::curve::Point;
use crate::units::Units;

/// Size of the numbers at the axes.
const TICK_TEXT: f64 = 13.0;

/// A plane with axes: deflection to the right, force up.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ChartPlane {
    /// Where the plot stands in the picture.
    pub(crate) frame: Frame,
    x: Axis,
    y: Axis,
    unit: Units,
}

impl ChartPlane {
    /// A plane that holds a deflection (m) and a force (N).
    pub(crate) fn holding(frame: Frame, deflection: f64, force: f64, unit: Units) -> ChartPlane {
        ChartPlane {
            frame,
            x: Axis::holding(deflection * unit.per_metre() * 1.02, 10),
            y: Axis::holding(unit.force(force) * 1.02, 8),
            unit,
        }
    }

    /// Deflection at the right edge, m.
    pub(crate) fn last_deflection(&self) -> f64 {
        self.x.end() / self.unit.per_metre()
    }

    /// Force at the upper edge, N.
    pub(crate) fn largest_force(&self) -> f64 {
        self.unit.newtons(self.y.end())
    }

    /// Where a point is in the picture.
    pub(crate) fn at(&self, point: Point) -> (f64, f64) {
        let f = &self.frame;
        let x = point.deflection / self.last_deflection();
        let y = point.force / self.largest_force();
        (f.left + x * (f.right - f.left), f.bottom - y * (f.bottom - f.top))
    }

    /// Whether a point is in the plot.
    pub(crate) fn holds(&self, point: Point) -> bool {
        self.frame.holds(self.at(point))
    }

    /// Draws grid, axes, ticks and names.
    pub(crate) fn draw(&self, drawing: &mut Drawing) {
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
        let name = format!("deflection \u{3b4} ({})", self.unit.symbol());
        drawing.text((middle, f.bottom + 42.0), Anchor::Middle, 14.0, &name);
        let middle = (f.top + f.bottom) / 2.0;
        drawing.upright(
            (f.left - 48.0, middle),
            14.0,
            &format!("force F ({})", self.unit.force_symbol()),
        );
    }
}
