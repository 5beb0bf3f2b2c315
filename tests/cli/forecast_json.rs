//! The shape of `forecast --format json`, field by field.

use super::{PROJECT, file, json, shown};
use serde_json::Value;

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} in {value}"))
}

fn keys(value: &Value, path: &str) -> Vec<String> {
    let object = value.pointer(path).and_then(Value::as_object);
    object.unwrap_or_else(|| panic!("{path} in {value}")).keys().cloned().collect()
}

/// Equal but for the twelve digits that are written.
fn is(value: &Value, path: &str, expected: f64) {
    let got = number(value, path);
    assert!((got - expected).abs() <= 1e-11 * expected.abs().max(1e-3), "{path}: {got}");
}

/// All fields that programs may rely on stand in an object, with their types.
fn has_the_promised_fields(value: &Value, with_field: bool) {
    let promised = [
        ("/inputs", vec!["d_m", "L_m", "D_m", "ex_m", "ey_m"]),
        ("/lab", vec!["F_kN", "delta_m"]),
        ("/field_reference", vec!["F_kN", "delta_m"]),
        ("/eccentricity", vec!["F", "delta"]),
        ("/ratios", vec!["alpha_F", "alpha_delta"]),
    ];
    for (object, fields) in promised {
        for field in fields {
            number(value, &format!("{object}/{field}"));
        }
    }
    assert!(value["inputs"]["mesh"].is_string());
    assert!(value["version"].is_string() && value["fingerprint"].is_string());
    for warning in value["warnings"].as_array().expect("warnings are a list") {
        assert!(warning["code"].is_string() && warning["message"].is_string());
        assert!(["note", "caution", "outside"].contains(&warning["weight"].as_str().unwrap()));
    }
    let over_lab = ["F_field_over_lab", "delta_field_over_lab"];
    if with_field {
        for field in ["F_kN", "delta_m", "anchor_kN"] {
            number(value, &format!("/field/{field}"));
        }
        assert!(value["field"]["regime"].is_string() && value["field"]["branch"].is_string());
        assert!(over_lab.iter().all(|f| value["ratios"][f].is_f64()));
        for axis in ["delta_m", "F_kN"] {
            assert_eq!(value["curve"][axis].as_array().unwrap().len(), 201);
        }
    } else {
        assert!(value["field"].is_null() && value["curve"].is_null());
        for field in over_lab {
            assert!(value["ratios"].as_object().unwrap()[field].is_null());
        }
    }
}

#[test]
fn without_anything_it_is_the_reference_panel() {
    let v = json(&["forecast"]);
    has_the_promised_fields(&v, true);
    assert_eq!(keys(&v, "/inputs").len(), 7);
    for (path, expected) in [
        ("/inputs/d_m", 0.32),
        ("/inputs/L_m", 3.0),
        ("/inputs/D_m", 1.0),
        ("/inputs/ex_m", 0.0),
        ("/inputs/ey_m", 0.0),
        ("/lab/F_kN", 73.3),
        ("/lab/delta_m", 0.6),
        ("/field_reference/F_kN", 29.1),
        ("/field_reference/delta_m", 0.648),
        // 29.1 x 0.93 and 0.648 x 0.98: the disclosed oddity.
        ("/field/F_kN", 27.063),
        ("/field/delta_m", 0.635_04),
        ("/field/anchor_kN", 27.063),
        ("/eccentricity/F", 1.0),
        ("/eccentricity/delta", 1.0),
        ("/eccentricity/F_sd", 0.0),
        ("/ratios/alpha_F", 29.1 / 73.3),
        ("/ratios/alpha_delta", 1.08),
        ("/ratios/F_field_over_lab", 27.063 / 73.3),
        ("/ratios/delta_field_over_lab", 1.0584),
        ("/curve/delta_m/0", 0.0),
        ("/curve/F_kN/0", 0.0),
        // Half of delta_a: 0.10425 of F_a by Eq. 3.
        ("/curve/delta_m/100", 0.317_52),
        ("/curve/F_kN/100", 27.063 * 0.104_25),
        ("/curve/delta_m/200", 0.635_04),
        ("/curve/F_kN/200", 27.063),
        // Area under Eq. 3: 0.2361666...
        ("/field/energy_kJ", 27.063 * 0.635_04 * (0.328 - 0.385 / 3.0 + 0.0365)),
        ("/field/tangent_kN_per_m", 27.063 / 0.635_04 * 3.239),
        ("/field/secant_kN_per_m", 27.063 / 0.635_04),
    ] {
        is(&v, path, expected);
    }
    assert_eq!(v["inputs"]["mesh"], "dt-8x10-2.7");
    assert_eq!(v["field"]["regime"], "large_punch");
    assert_eq!(v["field"]["branch"], "published");
    assert_eq!(v["field"]["relation"], "large_punch");
    assert_eq!(v["warnings"][0]["code"], "reference_point");
    assert!(v["other_branch"].is_null() && v["design"].is_null());
    assert!(v.get("layout").is_none());
    assert!(v["basis"].as_str().unwrap().starts_with("lowest of the arrangements"));
}

#[test]
fn inputs_come_back_without_noise() {
    let v = json(&["forecast", "-d", "0.3200", "-L", "2750mm", "--ex", "-70 mm", "--ey", "7cm"]);
    assert_eq!(v["inputs"]["d_m"].to_string(), "0.32");
    assert_eq!(v["inputs"]["L_m"].to_string(), "2.75");
    assert_eq!(v["inputs"]["ex_m"].to_string(), "-0.07");
    assert_eq!(v["inputs"]["ey_m"].to_string(), "0.07");
}

#[test]
fn negative_offsets_and_units_are_taken_in_every_way_of_writing_a_flag() {
    let expected = json(&["forecast", "-L", "3", "-d", "0.25", "--ex", "0.5", "--ey", "0.75"]);
    for arguments in [
        ["forecast", "-L", "3 m", "-d", "250mm", "--ex", "-0.5", "--ey", "-750mm"],
        ["forecast", "-L", "300cm", "-d", "0.25 m", "--ex=-500 mm", "--ey", ".75", "--units=m"],
    ] {
        let v = json(&arguments);
        assert_eq!(v["field"], expected["field"], "{arguments:?}");
    }
    assert_eq!(json(&["forecast", "-d250mm"])["inputs"]["d_m"], 0.25);
}

#[test]
fn near_the_branch_change_both_branches_stand() {
    // D = 0.36 > d = 0.32, below the crossing: the small-punch relation is the lower one.
    let arguments = ["forecast", "-D", "0.36"];
    let published = json(&arguments);
    has_the_promised_fields(&published, true);
    assert_eq!(published["field"]["regime"], "large_punch");
    assert_eq!(published["field"]["relation"], "large_punch");
    let conservative = json(&[&arguments[..], &["--branch", "conservative"]].concat());
    assert_eq!(conservative["field"]["branch"], "conservative");
    assert_eq!(conservative["field"]["regime"], "large_punch", "the regime is by size");
    assert_eq!(conservative["field"]["relation"], "small_punch");
    for field in ["F_kN", "delta_m"] {
        assert_eq!(published["other_branch"][field], conservative["field"][field]);
        assert_eq!(conservative["other_branch"][field], published["field"][field]);
    }
    assert!(number(&conservative, "/field/F_kN") < number(&published, "/field/F_kN"));
    assert_ne!(published["fingerprint"], conservative["fingerprint"]);
    let codes: Vec<_> = published["warnings"].as_array().unwrap().iter().collect();
    assert!(codes.iter().any(|w| w["code"] == "near_branch_change"));
}

#[test]
fn a_punch_on_a_plate_has_no_field_value_and_is_no_error() {
    let v = json(&["forecast", "--ex", "1.5", "--ey", "1.5"]);
    has_the_promised_fields(&v, false);
    assert_eq!(v["warnings"][0]["code"], "punch_on_plate");
    assert_eq!(v["warnings"][0]["weight"], "outside");
    is(&v, "/lab/F_kN", 73.3);
}

#[test]
fn an_eccentric_punch_shows_its_uncertainty() {
    // Table 1, test 4.
    let v = json(&["forecast", "-d", "0.4", "-L", "4", "-D", "1.2", "--ex", "2", "--ey", "0.2"]);
    assert_eq!(format!("{:.1}", number(&v, "/field/F_kN")), "37.1");
    is(&v, "/eccentricity/F", 1.139);
    assert!(number(&v, "/eccentricity/F_sd") > 0.0);
    assert!(!v["eccentricity"]["sources"].as_array().unwrap().is_empty());
}

#[test]
fn extrapolation_is_shown_with_the_number() {
    let v = json(&["forecast", "-L", "6"]);
    has_the_promised_fields(&v, true);
    let warning = &v["warnings"][0];
    assert_eq!(warning["code"], "extrapolated_L");
    assert!(warning["message"].as_str().unwrap().contains("1.25 to 4.5 m"));
}

#[test]
fn design_questions_are_answered_with_their_factors() {
    let v = json(&[
        "forecast",
        "--force",
        "10",
        "--deflection",
        "0.5",
        "--gamma-load",
        "1.5",
        "--gamma-resistance",
        "1.25",
    ]);
    is(&v, "/design/gamma_load", 1.5);
    is(&v, "/design/gamma_resistance", 1.25);
    is(&v, "/design/resistance_kN", 27.063 / 1.25);
    is(&v, "/design/at_force/F_kN", 10.0);
    is(&v, "/design/at_force/load_kN", 15.0);
    is(&v, "/design/at_force/utilisation", 15.0 / (27.063 / 1.25));
    is(&v, "/design/at_force/margin_kN", 27.063 / 1.25 - 15.0);
    // By the 10 kN without their factor; at 15 kN it would not be.
    assert_eq!(v["design"]["at_force"]["within_allowable"], true);
    // Eq. 3 at 0.5/0.63504 by its own coefficients.
    let x: f64 = 0.5 / 0.635_04;
    let force = 27.063 * (1.312 * x * x * x - 0.385 * x * x + 0.073 * x);
    is(&v, "/design/at_deflection/F_kN", force);
    is(&v, "/design/at_deflection/design_F_kN", force / 1.25);
    assert_eq!(v["design"]["at_deflection"]["beyond_failure"], false);
    // The deflection at the load lies on the unfactored curve.
    let x = number(&v, "/design/at_force/delta_m") / 0.635_04;
    let back = 27.063 * (1.312 * x * x * x - 0.385 * x * x + 0.073 * x);
    assert!((back - 15.0).abs() < 1e-8, "{back}");

    let too_much = json(&["forecast", "--force", "30kN"]);
    assert!(too_much["design"]["at_force"]["delta_m"].is_null());
    assert!(number(&too_much, "/design/at_force/utilisation") > 1.0);
}

#[test]
fn a_project_gives_a_list_and_a_layout_one_object() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let all = json(&["forecast", shown(&path)]);
    let list = all.as_array().unwrap();
    assert_eq!(list.len(), 3);
    let names: Vec<_> = list.iter().map(|v| v["layout"].as_str().unwrap()).collect();
    assert_eq!(names, ["bench 2", "portal, east", "corner"]);
    for (index, with_field) in [true, true, false].into_iter().enumerate() {
        has_the_promised_fields(&list[index], with_field);
    }
    is(&list[0], "/design/at_force/load_kN", 22.5);
    is(&list[1], "/inputs/D_m", 1.2);
    let one = json(&["forecast", shown(&path), "--layout", "portal, east"]);
    assert_eq!(one, list[1]);
}

#[test]
fn flags_go_above_the_file_for_every_layout() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let all = json(&["forecast", shown(&path), "-d", "300mm", "--branch", "published"]);
    for v in all.as_array().unwrap() {
        is(v, "/inputs/d_m", 0.3);
        assert_eq!(v["inputs"]["branch"], "published");
    }
    is(&all, "/0/inputs/L_m", 2.5);
}

#[test]
fn a_mesh_written_out_in_the_project_can_be_named_by_the_flag() {
    let text = PROJECT.replace(
        "layouts: [",
        "meshes: [\"dt-8x10-2.7\", (id: \"ours\", laboratory: (force: 50.0, deflection: 0.5, statistic: Characteristic, source: \"test report\"))],\n    layouts: [",
    );
    let (_keep, path) = file("own.ron", &text);
    let v = json(&["forecast", shown(&path), "--layout", "bench 2", "--mesh", "ours"]);
    is(&v, "/lab/F_kN", 50.0);
    assert_eq!(v["lab"]["statistic"], "characteristic");
    assert!(v["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "default_ratios"));
}

#[test]
fn the_fingerprint_is_of_the_inputs_and_of_nothing_else() {
    let of = |arguments: &[&str]| json(arguments)["fingerprint"].as_str().unwrap().to_string();
    let base = of(&["forecast"]);
    assert_eq!(base.len(), 16);
    assert_eq!(base, of(&["forecast", "-d", "320mm", "--units", "mm"]));
    assert_ne!(base, of(&["forecast", "-d", "321mm"]));
}
