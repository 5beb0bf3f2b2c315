//! The wires of the reference mesh are those that `meshcast calibrate --reference-fit` gave, as
//! `assets/reference_law.ron` records it. Whoever changes a solver so that its rows move must make them again.

use meshcast::lab::fit::reference::{RecordedLaw, record, starts};
use meshcast::mesh::catalogue;

fn kept() -> &'static RecordedLaw {
    record().found.iter().find(|found| found.start == record().kept).unwrap()
}

#[test]
fn the_catalogue_has_the_law_with_the_lowest_score() {
    let record = record();
    assert_eq!(record.found.len(), starts().len());
    for (found, start) in record.found.iter().zip(starts()) {
        assert_eq!(found.start, start.name);
        // The record's own rows give its score, to the digits that it is written with.
        let score = found.score().expect("a value of every row");
        assert!((score / found.scores.1 - 1.0).abs() < 1e-3, "{score} {found:?}");
        assert!(found.scores.1 <= found.scores.0 && found.scores.1 >= kept().scores.1);
    }
    let mesh = catalogue::reference();
    let wire = mesh.wire.as_ref().unwrap();
    assert_eq!(*wire, kept().law.wire(wire.net, wire.source.clone()));
    assert!(wire.source.contains(&record.command), "{}", wire.source);
}

#[test]
fn the_kept_law_gives_the_recorded_laboratory_test_and_anchored_reference() {
    let rows = kept().again(&["laboratory, L = 3", "anchored reference"], 2);
    // Force, deflection and stiffness; force, deflection and three points of the curve.
    assert_eq!(rows.len(), 8);
    for (label, recorded, now) in rows {
        // Other draws of alignment and slack would move the anchored force by its standard error, 3 %.
        let tolerance = if label.starts_with("laboratory") { 0.015 } else { 0.06 };
        assert!((now / recorded - 1.0).abs() < tolerance, "{label}: {recorded} {now}");
    }
}
