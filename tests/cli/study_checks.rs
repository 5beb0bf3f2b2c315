//! `sensitivity`, `sweep` and `compare` with `--dem`: numbers, reasons, forms, Ctrl+C. Tiny panels and
//! few quick runs, so that all of it takes a second or two.

use super::{command, file, json, ran, refused, run, shown};
use serde_json::Value;

/// A panel that runs in some milliseconds, and how it is checked.
const PANEL: [&str; 4] = ["-L", "1.3", "-D", "0.4"];
const QUICK: [&str; 2] = ["--runs=2", "--seed=7"];

fn of<'a>(command: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&[command][..], &PANEL, &QUICK, more].concat()
}

/// Standard output of a run that went well; progress is the only thing said beside it.
fn went(arguments: &[&str]) -> String {
    let got = run(arguments);
    assert_eq!(got.code, 0, "{}", got.err);
    assert!(got.err.lines().all(|l| l.starts_with("progress: ")), "{}", got.err);
    got.out
}

fn object(arguments: &[&str]) -> Value {
    let out = went(&[arguments, &["--format=json"]].concat());
    serde_json::from_str(&out).expect("standard output is JSON")
}

/// All lines fit a screen's width and end without blanks; nothing is beyond ASCII.
fn fits(out: &str) {
    for line in out.lines() {
        assert!(line.len() <= 80, "{} columns: {line}", line.len());
        assert!(line == line.trim_end() && line.is_ascii(), "{line:?}");
    }
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} in {value}"))
}

/// Equal but for the five digits to which a study rounds its checks.
fn same(ours: &Value, path: &str, theirs: &Value, their_path: &str) {
    let (a, b) = (number(ours, path), number(theirs, their_path));
    assert!((a - b).abs() <= 6e-5 * b.abs(), "{path} {a}, {their_path} {b}");
}

/// The `dem` of a study beside the result of `check` for the same layout.
fn is_the_check(dem: &Value, check: &Value) {
    same(dem, "/F_kN", check, "/mean/F_kN");
    same(dem, "/delta_m", check, "/mean/delta_m");
    for side in ["F_kN", "delta_m"] {
        same(dem, &format!("/standard_error/{side}"), check, &format!("/standard_error/{side}"));
        for end in ["0", "1"] {
            same(dem, &format!("/band/{side}/{end}"), check, &format!("/band/{side}/{end}"));
        }
    }
    assert_eq!(dem["runs"].as_u64(), check["runs"].as_array().map(|r| r.len() as u64));
    assert_eq!(dem["runs"], dem["broken"]);
    assert!(number(dem, "/error_estimate") > 0.0);
    assert_eq!((&dem["slipped"], &dem["fingerprint"]), (&check["slipped"], &check["fingerprint"]));
}

#[test]
fn a_sweep_is_the_check_at_each_point() {
    let range = ["--vary", "L", "--from", "1.3", "--to", "1.5", "--steps", "2", "--force", "8"];
    let plain = json(&[&["sweep"][..], &PANEL, &range].concat());
    let v = object(&of("sweep", &[&range[..], &["--dem"]].concat()));
    assert_eq!(v["check_plan"]["fidelity"], "quick");
    assert_eq!((&v["check_plan"]["runs"], &v["check_plan"]["seed"]), (&2.into(), &7.into()));
    for (index, spacing) in ["1.3", "1.5"].iter().enumerate() {
        let point = &v["points"][index];
        let check =
            object(&["check", "-L", spacing, "-D0.4", "--fidelity=quick", "--runs=2", "--seed=7"]);
        let dem = &point["check"];
        is_the_check(dem, &check);
        let over = 100.0 * (number(dem, "/F_kN") / number(point, "/F_kN") - 1.0);
        assert!((number(dem, "/difference_pct/F") - over).abs() < 1e-6);
        // gamma 1: the design force over the mean.
        assert!((number(dem, "/utilisation") - 8.0 / number(dem, "/F_kN")).abs() < 1e-9);
        assert!(point["check_reason"].is_null());
        // The forecast beside it is what it is without.
        for field in ["L_m", "F_kN", "delta_m", "utilisation", "warnings"] {
            assert_eq!(point[field], plain["points"][index][field]);
        }
    }
    assert!(plain["points"][0].get("check").is_none() && plain.get("check_plan").is_none());

    let out = went(&of("sweep", &[&range[..], &["--dem", "--format=csv"]].concat()));
    let rows: Vec<Vec<&str>> = out.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(rows[0][..2], ["L_m", "F_kN"]);
    assert_eq!(
        rows[0][10..14],
        ["check_F_kN", "check_delta_m", "check_utilisation", "check_F_low_kN"]
    );
    assert!(rows.len() == 3 && rows.iter().all(|r| r.len() == rows[0].len()), "{out}");
    assert_eq!(rows[1][10], v["points"][0]["check"]["F_kN"].to_string());
    let text = went(&of("sweep", &[&range[..], &["--dem"]].concat()));
    fits(&text);
    assert!(text.contains("DEM           quick fidelity, 2 runs each, seed 7"), "{text}");
    assert!(text.contains("FORECAST") && text.contains('D') && text.contains("---"), "{text}");
}

#[test]
fn a_sensitivity_has_changes_with_errors_and_reasons() {
    let v = object(&of("sensitivity", &["--dem", "--force", "8"]));
    let check = object(&["check", "-L1.3", "-D0.4", "--fidelity=quick", "--runs=2", "--seed=7"]);
    is_the_check(&v["check"], &check);
    // Another spacing puts other nodes under the plates: no pairs of runs.
    assert_eq!(v["sensitivity"][1]["high"]["check"]["change"]["paired"], false);
    let moved = object(&["check", "-L1.3", "-D0.44", "--fidelity=quick", "--runs=2", "--seed=7"]);
    let raised = &v["sensitivity"][2]["high"];
    is_the_check(&raised["check"], &moved);
    let change = &raised["check"]["change"];
    let by_hand = number(&raised["check"], "/F_kN") - number(&v["check"], "/F_kN");
    assert!((number(change, "/F_kN") - by_hand).abs() < 1e-9);
    // The error of two pairs with the shares w and 1 - w of the runs: their difference times
    // sqrt((w^2 + (1 - w)^2) / 2), half of it where the shares are equal. The share is had from the mean; the runs'
    // forces are those of the two checks, here rounded to five digits.
    let force = |check: &Value, k: usize| number(check, &format!("/runs/{k}/first_break/F_kN"));
    let share =
        (number(&check, "/mean/F_kN") - force(&check, 1)) / (force(&check, 0) - force(&check, 1));
    let pair = |k| force(&moved, k) - force(&check, k);
    let shares = share.powi(2) + (1.0 - share).powi(2);
    let error = (pair(0) - pair(1)).abs() * (shares / 2.0).sqrt();
    assert!((number(change, "/standard_error/F_kN") - error).abs() < 2e-3, "{change} {error}");
    assert_eq!(change["paired"], true);
    assert!(change["utilisation"].is_f64());
    for input in [5, 6] {
        let step = &v["sensitivity"][input]["low"];
        assert!(step["check"].is_null() && step["F_kN"].is_f64());
        assert_eq!(step["check_missing"], "laboratory");
        assert!(step["check_reason"].as_str().unwrap().contains("wires from the mesh"));
    }
    assert_eq!(v["check_order"]["F"].as_array().map(Vec::len), Some(7));

    let text = went(&of("sensitivity", &["--dem", "--force", "8"]));
    fits(&text);
    for word in ["FORECAST", "DEM", "CHECK", "standard error", "no DEM", "change of use, %"] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let csv = went(&of("sensitivity", &["--dem", "--format=csv"]));
    let rows: Vec<Vec<&str>> = csv.lines().map(|l| l.split(',').collect()).collect();
    assert!(rows.len() == 15 && rows.iter().all(|r| r.len() == rows[0].len()), "{csv}");
    let missing = rows[0].iter().position(|c| *c == "check_missing").unwrap();
    assert_eq!((rows[1][missing], rows[11][missing]), ("", "laboratory"));
    assert_eq!(rows[0].last(), Some(&"check_change_utilisation_error"));
}

const PAIR: &str = r#"(
    version: 1,
    name: "small",
    layouts: [
        (name: "bench", d: 0.32, L: 1.3, D: 0.4, design_force: 8.0),
        (name: "corner", d: 0.32, L: 1.3, D: 0.4, ex: 0.65, ey: 0.65),
        (name: "twin", d: 0.32, L: 1.3, D: 0.4),
    ],
)
"#;

/// A check is called the same in a comparison as in an exported table; what both have is one column.
#[test]
fn a_check_has_the_columns_of_an_exported_table() {
    let kept = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/inputs/kept.ron");
    let header = |csv: String| -> Vec<String> {
        csv.lines().next().unwrap().split(',').map(String::from).collect()
    };
    let exported = header(went(&["export", kept, "--what=table"]));
    let compared =
        header(went(&["compare", kept, "--dem", "--fidelity=quick", "--runs=1", "--format=csv"]));
    let of_checks = |names: &[String]| -> Vec<String> {
        names.iter().filter(|name| name.starts_with("check_")).cloned().collect()
    };
    let both = of_checks(&exported).into_iter().filter(|name| compared.contains(name));
    assert_eq!(both.collect::<Vec<_>>(), ["check_F_kN", "check_delta_m", "check_runs"]);
    let all = || exported.iter().chain(&compared);
    assert!(all().all(|name| !name.contains("dem")), "{exported:?} {compared:?}");
    assert!(all().any(|name| name == "design_delta_m"));
}

#[test]
fn a_comparison_checks_each_layout() {
    let (_keep, path) = file("small.ron", PAIR);
    let all = [&["compare", shown(&path), "--dem"][..], &QUICK].concat();
    let v = object(&all);
    let check = object(&["check", "-L1.3", "-D0.4", "--fidelity=quick", "--runs=2", "--seed=7"]);
    is_the_check(&v["layouts"][0]["check"], &check);
    let used = number(&v, "/layouts/0/check/utilisation");
    assert!((used - 8.0 / number(&v, "/layouts/0/check/F_kN")).abs() < 1e-9);
    let corner = &v["layouts"][1];
    assert!(corner["check"].is_null() && corner["check_missing"] == "impossible", "{corner}");
    assert!(corner["check_reason"].as_str().unwrap().contains("anchor plate"));
    assert_eq!(v["layouts"][2]["check"]["F_kN"], v["layouts"][0]["check"]["F_kN"]);
    let text = went(&all);
    fits(&text);
    assert!(text.contains("over F_a") && text.contains("not possible"), "{text}");
    let csv = went(&[&all[..], &["--format=csv"]].concat());
    assert!(
        csv.lines().next().unwrap().ends_with(",check_runs,check_slipped,check_missing"),
        "{csv}"
    );
    assert!(csv.lines().nth(2).unwrap().ends_with(",,,impossible"), "{csv}");
    // A sensitivity or a sweep of a project is a list, each layout with its own checks.
    let sweep = ["sweep", shown(&path), "--vary=D", "--from=0.4", "--to=0.45", "--steps=2"];
    let list = object(&[&sweep[..], &["--dem"], &QUICK].concat());
    assert_eq!(list[0]["points"][0]["check"]["F_kN"], v["layouts"][0]["check"]["F_kN"]);
    assert_eq!(list[1]["points"][1]["check_missing"], "impossible");
    assert_eq!(list[2]["points"], {
        let mut first = list[0]["points"].clone();
        for point in first.as_array_mut().unwrap() {
            point["utilisation"] = Value::Null;
            for field in ["service_delta_m", "use", "verdict_by"] {
                point[field] = Value::Null;
            }
            point["verdict"] = "NOT ASKED".into();
            point["check"]["utilisation"] = Value::Null;
        }
        first
    });
}

#[test]
fn threads_change_nothing() {
    let with = |threads| object(&of("sensitivity", &["--dem", "--threads", threads]));
    assert_eq!(with("1"), with("2"));
}

#[test]
fn a_map_has_a_second_one_of_the_checks() {
    let range = [
        "--vary=L",
        "--from=1.3",
        "--to=1.4",
        "--steps=2",
        "--vary2=D",
        "--from2=0.4",
        "--to2=1.35",
        "--steps2=2",
        "--dem",
    ];
    let v = object(&of("sweep", &range));
    assert!(v["points"][1]["check"]["F_kN"].is_f64());
    assert_eq!(v["points"][2]["check_missing"], "impossible");
    let text = went(&of("sweep", &range));
    fits(&text);
    assert!(text.contains("DEM F, kN") && text.contains("X cannot be checked"), "{text}");
}

#[test]
fn what_a_check_does_not_know_has_a_reason_and_no_run() {
    let range = ["--vary=Fl", "--from=60", "--to=80", "--steps=3", "--dem"];
    let v = object(&of("sweep", &range));
    assert!(v["points"].as_array().unwrap().iter().all(|p| p["check_missing"] == "laboratory"));
    let text = went(&of("sweep", &range));
    fits(&text);
    assert!(text.contains("wires from the mesh, not from the laboratory"), "{text}");
    // Nothing is asked of checks that are not made.
    let e = refused(&["sensitivity", "--runs", "4"]);
    assert!(e.contains("--dem"), "{e}");
    assert!(refused(&of("sensitivity", &["--dem", "--fidelity=rough"])).contains("standard"));
}

#[test]
fn runs_without_a_break_are_told_apart() {
    // A block as small as the openings: it goes through.
    let small = ["sweep", "-L1.3", "--vary=D", "--from=0.05", "--to=0.4", "--steps=2", "--dem"];
    let all = [&small[..], &QUICK].concat();
    let v = object(&all);
    let dem = &v["points"][0]["check"];
    assert!(dem["F_kN"].is_null() && dem["difference_pct"].is_null() && dem["broken"] == 0);
    assert!(dem["band"]["F_kN"][1].is_f64() && v["points"][1]["check"]["F_kN"].is_f64());
    let text = went(&all);
    fits(&text);
    assert!(text.lines().any(|l| l.contains("0.05") && l.contains("no break")), "{text}");
    let csv = went(&[&all[..], &["--format=csv"]].concat());
    assert!(csv.lines().nth(1).unwrap().contains(",passes_through,,,,,"), "{csv}");
}

/// Ctrl+C ends with the checks that are done: valid JSON, exit code 130.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_valid_json() {
    use std::io::Read;
    let arguments = [
        "sweep",
        "--vary=L",
        "--from=1.3",
        "--to=4",
        "--steps=500",
        "--dem",
        "--runs=8",
        "--threads=1",
        "--format=json",
    ];
    let mut child = command(&arguments)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // The first line of progress comes when the runs are on their way.
    let mut first = [0_u8; 9];
    child.stderr.as_mut().unwrap().read_exact(&mut first).unwrap();
    assert_eq!(&first, b"progress:");
    let pid = child.id().to_string();
    let kill = std::process::Command::new("kill").args(["-INT", &pid]).status().unwrap();
    assert!(kill.success());
    let got = ran(child.wait_with_output().unwrap());
    assert_eq!(got.code, 130, "{}", got.err);
    let v: Value = serde_json::from_str(&got.out).expect("still JSON");
    let points = v["points"].as_array().unwrap();
    assert_eq!(points.len(), 500);
    assert!(points[0]["check"]["runs"].as_u64() > Some(0), "{}", points[0]);
    assert_eq!(points[499]["check_missing"], "not_made");
    assert!(points[499]["F_kN"].is_f64(), "the forecast is whole");
}
