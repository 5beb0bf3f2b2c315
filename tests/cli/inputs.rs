//! What people put in, from public reports of this kind of work: implausible records, other nets,
//! numbers in other habits, names that a spreadsheet takes for formulas.

use super::{file, good, json, refused, run, shown};
use serde_json::Value;

#[test]
fn a_block_below_the_opening_of_the_mesh_has_no_value() {
    let out = good(&["forecast", "-D", "0.05"]);
    assert!(out.contains("no field value: the block is smaller than the opening"), "{out}");
    let v = json(&["forecast", "-D", "0.05"]);
    assert!(v["field"].is_null() && v["curve"].is_null());
    assert!(v["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "passes_through"));
    // An opening of 80 mm: a block as large as that is held.
    assert!(json(&["forecast", "-D", "0.08"])["field"]["F_kN"].is_number());
    let sweep = json(&["sweep", "--vary", "D", "--from", "0.05", "--to", "0.1", "--steps", "2"]);
    assert_eq!(sweep["points"][0]["missing"], "passes_through");
    assert!(sweep["points"][1]["F_kN"].is_number());
}

#[test]
fn a_record_in_a_wrong_unit_is_doubted() {
    let lab = |force: &str, deflection: &str| {
        format!(
            "(version: 1, name: \"p\", meshes: [(id: \"m1\", laboratory: (force: {force}, deflection: {deflection}, statistic: Mean, source: \"invented\"))], layouts: [(name: \"a\", d: 0.25, L: 3.0, D: 1.0, mesh: \"m1\")])"
        )
    };
    for (force, deflection, doubted) in [
        ("0.0733", "\"0.6 mm\"", true),
        ("73.3", "\"6 mm\"", true),
        ("7330.0", "0.6", true),
        ("73.3", "0.6", false),
        ("12.0", "1.4", false),
    ] {
        let (_keep, path) = file("lab.ron", &lab(force, deflection));
        let v = json(&["forecast", shown(&path), "--layout", "a"]);
        let said = v["warnings"].as_array().unwrap();
        let found = said.iter().find(|w| w["code"] == "implausible_laboratory");
        assert_eq!(found.is_some(), doubted, "{force} {deflection}: {v}");
        assert!(found.is_none_or(|w| w["weight"] == "caution"), "{v}");
    }
}

#[test]
fn a_check_with_the_net_of_a_file_is_not_held_against_another_mesh() {
    let net = "(
        net: (opening: 0.06, twist: 0.03, projection: 0.03, diameter: 0.0022, node_mass: 0.002, node_radius: 0.0088),
        single: [(0.001923, 250.0), (0.05, 382.92), (0.15, 512.19), (0.35, 565.85)],
        double_twist: [(0.001923, 250.0), (0.05, 382.92), (0.15, 512.19), (0.35, 565.85)],
        source: \"invented\",
    )";
    let (_keep, path) = file("net-6x8.ron", net);
    let check = ["check", "-d", "0.25", "-L", "1.2", "-D", "0.4", "--fidelity", "quick"];
    let mut own =
        [&check[..], &["--runs", "1", "--phase", "0.2,0.4", "--mesh-file", shown(&path)]].concat();
    let out = run(&own).out;
    assert!(out.contains("net-6x8.ron (opening 60.0 mm, wire 2.2 mm)"), "{out}");
    assert!(out.contains("no forecast") && !out.contains("check over forecast"), "{out}");
    own.extend(["--format", "json"]);
    let v: Value = serde_json::from_str(&run(&own).out).unwrap();
    assert_eq!(v["inputs"]["mesh"], "net-6x8.ron");
    assert!(v["forecast"]["F_kN"].is_null(), "{v}");
    assert!(v["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "no_forecast"));
}

#[test]
fn a_spreadsheet_takes_names_for_names_and_reads_decimal_commas() {
    let names = ["=1+1", "+41 cut", "-5 m bench", "@SUM(A1:A9)", "Böschung Süd"];
    let layouts: Vec<String> =
        names.iter().map(|n| format!("(name: {n:?}, d: 0.25, L: 3.5, D: 1.0, ex: -0.5)")).collect();
    let text = format!("(version: 1, name: \"=1+1\", layouts: [{}])", layouts.join(", "));
    let (_keep, path) = file("names.ron", &text);
    let plain = good(&["export", shown(&path), "--what", "table"]);
    for name in &names[..4] {
        assert!(plain.contains(&format!("\n'{name},")), "{plain}");
    }
    assert!(plain.contains("\nBöschung Süd,") && plain.contains(",3.5,"), "{plain}");
    assert!(json(&["compare", shown(&path)])["layouts"][0]["layout"] == "=1+1");

    let comma = good(&["export", shown(&path), "--what", "table", "--format", "csv-comma"]);
    assert!(comma.starts_with('\u{feff}') && comma.contains("\nBöschung Süd;"), "{comma}");
    assert!(comma.contains(";3,5;") && comma.contains(";-0,5;"), "{comma}");
    for command in ["forecast", "compare", "sensitivity"] {
        let out = good(&[command, shown(&path), "--format", "csv-comma"]);
        assert!(out.starts_with('\u{feff}') && out.lines().all(|l| l.contains(';')), "{out}");
    }
}

#[test]
fn signs_that_command_a_terminal_or_turn_a_line_are_refused_by_name() {
    for (field, text) in [
        ("id", "m\u{202e}1"),
        ("id", "m\u{1b}1"),
        ("name", "a\u{7}b"),
        ("source", "x\u{1b}]52;c;aGk=\u{7}"),
        ("standard", "UNI\u{2066}"),
    ] {
        let of = |name: &str, usual: &str| {
            let said = if field == name { text } else { usual };
            said.chars().map(|c| format!("\\u{{{:x}}}", c as u32)).collect::<String>()
        };
        let project = format!(
            "(version: 1, name: \"p\", meshes: [(id: \"{}\", name: \"{}\", laboratory: (force: 73.3, deflection: 0.6, statistic: Mean, standard: \"{}\", source: \"{}\"))], layouts: [])",
            of("id", "m1"),
            of("name", "mesh"),
            of("standard", "UNI"),
            of("source", "invented"),
        );
        let (_keep, path) = file("odd.ron", &project);
        let said = refused(&["forecast", shown(&path)]);
        assert!(said.contains(field), "{field}: {said}");
        let odd = |c: char| (c.is_control() && c != '\n') || "\u{202e}\u{2066}".contains(c);
        assert!(!said.chars().any(odd), "{said:?}");
    }
}

#[test]
fn a_record_of_the_force_alone_gives_forces_and_says_what_is_missing() {
    let path = "tests/files/valid/strength_only.ron";
    let v = json(&["forecast", path, "--layout", "a"]);
    // Eq. A.1 by hand: 180 kN x 29.1/73.3 x (0.06 + 0.94) x (1.5 x 0.33 + 0.45) x (0.4/3 + 0.84).
    let force = 180.0 * 29.1 / 73.3 * 1.0 * (1.5 * 0.33 + 0.45) * (0.4 / 3.0 + 0.84);
    assert!((v["field"]["F_kN"].as_f64().unwrap() - force).abs() < 1e-9, "{v}");
    assert!(v["field"]["delta_m"].is_null() && v["curve"].is_null(), "{v}");
    assert!(v["lab"]["delta_m"].is_null() && v["field"]["energy_kJ"].is_null(), "{v}");
    assert!(v["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "strength_only"), "{v}");
    let checks = &v["verdict"]["checks"];
    let state = |aspect: &str| {
        let all = checks.as_array().unwrap().iter();
        all.filter(|c| c["check"] == aspect).map(|c| c["state"].clone()).next().unwrap()
    };
    assert_eq!((state("strength"), state("deflection")), ("pass".into(), "not judged".into()));
    let text = good(&["forecast", path]);
    assert!(text.contains("none: the laboratory record has no deflection"), "{text}");
    assert!(!text.contains("NaN") && !text.contains("beyond failure"), "{text}");
    for command in [
        &["compare", path][..],
        &["sensitivity", path],
        &["sweep", path, "--vary", "L", "--from", "2", "--to", "3"],
        &["design", path],
        &["report", path, "--format", "md"],
        &["export", path, "--what", "table"],
        &["export", path, "--what", "chart"],
    ] {
        let out = good(command);
        assert!(!out.contains("NaN") && out.contains("a"), "{command:?}: {out}");
    }
    // Forces can be designed for; deflections have no answer.
    let designed = json(&["design", path, "--solve", "d"]);
    let solved = designed[0]["solutions"].as_array().unwrap();
    let asked: Vec<_> = solved.iter().map(|r| r["requirement"].clone()).collect();
    assert_eq!(asked, ["force"], "{designed}");
}
