//! Quantities as people write them (`250 mm`, `0.25 m`, `73.3 kN`), to and from SI.
//!
//! Inside the program lengths are metres, forces newtons, stresses pascals and masses kilograms.
//! This is the one place that converts. People read and type metres or millimetres and kilonewtons,
//! feet or inches, kips or tonnes; a bare number in a file or on the command line is metres or
//! kilonewtons, on the screen it is in the unit the screen shows.

mod shown;
mod thousands;

pub use shown::{ChosenUnits, ForceUnit, LengthUnit, Units};
use shown::{M_PER_FOOT, M_PER_INCH, N_PER_KIP, N_PER_TONNE};
pub(crate) use shown::{
    energy_text, force_entry, force_text, length_entry, length_text, maybe_length_text,
    pressure_entry, stiffness_text,
};
use std::fmt;

/// What a number measures, so that its unit can be read and checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// A length; SI unit metre.
    Length,
    /// A force; SI unit newton.
    Force,
    /// A force per area; SI unit N/m2.
    Pressure,
    /// A pure number, such as a partial factor.
    Number,
}

/// Newtons in a kilonewton.
pub(crate) const N_PER_KN: f64 = 1000.0;

/// Newtons to kilonewtons.
pub fn to_kn(newton: f64) -> f64 {
    newton / N_PER_KN
}

/// Kilonewtons to newtons.
pub(crate) fn from_kn(kilonewton: f64) -> f64 {
    kilonewton * N_PER_KN
}

/// Joules to kilojoules.
pub(crate) fn to_kj(joule: f64) -> f64 {
    joule / 1000.0
}

/// Units accepted behind a number, each with the quantity it measures and its size in SI.
/// Sizes below one are kept as their inverse so that `250 mm` is exactly `0.25`.
const UNITS: &[(&str, Quantity, Scale)] = &[
    ("mm", Quantity::Length, Scale::Over(1000.0)),
    ("cm", Quantity::Length, Scale::Over(100.0)),
    ("m", Quantity::Length, Scale::Times(1.0)),
    ("ft", Quantity::Length, Scale::Times(M_PER_FOOT)),
    ("in", Quantity::Length, Scale::Times(M_PER_INCH)),
    ("kN", Quantity::Force, Scale::Times(1000.0)),
    ("MN", Quantity::Force, Scale::Times(1.0e6)),
    ("N", Quantity::Force, Scale::Times(1.0)),
    // The tonne as a force, by the standard gravity of 9.80665 m/s2; pound and kip are 0.45359237 kg
    // and a thousand times that under it.
    ("t", Quantity::Force, Scale::Times(N_PER_TONNE)),
    ("kip", Quantity::Force, Scale::Times(N_PER_KIP)),
    ("lbf", Quantity::Force, Scale::Times(N_PER_KIP / 1000.0)),
    ("kN/m2", Quantity::Pressure, Scale::Times(1000.0)),
    ("kPa", Quantity::Pressure, Scale::Times(1000.0)),
    ("Pa", Quantity::Pressure, Scale::Times(1.0)),
    ("t/m2", Quantity::Pressure, Scale::Times(N_PER_TONNE)),
    ("ksf", Quantity::Pressure, Scale::Times(N_PER_KIP / (M_PER_FOOT * M_PER_FOOT))),
    ("psf", Quantity::Pressure, Scale::Times(N_PER_KIP / 1000.0 / (M_PER_FOOT * M_PER_FOOT))),
];

#[derive(Debug, Clone, Copy)]
enum Scale {
    Times(f64),
    Over(f64),
}

/// Why a typed quantity was refused. `Display` is a sentence for the person who typed it.
#[derive(Debug, Clone, PartialEq)]
pub enum QuantityError {
    /// Nothing was typed.
    Empty,
    /// A comma stands where a decimal point belongs.
    DecimalComma(String),
    /// Thousands are set off.
    Thousands {
        /// The number without that.
        plain: String,
        /// The other reading, where the sign may be a decimal comma.
        or_decimal: Option<String>,
    },
    /// The number part is no number.
    NotANumber(String),
    /// The number is infinite or not a number.
    NotFinite(String),
    /// A unit that does not measure this quantity, or none that is known.
    WrongUnit {
        /// The unit as typed.
        unit: String,
        /// The units that would do.
        allowed: &'static str,
    },
}

impl fmt::Display for QuantityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            QuantityError::Empty => write!(f, "a number is needed"),
            QuantityError::DecimalComma(fixed) => {
                write!(f, "write the decimal point as a point: {fixed}")
            }
            QuantityError::Thousands { plain, or_decimal: None } => {
                write!(f, "write thousands without a sign between them: {plain}")
            }
            QuantityError::Thousands { plain, or_decimal: Some(decimal) } => {
                write!(f, "this can be {plain} or {decimal}: write the one that is meant")
            }
            QuantityError::NotANumber(text) => write!(f, "{text:?} is not a number"),
            QuantityError::NotFinite(text) => write!(f, "{text:?} is not a finite number"),
            QuantityError::WrongUnit { unit, allowed } => {
                write!(f, "unit {unit:?} does not fit here; use {allowed}")
            }
        }
    }
}

impl std::error::Error for QuantityError {}

/// Reads a quantity and returns it in SI (m, N, or the bare number).
///
/// A bare number is taken in the default unit: in the unit shown.
///
/// # Errors
/// [`QuantityError`] says what is wrong with the text.
pub fn parse(text: &str, quantity: Quantity, units: Units) -> Result<f64, QuantityError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(QuantityError::Empty);
    }
    if let Some(grouped) = thousands::read(text) {
        let unit =
            if grouped.unit.is_empty() { String::new() } else { format!(" {}", grouped.unit) };
        return Err(QuantityError::Thousands {
            plain: format!("{}{unit}", grouped.plain),
            or_decimal: grouped.or_decimal,
        });
    }
    let (number, unit) = split_unit(text);
    if number.is_empty() {
        return Err(QuantityError::NotANumber(text.to_string()));
    }
    if number.contains(',') {
        return Err(QuantityError::DecimalComma(format!(
            "{}{}{unit}",
            number.replacen(',', ".", 1),
            if unit.is_empty() { "" } else { " " }
        )));
    }
    let value: f64 = number.parse().map_err(|_| QuantityError::NotANumber(text.to_string()))?;
    if !value.is_finite() {
        return Err(QuantityError::NotFinite(number.to_string()));
    }
    let scale = if unit.is_empty() {
        match (quantity, units.length) {
            (Quantity::Length, LengthUnit::Metre) | (Quantity::Number, _) => Scale::Times(1.0),
            (Quantity::Length, LengthUnit::Millimetre) => Scale::Over(1000.0),
            (Quantity::Length, LengthUnit::Foot) => Scale::Times(M_PER_FOOT),
            (Quantity::Length, LengthUnit::Inch) => Scale::Times(M_PER_INCH),
            (Quantity::Force, _) => Scale::Times(units.newtons(1.0)),
            (Quantity::Pressure, _) => Scale::Times(units.pascals()),
        }
    } else {
        find_unit(unit, quantity)?
    };
    let si = match scale {
        Scale::Times(s) => value * s,
        Scale::Over(s) => value / s,
    };
    if si.is_finite() { Ok(si) } else { Err(QuantityError::NotFinite(number.to_string())) }
}

/// The same of what is typed at the terminal, where a comma can only be a decimal one; with three digits
/// behind it may set off thousands, and is asked about.
///
/// # Errors
/// As [`parse`].
pub(crate) fn parse_typed(
    text: &str,
    quantity: Quantity,
    units: Units,
) -> Result<f64, QuantityError> {
    match parse(text, quantity, units) {
        Err(QuantityError::DecimalComma(fixed)) => parse(&fixed, quantity, units),
        other => other,
    }
}

/// Splits `250 mm` into `250` and `mm`; an exponent (`1e3`) belongs to the number.
fn split_unit(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let c = bytes[end];
        let exponent = (c == b'e' || c == b'E')
            && end > 0
            && bytes.get(end + 1).is_some_and(|n| n.is_ascii_digit() || matches!(n, b'+' | b'-'));
        let sign = matches!(c, b'+' | b'-');
        if c.is_ascii_digit() || c == b'.' || c == b',' || exponent || sign {
            end += 1;
        } else {
            break;
        }
    }
    (text[..end].trim(), text[end..].trim())
}

fn find_unit(unit: &str, quantity: Quantity) -> Result<Scale, QuantityError> {
    let exact = UNITS.iter().find(|u| u.1 == quantity && u.0 == unit);
    let loose = || UNITS.iter().find(|u| u.1 == quantity && u.0.eq_ignore_ascii_case(unit));
    let ambiguous = unit.eq_ignore_ascii_case("mn") && unit != "MN";
    match exact.or_else(|| if ambiguous { None } else { loose() }) {
        Some(u) => Ok(u.2),
        None => Err(QuantityError::WrongUnit {
            unit: unit.to_string(),
            allowed: match quantity {
                Quantity::Length => "m, cm, mm, ft or in",
                Quantity::Force => "kN, N, MN, t, kip or lbf",
                Quantity::Pressure => "kN/m2, kPa, Pa, t/m2, ksf or psf",
                Quantity::Number => "no unit",
            },
        }),
    }
}

/// A number at `digits` significant digits without an exponent, for tables and panels:
/// 31.04 at three digits is `31.0`, 0.6196 is `0.620`, 1234.0 is `1234`.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value:.0$}", if value == 0.0 { digits.saturating_sub(1) } else { 0 });
    }
    let magnitude = value.abs().log10().floor() as i32;
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{value:.decimals$}");
    // Rounding may carry into a new digit (9.996 -> "10.00"): print once more with one less.
    let rounded: f64 = text.parse().unwrap_or(value);
    if decimals > 0 && rounded.abs().log10().floor() as i32 > magnitude {
        return format!("{value:.0$}", decimals - 1);
    }
    text
}

/// The shortest decimal text of a number after rounding away the noise of unit conversion
/// (twelve significant digits), for files and for values a person entered: `0.1 + 0.2` is `0.3`.
/// Whole numbers keep one decimal (`3.0`), as RON writes floating point numbers.
pub fn shortest(value: f64) -> String {
    // An integer below 2^53 prints without an exponent; `{:?}` writes "3.0" and "0.25".
    format!("{:?}", without_noise(value))
}

/// The number rounded to twelve significant digits, which takes away the noise of conversion and
/// leaves far more than the method is good for; never the negative zero.
pub(crate) fn without_noise(value: f64) -> f64 {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// A utilisation in per cent at three digits, and at four where three would hide which side of 100 it
/// is on: `96.1`, `100.2`.
pub(crate) fn percent(utilisation: f64) -> String {
    let text = significant(utilisation * 100.0, 3);
    // What just meets a limit does so to rounding.
    if text == "100" && (utilisation - 1.0).abs() > 1e-9 {
        return significant(utilisation * 100.0, 4);
    }
    text
}

/// Reading and writing quantities in files: bare numbers are metres or kN, text may carry a unit.
pub(crate) mod file {
    use super::{Quantity, Units, parse};
    use serde::{Deserializer, Serializer, de};
    use std::fmt;

    struct Reader(Quantity);

    impl Reader {
        fn bare<E: de::Error>(&self, v: f64) -> Result<f64, E> {
            if !v.is_finite() {
                return Err(E::custom(format!(
                    "{v} is not a finite number; write an ordinary number such as 0.32"
                )));
            }
            let kilo = matches!(self.0, Quantity::Force | Quantity::Pressure);
            let si = if kilo { super::from_kn(v) } else { v };
            if si.is_finite() { Ok(si) } else { Err(E::custom("the number is too large")) }
        }
    }

    impl de::Visitor<'_> for Reader {
        type Value = f64;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str(match self.0 {
                Quantity::Length => "a length, a number in m or a text such as \"250 mm\",",
                Quantity::Force => "a force, a number in kN or a text such as \"73.3 kN\",",
                Quantity::Pressure => {
                    "a pressure, a number in kN/m2 or a text such as \"2.5 kPa\","
                }
                Quantity::Number => "a number",
            })
        }
        fn visit_f64<E: de::Error>(self, v: f64) -> Result<f64, E> {
            self.bare(v)
        }
        fn visit_i64<E: de::Error>(self, v: i64) -> Result<f64, E> {
            self.bare(v as f64)
        }
        fn visit_u64<E: de::Error>(self, v: u64) -> Result<f64, E> {
            self.bare(v as f64)
        }
        fn visit_str<E: de::Error>(self, v: &str) -> Result<f64, E> {
            parse(v, self.0, Units::METRES).map_err(E::custom)
        }
    }

    macro_rules! quantity_module {
        ($name:ident, $quantity:expr $(, $write:expr)?) => {
            /// For `#[serde(with = ...)]`: the field in SI, the file in its bare unit.
            pub(crate) mod $name {
                use super::*;
                /// Reads the quantity into SI.
                pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
                    d: D,
                ) -> Result<f64, D::Error> {
                    d.deserialize_any(Reader($quantity))
                }
                $(
                    /// Writes the quantity as a bare number.
                    pub(crate) fn serialize<S: Serializer>(
                        v: &f64,
                        s: S,
                    ) -> Result<S::Ok, S::Error> {
                        let write: fn(f64) -> f64 = $write;
                        s.serialize_f64(write(*v))
                    }
                )?
            }
        };
    }

    /// A length that may be missing.
    pub(crate) mod maybe_length {
        use super::*;
        /// Reads the length, m.
        pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
            d: D,
        ) -> Result<Option<f64>, D::Error> {
            super::length::deserialize(d).map(Some)
        }
        /// Writes the length as a bare number; a missing one as an empty value.
        #[expect(clippy::ref_option, reason = "serde's `with` hands over a reference to the field")]
        pub(crate) fn serialize<S: Serializer>(v: &Option<f64>, s: S) -> Result<S::Ok, S::Error> {
            match v {
                Some(v) => super::length::serialize(v, s),
                None => s.serialize_none(),
            }
        }
    }

    quantity_module!(length, Quantity::Length, |v| v);
    quantity_module!(force, Quantity::Force, crate::units::to_kn);
    quantity_module!(pressure, Quantity::Pressure);
    quantity_module!(number, Quantity::Number, |v| v);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_read_with_and_without_a_unit() {
        for (text, metres) in [
            ("250mm", 0.25),
            ("250 mm", 0.25),
            ("0.25", 0.25),
            (" 25 cm ", 0.25),
            ("0.25m", 0.25),
            ("2.5e-1 m", 0.25),
            ("-1.15 M", -1.15),
        ] {
            assert_eq!(parse(text, Quantity::Length, Units::METRES), Ok(metres), "{text}");
        }
        assert_eq!(parse("250", Quantity::Length, Units::MILLIMETRES), Ok(0.25));
    }

    #[test]
    fn forces_are_read_in_newtons() {
        assert_eq!(parse("73.3", Quantity::Force, Units::METRES), Ok(73300.0));
        assert_eq!(parse("500 N", Quantity::Force, Units::METRES), Ok(500.0));
        assert!(parse("5 mN", Quantity::Force, Units::METRES).is_err());
    }

    #[test]
    fn refusals_say_what_to_do() {
        let said = |t: &str| parse(t, Quantity::Length, Units::METRES).unwrap_err().to_string();
        assert_eq!(said("2,7 m"), "write the decimal point as a point: 2.7 m");
        assert_eq!(said("3 kN"), "unit \"kN\" does not fit here; use m, cm, mm, ft or in");
        assert_eq!(said("3 000 mm"), "write thousands without a sign between them: 3000 mm");
        assert_eq!(said("1,250mm"), "this can be 1250 mm or 1.250mm: write the one that is meant");
        assert_eq!(said("abc"), "\"abc\" is not a number");
        assert_eq!(said("1e999"), "\"1e999\" is not a finite number");
        assert_eq!(said("1-2"), "\"1-2\" is not a number");
        assert_eq!(said(""), "a number is needed");
    }

    #[test]
    fn a_typed_comma_is_a_decimal_point_where_it_can_be_nothing_else() {
        let read = |t: &str| parse_typed(t, Quantity::Length, Units::METRES);
        assert_eq!((read("2,5"), read("2,75 m"), read("-0,2")), (Ok(2.5), Ok(2.75), Ok(-0.2)));
        assert!(matches!(read("1,250"), Err(QuantityError::Thousands { .. })));
        assert!(read("1,2,3").is_err() && read(",").is_err());
    }

    #[test]
    fn feet_inches_kips_and_tonnes_are_what_they_are_defined_as() {
        let of = |t: &str, quantity| parse(t, quantity, Units::METRES).unwrap();
        assert_eq!((of("10 ft", Quantity::Length), of("10in", Quantity::Length)), (3.048, 0.254));
        // 1 kip is 1000 lbf; 1 lbf is 0.45359237 kg x 9.80665 m/s2.
        assert!((of("1 lbf", Quantity::Force) - 0.453_592_37 * 9.806_65).abs() < 1e-12);
        assert_eq!(of("1 kip", Quantity::Force), 1000.0 * of("1 lbf", Quantity::Force));
        assert_eq!(of("2 t", Quantity::Force), 19_613.3);
    }

    #[test]
    fn significant_digits_carry() {
        assert_eq!(significant(31.04, 3), "31.0");
        assert_eq!(significant(9.996, 3), "10.0");
        assert_eq!(significant(0.06196, 3), "0.0620");
        assert_eq!(significant(1234.0, 3), "1234");
        assert_eq!(significant(0.0, 3), "0.00");
        assert_eq!(significant(-0.9996, 3), "-1.00");
    }

    #[test]
    fn entries_keep_no_noise() {
        assert_eq!(shortest(0.1 + 0.2), "0.3");
        assert_eq!(shortest(3.0), "3.0");
        assert_eq!(shortest(-0.0), "0.0");
    }
}
