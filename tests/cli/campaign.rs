//! Campaigns: kept as they are made, gone on with after any end, the same on any threads.

use super::run;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Thirty lines.
const SMALL: [&str; 6] = ["campaign", "--runs", "24", "--seed", "3", "--eccentric"];

fn arguments<'a>(out: &'a str, threads: &'a str) -> Vec<&'a str> {
    let mut all = SMALL.to_vec();
    all.extend(["0.25", "--threads", threads, "--out", out]);
    all
}

fn file(folder: &Path) -> PathBuf {
    folder.join("campaign.jsonl")
}

/// What a campaign says that is made to its end; progress goes to standard error.
fn good(arguments: &[&str]) -> String {
    let ran = run(arguments);
    assert_eq!(ran.code, 0, "{arguments:?}: {}", ran.err);
    ran.out
}

/// Where the lines of a file end.
fn ends(text: &[u8]) -> Vec<usize> {
    text.iter().enumerate().filter(|(_, b)| **b == b'\n').map(|(at, _)| at + 1).collect()
}

#[test]
fn a_campaign_that_was_cut_off_goes_on_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("c");
    let said = good(&arguments(out.to_str().unwrap(), "1"));
    assert!(said.contains("centred        18 runs:") && said.contains("laboratory"), "{said}");
    let whole = fs::read(file(&out)).unwrap();
    let ends = ends(&whole);
    assert_eq!(ends.len(), 31, "a header and thirty lines");

    // On two threads, into another folder.
    let other = folder.path().join("two/threads");
    good(&arguments(other.to_str().unwrap(), "2"));
    assert!(fs::read(file(&other)).unwrap() == whole);

    // In the header and behind it; behind every tenth line, and in the middle of the next; before the end.
    let tenths = ends.iter().zip(&ends[1..]).step_by(10).skip(1);
    let mut cuts: Vec<usize> = tenths.flat_map(|(end, next)| [*end, (end + next) / 2]).collect();
    assert!(cuts.len() == 4 && cuts[3] > ends[20] && cuts[3] < ends[21], "{cuts:?}");
    cuts.extend([5, ends[0], whole.len() - 1, whole.len()]);
    for (cut, threads) in cuts.into_iter().zip(["1", "2"].into_iter().cycle()) {
        fs::write(file(&out), &whole[..cut]).unwrap();
        let mut all = arguments(out.to_str().unwrap(), threads);
        all.push("--resume");
        good(&all);
        assert!(fs::read(file(&out)).unwrap() == whole, "cut at {cut}");
    }
}

#[test]
fn a_campaign_that_was_killed_goes_on_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let (out, whole) = (folder.path().join("killed"), folder.path().join("whole"));
    let all = arguments(out.to_str().unwrap(), "2");
    let mut child = Command::new(env!("CARGO_BIN_EXE_meshcast"))
        .args(&all)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let start = Instant::now();
    while ends(&fs::read(file(&out)).unwrap_or_default()).len() < 6 {
        assert!(start.elapsed() < Duration::from_secs(120));
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let resumed: Vec<&str> = all.iter().copied().chain(["--resume"]).collect();
    good(&resumed);
    good(&arguments(whole.to_str().unwrap(), "1"));
    assert!(fs::read(file(&out)).unwrap() == fs::read(file(&whole)).unwrap());
}

#[test]
fn a_campaign_is_neither_overwritten_nor_mixed_with_another() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let small = ["campaign", "--runs", "1", "--eccentric", "0", "--out", out];
    good(&small);
    let kept = fs::read(file(folder.path())).unwrap();
    let refused = |more: &[&str], said: &str| {
        let all: Vec<&str> = small.iter().chain(more).copied().collect();
        let ran = run(&all);
        assert!(ran.code == 2 && ran.err.contains(said), "{}", ran.err);
        assert_eq!(fs::read(file(folder.path())).unwrap(), kept);
    };
    refused(&[], "exists already and is not overwritten");
    refused(&["--resume", "--seed", "7"], "seed 0 and not 7");
    refused(&["--resume", "--blocks", "mirrored"], "blocks repeated and not mirrored");
    refused(&["--resume", "--blocks", "worst"], "invalid value");
    fs::write(file(folder.path()), "{}\nno campaign\n").unwrap();
    let ran = run(&["campaign", "--runs", "1", "--resume", "--out", out]);
    assert!(ran.code == 2 && ran.err.contains("line 1"), "{}", ran.err);
}

#[test]
fn a_method_is_derived_from_a_small_campaign() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_string();
    let (runs, method) = (place("runs"), place("method.ron"));
    good(&["campaign", "--runs", "60", "--eccentric", "0.3", "--seed", "1", "--out", &runs]);
    let said = good(&["derive", &runs, "--out", &method]);
    for part in
        ["60 asked", "alpha_F", "published 1.312", "lower of two", "plate", "with an offset"]
    {
        assert!(said.contains(part), "{part}: {said}");
    }
    let text = fs::read_to_string(&method).unwrap();
    assert!(text.starts_with("// A method of forecasts"), "{text}");
    // Of one mesh the ratio cannot be far from that of its other runs.
    let alpha: f64 =
        said.split("alpha_F").nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
    assert!((0.3..0.5).contains(&alpha), "{alpha}");
    // Neither overwritten nor made of runs that are counted twice.
    assert_eq!(run(&["derive", &runs, "--out", &method]).code, 2);
    let twice = run(&["derive", &runs, &runs]);
    assert!(twice.code == 2 && twice.err.contains("seed 1"), "{}", twice.err);
    let nothing = run(&["derive", &place("nothing")]);
    assert!(nothing.code == 2 && nothing.err.contains("no such file"), "{}", nothing.err);
    assert!(!nothing.err.contains("meshcast new"), "{}", nothing.err);
}

#[test]
fn a_forecast_takes_either_method_and_says_which() {
    let one = |flags: &[&str]| {
        let all: Vec<&str> = ["forecast"].iter().chain(flags).copied().collect();
        super::json(&all)
    };
    let plain = one(&[]);
    // What stands in results of before has no word of it.
    assert!(plain["inputs"].get("method").is_none() && plain["field"].get("method").is_none());
    assert_eq!(one(&["--method", "pol-gabrieli-2021"]), plain);
    let derived = one(&["--method", "derived"]);
    assert_eq!(derived["inputs"]["method"], "derived");
    assert_eq!(derived["field"]["method"]["published"]["F_kN"], plain["field"]["F_kN"]);
    assert_ne!(derived["fingerprint"], plain["fingerprint"]);
    let said = good(&["forecast", "--method", "derived", "--ex", "0.5", "--ey", "0.9"]);
    assert!(
        said.contains("simulations of repeated blocks") && said.contains("published"),
        "{said}"
    );
    // Blocks that face each other have a method of their own, and no value where they would overlap.
    let force = |blocks: &str| {
        let flags = ["--method", "derived", "--blocks", blocks, "--ex", "0.5", "--ey", "0.9"];
        one(&flags)["field"]["F_kN"].as_f64().unwrap()
    };
    assert!(force("mirrored") < force("repeated") && force("worst") == force("mirrored"));
    let overlap = one(&["--method", "derived", "--blocks", "mirrored", "--ex", "1.2"]);
    assert!(overlap["field"].is_null());
    assert!(overlap["warnings"].to_string().contains("blocks_overlap"), "{}", overlap["warnings"]);
}

#[test]
fn a_layout_keeps_its_method_in_its_file() {
    let text = r#"(version: 2, name: "p", layouts: [(name: "a", d: 0.32, L: 3.0, D: 1.0, method: "derived")])"#;
    let (_keep, path) = super::file("p.ron", text);
    let value = super::json(&["forecast", super::shown(&path)]);
    assert_eq!(value[0]["inputs"]["method"], "derived", "{value}");
    let (_keep, path) = super::file("q.ron", &text.replace("derived", "guessed"));
    let refused = super::refused(&["forecast", super::shown(&path)]);
    assert!(refused.contains("method") && refused.contains("pol-gabrieli-2021"), "{refused}");
}

#[test]
fn layouts_that_no_fit_saw_are_held_against_both_methods() {
    let said = good(&["held-out", "--layouts", "6", "--seed", "5", "--threads", "1"]);
    for part in
        ["6 drawn of 6, seed 5", "left out:", "centred, D from 0.4 m", "published delta", "aims"]
    {
        assert!(said.contains(part), "{part}: {said}");
    }
    // A part without a layout has no figures.
    let few = good(&["held-out", "--layouts", "1", "--seed", "5", "--threads", "1"]);
    let line = few.lines().find(|l| l.starts_with("with an offset, D below 0.4 m")).unwrap();
    assert!(line.split_whitespace().skip(7).eq(["0", "-", "-", "-", "-"]), "{line}");
    let wide = run(&["held-out", "--seed", "5", "--widen", "3"]);
    assert!(wide.code == 2 && wide.err.contains("--widen: a part from 0 to 1"), "{}", wide.err);
    // The seed of the shipped methods' campaigns.
    let seen = run(&["held-out", "--layouts", "6", "--seed", "1"]);
    assert!(seen.code == 2 && seen.err.contains("was made from runs of this seed"), "{}", seen.err);
}

#[test]
fn a_reproduction_of_too_few_runs_is_refused() {
    let refused = run(&["reproduce", "--runs", "5"]);
    assert!(refused.code == 2 && refused.err.contains("60"), "{}", refused.err);
}

#[test]
#[ignore = "takes half a minute"]
fn the_papers_figures_and_tables_are_made_with_their_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let written = good(&["reproduce", "--runs", "60", "--out", out]);
    let names: Vec<&str> = written.lines().filter_map(|line| line.rsplit('/').next()).collect();
    assert_eq!(
        names.join(" "),
        "reproduced.txt fig3.svg fig4a.svg fig4b.svg fig6.svg fig7a.svg fig7b.svg fig7c.svg fig7d.svg fig7e.svg \
         fig7f.svg figa1.svg"
    );
    let text = fs::read_to_string(folder.path().join("reproduced.txt")).unwrap();
    for part in
        ["Eq. 1", "k75 at L = 2 m", "alpha_F", "Eq. 3", "test 5, mirrored", "after the fact"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    for name in &names[1..] {
        let picture = fs::read_to_string(folder.path().join(name)).unwrap();
        roxmltree::Document::parse(&picture).unwrap();
    }
}

/// alpha_F of the shipped method of repeated blocks.
const ALPHA: &str = "0.37878";

/// The shipped method of repeated blocks with another alpha_F: 0.4.
fn other_method() -> String {
    let text = include_str!("../../assets/methods/dt-8x10-2.7-repeated.ron");
    let other = text
        .replace(&format!("force: {ALPHA},"), "force: 0.4,")
        .replace("2.7 repeated\"", "2.7 of ours\"");
    assert_ne!(other, text);
    other
}

#[test]
fn a_project_names_a_method_by_file_and_so_does_a_flag() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("c")).unwrap();
    fs::write(folder.path().join("c/method.ron"), other_method()).unwrap();
    let project = |named: &str| {
        let path = folder.path().join("p.ron");
        let text = format!(
            r#"(version: 2, name: "p", method_files: [{named}], layouts: [(name: "a", d: 0.32, L: 3.0, D: 1.0, blocks: repeated, method: "derived")])"#
        );
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_string()
    };
    let field = |arguments: &[&str]| {
        let v: serde_json::Value =
            serde_json::from_str(&good(&[arguments, &["--format", "json"]].concat())).unwrap();
        v["field"].clone()
    };
    let force = |v: &serde_json::Value| v["F_kN"].as_f64().unwrap();
    let path = project("");
    let shipped = field(&["forecast", &path, "--layout", "a"]);
    let path = project(r#""c/method.ron""#);
    let named = field(&["forecast", &path, "--layout", "a"]);
    assert_eq!(named["method"]["name"], "dt-8x10-2.7 of ours");
    // Nothing else was changed.
    let alpha: f64 = ALPHA.parse().unwrap();
    assert!((force(&named) / force(&shipped) - 0.4 / alpha).abs() < 1e-9, "{named}");
    let file = folder.path().join("c/method.ron");
    let flag = ["forecast", "--blocks", "repeated", "--method-file", file.to_str().unwrap()];
    assert_eq!(force(&field(&flag)), force(&named));
    let report = good(&["report", &path, "--format", "md"]);
    assert!(report.contains("of ours") && report.contains("c/method.ron"), "{report}");

    // What it cannot go by it refuses, and says which and why.
    let refused = |named: &str| {
        let path = project(named);
        let ran = run(&["forecast", &path]);
        assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{}", ran.err);
        ran.err
    };
    assert!(refused(r#""c/other.ron""#).contains("there is no such file"));
    assert!(refused(r#""c""#).contains("directory"));
    fs::write(folder.path().join("c/deep.ron"), "(".repeat(100_000)).unwrap();
    assert!(refused(r#""c/deep.ron""#).contains("no method"));
    let wires = other_method().replace("wires: \"", "wires: \"0");
    fs::write(folder.path().join("c/wires.ron"), wires).unwrap();
    assert!(refused(r#""c/wires.ron""#).contains("other wires"));
    let mesh = other_method().replace("mesh: \"dt-8x10-2.7\"", "mesh: \"elsewhere\"");
    fs::write(folder.path().join("c/mesh.ron"), mesh).unwrap();
    assert!(refused(r#""c/mesh.ron""#).contains("elsewhere"));
    let said = refused(r#""c/method.ron", "c/method.ron""#);
    assert!(said.contains("method_files[1]") && said.contains("same mesh"), "{said}");
    let ran =
        run(&["forecast", "--method-file", folder.path().join("c/wires.ron").to_str().unwrap()]);
    assert!(ran.code == 2 && ran.err.contains("--method-file"), "{}", ran.err);
}
