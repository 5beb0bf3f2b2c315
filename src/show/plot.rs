//! Axes, and curves and points between them.

use super::glyphs::Glyphs;
use super::grid::{DotGrid, DotPen};
use super::picture::{Ink, Picture};
use crate::axis::{Axis, Range};

/// An axis of a plot, in the unit shown.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlotAxis {
    /// Where it begins and ends.
    pub(crate) ends: (f64, f64),
    /// Values that have a label, with it.
    pub(crate) ticks: Vec<(f64, String)>,
}

impl From<Axis> for PlotAxis {
    fn from(axis: Axis) -> PlotAxis {
        PlotAxis { ends: (0.0, axis.end()), ticks: axis.ticks() }
    }
}

impl From<Range> for PlotAxis {
    fn from(range: Range) -> PlotAxis {
        PlotAxis { ends: range.ends(), ticks: range.ticks() }
    }
}

impl PlotAxis {
    /// Where a value is: 0 at the axis's start, 1 at its end.
    pub(crate) fn part(&self, value: f64) -> f64 {
        let (first, last) = self.ends;
        (value - first) / (last - first)
    }

    fn widest_label(&self) -> usize {
        self.ticks.iter().map(|tick| tick.1.chars().count()).max().unwrap_or(0)
    }
}

/// A plot with its axes: values upwards at the left, across below it.
#[derive(Debug, Clone)]
pub(crate) struct Plot {
    /// What is drawn so far.
    pub(crate) picture: Picture,
    /// The axis across.
    pub(crate) x: PlotAxis,
    /// The axis upwards.
    pub(crate) y: PlotAxis,
    /// Characters between the axes, across and down.
    size: (usize, usize),
    /// Column of the first of them.
    left: usize,
    glyphs: Glyphs,
}

/// Smallest size in which something can be seen.
pub(crate) const SMALLEST: (usize, usize) = (20, 5);
/// Rows of the axis across with its labels.
const FOOT: usize = 2;

impl Plot {
    /// A plot of a size with its labels, `margin` columns of which are for those at the left; nothing
    /// where there is no room.
    pub(crate) fn new(
        (width, height): (usize, usize),
        margin: usize,
        x: PlotAxis,
        y: PlotAxis,
        glyphs: Glyphs,
    ) -> Option<Plot> {
        if width < margin + 2 || height <= FOOT {
            return None;
        }
        let size = (width - margin - 1, height - FOOT);
        let picture = Picture::new(width, height);
        let mut plot = Plot { picture, x, y, size, left: margin + 1, glyphs };
        plot.axes();
        Some(plot)
    }

    /// A plot that holds values between round ends.
    pub(crate) fn holding(
        (width, height): (usize, usize),
        x: (f64, f64),
        y: (f64, f64),
        glyphs: Glyphs,
    ) -> Option<Plot> {
        if width < SMALLEST.0 || height < SMALLEST.1 {
            return None;
        }
        let most = |room: usize, largest: usize| room.clamp(2, largest) as u32;
        let y = PlotAxis::from(Range::holding(y.0, y.1, most(height / 2, 8)));
        let margin = y.widest_label() + 1;
        let across = width.saturating_sub(margin + 1);
        let x = PlotAxis::from(Range::holding(x.0, x.1, most(across / 8, 10)));
        Plot::new((width, height), margin, x, y, glyphs)
    }

    fn axes(&mut self) {
        let ((width, height), margin) = (self.size, self.left - 1);
        for row in 0..height {
            self.picture.put(row, margin, self.glyphs.upright(), Ink::Heading);
        }
        let rule = format!("{}{}", self.glyphs.corner(), self.glyphs.rule().repeat(width));
        self.picture.put(height, margin, &rule, Ink::Heading);
        for (value, label) in &self.y.ticks {
            // The first stands at the corner, below the last row of the plot.
            let row = match self.y.part(*value) {
                part if part <= 0.0 => height,
                part => ((1.0 - part) * (height - 1) as f64).round() as usize,
            };
            self.picture.put_right(row, margin.saturating_sub(1), label, Ink::Text);
        }
        for (value, label) in &self.x.ticks {
            let column = (self.x.part(*value) * (width - 1) as f64).round() as usize;
            let long = label.chars().count();
            let start = column.saturating_sub(long / 2).min(width.saturating_sub(long));
            self.picture.put(height + 1, self.left + start, label, Ink::Text);
        }
    }

    /// An empty grid of dots over the plot.
    pub(crate) fn grid(&self) -> DotGrid {
        DotGrid::new(self.size.0, self.size.1, self.glyphs)
    }

    /// An empty grid over the plot in which each character is one dot.
    pub(crate) fn letters(&self) -> DotGrid {
        DotGrid::letters(self.size.0, self.size.1)
    }

    /// Draws a curve into such a grid. What is no number breaks it; a point above the plot ends it.
    pub(crate) fn curve(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        pen: DotPen,
        grid: &mut DotGrid,
    ) {
        let dots = points.into_iter().map(|(x, y)| self.dot(x, y, grid));
        let dots: Vec<(f64, f64)> = dots.take_while(|dot| dot.1.is_nan() || dot.1 > -1.0).collect();
        grid.line(dots, pen);
    }

    /// A value in dots of a grid over the plot.
    pub(crate) fn dot(&self, x: f64, y: f64, grid: &DotGrid) -> (f64, f64) {
        let (w, h) = grid.dots();
        (self.x.part(x) * f64::from(w - 1) + 0.5, (1.0 - self.y.part(y)) * f64::from(h - 1) + 0.5)
    }

    /// Puts what was drawn into a grid into the picture.
    pub(crate) fn put(&mut self, grid: &DotGrid) {
        grid.put(&mut self.picture, 0, self.left);
    }

    /// Puts a sign at a value; whether the plot holds it.
    pub(crate) fn mark(&mut self, x: f64, y: f64, sign: char, ink: Ink) -> bool {
        let cell = self.cell(x, y);
        if let Some((row, column)) = cell {
            self.picture.set(row, self.left + column, sign, ink);
        }
        cell.is_some()
    }

    /// Puts a sign on the axis across, below a value.
    pub(crate) fn mark_axis(&mut self, x: f64, sign: char, ink: Ink) {
        if let Some((row, column)) = self.cell(x, self.y.ends.0) {
            self.picture.set(row + 1, self.left + column, sign, ink);
        }
    }

    /// Puts a text between the axes.
    pub(crate) fn text(&mut self, row: usize, column: usize, text: &str, ink: Ink) {
        self.picture.put(row, self.left + column, text, ink);
    }

    /// Characters between the axes, across and down.
    pub(crate) fn size(&self) -> (usize, usize) {
        self.size
    }

    /// Row and column of the character nearest to a value, if it is between the axes.
    fn cell(&self, x: f64, y: f64) -> Option<(usize, usize)> {
        let place = |part: f64, count: usize| {
            let place = (part * (count - 1) as f64).round();
            (0.0..count as f64).contains(&place).then_some(place as usize)
        };
        let column = place(self.x.part(x), self.size.0)?;
        Some((place(1.0 - self.y.part(y), self.size.1)?, column))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::show::grid::Pattern;

    #[test]
    fn a_line_goes_from_corner_to_corner_with_round_ticks_below_it() {
        let pen = DotPen { ink: Ink::Forecast, pattern: Pattern::Solid, ascii: Some('*') };
        let mut plot = Plot::holding((24, 7), (0.0, 2.0), (0.0, 1.0), Glyphs::Ascii).unwrap();
        let mut letters = plot.letters();
        plot.curve([(0.0, 0.0), (2.0, 1.0)], pen, &mut letters);
        plot.put(&letters);
        assert!(plot.mark(2.0, 1.0, 'X', Ink::Check) && !plot.mark(2.0, 1.2, '?', Ink::Check));
        plot.mark_axis(0.0, '^', Ink::Title);
        let lines = plot.picture.lines();
        assert_eq!(lines[0], "1.0 |                **X");
        assert_eq!(lines[4], "    |***");
        assert_eq!(lines[5], "0.0 ^^------------------".replacen('^', "+", 1));
        assert_eq!(lines[6], "     0        1        2");
    }
}
