//! Comparison: the layouts of a project side by side, sorted by any column, and the one that governs.

use crate::case::{Case, Derived, Input, NoValue};
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::forecast::design::{Answer, AtForce, Limit};
use crate::forecast::{Forecast, Values};
use crate::problem::Problem;
use crate::remark::Weight;
use crate::units::percent;
use crate::words::Choice;
use std::cmp::Ordering;

/// One layout of the comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareRow {
    /// Its name.
    pub name: String,
    /// What is forecast.
    pub case: Case,
    /// What follows from it, or what is wrong with its inputs.
    pub derived: Result<Derived, Vec<Problem>>,
}

impl CompareRow {
    /// F_a and delta_a, or why there are none.
    pub(crate) fn values(&self) -> Result<Values, NoValue> {
        match &self.derived {
            Ok(d) => d.forecast.field.map(|field| field.values).map_err(NoValue::Outside),
            Err(problems) => Err(NoValue::Senseless(problems.clone())),
        }
    }

    /// Its forecast, if its inputs make sense.
    pub(crate) fn forecast(&self) -> Option<&Forecast> {
        self.derived.as_ref().ok().map(|derived| &derived.forecast)
    }

    /// The answer to its design question; missing without a field value.
    pub(crate) fn answer(&self) -> Option<Answer> {
        self.derived.as_ref().ok().and_then(|derived| derived.answer)
    }

    /// What its design force needs, where one is set.
    pub(crate) fn at_force(&self) -> Option<AtForce> {
        self.answer()?.at_force
    }

    /// Utilisation, where a design force is set.
    pub(crate) fn utilisation(&self) -> Option<f64> {
        self.at_force().map(|at| at.utilisation)
    }

    /// Whether it holds its load but gives way too far.
    pub(crate) fn over_allowed(&self) -> bool {
        self.at_force().is_some_and(|at| at.over_allowed())
    }

    /// The heaviest of its warnings; inputs that make no sense are outside.
    pub(crate) fn weight(&self) -> Option<Weight> {
        match self.forecast() {
            Some(f) => {
                f.warnings.iter().map(super::super::forecast::warning::Warning::weight).max()
            }
            None => Some(Weight::Outside),
        }
    }

    /// What stands in a column; nothing where it has no value.
    fn number(&self, column: Column) -> Option<f64> {
        let forecast = self.forecast();
        let values = || forecast?.field.ok().map(|field| field.values);
        match column {
            Column::Name | Column::Mesh => None,
            Column::Size(input) => self.case.get(input),
            Column::Force => values().map(|v| v.force),
            Column::Deflection => values().map(|v| v.deflection),
            Column::ForceRatio => forecast?.force_over_lab(),
            Column::DeflectionRatio => forecast?.deflection_over_lab(),
            Column::Utilisation => self.utilisation(),
            Column::DesignDeflection => self.at_force()?.deflection,
            Column::ServiceDeflection => self.at_force()?.service_deflection,
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
    /// A size or an offset of the layout, m.
    Size(Input),
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
    /// Deflection at the design force without its factor, m.
    ServiceDeflection,
    /// Weight of the heaviest warning.
    Warnings,
}

impl Choice for Column {
    /// In the order of the table.
    const ALL: &'static [Column] = &[
        Column::Name,
        Column::Mesh,
        Column::Size(Input::Plate),
        Column::Size(Input::Spacing),
        Column::Size(Input::Punch),
        Column::Size(Input::OffsetX),
        Column::Size(Input::OffsetY),
        Column::Force,
        Column::Deflection,
        Column::ForceRatio,
        Column::DeflectionRatio,
        Column::Utilisation,
        Column::DesignDeflection,
        Column::ServiceDeflection,
        Column::Warnings,
    ];

    fn word(self) -> &'static str {
        match self {
            Column::Name => "layout",
            Column::Mesh => "mesh",
            Column::Size(input) => input.word(),
            Column::Force => "F",
            Column::Deflection => "delta",
            Column::ForceRatio => "F_ratio",
            Column::DeflectionRatio => "delta_ratio",
            Column::Utilisation => "utilisation",
            Column::DesignDeflection => "design_delta",
            Column::ServiceDeflection => "service_delta",
            Column::Warnings => "warnings",
        }
    }
}

/// Which layout decides, and by what.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// Its place among the rows.
    pub(crate) row: usize,
    /// The highest use, of force or deflection; nothing where no layout has a design force, and then
    /// its force is the lowest.
    pub(crate) used: Option<(f64, Limit)>,
}

impl Governing {
    /// By what it governs, where there is a use.
    pub(crate) fn text(&self) -> Option<String> {
        self.used.map(|(used, limit)| {
            let of = match limit {
                Limit::Force => "",
                Limit::Deflection => " of the allowed deflection",
            };
            format!("the highest use, {} %{of}", percent(used))
        })
    }
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
        .map(|(name, case)| CompareRow { derived: case.derive(), name, case })
        .collect();
    let governing = governing(&rows);
    Comparison { rows, governing }
}

/// The highest use of force or deflection, or where no layout has one the lowest force; the first of
/// equals.
fn governing(rows: &[CompareRow]) -> Option<Governing> {
    let uses =
        rows.iter().enumerate().filter_map(|(row, r)| Some((row, r.at_force()?.largest_use())));
    let lower = |a: &(usize, (f64, Limit)), b: &(usize, (f64, Limit))| {
        a.1.0.total_cmp(&b.1.0).then(b.0.cmp(&a.0))
    };
    if let Some((row, used)) = uses.max_by(lower) {
        return Some(Governing { row, used: Some(used) });
    }
    let forces = rows.iter().enumerate().filter_map(|(row, r)| Some((row, r.values().ok()?.force)));
    let weakest = forces.min_by(|a, b| a.1.total_cmp(&b.1));
    weakest.map(|(row, _)| Governing { row, used: None })
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
        assert_eq!(c.governing, Some(Governing { row: 1, used: None }));
        let c = three([Some(13_531.5), None, Some(90_000.0)]);
        let g = c.governing.unwrap();
        assert_eq!(g.row, 0, "one design force is enough, and none without a value counts");
        assert!((g.used.unwrap().0 - 0.5).abs() < 1e-12);
        assert_eq!(compare([]).governing, None);
        assert_ne!(three([None; 3]).fingerprint(), c.fingerprint());
    }

    #[test]
    fn a_layout_over_the_allowed_deflection_governs_one_that_is_used_more_by_force() {
        let mut cases = [case(REFERENCE, Some(20_000.0)), case(REFERENCE, Some(13_531.5))];
        // Half of F_a is reached well beyond 0.2 m, and before failure at 0.635 m.
        cases[1].question.deflection = Some(0.2);
        let c = compare(["strong", "soft"].map(String::from).into_iter().zip(cases));
        assert!(c.rows[0].utilisation() > c.rows[1].utilisation());
        let g = c.governing.unwrap();
        assert_eq!((g.row, g.used.map(|used| used.1)), (1, Some(Limit::Deflection)));
        assert!(g.text().is_some_and(|text| text.ends_with("of the allowed deflection")));
        assert_eq!(c.rows.iter().map(CompareRow::over_allowed).collect::<Vec<_>>(), [false, true]);
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
            assert_eq!(c.sorted(*column, false).len(), 3, "{}", column.word());
        }
    }
}
