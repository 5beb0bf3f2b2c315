//! The case: a layout with its mesh, its branch rule and its design question, which the command line,
//! the screens, the studies and the exports share, and what follows from it.
//!
//! - [`input`]: what a case is made of, each input defined once; [`range`]: what an input may be;
//!   [`entry`]: an input typed, stepped and shown.
//! - [`Derived`]: its forecast and the answer to its question; [`CasePoint`]: the same for a study,
//!   which goes through thousands; [`NoValue`]: why there is none.

pub(crate) mod entry;
pub(crate) mod input;
mod range;
mod table;

pub use crate::forecast::design::Question;
pub(crate) use entry::{StepSize, input_unit, input_value, shown};
pub use input::Input;

use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, answer};
use crate::forecast::field::Branch;
use crate::forecast::fingerprint::{of_inputs, of_question};
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Forecast, NoField, Strength, forecast, laboratory};
use crate::layout::{BranchRule, Layout};
use crate::mesh::MeshType;
use crate::problem::{Problem, summary};
use crate::remark::Weight;
use std::sync::Arc;

/// One layout with all that its forecast and its check depend on.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its geometry.
    pub layout: Layout,
    /// Net, laboratory record and wires.
    pub mesh: Arc<MeshType>,
    /// The branch of Eqs. A.1-A.2 that it takes.
    pub rule: BranchRule,
    /// What is asked of it.
    pub question: Question,
}

/// What follows from a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Derived {
    /// By the published equations, or by the method that the layout names.
    pub forecast: Forecast,
    /// The answer to its question; missing where the forecast has no field value.
    pub answer: Option<Answer>,
}

/// What a case gives.
#[derive(Debug, Clone, PartialEq)]
pub struct CasePoint {
    /// The forecast of the panel; its values are F_a and delta_a.
    pub field: Field,
    /// Answer to the case's design question.
    pub answer: Answer,
    /// What to distrust.
    pub warnings: Vec<Warning>,
}

/// Why a case gives nothing.
#[derive(Debug, Clone, PartialEq)]
pub enum NoValue {
    /// Its sizes make no sense, as a spacing below the punch's diameter.
    Senseless(Vec<Problem>),
    /// It makes sense, and the method has no value for it.
    Outside(NoField),
}

impl NoValue {
    /// Stable identifier for programs: `senseless` or that of the forecast's warning.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            NoValue::Senseless(_) => "senseless",
            NoValue::Outside(why) => why.code(),
        }
    }

    /// A word or two for a narrow column.
    pub(crate) fn short(&self) -> &'static str {
        match self {
            NoValue::Senseless(_) => "no sense",
            NoValue::Outside(why) => why.short(),
        }
    }

    /// That there is no value, and why.
    pub(crate) fn sentence(&self) -> String {
        match self {
            NoValue::Senseless(problems) => format!("no value: {}", summary(problems)),
            NoValue::Outside(why) => why.sentence().into(),
        }
    }
}

/// A case's values, or why there are none.
pub(crate) type CaseValue = Result<CasePoint, NoValue>;

impl Case {
    /// The forecast of the case.
    ///
    /// # Errors
    /// Every input that makes no sense.
    pub(crate) fn forecast(&self) -> Result<Forecast, Vec<Problem>> {
        let lab = [Input::LabForce, Input::LabDeflection];
        let problems: Vec<Problem> =
            lab.into_iter().filter_map(|i| i.problem(self.get(i)?)).collect();
        if problems.is_empty() {
            forecast(&self.layout, &self.mesh, self.rule)
        } else {
            Err(problems)
        }
    }

    /// Its forecast and the answer to its question.
    ///
    /// # Errors
    /// Every input that makes no sense.
    pub fn derive(&self) -> Result<Derived, Vec<Problem>> {
        let forecast = self.forecast()?;
        let answer = forecast.field.ok().map(|field| answer(&field, &self.asked()));
        Ok(Derived { forecast, answer })
    }

    /// What is asked of it, with the load as a force on the panel.
    pub(crate) fn asked(&self) -> Question {
        self.question.on(&self.layout)
    }

    /// The case's values.
    ///
    /// # Errors
    /// Why there are none.
    pub fn outcome(&self) -> CaseValue {
        let forecast = self.forecast().map_err(NoValue::Senseless)?;
        let field = forecast.field.map_err(NoValue::Outside)?;
        Ok(CasePoint { field, answer: answer(&field, &self.asked()), warnings: forecast.warnings })
    }

    /// Deflection at which its check is expected to break until a run has told, m.
    pub(crate) fn expected_break(&self) -> f64 {
        expected_break(&self.layout, self.outcome().ok().map(|point| point.values()))
    }

    /// The same case with another value of one input.
    pub fn with(&self, input: Input, value: f64) -> Case {
        let mut case = self.clone();
        case.set(input, value);
        case
    }

    /// An input's value, SI; missing where it is not set. The laboratory values are the standard
    /// ones, F_l* and delta_l*.
    pub(crate) fn get(&self, input: Input) -> Option<f64> {
        match input {
            Input::LabForce => Some(standard(&self.mesh).force),
            Input::LabDeflection => standard(&self.mesh).deflection,
            _ => input.of(&self.layout, &self.question),
        }
    }

    /// Sets an input, SI. A laboratory value is set as the standard one; the mesh's record keeps its
    /// panel and is made to give that value.
    pub(crate) fn set(&mut self, input: Input, value: f64) {
        if !input.is_laboratory() {
            return input.put(&mut self.layout, &mut self.question, Some(value));
        }
        // Copies the mesh only when somebody else has it too.
        let record = &mut Arc::make_mut(&mut self.mesh).laboratory;
        let converted = record.panel != crate::mesh::STANDARD_PANEL;
        let factor = |ratio: fn(f64) -> f64| if converted { ratio(record.panel) } else { 1.0 };
        if input == Input::LabForce {
            record.force = value * factor(laboratory::force_ratio);
        } else {
            record.deflection = Some(value * factor(laboratory::deflection_ratio));
        }
    }

    /// The fingerprint of its forecast's inputs; what is asked of the forecast is none of them.
    pub fn fingerprint(&self) -> Fingerprint {
        of_inputs(&self.layout, &self.mesh, self.rule)
    }

    /// The fingerprint of its forecast's inputs and of what is asked of it.
    pub(crate) fn question_fingerprint(&self) -> Fingerprint {
        of_question(self.fingerprint(), &self.question)
    }
}

impl Input {
    /// Its value in a case, SI, of an input that is always set, as all that studies vary are; of
    /// another that is not set NaN, which is in no range.
    pub(crate) fn value(self, case: &Case) -> f64 {
        case.get(self).unwrap_or(f64::NAN)
    }
}

/// Deflection at which a layout is expected to break until a run has told, m: its forecast's, or a fifth
/// of the spacing where there is none.
pub(crate) fn expected_break(layout: &Layout, forecast: Option<Strength>) -> f64 {
    forecast.and_then(|values| values.deflection).unwrap_or(0.2 * layout.least())
}

impl CasePoint {
    /// F_a and delta_a.
    pub(crate) fn values(&self) -> Strength {
        self.field.values
    }

    /// Utilisation, where a design force is set.
    pub fn utilisation(&self) -> Option<f64> {
        self.answer.at_force.map(|at| at.utilisation)
    }

    /// Deflection at the design force without its factor, m, where one is set and reached.
    pub(crate) fn service_deflection(&self) -> Option<f64> {
        self.answer.at_force?.service_deflection
    }

    /// The branch of Eqs. A.1-A.2 that was used.
    pub(crate) fn branch(&self) -> Branch {
        self.field.branch
    }

    /// Whether there is something to know that weighs more than a note.
    pub(crate) fn doubtful(&self) -> bool {
        self.warnings.iter().any(|w| w.weight() >= Weight::Caution)
    }
}

/// The standard laboratory values of a mesh; where its record cannot be converted, and so has no
/// forecast, those of the record.
fn standard(mesh: &MeshType) -> Strength {
    let record = &mesh.laboratory;
    laboratory::standard_values(record)
        .unwrap_or(Strength { force: record.force, deflection: record.deflection })
}

/// For tests: the reference mesh in a layout, with a design force (N).
#[cfg(test)]
pub(crate) fn example(layout: Layout, force: Option<f64>) -> Case {
    Case {
        layout,
        mesh: crate::mesh::catalogue::reference(),
        rule: BranchRule::Published,
        question: Question { force, ..Question::default() },
    }
}

#[cfg(test)]
mod tests {
    use super::example as case;
    use super::*;
    use crate::layout::REFERENCE;
    use crate::words::Choice;

    #[test]
    fn every_input_is_set_and_read_back() {
        let base = case(REFERENCE, None);
        for input in Input::ALL.iter().copied() {
            let changed = base.with(input, 0.5);
            assert_eq!(changed.get(input), Some(0.5), "{input:?}");
            for other in Input::ALL.iter().copied().filter(|o| *o != input) {
                assert_eq!(changed.get(other), base.get(other), "{input:?} moves {other:?}");
            }
            assert_ne!(changed.question_fingerprint(), base.question_fingerprint());
        }
    }

    #[test]
    fn a_laboratory_value_is_the_standard_one_whatever_the_panel() {
        let mut base = case(REFERENCE, None);
        Arc::make_mut(&mut base.mesh).laboratory.panel = 4.5;
        let set = base.with(Input::LabForce, 70_000.0).with(Input::LabDeflection, 0.5);
        // By hand, Eqs. 1-2 at 4.5 m: factors 1.055 and 1.425.
        assert!((set.mesh.laboratory.force - 73_850.0).abs() < 1e-6);
        assert!((set.mesh.laboratory.deflection.unwrap() - 0.7125).abs() < 1e-12);
        let f = set.forecast().unwrap();
        assert!((f.laboratory.force - 70_000.0).abs() < 1e-6);
        assert!((f.laboratory.deflection.unwrap() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_case_without_values_says_why() {
        let on_plate = case(Layout { ex: 1.5, ey: 1.5, ..REFERENCE }, None);
        assert_eq!(on_plate.outcome(), Err(NoValue::Outside(NoField::PunchOnPlate)));
        let code = |case: Case| case.outcome().unwrap_err().code();
        assert_eq!(code(case(Layout { punch: 3.0, ..REFERENCE }, None)), "senseless");
        let base = case(REFERENCE, None);
        assert_eq!(code(base.with(Input::LabForce, 1.1e7)), "senseless");
        assert_eq!(code(base.with(Input::LabDeflection, 0.0)), "senseless");
        assert!(Input::Spacing.problem(f64::NAN).is_some());
        assert!(Input::OffsetX.problem(-2.0).is_none());
    }
}
