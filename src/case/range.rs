//! What an input may be: whether a value is allowed, and the range as text.

use crate::layout::{LARGEST_LENGTH, Layout};
use crate::units::{Quantity, to_kn};

/// What an input may be. Some ranges depend on the rest of the layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Range {
    /// Above 0 and below the spacing.
    BelowSpacing,
    /// Above plate and punch, below the largest length.
    Spacing,
    /// Within half the spacing along x (0) or y (1) on either side.
    HalfSpacing(usize),
    /// Above 0, up to this, SI.
    UpTo(f64),
    /// Between the two, both included, SI.
    Between(f64, f64),
}

/// Limits of a value, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limits {
    /// The lower one.
    pub(crate) min: f64,
    /// The upper one.
    pub(crate) max: f64,
    /// Whether the lower one is allowed itself.
    min_allowed: bool,
    /// Whether the upper one is allowed itself.
    max_allowed: bool,
}

impl Limits {
    /// Whether a value is allowed; what is no number is not.
    pub(crate) fn hold(&self, value: f64) -> bool {
        let above = if self.min_allowed { value >= self.min } else { value > self.min };
        let below = if self.max_allowed { value <= self.max } else { value < self.max };
        above && below
    }
}

impl Range {
    /// The limits in a layout.
    pub(crate) fn limits(self, layout: &Layout) -> Limits {
        let (min, max, min_allowed, max_allowed) = match self {
            Range::BelowSpacing => (0.0, layout.least(), false, false),
            Range::Spacing => (layout.plate.max(layout.punch), LARGEST_LENGTH, false, false),
            Range::HalfSpacing(axis) => {
                let half = layout.sides()[axis] / 2.0;
                (-half, half, true, true)
            }
            Range::UpTo(max) => (0.0, max, false, true),
            Range::Between(min, max) => (min, max, true, true),
        };
        Limits { min, max, min_allowed, max_allowed }
    }

    /// Whether a value is allowed in some layout, whatever the other inputs are.
    pub(super) fn holds_alone(self, value: f64) -> bool {
        match self {
            Range::BelowSpacing | Range::Spacing => value > 0.0 && value < LARGEST_LENGTH,
            Range::HalfSpacing(_) => value.abs() < LARGEST_LENGTH,
            Range::UpTo(max) => value > 0.0 && value <= max,
            Range::Between(min, max) => (min..=max).contains(&value),
        }
    }

    /// The range as text for files and flags: `above 0, below the spacing L`.
    pub(super) fn text(self, quantity: Quantity) -> String {
        match self {
            Range::BelowSpacing => "above 0, below the spacing L".into(),
            Range::Spacing => format!("above 0, below {LARGEST_LENGTH} m"),
            Range::HalfSpacing(_) => "-L/2 to L/2".into(),
            Range::UpTo(max) => format!("above 0, up to {}", measured(max, quantity)),
            Range::Between(min, max) => format!("{min} to {}", measured(max, quantity)),
        }
    }

    /// The same where the other inputs are not known.
    pub(super) fn alone(self, quantity: Quantity) -> String {
        match self {
            Range::BelowSpacing => Range::Spacing.text(quantity),
            Range::HalfSpacing(_) => {
                format!("-{LARGEST_LENGTH} m to {LARGEST_LENGTH} m; -L/2 to L/2 is the whole cell")
            }
            _ => self.text(quantity),
        }
    }
}

fn measured(value: f64, quantity: Quantity) -> String {
    match quantity {
        Quantity::Length => format!("{value} m"),
        Quantity::Force => format!("{} kN", to_kn(value)),
        Quantity::Pressure => format!("{} kN/m2", to_kn(value)),
        Quantity::Number => value.to_string(),
    }
}
