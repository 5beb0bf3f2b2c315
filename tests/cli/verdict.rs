//! Whether a layout is enough, as commands say it, and the exit codes of `--verdict`.

use super::{file, good, json, refused, run, shown};

/// Double twist 8x10, d 0.25, L 3, D 0.6 m, 20 kN, 0.4 m allowed: strong enough and far too soft.
const JOB: [&str; 10] =
    ["forecast", "-d", "0.25", "-D", "0.6", "--force", "20", "--deflection", "0.4", "-L"];

fn job<'a>(spacing: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&JOB[..], &[spacing], more].concat()
}

#[test]
fn a_layout_that_is_strong_enough_and_too_soft_fails_by_its_deflection() {
    let v = &json(&job("3", &[]))["verdict"];
    assert_eq!((&v["verdict"], &v["governing"]), (&"FAILS".into(), &"deflection".into()));
    // 20/23.431 on the mean, and over 0.88485 of it on the characteristic value.
    let strength = &v["checks"][0];
    assert_eq!(strength["state"], "pass");
    for (name, value) in [("use", 0.853_56), ("use_characteristic", 0.964_64)] {
        assert!((strength[name].as_f64().unwrap() - value).abs() < 1e-5, "{strength}");
    }
    assert_eq!(v["mend"]["input"], "L");
    let text = good(&job("3", &[]));
    assert!(
        text.contains("FAILS: deflection 157 %") && text.contains("spacing L 1.871 m"),
        "{text}"
    );
}

#[test]
fn the_exit_code_tells_the_verdict_only_when_it_is_asked_for() {
    let code = |spacing, more: &[&str]| run(&job(spacing, more)).code;
    assert_eq!(
        [code("3", &[]), code("3", &["--verdict"]), code("1.86", &["--verdict"])],
        [0, 3, 0]
    );
    // The block is on a plate; what is not asked cannot fail; bad input goes first.
    assert_eq!(code("3", &["--ex", "1.5", "--ey", "1.5", "--verdict"]), 4);
    assert_eq!(run(&["forecast", "--verdict"]).code, 0);
    assert_eq!(run(&["forecast", "-L", "0.1", "--verdict"]).code, 2);
    // 21.5/23.43 and 21.5/20.73 kN.
    let alone = ["forecast", "-d", "0.25", "-D", "0.6", "--force", "21.5", "--verdict", "--basis"];
    let of = |basis| run(&[&alone[..], &[basis]].concat()).code;
    assert_eq!([of("mean"), of("characteristic")], [0, 3]);
}

#[test]
fn one_layout_that_fails_makes_a_comparison_fail() {
    let (_keep, path) = file(
        "two.ron",
        r#"(version: 2, name: "p", layouts: [
            (name: "a", d: 0.25, L: 1.8, D: 0.6, pressure: 2.5),
            (name: "b", d: 0.25, L: 3.0, D: 0.6, pressure: "2.7 kN/m2"),
        ])"#,
    );
    // 2.7 kN/m2 on 9 m2 are 24.3 kN, over 23.4 kN.
    let compared = run(&["compare", shown(&path), "--verdict"]);
    assert_eq!(compared.code, 3, "{}", compared.out);
    assert!(compared.out.contains(">xb ") && compared.out.contains(" +a "), "{}", compared.out);
    assert_eq!(run(&["forecast", shown(&path), "--layout=a", "--verdict"]).code, 0);
}

#[test]
fn a_force_and_a_pressure_together_are_refused() {
    let said = refused(&["forecast", "--force", "20", "--pressure", "2.5"]);
    assert!(said.contains("--pressure"), "{said}");
    // One flag takes the place of what the file has.
    let text =
        r#"(version: 2, name: "p", layouts: [(name: "a", d: 0.25, L: 2, D: 0.6, pressure: 2.5)])"#;
    let (_keep, path) = file("one.ron", text);
    let forecast =
        |more: &[&str]| json(&[&["forecast", shown(&path), "--layout=a"], more].concat());
    let demand = |v: serde_json::Value| v["verdict"]["checks"][0]["demand_kN"].as_f64().unwrap();
    let found = [forecast(&[]), forecast(&["--force", "4"]), forecast(&["--pressure", "2"])];
    assert_eq!(found.map(demand), [10.0, 4.0, 8.0]);
    // Both in a file are refused with their place.
    let (_keep, path) = file("both.ron", &text.replace("pressure", "design_force: 3, pressure"));
    let said = refused(&["forecast", shown(&path)]);
    assert!(said.contains("layouts[0].pressure") && said.contains("never both"), "{said}");
}

#[test]
fn the_basis_is_the_projects_and_a_flag_stands_above_it() {
    // 21.5 kN on 23.43 and 20.73 kN.
    let text = |basis: &str| {
        format!(
            r#"(version: 2, name: "p", {basis} layouts: [(name: "a", d: 0.25, L: 3, D: 0.6, design_force: 21.5)])"#
        )
    };
    for (basis, code) in [("", 0), ("basis: mean,", 0), ("basis: characteristic,", 3)] {
        let (_keep, path) = file("p.ron", &text(basis));
        let all = ["forecast", shown(&path), "--verdict"];
        assert_eq!(run(&all).code, code, "{basis}");
        assert_eq!(run(&[&all[..], &["--basis", "mean"]].concat()).code, 0);
        let design = json(&["forecast", shown(&path)]);
        // The basis is no input of the forecast.
        assert_eq!(design[0]["fingerprint"], json(&JOB_AT_3)["fingerprint"]);
    }
    let (_keep, path) = file("p.ron", &text("basis: median,"));
    assert!(refused(&["forecast", shown(&path)]).contains("mean or characteristic"));
    let (_keep, path) = file("new.ron", "");
    std::fs::remove_file(&path).unwrap();
    assert_eq!(run(&["new", shown(&path)]).code, 0);
    assert!(std::fs::read_to_string(&path).unwrap().contains("basis: characteristic"));
}

const JOB_AT_3: [&str; 5] = ["forecast", "-d", "0.25", "-D", "0.6"];

/// The job of `tests/screens/job.rs` by commands.
#[test]
fn a_sweep_over_the_spacing_fails_from_1_87_m_on() {
    let job = ["-d", "0.25", "-D", "0.6", "--force", "20", "--deflection", "0.4"];
    let range = ["--vary", "L", "--from", "1.25", "--to", "4.5", "--steps", "66"];
    let v = json(&[&["sweep"], &job[..], &range].concat());
    let points = v["points"].as_array().unwrap();
    for point in points {
        let fails = point["L_m"].as_f64().unwrap() > 1.87;
        assert_eq!(point["verdict"], if fails { "FAILS" } else { "PASSES" }, "{point}");
        assert_eq!(point["use"].as_f64().unwrap() > 1.0, fails, "{point}");
        if fails {
            assert_eq!(point["verdict_by"], "deflection", "{point}");
        }
    }
    // The same spacing by the solver, and what the design advises.
    let v = json(&[&["design"], &job[..], &["--solve", "L"]].concat());
    assert_eq!(v["verdict"]["mend"]["input"], "L");
    let both = v["solutions"].as_array().unwrap().last().unwrap();
    let value = both["crossings"][0]["value_m"].as_f64().unwrap();
    assert!((value - 1.871).abs() < 1e-3 && both["crossings"][0]["advised"] == true, "{both}");
}

#[test]
fn plate_and_block_that_were_swapped_are_asked_about() {
    let codes = |d: &str, big: &str| {
        let v = json(&["forecast", "-d", d, "-D", big]);
        let all = v["warnings"].as_array().unwrap().clone();
        all.iter().any(|w| w["code"] == "d_and_D_swapped")
    };
    assert_eq!(
        [codes("0.6", "0.25"), codes("0.25", "0.6"), codes("0.3", "0.2")],
        [true, false, false]
    );
}

#[test]
fn a_check_is_judged_too() {
    let check =
        ["check", "-d", "0.3", "-L", "1.5", "-D", "0.5", "--runs", "2", "--fidelity", "quick"];
    // Nothing asked, nothing judged.
    let plain: serde_json::Value =
        serde_json::from_str(&run(&[&check[..], &["--format", "json"]].concat()).out).unwrap();
    assert!(plain["verdict"].is_null(), "{plain}");
    let with = |force: &str, more: &[&str]| run(&[&check[..], &["--force", force], more].concat());
    assert_eq!([with("1", &[]).code, with("1", &["--verdict"]).code], [0, 0]);
    let failed = with("90", &["--verdict"]);
    assert_eq!(failed.code, 3, "{}", failed.out);
    assert!(failed.out.contains("FAILS: strength"), "{}", failed.out);
    let v: serde_json::Value =
        serde_json::from_str(&with("90", &["--format", "json"]).out).unwrap();
    assert_eq!(v["verdict"]["verdict"], "FAILS");
    // The forecast of this panel is about 20 kN; the weaker of both is what counts.
    let by = &v["verdict"]["checks"][0]["by"];
    let (ours, theirs) =
        (v["mean"]["F_kN"].as_f64().unwrap(), v["forecast"]["F_kN"].as_f64().unwrap());
    assert_eq!(by, if ours < theirs { "check" } else { "forecast" }, "{v}");
    // A laboratory's test is no panel on a slope.
    let lab = run(&[&check[..], &["--test", "laboratory", "--force", "90", "--verdict"]].concat());
    assert_eq!(lab.code, 0, "{}", lab.out);
}

#[test]
fn meshes_of_two_kinds_of_values_are_not_compared_without_a_word() {
    let mesh = |id: &str, kind: &str| {
        format!(
            r#"(id: "{id}", laboratory: (force: 70, deflection: 0.6, statistic: {kind}, source: "made up"))"#
        )
    };
    let text = format!(
        r#"(version: 2, name: "p", meshes: [{}, {}], layouts: [
            (name: "a", d: 0.25, L: 2, D: 0.6, mesh: "m"), (name: "b", d: 0.25, L: 2, D: 0.6, mesh: "c")])"#,
        mesh("m", "Mean"),
        mesh("c", "Characteristic")
    );
    let (_keep, path) = file("mixed.ron", &text);
    let said = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = "mean and characteristic laboratory values stand side by side";
    assert!(said(good(&["compare", shown(&path)])).contains(words));
    assert!(json(&["compare", shown(&path)])["remark"].as_str().unwrap().contains(words));
    assert!(said(good(&["report", shown(&path)])).contains(words));
    let (_keep, path) = file("one.ron", &text.replace("Characteristic", "Mean"));
    assert!(!said(good(&["compare", shown(&path)])).contains(words));
}

#[test]
fn a_layout_that_is_left_out_of_the_check_is_not_judged() {
    let text = r#"(version: 2, name: "p", meshes: [(id: "bare", laboratory: (force: 70, deflection: 0.6, statistic: Mean, source: "made up"))],
        layouts: [(name: "a", d: 0.3, L: 1.5, D: 0.5, mesh: "dt-8x10-2.7", design_force: 1),
            (name: "no wire", d: 0.3, L: 1.5, D: 0.5, mesh: "bare", design_force: 1)])"#;
    let (_keep, path) = file("p.ron", text);
    let check = ["check", shown(&path), "--runs", "2", "--fidelity", "quick", "--verdict"];
    let r = run(&check);
    assert_eq!(r.code, 4, "{}{}", r.out, r.err);
    // Of which nothing is asked, nothing is missed.
    let (_keep, path) = file("p.ron", &text.replace(r#""bare", design_force: 1"#, r#""bare""#));
    let r = run(&["check", shown(&path), "--runs", "2", "--fidelity", "quick", "--verdict"]);
    assert_eq!(r.code, 0, "{}{}", r.out, r.err);
}

#[test]
fn a_block_smaller_than_the_opening_is_said_by_a_check() {
    let v = json(&["check", "-D", "0.05", "-L", "1.5", "--runs", "1", "--fidelity", "quick"]);
    let all = v["warnings"].as_array().unwrap();
    let said = |w: &&serde_json::Value| w["code"] == "no_forecast";
    let one = all.iter().find(said).unwrap_or_else(|| panic!("{v}"));
    assert!(one["message"].as_str().unwrap().contains("smaller than the mesh opening"), "{one}");
}
