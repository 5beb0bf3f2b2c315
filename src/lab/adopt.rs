//! A mesh from its own tests to forecasts of its own: the laws that fit its tests ([`super::fit::posterior`]),
//! a campaign with the middle one of them, and the method that its runs give.

use super::campaign::file::CampaignText;
use super::campaign::make::make;
use super::campaign::row::Row;
use super::campaign::{CampaignPlan, Header};
use super::derive::derive;
use super::fit::data::MeshData;
use super::fit::posterior::Identified;
use crate::dem::Flow;
use crate::mesh::adopted::{Adopted, AdoptedQuality, KeptMethod, NamedMethods};
use crate::mesh::wire::WireData;
use crate::mesh::{LabRecord, MeshType, STANDARD_PANEL, STANDARD_PUNCH, Statistic};
use crate::study::ensemble::EnsembleProgress;
use crate::study::result::rounded;
use crate::units::{from_kn, to_kn};

/// What a mesh is to be called, and what its values are.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeshWords {
    /// Identifier.
    pub(crate) id: String,
    /// Name for people.
    pub(crate) name: String,
    /// Whether its values are made up to show something.
    pub(crate) example: bool,
    /// Mean or characteristic.
    pub(crate) statistic: Statistic,
    /// Standard of its punch test.
    pub(crate) standard: String,
    /// Where its values stand.
    pub(crate) source: String,
}

/// What the law of a mesh rests on.
pub(crate) fn quality(data: &MeshData) -> AdoptedQuality {
    let first = data.punches.first();
    let curve = first.is_some_and(|test| test.curve.is_some());
    if curve || data.punches.len() > 1 || !data.tensile.is_empty() {
        AdoptedQuality::TwoTests
    } else if first.is_some_and(|test| test.deflection.is_some()) {
        AdoptedQuality::OneTestAndPrior
    } else {
        AdoptedQuality::ForceOnly
    }
}

/// Runs the campaign of a mesh and derives its method; nothing where it was ended before.
///
/// # Errors
/// Runs that say too little, in a sentence.
pub(crate) fn method(
    id: &str,
    wire: &WireData,
    plan: &CampaignPlan,
    threads: usize,
    progress: &(dyn Fn(EnsembleProgress) -> Flow + Sync),
) -> Result<Option<KeptMethod>, String> {
    let mut rows: Vec<Row> = Vec::with_capacity(plan.lines());
    let end = make(plan, wire, 0, threads, progress, &mut |row| {
        rows.push(row);
        Flow::Continue
    });
    if !end.whole {
        return Ok(None);
    }
    let campaign = CampaignText { header: Header::new(plan, id, wire), rows, whole: 0 };
    derive(&[campaign]).map(|method| Some(KeptMethod::keep(method)))
}

/// The mesh that all this makes.
pub(crate) fn mesh(
    words: MeshWords,
    data: &MeshData,
    found: &Identified,
    wire: WireData,
    methods: Vec<KeptMethod>,
) -> MeshType {
    let [low, middle, high] = found.anchored[0].map(|force| from_kn(rounded(to_kn(force))));
    let laboratory = record(&words, data, &methods);
    MeshType {
        id: words.id,
        name: words.name,
        reference: false,
        example: words.example,
        laboratory,
        ratios: None,
        wire: Some(wire),
        adopted: Some(Adopted { quality: quality(data), low, middle, high, methods }),
        methods: NamedMethods::default(),
    }
}

/// The record of the first test, if it can be converted to the standard one; else what the law gives there.
fn record(words: &MeshWords, data: &MeshData, methods: &[KeptMethod]) -> LabRecord {
    let test = &data.punches[0];
    let plain = LabRecord {
        force: test.force,
        deflection: test.deflection,
        statistic: words.statistic,
        panel: test.panel,
        punch: test.punch,
        standard: words.standard.clone(),
        source: words.source.clone(),
    };
    match methods.first() {
        Some(KeptMethod(method)) if test.punch != STANDARD_PUNCH => LabRecord {
            force: method.laboratory.force,
            deflection: Some(method.laboratory.deflection),
            panel: STANDARD_PANEL,
            punch: STANDARD_PUNCH,
            standard: String::new(),
            source: format!("simulated standard test with the law that fits: {}", words.source),
            ..plain
        },
        _ => plain,
    }
}
