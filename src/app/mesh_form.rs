//! The forms by which a mesh comes into the project, row by row: its laboratory record, or the tests that it is
//! adopted from ([`super::adopt_form`]).

use super::entry::{EditTarget, LineEntry};
use super::key::Key;
use crate::mesh::adopted::NamedMethods;
use crate::mesh::{LabRecord, MeshType, STANDARD_PANEL, STANDARD_PUNCH, Statistic};
use crate::problem::Problem;
use crate::units::{Quantity, Units, parse_typed};
use crate::words::Choice;

/// A row: what it is called, the field of the mesh, and what is to be typed.
#[derive(Debug)]
pub(crate) struct FormRow {
    pub(crate) label: &'static str,
    pub(super) field: &'static str,
    pub(crate) about: &'static str,
}

pub(super) const fn row(label: &'static str, field: &'static str, about: &'static str) -> FormRow {
    FormRow { label, field, about }
}

/// Why a row is refused: its field, and in words.
pub(super) type Refusal = (&'static str, String);

/// The value; where there is none, what is wrong is put to the rest and an empty one stands for it.
pub(super) fn or_told<T: Default>(got: Result<T, Refusal>, wrong: &mut Vec<Refusal>) -> T {
    got.unwrap_or_else(|refusal| {
        wrong.push(refusal);
        T::default()
    })
}

/// What is told first of what is wrong, of which there is something.
pub(super) fn first(wrong: Vec<Refusal>) -> Refusal {
    wrong.into_iter().next().unwrap_or_default()
}

/// Words made for the command line, whose flags are the rows of a form: without the signs that mark flags there. What
/// stands within a word, such as a file's name, is left alone.
pub(super) fn of_rows(text: &str) -> String {
    let words = text.split(' ').map(|word| {
        let opening = word.len() - word.trim_start_matches(['(', '"', '`']).len();
        let (opening, rest) = word.split_at(opening);
        format!("{opening}{}", rest.strip_prefix("--").unwrap_or(rest))
    });
    words.collect::<Vec<_>>().join(" ")
}

/// What a form is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FormKind {
    /// The laboratory record of a mesh to be added.
    Record,
    /// The tests of a mesh to be adopted.
    Tests,
}

/// The rows of a record; the last one's Enter adds the mesh.
const ROWS: [FormRow; 8] = [
    row("identifier", "id", "short, without spaces, such as ht-65-3; layouts name the mesh by it"),
    row("name", "name", "for people; may be left empty"),
    row("force", "laboratory.force", "F_l of the punch test, kN or with a unit: 180, 40 kip"),
    row(
        "deflection",
        "laboratory.deflection",
        "delta_l at failure; left empty where none was published: forces then, and no curve",
    ),
    row(
        "kind",
        "laboratory.statistic",
        "mean, characteristic or minimum, as the record says (m, c or mi will do); a declared value is mostly characteristic",
    ),
    row("panel", "laboratory.panel", "side of the panel in the test; empty: 3 m, the standard one"),
    row("standard", "laboratory.standard", "such as ISO 17746; may be left empty"),
    row("source", "laboratory.source", "where the values were published; Enter adds the mesh"),
];

/// The form as far as it is filled in.
#[derive(Debug, Clone)]
pub struct MeshForm {
    pub(crate) kind: FormKind,
    rows: &'static [FormRow],
    /// A line for each row.
    pub(crate) lines: Vec<LineEntry>,
    /// The marked row.
    pub(crate) index: usize,
    /// Why the mesh was refused.
    pub(crate) error: Option<String>,
}

impl MeshForm {
    /// An empty form of a record.
    pub(super) fn record() -> MeshForm {
        MeshForm::new(FormKind::Record, &ROWS)
    }

    /// An empty form of these rows.
    pub(super) fn new(kind: FormKind, rows: &'static [FormRow]) -> MeshForm {
        let lines = rows.iter().map(|_| LineEntry::new(EditTarget::Mesh, "")).collect();
        MeshForm { kind, rows, lines, index: 0, error: None }
    }

    pub(crate) fn rows(&self) -> &'static [FormRow] {
        self.rows
    }

    /// Whether the marked row is the last.
    pub(super) fn at_end(&self) -> bool {
        self.index + 1 >= self.lines.len()
    }

    /// What stands in a row, by its field.
    pub(super) fn text(&self, field: &str) -> &str {
        self.row_of(field).and_then(|row| self.lines.get(row)).map_or("", |line| line.text().trim())
    }

    /// The line of the marked row.
    pub(super) fn line(&mut self) -> &mut LineEntry {
        self.error = None;
        &mut self.lines[self.index]
    }

    pub(super) fn key(&mut self, key: Key) {
        self.line().key(key);
    }

    /// Moves the mark.
    pub(super) fn step(&mut self, lines: isize) {
        self.index = self.index.saturating_add_signed(lines).min(self.lines.len() - 1);
    }

    /// Marks what is wrong.
    pub(super) fn refuse(&mut self, field: &str, why: String) {
        self.index = self.row_of(field).unwrap_or(self.index);
        self.error = Some(why);
    }

    /// The row of a field.
    fn row_of(&self, field: &str) -> Option<usize> {
        self.rows().iter().position(|row| row.field == field)
    }

    /// A problem as a refusal; that of no row is put to the first. Its flag is the row's, and no word for the screen.
    pub(super) fn refusal(&self, problem: &Problem) -> Refusal {
        let field = self.rows()[self.row_of(&problem.field).unwrap_or(0)].field;
        (field, of_rows(&problem.to_string()))
    }

    /// What is wrong, the first row's first; of a row what was found first.
    pub(super) fn in_order(&self, mut wrong: Vec<Refusal>) -> Vec<Refusal> {
        wrong.sort_by_key(|(field, _)| self.row_of(field));
        wrong
    }

    /// Of what is wrong, what is said of the marked row. A row that was left empty may be filled in later.
    pub(super) fn said_here(&self, wrong: Vec<Refusal>) -> Option<Refusal> {
        let here = self.rows()[self.index].field;
        let said = wrong.into_iter().find(|(field, _)| *field == here);
        said.filter(|_| !self.text(here).is_empty())
    }

    /// The mesh that is typed.
    ///
    /// # Errors
    /// All that is wrong, in the order of the rows.
    pub(super) fn mesh(&self, unit: Units) -> Result<MeshType, Vec<Refusal>> {
        let mut wrong = Vec::new();
        let text = |row: usize| self.lines[row].text().trim();
        let number = |row: usize, quantity| {
            parse_typed(text(row), quantity, unit).map_err(|e| (ROWS[row].field, e.to_string()))
        };
        let kind = text(4).to_lowercase();
        let fits = |s: &Statistic| !kind.is_empty() && s.word().starts_with(&kind);
        let statistic = Statistic::ALL.iter().copied().find(fits);
        let length = |row: usize| match text(row) {
            "" => Ok(None),
            _ => number(row, Quantity::Length).map(Some),
        };
        let mut needed = |row: usize, missing: bool, why: &str| {
            if missing {
                wrong.push((ROWS[row].field, why.to_string()));
            }
        };
        needed(0, text(0).is_empty(), "a mesh needs an identifier");
        needed(4, statistic.is_none(), "mean, characteristic or minimum?");
        needed(7, text(7).is_empty(), "a source is needed");
        let mesh = MeshType {
            id: text(0).into(),
            name: text(1).into(),
            reference: false,
            example: false,
            laboratory: LabRecord {
                force: or_told(number(2, Quantity::Force), &mut wrong),
                deflection: or_told(length(3), &mut wrong),
                statistic: statistic.unwrap_or(Statistic::Mean),
                panel: or_told(length(5), &mut wrong).unwrap_or(STANDARD_PANEL),
                punch: STANDARD_PUNCH,
                standard: text(6).into(),
                date: String::new(),
                source: text(7).into(),
            },
            ratios: None,
            wire: None,
            adopted: None,
            methods: NamedMethods::default(),
        };
        let ranges = mesh.check().err().unwrap_or_default();
        wrong.extend(ranges.iter().map(|problem| self.refusal(problem)));
        if wrong.is_empty() { Ok(mesh) } else { Err(self.in_order(wrong)) }
    }
}

#[cfg(test)]
mod tests {
    use super::of_rows;

    #[test]
    fn the_signs_of_flags_go_and_names_of_files_stay() {
        let said =
            "--curve: a--b.csv: not there; which bond broke (--breaks) or \"--force\" would tell";
        let told = "curve: a--b.csv: not there; which bond broke (breaks) or \"force\" would tell";
        assert_eq!(of_rows(said), told);
    }
}
