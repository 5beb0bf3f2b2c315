//! Moving the cursor in as few bytes as the terminal allows.

use super::pen::decimal;

/// Where the cursor stands. After a character in the last column terminals differ about the column:
/// then it is `None`, and the next move starts with a carriage return or is absolute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cursor {
    pub(super) row: u16,
    pub(super) column: Option<u16>,
}

/// Writes the shortest move found from `from` to a cell.
pub(super) fn travel(from: Option<Cursor>, row: u16, column: u16, out: &mut Vec<u8>) {
    let mut best = Vec::with_capacity(12);
    absolute(row, column, &mut best);
    if let Some(from) = from
        && from.row <= row
    {
        let down = row - from.row;
        if let Some(at) = from.column {
            let mut way = Vec::with_capacity(12);
            lower(down, &mut way);
            sideways(at, column, &mut way);
            keep_shorter(way, &mut best);
        }
        if down <= 4 {
            let mut way = vec![b'\r'];
            way.resize(1 + usize::from(down), b'\n');
            sideways(0, column, &mut way);
            keep_shorter(way, &mut best);
        }
    }
    out.extend_from_slice(&best);
}

/// Bytes that it takes to step over `gap` columns.
pub(super) fn skip_cost(gap: u16) -> usize {
    match gap {
        0 => 0,
        1 => 3,
        2..=9 => 4,
        10..=99 => 5,
        _ => 6,
    }
}

fn keep_shorter(way: Vec<u8>, best: &mut Vec<u8>) {
    if way.len() < best.len() {
        *best = way;
    }
}

fn absolute(row: u16, column: u16, out: &mut Vec<u8>) {
    out.extend_from_slice(b"\x1b[");
    if row > 0 || column > 0 {
        decimal(row.saturating_add(1), out);
    }
    if column > 0 {
        out.push(b';');
        decimal(column.saturating_add(1), out);
    }
    out.push(b'H');
}

fn lower(rows: u16, out: &mut Vec<u8>) {
    if rows > 0 {
        relative(rows, b'B', out);
    }
}

fn sideways(from: u16, to: u16, out: &mut Vec<u8>) {
    if to > from {
        relative(to - from, b'C', out);
    } else if from - to <= 3 {
        out.resize(out.len() + usize::from(from - to), b'\x08');
    } else {
        relative(from - to, b'D', out);
    }
}

fn relative(n: u16, direction: u8, out: &mut Vec<u8>) {
    out.extend_from_slice(b"\x1b[");
    if n > 1 {
        decimal(n, out);
    }
    out.push(direction);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every move ends where it should, on a terminal that knows no more than a VT100.
    #[test]
    fn every_move_arrives() {
        for from_row in 0..6u16 {
            for from_column in [0, 1, 5, 9, 10, 11, 18, 19] {
                for row in 0..6u16 {
                    for column in [0, 1, 4, 8, 9, 10, 12, 19] {
                        let mut terminal = parser(6, 20);
                        let mut bytes = Vec::new();
                        absolute(from_row, from_column, &mut bytes);
                        let from = Cursor { row: from_row, column: Some(from_column) };
                        travel(Some(from), row, column, &mut bytes);
                        terminal.process(&bytes);
                        assert_eq!(terminal.screen().cursor_position(), (row, column));
                    }
                }
            }
        }
    }

    #[test]
    fn after_the_last_column_the_move_does_not_count_columns() {
        for (row, column) in [(0, 0), (0, 5), (1, 0), (1, 7), (3, 19)] {
            let mut terminal = parser(4, 20);
            let mut bytes = b"\x1b[1;20Hx".to_vec();
            travel(Some(Cursor { row: 0, column: None }), row, column, &mut bytes);
            terminal.process(&bytes);
            assert_eq!(terminal.screen().cursor_position(), (row, column));
        }
    }

    #[test]
    fn short_moves_are_short() {
        let from = Some(Cursor { row: 3, column: Some(40) });
        let cost = |row, column| {
            let mut out = Vec::new();
            travel(from, row, column, &mut out);
            out.len()
        };
        assert_eq!(cost(3, 40), 0);
        assert_eq!(cost(3, 39), 1);
        assert_eq!(cost(3, 0), 1);
        assert_eq!(cost(4, 0), 2);
        assert_eq!(cost(4, 40), 3);
        assert_eq!(cost(0, 0), 3);
        for gap in 1..30 {
            assert_eq!(cost(3, 40 + gap), skip_cost(gap));
        }
    }

    fn parser(rows: u16, columns: u16) -> vt100::Parser {
        let size = |n| std::num::NonZeroU16::new(n).unwrap();
        vt100::Parser::new(size(rows), size(columns), 0)
    }
}
