//! The paper's figures and tables from our own simulations, each value beside the paper's.
//!
//! What is lost of the paper's pictures has no value to compare with; what its text says of them has. A
//! difference is "not explained" unless a run here shows where it comes from.
//!
//! - this file: what is made; [`scenes`]: the ensembles; [`rows`]: values beside the paper's;
//!   [`mean`]: mean curves of a campaign's runs.

mod mean;
mod rows;
pub(crate) mod scenes;

use super::campaign::file::CampaignText;
use super::campaign::make::make;
use super::campaign::row::{Kind, Row};
use super::campaign::{CampaignPlan, Header};
use super::derive::derive;
use super::paper::PaperStanding;
use crate::curve::Curve;
use crate::dem::{Fidelity, Flow};
use crate::forecast::published::PublishedTest;
use crate::layout::{Layout, REFERENCE};
use crate::mesh::MeshType;
use crate::method::DerivedMethod;
use crate::problem::Problem;
use crate::study::ensemble::EnsembleProgress;
use crate::study::result::make::wires;

/// Differences that need no explanation, as a part: force, deflection and all else.
const CLOSE: f64 = 0.05;

/// D/L from which on the paper finds the laboratory's deflection constant over D (section 3).
pub(crate) const THRESHOLD: f64 = 0.4;

/// How it is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ReproducePlan {
    /// Runs of random layouts.
    pub(crate) runs: usize,
    /// Runs of a point of a laboratory series, and of an anchored test.
    pub(crate) beside: [usize; 2],
    /// Takes every so many of the sizes of a laboratory series, from the first on.
    pub(crate) every: usize,
    /// Seed of all runs.
    pub(crate) seed: u64,
    /// How exactly they compute.
    pub(crate) fidelity: Fidelity,
    /// Threads, at least 1; the result does not depend on them.
    pub(crate) threads: usize,
}

/// A value of the paper beside ours, in the unit that `words` says.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Compared {
    /// The figure or table.
    pub(crate) place: &'static str,
    /// What is compared.
    pub(crate) words: String,
    /// The paper's.
    pub(crate) paper: f64,
    pub(crate) ours: f64,
    /// What our law and methods have seen of it.
    pub(crate) standing: PaperStanding,
    /// What explains a difference; empty where nothing does.
    pub(crate) explained: &'static str,
}

impl Compared {
    /// Ours over the paper's, less 1.
    pub(crate) fn difference(&self) -> f64 {
        self.ours / self.paper - 1.0
    }

    /// What is said of the difference.
    pub(crate) fn remark(&self) -> &'static str {
        if self.difference().abs() <= CLOSE {
            ""
        } else if self.explained.is_empty() {
            "not explained"
        } else {
            self.explained
        }
    }
}

/// The mean curve of some runs, which ends at their mean first break, and between which forces 90 % of them
/// lie at its points, N.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct MeanCurve {
    pub(crate) curve: Curve,
    pub(crate) band: [Vec<f64>; 2],
}

/// A point of a laboratory series: block or panel, m, mean force, N, deflection, m, k75, N/m, and mean curve.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SeriesPoint {
    pub(crate) size: f64,
    pub(crate) force: f64,
    pub(crate) deflection: f64,
    pub(crate) k75: f64,
    pub(crate) curve: Curve,
}

/// A row of Table 1 simulated: how the blocks stood, in a word, and the mean curve.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SimulatedTest {
    pub(crate) test: &'static PublishedTest,
    pub(crate) by: Vec<(&'static str, MeanCurve)>,
}

/// All that was made.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Reproduced {
    /// The values.
    pub(crate) rows: Vec<Compared>,
    /// Laboratory tests over D at L = 3 m.
    pub(crate) over_block: Vec<SeriesPoint>,
    /// Laboratory tests over L at D = 1 m.
    pub(crate) over_panel: Vec<SeriesPoint>,
    /// The laboratory test and the anchored reference panel.
    pub(crate) star: [MeanCurve; 2],
    /// Table 1.
    pub(crate) tests: Vec<SimulatedTest>,
    /// What the campaign gave.
    pub(crate) method: DerivedMethod,
    /// Whether the force rises with every step of D.
    pub(crate) rising: bool,
    /// How many of the envelope's inner points hold Eq. 3.
    pub(crate) held: [usize; 2],
}

/// What is told on the way: the part, its number, how many there are, and the runs' progress.
pub(crate) type Tell<'a> = dyn Fn(&str, usize, usize, EnsembleProgress) -> Flow + Sync + 'a;

/// Parts that are told apart.
const PARTS: usize = 5;

/// Makes everything. Nothing where it was ended early.
///
/// # Errors
/// What is wrong with the mesh's wires, or a campaign that says nothing.
pub(crate) fn reproduce(
    plan: &ReproducePlan,
    mesh: &MeshType,
    tell: &Tell,
) -> Result<Option<Reproduced>, Vec<Problem>> {
    let Some(made) = campaign(plan, mesh, tell)? else { return Ok(None) };
    let star = [Kind::Laboratory, Kind::Reference].map(|kind| mean::curve(&made.rows, kind));
    let method = derive(&[made]).map_err(|said| vec![Problem::new("campaign", said)])?;

    let scenes = scenes::Scenes { plan, mesh, tell };
    let blocks = (1..=25).map(|k| f64::from(k) / 10.0);
    let panels = (8..=18).map(|k| f64::from(k) / 4.0);
    let by_block = |punch| Layout { punch, ..REFERENCE };
    let by_panel = |spacing| Layout { spacing, ..REFERENCE };
    let Some(over_block) = scenes.series("laboratory over D", 1, blocks, by_block)? else {
        return Ok(None);
    };
    let Some(over_panel) = scenes.series("laboratory over L", 2, panels, by_panel)? else {
        return Ok(None);
    };
    let Some(tests) = scenes.tests()? else { return Ok(None) };
    let Some(facing) = scenes.facing(&method)? else { return Ok(None) };
    let mut rows = rows::laboratory(&over_panel);
    rows.push(rows::threshold(&over_block));
    rows.extend(rows::method(&method));
    rows.extend(rows::offsets(&method, &facing));
    rows.extend(tests.iter().flat_map(rows::test));
    Ok(Some(Reproduced {
        rising: over_block.windows(2).all(|w| w[1].force > w[0].force),
        held: rows::held(&method),
        rows,
        over_block,
        over_panel,
        star,
        tests,
        method,
    }))
}

/// The random layouts.
fn campaign(
    plan: &ReproducePlan,
    mesh: &MeshType,
    tell: &Tell,
) -> Result<Option<CampaignText>, Vec<Problem>> {
    let wire = wires(mesh)?;
    let asked = CampaignPlan {
        runs: plan.runs,
        seed: plan.seed,
        fidelity: plan.fidelity,
        ..CampaignPlan::default()
    };
    let mut rows: Vec<Row> = Vec::new();
    let mut take = |row| {
        rows.push(row);
        Flow::Continue
    };
    let told = |now| tell("campaign", 0, PARTS, now);
    if !make(&asked, wire, 0, plan.threads, &told, &mut take).whole {
        return Ok(None);
    }
    let header = Header::new(&asked, &mesh.id, wire);
    Ok(Some(CampaignText { header, rows, whole: 0 }))
}
