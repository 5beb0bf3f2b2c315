//! The program as a whole: version, no terminal, no home, new projects.

use super::{command, good, json, ran, run, shown};

#[test]
fn the_version_names_the_commit() {
    let out = good(&["--version"]);
    let inner = out
        .strip_prefix(concat!("meshcast ", env!("CARGO_PKG_VERSION"), " ("))
        .and_then(|rest| rest.strip_suffix(")\n"))
        .unwrap_or_else(|| panic!("{out:?}"));
    let commit = inner.len() >= 7 && inner.chars().all(|c| c.is_ascii_hexdigit());
    assert!(commit || inner == "commit unknown", "{out:?}");
    let stated = json(&["forecast"])["version"].as_str().unwrap().to_string();
    assert_eq!(format!("meshcast {stated}\n"), out);
}

/// Without a terminal there is no interactive program: the headless help, and exit code 2.
#[test]
fn without_a_terminal_the_headless_help_is_printed() {
    for arguments in [&[][..], &["road-cut.ron"], &["--units", "mm"], &["./forecast"]] {
        let got = run(arguments);
        assert_eq!((got.code, got.out.as_str()), (2, ""), "{arguments:?}");
        assert!(got.err.contains("needs a terminal"), "{}", got.err);
        for word in ["forecast", "mesh", "validate", "new", "Usage:"] {
            assert!(got.err.contains(word), "{word} is missing in {}", got.err);
        }
    }
}

/// Every other test runs without any environment at all; this one with a home that does not exist.
#[test]
fn no_home_is_needed() {
    let mut there = command(&["forecast"]);
    there.env("HOME", "/nonexistent/home").env("XDG_DATA_HOME", "/nonexistent/data");
    let got = ran(there.output().unwrap());
    assert_eq!((got.code, got.err.as_str()), (0, ""));
    assert_eq!(got.out, good(&["forecast"]));
}

#[test]
fn a_new_project_can_be_forecast_at_once() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("gully 7.ron");
    assert_eq!(good(&["new", shown(&path)]), format!("{}\n", path.display()));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("gully 7") && text.contains("//"), "{text}");
    let all = json(&["forecast", shown(&path)]);
    // A new layout has blocks that take the least and the derived method; flags alone mean the published one.
    let alone = json(&["forecast", "--blocks", "worst", "--method", "derived"]);
    assert_eq!(all[0]["field"], alone["field"]);
    assert_eq!(all[0]["fingerprint"], alone["fingerprint"]);
}

#[test]
fn flags_of_the_screen_are_taken_by_every_command_and_change_no_json() {
    let plain = good(&["forecast", "--format", "json"]);
    let before =
        ["--color", "none", "--glyphs", "ascii", "--units", "mm", "forecast", "--format", "json"];
    let behind =
        ["forecast", "--format", "json", "--color", "16", "--glyphs", "braille", "--units", "m"];
    assert_eq!(good(&before), plain);
    assert_eq!(good(&behind), plain);
}

#[test]
fn every_shell_gets_completions_of_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = super::good(&["completions", shell]);
        for word in ["forecast", "sensitivity", "completions", "gamma-load"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}

#[test]
fn there_is_a_manual_page_of_the_program_and_of_each_command() {
    let page = good(&["man"]);
    assert!(page.contains(".TH meshcast 1") && page.contains("force\\-deflection"), "{page}");
    let page = good(&["man", "check"]);
    assert!(page.contains("meshcast\\-check") && page.contains("\\-\\-fidelity"), "{page}");
    let none = run(&["man", "chek"]);
    assert!(none.code == 2 && none.err.contains("did you mean"), "{}", none.err);
}

/// A project can come from another program: the answers are those of the file.
#[test]
fn a_project_is_taken_from_standard_input() {
    let (_keep, path) = super::file("road.ron", super::PROJECT);
    for words in [
        &["forecast", "-", "--format", "csv"][..],
        &["compare", "-", "--format", "csv"],
        &["export", "-", "--format", "csv"],
        &["design", "-", "--format", "json"],
    ] {
        let mut command = command(words);
        let ran = ran(command.stdin(std::fs::File::open(&path).unwrap()).output().unwrap());
        assert_eq!(ran.code, 0, "{words:?}: {}", ran.err);
        let of_file: Vec<&str> =
            words.iter().map(|w| if *w == "-" { shown(&path) } else { w }).collect();
        assert_eq!(ran.out, run(&of_file).out, "{words:?}");
    }
    let bad = ran(command(&["forecast", "-"]).stdin(std::process::Stdio::null()).output().unwrap());
    assert!(bad.code == 2 && bad.err.contains("standard input"), "{}", bad.err);
}

#[test]
fn a_written_file_is_named_by_its_whole_path() {
    let folder = tempfile::tempdir().unwrap();
    let (_keep, path) = super::file("road.ron", super::PROJECT);
    let mut command =
        super::command(&["export", super::shown(&path), "--what", "table", "-o", "t.csv"]);
    let ran = super::ran(command.current_dir(&folder).output().unwrap());
    let whole = folder.path().join("t.csv");
    assert_eq!(ran.out.trim_end(), whole.display().to_string());
    assert!(whole.exists());
}
