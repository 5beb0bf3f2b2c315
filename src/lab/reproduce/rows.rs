//! Our values beside the paper's.

use super::scenes::{MIRRORED, POINTS, REPEATED};
use super::{CLOSE, Compared, SeriesPoint, SimulatedTest, THRESHOLD};
use crate::forecast::master;
use crate::lab::paper::{ANCHORED, K75, LABORATORY, PaperStanding, RATIOS};
use crate::layout::REFERENCE;
use crate::method::DerivedMethod;
use crate::method::offset::Factors;
use crate::method::sizes::PUBLISHED;
use crate::units::to_kn;

/// Eqs. 1-2 refitted and k75.
pub(super) fn laboratory(over_panel: &[SeriesPoint]) -> Vec<Compared> {
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
pub(super) fn method(m: &DerivedMethod) -> Vec<Compared> {
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
    rows
}

/// The points of Fig. A1 that the paper gives away: by the campaign's map, and by runs of blocks that face each
/// other.
pub(super) fn offsets(m: &DerivedMethod, facing: &[Factors]) -> Vec<Compared> {
    let mut rows = Vec::new();
    for (point, facing) in POINTS.iter().zip(facing) {
        let layout = point.layout();
        let map = m.offsets.at(&layout, &m.sizes.at(&layout));
        let pair = |f: &Factors| [f.force, f.deflection];
        let ours = [(REPEATED, pair(&map)), (MIRRORED, pair(facing))];
        let [x, y] = point.at;
        rows.extend(beside("Fig. A1", pair(&point.factors), &ours, |stand, quantity| {
            format!("factor on {} at ({x}, {y}) L, {stand}", ["F", "delta"][quantity])
        }));
    }
    rows
}

/// A row of Table 1 by each arrangement.
pub(super) fn test(simulated: &SimulatedTest) -> Vec<Compared> {
    let printed = &simulated.test.dem;
    let paper = [printed.force.value(), printed.deflection.value()];
    let ours = simulated.by.iter().filter_map(|(stand, mean)| {
        let end = mean.curve.failure?;
        Some((*stand, [to_kn(end.force), end.deflection]))
    });
    beside("Table 1", paper, &ours.collect::<Vec<_>>(), |stand, quantity| {
        let number = simulated.test.test;
        format!("test {number}, {stand}: {}", ["F, kN", "delta, m"][quantity])
    })
}

/// Force and deflection by each arrangement. What repeated blocks miss and mirrored ones meet is explained by
/// those.
fn beside(
    place: &'static str,
    paper: [f64; 2],
    ours: &[(&'static str, [f64; 2])],
    words: impl Fn(&str, usize) -> String,
) -> Vec<Compared> {
    const FACING: &str = "explained: blocks that face each other, see the mirrored row";
    let mirrored = ours.iter().find(|(stand, _)| *stand == MIRRORED);
    let mut rows = Vec::new();
    for (stand, values) in ours {
        for quantity in [0, 1] {
            let paper = paper[quantity];
            let met = mirrored.is_some_and(|(_, m)| (m[quantity] / paper - 1.0).abs() <= CLOSE);
            let repeated = *stand == REPEATED;
            rows.push(Compared {
                place,
                words: words(stand, quantity),
                paper,
                ours: values[quantity],
                standing: if repeated {
                    PaperStanding::Predicted
                } else {
                    PaperStanding::AfterTheFact
                },
                explained: if repeated && met { FACING } else { "" },
            });
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

/// D/L from which on the laboratory's deflection is constant over D: within 3 % of its largest, because the
/// paper does not say how constant; within 1 % it may be met.
pub(super) fn threshold(over_block: &[SeriesPoint]) -> Compared {
    let [ours, closer] = [0.03, 0.01].map(|part| constant_from(over_block, part));
    let row = Compared {
        place: "Fig. 4",
        words: "D/L from which delta is within 3 % of its largest".into(),
        paper: THRESHOLD,
        ours,
        standing: PaperStanding::Predicted,
        explained: "",
    };
    let met = Compared { ours: closer, ..row.clone() }.difference().abs() <= CLOSE;
    let explained =
        if met { "explained: the paper does not say how constant; within 1 % met" } else { "" };
    Compared { explained, ..row }
}

/// D/L from which on the deflection stays within a part of its largest.
fn constant_from(over_block: &[SeriesPoint], part: f64) -> f64 {
    let largest = over_block.iter().map(|p| p.deflection).fold(0.0, f64::max);
    let first = over_block.iter().find(|p| p.deflection > (1.0 - part) * largest);
    first.map_or(f64::NAN, |p| p.size / REFERENCE.spacing)
}

/// How many inner points of the envelope hold Eq. 3, and how many there are.
pub(super) fn held(m: &DerivedMethod) -> [usize; 2] {
    let points = &m.master.envelope;
    let last = points.len().saturating_sub(1);
    let inside = (1..last).filter(|i| {
        let on = master::force(*i as f64 / last as f64);
        (points[*i][0]..=points[*i][2]).contains(&on)
    });
    [inside.count(), last.saturating_sub(1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Curve;

    fn point(size: f64, force: f64, deflection: f64) -> SeriesPoint {
        SeriesPoint { size, force, deflection, k75: 190.0e3, curve: Curve::default() }
    }

    #[test]
    fn the_papers_own_lines_come_back() {
        // Eqs. 1 and 2 at five panels.
        let series: Vec<SeriesPoint> = [2.0, 2.5, 3.0, 3.5, 4.0]
            .map(|l| point(l, 73.3e3 * (0.89 + 0.11 * l / 3.0), 0.6 * (0.15 + 0.85 * l / 3.0)))
            .into();
        for row in &laboratory(&series)[..4] {
            assert!(row.difference().abs() < 1e-9 && row.remark().is_empty(), "{row:?}");
        }
        // 190 kN/m against 247, 193 and 170: the first and the last are off by more than 5 %.
        let remarks: Vec<&str> = laboratory(&series)[4..].iter().map(Compared::remark).collect();
        assert_eq!(remarks, ["not explained", "", "not explained"]);
    }

    #[test]
    fn the_threshold_is_where_the_deflection_stops_to_rise() {
        let series: Vec<SeriesPoint> =
            [(0.3, 0.40), (0.6, 0.50), (0.9, 0.585), (1.2, 0.6), (1.5, 0.59)]
                .map(|(size, deflection)| point(size, 1.0, deflection))
                .into();
        // 0.97 x 0.6 = 0.582, first reached at D = 0.9 of L = 3.
        let row = threshold(&series);
        assert!((row.ours - 0.3).abs() < 1e-12);
        // And 0.99 x 0.6 = 0.594 at D = 1.2, where the paper has it.
        assert!((constant_from(&series, 0.01) - 0.4).abs() < 1e-12);
        assert!(row.remark().starts_with("explained: the paper does not say"), "{row:?}");
        // Without the point at 1.2 m, 1 % is first met at 1.5 m: D/L = 0.5.
        let without = [&series[..3], &[point(1.5, 1.0, 0.6)]].concat();
        assert_eq!(threshold(&without).remark(), "not explained");
    }

    #[test]
    fn a_difference_is_explained_where_blocks_that_face_each_other_have_none() {
        // 20 against 14 is far off, and 14.4 against it is not; 0.5 against 0.6 is, and so is 0.52.
        let ours = [(REPEATED, [20.0, 0.5]), (MIRRORED, [14.4, 0.52])];
        let rows = beside("Table 1", [14.0, 0.6], &ours, |stand, q| format!("{stand} {q}"));
        let said: Vec<_> = rows.iter().map(|row| (row.words.as_str(), row.remark())).collect();
        assert!(said[0].0 == "repeated 0" && said[0].1.starts_with("explained: "), "{said:?}");
        assert_eq!(
            said[1..],
            [("repeated 1", "not explained"), ("mirrored 0", ""), ("mirrored 1", "not explained")]
        );
        // One arrangement alone explains nothing.
        let alone = beside("Table 1", [14.0, 0.6], &ours[..1], |_, _| String::new());
        assert_eq!(alone[0].remark(), "not explained");
    }
}
