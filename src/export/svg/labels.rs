//! Words in a chart that find a free place: beside their point, off the curves and off each other.

use super::drawing::{Anchor, Drawing, Frame, TEXT, text_width};

/// Space around a word.
const AIR: f64 = 2.0;

/// What is taken already.
#[derive(Debug)]
pub(crate) struct Labels {
    inside: Frame,
    taken: Vec<Frame>,
}

impl Labels {
    /// Nothing but the frame that words must stay in.
    pub(crate) fn new(inside: Frame) -> Labels {
        Labels { inside, taken: Vec::new() }
    }

    /// Keeps words off a line.
    pub(crate) fn avoid(&mut self, points: &[(f64, f64)]) {
        const REACH: f64 = 3.0;
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let length = ((b.0 - a.0).powi(2) + (b.1 - a.1).powi(2)).sqrt();
            let steps = (length / 5.0).ceil().clamp(1.0, 400.0) as u32;
            for i in 0..=steps {
                let t = f64::from(i) / f64::from(steps);
                self.avoid_point((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)), REACH);
            }
        }
    }

    /// Keeps words off a point.
    pub(crate) fn avoid_point(&mut self, (x, y): (f64, f64), reach: f64) {
        self.taken.push(Frame {
            left: x - reach,
            top: y - reach,
            right: x + reach,
            bottom: y + reach,
        });
    }

    /// Writes a word at the first of the places that is free, or at the one that meets the fewest
    /// others. A place is where the base line begins.
    fn put(&mut self, drawing: &mut Drawing, places: &[(f64, f64)], text: &str, bold: bool) {
        let width = text_width(text, TEXT);
        let frame = |(x, y): (f64, f64)| Frame {
            left: x - AIR,
            top: y - TEXT * 0.8 - AIR,
            right: x + width + AIR,
            bottom: y + TEXT * 0.25 + AIR,
        };
        let meets = |place: &(f64, f64)| {
            let own = frame(*place);
            if !self.inside.holds_all(&own) {
                return usize::MAX;
            }
            self.taken.iter().filter(|taken| taken.meets(&own)).count()
        };
        let Some(best) = places.iter().min_by_key(|place| meets(place)).copied() else { return };
        self.taken.push(frame(best));
        if bold {
            drawing.bold(best, Anchor::Start, TEXT, text);
        } else {
            drawing.text(best, Anchor::Start, TEXT, text);
        }
    }

    /// A word beside a point, in growing circles around it.
    pub(crate) fn beside(&mut self, drawing: &mut Drawing, (x, y): (f64, f64), text: &str) {
        let width = text_width(text, TEXT);
        let mut places = Vec::new();
        for ring in 0..8 {
            let gap = 9.0 + 9.0 * f64::from(ring);
            let middle = y + TEXT * 0.35;
            places.extend([
                (x + gap, middle),
                (x - gap - width, middle),
                (x + gap * 0.7, middle - gap),
                (x - gap * 0.7 - width, middle - gap),
                (x - width / 2.0, middle - gap - 4.0),
                (x + gap * 0.7, middle + gap),
                (x - gap * 0.7 - width, middle + gap),
            ]);
        }
        self.put(drawing, &places, text, true);
    }

    /// A word on a line, as near to its middle as there is room.
    pub(crate) fn on(&mut self, drawing: &mut Drawing, line: &[(f64, f64)], text: &str) {
        let width = text_width(text, TEXT);
        let middle = line.len() / 2;
        let mut nearest: Vec<usize> = (0..line.len()).collect();
        nearest.sort_by_key(|i| i.abs_diff(middle));
        let places = nearest.into_iter().map(|i| line[i]);
        let places: Vec<_> = places.map(|(x, y)| (x - width / 2.0, y + TEXT * 0.35)).collect();
        self.put(drawing, &places, text, false);
    }

    /// A word along a level line: above it, from the left, or else below it.
    pub(crate) fn along(&mut self, drawing: &mut Drawing, y: f64, text: &str) {
        let mut places = Vec::new();
        for side in [-9.0, TEXT + 3.0] {
            for step in 0..30 {
                places.push((self.inside.left + 8.0 + 20.0 * f64::from(step), y + side));
            }
        }
        self.put(drawing, &places, text, false);
    }

    /// A word at an upright line: right of it, from the top, or else left of it.
    pub(crate) fn upright(&mut self, drawing: &mut Drawing, x: f64, text: &str) {
        let width = text_width(text, TEXT);
        let mut places = Vec::new();
        for left in [x + 6.0, x - 6.0 - width] {
            for step in 0..20 {
                places.push((left, self.inside.top + 20.0 + 16.0 * f64::from(step)));
            }
        }
        self.put(drawing, &places, text, false);
    }
}
