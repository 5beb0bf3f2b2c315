//! A campaign: many single runs of layouts drawn at random, from which a method is derived.
//!
//! The paper ran more than 300 simulations of random d, L and D to get its master curve. Here a campaign
//! draws them uniform in its ranges, and for a stated share of the runs an offset too:
//!
//! - this file: what is asked for, and what run k is; [`row`]: what is kept of a run; [`make`]: making the
//!   runs; [`mod@file`]: the text of a campaign's file; [`kept`]: the file on disk, and how it goes on.
//!
//! Everything about run k is drawn from (seed, k), so that it is the same whatever is made before it, on
//! however many threads. An eccentric run has a layout of its own too: that it had the alignment and slack of
//! a centred one was tried, and their scatter has next to nothing in common (correlation 0.2 over 530 pairs), so
//! that a quotient of two runs would only scatter more.

pub(crate) mod file;
pub(crate) mod kept;
pub(crate) mod make;
pub(crate) mod row;

use crate::dem::hash::{hash, uniform};
use crate::dem::{Arrangement, Fidelity, SceneSpec, Test};
use crate::forecast::warning::{PLATE, PUNCH, SPACING};
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::mesh::wire::WireData;
use crate::mesh::{STANDARD_PANEL, STANDARD_PUNCH};
use crate::study::result::Revisions;
use row::Kind;
use serde::{Deserialize, Serialize};

/// Cells in a direction around a single block: the fewest that a check of one tries. More cost more than a
/// campaign is worth.
const SINGLE_CELLS: usize = 3;

/// Laboratory runs, and as many of the reference panel, for each run of a random layout.
const BESIDE: f64 = 0.1;
/// The fewest of either.
const FEWEST_BESIDE: usize = 2;

/// Fewest runs of random layouts that a method can be derived from, with the default share of eccentric ones.
pub(crate) const FEWEST_FOR_METHOD: usize = 60;

/// Deflection at which runs are expected to break until one has, m.
pub(crate) const EXPECTED_BREAK: f64 = 0.6;

/// The paper's ranges of d, L and D, m.
pub(crate) const PAPER_RANGES: [[f64; 2]; 3] =
    [[PLATE.min, PLATE.max], [SPACING.min, SPACING.max], [PUNCH.min, PUNCH.max]];

/// What a campaign is asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct CampaignPlan {
    /// How the blocks of the cells stand: repeated, mirrored or single.
    pub(crate) blocks: Blocks,
    /// Runs of random layouts.
    pub(crate) runs: usize,
    /// Share of them that are eccentric, 0 to 0.9.
    pub(crate) eccentric: f64,
    /// Seed of all that is drawn.
    pub(crate) seed: u64,
    /// How exactly each run is computed.
    pub(crate) fidelity: Fidelity,
    /// Ranges of d, L and D, m.
    pub(crate) ranges: [[f64; 2]; 3],
}

impl Default for CampaignPlan {
    fn default() -> Self {
        CampaignPlan {
            blocks: Blocks::Repeated,
            runs: 320,
            eccentric: 0.5,
            seed: 0,
            fidelity: Fidelity::Quick,
            ranges: PAPER_RANGES,
        }
    }
}

/// The first line of a campaign's file: all that decides the lines below it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Header {
    /// What this is, and the form of the lines.
    pub(crate) campaign: u32,
    /// Identifier of the mesh.
    pub(crate) mesh: String,
    /// Print of its net and wires.
    pub(crate) wires: String,
    /// Revisions of solver and sampling.
    pub(crate) revisions: String,
    /// What was asked for.
    #[serde(flatten)]
    pub(crate) plan: CampaignPlan,
}

/// Form of the lines, and of how runs are drawn.
const FORM: u32 = 1;

impl Header {
    /// Of a campaign with a mesh's wires by this program.
    pub(crate) fn new(plan: &CampaignPlan, mesh: &str, wire: &WireData) -> Header {
        Header {
            campaign: FORM,
            mesh: mesh.to_string(),
            wires: wire.print().to_string(),
            revisions: Revisions::CURRENT.to_string(),
            plan: plan.clone(),
        }
    }

    /// What another header has otherwise, in words; nothing where they are the same.
    pub(crate) fn differs(&self, other: &Header) -> Option<String> {
        let words = |h: &Header| {
            [
                ("form", h.campaign.to_string()),
                ("mesh", h.mesh.clone()),
                ("wires", h.wires.clone()),
                ("revisions", h.revisions.clone()),
                ("blocks", format!("{:?}", h.plan.blocks).to_lowercase()),
                ("runs", h.plan.runs.to_string()),
                ("eccentric", h.plan.eccentric.to_string()),
                ("seed", h.plan.seed.to_string()),
                ("fidelity", format!("{:?}", h.plan.fidelity).to_lowercase()),
                ("ranges", format!("{:?}", h.plan.ranges)),
            ]
        };
        let pairs = words(self).into_iter().zip(words(other));
        let said: Vec<String> = pairs
            .filter(|((_, mine), (_, theirs))| mine != theirs)
            .map(|((name, mine), (_, theirs))| format!("{name} {mine} and not {theirs}"))
            .collect();
        (!said.is_empty()).then(|| said.join(", "))
    }
}

/// What run k is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    pub(crate) kind: Kind,
    pub(crate) layout: Layout,
    pub(crate) seed: u64,
    pub(crate) phase: [f64; 2],
}

impl CampaignPlan {
    /// Laboratory runs, and as many of the reference panel.
    pub(crate) fn beside(&self) -> usize {
        ((BESIDE * self.runs as f64).ceil() as usize).max(FEWEST_BESIDE)
    }

    /// Lines of the whole campaign: laboratory, reference panel, random layouts.
    pub(crate) fn lines(&self) -> usize {
        2 * self.beside() + self.runs
    }

    /// Run k, counted through from the first laboratory one.
    pub(crate) fn sample(&self, k: usize) -> Sample {
        let beside = self.beside();
        let drawn = |kind, layout, k: usize| {
            let seed = hash(self.seed, k as u64);
            Sample { kind, layout, seed, phase: [draw(seed, 0), draw(seed, 1)] }
        };
        let reference = Layout { blocks: self.blocks, ..REFERENCE };
        if k < beside {
            let layout = Layout { spacing: STANDARD_PANEL, punch: STANDARD_PUNCH, ..reference };
            return drawn(Kind::Laboratory, layout, k);
        }
        if k < 2 * beside {
            return drawn(Kind::Reference, reference, k);
        }
        let own = hash(self.seed, k as u64);
        let [plate, spacing, punch] = [0, 1, 2].map(|n| {
            let [from, to] = self.ranges[n];
            from + (to - from) * draw(own, 2 + n as u64)
        });
        let layout = Layout { plate, spacing, punch, ..reference };
        // As often as the share says, spread evenly.
        let due = |m: usize| (m as f64 * self.eccentric).floor();
        let m = k - 2 * beside;
        if due(m + 1) > due(m) {
            let [ex, ey] = [5, 6].map(|n| (draw(own, n) - 0.5) * spacing);
            return drawn(Kind::Eccentric, Layout { ex, ey, ..layout }, k);
        }
        drawn(Kind::Centred, layout, k)
    }
}

/// Draw n of a run; far beyond any bond's number, so that slack and all else are unrelated.
fn draw(seed: u64, n: u64) -> f64 {
    uniform(seed, u64::MAX - n)
}

impl Sample {
    /// Its scene with these wires.
    pub(crate) fn scene(&self, wire: &WireData) -> SceneSpec {
        let arrangement = match (self.kind, self.layout.blocks) {
            (Kind::Eccentric, Blocks::Mirrored) => Arrangement::Mirrored,
            (Kind::Laboratory, _) => Arrangement::default(),
            (_, Blocks::Single) => Arrangement::Single(SINGLE_CELLS),
            _ => Arrangement::default(),
        };
        let laboratory = self.kind == Kind::Laboratory;
        SceneSpec {
            layout: self.layout,
            test: if laboratory { Test::Laboratory } else { Test::Anchored },
            wire: wire.clone(),
            phase: self.phase,
            seed: self.seed,
            arrangement,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::derived::{Arranged, shipped};
    use crate::mesh::catalogue;
    use crate::mesh::laws;

    #[test]
    fn runs_lie_in_the_ranges_and_the_stated_share_is_eccentric() {
        for (eccentric, due) in [(0.0, 0), (0.25, 50), (0.5, 100)] {
            let plan = CampaignPlan { runs: 200, eccentric, ..CampaignPlan::default() };
            assert_eq!((plan.beside(), plan.lines()), (20, 240));
            let all: Vec<Sample> = (0..plan.lines()).map(|k| plan.sample(k)).collect();
            let of = |kind| all.iter().filter(|s| s.kind == kind).count();
            assert_eq!(of(Kind::Laboratory), 20);
            assert_eq!((of(Kind::Eccentric), of(Kind::Centred)), (due, 200 - due));
            for s in &all[40..] {
                let sizes = [s.layout.plate, s.layout.spacing, s.layout.punch];
                for (size, [from, to]) in sizes.iter().zip(PAPER_RANGES) {
                    assert!((from..to).contains(size), "{s:?}");
                }
            }
            // The mean of 200 uniform draws of L, 1.25 to 4.5, within four standard errors.
            let mean = all[40..].iter().map(|s| s.layout.spacing).sum::<f64>() / 200.0;
            assert!((mean - 2.875).abs() < 4.0 * 3.25 / (12.0_f64 * 100.0).sqrt(), "{mean}");
        }
    }

    #[test]
    fn offsets_are_spread_over_the_cell() {
        let plan = CampaignPlan { runs: 800, ..CampaignPlan::default() };
        let all: Vec<Sample> = (0..plan.lines()).map(|k| plan.sample(k)).collect();
        let parts: Vec<f64> = all
            .iter()
            .filter(|s| s.kind == Kind::Eccentric)
            .flat_map(|s| [s.layout.ex, s.layout.ey].map(|e| e / s.layout.spacing))
            .collect();
        assert!(parts.len() == 800 && parts.iter().all(|e| e.abs() <= 0.5));
        // Uniform on a length of 1: variance 1/12, known to about 0.0026 from 800.
        let variance = parts.iter().map(|e| e * e).sum::<f64>() / 800.0;
        assert!((variance - 1.0 / 12.0).abs() < 0.011, "{variance}");
        assert!(all.iter().all(|s| s.kind == Kind::Eccentric || s.layout.ex == 0.0));
    }

    #[test]
    fn the_shipped_methods_are_of_the_wires_of_the_catalogue() {
        // A change of the wires makes every run another one: the campaigns have to be run again.
        let mesh = catalogue::reference();
        let now = mesh.wire.as_ref().unwrap().print().to_string();
        for of in [Arranged::Repeated, Arranged::Mirrored] {
            let method = shipped(of);
            assert_eq!(
                (method.mesh.as_str(), method.wires.as_str()),
                (mesh.id.as_str(), now.as_str())
            );
        }
    }

    #[test]
    fn a_header_says_what_another_one_has_otherwise() {
        let wire = laws::bench();
        let plan = CampaignPlan::default();
        let one = Header::new(&plan, "m", &wire);
        assert_eq!(one.differs(&one.clone()), None);
        let other = Header::new(&CampaignPlan { seed: 3, runs: 9, ..plan }, "m", &laws::yade());
        let said = one.differs(&other).unwrap();
        assert!(said.contains("seed 0 and not 3") && said.contains("runs 320 and not 9"), "{said}");
        assert!(said.contains("wires") && !said.contains("mesh"), "{said}");
        let text = serde_json::to_string(&one).unwrap();
        assert_eq!(serde_json::from_str::<Header>(&text).unwrap(), one);
    }
}
