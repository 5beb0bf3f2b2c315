//! Lengths, forces and factors on the command line. Bare numbers are metres and kilonewtons; what is
//! wrong with a value is said with the range and the unit.

use crate::case::Input;
use crate::units::{Quantity, Units, parse};

fn read(text: &str, quantity: Quantity, allowed: &str) -> Result<f64, String> {
    let how = match quantity {
        Quantity::Length => ", in metres or with a unit such as 250mm",
        Quantity::Force => ", in kN or with a unit such as 25000N",
        Quantity::Pressure => ", in kN/m2 or with a unit such as 2.5kPa",
        Quantity::Number => ", without a unit",
    };
    parse(text, quantity, Units::METRES).map_err(|e| format!("{e}; allowed: {allowed}{how}"))
}

/// An input's value, SI. Whether it is in its range is checked with the whole layout.
pub(crate) fn of_input(input: Input, text: &str) -> Result<f64, String> {
    read(text, input.row().quantity, &input.allowed())
}

/// Largest force of a laboratory test, N.
pub(crate) fn test_force(text: &str) -> Result<f64, String> {
    let value = of_input(Input::LabForce, text)?;
    match Input::LabForce.problem(value) {
        None => Ok(value),
        Some(problem) => Err(format!("the value is out of range; allowed: {}", problem.allowed)),
    }
}

/// A length above 0, up to 100 m.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    let allowed = "above 0, up to 100 m";
    above_zero(read(text, Quantity::Length, allowed)?, allowed, 100.0)
}

/// Width and length, m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Sides(pub(crate) [f64; 2]);

/// Width and length with a comma between them.
pub(crate) fn sides(text: &str) -> Result<Sides, String> {
    let [width, height] = parts(text, "width, length, such as 1,1")?;
    Ok(Sides([length(width)?, length(height)?]))
}

/// Several values with commas between them.
pub(crate) fn parts<'a, const N: usize>(text: &'a str, what: &str) -> Result<[&'a str; N], String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    parts.try_into().map_err(|_| format!("{N} values with commas between them: {what}"))
}

/// A length of 0 or more, up to 10 m.
pub(crate) fn distance(text: &str) -> Result<f64, String> {
    read(text, Quantity::Length, "from 0, up to 10 m")
}

/// A number without a unit; its range is checked where it is used.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    parse(text, Quantity::Number, Units::METRES).map_err(|e| e.to_string())
}

fn above_zero(value: f64, allowed: &str, most: f64) -> Result<f64, String> {
    if value > 0.0 && value <= most {
        Ok(value)
    } else {
        Err(format!("the value is out of range; allowed: {allowed}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refusals_name_range_and_unit() {
        assert_eq!(of_input(Input::Plate, "250mm"), Ok(0.25));
        assert_eq!(of_input(Input::DesignForce, "25"), Ok(25_000.0));
        assert_eq!(
            of_input(Input::Plate, "2,7").unwrap_err(),
            "write the decimal point as a point: 2.7; allowed: above 0, below the spacing L, in metres or with a unit such as 250mm"
        );
        assert!(
            of_input(Input::GammaLoad, "1 kN").unwrap_err().contains("0.5 to 5, without a unit")
        );
    }
}
