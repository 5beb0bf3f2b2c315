//! Comparison: the layouts of a project side by side, sorted by any column, and the one that governs.

use super::verdict::{Aspect, Basis, Simulated, Verdict, verdict};
use crate::case::{Case, Derived, Input, NoValue};
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::forecast::design::{Answer, AtForce};
use crate::forecast::{Forecast, Strength};
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::remark::Weight;
use crate::words::Choice;
use std::cmp::Ordering;

/// One layout of the comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct CompareRow {
    pub name: String,
    /// What is forecast.
    pub case: Case,
    /// What follows from it, or what is wrong with its inputs.
    pub derived: Result<Derived, Vec<Problem>>,
    /// Whether it is enough, by the forecast and by its check.
    pub verdict: Verdict,
}

impl CompareRow {
    /// F_a and delta_a, or why there are none.
    pub(crate) fn values(&self) -> Result<Strength, NoValue> {
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
            Column::Deflection => values()?.deflection,
            Column::ForceRatio => forecast?.force_over_lab(),
            Column::DeflectionRatio => forecast?.deflection_over_lab(),
            Column::Utilisation => self.utilisation(),
            Column::Use => self.verdict.governing().map(|_| self.verdict.severity()),
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
    /// Use that governs the verdict, with the verdict's mark.
    Use,
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
        Column::Use,
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
            Column::Use => "use",
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
    /// What its verdict is governed by; nothing where no layout is judged, and then its force is the
    /// lowest.
    pub(crate) by: Option<Aspect>,
}

/// The layouts of a project side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// One for each layout, in the project's order.
    pub rows: Vec<CompareRow>,
    /// The governing one; nothing where none has a value.
    pub governing: Option<Governing>,
}

/// A layout to be compared.
#[derive(Debug, Clone)]
pub(crate) struct LayoutToCompare<'a> {
    pub(crate) name: String,
    /// What is forecast.
    pub(crate) case: Case,
    /// Its check.
    pub(crate) simulated: Simulated<'a>,
}

/// Compares layouts, their verdicts by mean or characteristic values.
pub(crate) fn compare<'a>(
    layouts: impl IntoIterator<Item = LayoutToCompare<'a>>,
    basis: Basis,
) -> Comparison {
    let rows: Vec<CompareRow> = layouts
        .into_iter()
        .map(|LayoutToCompare { name, case, simulated }| {
            let derived = case.derive();
            let verdict = verdict(&case, &derived, simulated, basis);
            CompareRow { name, case, derived, verdict }
        })
        .collect();
    let governing = governing(&rows);
    Comparison { rows, governing }
}

/// The worst verdict, or where no layout is judged the lowest force; the first of equals.
fn governing(rows: &[CompareRow]) -> Option<Governing> {
    let judged = rows.iter().enumerate().filter_map(|(row, r)| {
        let by = r.verdict.governing()?;
        Some((row, r.verdict.severity(), by.aspect))
    });
    let lower = |a: &(usize, f64, Aspect), b: &(usize, f64, Aspect)| {
        a.1.total_cmp(&b.1).then(b.0.cmp(&a.0))
    };
    if let Some((row, _, by)) = judged.max_by(lower) {
        return Some(Governing { row, by: Some(by) });
    }
    let forces = rows.iter().enumerate().filter_map(|(row, r)| Some((row, r.values().ok()?.force)));
    let weakest = forces.min_by(|a, b| a.1.total_cmp(&b.1));
    weakest.map(|(row, _)| Governing { row, by: None })
}

/// What is to be known where the records of some meshes are of another kind than those of others, means beside
/// characteristic values, or of another standard.
pub(crate) fn mixed<'m>(mut meshes: impl Iterator<Item = &'m MeshType>) -> Option<&'static str> {
    let first = &meshes.next()?.laboratory;
    let (mut kinds, mut standards) = (false, false);
    for record in meshes.map(|mesh| &mesh.laboratory) {
        kinds |= record.statistic != first.statistic;
        standards |= record.of_another_standard(first);
    }
    match (kinds, standards) {
        (true, true) => Some(
            "laboratory values of different kinds (mean, characteristic, minimum) and of different standards stand side by side: the forces of the layouts are not to be compared",
        ),
        (true, false) => Some(
            "mean and characteristic laboratory values stand side by side: the forces of the layouts are not of one kind and not to be compared",
        ),
        (false, true) => Some(
            "laboratory values of different standards stand side by side: tests that are not alike; the forces of the layouts are not to be compared",
        ),
        (false, false) => None,
    }
}

impl Comparison {
    /// [`mixed`] of the rows.
    pub(crate) fn mixed(&self) -> Option<&'static str> {
        mixed(self.rows.iter().map(|row| &*row.case.mesh))
    }

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

    fn all(cases: impl Iterator<Item = (String, Case)>) -> Comparison {
        let layout = |(name, case)| LayoutToCompare { name, case, simulated: Simulated::Missing };
        compare(cases.map(layout), Basis::Mean)
    }

    fn three(forces: [Option<f64>; 3]) -> Comparison {
        let layouts = [
            REFERENCE,
            Layout { spacing: 2.0, ..REFERENCE },
            Layout { ex: 1.5, ey: 1.5, ..REFERENCE },
        ];
        let names = ["b", "a", "on plate"].map(String::from);
        let cases = layouts.into_iter().zip(forces).map(|(l, f)| case(l, f));
        all(names.into_iter().zip(cases))
    }

    #[test]
    fn the_highest_utilisation_governs_or_else_the_lowest_force() {
        // F_a: 27.063 kN, and 27.063 x (0.32/3 + 0.84) = 25.62 kN.
        let c = three([None; 3]);
        assert_eq!(c.governing, Some(Governing { row: 1, by: None }));
        let c = three([Some(13_531.5), None, Some(90_000.0)]);
        let g = c.governing.unwrap();
        assert_eq!(g.row, 0, "one design force is enough, and none without a value counts");
        assert_eq!(g.by, Some(Aspect::Strength));
        assert!((c.rows[0].verdict.largest_use().unwrap() - 0.5).abs() < 1e-12);
        assert_eq!(compare([], Basis::Mean).governing, None);
        assert_ne!(three([None; 3]).fingerprint(), c.fingerprint());
    }

    #[test]
    fn a_layout_over_the_allowed_deflection_governs_one_that_is_used_more_by_force() {
        let mut cases = [case(REFERENCE, Some(20_000.0)), case(REFERENCE, Some(13_531.5))];
        // Half of F_a is reached well beyond 0.2 m, and before failure at 0.635 m.
        cases[1].question.deflection = Some(0.2);
        let c = all(["strong", "soft"].map(String::from).into_iter().zip(cases));
        assert!(c.rows[0].utilisation() > c.rows[1].utilisation());
        assert_eq!(c.governing, Some(Governing { row: 1, by: Some(Aspect::Deflection) }));
        assert_eq!(c.sorted(Column::Use, true), [1, 0]);
        assert_eq!(c.sorted(Column::Utilisation, true), [0, 1]);
    }

    #[test]
    fn a_mean_beside_a_characteristic_value_is_remarked() {
        assert!(three([None; 3]).mixed().is_none() && compare([], Basis::Mean).mixed().is_none());
        let mut cases = [case(REFERENCE, None), case(REFERENCE, None)];
        let record = &mut std::sync::Arc::make_mut(&mut cases[1].mesh).laboratory;
        record.statistic = crate::mesh::Statistic::Characteristic;
        let said =
            |cases: [Case; 2]| all(["a", "b"].map(String::from).into_iter().zip(cases)).mixed();
        assert!(said(cases.clone()).unwrap().contains("mean and characteristic"));
        // The catalogue's record names three standards; one of them is enough, and none said is not another.
        for (standard, words) in
            [("iso 17746", None), ("", None), ("ASTM A975", Some("of different standards stand"))]
        {
            let record = &mut std::sync::Arc::make_mut(&mut cases[1].mesh).laboratory;
            record.statistic = crate::mesh::Statistic::Mean;
            record.standard = standard.into();
            let found = said(cases.clone());
            assert_eq!(found.is_some(), words.is_some(), "{standard}");
            assert!(words.is_none_or(|words| found.unwrap().contains(words)), "{found:?}");
        }
        let record = &mut std::sync::Arc::make_mut(&mut cases[1].mesh).laboratory;
        record.statistic = crate::mesh::Statistic::Minimum;
        assert!(said(cases).unwrap().contains("different kinds"));
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
