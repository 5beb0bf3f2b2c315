//! The units that people are shown, and in which a bare number typed on the screen is read.

use super::{N_PER_KN, shortest, significant};
use crate::words::Choice;

/// A unit of lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum LengthUnit {
    /// Metres.
    #[default]
    #[serde(rename = "m")]
    Metre,
    /// Millimetres.
    #[serde(rename = "mm")]
    Millimetre,
    /// Feet of 0.3048 m.
    #[serde(rename = "ft")]
    Foot,
    /// Inches of 25.4 mm.
    #[serde(rename = "in")]
    Inch,
}

/// A unit of forces. What is derived from it (stiffness, energy, pressure) goes by it too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum ForceUnit {
    /// Kilonewtons; energy in kJ, pressure in kPa.
    #[default]
    #[serde(rename = "kN")]
    Kilonewton,
    /// Kips, a thousand pounds under standard gravity; energy in kip ft, pressure in kip/ft2.
    #[serde(rename = "kip")]
    Kip,
    /// Tonnes under standard gravity of 9.80665 m/s2; energy in t m, pressure in t/m2.
    #[serde(rename = "t")]
    Tonne,
}

/// Newtons in a kip: 1000 times 0.45359237 kg under 9.80665 m/s2.
pub(super) const N_PER_KIP: f64 = 4_448.221_615_260_5;
/// Newtons in a tonne under standard gravity.
pub(super) const N_PER_TONNE: f64 = 9_806.65;
/// Metres in a foot.
pub(super) const M_PER_FOOT: f64 = 0.3048;
/// Metres in an inch.
pub(super) const M_PER_INCH: f64 = 0.0254;

impl LengthUnit {
    /// The unit's sign: `m`, `mm`, `ft` or `in`.
    pub fn symbol(self) -> &'static str {
        match self {
            LengthUnit::Metre => "m",
            LengthUnit::Millimetre => "mm",
            LengthUnit::Foot => "ft",
            LengthUnit::Inch => "in",
        }
    }

    /// How many of this unit make a metre.
    pub(crate) fn per_metre(self) -> f64 {
        match self {
            LengthUnit::Metre => 1.0,
            LengthUnit::Millimetre => 1000.0,
            LengthUnit::Foot => 1.0 / M_PER_FOOT,
            LengthUnit::Inch => 1.0 / M_PER_INCH,
        }
    }

    /// The unit that a key leads to: the other of m and mm, or of ft and in.
    pub(crate) fn other(self) -> Self {
        match self {
            LengthUnit::Metre => LengthUnit::Millimetre,
            LengthUnit::Millimetre => LengthUnit::Metre,
            LengthUnit::Foot => LengthUnit::Inch,
            LengthUnit::Inch => LengthUnit::Foot,
        }
    }

    /// Decimals at which a computed length stands: a millimetre, a hundredth of a foot, a tenth of an inch.
    fn decimals(self) -> usize {
        match self {
            LengthUnit::Metre => 3,
            LengthUnit::Millimetre => 0,
            LengthUnit::Foot => 2,
            LengthUnit::Inch => 1,
        }
    }

    fn imperial(self) -> bool {
        matches!(self, LengthUnit::Foot | LengthUnit::Inch)
    }
}

impl Choice for LengthUnit {
    const ALL: &'static [LengthUnit] =
        &[LengthUnit::Metre, LengthUnit::Millimetre, LengthUnit::Foot, LengthUnit::Inch];

    fn word(self) -> &'static str {
        self.symbol()
    }
}

impl ForceUnit {
    /// The unit's sign: `kN`, `kip` or `t`.
    pub fn symbol(self) -> &'static str {
        match self {
            ForceUnit::Kilonewton => "kN",
            ForceUnit::Kip => "kip",
            ForceUnit::Tonne => "t",
        }
    }

    /// Newtons in it.
    fn newtons(self) -> f64 {
        match self {
            ForceUnit::Kilonewton => N_PER_KN,
            ForceUnit::Kip => N_PER_KIP,
            ForceUnit::Tonne => N_PER_TONNE,
        }
    }
}

impl Choice for ForceUnit {
    const ALL: &'static [ForceUnit] = &[ForceUnit::Kilonewton, ForceUnit::Kip, ForceUnit::Tonne];

    fn word(self) -> &'static str {
        self.symbol()
    }
}

/// What is shown: a unit of lengths and one of forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Units {
    /// Of lengths.
    pub length: LengthUnit,
    /// Of forces.
    pub force: ForceUnit,
}

impl Units {
    /// Metres and kilonewtons, as files have them.
    pub const METRES: Units = Units { length: LengthUnit::Metre, force: ForceUnit::Kilonewton };
    /// Millimetres and kilonewtons.
    pub const MILLIMETRES: Units =
        Units { length: LengthUnit::Millimetre, force: ForceUnit::Kilonewton };

    /// The sign of the unit of lengths.
    pub fn symbol(self) -> &'static str {
        self.length.symbol()
    }

    /// How many units of length make a metre.
    pub(crate) fn per_metre(self) -> f64 {
        self.length.per_metre()
    }

    /// The sign of the unit of forces.
    pub(crate) fn force_symbol(self) -> &'static str {
        self.force.symbol()
    }

    /// A force, N, in the unit shown.
    pub(crate) fn force(self, newton: f64) -> f64 {
        newton / self.force.newtons()
    }

    /// A force in the unit shown, in N.
    pub(crate) fn newtons(self, shown: f64) -> f64 {
        shown * self.force.newtons()
    }

    /// A force, N, at `digits` significant digits in the unit shown, without its sign.
    pub(crate) fn force_number(self, newton: f64, digits: usize) -> String {
        significant(self.force(newton), digits)
    }

    /// The sign of the unit of stiffness.
    pub(crate) fn stiffness_symbol(self) -> &'static str {
        match (self.force, self.length.imperial()) {
            (ForceUnit::Kilonewton, false) => "kN/m",
            (ForceUnit::Kilonewton, true) => "kN/ft",
            (ForceUnit::Kip, false) => "kip/m",
            (ForceUnit::Kip, true) => "kip/ft",
            (ForceUnit::Tonne, false) => "t/m",
            (ForceUnit::Tonne, true) => "t/ft",
        }
    }

    /// A stiffness, N/m, in the unit shown at three digits.
    pub(crate) fn stiffness_number(self, newton_per_metre: f64) -> String {
        let metres = if self.length.imperial() { M_PER_FOOT } else { 1.0 };
        significant(self.force(newton_per_metre) * metres, 3)
    }

    /// The sign of the unit of energy.
    pub(crate) fn energy_symbol(self) -> &'static str {
        match self.force {
            ForceUnit::Kilonewton => "kJ",
            ForceUnit::Kip => "kip ft",
            ForceUnit::Tonne => "t m",
        }
    }

    /// An energy, J, in the unit shown at three digits.
    pub(crate) fn energy_number(self, joule: f64) -> String {
        let metres = if self.force == ForceUnit::Kip { M_PER_FOOT } else { 1.0 };
        significant(self.force(joule) / metres, 3)
    }

    /// The sign of the unit of pressure, as narrow as it goes.
    pub(crate) fn pressure_symbol(self) -> &'static str {
        match self.force {
            ForceUnit::Kilonewton => "kPa",
            ForceUnit::Kip => "ksf",
            ForceUnit::Tonne => "t/m2",
        }
    }

    /// A pressure, N/m2, in the unit shown.
    pub(crate) fn pressure(self, si: f64) -> f64 {
        si / self.pascals()
    }

    /// N/m2 in the unit of pressure shown.
    pub(super) fn pascals(self) -> f64 {
        let area = if self.force == ForceUnit::Kip { M_PER_FOOT * M_PER_FOOT } else { 1.0 };
        self.force.newtons() / area
    }

    /// A computed length, m, at the precision of the method, without its sign.
    pub(crate) fn length_number(self, metres: f64) -> String {
        self.length_with(metres, 0)
    }

    /// The same with so many decimals more.
    pub(crate) fn length_with(self, metres: f64, more: usize) -> String {
        // Never the negative zero.
        format!("{:.1$}", metres * self.per_metre() + 0.0, self.length.decimals() + more)
    }

    /// A size, m, for a narrow column: a centimetre, a hundredth of a foot, a tenth of an inch.
    pub(crate) fn size_number(self, metres: f64) -> String {
        let decimals = match self.length {
            LengthUnit::Metre | LengthUnit::Foot => 2,
            LengthUnit::Millimetre => 0,
            LengthUnit::Inch => 1,
        };
        format!("{:.decimals$}", metres * self.per_metre())
    }

    /// How many decimals a studied length has at most and at least.
    pub(crate) fn study_decimals(self) -> (usize, usize) {
        match self.length {
            LengthUnit::Metre => (4, 2),
            LengthUnit::Millimetre => (1, 0),
            LengthUnit::Foot => (3, 2),
            LengthUnit::Inch => (2, 1),
        }
    }
}

/// What a person asked to see instead of the project's own units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChosenUnits {
    /// Of lengths; nothing for the project's.
    pub length: Option<LengthUnit>,
    /// Of forces; nothing for the project's.
    pub force: Option<ForceUnit>,
}

impl ChosenUnits {
    /// The units shown where the project has these.
    pub(crate) fn over(self, project: Units) -> Units {
        Units {
            length: self.length.unwrap_or(project.length),
            force: self.force.unwrap_or(project.force),
        }
    }

    /// Reads `mm`, `kip` or `ft,kip`, with a comma or a blank between.
    ///
    /// # Errors
    /// The words that would do.
    pub(crate) fn read(text: &str) -> Result<ChosenUnits, String> {
        let mut chosen = ChosenUnits::default();
        for word in text.split([',', ' ']).filter(|word| !word.is_empty()) {
            if let Some(length) = LengthUnit::from_word(word) {
                chosen.length = Some(length);
            } else if let Some(force) = ForceUnit::from_word(word) {
                chosen.force = Some(force);
            } else {
                return Err(format!("no unit {word}; lengths in {LENGTHS}, forces in {FORCES}"));
            }
        }
        match chosen == ChosenUnits::default() {
            true => Err(format!("lengths in {LENGTHS}, forces in {FORCES}")),
            false => Ok(chosen),
        }
    }
}

/// The words for lengths, for people.
const LENGTHS: &str = "m, mm, ft or in";
/// The words for forces.
const FORCES: &str = "kN, kip or t";

/// A length as entered, in the unit shown, shortest form without the unit's sign: `0.32` or `320`. In feet
/// and inches metric sizes are no round numbers: they end at a thirtieth of a millimetre.
pub(crate) fn length_entry(metres: f64, units: Units) -> String {
    let value = metres * units.per_metre();
    let grained = |grain: f64| shortest((value * grain).round() / grain);
    let text = match units.length {
        LengthUnit::Foot => grained(1e4),
        LengthUnit::Inch => grained(1e3),
        LengthUnit::Metre | LengthUnit::Millimetre => shortest(value),
    };
    match units.length {
        LengthUnit::Millimetre => text.strip_suffix(".0").unwrap_or(&text).to_string(),
        // At least two decimals, so that columns of lengths read alike.
        LengthUnit::Metre | LengthUnit::Foot => match text.find('.') {
            Some(dot) if text.len() - dot - 1 < 2 => format!("{text}0"),
            _ => text,
        },
        LengthUnit::Inch => text,
    }
}

/// A force as entered, in the unit shown, without the unit's sign. Kips and tonnes end at a newton.
pub(crate) fn force_entry(newton: f64, units: Units) -> String {
    entry(units.force(newton), units)
}

/// The same of a pressure, N/m2.
pub(crate) fn pressure_entry(si: f64, units: Units) -> String {
    entry(units.pressure(si), units)
}

fn entry(value: f64, units: Units) -> String {
    let text = match units.force {
        ForceUnit::Kilonewton => shortest(value),
        ForceUnit::Kip | ForceUnit::Tonne => shortest((value * 1e4).round() / 1e4),
    };
    text.strip_suffix(".0").unwrap_or(&text).to_string()
}

/// A computed length with its unit at the precision of the method: `0.620 m` or `620 mm`.
pub(crate) fn length_text(metres: f64, units: Units) -> String {
    format!("{} {}", units.length_number(metres), units.symbol())
}

/// The same of one that may be missing, `-`.
pub(crate) fn maybe_length_text(metres: Option<f64>, units: Units) -> String {
    metres.map_or("-".into(), |metres| length_text(metres, units))
}

/// A computed force at three significant digits, with its unit: `31.0 kN`.
pub(crate) fn force_text(newton: f64, units: Units) -> String {
    format!("{} {}", units.force_number(newton, 3), units.force_symbol())
}

/// A stiffness, N/m, with its unit: `45.2 kN/m`.
pub(crate) fn stiffness_text(newton_per_metre: f64, units: Units) -> String {
    format!("{} {}", units.stiffness_number(newton_per_metre), units.stiffness_symbol())
}

/// An energy, J, with its unit: `7.31 kJ`.
pub(crate) fn energy_text(joule: f64, units: Units) -> String {
    format!("{} {}", units.energy_number(joule), units.energy_symbol())
}

#[cfg(test)]
mod tests {
    use super::*;

    const FEET: Units = Units { length: LengthUnit::Foot, force: ForceUnit::Kip };
    const INCHES: Units = Units { length: LengthUnit::Inch, force: ForceUnit::Tonne };

    #[test]
    fn entries_are_short_and_free_of_noise() {
        assert_eq!(length_entry(0.32, Units::METRES), "0.32");
        assert_eq!(length_entry(3.0, Units::METRES), "3.00");
        assert_eq!(length_entry(0.3215, Units::METRES), "0.3215");
        assert_eq!(length_entry(0.32, Units::MILLIMETRES), "320");
        // 10 ft and 3 m in feet (3 / 0.3048 = 9.84251...), 250 mm in inches (250 / 25.4 = 9.84251...).
        assert_eq!(length_entry(3.048, FEET), "10.00");
        assert_eq!(length_entry(3.0, FEET), "9.8425");
        assert_eq!(length_entry(0.25, INCHES), "9.843");
        assert_eq!(force_entry(20_000.0, Units::METRES), "20");
        assert_eq!(force_entry(4_448.221_615_260_5 * 4.5, FEET), "4.5");
    }

    /// By hand: 31.0 kN / 4.4482216 = 6.969 kip, / 9.80665 = 3.161 t; 0.62 m = 2.034 ft = 24.41 in;
    /// 100 kN/m = 100 / 4.4482216 x 0.3048 = 6.852 kip/ft; 10 kJ = 10 / 4.4482216 / 0.3048 = 7.376 kip ft;
    /// 10 kPa = 10 / 4.4482216 x 0.3048^2 = 0.2089 kip/ft2.
    #[test]
    fn computed_values_are_converted_as_units_are_defined() {
        assert_eq!(force_text(31.0e3, FEET), "6.97 kip");
        assert_eq!(force_text(31.0e3, INCHES), "3.16 t");
        assert_eq!(length_text(0.62, FEET), "2.03 ft");
        assert_eq!(length_text(0.62, INCHES), "24.4 in");
        assert_eq!(stiffness_text(100.0e3, FEET), "6.85 kip/ft");
        assert_eq!(energy_text(10.0e3, FEET), "7.38 kip ft");
        assert_eq!(significant(FEET.pressure(10.0e3), 4), "0.2089");
        assert_eq!(stiffness_text(100.0e3, Units::METRES), "100 kN/m");
        assert_eq!(energy_text(10.0e3, Units::METRES), "10.0 kJ");
        assert_eq!(FEET.newtons(FEET.force(31.0e3)), 31.0e3);
    }

    #[test]
    fn one_or_both_units_can_be_chosen() {
        let read = |text: &str| ChosenUnits::read(text).map(|c| c.over(Units::MILLIMETRES));
        assert_eq!(read("ft,kip"), Ok(FEET));
        assert_eq!(read("t in"), Ok(INCHES));
        assert_eq!(read("m"), Ok(Units::METRES));
        let said = read("yd").unwrap_err();
        assert!(said.contains("no unit yd") && said.contains("ft or in"), "{said}");
        assert!(read(",").is_err());
    }
}
