//! A method derived from campaigns: what [`crate::method`] holds, by least squares over single runs.
//!
//! - this file: the runs, what is made of them, and whether campaigns go together; [`fit`]: the least squares
//!   and the cross-validation; [`sizes`]: size relations; [`offsets`]: what an offset does; [`curve`]: the
//!   normalised curve.
//!
//! Nothing but campaigns goes in: neither the paper's Table 1 nor any other of its values.

mod curve;
mod fit;
mod offsets;
mod sizes;

use super::campaign::file::CampaignText;
use super::campaign::row::{Kind, Row, RowEnd};
use crate::layout::Layout;
use crate::method::sizes::logarithms;
use crate::method::{
    Alpha, Anchor, Counts, DerivedMethod, FORMAT, FormError, HeldOut, Scatter, Source,
};
use crate::study::ensemble::{Spread, quantile};
use crate::study::result::rounded;
use crate::words::Choice;
use std::collections::BTreeMap;

/// D that tells small blocks from others in tables, m; what the method itself tells them by is fitted.
const SMALL: f64 = 0.4;
/// The fewest runs of a kind that are called enough.
const FEWEST: usize = 20;
/// Scatter where there are too few runs to know it: that of the paper's figures for D from and below 0.4 m.
const UNKNOWN: [f64; 2] = [0.085, 0.05];

/// Runs of random layouts that broke, over the reference panel.
#[derive(Debug, Default)]
struct Runs {
    layouts: Vec<Layout>,
    /// Logarithms of their sizes.
    at: Vec<[f64; 3]>,
    /// Force over F_a*.
    force: Vec<f64>,
    /// Deflection over delta_a*.
    deflection: Vec<f64>,
}

impl Runs {
    fn len(&self) -> usize {
        self.force.len()
    }
}

/// A number as the file has it.
fn digits(value: f64) -> f64 {
    rounded(value)
}

/// Derives a method.
///
/// # Errors
/// Campaigns that do not go together, or are too small to say anything.
pub(crate) fn derive(campaigns: &[CampaignText]) -> Result<DerivedMethod, String> {
    let header = together(campaigns)?;
    let blocks = header.plan.blocks;
    let rows = || campaigns.iter().flat_map(|c| &c.rows);
    let laboratory = anchor(rows(), Kind::Laboratory)?;
    let reference = anchor(rows(), Kind::Reference)?;
    let runs = |kind: Kind| {
        let mut found = Runs::default();
        for row in rows().filter(|row| row.kind == kind) {
            let Some([force, deflection]) = row.values() else { continue };
            let layout = row.layout(blocks);
            found.at.push(logarithms(&layout));
            found.layouts.push(layout);
            found.force.push(force / reference.force);
            found.deflection.push(deflection / reference.deflection);
        }
        found
    };
    let (centred, eccentric) = (runs(Kind::Centred), runs(Kind::Eccentric));
    if centred.len() < FEWEST {
        return Err(format!(
            "{} centred runs with a break are too few; at least {FEWEST}",
            centred.len()
        ));
    }
    let product = sizes::product(&centred);
    let mut forms = sizes::forms(&centred);
    let compared = compared(&centred, &product, &forms, &laboratory, &reference);
    let best = forms.swap_remove(sizes::best(&forms, &centred));
    let (mut offsets, offset_said) = offsets::offsets(&eccentric, &best.form);
    let through = |runs: &Runs| -> Vec<f64> {
        runs.layouts.iter().map(|layout| best.form.at(layout).through).collect()
    };
    let parts = [through(&centred), through(&eccentric)];
    let scatter = scatter([&centred, &eccentric], [&best.said, &offset_said], &parts);
    offsets.deviation = [0, 1].map(|q| {
        let more = scatter.large_offset[q].powi(2) - scatter.large[q].powi(2);
        digits(more.max(0.0).sqrt())
    });
    let curves = rows().filter(|row| row.kind == Kind::Centred && row.end == RowEnd::Broke);
    let method = DerivedMethod {
        format: FORMAT,
        name: format!("{} {}", header.mesh, blocks.word()),
        mesh: header.mesh.clone(),
        wires: header.wires.clone(),
        blocks,
        revisions: header.revisions.clone(),
        fidelity: header.plan.fidelity.word().to_string(),
        campaigns: campaigns.iter().map(source).collect(),
        runs: counts(campaigns, centred.len() + eccentric.len()),
        ranges: header.plan.ranges,
        alpha: alpha(&laboratory, &reference),
        laboratory,
        reference,
        refitted: product.form,
        cross_validated: held_out([&centred, &eccentric], [&best.said, &offset_said]),
        sizes: best.form,
        offsets,
        master: curve::master(&curves.map(|row| row.curve.clone()).collect::<Vec<_>>())?,
        scatter,
        compared,
    };
    method.check().map(|()| method)
}

/// The header of campaigns that go together: one mesh, law, arrangement, solver and fidelity, each seed once.
fn together(campaigns: &[CampaignText]) -> Result<&super::campaign::Header, String> {
    let Some(first) = campaigns.first() else { return Err("there is no campaign".into()) };
    for (k, other) in campaigns.iter().enumerate() {
        let (a, b) = (&first.header, &other.header);
        // What is left to differ: how many runs, of which seed, and how many of them with an offset.
        let mut alike = b.clone();
        (alike.plan.seed, alike.plan.runs) = (a.plan.seed, a.plan.runs);
        alike.plan.eccentric = a.plan.eccentric;
        if let Some(said) = alike.differs(a) {
            return Err(format!("the campaigns do not go together: {said}"));
        }
        if campaigns[..k].iter().any(|c| c.header.plan.seed == b.plan.seed) {
            return Err(format!("two campaigns have the seed {}, so the same runs", b.plan.seed));
        }
        if other.rows.len() < b.plan.lines() {
            return Err(format!(
                "the campaign of seed {} has {} of {} lines; meshcast campaign --resume makes the others",
                b.plan.seed,
                other.rows.len(),
                b.plan.lines()
            ));
        }
    }
    Ok(&first.header)
}

fn source(campaign: &CampaignText) -> Source {
    let plan = &campaign.header.plan;
    Source { seed: plan.seed, runs: plan.runs, eccentric: plan.eccentric }
}

/// Means of the runs of one scene.
fn anchor<'a>(rows: impl Iterator<Item = &'a Row>, kind: Kind) -> Result<Anchor, String> {
    let values: Vec<[f64; 2]> =
        rows.filter(|row| row.kind == kind).filter_map(Row::values).collect();
    if values.len() < 2 {
        return Err(format!("fewer than two runs of kind {kind:?} broke").to_lowercase());
    }
    let [force, deflection] = [0, 1].map(|q| {
        let all: Vec<f64> = values.iter().map(|v| v[q]).collect();
        Spread::of(&all, &[])
    });
    Ok(Anchor {
        force: digits(force.mean),
        force_error: digits(force.error),
        deflection: digits(deflection.mean),
        deflection_error: digits(deflection.error),
        runs: values.len(),
    })
}

fn alpha(laboratory: &Anchor, reference: &Anchor) -> Alpha {
    let ratio = |a: f64, a_error: f64, b: f64, b_error: f64| {
        let ratio = a / b;
        [digits(ratio), digits(ratio * (a_error / a).hypot(b_error / b))]
    };
    let [force, force_error] =
        ratio(reference.force, reference.force_error, laboratory.force, laboratory.force_error);
    let [deflection, deflection_error] = ratio(
        reference.deflection,
        reference.deflection_error,
        laboratory.deflection,
        laboratory.deflection_error,
    );
    Alpha { force, force_error, deflection, deflection_error }
}

fn counts(campaigns: &[CampaignText], used: usize) -> Counts {
    let mut counts = Counts { used, ..Counts::default() };
    let mut left_out: BTreeMap<String, usize> = BTreeMap::new();
    let random = campaigns.iter().flat_map(|c| &c.rows);
    for row in random.filter(|row| matches!(row.kind, Kind::Centred | Kind::Eccentric)) {
        counts.asked += 1;
        match row.end {
            RowEnd::Broke => {}
            RowEnd::Slipped => counts.slipped += 1,
            RowEnd::Diverged => counts.diverged += 1,
            other => *left_out.entry(other.words().to_string()).or_insert(0) += 1,
        }
    }
    counts.left_out = left_out.into_iter().collect();
    counts
}

/// Root mean square of value over what is said, less 1, of the runs of a place.
fn error(values: &[f64], said: &[f64], of: impl Fn(usize) -> bool) -> f64 {
    let squares: Vec<f64> = (0..values.len())
        .filter(|i| of(*i))
        .map(|i| values[i] / said[i] - 1.0)
        .map(|off| off * off)
        .collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}

/// Errors of the forms: the published one from our laboratory test, and those fitted.
fn compared(
    runs: &Runs,
    product: &sizes::Crossed<crate::method::sizes::Product>,
    forms: &[sizes::Crossed<crate::method::sizes::Sizes>],
    laboratory: &Anchor,
    reference: &Anchor,
) -> Vec<FormError> {
    let small: Vec<bool> = runs.layouts.iter().map(|layout| layout.punch < SMALL).collect();
    let one = |words: &str, said: &[Vec<f64>; 2]| {
        let of = |part: bool| {
            [(&runs.force, &said[0]), (&runs.deflection, &said[1])]
                .map(|(values, said)| digits(error(values, said, |i| small[i] == part)))
        };
        FormError { form: words.into(), below: of(true), above: of(false) }
    };
    let published: [Vec<f64>; 2] = {
        let star = crate::forecast::ratios::DEFAULT;
        let scale = [
            star.force * laboratory.force / reference.force,
            star.deflection * laboratory.deflection / reference.deflection,
        ];
        let all: Vec<[f64; 2]> =
            runs.layouts.iter().map(|l| crate::method::sizes::PUBLISHED.at(l)).collect();
        [0, 1].map(|q| all.iter().map(|v| v[q] * scale[q]).collect())
    };
    let mut list = vec![one("A.1-A.2 as published, from our laboratory test", &published)];
    list.push(one(&product.words, &product.said));
    list.extend(forms.iter().map(|form| one(&form.words, &form.said)));
    list
}

/// Scatter by way of failing, centred and with an offset; `parts` is that of the block's way in each run.
fn scatter(runs: [&Runs; 2], said: [&[Vec<f64>; 2]; 2], parts: &[Vec<f64>; 2]) -> Scatter {
    let of = |kind: usize, small: bool| {
        let mine = |i: usize| (parts[kind][i] > 0.5) == small;
        let n = (0..runs[kind].len()).filter(|i| mine(*i)).count();
        if n < FEWEST / 2 {
            return UNKNOWN;
        }
        [
            digits(error(&runs[kind].force, &said[kind][0], mine)),
            digits(error(&runs[kind].deflection, &said[kind][1], mine)),
        ]
    };
    Scatter {
        small: of(0, true),
        large: of(0, false),
        small_offset: of(1, true),
        large_offset: of(1, false),
    }
}

/// Quotients of single runs over what fits said that did not see them.
fn held_out(runs: [&Runs; 2], said: [&[Vec<f64>; 2]; 2]) -> Vec<HeldOut> {
    let mut list = Vec::new();
    for (kind, words) in ["centred", "with an offset"].iter().enumerate() {
        for (small, size) in [(true, "D below 0.4 m"), (false, "D from 0.4 m")] {
            let of: Vec<usize> = (0..runs[kind].len())
                .filter(|i| (runs[kind].layouts[*i].punch < SMALL) == small)
                .collect();
            let points = |values: &[f64], said: &[f64]| {
                let all: Vec<f64> = of.iter().map(|i| values[*i] / said[*i]).collect();
                [0.1, 0.5, 0.9].map(|part| digits(quantile(&all, part)))
            };
            list.push(HeldOut {
                part: format!("{words}, {size}"),
                n: of.len(),
                force: points(&runs[kind].force, &said[kind][0]),
                deflection: points(&runs[kind].deflection, &said[kind][1]),
            });
        }
    }
    list
}

#[cfg(test)]
mod tests;
