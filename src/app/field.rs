//! The inputs of a layout that the screen edits: what each is called, how it steps, what it may be.

use crate::forecast::warning::{self, PublishedRange};
use crate::layout::LARGEST_LENGTH;
use crate::project::schema::{FACTOR_RANGE, LARGEST_DEFLECTION, LARGEST_DESIGN_FORCE, NamedLayout};
use crate::units::{self, LengthUnit, Quantity};

/// One input of a layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// Plate side d.
    Plate,
    /// Anchor spacing L.
    Spacing,
    /// Punch diameter D.
    Punch,
    /// Offset of the punch across the twists, ex.
    Ex,
    /// Offset of the punch along the twists, ey.
    Ey,
    /// Design force.
    DesignForce,
    /// Allowable deflection.
    AllowableDeflection,
    /// Partial factor on the load.
    GammaLoad,
    /// Partial factor on the resistance.
    GammaResistance,
}

/// A step of a value by an arrow key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepSize {
    /// The small step.
    Fine,
    /// The large step.
    Coarse,
}

/// Offset of the text under a length: nothing below a tenth of a millimetre is kept from stepping.
const STEP_GRAIN: f64 = 1.0e4;

impl Field {
    /// All inputs, in the order of the screen.
    pub(crate) const ALL: [Field; 9] = [
        Field::Plate,
        Field::Spacing,
        Field::Punch,
        Field::Ex,
        Field::Ey,
        Field::DesignForce,
        Field::AllowableDeflection,
        Field::GammaLoad,
        Field::GammaResistance,
    ];

    /// The symbol beside the words; the paper's where it has one.
    pub fn symbol(self) -> &'static str {
        match self {
            Field::Plate => "d",
            Field::Spacing => "L",
            Field::Punch => "D",
            Field::Ex => "ex",
            Field::Ey => "ey",
            Field::DesignForce => "Fd",
            Field::AllowableDeflection => "dm",
            Field::GammaLoad => "gL",
            Field::GammaResistance => "gR",
        }
    }

    /// The input in a word or two.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Field::Plate => "plate",
            Field::Spacing => "spacing",
            Field::Punch => "punch",
            Field::Ex => "offset x",
            Field::Ey => "offset y",
            Field::DesignForce => "design",
            Field::AllowableDeflection => "allowed",
            Field::GammaLoad => "load fac",
            Field::GammaResistance => "res. fac",
        }
    }

    /// The input in a whole phrase, for help and messages.
    pub(crate) fn phrase(self) -> &'static str {
        match self {
            Field::Plate => "side of the square anchor plate",
            Field::Spacing => "anchor spacing, square grid only",
            Field::Punch => "diameter of the punching block",
            Field::Ex => "offset of the block across the twists",
            Field::Ey => "offset of the block along the twists",
            Field::DesignForce => "design force on the panel",
            Field::AllowableDeflection => "allowable deflection",
            Field::GammaLoad => "partial factor on the load",
            Field::GammaResistance => "partial factor on the resistance",
        }
    }

    /// What it measures.
    pub(crate) fn quantity(self) -> Quantity {
        match self {
            Field::DesignForce => Quantity::Force,
            Field::GammaLoad | Field::GammaResistance => Quantity::Number,
            _ => Quantity::Length,
        }
    }

    /// The unit's sign on the screen.
    pub(crate) fn unit(self, lengths: LengthUnit) -> &'static str {
        match self.quantity() {
            Quantity::Length => lengths.symbol(),
            Quantity::Force => "kN",
            Quantity::Number => "",
        }
    }

    /// The value in SI; missing for an optional input that is not set.
    pub(crate) fn get(self, layout: &NamedLayout) -> Option<f64> {
        match self {
            Field::Plate => Some(layout.plate),
            Field::Spacing => Some(layout.spacing),
            Field::Punch => Some(layout.punch),
            Field::Ex => Some(layout.ex),
            Field::Ey => Some(layout.ey),
            Field::DesignForce => layout.design_force,
            Field::AllowableDeflection => layout.allowable_deflection,
            Field::GammaLoad => Some(layout.gamma_load),
            Field::GammaResistance => Some(layout.gamma_resistance),
        }
    }

    /// Sets the value in SI, unchecked; `None` clears an optional input and puts an offset or a
    /// factor back to its default. A size cannot be cleared and stays.
    pub(crate) fn set(self, layout: &mut NamedLayout, value: Option<f64>) {
        match (self, value) {
            (Field::Plate, Some(v)) => layout.plate = v,
            (Field::Spacing, Some(v)) => layout.spacing = v,
            (Field::Punch, Some(v)) => layout.punch = v,
            (Field::Plate | Field::Spacing | Field::Punch, None) => {}
            (Field::Ex, v) => layout.ex = v.unwrap_or(0.0),
            (Field::Ey, v) => layout.ey = v.unwrap_or(0.0),
            (Field::DesignForce, v) => layout.design_force = v,
            (Field::AllowableDeflection, v) => layout.allowable_deflection = v,
            (Field::GammaLoad, v) => layout.gamma_load = v.unwrap_or(1.0),
            (Field::GammaResistance, v) => layout.gamma_resistance = v.unwrap_or(1.0),
        }
    }

    /// Whether Delete does something: optional inputs, offsets and factors.
    pub(crate) fn clearable(self) -> bool {
        !matches!(self, Field::Plate | Field::Spacing | Field::Punch)
    }

    /// The published range, for the inputs that have one.
    pub(crate) fn published(self) -> Option<PublishedRange> {
        match self {
            Field::Plate => Some(warning::PLATE),
            Field::Spacing => Some(warning::SPACING),
            Field::Punch => Some(warning::PUNCH),
            _ => None,
        }
    }

    /// The step of an arrow key in SI.
    pub(crate) fn step(self, size: StepSize) -> f64 {
        let (fine, coarse) = match self {
            Field::Plate => (0.01, 0.05),
            Field::Spacing => (0.05, 0.50),
            Field::Punch => (0.05, 0.25),
            Field::Ex | Field::Ey => (0.05, 0.25),
            Field::DesignForce => (units::from_kn(1.0), units::from_kn(10.0)),
            Field::AllowableDeflection => (0.01, 0.10),
            Field::GammaLoad | Field::GammaResistance => (0.05, 0.25),
        };
        match size {
            StepSize::Fine => fine,
            StepSize::Coarse => coarse,
        }
    }

    /// What the value may be in this layout: lower limit, upper limit, and whether the limits
    /// themselves belong to it.
    fn limits(self, layout: &NamedLayout) -> (f64, f64, bool) {
        match self {
            Field::Plate | Field::Punch => (0.0, layout.spacing, false),
            Field::Spacing => (layout.plate.max(layout.punch), LARGEST_LENGTH, false),
            Field::Ex | Field::Ey => (-layout.spacing / 2.0, layout.spacing / 2.0, true),
            Field::DesignForce => (0.0, LARGEST_DESIGN_FORCE, false),
            Field::AllowableDeflection => (0.0, LARGEST_DEFLECTION, false),
            Field::GammaLoad | Field::GammaResistance => (FACTOR_RANGE.0, FACTOR_RANGE.1, true),
        }
    }

    /// The allowed range as text, in the unit of the screen.
    pub(crate) fn allowed(self, layout: &NamedLayout, lengths: LengthUnit) -> String {
        let (min, max, closed) = self.limits(layout);
        let text = |v: f64| self.entry_text(v, lengths);
        let unit = self.unit(lengths);
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        match self {
            Field::Spacing => {
                let larger = if layout.punch >= layout.plate { "D" } else { "d" };
                format!("above {larger} = {}, below {}{unit}", text(min), text(max))
            }
            Field::Plate | Field::Punch => format!("above 0, below L = {}{unit}", text(max)),
            _ if closed => format!("{} to {}{unit}", text(min), text(max)),
            _ => format!("above 0, to {}{unit}", text(max)),
        }
    }

    /// The value as it is entered and shown among the inputs, without its unit.
    pub(crate) fn entry_text(self, value: f64, lengths: LengthUnit) -> String {
        match self.quantity() {
            Quantity::Length => units::length_entry(value, lengths),
            Quantity::Force => trim(&units::shortest(units::to_kn(value))),
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
        layout: &NamedLayout,
        lengths: LengthUnit,
    ) -> Result<Option<f64>, String> {
        if text.trim().is_empty() && self.clearable() {
            return Ok(None);
        }
        let allowed = || self.allowed(layout, lengths);
        let value = units::parse(text, self.quantity(), lengths)
            .map_err(|e| format!("{e}; allowed {}", allowed()))?;
        self.check(value, layout, lengths)?;
        Ok(Some(value))
    }

    /// Checks a value in SI against what the layout allows.
    ///
    /// # Errors
    /// The allowed range, as a sentence.
    pub(crate) fn check(
        self,
        value: f64,
        layout: &NamedLayout,
        lengths: LengthUnit,
    ) -> Result<(), String> {
        let (min, max, closed) = self.limits(layout);
        let inside = if closed { value >= min && value <= max } else { value > min && value < max };
        if inside {
            Ok(())
        } else {
            Err(format!("{} must be {}", self.symbol(), self.allowed(layout, lengths)))
        }
    }

    /// The value after `count` steps, rounded to a tenth of a millimetre (or newton, or 0.0001).
    /// An optional input that is not set starts at `start`.
    pub(crate) fn stepped(self, layout: &NamedLayout, size: StepSize, up: bool, start: f64) -> f64 {
        let Some(value) = self.get(layout) else { return start };
        let step = self.step(size);
        let moved = if up { value + step } else { value - step };
        let rounded = (moved * STEP_GRAIN).round() / STEP_GRAIN;
        match self {
            // Offsets stop at the cell's edge instead of refusing the last part of a step.
            Field::Ex | Field::Ey => {
                let (min, max, _) = self.limits(layout);
                // A value outside (the spacing shrank) may still come back in.
                rounded.clamp(min.min(value), max.max(value))
            }
            _ => rounded,
        }
    }
}

fn trim(text: &str) -> String {
    text.strip_suffix(".0").unwrap_or(text).to_string()
}
