//! Random texts and random edits.

use super::samples::{files, sample};
use meshcast::layout::BranchRule;
use meshcast::project::{self, MeshUse, NamedLayout, Project};
use meshcast::study::verdict::Basis;
use meshcast::units::{ForceUnit, LengthUnit, Units};
use proptest::prelude::*;
use proptest::sample::Index;
use std::fs;

/// Texts to spoil: all good files that are no more than a few kilobytes, as all of them are.
fn texts() -> Vec<String> {
    let all = files("projects").into_iter().chain(files("tests/files/valid"));
    all.map(|path| fs::read_to_string(path).unwrap()).collect()
}

/// Pieces that mean something in a project file.
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
    "\r",
    "\u{feff}",
    "1e999",
    "NaN",
    "-",
    "r#\"",
    "Some(",
    "None",
    "L: 2,7,",
    "d",
    "version: 0",
    "é",
    "石",
    "\0",
    "0x",
    "b'",
    "#![enable(",
];

/// Places, lengths and pieces of changes.
fn changes() -> impl Strategy<Value = Vec<(Index, usize, Index)>> {
    prop::collection::vec((any::<Index>(), 0usize..40, any::<Index>()), 1..8)
}

/// Spoils a good text; it is then a project that can be edited and saved, or refused in a few lines.
fn spoilt(which: Index, changes: Vec<(Index, usize, Index)>) -> Result<(), TestCaseError> {
    let texts = texts();
    let mut text: Vec<char> = which.get(&texts).chars().collect();
    for (at, cut, piece) in changes {
        let at = at.index(text.len() + 1);
        let end = (at + cut % 20).min(text.len());
        // Half of the changes only put something in.
        let end = if cut < 20 { at } else { end };
        text.splice(at..end, piece.get(PIECES).chars());
    }
    let text: String = text.into_iter().collect();
    match project::parse(&text, "spoilt") {
        Ok(opened) => {
            prop_assert_eq!(opened.project.check(), Ok(()));
            let mut edited = opened.project.clone();
            edited.site = "elsewhere".into();
            let rendered = opened.document.render(&edited).unwrap();
            let again = project::parse(&rendered.text, "again")
                .map_err(|e| TestCaseError::fail(format!("{e}\n{}", rendered.text)))?;
            prop_assert_eq!(again.project, edited);
        }
        Err(error) => {
            let said = error.to_string();
            prop_assert!((2..=15).contains(&said.lines().count()), "{}", said);
        }
    }
    Ok(())
}

proptest! {
    // Up to eight changes a case, the 2,000 in about five seconds; what they may find is a panic, an
    // endless loop or a message that does not fit.
    #![proptest_config(ProptestConfig { cases: 2_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn spoilt_texts_are_opened_or_refused_and_nothing_else(which in any::<Index>(), changes in changes()) {
        spoilt(which, changes)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    #[ignore = "an attack of a minute: cargo test --test files -- --ignored"]
    fn many_spoilt_texts_are_opened_or_refused_and_nothing_else(which in any::<Index>(), changes in changes()) {
        spoilt(which, changes)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn anything_at_all_is_no_reason_to_panic(text in "\\PC{0,60}") {
        let _ = project::parse(&text, "anything");
        let _ = project::parse(&format!("(version: 1, name: \"p\", layouts: [({text})])"), "inside");
    }
}

/// One thing that a user can do.
#[derive(Debug, Clone)]
enum Deed {
    Number(Index, u8, f64),
    Force(Index, Option<f64>),
    Deflection(Index, Option<f64>),
    Branch(Index, bool),
    Overlay(Index, bool),
    Note(Index, String),
    Rename(Index, String),
    Copy(Index),
    Remove(Index),
    Swap(Index, Index),
    Site(String),
    Checker(String),
    Basis(bool),
    Unit(bool),
}

fn deed() -> impl Strategy<Value = Deed> {
    let text = "[ -~äß石\n]{0,20}";
    prop_oneof![
        (any::<Index>(), 0u8..7, 0.01f64..1.0).prop_map(|(i, f, v)| Deed::Number(i, f, v)),
        (any::<Index>(), prop::option::of(1.0f64..1e6)).prop_map(|(i, v)| Deed::Force(i, v)),
        (any::<Index>(), prop::option::of(0.01f64..5.0)).prop_map(|(i, v)| Deed::Deflection(i, v)),
        (any::<Index>(), any::<bool>()).prop_map(|(i, v)| Deed::Branch(i, v)),
        (any::<Index>(), any::<bool>()).prop_map(|(i, v)| Deed::Overlay(i, v)),
        (any::<Index>(), text).prop_map(|(i, v)| Deed::Note(i, v)),
        (any::<Index>(), "[ -~äß石]{1,20}").prop_map(|(i, v)| Deed::Rename(i, v)),
        any::<Index>().prop_map(Deed::Copy),
        any::<Index>().prop_map(Deed::Remove),
        (any::<Index>(), any::<Index>()).prop_map(|(i, j)| Deed::Swap(i, j)),
        "[ -~äß石]{0,20}".prop_map(Deed::Site),
        "[ -~äß石]{0,20}".prop_map(Deed::Checker),
        any::<bool>().prop_map(Deed::Basis),
        any::<bool>().prop_map(Deed::Unit),
    ]
}

fn one(project: &mut Project, index: Index) -> Option<&mut NamedLayout> {
    let count = project.layouts.len();
    (count > 0).then(|| &mut project.layouts[index.index(count)])
}

fn act(project: &mut Project, deed: &Deed) {
    match deed.clone() {
        Deed::Site(text) => project.site = text,
        Deed::Checker(text) => project.title.checker = text,
        Deed::Basis(mean) => {
            project.basis = if mean { Basis::Mean } else { Basis::Characteristic };
        }
        Deed::Unit(mm) => {
            let feet = Units { length: LengthUnit::Foot, force: ForceUnit::Kip };
            project.display.units = if mm { Units::MILLIMETRES } else { feet };
        }
        Deed::Copy(i) => {
            if let Some(layout) = one(project, i).cloned() {
                let name = project.free_name(&layout.name);
                let at = i.index(project.layouts.len());
                project.layouts.insert(at + 1, layout.duplicate(name));
            }
        }
        Deed::Remove(i) => {
            if !project.layouts.is_empty() {
                project.layouts.remove(i.index(project.layouts.len()));
            }
        }
        Deed::Swap(i, j) => {
            let count = project.layouts.len();
            if count > 0 {
                project.layouts.swap(i.index(count), j.index(count));
            }
        }
        Deed::Rename(i, name) => {
            let name = project.free_name(&name);
            if let Some(l) = one(project, i) {
                l.name = name;
            }
        }
        Deed::Number(i, field, v) => {
            if let Some(l) = one(project, i) {
                match field {
                    0 => l.layout.plate = v * l.layout.spacing * 0.99,
                    1 => l.layout.punch = v * l.layout.spacing * 0.99,
                    2 => {
                        l.layout.spacing = (l.layout.plate.max(l.layout.punch) + v * 3.0).min(99.0);
                    }
                    3 => l.layout.ex = v - 0.5,
                    4 => l.layout.ey = (v * 10.0).round() / 10.0 - 0.5,
                    5 => l.question.gamma_load = 0.5 + v,
                    _ => l.question.gamma_resistance = 1.0,
                }
            }
        }
        Deed::Force(i, v) => {
            if let Some(l) = one(project, i) {
                l.question.force = v;
            }
        }
        Deed::Deflection(i, v) => {
            if let Some(l) = one(project, i) {
                l.question.deflection = v;
            }
        }
        Deed::Branch(i, v) => {
            if let Some(l) = one(project, i) {
                l.branch = if v { BranchRule::Conservative } else { BranchRule::Published };
            }
        }
        Deed::Overlay(i, v) => {
            let four = project.layouts.iter().filter(|l| l.overlay).count() >= 4;
            if let Some(l) = one(project, i) {
                l.overlay = v && !four;
            }
        }
        Deed::Note(i, text) => {
            if let Some(l) = one(project, i) {
                l.note = text;
            }
        }
    }
}

/// The comments of a text, sorted.
fn comments(text: &str) -> Vec<String> {
    let tree = project::text::parser::parse(text).unwrap();
    let mut list: Vec<String> = tree.comments.iter().map(|c| c.slice(text).to_string()).collect();
    list.sort();
    list
}

proptest! {
    // 300 runs of up to ten deeds over all good files take about a second.
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn edits_come_back_from_the_file_and_comments_stay(
        which in any::<Index>(),
        deeds in prop::collection::vec(deed(), 1..10),
    ) {
        let texts = texts();
        let opened = project::parse(which.get::<String>(&texts), "good").unwrap();
        let mut edited = opened.project.clone();
        for deed in &deeds {
            act(&mut edited, deed);
        }
        prop_assert_eq!(edited.check(), Ok(()));
        let rendered = opened.document.render(&edited).unwrap();
        prop_assert!(rendered.comments_kept, "{}", rendered.text);
        let again = project::parse(&rendered.text, "again").unwrap();
        prop_assert_eq!(&again.project, &edited);
        // Comments go only with a layout that is taken away, and none is written twice.
        let gone = opened.project.layouts.iter().any(|l| edited.layouts.iter().all(|e| e.uid != l.uid));
        let (before, after) = (comments(&opened.document.render(&opened.project).unwrap().text), comments(&rendered.text));
        if gone {
            let mut rest = before;
            for comment in after {
                let at = rest.iter().position(|c| *c == comment);
                prop_assert!(at.is_some(), "{comment:?} is new in\n{}", rendered.text);
                rest.remove(at.unwrap());
            }
        } else {
            prop_assert_eq!(before, after);
        }
        // And back again: the old project in the new text.
        let back = again.document.render(&opened.project).unwrap();
        prop_assert_eq!(&project::parse(&back.text, "back").unwrap().project, &opened.project);
    }
}

#[test]
fn values_that_no_short_decimal_can_hold_come_back_exactly() {
    let opened = sample("road-cut.ron");
    let mut edited = opened.project.clone();
    edited.layouts[0].layout.plate = 0.1 + 0.2;
    edited.layouts[0].layout.ex = -1.0 / 3.0;
    edited.layouts[0].question.force = Some(25_000.000_000_000_4);
    edited.layouts[1].question.force = Some(f64::MIN_POSITIVE);
    edited.layouts[1].layout.ey = 5e-324;
    edited.layouts[2].question.force = Some(0.1 + 0.2);
    let MeshUse::Catalogue(_) = &edited.meshes[0] else { panic!() };
    let rendered = opened.document.render(&edited).unwrap();
    let again = project::parse(&rendered.text, "again").unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(again.project, edited, "{}", rendered.text);
    assert!(rendered.comments_kept);
}
