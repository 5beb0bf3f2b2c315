//! A chart with axes between round ends, for curves and points.

use super::super::canvas::{Canvas, DotPen};
use super::super::text::{put, put_right, width};
use super::super::theme::Theme;
use crate::axis::Range;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Smallest area in which something can be seen.
pub(crate) const SMALLEST: (u16, u16) = (20, 5);

/// Where values stand on the screen. Both axes are in the units shown.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plot {
    /// Cells of the plot itself.
    pub(crate) area: Rect,
    x: Range,
    y: Range,
}

impl Plot {
    /// Draws the axes into an area and gives the plot between them; nothing where there is no room.
    pub(crate) fn new(
        area: Rect,
        x: (f64, f64),
        y: (f64, f64),
        buf: &mut Buffer,
        theme: &Theme,
    ) -> Option<Plot> {
        if area.width < SMALLEST.0 || area.height < SMALLEST.1 {
            return None;
        }
        let y = Range::holding(y.0, y.1, u32::from(area.height / 2).clamp(2, 8));
        let marks = y.ticks();
        let label = marks.iter().map(|t| width(&t.1)).max().unwrap_or(0) + 1;
        let plot = Rect {
            x: area.x + label + 1,
            y: area.y,
            width: area.width.saturating_sub(label + 1),
            height: area.height - 2,
        };
        let x = Range::holding(x.0, x.1, u32::from(plot.width / 8).clamp(2, 10));
        let plot = Plot { area: plot, x, y };
        plot.axes(area, label, buf, theme);
        Some(plot)
    }

    fn axes(&self, area: Rect, label: u16, buf: &mut Buffer, theme: &Theme) {
        let plot = self.area;
        for row in 0..plot.height {
            put(buf, area, row, label, theme.upright(), theme.heading);
        }
        let rule = theme.rule().repeat(usize::from(plot.width));
        put(buf, area, plot.height, label, &format!("{}{rule}", theme.corner()), theme.heading);
        for (value, text) in self.y.ticks() {
            // The first stands at the corner, below the last row of the plot.
            let row = match self.y.part(value) {
                part if part <= 0.0 => plot.height,
                part => ((1.0 - part) * f64::from(plot.height - 1)).round() as u16,
            };
            put_right(buf, Rect { width: label.saturating_sub(1), ..area }, row, &text, theme.text);
        }
        for (value, text) in self.x.ticks() {
            let column = (self.x.part(value) * f64::from(plot.width - 1)).round() as u16;
            let start = column.saturating_sub(width(&text) / 2);
            let start = start.min(plot.width.saturating_sub(width(&text)));
            put(buf, area, plot.height + 1, label + 1 + start, &text, theme.text);
        }
    }

    /// A value in dots of a canvas over the plot.
    pub(crate) fn dot(&self, x: f64, y: f64, canvas: &Canvas) -> (f64, f64) {
        let (w, h) = canvas.dots();
        (self.x.part(x) * f64::from(w - 1) + 0.5, (1.0 - self.y.part(y)) * f64::from(h - 1) + 0.5)
    }

    /// Draws a curve; what is no number breaks it.
    pub(crate) fn curve(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        pen: DotPen,
        canvas: &mut Canvas,
    ) {
        let dots: Vec<(f64, f64)> =
            points.into_iter().map(|(x, y)| self.dot(x, y, canvas)).collect();
        canvas.line(dots, pen);
    }

    /// Column and row of a value, if it is inside.
    pub(crate) fn cell(&self, x: f64, y: f64) -> Option<(u16, u16)> {
        let (x, y) = (self.x.part(x), self.y.part(y));
        let inside = |v: f64| (-1e-9..=1.0 + 1e-9).contains(&v);
        if !inside(x) || !inside(y) {
            return None;
        }
        let column = (x * f64::from(self.area.width - 1)).round() as u16;
        let row = ((1.0 - y) * f64::from(self.area.height - 1)).round() as u16;
        Some((column, row))
    }
}
