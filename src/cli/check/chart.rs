//! Curves drawn in plain characters.

use crate::curve::Curve;
use crate::show::glyphs::Glyphs;
use crate::show::grid::{DotPen, Pattern};
use crate::show::picture::Ink;
use crate::show::plot::{Plot, PlotAxis};
use crate::units::{Units, length_text};

/// Columns and rows between the axes.
const COLUMNS: usize = 60;
const ROWS: usize = 14;
/// Columns of the labels at the left.
const MARGIN: usize = 9;

/// A curve and the character it is drawn with.
pub(super) struct ChartLine<'a> {
    /// The points.
    pub curve: &'a Curve,
    /// The character.
    pub sign: char,
}

/// The curves in one drawing, the later ones over the earlier ones. Failure points are `X`.
pub(crate) fn draw(lines: &[ChartLine], unit: Units) -> Vec<String> {
    let points = || lines.iter().flat_map(|l| l.curve.points());
    let most = |values: &mut dyn Iterator<Item = f64>| {
        values.filter(|v| v.is_finite()).fold(0.0, f64::max)
    };
    let right = most(&mut points().map(|p| p.deflection));
    let top = most(&mut points().map(|p| p.force));
    if right <= 0.0 || top <= 0.0 {
        return Vec::new();
    }
    let x = vec![(0.0, "0".into()), (right, length_text(right, unit))];
    let x = PlotAxis { ends: (0.0, right), ticks: x };
    let y = PlotAxis { ends: (0.0, top), ticks: vec![(top, unit.force_number(top, 3))] };
    let size = (MARGIN + 1 + COLUMNS, ROWS + 2);
    let Some(mut plot) = Plot::new(size, MARGIN, x, y, Glyphs::Ascii) else { return Vec::new() };
    plot.picture.put_right(ROWS - 1, MARGIN - 1, "0", Ink::Text);
    let mut letters = plot.letters();
    for line in lines {
        let pen = DotPen { ink: Ink::Text, pattern: Pattern::Solid, ascii: Some(line.sign) };
        plot.curve(line.curve.points().map(|p| (p.deflection, p.force)), pen, &mut letters);
    }
    plot.put(&letters);
    for failure in lines.iter().filter_map(|l| l.curve.failure) {
        plot.mark(failure.deflection, failure.force, 'X', Ink::Text);
    }
    let mut out = plot.picture.lines();
    out[0].push_str(&format!("  {}", unit.force_symbol()));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Point;

    #[test]
    fn a_straight_line_goes_from_corner_to_corner_and_fits_the_page() {
        let end = Point { deflection: 0.5, force: 20_000.0 };
        let curve =
            Curve { deflection: vec![0.0, 0.5], force: vec![0.0, 20_000.0], failure: Some(end) };
        let drawn = draw(&[ChartLine { curve: &curve, sign: '*' }], Units::METRES);
        assert!(drawn[0].starts_with("    20.0 |") && drawn[0].contains("X  kN"), "{}", drawn[0]);
        assert!(drawn[ROWS - 1].starts_with("       0 |*"));
        assert!(drawn[..ROWS].iter().all(|row| row.contains(['*', 'X'])));
        assert!(drawn.iter().all(|row| row.len() <= 80));
        assert!(draw(&[], Units::METRES).is_empty());
    }
}
