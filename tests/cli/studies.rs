//! `sensitivity`, `sweep`, `compare` and `design`: forms, numbers and refusals.

use super::{PROJECT, file, good, json, refused, shown};
use serde_json::Value;

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} in {value}"))
}

/// Equal but for the twelve digits that are written.
fn is(value: &Value, path: &str, expected: f64) {
    let got = number(value, path);
    assert!((got - expected).abs() <= 1e-10 * expected.abs().max(1e-3), "{path}: {got}");
}

/// All lines fit a screen's width and end without blanks; nothing is beyond ASCII.
fn fits(out: &str) {
    for line in out.lines() {
        assert!(line.len() <= 80, "{} columns: {line}", line.len());
        assert_eq!(line, line.trim_end());
        assert!(line.is_ascii(), "{line}");
    }
}

/// The header and the rows of a CSV without quotes, all of one length.
fn table(out: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let split = |line: &str| line.split(',').map(String::from).collect::<Vec<String>>();
    let mut lines = out.lines().map(split);
    let header = lines.next().unwrap();
    let rows: Vec<Vec<String>> = lines.collect();
    assert!(rows.iter().all(|r| r.len() == header.len()), "{out}");
    (header, rows)
}

#[test]
fn a_sensitivity_has_the_numbers_of_the_equations() {
    let v = json(&["sensitivity", "--force", "13.5315"]);
    let forecast = json(&["forecast", "--force", "13.5315"]);
    assert_eq!(
        (&v["version"], &v["fingerprint"]),
        (&forecast["version"], &forecast["fingerprint"])
    );
    assert_eq!(v["inputs"], forecast["inputs"]);
    is(&v, "/base/F_kN", 27.063);
    is(&v, "/base/utilisation", 0.5);
    let words: Vec<&str> =
        v["sensitivity"].as_array().unwrap().iter().map(|b| b["input"].as_str().unwrap()).collect();
    assert_eq!(words, ["d", "L", "D", "ex", "ey", "Fl", "dl"]);
    // By hand: L + 10 % is 0.016 of F and 0.1 of delta; F_l* - 10 % is 0.1 of F.
    is(&v, "/sensitivity/1/high/value", 3.3);
    is(&v, "/sensitivity/1/high/change/F", 0.016);
    is(&v, "/sensitivity/1/high/change/delta_m", 0.063_504);
    is(&v, "/sensitivity/3/high/value", 0.15);
    is(&v, "/sensitivity/5/low/value", 65.97);
    is(&v, "/sensitivity/5/low/change/F_kN", -2.7063);
    is(&v, "/sensitivity/5/low/utilisation", 0.5 / 0.9);
    assert_eq!((&v["order"]["F"][0], &v["order"]["delta"][6]), (&"Fl".into(), &"Fl".into()));

    let (header, rows) = table(&good(&["sensitivity", "--format", "csv"]));
    assert_eq!((header[0].as_str(), rows.len()), ("input", 14));
    assert_eq!(rows[3][..5], ["L", "m", "high", "3.3", "27.496008"]);
}

#[test]
fn a_tornado_is_drawn_largest_first_and_marks_what_is_not_possible() {
    let out = good(&["sensitivity", "--force", "20"]);
    fits(&out);
    let first = out.lines().skip_while(|l| !l.starts_with("change of F_a")).nth(1).unwrap();
    assert!(first.starts_with("F_l*     65.97 to 80.63 kN"), "{out}");
    assert!(first.ends_with("---------------|==============="), "{out}");
    assert_eq!(out.matches("change of ").count(), 4, "F, delta, use and delta at F");
    let near = good(&["sensitivity", "-D", "0.3", "--units", "mm"]);
    fits(&near);
    assert!(near.contains('*') && near.contains("branch change at D = d"), "{near}");
    let edge = good(&["sensitivity", "--ex", "0.79", "--ey", "1.5"]);
    assert!(edge.contains("on plate"), "{edge}");
    let v = json(&["sensitivity", "--ex", "0.79", "--ey", "1.5"]);
    assert_eq!(v["sensitivity"][3]["high"]["missing"], "punch_on_plate");
    assert!(v["sensitivity"][3]["high"]["change"].is_null());
    let out = good(&["sensitivity", "-d", "0.05", "-D", "2.85"]);
    fits(&out);
    assert!(out.contains("no sense"), "{out}");
}

#[test]
fn a_layout_without_a_value_has_no_sensitivity() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let all = json(&["sensitivity", shown(&path)]);
    assert_eq!(all[2]["layout"], "corner");
    assert!(all[2]["base"].is_null() && all[2]["missing"] == "punch_on_plate");
    assert!(good(&["sensitivity", shown(&path)]).contains("no field value"));
    let csv = good(&["sensitivity", shown(&path), "--format", "csv"]);
    assert_eq!(csv.lines().count(), 1 + 3 * 14);
    assert!(csv.contains("\n\"portal, east\",d,m,low,0.36,"), "{csv}");
}

#[test]
fn a_sweep_is_the_forecast_at_each_point() {
    let arguments =
        ["sweep", "--vary", "L", "--from", "2", "--to", "4500mm", "--steps", "6", "--force", "20"];
    let v = json(&arguments);
    assert_eq!(v["points"].as_array().unwrap().len(), 6);
    assert_eq!((&v["vary"]["column"], &v["vary2"]), (&"L_m".into(), &Value::Null));
    for (index, spacing) in ["2", "2.5", "3", "3.5", "4", "4.5"].iter().enumerate() {
        let f = json(&["forecast", "-L", spacing, "--force", "20"]);
        let point = &v["points"][index];
        assert_eq!(point["L_m"], f["inputs"]["L_m"]);
        assert_eq!(point["F_kN"], f["field"]["F_kN"]);
        assert_eq!(point["delta_m"], f["field"]["delta_m"]);
        assert_eq!(point["utilisation"], f["design"]["at_force"]["utilisation"]);
        // Without a factor on the load both deflections are one.
        assert_eq!(point["service_delta_m"], f["design"]["at_force"]["delta_m"]);
    }
    let (header, rows) = table(&good(&[&arguments[..], &["--format", "csv"]].concat()));
    assert_eq!(
        header,
        [
            "L_m",
            "F_kN",
            "delta_m",
            "utilisation",
            "service_delta_m",
            "verdict",
            "verdict_by",
            "use",
            "missing",
            "warnings"
        ]
    );
    assert_eq!(rows[2][..3], ["3", "27.063", "0.63504"]);
    assert_eq!([5, 6, 9].map(|at| rows[2][at].as_str()), ["PASSES", "strength", "reference_point"]);
    let text = good(&arguments);
    fits(&text);
    assert!(text.contains("3.00    27.1     0.635   73.9"), "{text}");
}

#[test]
fn a_map_runs_along_the_first_input_and_shades_its_cells() {
    let arguments = [
        "sweep", "--vary", "L", "--from", "1.25", "--to", "4", "--steps", "9", "--vary2", "D",
        "--from2", "0.2", "--to2", "1.6", "--steps2", "8", "--force", "20",
    ];
    let v = json(&arguments);
    assert_eq!(v["points"].as_array().unwrap().len(), 72);
    is(&v, "/points/1/L_m", 1.593_75);
    is(&v, "/points/9/D_m", 0.4);
    assert_eq!(v["points"][63]["missing"], "senseless");
    let text = good(&arguments);
    fits(&text);
    assert!(text.contains("   1.60 |?      ?      #26.4"), "{text}");
    assert_eq!(text.matches(" up").count(), 4, "F, delta, use and delta at F: {text}");
    // More columns than there is room for are thinned, and the text says so.
    let wide = ["sweep", "--vary", "ex", "--from", "-1.5", "--to", "1.5", "--steps", "301"];
    let wide = good(&[&wide[..], &["--vary2", "ey", "--from2", "-1.5", "--to2", "1.5"]].concat());
    fits(&wide);
    assert!(wide.contains("of 301 columns") && wide.contains("PPPP"), "{wide}");
}

#[test]
fn a_sweep_of_a_project_is_a_list_and_a_varied_default_need_not_fit() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let sweep = ["sweep", "--vary", "Fl", "--from", "60", "--to", "80000N", "--steps", "3"];
    let all = json(&[&sweep[..], &[shown(&path)]].concat());
    assert_eq!(all.as_array().unwrap().len(), 3);
    is(&all[0], "/points/1/F_l_kN", 70.0);
    let csv = good(&[&sweep[..], &[shown(&path), "--format", "csv"]].concat());
    assert!(csv.starts_with("layout,F_l_kN,F_kN,delta_m,"), "{csv}");
    fits(&good(&[&sweep[..], &[shown(&path)]].concat()));
    // D = 3.5 m is beyond the default spacing, which is varied.
    let v =
        json(&["sweep", "-D", "3.5", "--vary", "L", "--from", "3", "--to", "5", "--steps", "3"]);
    assert_eq!(v["points"][0]["missing"], "senseless");
    assert!(v["points"][2]["F_kN"].is_f64());
}

#[test]
fn what_is_no_range_is_refused_by_its_flag() {
    let line = |from, to, steps| {
        refused(&["sweep", "--vary", "L", "--from", from, "--to", to, "--steps", steps])
    };
    assert!(line("-1", "3", "5").contains("--from = -1.0 m"));
    assert!(line("2,5", "3", "5").contains("write the decimal point as a point: 2.5"));
    assert!(line("2", "3 kN", "5").contains("--to = \"3 kN\""));
    assert!(line("2", "2", "5").contains("ends where it begins"));
    assert!(line("2", "3", "1").contains("--steps = 1"));
    assert!(line("2", "NaN", "3").contains("--to"));
    let twice = ["sweep", "--vary", "L", "--from", "2", "--to", "3", "--vary2", "L"];
    assert!(refused(&[&twice[..], &["--from2", "2", "--to2", "3"]].concat()).contains("--vary2"));
    assert!(refused(&twice).contains("--from2"));
    assert!(
        refused(&["sweep", "--vary", "x", "--from", "1", "--to", "2"]).contains("d, L, Ly, D, ex")
    );
}

#[test]
fn a_comparison_names_what_governs_and_sorts() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let v = json(&["compare", shown(&path)]);
    assert_eq!(v["governing"]["layout"], "bench 2");
    // 22.5 of 22.8 kN is a use of 99 %; the deflection there, 0.548 m, is 122 % of the allowed 0.45 m.
    assert_eq!(v["governing"]["by"], "deflection");
    let forecasts = json(&["forecast", shown(&path)]);
    for index in 0..3 {
        let (row, f) = (&v["layouts"][index], &forecasts[index]);
        assert_eq!(row["layout"], f["layout"]);
        assert_eq!(row["fingerprint"], f["fingerprint"]);
        assert_eq!(row["inputs"], f["inputs"]);
        assert_eq!(row["field"]["F_kN"], f["field"]["F_kN"]);
        assert_eq!(row["ratios"]["F_field_over_lab"], f["ratios"]["F_field_over_lab"]);
        assert_eq!(row["utilisation"], f["design"]["at_force"]["utilisation"]);
    }
    assert_eq!(v["layouts"][2]["missing"], "punch_on_plate");
    let names = |arguments: &[&str]| -> Vec<String> {
        let all = json(&[&["compare", shown(&path)], arguments].concat());
        let rows = all["layouts"].as_array().unwrap().iter();
        rows.map(|r| r["layout"].as_str().unwrap().to_string()).collect()
    };
    assert_eq!(names(&["--sort", "F"]), ["bench 2", "portal, east", "corner"]);
    assert_eq!(names(&["--sort", "F", "--descending"]), ["portal, east", "bench 2", "corner"]);
    assert_eq!(names(&["--sort", "layout"]), ["bench 2", "corner", "portal, east"]);
    // Without a design force anywhere the lowest force governs; flags are above the file.
    let plain = PROJECT.replace("design_force: 15.0, ", "");
    let (_keep, other) = file("plain.ron", &plain);
    assert_eq!(json(&["compare", shown(&other)])["governing"]["by"], "F");
    let asked = json(&["compare", shown(&other), "--force", "30"]);
    // Beyond failure the load over the force at the allowed deflection is above that over F_a.
    assert_eq!(asked["governing"]["by"], "deflection");

    let text = good(&["compare", shown(&path), "--units", "mm"]);
    fits(&text);
    assert!(text.contains(">xbench 2 ") && text.contains("> governing"), "{text}");
    assert!(text.contains("on plate"), "{text}");
    let csv = good(&["compare", shown(&path), "--format", "csv"]);
    assert!(
        csv.contains("\n\"portal, east\",dt-8x10-2.7,0.4,4,,1.2,2,0.2,false,down,37.0981"),
        "{csv}"
    );
    assert!(refused(&["compare"]).contains("PROJECT.ron"));
    assert!(refused(&["compare", shown(&path), "--sort", "width"]).contains("utilisation"));
}

#[test]
fn a_solved_spacing_meets_the_force_in_the_forecast_too() {
    let v = json(&["design", "--force", "20", "--gamma-load", "1.25", "--solve", "L"]);
    let s = &v["solutions"][0];
    assert_eq!(
        (&s["solve"], &s["requirement"], &s["met"]),
        (&"L".into(), &"force".into(), &"partly".into())
    );
    // By hand: 27.063 (0.16 L/3 + 0.84) = 25 kN.
    let spacing = (25.0 / 27.063 - 0.84) * 3.0 / 0.16;
    let crossing = &s["crossings"][0];
    assert!((number(crossing, "/value_m") - spacing).abs() < 1e-9);
    assert_eq!((&crossing["met"], &crossing["kind"]), (&"above".into(), &"exact".into()));
    let at = crossing["value_m"].to_string();
    let f = json(&["forecast", "-L", &at, "--force", "20", "--gamma-load", "1.25"]);
    assert!((number(&f, "/design/at_force/utilisation") - 1.0).abs() < 1e-9);
    assert_eq!(s["range_m"], serde_json::json!([1.25, 4.5]));
    assert_eq!(v["design"]["gamma_load"], 1.25);

    let v = json(&["design", "--deflection", "600mm", "--solve", "L"]);
    is(&v, "/solutions/0/crossings/0/value_m", 0.6 / 0.635_04 * 3.0);
    is(&v, "/solutions/0/crossings/0/rounded_m", 2.834);
}

#[test]
fn a_design_says_when_nothing_meets_it_and_where_the_forecast_jumps() {
    let text = good(&["design", "--force", "30", "--solve", "L"]);
    fits(&text);
    // At 4.5 m: 27.063 x 1.08 = 29.23 kN, use 102.6 %.
    assert!(text.contains("NOT MET anywhere in the range"), "{text}");
    assert!(text.contains("at 1.250 m use 122 %") && text.contains("use 103 %"), "{text}");
    let v = json(&["design", "--force", "30", "--solve", "L"]);
    assert_eq!(v["solutions"][0]["met"], "nowhere");
    is(&v, "/solutions/0/best/value_m", 4.5);
    let v = json(&["design", "-D", "0.2", "--force", "15", "--solve", "d"]);
    let kinds: Vec<&Value> =
        v["solutions"][0]["crossings"].as_array().unwrap().iter().map(|c| &c["kind"]).collect();
    assert_eq!(kinds, ["jump", "exact"]);
    // All three inputs and, with both questions, all three requirements.
    let both = ["design", "--force", "15", "--deflection", "0.6"];
    assert_eq!(json(&both)["solutions"].as_array().unwrap().len(), 9);
    let text = good(&both);
    fits(&text);
    assert!(text.contains("SOLVE L") && text.contains("SOLVE d") && text.contains("SOLVE D"));
    let (header, rows) = table(&good(&[&both[..], &["--format", "csv"]].concat()));
    assert_eq!(header[3], "value_m");
    assert!(rows.len() >= 18 && rows[0][..3] == ["L", "force", "low_end"]);
}

#[test]
fn a_design_needs_a_question() {
    assert!(refused(&["design"]).contains("give --force or --deflection"));
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let all = json(&["design", shown(&path), "--solve", "L"]);
    assert_eq!(all[0]["solutions"].as_array().unwrap().len(), 3);
    assert_eq!(all[1]["solutions"], serde_json::json!([]));
    let text = good(&["design", shown(&path)]);
    fits(&text);
    assert!(text.contains("nothing: no design force"), "{text}");
    let only = ["design", shown(&path), "--layout", "portal, east"];
    assert!(refused(&only).contains("nothing to design for"));
    assert!(refused(&["design", "--force", "0"]).contains("--force = 0.0 kN"));
}

#[test]
fn a_project_without_layouts_has_empty_studies() {
    let (_keep, path) = file("empty.ron", "(version: 1, name: \"empty\", layouts: [])");
    for command in ["sensitivity", "design"] {
        assert_eq!(good(&[command, shown(&path), "--format", "json"]), "[]\n");
        assert!(good(&[command, shown(&path)]).contains("no layouts"));
    }
    assert!(json(&["compare", shown(&path)])["governing"].is_null());
    assert!(good(&["compare", shown(&path)]).contains("no layouts"));
}

#[test]
fn a_tolerance_has_the_ends_and_the_worst_in_between_in_every_form() {
    // By hand: F_a = 29.1 x (1.5 d + 0.45) kN of the reference panel, 27.063 kN with d = 0.32 m.
    let plate = ["tolerance", "--vary", "d", "--off", "32mm", "--force", "13.5315"];
    let v = json(&plate);
    let words: Vec<&str> =
        v["places"].as_array().unwrap().iter().map(|p| p["place"].as_str().unwrap()).collect();
    assert_eq!(words, ["low", "planned", "high", "worst"]);
    is(&v, "/off", 0.032);
    is(&v, "/places/0/d_m", 0.288);
    is(&v, "/places/0/F_kN", 27.063 - 29.1 * 0.048);
    is(&v, "/places/2/change_F_kN", 29.1 * 0.048);
    is(&v, "/places/1/utilisation", 0.5);
    is(&v, "/places/3/d_m", 0.288);
    assert_eq!(v["places"][3]["verdict"], "PASSES");

    let (header, rows) = table(&good(&[&plate[..], &["--format", "csv"]].concat()));
    let mut keys: Vec<&String> = v["places"][0].as_object().unwrap().keys().collect();
    let mut names: Vec<&String> = header.iter().collect();
    keys.sort();
    names.sort();
    assert_eq!(names, keys, "one table of columns");
    assert_eq!((rows.len(), rows[3][0].as_str()), (4, "worst"));

    let text = good(&plate);
    assert!(text.contains("d 0.32 m, by up to 0.032 m either way"), "{text}");
    assert!(text.contains("-5.2 %") && text.contains("PASSES: strength 50.0 %"), "{text}");
    // An eccentric block that may run onto a plate has no value there, and that is the worst.
    let edge = good(&["tolerance", "--vary", "ex", "--off", "0.15", "--ex", "0.79", "--ey", "1.5"]);
    assert!(edge.contains("worst") && edge.contains("on plate"), "{edge}");
    for (off, word) in [("0", "above 0"), ("-1", "--off"), ("3kN", "--off")] {
        assert!(refused(&["tolerance", "--vary", "d", "--off", off]).contains(word), "{off}");
    }
}
