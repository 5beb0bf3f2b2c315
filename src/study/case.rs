//! One layout with its mesh and its design question, the inputs that a study varies, and what a case
//! gives.
//!
//! Every study first makes its cases and then asks each for its forecast; whoever has another way to
//! answer a case (a simulation) takes the same cases in the same order.

use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, Question, answer};
use crate::forecast::field::Branch;
use crate::forecast::fingerprint::{of_inputs, of_question};
use crate::forecast::warning::{PLATE, PUNCH, PublishedRange, SPACING, Warning, Weight};
use crate::forecast::{Field, Forecast, Values, forecast, laboratory};
use crate::layout::{BranchRule, Layout};
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::study::result::make::expected_break;
use crate::units::{LengthUnit, shortest, significant, to_kn};
use std::sync::Arc;

/// One layout to study.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its geometry.
    pub layout: Layout,
    /// Its mesh.
    pub mesh: Arc<MeshType>,
    /// The branch of Eqs. A.1-A.2 that it takes.
    pub rule: BranchRule,
    /// What is asked of it.
    pub question: Question,
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
    /// The punch overlaps an anchor plate, which is outside the method.
    PunchOnPlate,
}

impl NoValue {
    /// Stable identifier for programs: `senseless` or, as the forecast's warning, `punch_on_plate`.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            NoValue::Senseless(_) => "senseless",
            NoValue::PunchOnPlate => "punch_on_plate",
        }
    }

    /// A word or two for a narrow column.
    pub(crate) fn short(&self) -> &'static str {
        match self {
            NoValue::Senseless(_) => "no sense",
            NoValue::PunchOnPlate => "on plate",
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
        let lab = Input::ALL.iter().filter(|i| i.is_laboratory());
        let problems: Vec<Problem> = lab.filter_map(|i| i.problem(i.value(self))).collect();
        if problems.is_empty() {
            forecast(&self.layout, &self.mesh, self.rule)
        } else {
            Err(problems)
        }
    }

    /// The case's values.
    ///
    /// # Errors
    /// Why there are none.
    pub fn outcome(&self) -> CaseValue {
        let forecast = self.forecast().map_err(NoValue::Senseless)?;
        let field = forecast.field.ok_or(NoValue::PunchOnPlate)?;
        let answer = answer(&field, &self.question);
        Ok(CasePoint { field, answer, warnings: forecast.warnings })
    }

    /// Deflection at which its check is expected to break until a run has told, m.
    pub(crate) fn expected_break(&self) -> f64 {
        expected_break(&self.layout, self.outcome().ok().map(|point| point.values()))
    }

    /// The same case with another value of one input.
    pub fn with(&self, input: Input, value: f64) -> Case {
        let mut case = self.clone();
        input.set(&mut case, value);
        case
    }

    /// The fingerprint of its forecast's inputs; what is asked of the forecast is none of them.
    pub(crate) fn fingerprint(&self) -> Fingerprint {
        of_inputs(&self.layout, &self.mesh, self.rule)
    }

    /// The fingerprint of its forecast's inputs and of what is asked of it.
    pub(crate) fn question_fingerprint(&self) -> Fingerprint {
        of_question(self.fingerprint(), &self.question)
    }
}

impl CasePoint {
    /// F_a and delta_a.
    pub(crate) fn values(&self) -> Values {
        self.field.values
    }

    /// Utilisation, where a design force is set.
    pub fn utilisation(&self) -> Option<f64> {
        self.answer.at_force.map(|at| at.utilisation)
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

/// One of the seven inputs that a study varies. All are lengths in metres but the laboratory force,
/// which is in newtons.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Input {
    /// Side of the anchor plate, d.
    Plate,
    /// Anchor spacing, L. The offsets stay as they are in metres.
    Spacing,
    /// Diameter of the punch, D.
    Punch,
    /// Offset across the twists, e_x.
    OffsetX,
    /// Offset along the twists, e_y.
    OffsetY,
    /// Force of the standard laboratory test, F_l*.
    LabForce,
    /// Deflection of the standard laboratory test, delta_l*.
    LabDeflection,
}

/// Largest laboratory force that makes sense, N, as for mesh types.
const LARGEST_LAB_FORCE: f64 = 1.0e7;
/// Largest laboratory deflection that makes sense, m, as for mesh types.
const LARGEST_LAB_DEFLECTION: f64 = 10.0;

impl Input {
    /// All of them, in the order of definitions and tables.
    pub const ALL: [Input; 7] = [
        Input::Plate,
        Input::Spacing,
        Input::Punch,
        Input::OffsetX,
        Input::OffsetY,
        Input::LabForce,
        Input::LabDeflection,
    ];

    /// The word for commands and narrow tables: `d`, `L`, `D`, `ex`, `ey`, `Fl`, `dl`.
    pub fn word(self) -> &'static str {
        match self {
            Input::Plate => "d",
            Input::Spacing => "L",
            Input::Punch => "D",
            Input::OffsetX => "ex",
            Input::OffsetY => "ey",
            Input::LabForce => "Fl",
            Input::LabDeflection => "dl",
        }
    }

    /// The paper's symbol: `F_l*` for the laboratory force.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Input::LabForce => "F_l*",
            Input::LabDeflection => "delta_l*",
            other => other.word(),
        }
    }

    /// The name in JSON and CSV, with its unit: `L_m`, `F_l_kN`.
    pub(crate) fn column(self) -> &'static str {
        match self {
            Input::Plate => "d_m",
            Input::Spacing => "L_m",
            Input::Punch => "D_m",
            Input::OffsetX => "ex_m",
            Input::OffsetY => "ey_m",
            Input::LabForce => "F_l_kN",
            Input::LabDeflection => "delta_l_m",
        }
    }

    /// Whether it is a force; all others are lengths.
    pub(crate) fn is_force(self) -> bool {
        self == Input::LabForce
    }

    /// Whether it belongs to the mesh's laboratory test and not to the layout.
    pub(crate) fn is_laboratory(self) -> bool {
        matches!(self, Input::LabForce | Input::LabDeflection)
    }

    /// Whether it is an offset of the punch.
    pub(crate) fn is_offset(self) -> bool {
        matches!(self, Input::OffsetX | Input::OffsetY)
    }

    /// The range in which the paper's relations were made, where it gives one.
    pub(crate) fn published_range(self) -> Option<PublishedRange> {
        match self {
            Input::Plate => Some(PLATE),
            Input::Spacing => Some(SPACING),
            Input::Punch => Some(PUNCH),
            _ => None,
        }
    }

    /// Its value in a case, SI. The laboratory values are the standard ones, F_l* and delta_l*.
    pub(crate) fn value(self, case: &Case) -> f64 {
        match self {
            Input::Plate => case.layout.plate,
            Input::Spacing => case.layout.spacing,
            Input::Punch => case.layout.punch,
            Input::OffsetX => case.layout.ex,
            Input::OffsetY => case.layout.ey,
            Input::LabForce => standard(&case.mesh).force,
            Input::LabDeflection => standard(&case.mesh).deflection,
        }
    }

    /// Sets it in a case, SI. A laboratory value is set as the standard one; the mesh's record keeps
    /// its panel and is made to give that value.
    pub(crate) fn set(self, case: &mut Case, value: f64) {
        match self {
            Input::Plate => case.layout.plate = value,
            Input::Spacing => case.layout.spacing = value,
            Input::Punch => case.layout.punch = value,
            Input::OffsetX => case.layout.ex = value,
            Input::OffsetY => case.layout.ey = value,
            Input::LabForce | Input::LabDeflection => {
                // Copies the mesh only when somebody else has it too.
                let record = &mut Arc::make_mut(&mut case.mesh).laboratory;
                let converted = record.panel != crate::mesh::STANDARD_PANEL;
                let factor =
                    |ratio: fn(f64) -> f64| if converted { ratio(record.panel) } else { 1.0 };
                if self == Input::LabForce {
                    record.force = value * factor(laboratory::force_ratio);
                } else {
                    record.deflection = value * factor(laboratory::deflection_ratio);
                }
            }
        }
    }

    /// What is wrong with a value of this input whatever the others are; the field is its word.
    pub(crate) fn problem(self, value: f64) -> Option<Problem> {
        use crate::layout::LARGEST_LENGTH;
        let (good, allowed) = match self {
            Input::Plate | Input::Spacing | Input::Punch => {
                (value > 0.0 && value < LARGEST_LENGTH, "above 0, below 100 m")
            }
            Input::OffsetX | Input::OffsetY => {
                (value.abs() < LARGEST_LENGTH, "-100 m to 100 m; -L/2 to L/2 is the whole cell")
            }
            Input::LabForce => {
                (value > 0.0 && value <= LARGEST_LAB_FORCE, "above 0, up to 10000 kN")
            }
            Input::LabDeflection => {
                (value > 0.0 && value <= LARGEST_LAB_DEFLECTION, "above 0, up to 10 m")
            }
        };
        // What is not a number is in no range.
        (!good).then(|| {
            Problem::new(self.word(), "the value is outside what makes sense")
                .value(self.text(value))
                .allowed(allowed)
        })
    }

    /// A value as a person writes it, with its unit: `2.5 m`, `73.3 kN`.
    pub(crate) fn text(self, value: f64) -> String {
        if !value.is_finite() {
            value.to_string()
        } else if self.is_force() {
            format!("{} kN", shortest(to_kn(value)))
        } else {
            format!("{} m", shortest(value))
        }
    }
}

/// A value of a study's input in the unit shown, without its sign: lengths at a tenth of a millimetre,
/// forces at four digits.
pub(crate) fn input_value(input: Input, value: f64, unit: LengthUnit) -> String {
    if input.is_force() {
        return significant(to_kn(value), 4);
    }
    let (decimals, least) = match unit {
        LengthUnit::Metre => (4, 2),
        LengthUnit::Millimetre => (1, 0),
    };
    // Never the negative zero.
    let mut text = format!("{:.decimals$}", value * unit.per_metre() + 0.0);
    for _ in least..decimals {
        if text.ends_with('0') {
            text.pop();
        }
    }
    text.trim_end_matches('.').to_string()
}

/// The sign of the unit in which an input is shown.
pub(crate) fn input_unit(input: Input, unit: LengthUnit) -> &'static str {
    if input.is_force() { "kN" } else { unit.symbol() }
}

/// The standard laboratory values of a mesh; where its record cannot be converted, and so has no
/// forecast, those of the record.
fn standard(mesh: &MeshType) -> Values {
    let record = &mesh.laboratory;
    laboratory::standard_values(record)
        .unwrap_or(Values { force: record.force, deflection: record.deflection })
}

/// For tests: the reference mesh in a layout, with a design force (N).
#[cfg(test)]
pub(super) fn example(layout: Layout, force: Option<f64>) -> Case {
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

    #[test]
    fn every_input_is_set_and_read_back() {
        let base = case(REFERENCE, None);
        for input in Input::ALL {
            let changed = base.with(input, 0.5);
            assert_eq!(input.value(&changed), 0.5, "{input:?}");
            for other in Input::ALL.into_iter().filter(|o| *o != input) {
                assert_eq!(other.value(&changed), other.value(&base), "{input:?} moves {other:?}");
            }
            assert_ne!(changed.fingerprint(), base.fingerprint());
        }
    }

    #[test]
    fn a_laboratory_value_is_the_standard_one_whatever_the_panel() {
        let mut base = case(REFERENCE, None);
        Arc::make_mut(&mut base.mesh).laboratory.panel = 4.5;
        let set = base.with(Input::LabForce, 70_000.0).with(Input::LabDeflection, 0.5);
        // By hand, Eqs. 1-2 at 4.5 m: factors 1.055 and 1.425.
        assert!((set.mesh.laboratory.force - 73_850.0).abs() < 1e-6);
        assert!((set.mesh.laboratory.deflection - 0.7125).abs() < 1e-12);
        let f = set.forecast().unwrap();
        assert!((f.laboratory.force - 70_000.0).abs() < 1e-6);
        assert!((f.laboratory.deflection - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_case_without_values_says_why() {
        let on_plate = case(Layout { ex: 1.5, ey: 1.5, ..REFERENCE }, None);
        assert_eq!(on_plate.outcome(), Err(NoValue::PunchOnPlate));
        let code = |case: Case| case.outcome().unwrap_err().code();
        assert_eq!(code(case(Layout { punch: 3.0, ..REFERENCE }, None)), "senseless");
        let base = case(REFERENCE, None);
        assert_eq!(code(base.with(Input::LabForce, 1.1e7)), "senseless");
        assert_eq!(code(base.with(Input::LabDeflection, 0.0)), "senseless");
        assert!(Input::Spacing.problem(f64::NAN).is_some());
        assert!(Input::OffsetX.problem(-2.0).is_none());
    }
}
