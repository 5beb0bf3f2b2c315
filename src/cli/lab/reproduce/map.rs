//! Fig. A1: what an offset does to force and deflection, as lines of equal factor and as a table.

use crate::axis::Axis;
use crate::export::svg::contour;
use crate::export::svg::drawing::{Anchor, Drawing, Frame, Stroke, TEXT};
use crate::export::svg::frame::Plane;
use crate::export::svg::labels::Labels;
use crate::export::svg::legend::{self, LegendEntry};
use crate::export::svg::marks::{self, Mark};
use crate::lab::reproduce::scenes::{MapPoint, POINTS};
use crate::layout::{Layout, REFERENCE};
use crate::method::DerivedMethod;
use crate::method::offset::Factors;
use crate::units::significant;

/// Width of the picture, and side of a map.
const SIZE: (f64, f64) = (820.0, 310.0);
/// Left edges of the maps.
const LEFT: [f64; 2] = [72.0, 482.0];
/// Steps of the grid from the centre to half of the spacing.
const STEPS: usize = 25;
/// A line of fewer points is a speck at a place where the factor is the level itself.
const SPECK: usize = 4;
const STEP: f64 = HALF / STEPS as f64;
/// Distance of two lines.
const LEVELS: [f64; 2] = [0.1, 0.05];
/// How many of them from 0 on.
const MOST: u32 = 30;
/// Half of the spacing, over it: the maps' edge, beyond which they repeat.
const HALF: f64 = 0.5;
/// What fills the places on a plate.
const PLATE: &str = "#ccc";
const TITLE: &str = "Fig. A1: factors of an offset at the reference panel, repeated blocks";

/// The two maps.
pub(super) fn svg(method: &DerivedMethod) -> String {
    let mut drawing = Drawing::new(SIZE.0);
    drawing.bold((12.0, 24.0), Anchor::Start, TEXT + 1.0, TITLE);
    let names = ["factor on F", "factor on \u{3b4}"];
    for quantity in [0, 1] {
        let (left, top) = (LEFT[quantity], 66.0);
        drawing.bold((left, top - 12.0), Anchor::Start, TEXT, names[quantity]);
        let frame = Frame { left, top, right: left + SIZE.1, bottom: top + SIZE.1 };
        one(&mut drawing, frame, method, quantity);
    }
    let line = |line: Stroke, mark: Option<Mark>, words: String| LegendEntry {
        line: Some(line),
        mark,
        band: false,
        tag: String::new(),
        words,
    };
    let of = &method.offsets;
    let mut entries = vec![
        line(THIN, None, format!("equal factor, from {} runs of our campaign", of.runs)),
        line(ONE, None, "factor 1: as the centred block".into()),
        line(Stroke::solid(PLATE, 12.0), None, "block on a plate, outside the method".into()),
    ];
    for (number, said) in (1..).zip(said(method)) {
        entries.push(LegendEntry {
            tag: number.to_string(),
            ..line(marks::SIGNS, Some(Mark::Disc), said)
        });
    }
    let right = LEFT[1] + SIZE.1;
    let below = legend::draw(&mut drawing, &entries, LEFT[0], right, 66.0 + SIZE.1 + 54.0);
    let words: Vec<String> = entries.into_iter().map(|entry| entry.words).collect();
    drawing.finish(below + 12.0, TITLE, &words.join(". "))
}

const THIN: Stroke = Stroke::solid("#00479a", 1.2);
const ONE: Stroke = Stroke::solid("#000", 2.4);

/// What the paper says of its two points, and ours.
fn said(method: &DerivedMethod) -> Vec<String> {
    let of = |point: &MapPoint| {
        let (paper, ours) = (&point.factors, factors(method, point.at));
        let [x, y] = point.at;
        let [paper, ours] = [paper, &ours].map(|f| {
            let [force, deflection] = [f.force, f.deflection].map(|v| significant(v, 3));
            format!("F x {force}, \u{3b4} x {deflection}")
        });
        format!("({x}, {y}) L: paper {paper}; ours {ours}")
    };
    POINTS.iter().map(of).collect()
}

fn layout([x, y]: [f64; 2]) -> Layout {
    Layout { ex: x * REFERENCE.spacing, ey: y * REFERENCE.spacing, ..REFERENCE }
}

fn factors(method: &DerivedMethod, at: [f64; 2]) -> Factors {
    let layout = layout(at);
    method.offsets.at(&layout, &method.sizes.at(&layout))
}

/// Values over the grid: rows ey, columns ex.
fn grid(of: impl Fn([f64; 2]) -> f64) -> Vec<Vec<f64>> {
    let at = |k: usize| STEP * k as f64;
    (0..=STEPS).map(|row| (0..=STEPS).map(|column| of([at(column), at(row)])).collect()).collect()
}

fn one(drawing: &mut Drawing, frame: Frame, method: &DerivedMethod, quantity: usize) {
    let axis = Axis::holding(HALF, 5);
    let plane = Plane { frame, x: axis, y: axis };
    plane.draw(drawing, ["ex/L (-)", "ey/L (-)"]);
    let place = |line: &[(f64, f64)]| -> Vec<(f64, f64)> {
        line.iter().map(|(x, y)| plane.at((x * STEP, y * STEP))).collect()
    };
    let mut labels = Labels::new(frame);
    let plates = plates(&place);
    for point in &POINTS {
        labels.avoid_point(plane.at((point.at[0], point.at[1])), 6.0);
    }
    labels.avoid(&plates);
    let values = grid(|at| {
        let f = factors(method, at);
        [f.force, f.deflection][quantity]
    });
    let lines = (1..=MOST).map(|k| f64::from(k) * LEVELS[quantity]).flat_map(|level| {
        let lines = contour::lines(&values, level).into_iter();
        lines.filter(|line| line.len() >= SPECK).map(move |line| (level, line))
    });
    let lines: Vec<(f64, Vec<(f64, f64)>)> = lines.collect();
    for (level, line) in &lines {
        drawing.line(&place(line), if (level - 1.0).abs() < 1e-9 { ONE } else { THIN });
    }
    drawing.area(&plates, PLATE, Stroke::solid(PLATE, 1.0));
    for (number, point) in (1..).zip(&POINTS) {
        let at = plane.at((point.at[0], point.at[1]));
        Mark::Disc.draw(drawing, at, 8.0, marks::SIGNS);
        let paper = [point.factors.force, point.factors.deflection][quantity];
        labels.beside(drawing, at, &format!("{number}: {}", significant(paper, 3)));
    }
    for (level, line) in &lines {
        // What lies on plates is not seen.
        let seen: Vec<_> = line.iter().copied().filter(|at| !on_plate(*at)).collect();
        labels.on(drawing, &place(&seen), &format!("{level:.*}", [1, 2][quantity]));
    }
}

/// Whether a block at a place, in steps of the grid, stands on a plate.
fn on_plate((x, y): (f64, f64)) -> bool {
    layout([x * STEP, y * STEP]).punch_on_plate()
}

/// Where the block stands on a plate: around the corner.
fn plates(place: &impl Fn(&[(f64, f64)]) -> Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let gap = grid(|at| {
        let layout = layout(at);
        layout.distance_to_plate() - layout.punch / 2.0
    });
    let mut edge = contour::lines(&gap, 0.0).into_iter().next().unwrap_or_default();
    edge.push((STEPS as f64, STEPS as f64));
    place(&edge)
}
