//! The house: which room may talk to which, and what a room may touch. Read from the source, because
//! nothing else would notice.

mod circles;
mod source;

use source::{SourceFile, files};

/// Rooms on the ground, which everyone may use.
const GROUND: &[&str] = &[
    "axis",
    "curve",
    "fingerprint",
    "layout",
    "mesh",
    "method",
    "problem",
    "remark",
    "units",
    "words",
];

/// Rooms from the ground up, each with the rooms it may use. A room that does not exist yet is no
/// fault; a room that is missing here is one, because somebody has to say what it may use.
const ROOMS: &[(&str, &[&[&str]])] = &[
    ("units", &[&["words"]]),
    ("problem", &[&["words"]]),
    ("fingerprint", &[]),
    ("curve", &[]),
    ("axis", &[]),
    ("words", &[]),
    ("remark", &[]),
    ("layout", &[&["problem", "units", "words"]]),
    ("mesh", &[&["fingerprint", "layout", "method", "problem", "units", "words"]]),
    ("method", &[&["layout", "units", "words"]]),
    ("forecast", &[GROUND]),
    ("dem", &[GROUND]),
    ("case", &[GROUND, &["forecast"]]),
    ("study", &[GROUND, &["case", "dem", "forecast"]]),
    ("lab", &[GROUND, &["case", "dem", "forecast", "study"]]),
    ("project", &[GROUND, &["case", "dem", "study"]]),
    ("show", &[GROUND, &["case", "dem", "forecast", "study"]]),
    ("export", &[GROUND, &["case", "dem", "forecast", "project", "show", "study"]]),
    ("job", &[GROUND, &["case", "dem", "forecast", "lab", "project", "study"]]),
    (
        "app",
        &[GROUND, &["case", "dem", "export", "forecast", "job", "lab", "project", "show", "study"]],
    ),
    (
        "ui",
        &[GROUND, &["app", "case", "dem", "export", "forecast", "job", "project", "show", "study"]],
    ),
    (
        "term",
        &[
            GROUND,
            &["app", "case", "dem", "export", "forecast", "job", "project", "show", "study", "ui"],
        ],
    ),
    (
        "cli",
        &[
            GROUND,
            &["app", "case", "dem", "export", "forecast", "job", "lab"],
            &["project", "show", "study", "term"],
        ],
    ),
];

/// Longest file, lines.
const LONGEST_FILE: usize = 600;

/// Macros that print.
const PRINTING: &[&str] = &["println!", "eprintln!", "print!", "eprint!", "dbg!"];

/// Fails with everything that was found, so that one run shows all.
fn none(found: Vec<String>) {
    assert!(found.is_empty(), "\n{}\n", found.join("\n"));
}

fn rooms(names: &[&str]) -> Vec<SourceFile> {
    files().into_iter().filter(|f| names.contains(&f.room.as_str())).collect()
}

fn may_use(room: &str) -> Option<Vec<&'static str>> {
    ROOMS.iter().find(|(name, _)| *name == room).map(|(_, allowed)| allowed.concat())
}

#[test]
fn the_source_is_found_and_every_room_has_its_place() {
    let all = files();
    assert!(all.len() > 20, "only {} files were read", all.len());
    none(
        all.iter()
            .filter(|f| !["main", "lib", "build"].contains(&f.room.as_str()))
            .filter(|f| may_use(&f.room).is_none())
            .map(|f| format!("{}: say in tests/architecture what this room may use", f.path))
            .collect(),
    );
}

#[test]
fn arrows_run_one_way() {
    let mut found = Vec::new();
    for file in files() {
        let Some(allowed) = may_use(&file.room) else { continue };
        for used in file.rooms_used() {
            let is_room = may_use(&used).is_some();
            if is_room && used != file.room && !allowed.contains(&used.as_str()) {
                found.push(format!("{}: `{}` may not use `{used}`", file.path, file.room));
            }
        }
    }
    none(found);
}

#[test]
fn only_ui_and_term_name_a_terminal_crate() {
    let elsewhere = files().into_iter().filter(|f| !["ui", "term"].contains(&f.room.as_str()));
    none(elsewhere.flat_map(|f| f.lines_with_a_word(&["ratatui", "crossterm"])).collect());
}

fn uses_of_std(file: &SourceFile, modules: &[&str]) -> Vec<String> {
    let used = modules.iter().filter(|module| file.uses_std(module));
    used.map(|module| format!("{}: uses std::{module}", file.path)).collect()
}

#[test]
fn forecast_and_dem_read_no_file_and_no_clock_and_start_no_thread() {
    let mut found = Vec::new();
    for file in rooms(&["forecast", "dem"]) {
        found.extend(uses_of_std(&file, &["fs", "time", "thread", "env", "net", "process", "io"]));
        found.extend(file.lines_with_a_word(&["Instant", "SystemTime"]));
    }
    none(found);
}

#[test]
fn app_does_no_input_and_no_output() {
    let mut found = Vec::new();
    for file in rooms(&["app"]) {
        found.extend(uses_of_std(&file, &["fs", "io", "thread", "env", "net", "process"]));
    }
    none(found);
}

/// The printing macros panic when nobody reads; a user would see that.
#[test]
fn nothing_is_printed_by_a_macro() {
    // The build script talks to cargo in no other way.
    let all = files().into_iter().filter(|f| f.room != "build");
    none(all.flat_map(|f| f.lines_with_a_word(PRINTING)).collect());
}

/// Fits see simulations and laboratory tests, and of the paper nothing: neither its Table 1 nor the rows that
/// compare it with ours.
#[test]
fn table_1_is_in_no_fit() {
    let fits = ["lab/derive/", "lab/campaign/", "lab/calibrate", "method/"];
    let of_fits: Vec<SourceFile> = files()
        .into_iter()
        .filter(|f| fits.iter().any(|start| f.path.trim_start_matches("src/").starts_with(start)))
        .collect();
    assert!(of_fits.len() > 8, "{}", of_fits.len());
    let mut found = Vec::new();
    for file in of_fits {
        for way in
            ["forecast::published", "published.ron", "published()", "lab::paper", "super::paper"]
        {
            if file.text.contains(way) {
                found.push(format!("{}: a fit names {way}", file.path));
            }
        }
    }
    none(found);
}

#[test]
fn files_are_small() {
    let long = files().into_iter().filter(|f| f.text.lines().count() > LONGEST_FILE);
    none(long.map(|f| format!("{}: {} lines", f.path, f.text.lines().count())).collect());
}

/// An import that names the wrong one of two compiles now and then, and a search finds both.
#[test]
fn no_two_public_types_have_one_name() {
    let mut seen = std::collections::BTreeMap::<String, String>::new();
    let mut found = Vec::new();
    for file in files() {
        for line in file.code().lines().map(str::trim_start) {
            let mut words = line.split_whitespace();
            let public = words.next() == Some("pub");
            let kind = words.next();
            if !public
                || !["struct", "enum", "trait", "type", "union"].iter().any(|k| kind == Some(k))
            {
                continue;
            }
            let end = |c: char| !c.is_alphanumeric() && c != '_';
            let name = words.next().unwrap_or_default().split(end).next().unwrap_or_default();
            if let Some(other) = seen.insert(name.to_owned(), file.path.clone()) {
                found.push(format!("{name}: {other} and {}", file.path));
            }
        }
    }
    assert!(seen.len() > 100, "only {} types were read", seen.len());
    none(found);
}
