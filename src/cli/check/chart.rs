//! Curves drawn in plain characters.

use crate::curve::Curve;
use crate::units::{LengthUnit, significant, to_kn};

/// Columns and rows of the drawing.
const COLUMNS: usize = 60;
const ROWS: usize = 14;

/// A curve and the character it is drawn with.
pub(super) struct ChartLine<'a> {
    /// The points.
    pub curve: &'a Curve,
    /// The character.
    pub sign: char,
}

/// The curves in one drawing, the later ones over the earlier ones. Failure points are `X`.
pub(crate) fn draw(lines: &[ChartLine], unit: LengthUnit) -> Vec<String> {
    let points = || lines.iter().flat_map(|l| l.curve.points());
    let most = |values: &mut dyn Iterator<Item = f64>| {
        values.filter(|v| v.is_finite()).fold(0.0, f64::max)
    };
    let right = most(&mut points().map(|p| p.deflection));
    let top = most(&mut points().map(|p| p.force));
    if right <= 0.0 || top <= 0.0 {
        return Vec::new();
    }
    let mut grid = vec![[' '; COLUMNS]; ROWS];
    let mut put = |deflection: f64, force: f64, sign: char| {
        let column = (deflection / right * (COLUMNS - 1) as f64).round();
        let row = (force / top * (ROWS - 1) as f64).round();
        if (0.0..COLUMNS as f64).contains(&column) && (0.0..ROWS as f64).contains(&row) {
            grid[ROWS - 1 - row as usize][column as usize] = sign;
        }
    };
    for line in lines {
        let all: Vec<_> = line.curve.points().collect();
        for pair in all.windows(2) {
            // Steep parts are filled in, so that a line has no gaps.
            let rows = (pair[1].force - pair[0].force).abs() / top * ROWS as f64;
            let steps = (rows.ceil() as usize).clamp(1, ROWS);
            for k in 0..=steps {
                let part = k as f64 / steps as f64;
                put(
                    pair[0].deflection + part * (pair[1].deflection - pair[0].deflection),
                    pair[0].force + part * (pair[1].force - pair[0].force),
                    line.sign,
                );
            }
        }
    }
    for failure in lines.iter().filter_map(|l| l.curve.failure) {
        put(failure.deflection, failure.force, 'X');
    }
    let label = |row: usize| match row {
        0 => significant(to_kn(top), 3),
        _ if row == ROWS - 1 => "0".to_string(),
        _ => String::new(),
    };
    let mut out: Vec<String> = grid
        .iter()
        .enumerate()
        .map(|(row, signs)| {
            let signs: String = signs.iter().collect();
            format!("{:>8} |{}", label(row), signs.trim_end())
        })
        .collect();
    out[0].push_str("  kN");
    out.push(format!("{:>8} +{}", "", "-".repeat(COLUMNS)));
    let end = crate::units::length_text(right, unit);
    out.push(format!("{:>8}  0{end:>width$}", "", width = COLUMNS - 1));
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
        let drawn = draw(&[ChartLine { curve: &curve, sign: '*' }], LengthUnit::Metre);
        assert!(drawn[0].starts_with("    20.0 |") && drawn[0].contains("X  kN"), "{}", drawn[0]);
        assert!(drawn[ROWS - 1].starts_with("       0 |*"));
        assert!(drawn[..ROWS].iter().all(|row| row.contains(['*', 'X'])));
        assert!(drawn.iter().all(|row| row.len() <= 80));
        assert!(draw(&[], LengthUnit::Metre).is_empty());
    }
}
