//! Grids of anchors on the command line.

use super::{file, good, json, refused, run, shown};

#[test]
fn two_equal_spacings_and_one_give_the_same_forecast() {
    let [one, two] = [&["-L", "2.5"][..], &["--Lx", "2.5", "--Ly", "2.5"]].map(|grid| {
        let mut all = vec!["forecast", "-D", "0.6"];
        all.extend(grid);
        json(&all)
    });
    assert_eq!(one["field"], two["field"]);
    assert_eq!(one["fingerprint"], two["fingerprint"]);
    assert_eq!(two["inputs"]["Ly_m"], 2.5);
    assert!(one["inputs"].get("Ly_m").is_none());
}

#[test]
fn a_grid_without_a_published_relation_has_no_field_value_and_says_why() {
    for grid in [&["--Ly", "3.5"][..], &["--stagger"]] {
        let mut all = vec!["forecast", "--force", "20"];
        all.extend(grid);
        let got = json(&all);
        assert!(got["field"].is_null() && got["curve"].is_null());
        let codes = got["warnings"].as_array().unwrap();
        assert!(codes.iter().any(|w| w["code"] == "grid_without_relation"), "{codes:?}");
    }
    let text = good(&["forecast", "--Lx", "2.5", "--Ly", "3.5", "--stagger"]);
    assert!(text.contains("Lx 2.50 m, Ly 3.50 m, staggered"), "{text}");
}

#[test]
fn twists_across_exchange_the_offsets_of_a_square_cell() {
    let across = json(&["forecast", "--ex=0.4", "--ey=0.9", "--twists", "across"]);
    let down = json(&["forecast", "--ex=0.9", "--ey=0.4"]);
    assert_eq!(across["field"], down["field"]);
    assert_ne!(across["field"], json(&["forecast", "--ex=0.4", "--ey=0.9"])["field"]);
}

#[test]
fn one_spacing_and_two_are_never_given_together() {
    assert!(refused(&["forecast", "-L", "3", "--Ly", "3"]).contains("never both"));
    assert!(refused(&["forecast", "--Lx", "3"]).contains("--Ly as well"));
    let text = refused(&["forecast", "--Lx", "2", "--Ly", "4.5", "--stagger"]);
    assert!(text.contains("Lx/Ly = 0.444") && text.contains("0.5 to 2"), "{text}");
    assert!(refused(&["forecast", "--Lx", "0.2", "--Ly", "3"]).starts_with("error: "));
}

#[test]
fn a_single_block_says_whether_more_cells_would_change_it() {
    let all = ["check", "-d", "0.2", "-L", "1.0", "-D", "0.3", "--blocks", "single", "--fidelity"];
    let v = json(&[&all[..], &["quick", "--runs", "1"]].concat());
    let words = v["arrangement_words"].as_str().unwrap();
    // As it is in 5 x 5 and 7 x 7 cells: the net comes from farther away.
    assert!(words.starts_with("single in 7 x 7 cells, not converged, last change"), "{words}");
    let codes = v["warnings"].as_array().unwrap();
    assert!(codes.iter().any(|w| w["code"] == "not_converged"), "{codes:?}");
    let text = good(&[&all[..], &["quick", "--runs", "1"]].concat());
    assert!(text.contains("not converged"), "{text}");
}

#[test]
fn the_second_spacing_is_varied_where_there_is_one() {
    let grid = ["--Lx", "1.3", "--Ly", "1.6", "-D", "0.4", "-d", "0.25"];
    let quick = ["--dem", "--fidelity", "quick", "--runs", "2", "--threads", "1"];
    let v = json(&[&["sensitivity"][..], &grid, &quick].concat());
    let bars = v["sensitivity"].as_array().unwrap();
    let words: Vec<&str> = bars.iter().map(|b| b["input"].as_str().unwrap()).collect();
    assert_eq!(words, ["d", "L", "Ly", "D", "ex", "ey", "Fl", "dl"]);
    assert_eq!(
        (bars[2]["low"]["value"].as_f64(), bars[2]["high"]["value"].as_f64()),
        (Some(1.44), Some(1.76))
    );
    // The forecast has no relation for this grid; the check answers at each step.
    assert!(bars[2]["high"]["F_kN"].is_null());
    assert!(bars[2]["high"]["check"]["F_kN"].as_f64().unwrap() > 1.0, "{}", bars[2]);
    // On a square grid there is none to be moved.
    let v = json(&["sensitivity"]);
    assert!(v["sensitivity"].as_array().unwrap().iter().all(|b| b["input"] != "Ly"));

    let line = ["sweep", "--vary", "Ly", "--from", "1.4", "--to", "1.6", "--steps", "2"];
    let v = json(&[&line[..], &grid, &quick].concat());
    let points = v["points"].as_array().unwrap();
    let forces: Vec<f64> = points.iter().map(|p| p["check"]["F_kN"].as_f64().unwrap()).collect();
    let check =
        ["check", "--Lx", "1.3", "--Ly", "1.4", "-D", "0.4", "-d", "0.25", "--fidelity", "quick"];
    let one = json(&[&check[..], &["--runs", "2"]].concat());
    let expected = one["mean"]["F_kN"].as_f64().unwrap();
    assert!((forces[0] / expected - 1.0).abs() < 1e-4 && forces[1] != forces[0], "{forces:?}");
}

#[test]
fn a_check_of_a_staggered_grid_answers_where_the_forecast_cannot() {
    let grid = ["--Lx", "1.3", "--Ly", "1.6", "--stagger", "--blocks", "worst"];
    let mut all =
        vec!["check", "-D", "0.5", "--fidelity", "quick", "--runs", "2", "--format", "json"];
    all.extend(grid);
    let got = run(&all);
    assert_eq!(got.code, 0, "{}", got.err);
    let value: serde_json::Value = serde_json::from_str(&got.out).unwrap();
    assert!(value["mean"]["F_kN"].as_f64().unwrap() > 1.0, "{}", got.out);
    // Nothing to face each other across.
    let said = refused(&["check", "--stagger", "--blocks", "mirrored", "--runs", "1"]);
    assert!(said.contains("no anchor line"), "{said}");
}

#[test]
fn the_flags_stand_above_a_file_with_two_spacings() {
    let text =
        "(version: 2, name: \"p\", layouts: [(name: \"a\", d: 0.32, Lx: 2.5, Ly: 3.5, D: 1.0)])";
    let (_directory, path) = file("p.ron", text);
    let of = |more: &[&str]| {
        let mut all = vec!["forecast", shown(&path), "--layout", "a"];
        all.extend(more);
        json(&all)["inputs"].clone()
    };
    assert_eq!((&of(&[])["L_m"], &of(&[])["Ly_m"]), (&2.5.into(), &3.5.into()));
    assert_eq!(
        (&of(&["--Lx", "3"])["L_m"], &of(&["--Lx", "3"])["Ly_m"]),
        (&3.0.into(), &3.5.into())
    );
    assert!(of(&["-L", "3"]).get("Ly_m").is_none());
}
