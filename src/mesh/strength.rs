//! Meshes of which only the strength of the net is published, from `assets/strengths.ron`: they say what is missing
//! for a forecast.

use super::Statistic;
use crate::problem::Problem;
use serde::Deserialize;
use std::sync::OnceLock;

const TEXT: &str = include_str!("../../assets/strengths.ron");

/// The strength of a net as a document states it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StrengthRecord {
    /// Identifier; no mesh of the catalogue has the same.
    pub(crate) id: String,
    /// Name for people.
    pub(crate) name: String,
    /// Opening of the mesh, m.
    pub(crate) opening: f64,
    /// Diameter of the wire, m.
    pub(crate) diameter: f64,
    /// Strength along the twists, kN/m.
    pub(crate) along: f64,
    /// Strength across them, kN/m, where it is stated.
    pub(crate) across: Option<f64>,
    /// What the values are.
    pub(crate) kind: Statistic,
    /// Standard of the test.
    pub(crate) standard: String,
    /// When the document appeared.
    pub(crate) date: String,
    /// Where the values stand.
    pub(crate) source: String,
    /// What else the document has and why it does not do.
    pub(crate) missing: String,
}

/// All of them.
pub(crate) fn all() -> &'static [StrengthRecord] {
    static ALL: OnceLock<Vec<StrengthRecord>> = OnceLock::new();
    ALL.get_or_init(|| {
        let options = ron::Options::default()
            .with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        // The text is part of the program; a test loads it, so a broken one is never shipped.
        options.from_str(TEXT).unwrap_or_else(|e| panic!("assets/strengths.ron: {e}"))
    })
}

/// The one of this identifier.
pub(crate) fn find(id: &str) -> Option<&'static StrengthRecord> {
    all().iter().find(|record| record.id == id)
}

impl StrengthRecord {
    /// What is missing for a forecast, and what to do.
    pub(crate) fn problem(&self) -> Problem {
        Problem::new("mesh", "of this mesh only the strength of the net is published: no forecast")
            .value(self.id.clone())
            .advice(
                "missing: force and deflection of its punch test by ISO 17746 or UNI 11437; with them meshcast adopt makes it a mesh of the project",
            )
    }
}

#[cfg(test)]
mod tests {
    use super::super::catalogue;
    use super::*;

    #[test]
    fn every_record_has_kind_standard_date_and_source_and_an_identifier_of_its_own() {
        for record in all() {
            assert!(catalogue::find(&record.id).is_none() && find(&record.id) == Some(record));
            for text in [&record.standard, &record.date, &record.source, &record.missing] {
                assert!(!text.is_empty(), "{record:?}");
            }
            assert!(record.across.is_none_or(|across| across < record.along));
            assert_eq!(record.kind, Statistic::Minimum);
        }
        // Pounds per foot by hand: 3500 x 4.44822 N / 0.3048 m = 51.08 kN/m.
        let zinc = find("astm-a975-8x10-3.05").unwrap();
        assert!((zinc.along - 3.5 * 4.448_22 / 0.3048).abs() < 0.05);
        assert!((zinc.across.unwrap() - 1.8 * 4.448_22 / 0.3048).abs() < 0.05);
    }
}
