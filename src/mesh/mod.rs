//! Mesh types: what a mesh is, its laboratory punch test, its own laboratory-to-field ratios if it
//! has any, and the wire data that the discrete element check needs.
//!
//! - [`MeshType`] and its parts: this file.
//! - [`adopted`]: what a mesh carries that was adopted from its own tests.
//! - [`catalogue`]: the mesh types shipped in `assets/meshes.ron`.
//! - [`strength`]: meshes of which only the strength of the net is published.
//! - [`laws`]: wire laws with a name, for comparing solvers and for starting a calibration.
//! - [`wire`]: the net's geometry and the stress-strain curves of its wires.

pub mod adopted;
pub mod catalogue;
pub mod laws;
pub(crate) mod strength;
pub mod wire;

use crate::problem::Problem;
use crate::units::{self, shortest, to_kn};
use crate::words::{Choice, shown};
use serde::{Deserialize, Serialize};

/// Identifier of the reference mesh, the one the paper's relations were made with.
pub const REFERENCE_ID: &str = "dt-8x10-2.7";

/// Side of the standard laboratory panel, L^l, m (ISO 17745, ISO 17746, UNI 11437).
pub(crate) const STANDARD_PANEL: f64 = 3.0;
/// Diameter of the standard laboratory punch, D^l, m (ISO 17745, ISO 17746, UNI 11437).
pub(crate) const STANDARD_PUNCH: f64 = 1.0;

/// A mesh type: all the forecast and the check need to know of a mesh.
///
/// In files forces are kN and lengths m; in memory both are SI.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshType {
    /// Short identifier, by which layouts and the command line name the mesh.
    pub id: String,
    /// Name for people.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Whether this is the double-twist mesh of 80 mm opening and 2.7 mm wire on which the paper's
    /// relations rest. Any other mesh that uses the default ratios gets a warning.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub reference: bool,
    /// Whether this is an example to show the format, not a product's values.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub example: bool,
    /// The laboratory punch test.
    pub laboratory: LabRecord,
    /// The mesh's own laboratory-to-field ratios; the default ones are used where this is missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratios: Option<RatioRecord>,
    /// Net and wires for the discrete element check; without it only the forecast is possible.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wire: Option<wire::WireData>,
    /// What `meshcast adopt` found, where the mesh was adopted from its own tests.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adopted: Option<adopted::Adopted>,
    /// Methods that the project names by file; they go before those of an adopted mesh.
    #[serde(skip)]
    pub methods: adopted::NamedMethods,
}

/// Result of a laboratory punch test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LabRecord {
    /// Largest punching force F_l, N (kN in files), above 0.
    #[serde(with = "units::file::force")]
    pub force: f64,
    /// Deflection at failure delta_l, m, above 0; missing where only the force was published: then there
    /// are forces and no curve.
    #[serde(with = "units::file::maybe_length", default, skip_serializing_if = "Option::is_none")]
    pub deflection: Option<f64>,
    /// Whether the two values are means, characteristic or least values.
    pub statistic: Statistic,
    /// Side of the square test panel, m; the standard one is 3.0 m.
    #[serde(with = "units::file::length", default = "standard_panel")]
    pub panel: f64,
    /// Diameter of the punch, m; only the standard 1.0 m can be used (the paper gives no relation for others).
    #[serde(with = "units::file::length", default = "standard_punch")]
    pub punch: f64,
    /// Standard the test followed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub standard: String,
    /// When the document of the values appeared: a year, or a day as 2021-05-31.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub date: String,
    /// Where the values were published.
    pub source: String,
}

/// Whether laboratory values are means of a series, characteristic or least values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Statistic {
    /// Mean of a series, or a single (simulated) test.
    #[serde(alias = "mean")]
    Mean,
    /// Characteristic value (a low fractile), as a product standard declares it.
    #[serde(alias = "characteristic")]
    Characteristic,
    /// Least value that every piece must reach, as a product standard demands it.
    #[serde(alias = "minimum")]
    Minimum,
}

impl Choice for Statistic {
    const ALL: &'static [Statistic] =
        &[Statistic::Mean, Statistic::Characteristic, Statistic::Minimum];

    /// The word for people: `mean`, `characteristic` or `minimum`.
    fn word(self) -> &'static str {
        match self {
            Statistic::Mean => "mean",
            Statistic::Characteristic => "characteristic",
            Statistic::Minimum => "minimum",
        }
    }
}

impl Statistic {
    /// A short word for a narrow column: `mean`, `char` or `min`.
    pub(crate) fn short(self) -> &'static str {
        match self {
            Statistic::Mean => "mean",
            Statistic::Characteristic => "char",
            Statistic::Minimum => "min",
        }
    }
}

/// A mesh's own laboratory-to-field ratios.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RatioRecord {
    /// alpha_F = F_a*/F_l*, above 0.
    #[serde(with = "units::file::number")]
    pub force: f64,
    /// alpha_delta = delta_a*/delta_l*, above 0.
    #[serde(with = "units::file::number")]
    pub deflection: f64,
    /// Where the ratios were published.
    pub source: String,
}

fn standard_panel() -> f64 {
    STANDARD_PANEL
}

fn standard_punch() -> f64 {
    STANDARD_PUNCH
}

/// Largest laboratory force taken as sensible, N.
pub(crate) const LARGEST_FORCE: f64 = 1.0e7;
/// Largest laboratory deflection taken as sensible, m.
pub(crate) const LARGEST_DEFLECTION: f64 = 10.0;
/// Largest laboratory panel taken as sensible, m.
const LARGEST_PANEL: f64 = 20.0;

impl LabRecord {
    /// Whether another record is of another standard: both name some, and none is the same.
    pub(crate) fn of_another_standard(&self, other: &LabRecord) -> bool {
        let names = |record: &LabRecord| -> Vec<String> {
            let parts = record.standard.split([',', ';']).map(|part| part.trim().to_lowercase());
            parts.filter(|part| !part.is_empty()).collect()
        };
        let (ours, theirs) = (names(self), names(other));
        !ours.is_empty() && !theirs.is_empty() && !ours.iter().any(|name| theirs.contains(name))
    }

    /// What is wrong with its punch, if it is not the standard one.
    pub(crate) fn punch_problem(&self) -> Option<Problem> {
        (self.punch != STANDARD_PUNCH).then(|| {
            Problem::new("laboratory.punch", "a test with another punch cannot be converted")
                .value(format!("{} m", shortest(self.punch)))
                .allowed("1.0 m only")
                .advice("the published relations convert the panel size, not the punch")
        })
    }
}

impl MeshType {
    /// The name for people, or the identifier where there is none.
    pub(crate) fn title(&self) -> &str {
        if self.name.is_empty() { &self.id } else { &self.name }
    }

    /// Checks every value against its range.
    ///
    /// # Errors
    /// Every field that is wrong, by its path inside the mesh (`laboratory.force`).
    pub(crate) fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        if self.id.trim().is_empty() || !self.id.chars().all(|c| shown(c) && !c.is_whitespace()) {
            problems.push(
                Problem::new("id", "a mesh needs an identifier")
                    .value(format!("{:?}", self.id))
                    .allowed("letters, digits and signs without spaces"),
            );
        }
        let lab = &self.laboratory;
        let ratios = self.ratios.as_ref().map(|r| ("ratios.source", &r.source));
        let texts = [
            ("name", &self.name),
            ("laboratory.standard", &lab.standard),
            ("laboratory.date", &lab.date),
            ("laboratory.source", &lab.source),
        ];
        problems
            .extend(texts.into_iter().chain(ratios).filter_map(|(f, t)| Problem::of_text(f, t)));
        let mut number = |field: &str, value: f64, shown: String, max: f64, range: &str| {
            if !(value.is_finite() && value > 0.0 && value <= max) {
                problems.push(
                    Problem::new(field, "the value is outside what makes sense")
                        .value(shown)
                        .allowed(range),
                );
            }
        };
        let kn = |v: f64| format!("{} kN", shortest(to_kn(v)));
        let m = |v: f64| format!("{} m", shortest(v));
        number(
            "laboratory.force",
            lab.force,
            kn(lab.force),
            LARGEST_FORCE,
            "above 0, up to 10000 kN",
        );
        if let Some(deflection) = lab.deflection {
            let range = "above 0, up to 10 m";
            number("laboratory.deflection", deflection, m(deflection), LARGEST_DEFLECTION, range);
        }
        number("laboratory.panel", lab.panel, m(lab.panel), LARGEST_PANEL, "above 0, up to 20 m");
        if let Some(r) = &self.ratios {
            number("ratios.force", r.force, shortest(r.force), 10.0, "above 0, up to 10");
            number(
                "ratios.deflection",
                r.deflection,
                shortest(r.deflection),
                10.0,
                "above 0, up to 10",
            );
        }
        if lab.panel.is_finite() && lab.panel > 0.0 && lab.punch >= lab.panel {
            problems.push(
                Problem::new("laboratory.panel", "no punch fits into a panel of its own size")
                    .value(m(lab.panel))
                    .allowed(format!("above the punch of {}", m(lab.punch))),
            );
        }
        problems.extend(lab.punch_problem());
        problems.extend(self.adopted.as_ref().and_then(adopted::Adopted::problem));
        if let Some(wire) = &self.wire
            && let Err(found) = wire.check()
        {
            problems.extend(found.into_iter().map(|p| p.under("wire")));
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }
}
