//! The paper's figures as SVG.

use super::map;
use crate::curve::{Curve, Point};
use crate::export::svg::drawing::Stroke;
use crate::export::svg::marks::{self, Mark};
use crate::export::svg::plot::{Plot, PlotLine, Points, Signs};
use crate::forecast::published::PublishedTest;
use crate::forecast::{forecast, laboratory, master, rescaled};
use crate::lab::paper::{ANCHORED, LABORATORY};
use crate::lab::reproduce::{MeanCurve, Reproduced, SeriesPoint, SimulatedTest, THRESHOLD};
use crate::layout::{BranchRule, REFERENCE};
use crate::mesh::catalogue;
use crate::units::{from_kn, significant, to_kn};

const DELTA: &str = "deflection \u{3b4} (m)";
const FORCE: &str = "force F (kN)";
/// Points of a line that has an equation.
const POINTS: usize = 41;
/// Blocks and panels whose curves are shown, m.
const SHOWN: [&[f64]; 2] = [&[0.5, 1.0, 1.5, 2.0, 2.5], &[2.0, 4.0]];
/// The sign of what the paper prints.
const PAPER: Mark = Mark::Disc;

/// All pictures with their file names.
pub(super) fn all(r: &Reproduced) -> Vec<(&'static str, String)> {
    let mut all = vec![
        ("fig3.svg", fig3(r).svg()),
        ("fig4a.svg", fig4a(r).svg()),
        ("fig4b.svg", fig4b(r).svg()),
        ("fig6.svg", fig6(r).svg()),
        ("fig7a.svg", fig7a(r).svg()),
    ];
    let names = ["fig7b.svg", "fig7c.svg", "fig7d.svg", "fig7e.svg", "fig7f.svg"];
    all.extend(names.into_iter().zip(&r.tests).map(|(name, test)| (name, fig7(name, test).svg())));
    all.push(("figa1.svg", map::svg(&r.method)));
    all
}

/// Laboratory curves for several blocks and panels.
fn fig3(r: &Reproduced) -> Plot {
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    let shown = |series: &'static [f64], points: &'static str, of: &[SeriesPoint]| {
        let of = of.iter().filter(move |p| series.iter().any(|size| near(p.size, *size)));
        of.map(|p| (format!("{points} = {} m", p.size), p.curve.clone())).collect::<Vec<_>>()
    };
    let mut curves = shown(SHOWN[0], "D", &r.over_block);
    curves.extend(shown(SHOWN[1], "L", &r.over_panel));
    let lines = curves.into_iter().enumerate().map(|(k, (tag, curve))| {
        let (stroke, mark) = marks::nth(k);
        let rest = if tag.starts_with('D') { "L = 3 m" } else { "D = 1 m" };
        let words = format!("{tag}, {rest}: {}", ended(&curve));
        PlotLine { tag, ..line(&curve, stroke, mark, words) }
    });
    Plot {
        title: "Fig. 3: laboratory tests by D and by L, means of our runs".into(),
        axes: [DELTA, FORCE],
        lines: lines.collect(),
    }
}

/// Laboratory forces over both sizes, and Eq. 1.
fn fig4a(r: &Reproduced) -> Plot {
    let paper = |panel: f64| to_kn(LABORATORY[0]) * laboratory::force_ratio(panel);
    Plot {
        title: "Fig. 4a: force of the laboratory test by D and by L".into(),
        axes: ["D or L (m)", FORCE],
        lines: over_both(r, |p| to_kn(p.force), paper, "Eq. 1 of the paper, over L"),
    }
}

/// Laboratory deflections over both sizes, and Eq. 2.
fn fig4b(r: &Reproduced) -> Plot {
    let paper = |panel: f64| LABORATORY[1] * laboratory::deflection_ratio(panel);
    let mut lines = over_both(r, |p| p.deflection, paper, "Eq. 2 of the paper, over L");
    let end = THRESHOLD * REFERENCE.spacing;
    let words = format!("the paper's threshold over D, D/L = {THRESHOLD}: constant beyond");
    let top = r.over_panel.iter().map(|p| p.deflection).fold(0.0, f64::max);
    lines.push(PlotLine {
        points: vec![(end, 0.0), (end, top)],
        stroke: marks::ALLOWABLE,
        ..signs(Vec::new(), None, words)
    });
    Plot {
        title: "Fig. 4b: deflection at failure of the laboratory test by D and by L".into(),
        axes: ["D or L (m)", DELTA],
        lines,
    }
}

fn over_both(
    r: &Reproduced,
    of: fn(&SeriesPoint) -> f64,
    paper: impl Fn(f64) -> f64,
    equation: &str,
) -> Vec<PlotLine> {
    let points = |series: &[SeriesPoint]| series.iter().map(|p| (p.size, of(p))).collect();
    let series = |points: Points, k: usize, mark: Mark, words: &str, tag: &str| PlotLine {
        points,
        stroke: Stroke { width: 1.2, ..marks::nth(k).0 },
        mark: Some((mark, Signs::All)),
        band: Vec::new(),
        words: words.into(),
        tag: tag.into(),
    };
    let panels = r.over_panel.iter().map(|p| (p.size, paper(p.size)));
    vec![
        series(points(&r.over_block), 0, Mark::Disc, "our runs over D, L = 3 m", "D"),
        series(points(&r.over_panel), 1, Mark::Diamond, "our runs over L, D = 1 m", "L"),
        PlotLine {
            stroke: marks::OTHER,
            points: panels.collect(),
            ..signs(Vec::new(), None, equation.into())
        },
    ]
}

/// The standard laboratory test and the anchored reference panel.
fn fig6(r: &Reproduced) -> Plot {
    let [laboratory, anchored] = &r.star;
    let paper = |[force, deflection]: [f64; 2], of: &str| {
        let point = Point { deflection, force };
        let words = format!("the paper's F_{of}*, \u{3b4}_{of}*: {}", at(point));
        signs(vec![place(point)], Some(PAPER), words)
    };
    let ours = |mean: &MeanCurve, stroke, mark, of: &str, what: &str| {
        let tag = format!("F_{of}*, \u{3b4}_{of}*");
        let words = format!("{what}, ours: {tag} = {}; shaded: 90 %", ended(&mean.curve));
        PlotLine { band: band(mean), tag, ..line(&mean.curve, stroke, mark, words) }
    };
    Plot {
        title: "Fig. 6: laboratory (L = 3, D = 1 m) and anchored (d = 0.32, L = 3, D = 1 m)".into(),
        axes: [DELTA, FORCE],
        // Ours last, because the signs are near each other.
        lines: vec![
            paper(LABORATORY, "l"),
            paper(ANCHORED, "a"),
            ours(laboratory, marks::OTHER, Mark::Ring, "l", "laboratory"),
            ours(anchored, marks::CHECK, Mark::Diamond, "a", "anchored"),
        ],
    }
}

/// Envelope of the normalised curves, and Eq. 3.
fn fig7a(r: &Reproduced) -> Plot {
    let envelope = &r.method.master.envelope;
    let last = envelope.len().max(2) - 1;
    let x = |i: usize| i as f64 / last as f64;
    let edge =
        |k: usize| -> Points { envelope.iter().enumerate().map(|(i, p)| (x(i), p[k])).collect() };
    let mut around = edge(0);
    around.extend(edge(2).into_iter().rev());
    let equation =
        (0..POINTS).map(|i| i as f64 / (POINTS - 1) as f64).map(|x| (x, master::force(x)));
    Plot {
        title: "Fig. 7a: normalised curves of random layouts".into(),
        axes: [
            "deflection over that at failure, \u{3b4}/\u{3b4}_a",
            "force over that at failure, F/F_a",
        ],
        lines: vec![
            PlotLine {
                points: edge(1),
                stroke: marks::CHECK,
                band: around,
                ..signs(Vec::new(), None, "our runs: their median; shaded: 5 to 95 %".into())
            },
            PlotLine {
                points: equation.collect(),
                stroke: marks::FORECAST,
                ..signs(
                    Vec::new(),
                    None,
                    "Eq. 3 of the paper: 1.312 x^3 - 0.385 x^2 + 0.073 x".into(),
                )
            },
        ],
    }
}

/// A row of Table 1: our runs, what the paper prints, and the paper's forecast.
fn fig7(name: &str, simulated: &SimulatedTest) -> Plot {
    let test = simulated.test;
    let styles = [(marks::CHECK, Mark::Diamond), (marks::OTHER, Mark::Square)];
    let mut lines: Vec<PlotLine> = simulated
        .by
        .iter()
        .zip(styles)
        .map(|((stand, mean), (stroke, mark))| {
            let words = format!("our runs, {stand} blocks: {}; shaded: 90 %", ended(&mean.curve));
            PlotLine { band: band(mean), ..line(&mean.curve, stroke, mark, words) }
        })
        .collect();
    let predicted = forecast(&test.layout(), &catalogue::reference(), BranchRule::Published)
        .ok()
        .and_then(|told| told.field.ok()?.end());
    if let Some(end) = predicted {
        let curve = rescaled(end, POINTS);
        let words = format!("forecast of the paper: {}", ended(&curve));
        lines.push(line(&curve, marks::FORECAST, Mark::Cross, words));
    }
    let printed =
        Point { force: from_kn(test.dem.force.value()), deflection: test.dem.deflection.value() };
    let words = format!("the paper's simulation, Table 1: {}", at(printed));
    let tag = "paper".to_string();
    lines.push(PlotLine { tag, ..signs(vec![place(printed)], Some(PAPER), words) });
    Plot { title: title(name, test), axes: [DELTA, FORCE], lines }
}

fn title(name: &str, test: &PublishedTest) -> String {
    let letter = name.trim_start_matches("fig7").trim_end_matches(".svg");
    let sizes = format!("d = {}, L = {}, D = {}", test.plate, test.spacing, test.punch);
    let offset = if (test.ex, test.ey) == (0.0, 0.0) {
        String::new()
    } else {
        format!(", ex = {}, ey = {}", test.ex, test.ey)
    };
    format!("Fig. 7{letter}: test {}, {sizes}{offset} m", test.test)
}

fn place(point: Point) -> (f64, f64) {
    (point.deflection, to_kn(point.force))
}

fn at(point: Point) -> String {
    let force = significant(to_kn(point.force), 3);
    format!("{force} kN at {} m", significant(point.deflection, 3))
}

/// Where a curve ends.
fn ended(curve: &Curve) -> String {
    curve.failure.map_or("no break".into(), at)
}

fn line(curve: &Curve, stroke: Stroke, mark: Mark, words: String) -> PlotLine {
    PlotLine {
        points: curve.points().map(place).collect(),
        stroke,
        mark: curve.failure.map(|_| (mark, Signs::End)),
        band: Vec::new(),
        words,
        tag: String::new(),
    }
}

fn signs(points: Points, mark: Option<Mark>, words: String) -> PlotLine {
    PlotLine {
        points,
        stroke: marks::SIGNS,
        mark: mark.map(|mark| (mark, Signs::All)),
        band: Vec::new(),
        words,
        tag: String::new(),
    }
}

/// The band of a mean curve as a closed line.
fn band(mean: &MeanCurve) -> Points {
    let edge = |forces: &[f64]| -> Points {
        let pairs = mean.curve.deflection.iter().zip(forces);
        pairs.map(|(deflection, force)| (*deflection, to_kn(*force))).collect()
    };
    let mut around = edge(&mean.band[0]);
    around.extend(edge(&mean.band[1]).into_iter().rev());
    around
}
