//! Lines over two axes, with points that have a name: pictures that are no chart of a layout.

use super::drawing::{Anchor, Drawing, Frame, Stroke, TEXT};
use super::frame::Plane;
use super::labels::Labels;
use super::legend::{self, LegendEntry};
use super::marks::{self, Mark};
use crate::axis::Axis;

/// Width of the picture and height of the plot.
const SIZE: (f64, f64) = (700.0, 300.0);
/// Left and right edge of the plot.
const EDGES: (f64, f64) = (76.0, SIZE.0 - 24.0);
/// How many ticks at most, across and up.
const TICKS: [u32; 2] = [8, 6];

/// Values along both axes.
pub(crate) type Points = Vec<(f64, f64)>;

/// A line, and what it is.
#[derive(Debug, Clone)]
pub(crate) struct PlotLine {
    pub(crate) points: Points,
    /// Of no width where there are only signs.
    pub(crate) stroke: Stroke,
    /// The sign at each of its points, or at its end alone.
    pub(crate) mark: Option<(Mark, Signs)>,
    /// What lies around it, a closed line.
    pub(crate) band: Points,
    /// What it is, for the legend.
    pub(crate) words: String,
    /// A word beside its end.
    pub(crate) tag: String,
}

/// Where a line has signs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Signs {
    All,
    End,
}

/// A picture.
#[derive(Debug, Clone)]
pub(crate) struct Plot {
    pub(crate) title: String,
    /// What the axes are, with their units.
    pub(crate) axes: [&'static str; 2],
    pub(crate) lines: Vec<PlotLine>,
}

impl Plot {
    /// The picture as SVG.
    pub(crate) fn svg(&self) -> String {
        let (width, height) = SIZE;
        let mut drawing = Drawing::new(width);
        let mut top = 24.0;
        for line in legend::wrapped(&self.title, width - 24.0) {
            drawing.bold((12.0, top), Anchor::Start, TEXT + 1.0, &line);
            top += 20.0;
        }
        let frame = Frame { left: EDGES.0, top, right: EDGES.1, bottom: top + height };
        let plane = self.plane(frame);
        plane.draw(&mut drawing, self.axes);
        let labels = &mut Labels::new(frame);
        let place = |points: &Points| -> Points { points.iter().map(|p| plane.at(*p)).collect() };
        for line in self.lines.iter().filter(|line| !line.band.is_empty()) {
            drawing.area(&place(&line.band), marks::FILL, marks::BAND);
        }
        for line in &self.lines {
            draw(&mut drawing, labels, line, &place(&line.points));
        }
        for line in self.lines.iter().filter(|line| !line.tag.is_empty()) {
            if let Some(end) = line.points.last() {
                labels.beside(&mut drawing, plane.at(*end), &line.tag);
            }
        }
        let entries: Vec<LegendEntry> = self.lines.iter().map(entry).collect();
        let below = legend::draw(&mut drawing, &entries, EDGES.0, EDGES.1, frame.bottom + 54.0);
        let said: Vec<&str> = self.lines.iter().map(|line| line.words.as_str()).collect();
        drawing.finish(below + 12.0, &self.title, &said.join(". "))
    }

    /// Axes that hold all lines.
    fn plane(&self, frame: Frame) -> Plane {
        let all = || self.lines.iter().flat_map(|line| line.points.iter().chain(&line.band));
        let most = |of: fn(&(f64, f64)) -> f64| all().map(of).fold(0.0, f64::max);
        Plane {
            frame,
            x: Axis::holding(most(|p| p.0), TICKS[0]),
            y: Axis::holding(most(|p| p.1), TICKS[1]),
        }
    }
}

fn draw(drawing: &mut Drawing, labels: &mut Labels, line: &PlotLine, places: &Points) {
    if line.stroke.width > 0.0 {
        drawing.line(places, line.stroke);
        labels.avoid(places);
    }
    let Some((mark, signs)) = line.mark else { return };
    let from = if signs == Signs::End { places.len().saturating_sub(1) } else { 0 };
    for place in &places[from..] {
        mark.draw(drawing, *place, 8.0, line.stroke);
        labels.avoid_point(*place, 6.0);
    }
}

fn entry(line: &PlotLine) -> LegendEntry {
    LegendEntry {
        line: Some(line.stroke),
        mark: line.mark.map(|(mark, _)| mark),
        band: !line.band.is_empty(),
        tag: String::new(),
        words: line.words.clone(),
    }
}
