//! Line styles and signs: told apart without colour, by dashes and by the shape of the sign.

use super::drawing::{Drawing, Stroke};

/// The sign at the end of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    /// An X.
    Cross,
    /// A filled circle.
    Disc,
    /// A circle.
    Ring,
    /// A filled square.
    Block,
    Square,
    Triangle,
    Diamond,
    Plus,
}

/// Line of the forecast of a single layout.
pub(crate) const FORECAST: Stroke = Stroke::solid("#000", 2.4);
/// Lines around the forecast that hold most of the simulated curves.
pub(crate) const ENVELOPE: Stroke = Stroke { colour: "#000", width: 1.0, dashes: "1 4" };
/// Line of the laboratory test.
pub(crate) const LABORATORY: Stroke = Stroke { colour: "#444", width: 2.0, dashes: "0.1 5" };
/// Line of the other branch.
pub(crate) const OTHER: Stroke = Stroke { colour: "#0a5040", width: 1.6, dashes: "9 4" };
/// Line of a check.
pub(crate) const CHECK: Stroke = Stroke { colour: "#00479a", width: 2.0, dashes: "14 4 3 4" };
/// Edge of a check's band.
pub(crate) const BAND: Stroke = Stroke::solid("#7088a8", 0.8);
/// Signs without a line.
pub(crate) const SIGNS: Stroke = Stroke::solid("#000", 0.0);
/// What fills a band.
pub(crate) const FILL: &str = "#dfe6ef";
/// Line of a design force.
pub(crate) const DESIGN: Stroke = Stroke { colour: "#8a2b00", width: 1.6, dashes: "8 4" };
/// Line of an allowable deflection.
pub(crate) const ALLOWABLE: Stroke = Stroke { colour: "#8a2b00", width: 1.6, dashes: "3 3" };
/// Line of a factored resistance.
pub(crate) const RESISTANCE: Stroke = Stroke { colour: "#000", width: 1.2, dashes: "12 3 2 3 2 3" };

/// The style of a curve among several: dashes, colour and sign repeat at different lengths, so that
/// the first forty are all different; the number at its end tells the rest.
pub(crate) fn nth(index: usize) -> (Stroke, Mark) {
    const DASHES: [&str; 5] = ["", "10 4", "4 3", "12 4 3 4", "18 5"];
    const COLOURS: [&str; 6] = ["#000", "#00479a", "#8a2b00", "#0a5040", "#5a1a78", "#5a4a00"];
    const MARKS: [Mark; 8] = [
        Mark::Cross,
        Mark::Disc,
        Mark::Square,
        Mark::Triangle,
        Mark::Ring,
        Mark::Block,
        Mark::Diamond,
        Mark::Plus,
    ];
    let stroke =
        Stroke { colour: COLOURS[index % 6], width: 1.9, dashes: DASHES[index % DASHES.len()] };
    (stroke, MARKS[index % MARKS.len()])
}

impl Mark {
    /// Draws the sign in the colour of its line.
    pub(crate) fn draw(self, drawing: &mut Drawing, (x, y): (f64, f64), size: f64, line: Stroke) {
        let r = size / 2.0;
        let pen = Stroke::solid(line.colour, 1.8);
        let square = [(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)];
        match self {
            Mark::Cross => {
                drawing.line(&[(x - r, y - r), (x + r, y + r)], pen);
                drawing.line(&[(x - r, y + r), (x + r, y - r)], pen);
            }
            Mark::Plus => {
                drawing.line(&[(x - r, y), (x + r, y)], pen);
                drawing.line(&[(x, y - r), (x, y + r)], pen);
            }
            Mark::Disc => drawing.circle((x, y), r, line.colour, pen),
            Mark::Ring => drawing.circle((x, y), r, "#fff", pen),
            Mark::Block => drawing.area(&square, line.colour, pen),
            Mark::Square => drawing.area(&square, "#fff", pen),
            Mark::Triangle => {
                drawing.area(&[(x, y - r), (x + r, y + r), (x - r, y + r)], "#fff", pen);
            }
            Mark::Diamond => {
                let d = r * 1.25;
                drawing.area(&[(x, y - d), (x + d, y), (x, y + d), (x - d, y)], "#fff", pen);
            }
        }
    }
}
