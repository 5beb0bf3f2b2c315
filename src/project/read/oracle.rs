//! The reader against the `ron` crate, which reads the same structs in a way of its own.
//!
//! What this reader takes, `ron` takes as the same project, but for
//! - words in quotes (`branch: "published"`, `overlay: "true"`), which files in use may have.
//!
//! What `ron` takes, this reader takes as the same project, but for
//! - brackets or comments nested deeper than 64;
//! - numbers that are infinite or none at all, which no field may be; `b'a'`, which is no number to a
//!   person; ranges (`1..2`); an underscore between an exponent and its sign;
//! - extensions of RON but `implicit_some`, which is on anyway;
//! - a name before the brackets of a mesh that is not `MeshType`;
//! - strings with `\` before a line end, and with one character spelt as several `\x`.

use super::values;
use crate::mesh::MeshType;
use crate::mesh::adopted::NamedMethods;
use crate::mesh::wire::{CurvePoint, Distortion, NetGeometry, Slack, WireData};
use crate::mesh::{LabRecord, RatioRecord, Statistic};
use crate::project::decode::ProjectFile;
use crate::project::schema::Project;
use crate::project::text::parser;
use crate::project::write::{compact, pretty, ron_options};
use proptest::prelude::*;
use proptest::sample::Index;
use std::fs;
use std::path::Path;

/// What makes `ron` take a text that this reader refuses, by what is said of it.
const REFUSED_HERE: &[&str] = &[
    "nested too deep",
    "is infinite",
    "is not a number",
    "no escape that RON knows",
    "no RON extensions",
    "stands before the bracket",
];

fn by_ron(text: &str) -> Result<Project, String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let file: ProjectFile = ron_options().from_str(text).map_err(|e| e.to_string())?;
    file.project().map_err(|problems| format!("{problems:?}"))
}

fn by_us(text: &str) -> Result<Project, String> {
    let tree = parser::parse(text).map_err(|e| e.problem.to_string())?;
    let file: ProjectFile = values(text, &tree.root, "")
        .map_err(|found| found.iter().map(|f| format!("{}\n", f.problem)).collect::<String>())?;
    file.project().map_err(|problems| format!("{problems:?}"))
}

/// Holds the two against each other.
fn compare(text: &str) -> Result<(), TestCaseError> {
    match (by_us(text), by_ron(text)) {
        (Ok(ours), Ok(theirs)) => prop_assert_eq!(ours, theirs, "{}", text),
        (Ok(_), Err(said)) => {
            let quoted =
                ["\"published\"", "\"conservative\"", "\"true\"", "\"false\"", "\"m\"", "\"mm\""];
            prop_assert!(quoted.iter().any(|q| text.contains(q)), "ron refuses: {said}\n{text}");
        }
        (Err(said), Ok(_)) => {
            let byte = text.contains("b'") && said.contains("is expected here");
            let odd = |piece: &str| text.contains(piece) && said.contains("this is no number");
            let known = byte
                || odd("..")
                || odd("e_")
                || odd("E_")
                || REFUSED_HERE.iter().any(|known| said.contains(known));
            prop_assert!(known, "only ron takes it: {said}\n{text}");
        }
        (Err(_), Err(_)) => {}
    }
    Ok(())
}

/// All good files of the current version, and one with a kept check.
fn texts() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = Vec::new();
    for dir in ["projects", "tests/files/valid", "tests/golden/inputs"] {
        for entry in fs::read_dir(root.join(dir)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|e| e == "ron") {
                texts.push(fs::read_to_string(path).unwrap());
            }
        }
    }
    texts.retain(|text| by_us(text).is_ok());
    assert!(texts.len() > 10 && texts.iter().any(|t| t.contains("curve_delta")));
    texts
}

/// Pieces on which two readers may differ.
const PIECES: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    "\"",
    "'",
    "\\",
    "/*",
    "*/",
    "//",
    "\n",
    "\u{feff}",
    "1e999",
    "NaN",
    "-",
    "r#\"",
    "Some(",
    "None",
    "None,",
    "d",
    "_",
    "1_0",
    "0x1F",
    "3f64",
    ".5",
    "1e5",
    "0.1f32",
    "7u8",
    "300u8",
    "b'a'",
    "é",
    "r#name",
    "\\u{e4}",
    "\\x41",
    "true",
    "published",
    "Layout",
    "Project(",
    "ex: Some(0.1),",
    "ey: \"10 mm\",",
    "overlay: true,",
    "overlay: \"true\",",
    "note: \"a\\tb\",",
    "#![enable(implicit_some)]",
    "#![enable(unwrap_newtypes)]",
];

proptest! {
    // 600 spoilt texts take about two seconds; a rule on which the two differ shows within a few hundred.
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spoilt_projects_are_read_alike(
        which in any::<Index>(),
        changes in prop::collection::vec((any::<Index>(), 0usize..30, any::<Index>()), 0..4),
    ) {
        let texts = texts();
        let mut text: Vec<char> = which.get(&texts).chars().collect();
        for (at, cut, piece) in changes {
            let at = at.index(text.len() + 1);
            // Most changes only put something in, so that some of the texts stay good.
            let end = (at + cut.saturating_sub(20)).min(text.len());
            text.splice(at..end, piece.get(PIECES).chars());
        }
        compare(&text.into_iter().collect::<String>())?;
    }

    #[test]
    fn values_are_read_alike(number in "[-+]?[0-9_.eEfxobu]{1,8}", text in "\\PC{0,20}") {
        let text = format!("{text:?}");
        for value in [number.as_str(), &text] {
            let fields = format!("name: \"a\", d: 0.3, L: 3, D: 1, ex: {value}");
            compare(&format!("(version: 2, name: {text}, layouts: [({fields})])"))?;
        }
    }

    #[test]
    fn meshes_come_back_as_ron_writes_them(mesh in meshes()) {
        for text in [compact(&mesh).unwrap(), pretty(&mesh).unwrap()] {
            let tree = parser::parse(&text).unwrap();
            let ours = values::<MeshType>(&text, &tree.root, "").unwrap();
            let theirs = ron_options().from_str::<MeshType>(&text).unwrap();
            prop_assert_eq!(&ours, &mesh, "{}", text);
            prop_assert_eq!(ours, theirs);
        }
    }
}

fn wires() -> impl Strategy<Value = WireData> {
    let number = || -1e3..1e3_f64;
    let points = || prop::collection::vec((-1.0..1.0_f64, number()), 0..4);
    let net = prop::array::uniform6(number());
    let slack = prop_oneof![number().prop_map(Slack::Fixed), Just(Slack::Triangular)];
    (net, points(), points(), number(), slack, "\\PC{0,9}").prop_map(
        |(
            [opening, twist, projection, diameter, node_mass, node_radius],
            a,
            b,
            u,
            slack,
            source,
        )| {
            let curve = |points: Vec<(f64, f64)>| {
                points.into_iter().map(|(strain, stress)| CurvePoint(strain, stress)).collect()
            };
            WireData {
                net: NetGeometry { opening, twist, projection, diameter, node_mass, node_radius },
                single: curve(a),
                double_twist: curve(b),
                distortion: Distortion { lambda_u: u, lambda_f: u / 3.0, slack },
                source,
            }
        },
    )
}

fn meshes() -> impl Strategy<Value = MeshType> {
    let text = || "[ -~äß石\n\t\"]{0,12}";
    let flags = any::<[bool; 3]>();
    let lab = (1.0..1e6_f64, 0.01..9.0_f64, text(), text());
    let ratios = prop::option::of((0.1..9.0_f64, 0.1..9.0_f64, text()));
    (text(), text(), flags, lab, ratios, prop::option::of(wires())).prop_map(
        |(
            id,
            name,
            [reference, example, mean],
            (kilonewton, deflection, standard, source),
            ratios,
            wire,
        )| {
            MeshType {
                id,
                name,
                reference,
                example,
                laboratory: LabRecord {
                    // Whole kilonewtons, so that the way to the file and back is exact.
                    force: kilonewton.round() * 1000.0,
                    deflection: (!example).then_some(deflection),
                    statistic: if mean { Statistic::Mean } else { Statistic::Characteristic },
                    panel: 3.0,
                    punch: deflection / 7.0,
                    date: standard.clone(),
                    standard,
                    source,
                },
                ratios: ratios.map(|(force, deflection, source)| RatioRecord {
                    force,
                    deflection,
                    source,
                }),
                wire,
                adopted: None,
                methods: NamedMethods::default(),
            }
        },
    )
}

#[test]
fn the_ways_in_which_ron_differs_are_the_ones_stated() {
    let with = |value: &str| {
        format!("(version: 2, name: \"p\", layouts: [(name: \"a\", d: 0.3, L: 3, D: 1, {value})])")
    };
    for ours in ["branch: \"published\"", "overlay: \"true\""] {
        assert!(by_us(&with(ours)).is_ok() && by_ron(&with(ours)).is_err(), "{ours}");
    }
    let deep = format!("{}{}ex: 0.1", "/*".repeat(70), "*/".repeat(70));
    for theirs in ["ex: b'a'", "note: \"a\\\n   b\"", "note: \"\\xc3\\xa4\"", &deep] {
        assert!(by_us(&with(theirs)).is_err() && by_ron(&with(theirs)).is_ok(), "{theirs}");
    }
    for both in ["ex: Some(0.1)", "ex: None", "note: r#\"\"a\"\"#", "ex: 1_0e-1", "r#ex: 0.1"] {
        assert_eq!(by_us(&with(both)), by_ron(&with(both)), "{both}");
        assert!(by_us(&with(both)).is_ok(), "{both}");
    }
    for neither in
        ["ex: Some(Some(0.1))", "ex: 300u8", "ex: 1._5", "ex: inf", "blocks: 1", "note: 'a'"]
    {
        assert!(by_us(&with(neither)).is_err() && by_ron(&with(neither)).is_err(), "{neither}");
    }
}
