//! Charts and plans: well-formed, whole, inside their frame, the same every time.

use super::{good, keep, odd, projects, sample};
use meshcast::curve::{Curve, Point};
use meshcast::export::svg::{Series, chart, plan};
use meshcast::export::{Band, Check, ExportedLayout};
use meshcast::forecast::rescaled;
use meshcast::project::{Project, parse};
use meshcast::units::Units;
use roxmltree::{Document, Node};

fn number(node: &Node, name: &str) -> f64 {
    let text = node.attribute(name).unwrap_or_else(|| panic!("{node:?} has no {name}"));
    text.parse().unwrap_or_else(|_| panic!("{name} of {node:?} is {text:?}"))
}

/// Corners of what a node draws. Text is taken as wide as wide fonts make it.
fn corners(node: &Node) -> Vec<(f64, f64)> {
    let n = |name| number(node, name);
    match node.tag_name().name() {
        "rect" => vec![(n("x"), n("y")), (n("x") + n("width"), n("y") + n("height"))],
        "circle" => {
            let (x, y, r) = (n("cx"), n("cy"), n("r"));
            vec![(x - r, y - r), (x + r, y + r)]
        }
        "polyline" | "polygon" => {
            let points = node.attribute("points").unwrap();
            let pair = |p: &str| {
                let (x, y) = p.split_once(',').unwrap();
                (x.parse().unwrap(), y.parse().unwrap())
            };
            points.split(' ').map(pair).collect()
        }
        "text" => {
            use unicode_width::UnicodeWidthStr;
            let (x, y, size) = (n("x"), n("y"), n("font-size"));
            let wide = node.text().unwrap_or_default().width() as f64 * size * 0.6;
            let left = match node.attribute("text-anchor") {
                Some("middle") => wide / 2.0,
                Some("end") => wide,
                _ => 0.0,
            };
            if node.attribute("transform").is_some() {
                return vec![(x - size, y - wide / 2.0), (x, y + wide / 2.0)];
            }
            vec![(x - left, y - size), (x - left + wide, y + size * 0.25)]
        }
        "svg" | "title" | "desc" => Vec::new(),
        other => panic!("an unexpected {other}"),
    }
}

/// Fails where a picture is not well-formed, leaves its frame, or names something outside itself.
pub(crate) fn assert_sound(svg: &str) {
    let document = Document::parse(svg).expect("a picture is well-formed XML");
    let root = document.root_element();
    let frame: Vec<f64> =
        root.attribute("viewBox").unwrap().split(' ').map(|n| n.parse().unwrap()).collect();
    assert_eq!((frame[0], frame[1]), (0.0, 0.0));
    for node in root.descendants().filter(Node::is_element) {
        for attribute in node.attributes() {
            let (name, value) = (attribute.name(), attribute.value());
            assert!(!["id", "href", "style", "class", "onload"].contains(&name), "{name}");
            for bad in ["NaN", "inf", "url(", "http"] {
                assert!(!value.contains(bad), "{name}={value:?}");
            }
            assert!(!value.is_empty(), "{name} of {node:?} is empty");
        }
        for (x, y) in corners(&node) {
            let inside = (0.0..=frame[2]).contains(&x) && (0.0..=frame[3]).contains(&y);
            assert!(inside, "{x}, {y} outside {frame:?}: {node:?} {:?}", node.text());
        }
    }
}

fn words(svg: &str) -> String {
    let document = Document::parse(svg).unwrap();
    // Words have a rim, a text of its own that is hidden from those who listen.
    let texts = document
        .descendants()
        .filter(|n| n.has_tag_name("text") && n.attribute("aria-hidden").is_none());
    texts.filter_map(|n| n.text()).collect::<Vec<_>>().join(" ")
}

fn chart_of(cases: &[ExportedLayout], title: &str, unit: Units) -> String {
    chart(&cases.iter().map(Series::from).collect::<Vec<_>>(), title, unit)
}

#[test]
fn charts_are_sound_and_name_every_layout() {
    for (index, project) in projects().iter().enumerate() {
        let cases = good(project);
        for unit in [Units::METRES, Units::MILLIMETRES] {
            let svg = chart_of(&cases, &project.name, unit);
            assert_sound(&svg);
            let said = words(&svg);
            // Long names go on in the next line.
            let said = said.replace(' ', "");
            // The chart of one layout is named by its title.
            for case in cases.iter().filter(|_| cases.len() > 1) {
                assert!(said.contains(&case.entry.name.replace(' ', "")), "{said}");
            }
            assert_eq!(svg, chart_of(&good(project), &project.name, unit), "not the same twice");
            keep(&format!("chart-{index}-{}.svg", unit.symbol()), &svg);
        }
        for (number, case) in cases.iter().enumerate() {
            let svg = chart(&[Series::from(case)], &case.entry.name, project.display.units);
            assert_sound(&svg);
            keep(&format!("chart-{index}-layout-{number}.svg"), &svg);
        }
    }
}

#[test]
fn plans_are_sound() {
    for (index, project) in projects().iter().enumerate() {
        for (number, case) in good(project).iter().enumerate() {
            let svg = plan(case, project.display.units);
            assert_sound(&svg);
            assert!(words(&svg).contains("twists of the net"));
            keep(&format!("plan-{index}-{number}.svg"), &svg);
        }
    }
}

#[test]
fn a_chart_says_what_it_shows() {
    let cases = good(&sample("road-cut.ron"));
    let portal = words(&chart_of(&cases[2..3], "portal", Units::METRES));
    for said in [
        "deflection \u{3b4} (m)",
        "force F (kN)",
        "forecast: failure at 31.0 kN, 0.623 m",
        "73.3 kN at 0.600 m",
        "only its end point was published",
        "design force 20.0 kN x 1.3 = 26.0 kN",
        "failure force / 1.25 = 24.8 kN",
        "allowable deflection 0.60 m",
    ] {
        assert!(portal.contains(said), "{said:?} is missing: {portal}");
    }
    let odd = good(&odd());
    let of = |index: usize| words(&chart_of(&odd[index..=index], "odd", Units::MILLIMETRES));
    assert!(of(0).contains("by the other branch (small punch)"), "{}", of(0));
    assert!(of(0).contains("deflection \u{3b4} (mm)"));
    assert!(of(1).contains("no field value: the block is on an anchor plate"));
    assert!(of(2).contains("extrapolated") && of(2).contains("(beyond the chart)"), "{}", of(2));
    assert!(of(3).contains("design force 500 kN (beyond the chart)"), "{}", of(3));
}

#[test]
fn what_all_layouts_are_asked_for_stands_in_their_chart() {
    let mut project = sample("road-cut.ron");
    let shown = |project: &Project| words(&chart_of(&good(project), "all", Units::METRES));
    // Loads of 8 to 20 kN, and one without: there is no line for all of them.
    assert!(!shown(&project).contains("design force"));
    for named in &mut project.layouts {
        (named.question.force, named.question.pressure) = (Some(20_000.0), None);
        (named.question.gamma_load, named.question.deflection) = (1.0, Some(0.4));
    }
    let words = shown(&project);
    assert!(words.contains("design force 20.0 kN"), "{words}");
    assert!(words.contains("allowable deflection 0.40 m"), "{words}");
}

#[test]
fn an_empty_project_has_an_empty_chart() {
    assert_sound(&chart(&[], "nothing", Units::METRES));
}

#[test]
fn more_layouts_than_styles_are_told_apart_by_numbers() {
    let mut project = sample("spacing-study.ron");
    let first = project.layouts[0].clone();
    for n in 0..45 {
        let mut one = first.duplicate(format!("layout number {n}"));
        one.layout.spacing = 2.0 + 0.05 * f64::from(n);
        project.layouts.push(one);
    }
    let svg = chart_of(&good(&project), "many", Units::METRES);
    assert_sound(&svg);
    assert!(words(&svg).contains("layout number 44"));
    keep("chart-many.svg", &svg);
}

/// A check somewhat off the forecast, with a band.
fn check(case: &ExportedLayout) -> Check {
    let mut values = case.forecast().field.expect("a field value").end().expect("a curve");
    values.force *= 1.08;
    values.deflection *= 1.03;
    let mean: Curve = rescaled(values, 60);
    let part = |f: f64| mean.force.iter().map(|force| force * f).collect::<Vec<f64>>();
    let band = Band { deflection: mean.deflection.clone(), low: part(0.9), high: part(1.1) };
    let breaks = [0.92, 0.97, 1.0, 1.06]
        .map(|f| Point { deflection: values.deflection * f, force: values.force * f })
        .to_vec();
    Check {
        label: "check, 16 runs".into(),
        mean,
        band: Some(band),
        breaks,
        notes: vec!["the error estimate is 2 %".into()],
        stale: false,
    }
}

#[test]
fn a_check_is_drawn_over_its_forecast() {
    let cases = good(&sample("road-cut.ron"));
    let checked = check(&cases[2]);
    let series = [Series { case: &cases[2], check: Some(&checked) }];
    let svg = chart(&series, "portal", Units::METRES);
    assert_sound(&svg);
    let said = words(&svg);
    assert!(said.contains("check, 16 runs: first break at 33.5 kN, 0.642 m"), "{said}");
    keep("chart-check.svg", &svg);

    let stale = Check { stale: true, ..checked };
    let both = [Series { case: &cases[2], check: Some(&stale) }, Series::from(&cases[0])];
    let svg = chart(&both, "two", Units::METRES);
    assert_sound(&svg);
    assert!(words(&svg).contains("stale: inputs have changed since"));
    keep("chart-check-two.svg", &svg);
}

/// Seen: in renderers that do not know `paint-order` all words were white. Cause: the white rim was the
/// stroke of the words themselves, which is painted over their fill unless that attribute is understood.
#[test]
fn words_do_not_hang_on_the_order_of_painting() {
    let project = &projects()[0];
    let svg = chart_of(&good(project), "chart", Units::METRES);
    let document = Document::parse(&svg).unwrap();
    assert!(!svg.contains("paint-order"));
    let texts: Vec<_> = document.descendants().filter(|n| n.has_tag_name("text")).collect();
    for pair in texts.chunks(2) {
        let [rim, words] = pair else { panic!("a text without its rim") };
        assert_eq!(rim.text(), words.text());
        assert_eq!(
            (rim.attribute("x"), rim.attribute("y")),
            (words.attribute("x"), words.attribute("y"))
        );
        assert!(rim.attribute("stroke").is_some() && words.attribute("stroke").is_none());
    }
    assert!(texts.len() > 20);
}

/// Fig. 7a of the paper: what the simulated curves lie between, around the forecast.
#[test]
fn the_chart_of_a_derived_forecast_has_the_envelope_of_the_curves() {
    let svg = |method: &str| {
        let text = format!(
            r#"(version: 2, name: "p", layouts: [(name: "a", d: 0.32, L: 3.0, D: 1.0, blocks: repeated, method: "{method}")])"#
        );
        chart_of(&good(&parse(&text, "p.ron").expect("it opens").project), "a", Units::METRES)
    };
    let lines = |svg: &str| -> Vec<Vec<(f64, f64)>> {
        let document = Document::parse(svg).unwrap();
        let dotted = |n: &Node| n.attribute("stroke-dasharray") == Some("1 4");
        let lines = document.descendants().filter(|n| n.has_tag_name("polyline") && dotted(n));
        lines.map(|n| corners(&n)).filter(|points| points.len() > 2).collect()
    };
    let derived = svg("derived");
    assert_sound(&derived);
    assert!(words(&derived).contains("90 % of the simulated curves"), "{}", words(&derived));
    let found = lines(&derived);
    let [low, high] = &found[..] else { panic!("{} lines", found.len()) };
    // 21 points each, from the same start to the same end; up on the page is less.
    assert_eq!((low.len(), high.len()), (21, 21));
    assert_eq!((low[0], low[20]), (high[0], high[20]));
    assert!((1..20).all(|k| low[k].1 > high[k].1));
    let published = svg("pol-gabrieli-2021");
    assert!(lines(&published).is_empty() && !words(&published).contains("90 % of the simulated"));
}
