//! Laboratory extension: the effect of the panel's size on the standard punch test, Eqs. 1-2 of
//! Pol & Gabrieli (2021), both ways. Holds for the standard punch of 1.0 m only.

use super::Strength;
use crate::mesh::{LabRecord, STANDARD_PANEL};
use crate::problem::Problem;

/// Range of panel sides on which Eqs. 1-2 were fitted, m.
pub(crate) const PANEL_RANGE: (f64, f64) = (2.0, 4.5);

/// Eq. 1: largest force of a panel of side `panel` (m) over that of the standard panel,
/// 0.89 + 0.11 L/L^l.
pub(crate) fn force_ratio(panel: f64) -> f64 {
    0.89 + 0.11 * panel / STANDARD_PANEL
}

/// Eq. 2: deflection at failure of a panel of side `panel` (m) over that of the standard panel,
/// 0.15 + 0.85 L/L^l.
pub(crate) fn deflection_ratio(panel: f64) -> f64 {
    0.15 + 0.85 * panel / STANDARD_PANEL
}

/// Eqs. 1-2: from the standard values to a laboratory panel of another side (m).
pub fn to_panel(standard: Strength, panel: f64) -> Strength {
    Strength {
        force: standard.force * force_ratio(panel),
        deflection: standard.deflection.map(|delta| delta * deflection_ratio(panel)),
    }
}

/// Eqs. 1-2 inverted: from a test on a panel of side `panel` (m) to the standard values F_l*, delta_l*.
pub fn from_panel(measured: Strength, panel: f64) -> Strength {
    Strength {
        force: measured.force / force_ratio(panel),
        deflection: measured.deflection.map(|delta| delta / deflection_ratio(panel)),
    }
}

/// The standard values F_l*, delta_l* of a laboratory record.
///
/// A record of the standard panel is returned untouched, to the last bit.
///
/// # Errors
/// Its punch is not the standard 1.0 m, for which the paper gives no relation.
pub(crate) fn standard_values(record: &LabRecord) -> Result<Strength, Problem> {
    if let Some(problem) = record.punch_problem() {
        return Err(problem);
    }
    let measured = Strength { force: record.force, deflection: record.deflection };
    Ok(if record.panel == STANDARD_PANEL { measured } else { from_panel(measured, record.panel) })
}

#[cfg(test)]
mod tests {
    use super::*;

    // Rounding of a handful of operations; values worked by hand to the digits shown.
    const TINY: f64 = 1e-12;

    #[test]
    fn worked_by_hand() {
        // L = 4.5: 0.89 + 0.11 x 1.5 = 1.055; 0.15 + 0.85 x 1.5 = 1.425.
        assert!((force_ratio(4.5) - 1.055).abs() < TINY);
        assert!((deflection_ratio(4.5) - 1.425).abs() < TINY);
        // L = 2: 0.89 + 0.22/3 = 0.963333...; 0.15 + 1.7/3 = 0.716666...
        let at_2 = to_panel(Strength { force: 73_300.0, deflection: Some(0.60) }, 2.0);
        assert!((at_2.force - 70_612.333_333_333_33).abs() < 1e-6);
        assert!((at_2.deflection.unwrap() - 0.43).abs() < TINY);
        // The standard panel is its own reference.
        assert!(
            (force_ratio(3.0) - 1.0).abs() < TINY && (deflection_ratio(3.0) - 1.0).abs() < TINY
        );
    }

    #[test]
    fn a_test_with_another_punch_has_no_standard_values_and_says_why() {
        let mut record = crate::mesh::catalogue::reference().laboratory.clone();
        assert!(standard_values(&record).is_ok());
        record.punch = 0.8;
        let said = standard_values(&record).unwrap_err().to_string();
        assert!(said.starts_with("laboratory.punch = 0.8 m: a test with another punch"), "{said}");
    }

    #[test]
    fn both_ways_meet() {
        let standard = Strength { force: 73_300.0, deflection: Some(0.60) };
        for panel in [2.0, 2.5, 3.25, 4.5] {
            let back = from_panel(to_panel(standard, panel), panel);
            assert!((back.force / standard.force - 1.0).abs() < TINY);
            assert!((back.deflection.unwrap() / 0.60 - 1.0).abs() < TINY);
        }
    }
}
