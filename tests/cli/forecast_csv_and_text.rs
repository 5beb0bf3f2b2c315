//! `forecast` as CSV and as a text.

use super::{PROJECT, file, good, ran, run, shown};

#[test]
fn csv_of_one_layout_is_its_curve() {
    let out = good(&["forecast", "--format", "csv"]);
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 202);
    assert_eq!((lines[0], lines[1]), ("delta_m,F_kN", "0,0"));
    assert_eq!(lines[201], "0.63504,27.063");
    for line in &lines[1..] {
        let numbers: Vec<f64> = line.split(',').map(|n| n.parse().unwrap()).collect();
        assert_eq!(numbers.len(), 2);
    }
}

#[test]
fn csv_of_a_project_has_the_layouts_in_front_and_remarks_elsewhere() {
    let (_keep, path) = file("road-cut.ron", PROJECT);
    let got = run(&["forecast", shown(&path), "--format", "csv"]);
    assert_eq!(got.code, 0);
    let lines: Vec<&str> = got.out.lines().collect();
    assert_eq!(lines[0], "layout,delta_m,F_kN");
    assert_eq!(lines.len(), 1 + 2 * 201, "the third layout has no curve");
    assert_eq!(lines[1], "bench 2,0,0");
    assert_eq!(lines[202], "\"portal, east\",0,0");
    assert!(got.err.starts_with("note: layout \"corner\": no curve; the block overlaps"));
    let one = good(&["forecast", shown(&path), "--layout", "bench 2", "--format", "csv"]);
    assert!(one.starts_with("delta_m,F_kN\n0,0\n"));
}

/// Every case a person may meet stays on one screen.
#[test]
fn the_text_fits_a_screen() {
    let long_name = "x".repeat(60);
    let text = PROJECT.replace("corner", &long_name);
    let (_keep, path) = file("road-cut.ron", &text);
    let everything = [
        "forecast",
        "-d",
        "0.5",
        "-L",
        "5.5",
        "-D",
        "0.39",
        "--ex",
        "5",
        "--ey",
        "-2.6",
        "--force",
        "25",
        "--deflection",
        "0.9",
        "--gamma-load",
        "1.35",
        "--gamma-resistance",
        "1.25",
        "--units",
        "mm",
    ];
    for arguments in [
        &["forecast"][..],
        &everything[..],
        &["forecast", "--ex", "1.5", "--ey", "1.5", "--force", "10"],
        &["forecast", shown(&path), "--layout", &long_name],
    ] {
        let out = good(arguments);
        let lines: Vec<&str> = out.lines().collect();
        assert!(lines.len() <= 24, "{} lines:\n{out}", lines.len());
        for line in lines {
            assert!(line.chars().count() <= 80, "{line}");
            assert_eq!(line, line.trim_end());
        }
    }
}

#[test]
fn the_text_says_what_an_engineer_asks_for() {
    let out = good(&["forecast", "--force", "10", "--deflection", "0.5", "--gamma-load", "1.5"]);
    for words in [
        "d 0.32 m, L 3.00 m, D 1.00 m",
        "F_l* 73.3 kN, delta_l* 0.600 m, mean",
        "alpha_F 0.397, alpha_delta 1.080",
        "F_a 27.1 kN, delta_a 0.635 m",
        "large punch",
        "each anchor   carries 27.1 kN",
        "gamma_load 1.5",
        "gamma_resistance 1.0",
        "10.0 kN factored to 15.0 kN: use 55.4 %",
        "lowest of the arrangements computed",
        "square grid",
        "tangent 138, secant 42.6 kN/m; 4.06 kJ",
        "27.1 kN and",
    ] {
        assert!(out.contains(words), "{words:?} is missing:\n{out}");
    }
    let eccentric = good(&["forecast", "-L", "4", "--ex", "2", "--ey", "0.2"]);
    assert!(eccentric.contains("1.139 +- "), "{eccentric}");
    let outside = good(&["forecast", "-L", "6"]);
    assert!(outside.contains("(extrapolated)") && outside.contains("1.25 to 4.5 m"), "{outside}");
    let on_plate = good(&["forecast", "--ex", "1.5", "--ey", "1.5"]);
    assert!(on_plate.contains("no field value") && on_plate.contains("F_l* 73.3 kN"), "{on_plate}");
    let near = good(&["forecast", "-D", "0.33"]);
    assert!(near.contains("the other gives"), "{near}");
}

#[test]
fn what_an_anchor_carries_follows_how_the_blocks_stand() {
    let test_5 = ["-d", "0.25", "-L", "3.5", "-D", "0.8", "--ex", "0.55", "--ey", "1.15"];
    let said = |blocks: &str| {
        let flags = [&["forecast"], &test_5[..], &["--blocks", blocks]].concat();
        let text = good(&flags).split_whitespace().collect::<Vec<_>>().join(" ");
        text.split(" anchor ").nth(1).unwrap().split(" basis").next().unwrap().to_string()
    };
    // 15.29 kN by the published relations, and the lever of both offsets: (4.6/3.5)(5.8/3.5).
    assert_eq!(said("repeated"), "carries 15.3 kN at failure, the whole force of its cell");
    assert!(said("mirrored").starts_with("carries at most 33.3 kN at failure (estimate)"));
    assert!(said("single").starts_with("carries 15.3 kN at failure (estimate)"));
}

#[test]
fn the_text_follows_the_unit_of_the_flag_and_of_the_project() {
    assert!(good(&["--units", "mm", "forecast"]).contains("delta_a 635 mm"));
    let text = PROJECT.replace("layouts: [", "display: (length_unit: mm),\n    layouts: [");
    let (_keep, path) = file("road-cut.ron", &text);
    let layout = ["forecast", shown(&path), "--layout", "bench 2"];
    assert!(good(&layout).contains("d 250 mm, L 2500 mm"));
    assert!(good(&[&layout[..], &["--units", "m"]].concat()).contains("d 0.25 m"));
    // 27.1 kN / 4.4482 is 6.09 kip, 0.635 m / 0.3048 is 2.08 ft.
    let feet = good(&["--units", "ft,kip", "forecast"]);
    assert!(feet.contains("F_a 6.08 kip, delta_a 2.08 ft"), "{feet}");
    // Programs get the same bytes whatever people are shown.
    let json = |units| good(&["--units", units, "forecast", "--format", "json"]);
    assert_eq!(json("ft,kip"), json("m"));
}

#[test]
fn a_project_without_layouts_has_an_empty_result() {
    let (_keep, path) = file("empty.ron", "(version: 1, name: \"empty\", layouts: [])");
    let of = |format| good(&["forecast", shown(&path), "--format", format]);
    assert_eq!(of("json"), "[]\n");
    assert_eq!(of("csv"), "layout,delta_m,F_kN\n");
    assert!(of("text").contains("no layouts"));
}

/// A reader that goes away early, as `head` does, is no failure and no panic.
#[test]
fn a_closed_pipe_is_left_quietly() {
    use std::process::Stdio;
    let layouts: String = (0..60)
        .map(|n| format!("        (name: \"layout {n}\", d: 0.25, L: 2.5, D: 0.6),\n"))
        .collect();
    let project = format!("(version: 1, name: \"many\", layouts: [\n{layouts}])");
    let (_keep, path) = file("many.ron", &project);
    let mut child = super::command(&["forecast", shown(&path), "--format", "csv"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The result is far larger than a pipe holds (60 x 201 lines), so the program is still writing.
    drop(child.stdout.take());
    let got = ran(child.wait_with_output().unwrap());
    assert_eq!((got.code, got.err.as_str()), (0, ""));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let got = ran(super::command(&["forecast"]).stdout(full).output().unwrap());
    assert_eq!(got.code, 1);
    assert!(got.err.starts_with("error: the result cannot be written"), "{}", got.err);
}
