//! A mesh from its own tests to forecasts of its own: the laws that fit its tests ([`super::fit::posterior`]),
//! campaigns with the middle one of them, and the methods that their runs give.
//!
//! All of it is kept in a folder as it is made ([`kept`]), so that what was cut off anywhere goes on to the same
//! bytes.

mod kept;

use super::campaign::kept::{Kept, KeptFault};
use super::campaign::{CampaignPlan, Header};
use super::derive::derive;
use super::fit::data::MeshData;
use super::fit::memory::{LawMemory, TriedLaw};
use super::fit::posterior::{Identified, IdentifyOptions, SIMULATIONS, identify_on};
use super::fit::rows::{Ended, FitScene};
use super::fit::say::{Trials, wire};
use crate::dem::Flow;
use crate::layout::Blocks;
use crate::mesh::adopted::{Adopted, AdoptedQuality, KeptMethod, NamedMethods};
use crate::mesh::wire::WireData;
use crate::mesh::{LabRecord, MeshType, STANDARD_PANEL, STANDARD_PUNCH, Statistic};
use crate::problem::Problem;
use crate::study::clock::wall_seconds;
use crate::study::ensemble::EnsembleProgress;
use crate::study::result::rounded;
use crate::units::{from_kn, to_kn};
use crate::words::Choice;
use kept::KeptLaws;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Runs of random layouts in a campaign where nothing is said.
pub(crate) const RUNS: usize = 160;

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
fn quality(data: &MeshData) -> AdoptedQuality {
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

/// What is to be done.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AdoptPlan {
    /// What the mesh is to be called.
    pub(crate) words: MeshWords,
    /// What is known of it.
    pub(crate) data: MeshData,
    /// How its laws are found; the seed, fidelity and threads of the campaigns too.
    pub(crate) options: IdentifyOptions,
    /// Runs of random layouts in a campaign.
    pub(crate) runs: usize,
    /// Arrangements of blocks that get a campaign and a method of their own, beside repeated ones.
    pub(crate) more: Vec<Blocks>,
}

/// How far it is.
pub(crate) enum AdoptStep<'a> {
    /// The laws are sought: which simulation of about how many.
    Laws { scene: &'a FitScene, trial: usize, of: usize },
    /// A campaign runs: the line at which it was begun or gone on with, and how many there are.
    Campaign { blocks: Blocks, from: usize, lines: usize },
}

/// Called with each word of progress, from several threads.
pub(crate) type AdoptTell<'a> = dyn Fn(AdoptStep, EnsembleProgress) -> Flow + Sync + 'a;

/// The mesh, and how it came about.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AdoptedMesh {
    /// As a project takes it: with the laws found, the methods and what they rest on.
    pub(crate) mesh: MeshType,
    /// The laws that fit.
    pub(crate) found: Identified,
    /// Time that the laws took and that the campaigns took, s.
    pub(crate) seconds: [f64; 2],
}

/// Why a mesh is not adopted.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum AdoptFault {
    /// What is wrong with the data.
    Problems(Vec<Problem>),
    /// What is kept, or the disk.
    Kept(KeptFault),
    /// It cannot be done, in a sentence.
    Failed(String),
}

impl From<KeptFault> for AdoptFault {
    fn from(fault: KeptFault) -> AdoptFault {
        AdoptFault::Kept(fault)
    }
}

/// Where an adoption into a project is kept while it is made: beside the project's file.
pub(crate) fn folder(project: &Path, id: &str) -> PathBuf {
    let stem = project.file_stem().unwrap_or_default().to_string_lossy();
    project.with_file_name(format!("{stem}.adopt-{id}"))
}

/// Takes the folder away when the mesh is safe elsewhere. What is not of an adoption stays, and so does the
/// folder then.
pub(crate) fn remove(folder: &Path) {
    let campaigns = Blocks::ALL.iter().map(|blocks| folder.join(blocks.word()));
    let files = [folder.join(kept::NAME)];
    for file in
        files.into_iter().chain(campaigns.clone().map(|c| c.join(super::campaign::file::NAME)))
    {
        // What is not there is gone.
        let _ = std::fs::remove_file(file);
    }
    for folder in campaigns.chain([folder.to_path_buf()]) {
        let _ = std::fs::remove_dir(folder);
    }
}

/// An identifier made of a name: `Acme 6x8, 2.2` becomes `acme-6x8-2.2`; nothing where it has neither letters
/// nor digits.
pub(crate) fn identifier(name: &str) -> Option<String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '.';
    let parts = name.split(|c| !plain(c)).map(|part| part.trim_matches('.'));
    let parts: Vec<String> =
        parts.filter(|part| !part.is_empty()).map(str::to_ascii_lowercase).collect();
    (!parts.is_empty()).then(|| parts.join("-"))
}

impl AdoptPlan {
    fn campaign(&self, blocks: Blocks) -> CampaignPlan {
        CampaignPlan {
            blocks,
            runs: self.runs,
            seed: self.options.seed,
            fidelity: self.options.fidelity,
            ..CampaignPlan::default()
        }
    }

    /// Does it, and keeps it in `folder`. Nothing where it was ended before; the same goes on there. `resume`
    /// says whether it may go on with what is there, and what to say where not.
    ///
    /// # Errors
    /// Why it cannot be done.
    pub(crate) fn adopt(
        &self,
        folder: &Path,
        resume: (bool, &str),
        tell: &AdoptTell,
    ) -> Result<Option<AdoptedMesh>, AdoptFault> {
        let clock = wall_seconds();
        // It stays locked to the end: one program at a time adopts in a folder.
        let mut kept = KeptLaws::open(folder, &self.print(), resume)?;
        let Some(found) = self.laws(&mut kept, tell)? else { return Ok(None) };
        let fitted = wall_seconds() - clock;
        let wire = wire(&found, found.middle(), "the middle one");
        let mut methods = Vec::new();
        for blocks in std::iter::once(&Blocks::Repeated).chain(&self.more) {
            let Some(method) = self.method(*blocks, &wire, folder, tell)? else { return Ok(None) };
            methods.push(method);
        }
        let ran = wall_seconds() - clock - fitted;
        let mesh = mesh(self.words.clone(), &self.data, &found, wire, methods);
        mesh.check().map_err(AdoptFault::Problems)?;
        Ok(Some(AdoptedMesh { mesh, found, seconds: [fitted, ran] }))
    }

    /// All that the laws depend on.
    fn print(&self) -> String {
        let options = IdentifyOptions { threads: 0, ..self.options };
        format!("{:?} {options:?}", self.data)
    }

    /// The laws that fit.
    fn laws(
        &self,
        kept: &mut KeptLaws,
        tell: &AdoptTell,
    ) -> Result<Option<Identified>, AdoptFault> {
        let known = kept.take_known();
        let trials = Mutex::new(Trials::after(known.len()));
        let of = 2 * SIMULATIONS * (self.data.punches.len() + self.data.tensile.len());
        let told = |scene: &FitScene, now: EnsembleProgress| {
            // A lock is only poisoned by a panic, and the count stays whole.
            let trial = trials.lock().unwrap_or_else(PoisonError::into_inner).at(scene, now);
            tell(AdoptStep::Laws { scene, trial, of }, now)
        };
        let mut failed = None;
        let mut keep = |tried: &TriedLaw| match kept.write(tried) {
            Ok(()) => Flow::Continue,
            Err(fault) => {
                failed = Some(fault);
                Flow::Cancel
            }
        };
        let mut memory = LawMemory::new(known, &mut keep);
        let found = identify_on(&self.data, &self.options, &mut memory, &told);
        match (failed, found) {
            (Some(fault), _) => Err(fault.into()),
            (None, Ok(Some(found))) => Ok(Some(found)),
            (None, Ok(None)) => Err(AdoptFault::Failed(NO_LAW.into())),
            (None, Err(Ended::Bad(problems))) => Err(AdoptFault::Problems(problems)),
            (None, Err(Ended::Cancelled)) => Ok(None),
        }
    }

    /// The campaign of an arrangement and the method from it.
    fn method(
        &self,
        blocks: Blocks,
        wire: &WireData,
        folder: &Path,
        tell: &AdoptTell,
    ) -> Result<Option<KeptMethod>, AdoptFault> {
        let plan = self.campaign(blocks);
        let header = Header::new(&plan, &self.words.id, wire);
        let mut kept = Kept::open(&folder.join(blocks.word()), &header, (true, ""))?;
        let (from, lines) = (kept.rows().len(), plan.lines());
        let told = |now| tell(AdoptStep::Campaign { blocks, from, lines }, now);
        if !kept.make(&header, wire, self.options.threads, &told)?.whole {
            return Ok(None);
        }
        let method = derive(&[kept.into_text(header)]).map_err(AdoptFault::Failed)?;
        Ok(Some(KeptMethod::keep(method)))
    }
}

/// What is said where no law fits.
pub(crate) const NO_LAW: &str =
    "no law of the family fits: none can be run, or in none does that bond break first";

/// The mesh that all this makes.
fn mesh(
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
        date: String::new(),
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
