//! The paper's figures and tables from our own simulations, each value beside the paper's.
//!
//! What is lost of the paper's pictures has no value to compare with; what its text says of them has. A
//! difference is "not explained" unless a run here shows where it comes from.

use super::campaign::file::CampaignText;
use super::campaign::make::make;
use super::campaign::row::Row;
use super::campaign::{CampaignPlan, Header};
use super::derive::derive;
use super::paper::{ANCHORED, K75, LABORATORY, PaperStanding, RATIOS};
use crate::curve::Curve;
use crate::dem::{Arrangement, Controls, Fidelity, Flow, SceneSpec, Test};
use crate::forecast::published::published;
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::mesh::MeshType;
use crate::method::DerivedMethod;
use crate::method::sizes::PUBLISHED;
use crate::problem::Problem;
use crate::study::ensemble::{self, Ensemble, EnsembleProgress, Plan};
use crate::study::result::make::wires;
use crate::units::to_kn;

/// Runs of a point of a laboratory series, and of a row of Table 1.
const RUNS: [usize; 2] = [4, 16];
/// Differences that need no explanation, as a part: force, deflection and all else.
const CLOSE: f64 = 0.05;

/// How it is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ReproducePlan {
    /// Runs of random layouts.
    pub(crate) runs: usize,
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

/// A point of a laboratory series: block or panel, m, mean force, N, deflection, m, k75, N/m, and a curve.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SeriesPoint {
    pub(crate) size: f64,
    pub(crate) force: f64,
    pub(crate) deflection: f64,
    pub(crate) k75: f64,
    pub(crate) curve: Curve,
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
    /// What the campaign gave.
    pub(crate) method: DerivedMethod,
    /// D/L from which on the deflection stays within 3 % of its largest.
    pub(crate) threshold: f64,
    /// Whether the force rises with every step of D.
    pub(crate) rising: bool,
    /// How many of the envelope's inner points hold Eq. 3.
    pub(crate) held: [usize; 2],
}

/// What is told on the way: the part, its number, how many there are, and the runs' progress.
pub(crate) type Tell<'a> = dyn Fn(&str, usize, usize, EnsembleProgress) -> Flow + Sync + 'a;

/// Parts that are told apart.
const PARTS: usize = 4;

/// Makes everything. Nothing where it was ended early.
///
/// # Errors
/// What is wrong with the mesh's wires, or a campaign that says nothing.
pub(crate) fn reproduce(
    plan: &ReproducePlan,
    mesh: &MeshType,
    tell: &Tell,
) -> Result<Option<Reproduced>, Vec<Problem>> {
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
    let campaign = CampaignText { header, rows, whole: 0 };
    let method = derive(&[campaign]).map_err(|said| vec![Problem::new("campaign", said)])?;

    let scenes = Scenes { plan, mesh, tell };
    let blocks: Vec<f64> = (1..=25).map(|k| f64::from(k) / 10.0).collect();
    let panels: Vec<f64> = (8..=18).map(|k| f64::from(k) / 4.0).collect();
    let by_block = |punch: &f64| Layout { punch: *punch, ..REFERENCE };
    let by_panel = |spacing: &f64| Layout { spacing: *spacing, ..REFERENCE };
    let Some(over_block) = scenes.series("laboratory over D", 1, &blocks, by_block)? else {
        return Ok(None);
    };
    let Some(over_panel) = scenes.series("laboratory over L", 2, &panels, by_panel)? else {
        return Ok(None);
    };
    let mut rows = laboratory_rows(&over_panel);
    rows.extend(method_rows(&method));
    let Some(tests) = scenes.tests()? else { return Ok(None) };
    rows.extend(tests);
    Ok(Some(Reproduced {
        threshold: threshold(&over_block),
        rising: over_block.windows(2).all(|w| w[1].force > w[0].force),
        held: held(&method),
        rows,
        over_block,
        over_panel,
        method,
    }))
}

/// Runs of scenes.
struct Scenes<'a> {
    plan: &'a ReproducePlan,
    mesh: &'a MeshType,
    tell: &'a Tell<'a>,
}

impl Scenes<'_> {
    fn ensemble(
        &self,
        (words, part): (&str, usize),
        layout: Layout,
        test: Test,
        arrangement: Arrangement,
        runs: usize,
    ) -> Result<Option<Ensemble>, Vec<Problem>> {
        let plain = SceneSpec::plain(layout, test, wires(self.mesh)?.clone());
        let spec = SceneSpec { arrangement, ..plain };
        let controls =
            Controls { fidelity: self.plan.fidelity, after_break: 0.0, ..Controls::default() };
        let plan = Plan {
            runs: Some(runs),
            seed: self.plan.seed,
            threads: self.plan.threads,
            ..Plan::default()
        };
        let told = |now| (self.tell)(words, part, PARTS, now);
        let ensemble = ensemble::run(&spec, &controls, &plan, &told)?;
        Ok((!ensemble.partial()).then_some(ensemble))
    }

    /// Laboratory tests of some sizes.
    fn series(
        &self,
        words: &str,
        part: usize,
        sizes: &[f64],
        layout: impl Fn(&f64) -> Layout,
    ) -> Result<Option<Vec<SeriesPoint>>, Vec<Problem>> {
        let mut points = Vec::new();
        for size in sizes {
            let of = (words, part);
            let (test, stand) = (Test::Laboratory, Arrangement::default());
            let Some(e) = self.ensemble(of, layout(size), test, stand, RUNS[0])? else {
                return Ok(None);
            };
            points.push(SeriesPoint {
                size: *size,
                force: e.force.mean,
                deflection: e.deflection.mean,
                k75: e.k75,
                curve: e.runs.first().map(|run| run.outcome.curve.clone()).unwrap_or_default(),
            });
        }
        Ok(Some(points))
    }

    /// Table 1, with repeated blocks, and the eccentric ones with mirrored too.
    fn tests(&self) -> Result<Option<Vec<Compared>>, Vec<Problem>> {
        const FACING: &str = "explained: blocks that face each other, see the mirrored row";
        let mut rows = Vec::new();
        for test in &published().tests {
            let layout = test.layout();
            let offset = (layout.ex, layout.ey) != (0.0, 0.0);
            let mut stands = vec![("repeated", Arrangement::default(), PaperStanding::Predicted)];
            if offset {
                let mirrored = Arrangement::Mirrored;
                stands.push(("mirrored", mirrored, PaperStanding::AfterTheFact));
            }
            for (words, arrangement, standing) in stands {
                let of = ("Table 1", 3);
                let layout = Layout { blocks: Blocks::Repeated, ..layout };
                let e = self.ensemble(of, layout, Test::Anchored, arrangement, RUNS[1])?;
                let Some(e) = e else { return Ok(None) };
                // Test 5 is shown by a run to be the blocks' arrangement; of test 4 nothing is.
                let explained = if test.test == 5 && words == "repeated" { FACING } else { "" };
                let row = |what: &str, paper: f64, ours: f64| Compared {
                    place: "Table 1",
                    words: format!("test {}, {words}: {what}", test.test),
                    paper,
                    ours,
                    standing,
                    explained,
                };
                rows.push(row("F, kN", test.dem.force.value(), to_kn(e.force.mean)));
                rows.push(row("delta, m", test.dem.deflection.value(), e.deflection.mean));
            }
        }
        Ok(Some(rows))
    }
}

/// Eqs. 1-2 refitted and k75.
fn laboratory_rows(over_panel: &[SeriesPoint]) -> Vec<Compared> {
    let standard = over_panel.iter().find(|p| p.size == REFERENCE.spacing);
    let Some(standard) = standard else { return Vec::new() };
    let row = |place, words: &str, paper, ours| Compared {
        place,
        words: words.into(),
        paper,
        ours,
        standing: PaperStanding::Fitted,
        explained: "",
    };
    let part = |of: fn(&SeriesPoint) -> f64| {
        let points = over_panel.iter().map(|p| (p.size / REFERENCE.spacing, of(p) / of(standard)));
        line(&points.collect::<Vec<_>>())
    };
    let ([f0, f1], [d0, d1]) = (part(|p| p.force), part(|p| p.deflection));
    let mut rows = vec![
        row("Eq. 1", "constant of F over L", 0.89, f0),
        row("Eq. 1", "slope of F over L", 0.11, f1),
        row("Eq. 2", "constant of delta over L", 0.15, d0),
        row("Eq. 2", "slope of delta over L", 0.85, d1),
    ];
    for (panel, paper) in K75 {
        if let Some(point) = over_panel.iter().find(|p| p.size == panel) {
            let words = format!("k75 at L = {panel} m, kN/m");
            rows.push(row("section 3", &words, to_kn(paper), to_kn(point.k75)));
        }
    }
    rows
}

/// What the campaign says of the reference, the relations, the master curve and the map.
fn method_rows(m: &DerivedMethod) -> Vec<Compared> {
    use PaperStanding::{Fitted, Predicted};
    let row = |place, words: &str, paper: f64, ours: f64, standing| Compared {
        place,
        words: words.into(),
        paper,
        ours,
        standing,
        explained: "",
    };
    let mut rows = vec![
        row("Fig. 6", "F_l*, kN", to_kn(LABORATORY[0]), to_kn(m.laboratory.force), Fitted),
        row("Fig. 6", "delta_l*, m", LABORATORY[1], m.laboratory.deflection, Fitted),
        row("Fig. 6", "F_a*, kN", to_kn(ANCHORED[0]), to_kn(m.reference.force), Fitted),
        row("Fig. 6", "delta_a*, m", ANCHORED[1], m.reference.deflection, Fitted),
        row("Fig. 6", "alpha_F", RATIOS[0], m.alpha.force, Fitted),
        row("Fig. 6", "alpha_delta", RATIOS[1], m.alpha.deflection, Fitted),
    ];
    for (k, name) in ["a", "b", "c"].iter().enumerate() {
        let paper = [1.312, -0.385, 0.073][k];
        let words = format!("{name} of the master curve");
        rows.push(row("Eq. 3", &words, paper, m.master.free[k], Fitted));
    }
    let (p, r) = (&PUBLISHED, &m.refitted);
    // The wires were fitted to trends of one size at a time; no block of theirs is as small as a plate.
    for (words, paper, ours, standing) in [
        ("factor of D, D <= d", p.force_small, r.force_small, Predicted),
        ("slope of D, D > d", p.force_large, r.force_large, Fitted),
        ("slope of d", p.force_plate[0], r.force_plate[0], Fitted),
        ("constant of d", p.force_plate[1], r.force_plate[1], Fitted),
        ("slope of L", p.force_spacing, r.force_spacing, Fitted),
    ] {
        rows.push(row("Eq. A.1", words, paper, ours, standing));
    }
    for (x, y, factors) in [(0.157, 0.329, [0.628, 0.85]), (0.5, 0.05, [1.139, 0.815])] {
        let side = REFERENCE.spacing;
        let layout = Layout { ex: x * side, ey: y * side, ..REFERENCE };
        let f = m.offsets.at(&layout, &m.sizes.at(&layout));
        for (what, paper, ours) in [("F", factors[0], f.force), ("delta", factors[1], f.deflection)]
        {
            let words = format!("factor on {what} at ({x}, {y}) L, repeated");
            rows.push(row("Fig. A1", &words, paper, ours, Predicted));
        }
    }
    rows
}

/// Constant and slope of the straight line through some points.
fn line(points: &[(f64, f64)]) -> [f64; 2] {
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let along: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = along / points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>();
    [y - slope * x, slope]
}

/// D/L from which on the deflection stays within 3 % of its largest.
fn threshold(over_block: &[SeriesPoint]) -> f64 {
    let largest = over_block.iter().map(|p| p.deflection).fold(0.0, f64::max);
    let first = over_block.iter().find(|p| p.deflection > 0.97 * largest);
    first.map_or(f64::NAN, |p| p.size / REFERENCE.spacing)
}

/// How many inner points of the envelope hold Eq. 3, and how many there are.
fn held(m: &DerivedMethod) -> [usize; 2] {
    let points = &m.master.envelope;
    let last = points.len().saturating_sub(1);
    let inside = (1..last).filter(|i| {
        let on = crate::forecast::master::force(*i as f64 / last as f64);
        (points[*i][0]..=points[*i][2]).contains(&on)
    });
    [inside.count(), last.saturating_sub(1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(size: f64, force: f64, deflection: f64) -> SeriesPoint {
        SeriesPoint { size, force, deflection, k75: 190.0e3, curve: Curve::default() }
    }

    #[test]
    fn the_papers_own_lines_come_back() {
        // Eqs. 1 and 2 at five panels.
        let series: Vec<SeriesPoint> = [2.0, 2.5, 3.0, 3.5, 4.0]
            .map(|l| point(l, 73.3e3 * (0.89 + 0.11 * l / 3.0), 0.6 * (0.15 + 0.85 * l / 3.0)))
            .into();
        for row in &laboratory_rows(&series)[..4] {
            assert!(row.difference().abs() < 1e-9 && row.remark().is_empty(), "{row:?}");
        }
        // 190 kN/m against 247, 193 and 170: the first and the last are off by more than 5 %.
        let remarks: Vec<&str> =
            laboratory_rows(&series)[4..].iter().map(Compared::remark).collect();
        assert_eq!(remarks, ["not explained", "", "not explained"]);
    }

    #[test]
    fn the_threshold_is_where_the_deflection_stops_to_rise() {
        let series: Vec<SeriesPoint> =
            [(0.3, 0.40), (0.6, 0.50), (0.9, 0.585), (1.2, 0.6), (1.5, 0.59)]
                .map(|(size, deflection)| point(size, 1.0, deflection))
                .into();
        // 0.97 x 0.6 = 0.582, first reached at D = 0.9 of L = 3.
        assert!((threshold(&series) - 0.3).abs() < 1e-12);
    }
}
