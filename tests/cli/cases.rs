//! Inputs made from public reports of this kind of work, `tests/files/cases`, with what is right for each.

use super::{good, json, refused, run};
use std::fs;

fn case(name: &str) -> String {
    format!("tests/files/cases/{name}")
}

fn codes(v: &serde_json::Value) -> Vec<String> {
    let all = v["warnings"].as_array().unwrap().iter();
    all.map(|w| w["code"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn the_net_of_a_file_is_named_and_has_no_forecast_of_another_mesh() {
    let net = case("net-6x8-2.2.ron");
    let check = ["check", "--mesh-file", &net, "-L", "1.5", "--runs", "1", "--fidelity", "quick"];
    let v: serde_json::Value =
        serde_json::from_str(&run(&[&check[..], &["--format", "json"]].concat()).out).unwrap();
    assert_eq!(v["inputs"]["mesh"], "net-6x8-2.2.ron");
    assert!(v["forecast"]["F_kN"].is_null() && codes(&v).contains(&"no_forecast".into()), "{v}");
    let text = run(&check).out;
    assert!(text.contains("net-6x8-2.2.ron") && !text.contains("check over forecast"), "{text}");
}

#[test]
fn names_are_no_formulas_and_decimal_commas_can_be_had() {
    let path = case("formula-names.ron");
    let plain = good(&["export", &path, "--what", "table"]);
    for name in ["'=1+1", "'+41 cut", "'-5 m bench", "'@SUM(A1:A9)"] {
        assert!(plain.contains(&format!("\n{name},")), "{plain}");
    }
    let comma = good(&["export", &path, "--what", "table", "--format", "csv-comma"]);
    assert!(comma.starts_with('\u{feff}') && comma.contains(";0,25;"), "{comma}");
    assert!(comma.contains("\nBöschung Süd – 1/2;"), "{comma}");
}

#[test]
fn a_wire_that_no_steel_is_gets_a_caution() {
    for (force, deflection) in [("73.3", "0.9"), ("20", "0.3")] {
        let args = ["calibrate", "--force", force, "--deflection", deflection];
        let got = run(&[&args[..], &["--runs", "1", "--fidelity", "quick"]].concat());
        let said = got.out + &got.err;
        assert!(said.contains("steel") || said.contains("no scale"), "{said}");
    }
}

#[test]
fn a_block_below_the_opening_passes_through() {
    let v = json(&["forecast", "-D", "0.05"]);
    assert!(v["field"].is_null() && codes(&v).contains(&"passes_through".into()), "{v}");
}

#[test]
fn both_readings_of_a_thousands_separator_are_named() {
    let said = refused(&["forecast", &case("thousands.ron")]);
    assert!(said.contains("1250 mm") && said.contains("1.25"), "{said}");
    let said = refused(&["forecast", "-D", "1,250mm"]);
    assert!(said.contains("1250 mm") && said.contains("1.25"), "{said}");
}

#[test]
fn implausible_and_impossible_records_are_said() {
    let v = json(&["forecast", &case("lab-implausible.ron"), "--layout", "a"]);
    assert!(codes(&v).contains(&"implausible_laboratory".into()), "{v}");
    let said = refused(&["forecast", &case("lab-panel-below-punch.ron")]);
    assert!(said.contains("no punch fits into a panel of its own size"), "{said}");
}

#[test]
fn a_force_alone_gives_forces_and_no_curve() {
    let v = json(&["forecast", &case("force-only.ron"), "--layout", "a"]);
    assert!(v["field"]["F_kN"].is_number() && v["field"]["delta_m"].is_null(), "{v}");
    assert!(v["curve"].is_null() && codes(&v).contains(&"strength_only".into()), "{v}");
    assert_eq!(v["verdict"]["verdict"], "PASSES");
}

#[test]
fn only_endings_that_can_be_written_are_taken() {
    let dir = tempfile::tempdir().unwrap();
    let path = case("formula-names.ron");
    for (command, what, name) in [
        ("export", Some("chart"), "x.png"),
        ("export", Some("table"), "t.xlsx"),
        ("report", None, "r.pdf"),
        ("report", None, "r.docx"),
    ] {
        let out = dir.path().join(name);
        let mut args = vec![command, path.as_str()];
        args.extend(what.into_iter().flat_map(|what| ["--what", what]));
        args.extend(["-o", out.to_str().unwrap()]);
        let said = refused(&args);
        let ending = name.split('.').next_back().unwrap();
        assert!(said.contains(ending) && said.contains("allowed: "), "{said}");
        assert!(!out.exists());
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}
