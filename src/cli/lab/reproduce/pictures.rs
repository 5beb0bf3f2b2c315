//! The paper's figures as SVG.

use crate::axis::Axis;
use crate::export::svg::drawing::{Anchor, Drawing, Stroke};
use crate::forecast::master;
use crate::lab::reproduce::{Reproduced, SeriesPoint};
use crate::units::to_kn;

/// Size of a picture and its margin.
const SIZE: (f64, f64) = (520.0, 360.0);
const MARGIN: f64 = 55.0;
const WORDS: f64 = 12.0;
const COLOURS: [&str; 5] = ["#1b6ca8", "#b03a2e", "#1e8449", "#7d3c98", "#b9770e"];

/// Points of a line.
type Points = Vec<(f64, f64)>;

/// Some lines over common axes.
struct Figure {
    title: &'static str,
    x: &'static str,
    y: &'static str,
    /// Name, points and whether they are drawn as dots.
    lines: Vec<(String, Points, bool)>,
}

/// All pictures with their file names.
pub(super) fn all(r: &Reproduced) -> Vec<(&'static str, String)> {
    let kn = |points: &[SeriesPoint]| -> Vec<(f64, f64)> {
        points.iter().map(|p| (p.size, to_kn(p.force))).collect()
    };
    let delta = |points: &[SeriesPoint]| -> Vec<(f64, f64)> {
        points.iter().map(|p| (p.size, p.deflection)).collect()
    };
    let curve = |p: &SeriesPoint, name: &str| {
        let points = p.curve.points().map(|q| (q.deflection, to_kn(q.force))).collect();
        (format!("{name} {:.1} m", p.size), points, false)
    };
    let mut fig3: Vec<_> =
        [4, 9, 14, 19].iter().filter_map(|k| r.over_block.get(*k)).map(|p| curve(p, "D")).collect();
    fig3.extend(r.over_panel.first().map(|p| curve(p, "D 1 m, L")));
    let both = |of: &dyn Fn(&[SeriesPoint]) -> Points| {
        vec![
            ("over D, L = 3 m".to_string(), of(&r.over_block), true),
            ("over L, D = 1 m".to_string(), of(&r.over_panel), true),
        ]
    };
    let envelope = &r.method.master.envelope;
    let last = (envelope.len().max(2) - 1) as f64;
    let x = |i: usize| i as f64 / last;
    let mut fig7: Vec<_> = [(0, "5 %"), (1, "50 %"), (2, "95 %")]
        .iter()
        .map(|(k, name)| {
            let points = envelope.iter().enumerate().map(|(i, p)| (x(i), p[*k])).collect();
            (name.to_string(), points, false)
        })
        .collect();
    let eq3 = (0..envelope.len()).map(|i| (x(i), master::force(x(i)))).collect();
    fig7.push(("Eq. 3 of the paper".to_string(), eq3, true));
    let figures = [
        ("fig3.svg", Figure { title: "Laboratory curves", x: "delta, m", y: "F, kN", lines: fig3 }),
        (
            "fig4a.svg",
            Figure { title: "Laboratory force", x: "D or L, m", y: "F, kN", lines: both(&kn) },
        ),
        (
            "fig4b.svg",
            Figure {
                title: "Laboratory deflection",
                x: "D or L, m",
                y: "delta, m",
                lines: both(&delta),
            },
        ),
        (
            "fig7a.svg",
            Figure { title: "Normalised curves", x: "delta/delta_a", y: "F/F_a", lines: fig7 },
        ),
    ];
    figures.into_iter().map(|(name, figure)| (name, figure.svg())).collect()
}

impl Figure {
    fn svg(&self) -> String {
        let all = || self.lines.iter().flat_map(|line| &line.1);
        let x = Axis::holding(all().map(|p| p.0).fold(0.0, f64::max), 6);
        let y = Axis::holding(all().map(|p| p.1).fold(0.0, f64::max), 6);
        let (width, height) = SIZE;
        let at = |p: (f64, f64)| {
            (
                MARGIN + p.0 / x.end() * (width - 2.0 * MARGIN),
                height - MARGIN - p.1 / y.end() * (height - 2.0 * MARGIN),
            )
        };
        let mut drawing = Drawing::new(width);
        let thin = Stroke::solid("#ccc", 1.0);
        for (value, label) in x.ticks() {
            let (px, py) = at((value, 0.0));
            drawing.line(&[(px, py), at((value, y.end()))], thin);
            drawing.text((px, py + 16.0), Anchor::Middle, WORDS, &label);
        }
        for (value, label) in y.ticks() {
            let (px, py) = at((0.0, value));
            drawing.line(&[(px, py), at((x.end(), value))], thin);
            drawing.text((px - 6.0, py + 4.0), Anchor::End, WORDS, &label);
        }
        drawing.text((width / 2.0, height - 16.0), Anchor::Middle, WORDS, self.x);
        drawing.text((MARGIN, MARGIN - 12.0), Anchor::Start, WORDS, self.y);
        for (k, (name, points, dots)) in self.lines.iter().enumerate() {
            let colour = COLOURS[k % COLOURS.len()];
            let places: Vec<(f64, f64)> = points.iter().map(|p| at(*p)).collect();
            if *dots {
                for place in &places {
                    drawing.circle(*place, 2.5, colour, Stroke::solid(colour, 1.0));
                }
            }
            drawing.line(&places, Stroke::solid(colour, 1.2));
            let key = (width - MARGIN - 130.0, MARGIN + 16.0 * k as f64);
            drawing.line(
                &[(key.0 - 24.0, key.1 - 4.0), (key.0 - 4.0, key.1 - 4.0)],
                Stroke::solid(colour, 2.0),
            );
            drawing.text(key, Anchor::Start, WORDS, name);
        }
        drawing.finish(height, self.title, "From our simulations; see reproduced.txt.")
    }
}
