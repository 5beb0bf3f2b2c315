//! The forecast held against checks of layouts that no fit has seen, by the derived method and by the published.

use super::campaign::{CampaignPlan, PAPER_RANGES};
use crate::dem::{Fidelity, Flow};
use crate::forecast::derived::{Arranged, shipped};
use crate::forecast::{NoField, forecast};
use crate::layout::{Blocks, BranchRule, Layout, MethodChoice};
use crate::mesh::MeshType;
use crate::problem::{Problem, summary};
use crate::study::ensemble::quantile;
use crate::study::result::Wanted;
use crate::study::result::make::{Told, make};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

/// D that tells small blocks from others, m.
pub(crate) const SMALL: f64 = 0.4;

/// Aims for the middle 80 % of check over derived forecast.
pub(crate) const AIMS: [[f64; 2]; 2] = [[0.93, 1.07], [0.90, 1.12]];

/// How the comparison is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HeldOutPlan {
    /// Layouts that are drawn.
    pub(crate) layouts: usize,
    /// How their blocks stand: repeated or mirrored.
    pub(crate) blocks: Blocks,
    /// Seed of the layouts, alignments and slack.
    pub(crate) seed: u64,
    /// How exactly the checks compute.
    pub(crate) fidelity: Fidelity,
    /// Part by which the ranges of d, L and D are wider than the paper's.
    pub(crate) widen: f64,
    /// Whether blocks are below [`SMALL`] only.
    pub(crate) small: bool,
    /// Threads, at least 1; the result does not depend on them.
    pub(crate) threads: usize,
}

/// A layout: check over forecast, force and deflection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HeldOutLayout {
    pub(crate) layout: Layout,
    /// Mean force of the check, N, and deflection, m.
    pub(crate) check: [f64; 2],
    /// Standard error of the mean force over it, and standard deviation of a single run.
    pub(crate) error: [f64; 2],
    /// Over the derived forecast.
    pub(crate) derived: [f64; 2],
    /// Over the published one.
    pub(crate) published: [f64; 2],
}

/// All of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct HeldOutTable {
    /// The layouts that have both.
    pub(crate) layouts: Vec<HeldOutLayout>,
    /// Why others have not, and how many.
    pub(crate) left_out: BTreeMap<String, usize>,
    /// Layouts that were drawn so far.
    pub(crate) drawn: usize,
    /// Whether it was ended early.
    pub(crate) part: bool,
}

/// 10, 50 and 90 % points of check over forecast, by one method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Points {
    pub(crate) force: [f64; 3],
    pub(crate) deflection: [f64; 3],
}

/// A part of the layouts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HeldOutPart {
    /// Which.
    pub(crate) words: String,
    /// How many.
    pub(crate) n: usize,
    /// Derived and published.
    pub(crate) points: [Points; 2],
    /// Median and 90 % point of the standard error of a check's mean force, over it, and of the standard
    /// deviation of a single run: alignment and slack of one layout.
    pub(crate) errors: [[f64; 2]; 2],
}

/// Draws layouts and checks them. Ended by `tell`, which gets the number of the layout and the check's news.
///
/// # Errors
/// A seed that is in the method's campaigns, or a mesh without wires.
pub(crate) fn held_out(
    plan: &HeldOutPlan,
    mesh: &MeshType,
    tell: &(dyn Fn(usize, Told) -> Flow + Sync),
) -> Result<HeldOutTable, Vec<Problem>> {
    let of = if plan.blocks == Blocks::Mirrored { Arranged::Mirrored } else { Arranged::Repeated };
    if shipped(of).campaigns.iter().any(|c| c.seed == plan.seed) {
        return Err(vec![
            Problem::new("--seed", "the method was made from runs of this seed")
                .value(plan.seed.to_string()),
        ]);
    }
    let wider = 1.0 + plan.widen;
    let mut ranges = PAPER_RANGES.map(|[from, to]| [from / wider, to * wider]);
    if plan.small {
        ranges[2][1] = SMALL;
    }
    let drawing = CampaignPlan {
        blocks: plan.blocks,
        runs: plan.layouts,
        seed: plan.seed,
        fidelity: plan.fidelity,
        ranges,
        ..CampaignPlan::default()
    };
    let mut table = HeldOutTable::default();
    let first = 2 * drawing.beside();
    for k in first..drawing.lines() {
        let sample = drawing.sample(k);
        let cancelled = AtomicBool::new(false);
        let told = |told: Told| {
            let answer = tell(k - first, told);
            cancelled.fetch_or(answer == Flow::Cancel, Ordering::Relaxed);
            answer
        };
        let one = layout(&sample.layout, mesh, plan, sample.seed, &told);
        if cancelled.into_inner() {
            table.part = true;
            return Ok(table);
        }
        table.drawn += 1;
        match one {
            Ok(found) => table.layouts.push(found),
            Err(why) => *table.left_out.entry(why).or_insert(0) += 1,
        }
    }
    Ok(table)
}

/// One layout by check and both forecasts, or why not.
fn layout(
    layout: &Layout,
    mesh: &MeshType,
    plan: &HeldOutPlan,
    seed: u64,
    tell: &(dyn Fn(Told) -> Flow + Sync),
) -> Result<HeldOutLayout, String> {
    let by = |method: MethodChoice| {
        let layout = Layout { method, ..*layout };
        forecast(&layout, mesh, BranchRule::Published)
            .map_err(|_| "block larger than the spacing".to_string())?
            .field
            .map(|field| [field.values.force, field.values.deflection.unwrap_or(f64::NAN)])
            .map_err(|why: NoField| why.short().to_string())
    };
    let [derived, published] = [by(MethodChoice::Derived)?, by(MethodChoice::Published)?];
    let wanted = Wanted { fidelity: plan.fidelity.into(), runs: None, seed };
    let made = make(layout, mesh, &wanted, plan.threads, tell).map_err(|e| summary(&e))?.result;
    if !made.broke() {
        return Err("no run broke a wire".into());
    }
    let check = [made.force.mean, made.deflection.mean];
    let over = |forecast: [f64; 2]| [check[0] / forecast[0], check[1] / forecast[1]];
    let error = [made.force.error, made.force.deviation].map(|v| v / made.force.mean);
    let [derived, published] = [derived, published].map(over);
    Ok(HeldOutLayout { layout: *layout, check, error, derived, published })
}

impl HeldOutTable {
    /// The parts that are told apart: centred and with an offset, small blocks and others, and both.
    pub(crate) fn parts(&self) -> Vec<HeldOutPart> {
        let mut parts = Vec::new();
        for (offset, words) in [(false, "centred"), (true, "with an offset")] {
            for (size, small) in
                [("", None), (", D below 0.4 m", Some(true)), (", D from 0.4 m", Some(false))]
            {
                let mine = |l: &&HeldOutLayout| {
                    let is_offset = (l.layout.ex, l.layout.ey) != (0.0, 0.0);
                    is_offset == offset && small.is_none_or(|s| (l.layout.punch < SMALL) == s)
                };
                let all: Vec<&HeldOutLayout> = self.layouts.iter().filter(mine).collect();
                let points = |of: fn(&HeldOutLayout) -> [f64; 2]| {
                    let [force, deflection] = [0, 1].map(|q| {
                        let values: Vec<f64> = all.iter().map(|l| of(l)[q]).collect();
                        [0.1, 0.5, 0.9].map(|part| quantile(&values, part))
                    });
                    Points { force, deflection }
                };
                let errors = [0, 1].map(|k| {
                    let values: Vec<f64> = all.iter().map(|l| l.error[k]).collect();
                    [0.5, 0.9].map(|part| quantile(&values, part))
                });
                parts.push(HeldOutPart {
                    errors,
                    words: format!("{words}{size}"),
                    n: all.len(),
                    points: [points(|l| l.derived), points(|l| l.published)],
                });
            }
        }
        parts
    }
}
