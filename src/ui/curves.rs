//! The plot of the chart: force over deflection in the units shown.

use crate::curve::{Curve, Point};
use crate::show::grid::{DotGrid, DotPen};
use crate::show::picture::Ink;
use crate::show::plot::Plot;
use crate::units::Units;

/// A plot that takes points in newtons and metres.
pub(super) struct CurvePlot {
    /// The plot, in the units shown.
    pub(super) plot: Plot,
    /// Those units.
    pub(super) units: Units,
}

impl CurvePlot {
    fn shown(&self, point: Point) -> (f64, f64) {
        (point.deflection * self.units.per_metre(), self.units.force(point.force))
    }

    /// Draws a curve; it ends where it leaves the chart at the top.
    pub(super) fn curve(&self, curve: &Curve, pen: DotPen, grid: &mut DotGrid) {
        self.line(curve.points(), pen, grid);
    }

    /// Draws a line through points.
    pub(super) fn line(
        &self,
        points: impl IntoIterator<Item = Point>,
        pen: DotPen,
        grid: &mut DotGrid,
    ) {
        self.plot.curve(points.into_iter().map(|p| self.shown(p)), pen, grid);
    }

    /// Draws a dot.
    pub(super) fn dot(&self, point: Point, pen: DotPen, grid: &mut DotGrid) {
        let (x, y) = self.shown(point);
        let (x, y) = self.plot.dot(x, y, grid);
        grid.dot(x.floor() as i32, y.floor() as i32, pen);
    }

    /// Puts a sign at a point; whether the chart holds it.
    pub(super) fn mark(&mut self, point: Point, sign: char, ink: Ink) -> bool {
        let (x, y) = self.shown(point);
        self.plot.mark(x, y, sign, ink)
    }

    /// The largest force and deflection of the chart.
    pub(super) fn end(&self) -> Point {
        let force = self.units.newtons(self.plot.y.ends.1);
        Point { deflection: self.plot.x.ends.1 / self.units.per_metre(), force }
    }
}
