//! An input as it is typed, stepped and shown on a screen, in the unit that is shown there.

use super::input::Input;
use super::range::Range;
use crate::layout::Layout;
use crate::units::{self, Quantity, Units, significant};

/// A step of a value by an arrow key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepSize {
    /// The small step.
    Fine,
    /// The large step.
    Coarse,
}

/// Steps in a metre, a newton or a factor of 1 that a stepped value is rounded to: a tenth of a
/// millimetre. Without it 0.1 + 0.2 would show.
const STEP_GRAIN: f64 = 1.0e4;

impl Input {
    /// The sign of the unit in which it is shown.
    pub(crate) fn unit(self, shown: Units) -> &'static str {
        match self.row().quantity {
            Quantity::Length => shown.symbol(),
            Quantity::Force => shown.force_symbol(),
            // As kN/m2, in fewer columns.
            Quantity::Pressure => shown.pressure_symbol(),
            Quantity::Number => "",
        }
    }

    /// The step of an arrow key in SI.
    pub(crate) fn step(self, size: StepSize) -> f64 {
        let [fine, coarse] = self.row().steps;
        match size {
            StepSize::Fine => fine,
            StepSize::Coarse => coarse,
        }
    }

    /// What it may be in a layout, as text in the unit shown.
    pub(crate) fn allowed_in(self, layout: &Layout, shown: Units) -> String {
        let limits = self.row().range.limits(layout);
        let (min, max) = (self.entry_text(limits.min, shown), self.entry_text(limits.max, shown));
        let unit = self.unit(shown);
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        match self.row().range {
            Range::Spacing => {
                let larger = if layout.punch >= layout.plate { "D" } else { "d" };
                format!("above {larger} = {min}, below {max}{unit}")
            }
            Range::BelowSpacing => {
                let [x, y] = layout.sides();
                let spacing = layout.words()[usize::from(y < x)];
                format!("above 0, below {spacing} = {max}{unit}")
            }
            Range::UpTo(_) => format!("above 0, up to {max}{unit}"),
            Range::HalfSpacing(_) | Range::Between(..) => format!("{min} to {max}{unit}"),
        }
    }

    /// A value as it is entered and shown among the inputs, without its unit: as exact as it is.
    pub(crate) fn entry_text(self, value: f64, shown: Units) -> String {
        match self.row().quantity {
            Quantity::Length => units::length_entry(value, shown),
            Quantity::Force => units::force_entry(value, shown),
            Quantity::Pressure => units::pressure_entry(value, shown),
            Quantity::Number => units::shortest(value),
        }
    }

    /// Reads a typed value into SI and checks it. Empty text clears an input that can be cleared.
    ///
    /// # Errors
    /// What is wrong with the text, with the allowed range.
    pub(crate) fn read(
        self,
        text: &str,
        layout: &Layout,
        shown: Units,
    ) -> Result<Option<f64>, String> {
        if text.trim().is_empty() && self.clearable() {
            return Ok(None);
        }
        let value = units::parse_typed(text, self.row().quantity, shown)
            .map_err(|e| format!("{e}; allowed {}", self.allowed_in(layout, shown)))?;
        self.check(value, layout, shown)?;
        Ok(Some(value))
    }

    /// Checks a value in SI against what the layout allows.
    ///
    /// # Errors
    /// The allowed range, as a sentence.
    pub(crate) fn check(self, value: f64, layout: &Layout, shown: Units) -> Result<(), String> {
        if self.row().range.limits(layout).hold(value) {
            Ok(())
        } else {
            Err(format!("{} must be {}", self.word(), self.allowed_in(layout, shown)))
        }
    }

    /// A value one step on, rounded to [`STEP_GRAIN`].
    pub(crate) fn stepped(self, value: f64, layout: &Layout, size: StepSize, up: bool) -> f64 {
        let step = self.step(size);
        let rounded = on_grain(if up { value + step } else { value - step });
        match self.row().range {
            // Offsets stop at the cell's edge instead of refusing the last part of a step.
            Range::HalfSpacing(_) => {
                let limits = self.row().range.limits(layout);
                // A value outside (the spacing shrank) may still come back in.
                rounded.clamp(limits.min.min(value), limits.max.max(value))
            }
            _ => rounded,
        }
    }
}

/// A value of a study's input in the unit shown, without its sign: lengths at a tenth of a millimetre,
/// forces at four digits.
pub(crate) fn input_value(input: Input, value: f64, unit: Units) -> String {
    match input.row().quantity {
        Quantity::Force => return unit.force_number(value, 4),
        Quantity::Pressure => return significant(unit.pressure(value), 4),
        Quantity::Length | Quantity::Number => {}
    }
    let (decimals, least) = unit.study_decimals();
    // Never the negative zero.
    let mut text = format!("{:.decimals$}", value * unit.per_metre() + 0.0);
    for _ in least..decimals {
        if text.ends_with('0') {
            text.pop();
        }
    }
    text.trim_end_matches('.').to_string()
}

/// A value, SI, as a number in the unit shown, for the axis of a picture.
pub(crate) fn shown(input: Input, value: f64, unit: Units) -> f64 {
    match input.row().quantity {
        Quantity::Force => unit.force(value),
        Quantity::Pressure => unit.pressure(value),
        Quantity::Length => value * unit.per_metre(),
        Quantity::Number => value,
    }
}

/// The sign of the unit in which an input is shown.
pub(crate) fn input_unit(input: Input, unit: Units) -> &'static str {
    input.unit(unit)
}

/// A value rounded to what steps go by.
pub(crate) fn on_grain(value: f64) -> f64 {
    (value * STEP_GRAIN).round() / STEP_GRAIN
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    #[test]
    fn results_show_lengths_at_a_tenth_of_a_millimetre_and_forces_at_four_digits() {
        let m = |v| input_value(Input::Spacing, v, Units::METRES);
        assert_eq!(
            [m(2.0), m(1.125), m(-0.038_46), m(10.25)],
            ["2.00", "1.125", "-0.0385", "10.25"]
        );
        let mm = |v| input_value(Input::Spacing, v, Units::MILLIMETRES);
        assert_eq!([mm(2.0), mm(0.1125), mm(0.0)], ["2000", "112.5", "0"]);
        assert_eq!(input_value(Input::LabForce, 73_300.0, Units::METRES), "73.30");
    }

    /// The file takes a design force of exactly 10 000 kN; the screen takes it as well.
    #[test]
    fn the_largest_value_that_a_file_takes_is_taken_on_the_screen() {
        for (input, text) in [(Input::DesignForce, "10000"), (Input::AllowableDeflection, "10")] {
            let read = input.read(text, &REFERENCE, Units::METRES);
            assert_eq!(read.map(|v| v.and_then(|v| input.problem(v))), Ok(None), "{input:?}");
            assert!(input.read("10001", &REFERENCE, Units::METRES).is_err());
        }
    }

    /// Steps added as they are would leave what a tenth lacks in binary: 0.1 + 0.2 is not 0.3.
    #[test]
    fn steps_leave_no_noise_and_lead_back() {
        let mut value = 0.1;
        for _ in 0..10 {
            value = Input::OffsetX.stepped(value, &REFERENCE, StepSize::Fine, true);
        }
        assert_eq!(value, on_grain(value), "a tenth of a millimetre is the finest");
        for _ in 0..10 {
            value = Input::OffsetX.stepped(value, &REFERENCE, StepSize::Fine, false);
        }
        assert_eq!(value, 0.1);
    }
}
