//! Comparison: the layouts of a project side by side, sorted by any column, and the one that governs.

use crate::case::{Case, NoValue};
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::forecast::design::{Answer, answer};
use crate::forecast::warning::Weight;
use crate::forecast::{Forecast, Values};
use crate::problem::Problem;
use std::cmp::Ordering;

/// One layout of the comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareRow {
    /// Its name.
    pub name: String,
    /// What is forecast.
    pub case: Case,
    /// Its forecast, or what is wrong with its inputs.
    pub forecast: Result<Forecast, Vec<Problem>>,
    /// The answer to its design question; missing without a field value.
    pub answer: Option<Answer>,
}

impl CompareRow {
    /// F_a and delta_a, or why there are none.
    pub(crate) fn values(&self) -> Result<Values, NoValue> {
        match &self.forecast {
            Ok(f) => f.field.map(|field| field.values).ok_or(NoValue::PunchOnPlate),
            Err(problems) => Err(NoValue::Senseless(problems.clone())),
        }
    }

    /// Utilisation, where a design force is set.
    pub(crate) fn utilisation(&self) -> Option<f64> {
        self.answer?.at_force.map(|at| at.utilisation)
    }

    /// The heaviest of its warnings; inputs that make no sense are outside.
    pub(crate) fn weight(&self) -> Option<Weight> {
        match &self.forecast {
            Ok(f) => f.warnings.iter().map(|w| w.weight()).max(),
            Err(_) => Some(Weight::Outside),
        }
    }

    /// What stands in a column; nothing where it has no value.
    fn number(&self, column: Column) -> Option<f64> {
        let (layout, forecast) = (&self.case.layout, self.forecast.as_ref().ok());
        let values = || forecast?.field.map(|field| field.values);
        match column {
            Column::Name | Column::Mesh => None,
            Column::Plate => Some(layout.plate),
            Column::Spacing => Some(layout.spacing),
            Column::Punch => Some(layout.punch),
            Column::OffsetX => Some(layout.ex),
            Column::OffsetY => Some(layout.ey),
            Column::Force => values().map(|v| v.force),
            Column::Deflection => values().map(|v| v.deflection),
            Column::ForceRatio => forecast?.force_over_lab(),
            Column::DeflectionRatio => forecast?.deflection_over_lab(),
            Column::Utilisation => self.utilisation(),
            Column::DesignDeflection => self.answer?.at_force?.deflection,
            Column::Warnings => self.weight().map(|w| f64::from(w as u8)),
        }
    }
}

/// A column of the comparison, by which it can be sorted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// Name of the layout.
    Name,
    /// Identifier of its mesh.
    Mesh,
    /// d, m.
    Plate,
    /// L, m.
    Spacing,
    /// D, m.
    Punch,
    /// e_x, m.
    OffsetX,
    /// e_y, m.
    OffsetY,
    /// F_a, N.
    Force,
    /// delta_a, m.
    Deflection,
    /// F_a over F_l*.
    ForceRatio,
    /// delta_a over delta_l*.
    DeflectionRatio,
    /// Utilisation, where a design force is set.
    Utilisation,
    /// Deflection at the factored design force, m.
    DesignDeflection,
    /// Weight of the heaviest warning.
    Warnings,
}

impl Column {
    /// All of them, in the order of the table.
    pub(crate) const ALL: [Column; 14] = [
        Column::Name,
        Column::Mesh,
        Column::Plate,
        Column::Spacing,
        Column::Punch,
        Column::OffsetX,
        Column::OffsetY,
        Column::Force,
        Column::Deflection,
        Column::ForceRatio,
        Column::DeflectionRatio,
        Column::Utilisation,
        Column::DesignDeflection,
        Column::Warnings,
    ];

    /// The word by which it is named in commands.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Column::Name => "layout",
            Column::Mesh => "mesh",
            Column::Plate => "d",
            Column::Spacing => "L",
            Column::Punch => "D",
            Column::OffsetX => "ex",
            Column::OffsetY => "ey",
            Column::Force => "F",
            Column::Deflection => "delta",
            Column::ForceRatio => "F_ratio",
            Column::DeflectionRatio => "delta_ratio",
            Column::Utilisation => "utilisation",
            Column::DesignDeflection => "design_delta",
            Column::Warnings => "warnings",
        }
    }
}

/// Which layout decides, and by what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// Its place among the rows.
    pub(crate) row: usize,
    /// Its utilisation, the highest; nothing where no layout has a design force, and then its force is
    /// the lowest.
    pub(crate) utilisation: Option<f64>,
}

/// The layouts of a project side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// One for each layout, in the project's order.
    pub rows: Vec<CompareRow>,
    /// The governing one; nothing where none has a value.
    pub governing: Option<Governing>,
}

/// Compares named cases.
pub(crate) fn compare(cases: impl IntoIterator<Item = (String, Case)>) -> Comparison {
    let rows: Vec<CompareRow> = cases
        .into_iter()
        .map(|(name, case)| {
            let forecast = case.forecast();
            let field = forecast.as_ref().ok().and_then(|f| f.field);
            CompareRow { answer: field.map(|f| answer(&f, &case.question)), name, case, forecast }
        })
        .collect();
    let governing = governing(&rows);
    Comparison { rows, governing }
}

/// The highest utilisation, or where no layout has one the lowest force; the first of equals.
fn governing(rows: &[CompareRow]) -> Option<Governing> {
    let numbers = |column: Column| {
        rows.iter().enumerate().filter_map(move |(row, r)| r.number(column).map(|v| (row, v)))
    };
    let lower = |a: &(usize, f64), b: &(usize, f64)| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0));
    let most_used = numbers(Column::Utilisation).max_by(lower);
    match most_used {
        Some((row, utilisation)) => Some(Governing { row, utilisation: Some(utilisation) }),
        None => {
            let weakest = numbers(Column::Force).min_by(|a, b| a.1.total_cmp(&b.1));
            weakest.map(|(row, _)| Governing { row, utilisation: None })
        }
    }
}

impl Comparison {
    /// Fingerprint of all layouts with their names, in the project's order.
    pub(crate) fn fingerprint(&self) -> Fingerprint {
        let all = Fingerprinter::new("compare");
        let taken = self.rows.iter().fold(all, |of, row| {
            of.text(&row.name).text(&row.case.question_fingerprint().to_string())
        });
        taken.finish()
    }

    /// The rows' places sorted by a column, rising or falling. Rows that have nothing there stand at
    /// the end either way; equal ones keep the project's order.
    pub(crate) fn sorted(&self, column: Column, falling: bool) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.rows.len()).collect();
        let way = |o: Ordering| if falling { o.reverse() } else { o };
        order.sort_by(|a, b| {
            let (a, b) = (&self.rows[*a], &self.rows[*b]);
            match column {
                Column::Name => way(a.name.cmp(&b.name)),
                Column::Mesh => way(a.case.mesh.id.cmp(&b.case.mesh.id)),
                _ => match (a.number(column), b.number(column)) {
                    (Some(a), Some(b)) => way(a.total_cmp(&b)),
                    (a, b) => b.is_some().cmp(&a.is_some()),
                },
            }
        });
        order
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::example as case;
    use crate::layout::{Layout, REFERENCE};

    fn three(forces: [Option<f64>; 3]) -> Comparison {
        let layouts = [
            REFERENCE,
            Layout { spacing: 2.0, ..REFERENCE },
            Layout { ex: 1.5, ey: 1.5, ..REFERENCE },
        ];
        let names = ["b", "a", "on plate"].map(String::from);
        let cases = layouts.into_iter().zip(forces).map(|(l, f)| case(l, f));
        compare(names.into_iter().zip(cases))
    }

    #[test]
    fn the_highest_utilisation_governs_or_else_the_lowest_force() {
        // F_a: 27.063 kN, and 27.063 x (0.32/3 + 0.84) = 25.62 kN.
        let c = three([None; 3]);
        assert_eq!(c.governing, Some(Governing { row: 1, utilisation: None }));
        let c = three([Some(13_531.5), None, Some(90_000.0)]);
        let g = c.governing.unwrap();
        assert_eq!(g.row, 0, "one design force is enough, and none without a value counts");
        assert!((g.utilisation.unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(compare([]).governing, None);
        assert_ne!(three([None; 3]).fingerprint(), c.fingerprint());
    }

    #[test]
    fn rows_without_a_value_stand_last_either_way() {
        let c = three([None; 3]);
        assert_eq!(c.sorted(Column::Force, false), [1, 0, 2]);
        assert_eq!(c.sorted(Column::Force, true), [0, 1, 2]);
        assert_eq!(c.sorted(Column::Name, false), [1, 0, 2]);
        assert_eq!(c.sorted(Column::Utilisation, true), [0, 1, 2]);
        assert_eq!(c.sorted(Column::Warnings, true)[0], 2, "outside weighs most");
        for column in Column::ALL {
            assert_eq!(c.sorted(column, false).len(), 3, "{}", column.word());
        }
    }
}
