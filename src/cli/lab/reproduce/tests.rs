//! The files of a small reproduction.

use super::*;
use crate::dem::{Fidelity, Flow};
use crate::export::svg::drawing::text_width;
use roxmltree::{Document, Node};
use std::sync::OnceLock;

/// Few runs: what is drawn, not what comes out.
const SMALL: ReproducePlan = ReproducePlan {
    runs: 60,
    beside: [1, 2],
    every: 4,
    seed: 2,
    fidelity: Fidelity::Quick,
    threads: 2,
};

fn small() -> &'static Reproduced {
    static MADE: OnceLock<Reproduced> = OnceLock::new();
    MADE.get_or_init(|| {
        let go_on = |_: &str, _, _, _| Flow::Continue;
        reproduce(&SMALL, &catalogue::reference(), &go_on).unwrap().unwrap()
    })
}

/// The words of a picture, after its form was looked at: well-formed, and no word beyond its edge.
fn words(svg: &str) -> String {
    let document = Document::parse(svg).unwrap();
    let number = |node: &Node, name| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let width = number(&document.root_element(), "width");
    let mut all = String::new();
    for node in document.descendants().filter(|n| n.has_tag_name("text")) {
        let text = node.text().unwrap();
        let long = text_width(text, number(&node, "font-size"));
        let before = match node.attribute("text-anchor").unwrap() {
            "start" => 0.0,
            "middle" => long / 2.0,
            _ => long,
        };
        let left = number(&node, "x") - before;
        let upright = node.attribute("transform").is_some();
        assert!(upright || (left >= 0.0 && left + long <= width), "{text}: {left} + {long}");
        if node.attribute("aria-hidden").is_none() {
            all += text;
            all.push(' ');
        }
    }
    all
}

#[test]
fn every_figure_has_its_axes_with_units_and_the_values_that_the_paper_prints() {
    let pictures = pictures::all(small());
    let expected: [(&str, [&str; 2], &[&str]); 11] = [
        ("fig3.svg", ["\u{3b4} (m)", "F (kN)"], &["D = 0.5 m", "D = 2.5 m", "L = 4 m", "D = 1 m"]),
        ("fig4a.svg", ["D or L (m)", "F (kN)"], &["Eq. 1"]),
        ("fig4b.svg", ["D or L (m)", "\u{3b4} (m)"], &["Eq. 2", "D/L = 0.4"]),
        (
            "fig6.svg",
            ["\u{3b4} (m)", "F (kN)"],
            &["F_l*", "\u{3b4}_a*", "73.3 kN at 0.600 m", "29.1 kN at 0.650 m"],
        ),
        ("fig7a.svg", ["\u{3b4}/\u{3b4}_a", "F/F_a"], &["5 to 95 %", "1.312"]),
        // Table 1: the paper's simulation and its forecast.
        (
            "fig7b.svg",
            ["\u{3b4} (m)", "F (kN)"],
            &["22.6 kN at 0.560 m", "22.8 kN at 0.5", "d = 0.25, L = 2.5, D = 0.6 m"],
        ),
        ("fig7c.svg", ["\u{3b4} (m)", "F (kN)"], &["13.4 kN at 0.490 m", "13.0 kN at 0.4"]),
        ("fig7d.svg", ["\u{3b4} (m)", "F (kN)"], &["30.9 kN at 0.620 m", "31.0 kN at 0.6"]),
        (
            "fig7e.svg",
            ["\u{3b4} (m)", "F (kN)"],
            &["34.9 kN at 0.670 m", "37.1 kN at 0.6", "repeated", "mirrored", "ex = 2, ey = 0.2 m"],
        ),
        (
            "fig7f.svg",
            ["\u{3b4} (m)", "F (kN)"],
            &["14.9 kN at 0.650 m", "15.3 kN at 0.6", "repeated", "mirrored"],
        ),
        (
            "figa1.svg",
            ["ex/L", "ey/L"],
            &[
                "factor on F",
                "factor on \u{3b4}",
                "1: 0.628",
                "2: 1.14",
                "1: 0.850",
                "2: 0.815",
                "plate",
            ],
        ),
    ];
    let names: Vec<&str> = pictures.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, expected.map(|(name, _, _)| name));
    for ((name, svg), (_, axes, parts)) in pictures.iter().zip(expected) {
        let words = words(svg);
        for part in axes.iter().chain(parts) {
            assert!(words.contains(part), "{name}: {part}: {words}");
        }
        assert!(words.contains("our"), "{name}: {words}");
    }
}

#[test]
fn a_paper_point_stands_where_its_numbers_are() {
    // Fig. 6 at 0.60 m and 73.3 kN: between the ticks of 0.6 and 0.7 m, and of 60 and 80 kN.
    let pictures = pictures::all(small());
    let (_, svg) = pictures.iter().find(|(name, _)| *name == "fig6.svg").unwrap();
    let document = Document::parse(svg).unwrap();
    let tick = |text: &str, along: &str| {
        let mut ticks = document.descendants().filter(|n| n.has_tag_name("text"));
        let node = ticks.find(|n| n.text() == Some(text)).unwrap();
        node.attribute(along).unwrap().parse::<f64>().unwrap()
    };
    let discs: Vec<(f64, f64)> = document
        .descendants()
        .filter(|n| n.has_tag_name("circle") && n.attribute("fill") == Some("#000"))
        .map(|n| [n.attribute("cx"), n.attribute("cy")].map(|v| v.unwrap().parse().unwrap()))
        .map(|[x, y]| (x, y))
        .collect();
    // Two in the plot, and each again in the legend.
    assert_eq!(discs.len(), 4);
    let (x, y) = discs[0];
    assert!((x - tick("0.6", "x")).abs() < 0.02, "{x}");
    // The numbers stand 4.5 below their line.
    let [low, high] = ["60", "80"].map(|text| tick(text, "y") - 4.5);
    let by_hand = low + (73.3 - 60.0) / 20.0 * (high - low);
    assert!((y - by_hand).abs() < 0.02, "{y} {by_hand}");
}

#[test]
fn the_text_has_a_map_and_both_arrangements_at_the_points_of_the_paper() {
    let text = text(&SMALL, small());
    let row = text.lines().find(|line| line.starts_with("Fig. 4 ")).unwrap();
    assert!(row.contains("D/L from which delta") && row.contains("0.400"), "{row}");
    let map = text.split("Fig. A1: factors of an offset").nth(1).unwrap();
    assert!(map.contains("rows ey/L, columns ex/L") && map.contains("plate"), "{map}");
    // Six rows below the head.
    assert_eq!(map.lines().skip(2).count(), 6, "{map}");
    assert!(map.lines().last().unwrap().starts_with("     0  1.00 1.00"), "{map}");
    for (stand, label) in [("repeated", "predicted"), ("mirrored", "after the fact")] {
        for what in ["F", "delta"] {
            for at in ["(0.157, 0.329)", "(0.5, 0.05)"] {
                let words = format!("factor on {what} at {at} L, {stand}");
                let row = text.lines().find(|line| line.contains(&words)).unwrap();
                assert!(row.starts_with("Fig. A1") && row.contains(label), "{row}");
            }
        }
    }
}

#[test]
fn the_curves_of_fig_6_end_at_the_values_of_the_table() {
    let made = small();
    for (mean, anchor) in made.star.iter().zip([&made.method.laboratory, &made.method.reference]) {
        let end = mean.curve.failure.unwrap();
        // The file of a method has five digits.
        assert!((end.force / anchor.force - 1.0).abs() < 1e-4, "{end:?} {anchor:?}");
        assert!((end.deflection / anchor.deflection - 1.0).abs() < 1e-4, "{end:?} {anchor:?}");
        assert_eq!(mean.band[0].len(), mean.curve.force.len());
        let around = mean.band[0].iter().zip(&mean.band[1]).zip(&mean.curve.force);
        assert!(around.clone().all(|((low, high), force)| low <= force && force <= high));
    }
}
