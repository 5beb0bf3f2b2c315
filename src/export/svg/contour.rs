//! Lines of equal value over a grid, by marching squares.

/// An edge of the grid: from its point in this column and row to the next column, or to the next row.
type Edge = (usize, usize, bool);

/// The lines on which the values, `values[row][column]`, are `level`; points in columns and rows.
pub(crate) fn lines(values: &[Vec<f64>], level: f64) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<[Edge; 2]> = Vec::new();
    for row in 0..values.len().saturating_sub(1) {
        for column in 0..values[row].len().saturating_sub(1) {
            pieces.extend(in_cell(values, level, column, row));
        }
    }
    let mut lines = Vec::new();
    while let Some(piece) = pieces.pop() {
        let mut line = std::collections::VecDeque::from(piece);
        while let Some(edge) = take(&mut pieces, line[line.len() - 1]) {
            line.push_back(edge);
        }
        while let Some(edge) = take(&mut pieces, line[0]) {
            line.push_front(edge);
        }
        lines.push(line.into_iter().map(|edge| crossing(values, level, edge)).collect());
    }
    lines
}

/// Takes a piece that ends on an edge out of the list, and says where its other end is.
fn take(pieces: &mut Vec<[Edge; 2]>, end: Edge) -> Option<Edge> {
    let found = pieces.iter().position(|piece| piece.contains(&end))?;
    let [a, b] = pieces.swap_remove(found);
    Some(if a == end { b } else { a })
}

/// The pieces of lines through a cell: each joins two of its edges.
fn in_cell(values: &[Vec<f64>], level: f64, column: usize, row: usize) -> Vec<[Edge; 2]> {
    let corners = [
        values[row][column],
        values[row][column + 1],
        values[row + 1][column + 1],
        values[row + 1][column],
    ];
    let above = corners.map(|v| v >= level);
    // In the order of the corners: edge k goes from corner k to the next.
    let edges = [
        (column, row, true),
        (column + 1, row, false),
        (column, row + 1, true),
        (column, row, false),
    ];
    let crossed: Vec<Edge> =
        (0..4).filter(|k| above[*k] != above[(k + 1) % 4]).map(|k| edges[k]).collect();
    match crossed[..] {
        [a, b] => vec![[a, b]],
        // A saddle: the middle says which corners belong together.
        [a, b, c, d] => {
            let middle = corners.iter().sum::<f64>() / 4.0 >= level;
            if middle == above[0] { vec![[a, b], [c, d]] } else { vec![[d, a], [b, c]] }
        }
        _ => Vec::new(),
    }
}

/// Where the level is on an edge.
fn crossing(values: &[Vec<f64>], level: f64, (column, row, across): Edge) -> (f64, f64) {
    let from = values[row][column];
    let to = if across { values[row][column + 1] } else { values[row + 1][column] };
    let part = (level - from) / (to - from);
    let (x, y) = (column as f64, row as f64);
    if across { (x + part, y) } else { (x, y + part) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(n: usize, of: impl Fn(f64, f64) -> f64) -> Vec<Vec<f64>> {
        (0..n).map(|y| (0..n).map(|x| of(x as f64, y as f64)).collect()).collect()
    }

    #[test]
    fn a_line_of_a_slope_is_straight_and_in_one_piece() {
        // x + 2 y = 5 from (1, 2) on the left edge's side to (4, 0.5).
        let found = lines(&grid(5, |x, y| x + 2.0 * y), 5.0);
        assert_eq!(found.len(), 1);
        assert!(found[0].iter().all(|(x, y)| (x + 2.0 * y - 5.0).abs() < 1e-12), "{found:?}");
        let ends = [found[0][0], *found[0].last().unwrap()];
        assert!(ends.contains(&(0.0, 2.5)) && ends.contains(&(4.0, 0.5)), "{ends:?}");
    }

    #[test]
    fn a_hill_has_a_closed_line_and_nothing_above_it() {
        let hill = grid(7, |x, y| -(x - 3.0).powi(2) - (y - 3.0).powi(2));
        let found = lines(&hill, -4.5);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].first(), found[0].last());
        // A circle of radius 2.12, to what linear interpolation gives.
        let radius = |(x, y): &(f64, f64)| (x - 3.0).hypot(y - 3.0);
        assert!(found[0].iter().all(|p| (1.9..2.2).contains(&radius(p))), "{found:?}");
        assert!(lines(&hill, 1.0).is_empty());
    }

    #[test]
    fn a_saddle_has_two_lines() {
        let found = lines(&grid(2, |x, y| if x == y { 1.0 } else { 0.0 }), 0.6);
        assert_eq!(found.len(), 2);
    }
}
