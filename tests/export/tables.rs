//! CSV: as many fields as the header has, numbers that are numbers, names as they are.

use super::{good, odd, projects};
use meshcast::export::csv;

fn rows(text: &str) -> Vec<Vec<String>> {
    let mut reader = ::csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    reader.records().map(|r| r.unwrap().iter().map(str::to_string).collect()).collect()
}

#[test]
fn every_layout_has_a_line_and_every_line_all_fields() {
    for project in projects() {
        let cases = good(&project);
        let rows = rows(&csv::table(&cases));
        assert_eq!(rows.len(), cases.len() + 1);
        for (row, case) in rows[1..].iter().zip(&cases) {
            // A name that a spreadsheet would take for a formula stands behind an apostrophe.
            assert_eq!(row[0].trim_start_matches('\''), case.entry.name);
            for (name, field) in rows[0].iter().zip(row) {
                let number = ["_m", "_kN", "_kJ"].iter().any(|end| name.ends_with(end));
                let sound = field.is_empty() || field.parse::<f64>().is_ok_and(f64::is_finite);
                assert!(!number || sound, "{name} = {field:?}");
            }
        }
    }
}

#[test]
fn columns_carry_their_units_and_the_published_values() {
    let text = csv::table(&good(&super::sample("road-cut.ron")));
    let rows = rows(&text);
    let at = |row: usize, name: &str| {
        let column = rows[0].iter().position(|n| n == name).unwrap_or_else(|| panic!("{name}"));
        rows[row][column].clone()
    };
    let rounded = |row, name: &str| format!("{:.1}", at(row, name).parse::<f64>().unwrap());
    assert_eq!((rounded(1, "F_kN"), rounded(3, "F_kN")), ("22.8".into(), "31.0".into()));
    assert_eq!((at(3, "load_kN"), at(3, "gamma_resistance")), ("26".into(), "1.25".into()));
    assert_eq!(at(2, "allowable_delta_m"), "");
    assert_eq!(at(4, "warnings"), "eccentricity_uncertain facing_left_out");
}

#[test]
fn curves_run_from_nothing_to_failure() {
    let cases = good(&odd());
    let rows = rows(&csv::case_curves(&cases));
    assert_eq!(rows[0], ["layout", "delta_m", "F_kN"]);
    // One of the four layouts is on a plate.
    assert_eq!(rows.len(), 1 + 3 * 201);
    assert_eq!(rows[1], [cases[0].entry.name.as_str(), "0", "0"]);
}
