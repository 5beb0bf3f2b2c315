//! What the paper prints, from `assets/published.ron`, and how the forecast compares with it, digit
//! for digit.

use super::{Strength, Values, field, forecast, laboratory, master, ratios};
use crate::layout::{BranchRule, Layout, REFERENCE};
use crate::mesh::{STANDARD_PANEL, catalogue};
use crate::units::to_kn;
use serde::Deserialize;
use std::sync::OnceLock;

const TEXT: &str = include_str!("../../assets/published.ron");

/// A number as it is printed; its digits are the precision to which it is known.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct Printed(String);

impl TryFrom<String> for Printed {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let digits = text.chars().all(|c| c.is_ascii_digit() || c == '.');
        match text.parse::<f64>() {
            Ok(_) if digits => Ok(Printed(text)),
            _ => Err(format!("{text:?} is no printed number such as 22.8")),
        }
    }
}

impl Printed {
    /// The digits.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// The number that the digits say.
    pub fn value(&self) -> f64 {
        // Checked when it was read.
        self.0.parse().unwrap_or(f64::NAN)
    }

    /// Digits behind the point.
    pub(crate) fn decimals(&self) -> usize {
        self.0.split_once('.').map_or(0, |(_, behind)| behind.len())
    }

    /// Whether a value, rounded to the same digits, is printed the same.
    pub(crate) fn agrees(&self, value: f64) -> bool {
        format!("{value:.0$}", self.decimals()) == self.0
    }
}

/// A printed force (kN) with its deflection (m).
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrintedValues {
    /// Force, kN.
    pub force: Printed,
    /// Deflection, m.
    pub deflection: Printed,
}

/// One row of Table 1.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedTest {
    /// Number of the test.
    pub test: u32,
    /// Plate side, m.
    #[serde(rename = "d")]
    pub plate: f64,
    /// Spacing, m.
    #[serde(rename = "L")]
    pub spacing: f64,
    /// Punch diameter, m.
    #[serde(rename = "D")]
    pub punch: f64,
    /// Offset across the twists, m.
    pub ex: f64,
    /// Offset along the twists, m.
    pub ey: f64,
    /// The paper's simulation.
    pub dem: PrintedValues,
    /// The paper's forecast.
    pub forecast: PrintedValues,
    /// Whether the eccentricity map was made to meet the forecast, so that agreement proves nothing.
    pub by_construction: bool,
}

impl PublishedTest {
    /// The row's layout.
    pub fn layout(&self) -> Layout {
        Layout {
            plate: self.plate,
            spacing: self.spacing,
            punch: self.punch,
            ex: self.ex,
            ey: self.ey,
            ..REFERENCE
        }
    }
}

/// What a printed number outside Table 1 is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Fact {
    /// F_l* through Eq. 1 at the standard panel, kN.
    StandardPanelForce,
    /// delta_l* through Eq. 2 at the standard panel, m.
    StandardPanelDeflection,
    /// alpha_F.
    AlphaForce,
    /// alpha_delta.
    AlphaDeflection,
    /// F_a*, kN.
    FieldReferenceForce,
    /// delta_a*, m.
    FieldReferenceDeflection,
    /// Eq. 3 at 1.
    MasterCurveEnd,
}

/// A printed number outside Table 1.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedFact {
    /// What it is of.
    pub fact: Fact,
    /// The same in words.
    pub words: String,
    /// Its unit, empty for a pure number.
    pub unit: String,
    /// The digits.
    pub printed: Printed,
    /// Where in the paper.
    pub source: String,
}

/// What the paper prints.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// The paper.
    pub source: String,
    /// Table 1.
    pub tests: Vec<PublishedTest>,
    /// Other printed numbers.
    pub facts: Vec<PublishedFact>,
    /// What the published relations return at their reference point, where they were made to give
    /// 29.1 kN and 0.65 m; worked by hand, not printed.
    pub reference_point: PrintedValues,
}

/// What the paper prints.
pub fn published() -> &'static Published {
    static PUBLISHED: OnceLock<Published> = OnceLock::new();
    PUBLISHED.get_or_init(|| {
        // The text is part of the program; a test loads it, so a broken one is never shipped.
        ron::from_str(TEXT).unwrap_or_else(|e| panic!("assets/published.ron: {e}"))
    })
}

/// A printed number beside ours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedComparison {
    /// What is printed.
    pub printed: &'static Printed,
    /// Ours, in the unit in which it is printed.
    pub ours: f64,
}

impl PublishedComparison {
    /// Whether every printed digit agrees.
    pub fn agrees(&self) -> bool {
        self.printed.agrees(self.ours)
    }

    /// Ours less the printed number.
    pub(crate) fn difference(&self) -> f64 {
        self.ours - self.printed.value()
    }
}

/// A row of Table 1 beside ours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestRow {
    /// The row.
    pub(crate) test: &'static PublishedTest,
    /// Its F_a, kN.
    pub(crate) force: PublishedComparison,
    /// Its delta_a, m.
    pub(crate) deflection: PublishedComparison,
}

/// The whole comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Validation {
    /// Table 1.
    pub tests: Vec<TestRow>,
    /// Other printed numbers.
    pub facts: Vec<(&'static PublishedFact, PublishedComparison)>,
    /// F_a (kN) at the reference point beside the value worked by hand.
    pub reference_force: PublishedComparison,
    /// delta_a (m) at the reference point beside the value worked by hand.
    pub reference_deflection: PublishedComparison,
}

impl Validation {
    /// Whether every digit agrees.
    pub fn agrees(&self) -> bool {
        self.tests.iter().all(|t| t.force.agrees() && t.deflection.agrees())
            && self.facts.iter().all(|(_, c)| c.agrees())
            && self.reference_force.agrees()
            && self.reference_deflection.agrees()
    }
}

/// Compares the forecast of the reference mesh with everything the paper prints. What cannot be
/// forecast is not a number and agrees with nothing.
pub fn validate() -> Validation {
    let published = published();
    let pair = |printed: &'static PrintedValues, ours: Values| {
        (
            PublishedComparison { printed: &printed.force, ours: to_kn(ours.force) },
            PublishedComparison { printed: &printed.deflection, ours: ours.deflection },
        )
    };
    let tests = published.tests.iter().map(|test| {
        let (force, deflection) = pair(&test.forecast, field_values(&test.layout()));
        TestRow { test, force, deflection }
    });
    let facts = published.facts.iter().map(|fact| {
        (fact, PublishedComparison { printed: &fact.printed, ours: our_fact(fact.fact) })
    });
    let (reference_force, reference_deflection) =
        pair(&published.reference_point, field_values(&REFERENCE));
    Validation {
        tests: tests.collect(),
        facts: facts.collect(),
        reference_force,
        reference_deflection,
    }
}

/// F_a and delta_a of a layout with the reference mesh, whose laboratory record has both.
fn field_values(layout: &Layout) -> Values {
    forecast(layout, &catalogue::reference(), BranchRule::Published)
        .ok()
        .and_then(|result| result.field.ok()?.end())
        .unwrap_or(Values::new(f64::NAN, f64::NAN))
}

fn our_fact(fact: Fact) -> f64 {
    let mesh = catalogue::reference();
    let record = &mesh.laboratory;
    let standard = Strength { force: record.force, deflection: record.deflection };
    let at_standard = laboratory::to_panel(standard, STANDARD_PANEL);
    let ratios = ratios::of_mesh(&mesh);
    let reference = ratios::field_reference(standard, &ratios);
    match fact {
        Fact::StandardPanelForce => to_kn(at_standard.force),
        Fact::StandardPanelDeflection => at_standard.deflection.unwrap_or(f64::NAN),
        Fact::AlphaForce => ratios.force,
        Fact::AlphaDeflection => ratios.deflection,
        Fact::FieldReferenceForce => to_kn(reference.force),
        Fact::FieldReferenceDeflection => reference.deflection.unwrap_or(f64::NAN),
        Fact::MasterCurveEnd => master::force(1.0),
    }
}

/// Factors by which the published relations miss their reference values at the reference point.
pub(crate) fn reference_point_factors() -> (f64, f64) {
    let branch = field::Branch::published(&REFERENCE);
    (field::force_ratio(&REFERENCE, branch), field::deflection_ratio(&REFERENCE, branch))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_printed_number_counts_every_digit() {
        let printed = |t: &str| Printed::try_from(t.to_string());
        let p = printed("0.60").unwrap();
        assert_eq!((p.value(), p.decimals()), (0.6, 2));
        assert!(p.agrees(0.5951) && p.agrees(0.6049) && !p.agrees(0.6051) && !p.agrees(f64::NAN));
        assert!(printed("7").unwrap().agrees(7.2));
        assert!(printed("0,60").is_err() && printed("inf").is_err() && printed("-1").is_err());
    }

    #[test]
    fn everything_printed_comes_out() {
        let validation = validate();
        assert_eq!((validation.tests.len(), validation.facts.len()), (5, 7));
        assert!(validation.agrees(), "{validation:#?}");
        let built: Vec<u32> = validation
            .tests
            .iter()
            .filter(|t| t.test.by_construction)
            .map(|t| t.test.test)
            .collect();
        assert_eq!(built, [4, 5]);
    }

    #[test]
    fn the_reference_point_misses_its_own_values_by_two_known_factors() {
        // By hand: 0.48 + 0.45 and 0.98, the other factors being 1.
        let (force, deflection) = reference_point_factors();
        assert!((force - 0.93).abs() < 1e-12 && (deflection - 0.98).abs() < 1e-12);
    }
}
