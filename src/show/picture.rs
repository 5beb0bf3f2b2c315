//! Characters at their places, each with what it stands for.

/// What a character stands for; a screen gives each its style, a text has none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ink {
    /// Ordinary text.
    Text,
    /// Rules and headings.
    Heading,
    /// What names something.
    Title,
    /// What is selected.
    Selected,
    Forecast,
    /// The check by simulation.
    Check,
    /// Other layouts.
    Overlay,
    /// The laboratory test.
    Laboratory,
    /// Design values.
    Design,
    /// What to distrust.
    Caution,
}

/// A drawing of characters, each one column wide.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Picture {
    width: usize,
    cells: Vec<Option<(char, Ink)>>,
}

impl Picture {
    /// An empty drawing.
    pub(crate) fn new(width: usize, height: usize) -> Picture {
        Picture { width, cells: vec![None; width * height] }
    }

    /// Sets one character; what is outside is left out.
    pub(crate) fn set(&mut self, row: usize, column: usize, sign: char, ink: Ink) {
        if column >= self.width {
            return;
        }
        if let Some(cell) = self.cells.get_mut(row * self.width + column) {
            *cell = Some((sign, ink));
        }
    }

    /// Puts a text from a place to the right, cut at the edge.
    pub(crate) fn put(&mut self, row: usize, column: usize, text: &str, ink: Ink) {
        for (place, sign) in text.chars().enumerate() {
            self.set(row, column + place, sign, ink);
        }
    }

    /// Puts a text so that it ends before a column.
    pub(crate) fn put_right(&mut self, row: usize, end: usize, text: &str, ink: Ink) {
        self.put(row, end.saturating_sub(text.chars().count()), text, ink);
    }

    /// The characters that were put, each with its row and column.
    pub(crate) fn cells(&self) -> impl Iterator<Item = (usize, usize, char, Ink)> + '_ {
        self.cells.iter().enumerate().filter_map(|(i, cell)| {
            cell.map(|(sign, ink)| (i / self.width, i % self.width, sign, ink))
        })
    }

    /// The drawing as lines, without blanks at their ends.
    pub(crate) fn lines(&self) -> Vec<String> {
        // A drawing without width has no cells either.
        self.cells
            .chunks(self.width.max(1))
            .map(|row| {
                let line: String = row.iter().map(|cell| cell.map_or(' ', |c| c.0)).collect();
                line.trim_end().to_string()
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_stay_in_the_picture_and_the_last_one_wins() {
        let mut picture = Picture::new(5, 2);
        picture.put(0, 1, "abcdefg", Ink::Text);
        picture.put_right(1, 4, "xy", Ink::Check);
        picture.put(0, 2, "-", Ink::Heading);
        picture.put(7, 0, "below", Ink::Text);
        assert_eq!(picture.lines(), [" a-cd", "  xy"]);
        assert_eq!(picture.cells().count(), 6);
        assert!(picture.cells().any(|cell| cell == (1, 2, 'x', Ink::Check)));
    }
}
