//! Calibration with more than a force and a deflection: what it says, and what it refuses.

use super::{file, refused, run, shown};
use serde_json::Value;

/// A made-up test on a small panel with a small punch: 30 points of F = 26 (d/0.33)^3 kN, one of them missing,
/// and what comes behind the failure.
fn curve() -> String {
    let mut text = "# made up\nDeflection [mm];Force [N]\n".to_string();
    for k in 1..=30 {
        let x = f64::from(k) / 30.0;
        // A noise of 2 % up and down.
        let force = 26_000.0 * x.powi(3) * if k % 2 == 0 { 1.02 } else { 0.98 };
        text += &if k == 9 {
            "99;\n".to_string()
        } else {
            format!("{:.1};{force:.0}\n", 330.0 * x).replace('.', ",")
        };
    }
    text + "335;8000\n"
}

const PANEL: [&str; 6] = ["calibrate", "--panel", "1.6", "--punch", "0.5", "--curve"];

fn with<'a>(path: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&PANEL[..], &[path], more].concat()
}

#[test]
fn a_noisy_curve_gives_the_laws_that_fit_it_on_any_threads() {
    let (directory, path) = file("test.csv", &curve());
    let mut results = Vec::new();
    for threads in ["1", "2"] {
        let more = ["--fidelity", "quick", "--format", "json", "--threads", threads];
        let ran = run(&with(shown(&path), &more));
        assert_eq!(ran.code, 0, "{}", ran.err);
        results.push(ran.out);
    }
    assert!(results[0] == results[1], "threads change the result");
    let found: Value = serde_json::from_str(&results[0]).unwrap();
    let laws = found["laws"].as_array().unwrap();
    let weights: f64 = laws.iter().map(|law| law["weight"].as_f64().unwrap()).sum();
    assert!((weights - 1.0).abs() < 1e-9 && laws.len() > 10, "{weights}");
    let point = |key: &str| found["anchored_F_kN"][key].as_f64().unwrap();
    assert!(point("p5") < point("p50") && point("p50") < point("p95"));
    for parameter in found["parameters"].as_array().unwrap() {
        assert!((0.0..=1.0).contains(&parameter["held_by_data"].as_f64().unwrap()), "{parameter}");
    }
    // The curve's own end is the test: 26 kN up by the noise of the last point.
    assert_eq!(found["rows"][0]["data"].as_f64().unwrap(), 26_520.0);

    // The best law can be written, and is never written over another file.
    let out = directory.path().join("best.ron");
    let more = ["--fidelity", "quick", "--breaks", "wire", "--out", shown(&out)];
    let ran = run(&with(shown(&path), &more));
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.contains("29 points") && ran.out.contains("1 gaps, 1 points"), "{}", ran.out);
    assert!(ran.out.contains("held by the data"), "{}", ran.out);
    let wires = std::fs::read_to_string(&out).unwrap();
    assert!(wires.contains("EN 10223-3"), "{wires}");
    let again = refused(&with(shown(&path), &more));
    assert!(again.contains("exists already"), "{again}");
    assert_eq!(std::fs::read_to_string(&out).unwrap(), wires);
}

/// Any test at 0.45 m left the scales that wires can have, and the answer neither said what could be reached nor
/// from where to begin.
#[test]
fn a_test_that_no_scale_reaches_is_answered_with_the_nearest_and_where_to_begin() {
    let least = ["--runs", "1", "--fidelity", "quick"];
    let e =
        refused(&[&["calibrate", "--force", "180", "--deflection", "0.45"], &least[..]].concat());
    assert!(e.contains("no scale of the starting law reaches this punch test"), "{e}");
    assert!(e.contains("the nearest was ") && e.contains(" kN at 0."), "{e}");
    assert!(e.contains("--ensemble") && e.contains("--from another mesh"), "{e}");
}

#[test]
fn bad_laboratory_data_are_refused_in_clear_words() {
    let said = |text: &str, more: &[&str]| {
        let (_directory, path) = file("test.csv", text);
        refused(&with(shown(&path), more))
    };
    let five: String = curve().lines().take(7).map(|line| format!("{line}\n")).collect();
    let e = said(&five, &[]);
    assert!(e.contains("a curve of 5 points says too little") && e.contains("8 points"), "{e}");
    let falls: String = (1..20).map(|k| format!("{};{}\n", 10 * k, 30_000 - 1000 * k)).collect();
    let e = said(&format!("deflection mm;force N\n{falls}"), &[]);
    assert!(e.contains("the force falls by more than noise") && e.contains("line"), "{e}");
    let e = said(&curve().replace("[N]", "[kN]"), &[]);
    assert!(e.contains("no punch test has such a largest force") && e.contains("unit"), "{e}");
    let e = said(&curve().replace("[mm]", ""), &[]);
    assert!(e.contains("the unit of deflection is missing or not known"), "{e}");
    let e = said(&curve(), &["--force", "260"]);
    assert!(e.contains("--curve") && e.contains("not the force and deflection given"), "{e}");
    let e = refused(&[
        "calibrate",
        "--force",
        "50",
        "--deflection",
        "0.4",
        "--panel",
        "0.9",
        "--punch",
        "1",
        "--ensemble",
    ]);
    assert!(e.contains("--punch") && e.contains("below the panel of 0.9 m"), "{e}");
    let e =
        refused(&["calibrate", "--force", "50", "--deflection", "0.4", "--wire-strength", "45"]);
    assert!(e.contains("--wire-strength") && e.contains("100.0 to 2500.0 MPa"), "{e}");
    // What is no table is not waited for, nor read without end.
    let e = refused(&["calibrate", "--curve", "/dev/zero"]);
    assert!(e.contains("/dev/zero") && e.contains("no ordinary file"), "{e}");
    let (_directory, path) = file("latin.csv", "");
    std::fs::write(&path, b"d\xe9flexion [mm];force [N]\n").unwrap();
    let e = refused(&["calibrate", "--curve", shown(&path)]);
    assert!(e.contains("no text in UTF-8"), "{e}");
}

/// Each range is meant to hold what its law does with 90 %. If it did with 60 % only, four of five would be
/// inside in a third of all cases (5 x 0.6^4 x 0.4 + 0.6^5 = 0.34), five of five in one of thirteen; so four are
/// weak evidence and a fall below that is strong. The hundred draws of the page of measurements are the proof.
#[test]
fn laws_are_found_again_from_noisy_curves_within_their_stated_ranges() {
    let arguments = [
        "calibrate",
        "--coverage",
        "5",
        "--panel",
        "1.6",
        "--punch",
        "0.5",
        "--fidelity",
        "quick",
        "--seed",
        "1",
        "--format",
        "json",
    ];
    let ran = run(&arguments);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let made: Value = serde_json::from_str(&ran.out).unwrap();
    let draws = made["draws"].as_array().unwrap();
    assert_eq!(draws.len(), 5);
    assert!(made["inside"].as_u64().unwrap() >= 4, "{}", ran.out);
    for draw in draws {
        let of = |key: &str| draw[key].as_f64().unwrap();
        assert!(of("p5_kN") < of("p50_kN") && of("p50_kN") < of("p95_kN"), "{draw}");
        let inside = (of("p5_kN")..=of("p95_kN")).contains(&of("field_F_kN"));
        assert_eq!(draw["inside"].as_bool().unwrap(), inside, "{draw}");
    }
}
