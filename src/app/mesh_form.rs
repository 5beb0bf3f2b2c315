//! The form by which a mesh is added to the project: a row for each field of its laboratory record.

use super::entry::{EditTarget, LineEntry};
use super::key::Key;
use crate::mesh::adopted::NamedMethods;
use crate::mesh::{LabRecord, MeshType, STANDARD_PANEL, STANDARD_PUNCH, Statistic};
use crate::units::{Quantity, Units, parse_typed};

/// A row: what it is called, the field of the mesh, and what is to be typed.
pub(crate) struct FormRow {
    pub(crate) label: &'static str,
    pub(super) field: &'static str,
    pub(crate) about: &'static str,
}

const fn row(label: &'static str, field: &'static str, about: &'static str) -> FormRow {
    FormRow { label, field, about }
}

/// The rows; the last one's Enter adds the mesh.
pub(crate) const ROWS: [FormRow; 8] = [
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
        "mean or characteristic, as the record says (m or c will do); a declared value is mostly characteristic",
    ),
    row("panel", "laboratory.panel", "side of the panel in the test; empty: 3 m, the standard one"),
    row("standard", "laboratory.standard", "such as ISO 17746; may be left empty"),
    row("source", "laboratory.source", "where the values were published; Enter adds the mesh"),
];

/// The form as far as it is filled in.
#[derive(Debug, Clone)]
pub struct MeshForm {
    pub(crate) lines: [LineEntry; ROWS.len()],
    /// The marked row.
    pub(crate) index: usize,
    /// Why the mesh was refused.
    pub(crate) error: Option<String>,
}

impl MeshForm {
    pub(super) fn new() -> MeshForm {
        let lines = ROWS.map(|_| LineEntry::new(EditTarget::Mesh, ""));
        MeshForm { lines, index: 0, error: None }
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
        self.index = self.index.saturating_add_signed(lines).min(ROWS.len() - 1);
    }

    /// Marks what is wrong.
    pub(super) fn refuse(&mut self, field: &str, why: String) {
        self.index = ROWS.iter().position(|row| row.field == field).unwrap_or(self.index);
        self.error = Some(why);
    }

    /// The mesh that is typed; else the field that is wrong, and why.
    pub(super) fn mesh(&self, unit: Units) -> Result<MeshType, (&'static str, String)> {
        let text = |row: usize| self.lines[row].text().trim();
        let number = |row: usize, quantity| {
            parse_typed(text(row), quantity, unit).map_err(|e| (ROWS[row].field, e.to_string()))
        };
        let kinds = [Statistic::Mean, Statistic::Characteristic];
        let kind = text(4).to_lowercase();
        let fits = |s: &Statistic| !kind.is_empty() && s.word().starts_with(&kind);
        let statistic = kinds.into_iter().find(fits);
        let length = |row: usize| match text(row) {
            "" => Ok(None),
            _ => number(row, Quantity::Length).map(Some),
        };
        if text(0).is_empty() {
            return Err((ROWS[0].field, "a mesh needs an identifier".into()));
        }
        Ok(MeshType {
            id: text(0).into(),
            name: text(1).into(),
            reference: false,
            example: false,
            laboratory: LabRecord {
                force: number(2, Quantity::Force)?,
                deflection: length(3)?,
                statistic: statistic.ok_or((ROWS[4].field, "mean or characteristic?".into()))?,
                panel: length(5)?.unwrap_or(STANDARD_PANEL),
                punch: STANDARD_PUNCH,
                standard: text(6).into(),
                source: match text(7) {
                    "" => Err((ROWS[7].field, "a source is needed".to_string())),
                    source => Ok(source.into()),
                }?,
            },
            ratios: None,
            wire: None,
            adopted: None,
            methods: NamedMethods::default(),
        })
    }
}
