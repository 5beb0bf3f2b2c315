//! The form by which a mesh is adopted from its own tests: a row for each thing that a maker's sheet says.

use super::mesh_form::{FormKind, FormRow, MeshForm, Refusal, or_told, row};
use crate::lab::adopt::{MeshWords, RUNS, identifier};
use crate::lab::campaign::FEWEST_FOR_METHOD;
use crate::lab::fit::data::FirstBond;
use crate::lab::fit::sheet::Sheet;
use crate::mesh::{STANDARD_PANEL, STANDARD_PUNCH, Statistic, laws};
use crate::project::home::typed_path;
use crate::units::{Quantity, Units, from_kn, parse_typed};
use crate::words::Choice;
use std::path::{Path, PathBuf};

/// The rows, their fields by the flags of `meshcast adopt`; the last one's Enter begins the work.
const ROWS: [FormRow; 19] = [
    row(
        "name",
        "--name",
        "name of the mesh, for people; layouts name it by its letters and digits",
    ),
    row(
        "force",
        "--force",
        "force at failure of its punch test, kN or with a unit; empty: the curve's end",
    ),
    row(
        "deflection",
        "--deflection",
        "deflection at failure; empty: the curve's end, or not known",
    ),
    row("panel", "--panel", "side of the panel in the test; empty: 3 m"),
    row("punch", "--punch", "diameter of the punch, below the panel; empty: 1 m"),
    row(
        "opening",
        "--opening",
        "opening of the mesh, across the twists, 0.02 to 0.3 m; empty: 80 mm",
    ),
    row("twist", "--twist", "length of a double twist; empty: half of the opening"),
    row("wire", "--diameter", "diameter of the wire, 0.5 to 10 mm; empty: 2.7 mm"),
    row(
        "curve file",
        "--curve",
        "the test's whole curve: a CSV file with a header deflection_mm,force_kN; may be empty",
    ),
    row("k75", "--k75", "stiffness at 75 % of the force, by the tangent, kN/m; may be empty"),
    row(
        "along",
        "--strength-along",
        "strength of the net along its twists, kN/m; may be empty; a minute more",
    ),
    row(
        "across",
        "--strength-across",
        "strength of the net across its twists, kN/m; may be empty; a minute more",
    ),
    row("wire MPa", "--wire-strength", "strength of the wire, MPa; may be empty"),
    row("wire %", "--wire-elongation", "elongation of the wire at rupture, %; may be empty"),
    row(
        "breaks",
        "--breaks",
        "which bond breaks first in the punch test: twist or wire; empty: not known",
    ),
    row(
        "kind",
        "--kind",
        "of the values: mean, characteristic or minimum (m, c or mi will do); m example where made up",
    ),
    row("standard", "--standard", "standard of the test, such as ISO 17746; may be left empty"),
    row("runs", "--runs", "runs of random layouts, 60 to 5000; empty: 160"),
    row(
        "source",
        "--source",
        "where the values stand; Enter begins the work, a minute or two; Esc ends it",
    ),
];

/// An empty form.
pub(super) fn form() -> MeshForm {
    MeshForm::new(FormKind::Tests, &ROWS)
}

/// What is typed.
pub(super) struct Typed {
    pub(super) words: MeshWords,
    pub(super) sheet: Sheet,
    pub(super) curve: Option<PathBuf>,
    pub(super) runs: usize,
}

/// What is typed in a form of tests.
///
/// # Errors
/// All that is wrong, in the order of the rows.
pub(super) fn typed(form: &MeshForm, unit: Units) -> Result<Typed, Vec<Refusal>> {
    let mut wrong = Vec::new();
    let mut number = |field: &'static str, quantity| {
        let got = match form.text(field) {
            "" => Ok(None),
            text => parse_typed(text, quantity, unit).map(Some).map_err(|e| (field, e.to_string())),
        };
        or_told(got, &mut wrong)
    };
    let mut sheet = Sheet {
        force: number("--force", Quantity::Force),
        deflection: number("--deflection", Quantity::Length),
        panel: number("--panel", Quantity::Length).unwrap_or(STANDARD_PANEL),
        punch: number("--punch", Quantity::Length).unwrap_or(STANDARD_PUNCH),
        net: ["--opening", "--twist", "--diameter"].map(|field| number(field, Quantity::Length)),
        stiffness: number("--k75", Quantity::Number).map(from_kn),
        strengths: ["--strength-along", "--strength-across"]
            .map(|field| number(field, Quantity::Number).map(from_kn)),
        wire_strength: number("--wire-strength", Quantity::Number),
        wire_elongation: number("--wire-elongation", Quantity::Number)
            .map(|percent| percent / 100.0),
        ..Sheet::default()
    };
    let runs = number("--runs", Quantity::Number).unwrap_or(RUNS as f64);
    sheet.first = or_told(first_bond(form.text("--breaks")), &mut wrong);
    let name = form.text("--name");
    let id = identifier(name).ok_or(("--name", "a name needs letters or digits".to_string()));
    let id = or_told(id, &mut wrong);
    if !(FEWEST_FOR_METHOD as f64..=5000.0).contains(&runs) || runs.fract() != 0.0 {
        wrong.push(("--runs", format!("a whole number of runs, {FEWEST_FOR_METHOD} to 5000")));
    }
    let (statistic, example) = or_told(kind(form.text("--kind")).map(Some), &mut wrong)
        .unwrap_or((Statistic::Mean, false));
    let source = form.text("--source");
    if source.is_empty() {
        wrong.push(("--source", "a source is needed".into()));
    }
    let curve = Some(form.text("--curve")).filter(|text| !text.is_empty());
    // A curve may bring force and deflection; it is read behind the screen.
    if curve.is_none() {
        let found = sheet.clone().data(&laws::reference().net).err().unwrap_or_default();
        wrong.extend(found.iter().map(|problem| form.refusal(problem)));
    }
    if !wrong.is_empty() {
        return Err(form.in_order(wrong));
    }
    let words = MeshWords {
        id,
        name: name.into(),
        example,
        statistic,
        standard: form.text("--standard").into(),
        source: source.into(),
    };
    let curve = curve.map(|text| typed_path(Path::new(text)));
    Ok(Typed { words, sheet, curve, runs: runs as usize })
}

/// Which bond breaks first, where it is said.
fn first_bond(text: &str) -> Result<Option<FirstBond>, Refusal> {
    let fits = |bond: &&FirstBond| bond.word().starts_with(&text.to_lowercase());
    match text {
        "" => Ok(None),
        _ => FirstBond::ALL
            .iter()
            .find(fits)
            .map(|bond| Some(*bond))
            .ok_or(("--breaks", "twist or wire, or left empty".to_string())),
    }
}

/// Mean or characteristic, and whether the values are made up.
fn kind(text: &str) -> Result<(Statistic, bool), Refusal> {
    let wrong =
        || ("--kind", "mean, characteristic or minimum? with example where made up".to_string());
    let (mut statistic, mut example) = (None, false);
    for word in text.to_lowercase().split_whitespace() {
        match Statistic::ALL.iter().copied().find(|kind| kind.word().starts_with(word)) {
            Some(kind) => statistic = Some(kind),
            None if "example".starts_with(word) => example = true,
            None => return Err(wrong()),
        }
    }
    Ok((statistic.ok_or_else(wrong)?, example))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn filled(values: &[(&str, &str)]) -> MeshForm {
        let mut form = form();
        for (field, text) in values {
            let row = ROWS.iter().position(|row| row.field == *field).unwrap();
            form.lines[row].paste(text);
        }
        form
    }

    const EXAMPLE: [(&str, &str); 5] = [
        ("--name", "Example 6x8, 2.2"),
        ("--force", "20 kN"),
        ("--diameter", "2.2 mm"),
        ("--kind", "m example"),
        ("--source", "made up"),
    ];

    #[test]
    fn what_is_typed_is_read_with_its_units_and_the_rest_is_as_it_is_mostly() {
        let made = typed(&filled(&EXAMPLE), Units::METRES).unwrap();
        assert_eq!(made.words.id, "example-6x8-2.2");
        assert!(made.words.example && made.words.statistic == Statistic::Mean);
        assert_eq!(
            (made.sheet.force, made.sheet.net),
            (Some(20_000.0), [None, None, Some(0.0022)])
        );
        assert_eq!((made.sheet.panel, made.sheet.punch, made.runs), (3.0, 1.0, 160));
        // Bare lengths are in the unit of the screen.
        let with = [&EXAMPLE[..], &[("--panel", "1600"), ("--punch", "500")]].concat();
        let made = typed(&filled(&with), Units::MILLIMETRES).unwrap();
        assert_eq!((made.sheet.panel, made.sheet.punch), (1.6, 0.5));
    }

    #[test]
    fn each_row_that_is_wrong_is_named_with_what_it_may_be() {
        for (field, text, part) in [
            ("--force", "many", "many"),
            ("--force", "73300 kN", "10000"),
            ("--panel", "0.9", "below the panel"),
            ("--opening", "80 m", "0.02 to 0.3 m"),
            ("--k75", "0.2", "1.0 to 100000.0 kN/m"),
            ("--breaks", "both", "twist or wire"),
            ("--runs", "12", "60 to 5000"),
            ("--kind", "x", "mean, characteristic or minimum"),
        ] {
            let rest = EXAMPLE.iter().filter(|(known, _)| *known != field).copied();
            let values: Vec<(&str, &str)> = rest.chain([(field, text)]).collect();
            let (named, why) = typed(&filled(&values), Units::METRES).err().unwrap().swap_remove(0);
            // A panel that no punch fits into is said of the punch.
            let row = if field == "--panel" { "--punch" } else { field };
            assert!(named == row && why.contains(part) && !why.contains("--"), "{named}: {why}");
        }
        for missing in ["--name", "--force", "--kind", "--source"] {
            let rest: Vec<_> = EXAMPLE.into_iter().filter(|(field, _)| *field != missing).collect();
            assert_eq!(typed(&filled(&rest), Units::METRES).err().unwrap()[0].0, missing);
        }
    }
}
