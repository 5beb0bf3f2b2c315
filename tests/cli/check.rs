//! `meshcast check`: shape of the result, plain runs, threads, Ctrl+C, mesh files. Quick fidelity and
//! small panels, so that all of it takes seconds.

use super::{PROJECT, command, file, good, json, ran, refused, run, shown};
use serde_json::{Map, Value};

/// A small anchored panel that runs in some milliseconds.
const SMALL: [&str; 8] = ["check", "-L", "1.6", "-D", "0.5", "--fidelity", "quick", "--seed=7"];

fn arguments<'a>(more: &[&'a str]) -> Vec<&'a str> {
    SMALL.iter().chain(more).copied().collect()
}

/// The result as JSON; progress is the only thing said beside it.
fn checked(more: &[&str]) -> Value {
    let mut all = arguments(more);
    all.extend(["--format", "json"]);
    let got = run(&all);
    assert_eq!(got.code, 0, "{}", got.err);
    assert!(got.err.lines().all(|l| l.starts_with("progress: ")), "{}", got.err);
    serde_json::from_str(&got.out).expect("standard output is JSON")
}

fn object(value: &Value) -> &Map<String, Value> {
    value.as_object().unwrap_or_else(|| panic!("{value} is no object"))
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn has(value: &Value, fields: &[&str]) {
    for field in fields {
        assert!(object(value).contains_key(*field), "{field} is missing in {value}");
    }
}

#[test]
fn the_result_has_every_field() {
    let r = checked(&["--runs", "2"]);
    has(&r, &["version", "fingerprint", "inputs", "test", "fidelity", "runs", "mean", "mean_peak"]);
    has(&r, &["standard_error", "slipped", "band", "forecast", "warnings"]);
    assert_eq!((r["test"].as_str(), r["fidelity"].as_str()), (Some("anchored"), Some("quick")));
    has(&r["inputs"], &["d_m", "L_m", "D_m", "ex_m", "ey_m", "mesh", "branch"]);
    for pair in ["mean", "mean_peak", "standard_error", "forecast"] {
        assert!(number(&r[pair]["F_kN"]) > 0.0 && number(&r[pair]["delta_m"]) > 0.0, "{pair}");
    }
    for side in ["F_kN", "delta_m"] {
        let band = r["band"][side].as_array().unwrap();
        assert!(band.len() == 2 && number(&band[0]) <= number(&band[1]));
    }
    assert_eq!(r["runs"].as_array().map(Vec::len), Some(2));
    for run in r["runs"].as_array().unwrap() {
        has(run, &["seed", "phase", "stop", "first_break", "breaks", "peak", "energy_J"]);
        has(run, &["k75_kN_per_m", "curve", "quality", "cost", "skipped"]);
        assert!(run["seed"].is_u64() && run["phase"].as_array().unwrap().len() == 2);
        assert_eq!(run["stop"], "after_break");
        let first = &run["first_break"];
        has(first, &["F_kN", "delta_m", "bond"]);
        has(&first["bond"], &["kind", "x_m", "y_m"]);
        assert!(["single_wire", "double_twist"].contains(&first["bond"]["kind"].as_str().unwrap()));
        has(&run["breaks"][0], &["kind", "x_m", "y_m", "delta_m"]);
        let reached = number(&first["delta_m"]);
        assert!((number(&run["breaks"][0]["delta_m"]) - reached).abs() < 1e-9);
        assert!(
            number(&run["peak"]["F_kN"]) >= number(&first["F_kN"])
                && run["peak"]["delta_m"].is_f64()
        );
        let curve = |side: &str| run["curve"][side].as_array().unwrap().len();
        assert!(curve("delta_m") > 50 && curve("delta_m") == curve("F_kN"));
        has(&run["quality"], &["kinetic_over_internal", "energy_balance"]);
        has(&run["quality"], &["support_over_punch", "error_estimate"]);
        has(&run["cost"], &["wall_ms", "steps", "nodes", "bonds"]);
        assert!(!run["skipped"].as_array().unwrap().is_empty());
    }
    let force = |k: usize| number(&r["runs"][k]["first_break"]["F_kN"]);
    assert!((number(&r["mean"]["F_kN"]) - (force(0) + force(1)) / 2.0).abs() < 1e-9);
    // With one alignment for all the runs differ by their slack alone: the standard error of two values is half
    // their difference.
    let pinned = checked(&["--runs", "2", "--phase", "0.3,0.6"]);
    let force = |k: usize| number(&pinned["runs"][k]["first_break"]["F_kN"]);
    let error = (force(0) - force(1)).abs() / 2.0;
    assert!((number(&pinned["standard_error"]["F_kN"]) - error).abs() < 1e-9);
    assert!(r["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "wire_law"));
}

#[test]
fn a_single_plain_run_is_the_run_that_was_asked_for() {
    let r = checked(&["--runs", "1", "--phase", "0.25,0.125", "--law", "bench", "--after-break=0"]);
    let runs = r["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 1);
    assert_eq!(runs[0]["phase"], serde_json::json!([0.25, 0.125]));
    assert_eq!(r["mean"]["F_kN"], runs[0]["first_break"]["F_kN"]);
    assert_eq!(r["band"]["F_kN"][0], r["band"]["F_kN"][1]);
    // Nothing is known of the scatter.
    assert_eq!(r["standard_error"]["F_kN"], Value::Null);
    // The bench law has no scatter, so the seed decides nothing.
    let again = checked(&[
        "--runs=1",
        "--phase=0.25,0.125",
        "--law=bench",
        "--after-break=0",
        "--instructions=portable",
    ]);
    assert_eq!(again["mean"], r["mean"]);
    assert_eq!(again["fingerprint"], r["fingerprint"]);
}

/// The same, whatever the number of threads, but for the time it took.
#[test]
fn threads_change_nothing() {
    let without_time = |threads: &str| {
        let mut r = checked(&["--runs", "3", "--threads", threads]);
        for run in r["runs"].as_array_mut().unwrap() {
            run["cost"]["wall_ms"] = Value::Null;
        }
        r
    };
    assert_eq!(without_time("1"), without_time("2"));
}

#[test]
fn the_laboratory_has_random_alignments_and_eqs_1_and_2_beside_it() {
    let got = run(&[
        "check",
        "--test=laboratory",
        "-L2",
        "--runs=2",
        "--fidelity=quick",
        "--after-break=0",
        "--format=json",
    ]);
    assert_eq!(got.code, 0, "{}", got.err);
    let r: Value = serde_json::from_str(&got.out).unwrap();
    assert_eq!(r["test"], "laboratory");
    assert_ne!(r["runs"][0]["phase"], r["runs"][1]["phase"]);
    // Worked by hand: 73.3 (0.89 + 0.11 x 2/3) and 0.60 (0.15 + 0.85 x 2/3).
    assert!((number(&r["forecast"]["F_kN"]) - 70.612_333).abs() < 1e-5);
    assert!((number(&r["forecast"]["delta_m"]) - 0.43).abs() < 1e-9);
    // For another punch the paper has no relation.
    let other = checked(&["--test", "laboratory", "--runs=1", "--after-break=0"]);
    assert_eq!(other["forecast"]["F_kN"], Value::Null);
    assert!(other["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "no_forecast"));
}

#[test]
fn a_punch_as_small_as_the_opening_slips_and_says_so() {
    // Over the middle of an opening.
    let all = [
        "check",
        "-L1.6",
        "-D0.08",
        "--fidelity=quick",
        "--runs=1",
        "--phase=0.25,0.25",
        "--format=json",
    ];
    let got = run(&all);
    assert_eq!(got.code, 0, "{}", got.err);
    let r: Value = serde_json::from_str(&got.out).unwrap();
    let run = &r["runs"][0];
    assert_eq!(run["stop"], "slipped");
    assert_eq!((&run["first_break"], r["slipped"].as_u64()), (&Value::Null, Some(1)));
    assert_eq!(r["mean"]["F_kN"], Value::Null);
    assert!(r["band"]["F_kN"][0].is_f64());
    assert!(r["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "slipped"));
}

#[test]
fn a_project_gives_a_list_and_leaves_out_what_cannot_be_checked() {
    let (_directory, path) = file("p.ron", PROJECT);
    let quick = ["--runs=1", "--fidelity=quick", "--after-break=0", "--format=json"];
    let got = run(&[&["check", shown(&path)][..], &quick].concat());
    assert_eq!(got.code, 0, "{}", got.err);
    let all: Value = serde_json::from_str(&got.out).unwrap();
    let names: Vec<&str> =
        all.as_array().unwrap().iter().map(|r| r["layout"].as_str().unwrap()).collect();
    assert_eq!(names, ["bench 2", "portal, east"]);
    assert!(
        got.err.contains("layout \"corner\" is left out") && got.err.contains("plate"),
        "{}",
        got.err
    );
    let one = run(&[&["check", shown(&path), "--layout", "bench 2"][..], &quick].concat());
    let one: Value = serde_json::from_str(&one.out).unwrap();
    assert_eq!(one["layout"], "bench 2");
    let e = refused(&["check", shown(&path), "--layout", "corner"]);
    assert!(e.contains("anchor plate"), "{e}");
}

#[test]
fn text_and_csv_hold_the_comparison_and_the_curves() {
    let got = run(&arguments(&["--runs=2"]));
    assert_eq!(got.code, 0);
    for word in
        ["forecast", "CHECK", "check over forecast", "quality", "cost", "skipped", "wire law", "X"]
    {
        assert!(got.out.contains(word), "{word} is missing in\n{}", got.out);
    }
    assert!(got.out.lines().all(|l| l.chars().count() <= 80), "{}", got.out);
    let got = run(&arguments(&["--runs=2", "--format=csv"]));
    let mut lines = got.out.lines();
    assert_eq!(lines.next(), Some("run,delta_m,F_kN,anchor_normal_kN,anchor_in_plane_kN"));
    let runs: std::collections::BTreeSet<&str> =
        lines.map(|l| l.split(',').next().unwrap()).collect();
    assert_eq!(runs.into_iter().collect::<Vec<_>>(), ["1", "2"]);
}

#[test]
fn bad_input_is_refused_at_its_flag() {
    for (more, words) in [
        (&["--phase", "1.5,0"][..], &["--phase", "below 1"][..]),
        (&["--runs", "0"], &["--runs", "1 to 10000"]),
        (&["--step-factor", "2"], &["--step-factor", "stability"]),
        (&["--damping", "0.9"], &["--damping", "0.5"]),
        (&["--speed", "1"], &["--speed"]),
        (&["--ex", "0.8", "--ey", "0.8"], &["anchor plate"]),
        (&["--law", "bensh"], &["--law", "bench, yade or reference"]),
        (&["--mesh-file", "/nonexistent.ron"], &["/nonexistent.ron", "no such file"]),
        (&["--test", "field"], &["--test", "anchored"]),
    ] {
        let e = refused(&arguments(more));
        assert!(words.iter().all(|w| e.contains(w)), "{more:?}: {e}");
    }
}

#[test]
fn a_mesh_without_wires_says_what_to_do() {
    let sample = concat!(env!("CARGO_MANIFEST_DIR"), "/projects/own-mesh.ron");
    let e = refused(&["check", sample, "--layout", "our mesh"]);
    assert!(e.contains("example-mesh") && e.contains("--mesh-file"), "{e}");
    // With wires from a file it can be checked.
    let wires = concat!(env!("CARGO_MANIFEST_DIR"), "/projects/wire/dt-8x10-2.7.ron");
    let got = run(&[
        "check",
        sample,
        "--layout",
        "our mesh",
        "--mesh-file",
        wires,
        "--runs=1",
        "--fidelity=quick",
        "--after-break=0",
        "--format=json",
    ]);
    assert_eq!(got.code, 0, "{}", got.err);
}

#[test]
fn a_bad_mesh_file_is_refused_with_file_line_and_field() {
    let good = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/projects/wire/dt-8x10-2.7.ron"
    ))
    .unwrap();
    let line = 1 + good.lines().position(|l| l.contains("diameter")).unwrap();
    for (from, to, field) in [
        ("diameter: 0.0027", "diameter: -0.0027", "net.diameter"),
        ("diameter: 0.0027", "diameter: \"thick\"", "net.diameter"),
        ("diameter: 0.0027", "diametre: 0.0027", "net.diametre"),
    ] {
        assert!(good.contains(from));
        let (_directory, path) = file("wires.ron", &good.replace(from, to));
        let e = refused(&arguments(&["--mesh-file", shown(&path)]));
        let place = format!("line {line}");
        assert!(e.contains("wires.ron") && e.contains(&place) && e.contains(field), "{e}");
    }
}

/// Ctrl+C ends with what there is: valid JSON, exit code 130.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_valid_json() {
    use std::io::Read;
    use std::time::Duration;
    let mut child =
        command(&["check", "--runs=500", "--threads=1", "--fidelity=quick", "--format=json"])
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
    // The first line of progress comes when the runs are on their way.
    let mut first = [0_u8; 9];
    child.stderr.as_mut().unwrap().read_exact(&mut first).unwrap();
    assert_eq!(&first, b"progress:");
    std::thread::sleep(Duration::from_millis(300));
    let pid = child.id().to_string();
    let kill = std::process::Command::new("kill").args(["-INT", &pid]).status().unwrap();
    assert!(kill.success());
    let got = ran(child.wait_with_output().unwrap());
    assert_eq!(got.code, 130, "{}", got.err);
    let r: Value = serde_json::from_str(&got.out).expect("still JSON");
    let runs = r["runs"].as_array().unwrap();
    assert!(!runs.is_empty() && runs.len() < 500, "{} runs", runs.len());
    assert_eq!(runs.last().unwrap()["stop"], "cancelled");
    assert!(r["warnings"].as_array().unwrap().iter().any(|w| w["code"] == "cancelled"));
}

#[test]
fn a_check_of_which_no_run_came_to_an_end_is_no_success() {
    // Far too fast and far too damped: a wire snaps early, and again with a shorter step.
    let wild = [
        "-d",
        "0.25",
        "-D",
        "0.3",
        "--phase",
        "0.25,0.125",
        "--speed",
        "0.002",
        "--damping",
        "0.5",
    ];
    let got = run(&[&SMALL[..3], &["--fidelity", "quick", "--runs", "1"], &wild].concat());
    assert_eq!(got.code, 1, "{}", got.out);
    assert!(got.out.contains("1 run diverged and is not counted"), "{}", got.out);
    assert!(got.out.contains("no break"), "{}", got.out);
}

#[test]
fn a_project_s_check_of_another_solver_stands_beside_the_new_one() {
    let text = include_str!("../golden/inputs/kept.ron");
    let check = |text: &str| {
        let (_keep, path) = file("kept.ron", text);
        let one =
            ["check", shown(&path), "--layout", "centred", "--fidelity", "quick", "--runs", "2"];
        let got = run(&[&one[..], &["--format", "json"]].concat());
        let v: Value = serde_json::from_str(&got.out).expect("standard output is JSON");
        (v["kept_before"].clone(), run(&one).out)
    };
    let now = meshcast::study::result::Revisions::CURRENT.to_string();
    let at = text.find("by:\"").expect("a kept check") + 4;
    let by = &text[at..at + text[at..].find('"').expect("its end")];
    let (before, said) = check(&text.replace(by, &now));
    assert!(before.is_null() && !said.contains("kept check"), "{before}");
    let (before, said) = check(&text.replace(by, "solver 1, sampling 1"));
    assert_eq!(before["made_by"], "solver 1, sampling 1");
    assert_eq!(before["same_inputs"], true, "{before}");
    // The same solver in truth: nothing has moved beyond the rounding of what is kept.
    assert!(before["change_F"].as_f64().unwrap().abs() < 1e-4, "{before}");
    assert!(said.contains("by solver 1, sampling 1, quick; now F"), "{said}");
}

/// By hand, for the bench law, whose slack is the same in all bonds: a wire of 56.57 mm is taut at 58.27 mm and breaks
/// at 14.115 % more, 66.49 mm, where it carries 565.85 MPa x 5.7256 mm2 = 3239.8 N; it reaches 40 mm across, so
/// 53.11 mm along the pull; two of them for each 80 mm of width carry 5175.9 N, less than the 6480 N of a twist.
#[test]
fn a_net_that_is_pulled_breaks_at_the_strength_that_statics_gives() {
    let arguments =
        ["check", "--pull", "along", "--piece", "0.8,0.8", "--law", "bench", "--runs", "1"];
    let pulled = json(&arguments);
    let strength = pulled["strength_kN_per_m"].as_f64().unwrap();
    assert!((strength / (5.1759 / 0.08) - 1.0).abs() < 0.005, "{strength}");
    assert_eq!(pulled["pulls"][0]["twist_broke"].as_bool(), Some(false));
    // Random slack makes it weaker; across the twists a net has about half of that.
    let of = |way: &str| {
        let pulled = json(&["check", "--pull", way, "--piece", "0.8,0.8", "--runs", "2"]);
        pulled["strength_kN_per_m"].as_f64().unwrap()
    };
    let (along, across) = (of("along"), of("across"));
    assert!(across > 0.25 * along && across < 0.75 * along, "{along} {across}");
    let said = good(&["check", "--pull", "across", "--piece", "0.5,0.5", "--runs", "1"]);
    assert!(said.contains("STRENGTH") && said.contains("kN/m at"), "{said}");
    let e = refused(&["check", "--pull", "along", "--piece", "0.1,1"]);
    assert!(e.contains("--piece") && e.contains("0.2 to 10 m"), "{e}");
}
