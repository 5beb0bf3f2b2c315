//! The table of layouts with all that follows from them, as it is exported and copied.

use super::columns::{
    self, CheckRow, OVER_LAB, PointRow, RATIOS, STIFFNESS, check_fidelity, check_mean, check_runs,
    point,
};
use super::table::Table;
use super::value::{NamedColumn, Value, kn};
use super::verdict;
use crate::VERSION;
use crate::case::{Case, Derived, Input, Question};
use crate::forecast::design::Answer;
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Forecast};
use crate::layout::Layout;
use crate::study::checks::figures::Figures;
use crate::study::result::CheckResult;
use crate::study::verdict::Verdict;
use crate::units::{to_kj, to_kn};
use crate::words::Choice;

/// A layout with what follows from it.
pub(crate) struct LayoutRow<'a> {
    pub(crate) name: &'a str,
    /// Identifier of its mesh.
    pub(crate) mesh: &'a str,
    /// Its geometry.
    pub(crate) layout: &'a Layout,
    /// What is asked of it.
    pub(crate) question: &'a Question,
    /// The same as a case, where its mesh is known.
    pub(crate) case: Option<&'a Case>,
    /// What follows from it, where its inputs are sound.
    pub(crate) derived: Option<&'a Derived>,
    /// Whether it is enough, where anything is asked.
    pub(crate) verdict: Option<&'a Verdict>,
    /// The check that is kept, and whether it is stale.
    pub(crate) check: Option<(&'a CheckResult, bool)>,
}

/// The parts of a layout that its columns read.
pub(crate) struct LayoutParts<'a> {
    row: LayoutRow<'a>,
    forecast: Option<&'a Forecast>,
    field: Option<Field>,
    answer: Option<Answer>,
    point: PointRow<'a>,
    check: Option<CheckRow<'a>>,
}

impl<'a> From<LayoutRow<'a>> for LayoutParts<'a> {
    fn from(row: LayoutRow<'a>) -> LayoutParts<'a> {
        let forecast = row.derived.map(|derived| &derived.forecast);
        let field = forecast.and_then(|f| f.field.ok());
        let answer = row.derived.and_then(|d| d.answer).filter(|_| row.question.asks());
        let values = field.map(|field| field.values);
        let warnings: &[Warning] = forecast.map_or(&[], |f| &f.warnings);
        let point = PointRow { values, answer, missing: None, warnings };
        let check = row.check.map(|(result, _)| CheckRow {
            result: Some(result),
            missing: None,
            figures: Some(Figures::of(result, values, row.question)),
        });
        LayoutParts { row, forecast, field, answer, point, check }
    }
}

/// What the forecast is made of.
const FORECAST: [NamedColumn<Forecast>; 11] = [
    ("branch", |f| f.rule.word().into()),
    ("F_l_kN", |f| kn(f.laboratory.force)),
    ("delta_l_m", |f| f.laboratory.deflection.into()),
    RATIOS[0],
    RATIOS[1],
    ("F_reference_kN", |f| kn(f.reference.force)),
    ("delta_reference_m", |f| f.reference.deflection.into()),
    ("eccentricity_F", |f| f.eccentricity.force.into()),
    ("eccentricity_F_sd", |f| f.eccentricity.force_sd.into()),
    ("eccentricity_delta", |f| f.eccentricity.deflection.into()),
    ("eccentricity_delta_sd", |f| f.eccentricity.deflection_sd.into()),
];

/// How the field values are found.
const RELATION: [NamedColumn<Field>; 2] =
    [("regime", |f| f.regime.word().into()), ("relation", |f| f.branch.word().into())];

/// The field values of the other branch.
const OTHER: [NamedColumn<Field>; 2] = [
    ("other_branch_F_kN", |f| f.other_branch.map(|v| to_kn(v.force)).into()),
    ("other_branch_delta_m", |f| f.other_branch.map(|v| v.deflection).into()),
];

/// The answer to the design force.
const LOAD: [NamedColumn<Answer>; 1] =
    [("load_kN", |a| a.at_force.map(|at| to_kn(at.load)).into())];
const MARGIN: [NamedColumn<Answer>; 1] =
    [("margin_kN", |a| a.at_force.map(|at| to_kn(at.margin)).into())];

/// The answer to the allowable deflection.
const ALLOWABLE: [NamedColumn<Answer>; 3] = [
    ("allowable_F_kN", |a| a.at_deflection.map(|at| to_kn(at.force)).into()),
    ("allowable_design_F_kN", |a| a.at_deflection.map(|at| to_kn(at.design_force)).into()),
    ("allowable_energy_kJ", |a| a.at_deflection.map(|at| to_kj(at.energy)).into()),
];

/// All columns. What does not apply is left empty.
pub(crate) fn table<'a>() -> Table<'a, LayoutParts<'a>> {
    let [force, deflection, utilisation, at_load, service, _, warnings] = point();
    let [check_force, check_deflection, _] = check_mean();
    let with_inputs = |table: Table<'a, LayoutParts<'a>>, inputs: &[Input]| {
        inputs.iter().fold(table, |table, input| {
            let input = *input;
            let value = move |l: &LayoutParts| input.of(l.row.layout, l.row.question);
            table.with(input.column(), move |l| value(l).map(|v| columns::input(input, v)).into())
        })
    };
    let table = Table::<LayoutParts>::new()
        .with("layout", |l| l.row.name.to_string().into())
        .with("mesh", |l| l.row.mesh.to_string().into());
    let table = with_inputs(table, &Input::GEOMETRY)
        .with("stagger", |l| l.row.layout.grid.stagger.into())
        .with("twists", |l| l.row.layout.grid.twists.word().into())
        .part(FORECAST, |l| l.forecast)
        .part(RELATION, |l| l.field.as_ref())
        .part([force, deflection], |l| Some(&l.point))
        .part(OTHER, |l| l.field.as_ref())
        .part(OVER_LAB, |l| l.forecast)
        .part(STIFFNESS, |l| l.field.as_ref());
    let table = with_inputs(table, &[Input::GammaResistance, Input::GammaLoad])
        .with("resistance_kN", |l| l.answer.map(|a| to_kn(a.resistance)).into());
    let table = with_inputs(table, &[Input::DesignForce])
        .part(LOAD, |l| l.answer.as_ref())
        .part([utilisation], |l| Some(&l.point))
        .part(MARGIN, |l| l.answer.as_ref())
        .part([at_load, service], |l| Some(&l.point));
    let table = with_inputs(table, &[Input::Pressure, Input::AnchorResistance])
        .part(verdict::COLUMNS, |l| l.row.verdict);
    with_inputs(table, &[Input::AllowableDeflection])
        .part(ALLOWABLE, |l| l.answer.as_ref())
        .part([check_force], |l| l.check.as_ref())
        .with("check_F_sd_kN", |l| broke(l).map(|v| to_kn(v.force.deviation)).into())
        .part([check_deflection], |l| l.check.as_ref())
        .with("check_delta_sd_m", |l| broke(l).map(|v| v.deflection.deviation).into())
        .part([check_runs(), check_fidelity()], |l| l.check.as_ref())
        .with("check_stale", |l| l.row.check.map(|check| check.1).into())
        .part([warnings], |l| Some(&l.point))
        .with("fingerprint", |l| l.row.case.map(|case| case.fingerprint().to_string()).into())
        .with("version", |_| Value::from(VERSION))
}

/// The kept check, if a wire broke in it.
fn broke<'a>(l: &LayoutParts<'a>) -> Option<&'a CheckResult> {
    l.row.check.map(|check| check.0).filter(|v| v.broke())
}
